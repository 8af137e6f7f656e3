"""Attacks the border between YES and NO: shapes that just touch, or miss by one unit."""
