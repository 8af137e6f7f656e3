"""Attacks arithmetic that is not exact: floating point, slopes, angles, 32-bit products."""
