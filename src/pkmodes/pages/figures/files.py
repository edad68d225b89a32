"""Write the figures of a robot."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pkmodes.core.base.arguments import check_argument, one_of
from pkmodes.core.base.drives import FREE
from pkmodes.core.base.errors import OutputError
from pkmodes.core.support.replacing import check_replaced, holds
from pkmodes.core.support.writing import write_files
from pkmodes.pages.figures.pictures import PICTURES, Picture, pictures
from pkmodes.pages.plots.style import GREY, styled

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from pkmodes.core.model import Model

FORMATS = ("svg", "png", "pdf")
#: Distance between a figure and the line below it [inch].
GAP = 0.08


def write_pictures(
    model: Model,
    folder: Path,
    grid: Any = None,
    formats: Sequence[str] = ("svg",),
    *,
    drives: str = FREE,
    overwrite: bool = False,
) -> list[Path]:
    """Draw the figures of a robot and write them, all or none; one that would show the same everywhere is a sentence.

    Parameters
    ----------
    model : Model
        The robot.
    folder : Path
        Created if it does not exist.
    grid : mapping of str to array_like, optional
        As for `pictures`.
    formats : sequence of {"svg", "png", "pdf"}
        Each figure is written in all of them.
    drives : {"free", "held"}
        As for `pkmodes.Model.modes`.
    overwrite : bool
        Whether a file with the name of a figure is replaced also where it is no such figure.

    Returns
    -------
    list of Path
        The files.

    Raises
    ------
    PkmodesError, MissingExtraError
        As for `pictures`.
    OutputError
        If a format is unknown, a file is there that is something else, or the folder cannot be written.
    """
    return written_pictures(model, folder, grid, formats, drives=drives, overwrite=overwrite)[0]


def written_pictures(
    model: Model, folder: Path, grid: Any, formats: Sequence[str], *, drives: str, overwrite: bool
) -> tuple[list[Path], dict[str, str]]:
    """Do as `write_pictures`; return the files, and the sentences instead of figures by name."""
    for suffix in formats:
        check_argument(suffix, one_of(FORMATS), "formats", "choose one of the three", OutputError)
    for kind in PICTURES:
        problem = "the file exists, and is not such a figure"
        places = [folder / f"{kind.name}.{suffix}" for suffix in formats]
        remedy = "choose another folder, or replace what is there with overwrite=True (--overwrite)"
        check_replaced(places, "folder", overwrite, holds(kind.title.encode()), what=problem, remedy=remedy)
    files: dict[str, bytes] = {}
    sentences: dict[str, str] = {}
    for picture in pictures(model, grid, drives=drives):
        if picture.instead:
            sentences[picture.name] = picture.instead
        for suffix in formats:
            files[f"{picture.name}.{suffix}"] = rendered(picture, suffix)
    return write_files(folder, files), sentences


def rendered(picture: Picture, suffix: str) -> bytes:
    """Return a figure as the content of a file: on white, with what it shows below it, the same at every run."""
    fixed_metadata: dict[str, dict[str, Any]] = {
        "svg": {"Date": None, "Description": picture.description},
        "pdf": {"CreationDate": None, "Subject": picture.description},
        "png": {"Software": None, "Description": picture.description},
    }
    target = BytesIO()
    with styled(), _with_line_below(picture.figure, picture.about):
        metadata = {**fixed_metadata[suffix], "Title": picture.title}
        picture.figure.savefig(
            target, format=suffix, metadata=metadata, bbox_inches="tight", pad_inches=0.05, facecolor="white"
        )
    return target.getvalue()


@contextmanager
def _with_line_below(figure: Figure, line: str) -> Iterator[None]:
    """Write a line below everything that a figure shows, for as long as it is saved."""
    if not line:
        yield
        return
    figure.draw_without_rendering()
    box = figure.get_tightbbox()
    width, height = figure.get_size_inches()
    text = figure.text(
        box.x0 / width, (box.y0 - GAP) / height, line, va="top", fontsize=7, color=GREY, in_layout=True
    )
    try:
        yield
    finally:
        text.remove()
