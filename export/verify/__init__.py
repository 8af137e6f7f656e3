"""The packages, read back by the judges' own tools."""
