"""Attacks searches among the edges of large polygons: where they begin and end, what they skip."""
