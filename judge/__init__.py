"""What checker.py is made of: lower modules never import higher ones, and never `gen`."""
