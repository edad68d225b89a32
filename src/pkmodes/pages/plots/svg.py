"""Figures as SVG inside a page: accessible, in the colours of the page, with unique ids."""

from __future__ import annotations

import io
import re
import warnings
from collections.abc import Mapping
from hashlib import sha256
from typing import TYPE_CHECKING, Any
from xml.etree import ElementTree

from pkmodes.pages.plots.drawing import Drawing
from pkmodes.pages.plots.style import (
    BLUE,
    GREEN,
    GREY,
    INK,
    ORANGE,
    PAPER,
    PURPLE,
    SKY,
    VERMILLION,
    figure_style,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure

SVG_NAMESPACE, XLINK_HREF = "{http://www.w3.org/2000/svg}", "{http://www.w3.org/1999/xlink}href"
#: Colours that the page may redefine, for example for a dark background.
VARIABLE_NAMES = {
    BLUE: "blue",
    VERMILLION: "vermillion",
    GREEN: "green",
    PURPLE: "purple",
    ORANGE: "orange",
    SKY: "sky",
    GREY: "grey",
}
PAGE_COLOURS = {
    INK: "currentColor",
    PAPER: "var(--paper, Canvas)",
    **{colour: f"var(--{name}, {colour})" for colour, name in VARIABLE_NAMES.items()},
}
COLOUR_PATTERN = re.compile("|".join(PAGE_COLOURS), re.IGNORECASE)
#: Replace the font of the layout by those of the page.
FONT_REPLACEMENTS = (
    (re.compile(r"\bfont: (\S*px) [^;]*"), r"font-size: \1"),
    (re.compile(r"font-family: [^;]*"), "font-family: inherit"),
)
#: Coordinates are rounded to two decimals: a figure is a few hundred units wide.
LONG_DECIMAL = re.compile(r"\d+\.\d{3,}")
WHITESPACE = re.compile(r"\s+")
ID_REFERENCE = re.compile(r"url\(#([^)]+)\)")
#: Characters that XML does not allow.
FORBIDDEN_IN_XML = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\ud800-\udfff\ufffe\uffff]")
#: Resolution of images in narrow figures, lower than in wide ones because their panels are large [1/inch].
NARROW_DPI = 130
#: Maximum number of panels below one another on a narrow screen; with more, the wide figure is easier to read.
MAX_NARROW_PANELS = 12
#: Length of the prefix that makes ids unique to a figure.
PREFIX_DIGITS = 8


def inline_svg(figure: Figure, title: str, description: str, *, cropped: bool = False) -> str:
    """Return a figure as an SVG element for an HTML page.

    Text, axes and background have the colours of the page; data have their own, which the page may redefine by the
    variables ``--blue``, ``--vermillion`` and so on.  The element is as wide as its parent, and the same figure
    always gives the same text.

    - title, description: text alternatives for readers who cannot see the figure
    - cropped: whether empty margins are cut off, as around maps, whose panels keep their ratio of height to width
    """
    return _svg_element(
        figure, title, description, {"bbox_inches": "tight", "pad_inches": 0.05} if cropped else {}
    )


def inline_narrow_svg(drawing: Drawing, title: str, description: str) -> str:
    """Return a figure drawn for a narrow screen, as `inline_svg` does; an empty text if it does not fit."""
    if not drawing.narrow:
        return ""
    with figure_style(), warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)  # panels that collapse, and characters that a font lacks
        sheet = drawing.sheet(narrow=True)
        visible_box = sheet.lay_out_narrow() if len(sheet.panels) <= MAX_NARROW_PANELS else None
    if visible_box is None:
        return ""
    return _svg_element(sheet.figure, title, description, {"bbox_inches": visible_box, "dpi": NARROW_DPI})


def _svg_element(figure: Figure, title: str, description: str, settings: dict[str, Any]) -> str:
    target = io.StringIO()
    with figure_style(), warnings.catch_warnings():
        # Text is drawn in the fonts of the reader; a character missing in the font of the layout affects only widths.
        warnings.filterwarnings("ignore", message="Glyph .* missing from")
        figure.savefig(target, format="svg", metadata={"Date": None, "Creator": None}, **settings)
    text = FORBIDDEN_IN_XML.sub("\ufffd", target.getvalue())
    root = ElementTree.fromstring(text)
    title, description = FORBIDDEN_IN_XML.sub("\ufffd", title), FORBIDDEN_IN_XML.sub("\ufffd", description)
    for parent in list(root.iter()):
        for child in list(parent):  # a rule in a style element would apply to the whole page
            if child.tag in (f"{SVG_NAMESPACE}metadata", f"{SVG_NAMESPACE}style"):
                parent.remove(child)
    # Ids from matplotlib are hashes of coordinates, whose last digits may differ between two layouts.
    referenced_ids = _referenced_ids(root)
    _rename_ids(root, {identifier: str(k) for k, identifier in enumerate(referenced_ids)})
    for element in root.iter():
        _simplify(element)
    drawing = ElementTree.tostring(root, encoding="unicode")
    digest = sha256("\0".join((title, description, drawing)).encode()).hexdigest()
    prefix = f"f{digest[:PREFIX_DIGITS]}"
    _rename_ids(root, {str(k): f"{prefix}-{k}" for k in range(len(referenced_ids))})
    texts_by_tag = {"title": title, "desc": description}
    for position, (tag, content) in enumerate(texts_by_tag.items()):
        element = ElementTree.Element(tag, id=f"{prefix}-{tag}")
        element.text = content
        root.insert(position, element)
    root.attrib = {
        "xmlns": SVG_NAMESPACE[1:-1],
        "viewBox": root.get("viewBox", ""),
        "role": "img",
        "aria-labelledby": f"{prefix}-title",
        "aria-describedby": f"{prefix}-desc",
        "style": "display: block; width: 100%; height: auto; stroke-linejoin: round",
    }
    return ElementTree.tostring(root, encoding="unicode")


def _referenced_ids(root: ElementTree.Element) -> list[str]:
    """Return the ids that are referred to, in the order of their elements."""
    referenced_ids: set[str] = set()
    for element in root.iter():
        for attribute, value in element.attrib.items():
            if attribute == XLINK_HREF and value.startswith("#"):
                referenced_ids.add(value[1:])
            referenced_ids.update(ID_REFERENCE.findall(value))
    return [
        identifier
        for element in root.iter()
        if (identifier := element.get("id")) in referenced_ids and identifier is not None
    ]


def _rename_ids(root: ElementTree.Element, new_ids: Mapping[str, str]) -> None:
    """Replace the ids of elements and the references to them, and drop ids that have no replacement."""
    for element in root.iter():
        new_id = new_ids.get(element.attrib.pop("id", ""))
        if new_id is not None:
            element.set("id", new_id)
        for attribute, value in list(element.attrib.items()):
            if attribute in (XLINK_HREF, "href"):
                del element.attrib[attribute]
                element.set("href", f"#{new_ids[value[1:]]}" if value.startswith("#") else value)
            elif "url(#" in value:
                element.set(attribute, ID_REFERENCE.sub(lambda match: f"url(#{new_ids[match[1]]})", value))


def _simplify(element: ElementTree.Element) -> None:
    """Remove namespaces, and use the colours and fonts of the page."""
    element.tag = element.tag.removeprefix(SVG_NAMESPACE)
    element.tail = None
    if element.tag != "text" and element.text is not None and not element.text.strip():
        element.text = None
    for name in ("style", "fill", "stroke"):
        value = element.get(name)
        if value is not None:
            value = COLOUR_PATTERN.sub(lambda match: PAGE_COLOURS[match.group().lower()], value)
            for pattern, replacement in FONT_REPLACEMENTS:
                value = pattern.sub(replacement, value)
            element.set(name, value)
    for name in ("d", "x", "y"):
        value = element.get(name)
        if value is not None:
            value = LONG_DECIMAL.sub(lambda match: f"{float(match.group()):.2f}", value)
            element.set(name, WHITESPACE.sub(" ", value).strip())
