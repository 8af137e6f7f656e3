"""Puts the page together: one file, which may load nothing and send nothing."""

from __future__ import annotations

import base64
import hashlib
import json
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path

import msgspec

from explorer.modules import join
from explorer.scenes import Scene
from judge.problem.declaration import Constraints

SOURCES = Path(__file__).resolve().parent / "src"
FIRST = "02-sweep-1"  # the scene that is shown at first: only the way between is in the way


def build(scenes: Sequence[Scene], constraints: Constraints) -> str:
    """Return the page with these scenes, as HTML. Raises ModuleError."""
    style = (SOURCES / "style.css").read_text(encoding="utf-8").strip()
    script = join(SOURCES / "main.js").strip()
    sentences = list(dict.fromkeys(scene.sentence for scene in scenes))
    held = {
        "rules": msgspec.to_builtins(constraints),
        "first": FIRST,
        "sentences": sentences,
        "scenes": [
            asdict(scene) | {"sentence": sentences.index(scene.sentence)} for scene in scenes
        ],
    }
    parts = {
        "policy": f"default-src 'none'; style-src {_source(style)}; script-src {_source(script)}",
        "style": style,
        "data": json.dumps(held, ensure_ascii=False, separators=(",", ":")).replace("</", "<\\/"),
        "script": script,
    }
    page = (SOURCES / "page.html").read_text(encoding="utf-8")
    for name, text in parts.items():
        before, _, after = page.partition("{{" + name + "}}")
        page = before + text + after
    return page


def _source(text: str) -> str:
    """Return the source expression of a content security policy that allows this text only."""
    digest = hashlib.sha256(text.encode()).digest()
    return f"'sha256-{base64.b64encode(digest).decode()}'"
