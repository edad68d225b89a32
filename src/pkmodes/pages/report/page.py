"""One self-contained HTML page from its sections, by Jinja2 templates that hold no mathematics."""

from __future__ import annotations

import os
import re
from collections.abc import Sequence
from datetime import UTC, datetime
from functools import cache
from importlib.resources import files
from typing import TYPE_CHECKING, Any

from pkmodes.core.base.errors import PkmodesError, shown
from pkmodes.core.base.version import VERSION
from pkmodes.core.support.extras import require
from pkmodes.core.support.page_policy import with_policy
from pkmodes.pages.report.blocks import Section, Summary
from pkmodes.pages.view.markup import breakable

if TYPE_CHECKING:
    from jinja2 import Environment

TEMPLATES, PAGE, STYLE, BROWSER = "templates", "page.html.j2", "style.css", "browser"
#: Variable of the environment with the time of reproducible files (reproducible-builds.org).
EPOCH_VARIABLE = "SOURCE_DATE_EPOCH"
#: Program that pages with folded sections need.
FOLDING_PROGRAM = "fold"
#: A space at which a line must not end: between a number and its unit (in quotes it may be copied into a file), and
#: between a minus sign and its number.
UNBREAKABLE_SPACE = re.compile(
    r"(?<=\d) (?=(?:%|\u00b0|\u03c3|sigma|[\u00b5mk]?m|m?s|k?Hz|k?g|k?N|[m\u00b5]?rad|dB)(?:[^\w\"]|$))"
    r"|(?<=\u2212) (?=\d)"
)
NO_BREAK_SPACE = "\u00a0"


def need_report() -> None:
    """Refuse to make a report without the libraries for it."""
    require("reports", "report", "jinja2", "matplotlib")


def page(summary: Summary, sections: Sequence[Section]) -> str:
    """Return a page as HTML that needs no other file and no network.

    - summary: its head
    - sections: in the order of the page

    Raises MissingExtraError if Jinja2 or matplotlib is not installed.
    """
    need_report()
    template = _environment().get_template(PAGE)
    style = (files(__package__) / TEMPLATES / STYLE).read_text(encoding="utf-8")
    # The programs that the blocks need in the browser, each once.
    names = dict.fromkeys(name for section in sections for block in section.blocks for name in block.programs)
    if any(section.folded for section in sections):
        names[FOLDING_PROGRAM] = None
    folder = files(__package__) / BROWSER
    programs = [
        "".join((folder / f"{part}.js").read_text(encoding="utf-8") for part in name.split("+"))
        for name in names
    ]
    html = template.render(
        date=date_of_page(),
        summary=summary,
        sections=list(sections),
        style=style,
        programs=programs,
        version=VERSION,
    )
    return with_policy(html)


def date_of_page() -> str:
    """Return the date of a page, as in ISO 8601: that of ``SOURCE_DATE_EPOCH`` where it is set, else today's.

    Raises PkmodesError if it is not a number of seconds since 1970.
    """
    epoch = os.environ.get(EPOCH_VARIABLE)
    if epoch is None:
        return datetime.now().astimezone().date().isoformat()
    try:
        return datetime.fromtimestamp(int(epoch), UTC).date().isoformat()
    except (ValueError, OverflowError, OSError):
        problem = f"expected whole seconds since 1970, found {shown(epoch)}"
        raise PkmodesError(problem, EPOCH_VARIABLE, "unset it, or give such a number") from None


@cache
def _environment() -> Environment:
    from jinja2 import Environment, PackageLoader, StrictUndefined

    environment = Environment(
        loader=PackageLoader(__package__, TEMPLATES),
        autoescape=True,
        finalize=_with_unbreakable_spaces,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    environment.filters["breakable"] = breakable
    return environment


def _with_unbreakable_spaces(value: Any) -> Any:
    """Return a text with no-break spaces before units; what is HTML already, or was escaped, as it is."""
    return UNBREAKABLE_SPACE.sub(NO_BREAK_SPACE, value) if type(value) is str else value
