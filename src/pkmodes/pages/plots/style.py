"""The style of all figures: one style sheet, a palette, and figures outside the global state of pyplot."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import cache
from importlib.resources import as_file, files
from typing import TYPE_CHECKING, Any

from numpy.typing import NDArray

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Colours of text and background; on a page they are replaced by those of the page, light or dark.
INK, PAPER = "#010203", "#fefdfc"
#: Colours of data (Okabe and Ito, 2008), which colour-blind readers can distinguish.
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
#: Colours that a page does not redefine, for marks on images: images look the same on a dark page.
BLACK, WHITE = "#000000", "#ffffff"
#: Luminance L at which black and white have the same contrast: 1.05 / (L + 0.05) = (L + 0.05) / 0.05.
EQUAL_CONTRAST_LUMINANCE = 0.179
#: Width of a figure as wide as the text of a page [inch].
FIGURE_WIDTH = 6.3
#: Characters per line of such a figure.
CHARACTERS_PER_LINE = 90
#: Settings of a session that do not affect the style.
SESSION_SETTINGS = ("backend", "backend_fallback", "interactive", "toolbar", "timezone")


@contextmanager
def figure_style() -> Iterator[None]:
    """Apply the style of pkmodes instead of the settings of the user; create and save figures inside this context."""
    import matplotlib

    with matplotlib.rc_context():
        matplotlib.rcParams.update(_settings())
        yield


def figure(height: float, width: float = FIGURE_WIDTH) -> Figure:
    """Return an empty figure, with sizes in inches; call it inside `figure_style`."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    new_figure = Figure(figsize=(width, height), layout="constrained")
    FigureCanvasAgg(new_figure)  # without a canvas, each layout measures every text again
    return new_figure


def sentence_figure(sentence: str) -> Figure:
    """Return a figure that consists of a sentence; call it inside `figure_style`."""
    from textwrap import wrap

    lines = wrap(sentence, CHARACTERS_PER_LINE)
    new_figure = figure(0.2 * len(lines) + 0.1)
    new_figure.text(0.01, 0.5, "\n".join(lines), va="center", linespacing=1.5)
    return new_figure


def contrasting_ink(colour: Sequence[float] | NDArray[Any]) -> str:
    """Return the colour of text on a colour that no page redefines: black or white, whichever has more contrast.

    References
    ----------
    Web Content Accessibility Guidelines 2.1, relative luminance.
    """
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in colour[:3]]
    luminance = sum(weight * c for weight, c in zip((0.2126, 0.7152, 0.0722), linear, strict=True))
    return BLACK if luminance > EQUAL_CONTRAST_LUMINANCE else WHITE


@cache
def _settings() -> Any:
    """Return the style sheet on top of matplotlib's defaults."""
    import matplotlib

    with as_file(files(__package__) / "pkmodes.mplstyle") as path:
        settings = matplotlib.rc_params_from_file(path, use_default_template=True)
    return {name: value for name, value in settings.items() if name not in SESSION_SETTINGS}
