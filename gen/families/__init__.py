"""The families: functions that make the scenarios of one test case from a seed."""

from gen.families import (
    contacts,
    containment,
    cuts,
    decoys,
    hugging,
    in_line,
    parallel,
    precision,
    rooms,
    rounds,
    scenes,
    sequences,
    slivers,
    worlds,
)
from gen.families.registry import FAMILIES, Family, FamilyError, Parameters, find, nearest

__all__ = [
    "FAMILIES",
    "Family",
    "FamilyError",
    "Parameters",
    "contacts",
    "containment",
    "cuts",
    "decoys",
    "find",
    "hugging",
    "in_line",
    "nearest",
    "parallel",
    "precision",
    "rooms",
    "rounds",
    "scenes",
    "sequences",
    "slivers",
    "worlds",
]
