"""The families: functions that make the scenarios of one test case from a seed.

Each room (a folder here) is named after what it attacks; each file is named after its family.
Every module below this folder is imported, so a new family is found by itself.
"""

import pkgutil
from importlib import import_module

from gen.families.registry import FAMILIES, Family, FamilyError, Parameters, find

for _module in pkgutil.walk_packages(__path__, f"{__name__}."):
    import_module(_module.name)

__all__ = ["FAMILIES", "Family", "FamilyError", "Parameters", "find"]
