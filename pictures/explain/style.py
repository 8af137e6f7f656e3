"""How the parts of a picture look: by colour, and without colour by line and fill.

The colours are those of Okabe and Ito, which colour-blind people can tell apart, the edges of robot
and obstacle darker and lighter than theirs, so that they differ in grey as well. Each picture has
a class of its own, so that several in one page do not disturb each other.
"""

from __future__ import annotations

FONT = "Helvetica, Arial, sans-serif"

# class: (properties, what differs on a dark page)
_LOOKS = {
    "paper": ("fill:#fff", "fill:#15181c"),
    "plot": ("fill:#fcfcfb", "fill:#1b1f24"),
    "frame": ("fill:none;stroke:#9a9a9a;stroke-width:1", "stroke:#6d747c"),
    "grid": ("fill:none;stroke:#e7e7e4;stroke-width:.7", "stroke:#2a3037"),
    "tick": ("fill:none;stroke:#d2d2ce;stroke-width:.8", "stroke:#3b434c"),
    "zero": ("fill:none;stroke:#a5a5a0;stroke-width:1", "stroke:#69727c"),
    "text": ("fill:#222", "fill:#e8e8e6"),
    "faint": ("fill:#666", "fill:#a3aab2"),
    "halo": (
        "fill:#222;stroke:#fff;stroke-width:3.5;paint-order:stroke;stroke-linejoin:round",
        "fill:#f0f0ee;stroke:#15181c",
    ),
    "sweep": ("fill:#0072b2;fill-opacity:.1", "fill:#56b4e9;fill-opacity:.13"),
    "sweep-line": (
        "fill:none;stroke:#0072b2;stroke-width:.9;stroke-opacity:.6",
        "stroke:#56b4e9",
    ),
    "start": (
        "fill:#0072b2;fill-opacity:.16;stroke:#0072b2;stroke-width:1.3",
        "fill:#56b4e9;stroke:#56b4e9",
    ),
    "end": (
        "fill:none;stroke:#0072b2;stroke-width:1.3;stroke-dasharray:5 3.5",
        "stroke:#56b4e9",
    ),
    "then": (
        "fill:#0072b2;fill-opacity:.38;stroke:#00507d;stroke-width:2.4",
        "fill:#56b4e9;stroke:#6cbdee",
    ),
    "other": (
        "fill:#8d8d88;fill-opacity:.25;stroke:#8d8d88;stroke-width:1",
        "fill:#9aa1a8;stroke:#9aa1a8",
    ),
    "dots": ("fill:#8d8d88", "fill:#9aa1a8"),
    "obstacle": (
        "fill:#e69f00;fill-opacity:.32;stroke:#bd7d00;stroke-width:2;stroke-dasharray:9 2 2 2",
        "fill:#e69f00;stroke:#ffd873",
    ),
    "arrow": ("fill:none;stroke:#0072b2;stroke-width:1.6", "stroke:#56b4e9"),
    "head": ("fill:#0072b2", "fill:#56b4e9"),
    "of-robot-head": ("fill:#00507d", "fill:#56b4e9"),
    "of-obstacle-head": ("fill:#bd7d00", "fill:#ffd873"),
    "gap": ("fill:none;stroke:#222;stroke-width:1.6;stroke-dasharray:2 2", "stroke:#f0f0ee"),
    "hit": ("fill:none;stroke:#d55e00;stroke-width:2.4", "stroke:#ff8a3c"),
    "hit-dot": ("fill:#d55e00", "fill:#ff8a3c"),
    "lens": ("fill:none;stroke:#222;stroke-width:1", "stroke:#f0f0ee"),
    "inner": ("fill:#8d8d88;fill-opacity:.14", "fill:#9aa1a8"),
    "of-robot": ("fill:none;stroke:#00507d;stroke-width:2.4", "stroke:#56b4e9"),
    "of-move": (
        "fill:none;stroke:#00507d;stroke-width:2.4;stroke-dasharray:1.5 3",
        "stroke:#56b4e9",
    ),
    "of-obstacle": (
        "fill:none;stroke:#bd7d00;stroke-width:2.4;stroke-dasharray:9 2 2 2",
        "stroke:#ffd873",
    ),
}


def css(scope: str) -> str:
    """Return the rules for one picture, whose class is `scope`."""
    light = [f".{scope} .{name}{{{look}}}" for name, (look, _) in _LOOKS.items()]
    dark = [f".{scope} .{name}{{{look}}}" for name, (_, look) in _LOOKS.items()]
    return "\n".join([*light, "@media (prefers-color-scheme:dark){", *dark, "}"])
