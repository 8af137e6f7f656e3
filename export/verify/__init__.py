"""Proof that the packages are right, by the judges' own tools. One module per tool, no more."""
