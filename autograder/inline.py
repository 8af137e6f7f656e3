"""Makes a picture that can stand in somebody else's page: SVG without a style sheet.

A page that cleans what it shows removes style sheets, and those that it keeps would apply to all
of the page.
"""

from __future__ import annotations

import re
from xml.etree import ElementTree as ET

SVG = "http://www.w3.org/2000/svg"
_RULE = re.compile(r"\.\w+ \.([\w-]+)\{([^}]*)\}")
_XML_SPACE = "{http://www.w3.org/XML/1998/namespace}space"


def without_stylesheet(picture: str) -> str:
    """Return an SVG picture of the kit with the rules of its style sheet as attributes.

    What the style sheet says about dark pages is dropped. O(size).
    """
    ET.register_namespace("", SVG)
    root = ET.fromstring(picture)
    sheet = root.find(f"{{{SVG}}}style")
    rules: dict[str, str] = {}
    if sheet is not None:
        light = (sheet.text or "").partition("@media")[0]
        rules = dict(_RULE.findall(light))
        root.remove(sheet)
    for element in root.iter():
        element.attrib.pop(_XML_SPACE, None)
        looks = rules.get(element.attrib.pop("class", ""), "")
        for look in filter(None, looks.split(";")):
            name, _, value = look.partition(":")
            element.set(name, value)
    return ET.tostring(root, encoding="unicode")
