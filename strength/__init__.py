"""How strong the data is: which wrong programs it kills, and by which cases."""
