"""The judge behind checker.py. Lower modules never import higher ones; none imports `gen`."""
