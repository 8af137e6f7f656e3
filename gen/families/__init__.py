"""The families: functions that make the scenarios of one test case from a seed."""

from gen.families import contacts, hugging, scenes
from gen.families.registry import FAMILIES, Family, FamilyError, Parameters, find, nearest

__all__ = [
    "FAMILIES",
    "Family",
    "FamilyError",
    "Parameters",
    "contacts",
    "find",
    "hugging",
    "nearest",
    "scenes",
]
