"""Strictly convex polygons on the integer grid."""
