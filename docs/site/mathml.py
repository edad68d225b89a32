"""Formulas as MathML, written when the site is built: browsers typeset it without any script.

latex2mathml translates.  What it leaves to the browser, and browsers with MathML Core do not do, is added here:
spaces around functions, signs instead of differences, names in the typewriter font, and places where long sums may
break.
"""

from __future__ import annotations

import re
from xml.etree import ElementTree

from docutils import nodes
from latex2mathml.converter import convert
from sphinx.application import Sphinx
from sphinx.writers.html5 import HTML5Translator

NAMESPACE = "http://www.w3.org/1998/Math/MathML"
FUNCTIONS = {"cos", "sin", "tan", "asin", "atan2", "arccos", "exp", "log", "det", "sgn", "min", "max"}
#: Functions with names of their own; latex2mathml knows only letters in them.
NAMED = re.compile(r"\\operatorname\{([a-z]+)_?\{?(2?)\}?\}")
#: Operators before which a formula may continue on the next line.
BREAKS = {"+", "\u2212", "="}
#: After these, a minus is a sign.
OPENING = {"(", "[", "=", "+", "\u2212", ","}
THIN = "0.17em"
ROW, IDENTIFIER, OPERATOR, SPACE, TEXT = (
    f"{{{NAMESPACE}}}{name}" for name in ("mrow", "mi", "mo", "mspace", "mtext")
)

ElementTree.register_namespace("", NAMESPACE)


def pieces(latex: str, *, display: bool) -> list[str]:
    """Return a formula as one or more ``<math>`` elements, between which a line may break.

    Parameters
    ----------
    latex : str
        LaTeX mathematics, perhaps between the backticks of GitHub's inline formulas.
    display : bool
        Whether the formula stands on its own; others are a single element.
    """
    plain = re.sub(r"^`(.*)`$", r"\1", latex.strip(), flags=re.DOTALL)
    root = ElementTree.fromstring(convert(NAMED.sub(r"\\text{\1\2}", plain)))
    for row in list(root.iter()):
        _typewriter(row)
        _functions(row)
        _signs(row)
    (top,) = root
    parts: list[list[ElementTree.Element]] = [[]]
    for child in top:
        infix = child.tag == OPERATOR and child.text in BREAKS and child.get("form") != "prefix"
        if display and infix and parts[-1]:
            parts.append([])
        parts[-1].append(child)
    return [_math(part, display=display) for part in parts]


def _math(children: list[ElementTree.Element], *, display: bool) -> str:
    """Return children as one element; an operator at its start follows a space, and is one between operands."""
    math = ElementTree.Element(f"{{{NAMESPACE}}}math", {"displaystyle": "true"} if display else {})
    row = ElementTree.SubElement(math, ROW)
    for child in children:
        row.append(child)
    if children[0].tag == OPERATOR and children[0].text in BREAKS and len(children) > 1:
        children[0].attrib = {"form": "infix", "lspace": "0", **children[0].attrib}
    return ElementTree.tostring(math, encoding="unicode")


def _typewriter(row: ElementTree.Element) -> None:
    """Join letters in the typewriter font, which browsers do not apply to single identifiers, into words."""
    word: ElementTree.Element | None = None
    for child in list(row):
        if child.get("mathvariant") != "monospace":
            word = None
        elif word is None:
            word = child
            word.tag = TEXT
            word.attrib = {"class": "name"}
        else:
            word.text = (word.text or "") + (child.text or "")
            row.remove(child)


def _functions(row: ElementTree.Element) -> None:
    """Make functions identifiers with a thin space on each side that has an operand."""
    children = list(row)
    for before, child, after in zip([None, *children], children, [*children[1:], None], strict=False):
        if child.tag not in (OPERATOR, IDENTIFIER, TEXT) or child.text not in FUNCTIONS:
            continue
        child.tag = IDENTIFIER
        child.attrib = {}
        place = list(row).index(child)
        if after is not None and not _opens(after):
            row.insert(place + 1, ElementTree.Element(SPACE, {"width": THIN}))
        if before is not None and before.tag != OPERATOR:
            row.insert(place, ElementTree.Element(SPACE, {"width": THIN}))


def _opens(element: ElementTree.Element) -> bool:
    """Return whether an element begins with a parenthesis."""
    first = next((e for e in element.iter() if e.tag not in (ROW,)), element)
    return first.tag == OPERATOR and (first.text or "") in "(["


def _signs(row: ElementTree.Element) -> None:
    """Set a minus close to what it negates."""
    before: ElementTree.Element | None = None
    for child in row:
        opened = before is None or (before.tag == OPERATOR and before.text in OPENING)
        if child.tag == OPERATOR and child.text == "\u2212" and opened:
            child.set("form", "prefix")
        before = child


def _inline(translator: HTML5Translator, node: nodes.math) -> None:
    translator.body.extend(pieces(node.astext(), display=False))
    raise nodes.SkipNode


def _block(translator: HTML5Translator, node: nodes.math_block) -> None:
    translator.body.append(translator.starttag(node, "div", CLASS="formula"))
    translator.body.append("\n".join(pieces(node.astext(), display=True)))
    translator.body.append("</div>\n")
    raise nodes.SkipNode


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the renderer."""
    app.add_html_math_renderer("mathml", (_inline, None), (_block, None))
    return {"parallel_read_safe": True, "parallel_write_safe": True}
