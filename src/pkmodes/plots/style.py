"""The style of all figures: one style sheet, a palette, and figures that belong to no global state."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from importlib.resources import as_file, files
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: The colours of text and background: in pages they follow those of the page, light or dark.
INK, PAPER = "#010203", "#fefdfc"
#: Colours of data (Okabe and Ito, 2008), which also differ for colour-blind readers.
BLUE, VERMILLION, GREEN, PURPLE, ORANGE, SKY = (
    "#0072b2",
    "#d55e00",
    "#009e73",
    "#cc79a7",
    "#e69f00",
    "#56b4e9",
)
GREY = "#80868b"
PALETTE = (BLUE, VERMILLION, GREEN, PURPLE, ORANGE, SKY)
#: Colours that a page does not redefine, for images, for marks on them and for their legends: an image keeps its
#: colours on a dark page.  The palette is one step off, so that it is not recognised.
BLACK, WHITE = "#000000", "#ffffff"
UNCHANGED = ("#0072b3", "#d55e01", "#009e74", "#cc79a8", "#e69f01", "#56b4e8", "#80868c")
#: Width of a figure that is as wide as a page's text [inch].
WIDTH = 6.3
#: Settings of a session that are not a matter of style.
OF_THE_SESSION = ("backend", "backend_fallback", "interactive", "toolbar", "timezone")


@contextmanager
def styled() -> Iterator[None]:
    """Draw in the style of pkmodes, whatever the user's own settings; figures are created and saved inside."""
    import matplotlib

    with matplotlib.rc_context():
        matplotlib.rcParams.update(_settings())
        yield


def figure(height: float, width: float = WIDTH) -> Figure:
    """Return an empty figure, sizes in inches; call it inside `styled`."""
    from matplotlib.figure import Figure

    return Figure(figsize=(width, height), layout="constrained")


@cache
def _settings() -> Any:
    """Return the style sheet on top of matplotlib's defaults."""
    import matplotlib

    with as_file(files(__package__) / "pkmodes.mplstyle") as path:
        settings = matplotlib.rc_params_from_file(path, use_default_template=True)
    return {name: value for name, value in settings.items() if name not in OF_THE_SESSION}
