"""Figures as SVG inside a page: accessible, following the page's colours, with ids of their own."""

from __future__ import annotations

import io
import re
import warnings
from collections.abc import Mapping
from hashlib import sha256
from typing import TYPE_CHECKING, Any
from xml.etree import ElementTree

from pkmodes.pages.plots.drawing import Drawing
from pkmodes.pages.plots.style import BLUE, GREEN, GREY, INK, ORANGE, PAPER, PURPLE, SKY, VERMILLION, styled

if TYPE_CHECKING:
    from matplotlib.figure import Figure

SVG, LINK = "{http://www.w3.org/2000/svg}", "{http://www.w3.org/1999/xlink}href"
#: Colours that the page may redefine, for example for a dark background.
NAMES = {
    BLUE: "blue",
    VERMILLION: "vermillion",
    GREEN: "green",
    PURPLE: "purple",
    ORANGE: "orange",
    SKY: "sky",
    GREY: "grey",
}
COLOURS = {
    INK: "currentColor",
    PAPER: "var(--paper, Canvas)",
    **{colour: f"var(--{name}, {colour})" for colour, name in NAMES.items()},
}
COLOUR = re.compile("|".join(COLOURS), re.IGNORECASE)
#: The page's fonts in place of the one used for the layout.
FONTS = (
    (re.compile(r"\bfont: (\S*px) [^;]*"), r"font-size: \1"),
    (re.compile(r"font-family: [^;]*"), "font-family: inherit"),
)
#: Coordinates are rounded to two decimals: a figure is a few hundred units wide.
DECIMALS = re.compile(r"\d+\.\d{3,}")
SPACE = re.compile(r"\s+")
REFERENCE = re.compile(r"url\(#([^)]+)\)")
#: Characters that XML does not allow.
FORBIDDEN = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\ud800-\udfff\ufffe\uffff]")
#: Resolution of images in narrow figures, which have large panels [1/inch].
SPARING = 130
#: Most panels below one another on a narrow screen: of more, the wide figure is the shorter way.
MOST_PANELS = 12
#: Length of the prefix that makes ids unique to a figure.
DIGITS = 8


def inline(figure: Figure, title: str, description: str, *, cropped: bool = False) -> str:
    """Return a figure as an SVG element for an HTML page.

    Text, axes and background follow the page; the data keep their colours, which the page may redefine by the
    variables ``--blue``, ``--vermillion`` and so on.  The element is as wide as its parent, and the same figure
    always gives the same text.

    - title, description: name of the figure and what it shows, for those who do not see it
    - cropped: whether empty margins are cut off, as those of maps, whose panels keep their proportions
    """
    return _element(
        figure, title, description, {"bbox_inches": "tight", "pad_inches": 0.05} if cropped else {}
    )


def inline_narrow(drawing: Drawing, title: str, description: str) -> str:
    """Return a figure as `inline` does, drawn for a narrow screen; nothing if it does not fit one."""
    if not drawing.narrow:
        return ""
    with styled(), warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)  # panels that collapse, and characters that a font lacks
        sheet = drawing.sheet(narrow=True)
        visible_box = sheet.settle() if len(sheet.panels) <= MOST_PANELS else None
    if visible_box is None:
        return ""
    return _element(sheet.figure, title, description, {"bbox_inches": visible_box, "dpi": SPARING})


def _element(figure: Figure, title: str, description: str, settings: dict[str, Any]) -> str:
    target = io.StringIO()
    with styled(), warnings.catch_warnings():
        # Text is drawn by the reader's fonts; that the layout's font lacks a character only affects its width.
        warnings.filterwarnings("ignore", message="Glyph .* missing from")
        figure.savefig(target, format="svg", metadata={"Date": None, "Creator": None}, **settings)
    text = FORBIDDEN.sub("\ufffd", target.getvalue())
    root = ElementTree.fromstring(text)
    title, description = FORBIDDEN.sub("\ufffd", title), FORBIDDEN.sub("\ufffd", description)
    for parent in list(root.iter()):
        for child in list(parent):  # a rule in a style element would apply to the whole page
            if child.tag in (f"{SVG}metadata", f"{SVG}style"):
                parent.remove(child)
    # Matplotlib's ids are digests of places with all their digits, the last of which may differ between two layouts.
    used_ids = _used(root)
    _rename(root, {identifier: str(k) for k, identifier in enumerate(used_ids)})
    for element in root.iter():
        _simplify(element)
    drawing = ElementTree.tostring(root, encoding="unicode")
    digest = sha256("\0".join((title, description, drawing)).encode()).hexdigest()
    prefix = f"f{digest[:DIGITS]}"
    _rename(root, {str(k): f"{prefix}-{k}" for k in range(len(used_ids))})
    texts_by_tag = {"title": title, "desc": description}
    for position, (tag, content) in enumerate(texts_by_tag.items()):
        element = ElementTree.Element(tag, id=f"{prefix}-{tag}")
        element.text = content
        root.insert(position, element)
    root.attrib = {
        "xmlns": SVG[1:-1],
        "viewBox": root.get("viewBox", ""),
        "role": "img",
        "aria-labelledby": f"{prefix}-title",
        "aria-describedby": f"{prefix}-desc",
        "style": "display: block; width: 100%; height: auto; stroke-linejoin: round",
    }
    return ElementTree.tostring(root, encoding="unicode")


def _used(root: ElementTree.Element) -> list[str]:
    """Return the ids that are referred to, in the order of their elements."""
    referenced_ids: set[str] = set()
    for element in root.iter():
        for name, value in element.attrib.items():
            if name == LINK and value.startswith("#"):
                referenced_ids.add(value[1:])
            referenced_ids.update(REFERENCE.findall(value))
    return [
        identifier
        for element in root.iter()
        if (identifier := element.get("id")) in referenced_ids and identifier is not None
    ]


def _rename(root: ElementTree.Element, names: Mapping[str, str]) -> None:
    """Give elements other ids, also where they are referred to, and drop the ids that have no other name."""
    for element in root.iter():
        new_id = names.get(element.attrib.pop("id", ""))
        if new_id is not None:
            element.set("id", new_id)
        for name, value in list(element.attrib.items()):
            if name in (LINK, "href"):
                del element.attrib[name]
                element.set("href", f"#{names[value[1:]]}" if value.startswith("#") else value)
            elif "url(#" in value:
                element.set(name, REFERENCE.sub(lambda match: f"url(#{names[match[1]]})", value))


def _simplify(element: ElementTree.Element) -> None:
    """Remove namespaces, and let colours and fonts follow the page."""
    element.tag = element.tag.removeprefix(SVG)
    element.tail = None
    if element.tag != "text" and element.text is not None and not element.text.strip():
        element.text = None
    for name in ("style", "fill", "stroke"):
        value = element.get(name)
        if value is not None:
            value = COLOUR.sub(lambda match: COLOURS[match.group().lower()], value)
            for font, instead in FONTS:
                value = font.sub(instead, value)
            element.set(name, value)
    for name in ("d", "x", "y"):
        value = element.get(name)
        if value is not None:
            value = DECIMALS.sub(lambda match: f"{float(match.group()):.2f}", value)
            element.set(name, SPACE.sub(" ", value).strip())
