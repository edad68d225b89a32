"""Draw the pictures of docs/how-to/signals.md: the fit of the first file of the page's own campaign.

    python docs/figures/signals.py [FOLDER]

writes them next to this file, or into another folder.
"""

from __future__ import annotations

import contextlib
import re
import shutil
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

from pkmodes.modaltest.campaign.campaign import read_campaign
from pkmodes.modaltest.campaign.identify import identify
from pkmodes.pages.plots import fits
from pkmodes.pages.plots.style import figure_style

HERE = Path(__file__).parent
PAGE = HERE.parent / "how-to/signals.md"
PICTURES = ("signals-stabilisation", "signals-functions")


def block(language: str) -> str:
    """Return the first code block of the page in a language."""
    found = re.search(rf"```{language}\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)
    assert found is not None
    return found[1]


def main(arguments: Sequence[str]) -> None:
    """Write every picture."""
    folder = Path(arguments[0]).absolute() if arguments else HERE
    with tempfile.TemporaryDirectory() as name, contextlib.chdir(name):
        shutil.copytree(HERE.parents[1] / "robots", "robots")
        exec(block("python"), {"__name__": "page"})
        Path("campaign.toml").write_text(block("toml"), encoding="utf-8")
        result = identify(read_campaign("campaign.toml"), inspect=True).records[0]
    (one,) = result.inspections
    marked = fits.MarkedFrequencies(
        [(mode.frequency, k, False) for k, mode in enumerate(result.modes, start=1)], (), ()
    )
    band = result.record.band
    drawn = (
        fits.stabilisation_diagram(one, marked, band),
        fits.function_fits(one, marked, band, has_phase=True),
    )
    with figure_style():
        for picture, drawing in zip(PICTURES, drawn, strict=True):
            metadata = {"Date": None, "Creator": None}
            drawing.figure.savefig(folder / f"{picture}.svg", facecolor="white", metadata=metadata)


if __name__ == "__main__":
    main(sys.argv[1:])
