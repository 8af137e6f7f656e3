"""Attacks slow methods, and arrays, buffers and searches that are too small."""
