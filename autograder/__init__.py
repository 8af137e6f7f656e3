"""What runs in Gradescope's container: finds the student's file, judges it, writes results.json."""
