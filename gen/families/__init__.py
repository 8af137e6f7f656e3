"""The families: functions that make the scenarios of one test case from a seed."""

from gen.families import (
    contacts,
    containment,
    decoys,
    hugging,
    parallel,
    precision,
    rooms,
    scenes,
    sequences,
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
    "decoys",
    "find",
    "hugging",
    "nearest",
    "parallel",
    "precision",
    "rooms",
    "scenes",
    "sequences",
    "worlds",
]
