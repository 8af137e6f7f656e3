"""Exact geometry on the integer grid, for making scenes only.

No solver imports anything from here, so that the makers of the data and the programs that
answer it share no bug. A polygon is a list of vertices, counter-clockwise and strictly
convex unless said otherwise.
"""

from gen.geometry.plane import (
    Point,
    Polygon,
    Sweep,
    apart,
    cross,
    hull,
    is_strictly_convex,
    is_upper,
    minus,
    primitive,
    step_right,
    sweep,
    translated,
)

__all__ = [
    "Point",
    "Polygon",
    "Sweep",
    "apart",
    "cross",
    "hull",
    "is_strictly_convex",
    "is_upper",
    "minus",
    "primitive",
    "step_right",
    "sweep",
    "translated",
]
