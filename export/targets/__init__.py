"""One module per judge. Each declares `TARGETS`; this file finds the modules and joins them."""

import pkgutil
from importlib import import_module

from export.target import Target

TARGETS: dict[str, Target] = {
    target.name: target
    for module in pkgutil.iter_modules(__path__)
    if not module.name.startswith("_")
    for target in getattr(import_module(f"{__name__}.{module.name}"), "TARGETS", ())
}
