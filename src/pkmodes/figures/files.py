"""Write the figures of a robot."""

from __future__ import annotations

from collections.abc import Sequence
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pkmodes.base.arguments import check_argument, one_of
from pkmodes.base.drives import FREE
from pkmodes.base.errors import OutputError
from pkmodes.base.writing import write_files
from pkmodes.figures.pictures import Picture, pictures
from pkmodes.plots.style import styled

if TYPE_CHECKING:
    from pkmodes.model.model import Model

FORMATS = ("svg", "png", "pdf")


def write_pictures(
    model: Model,
    folder: Path,
    grid: Any = None,
    formats: Sequence[str] = ("svg",),
    *,
    drives: str = FREE,
) -> list[Path]:
    """Draw the figures of a robot and write them, all or none.

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

    Returns
    -------
    list of Path
        The files.

    Raises
    ------
    PkmodesError, MissingExtraError
        As for `pictures`.
    OutputError
        If a format is unknown, or the folder cannot be written.
    """
    for one in formats:
        check_argument(one, one_of(FORMATS), "formats", "choose one of the three", OutputError)
    files: dict[str, bytes] = {}
    for picture in pictures(model, grid, drives=drives):
        for one in formats:
            files[f"{picture.name}.{one}"] = rendered(picture, one)
    return write_files(folder, files)


def rendered(picture: Picture, suffix: str) -> bytes:
    """Return a figure as the content of a file: on white, the same at every run."""
    nothing: dict[str, Any] = {
        "svg": {"Date": None},
        "pdf": {"CreationDate": None},
        "png": {"Software": None},
    }
    target = BytesIO()
    with styled():
        metadata = {**nothing[suffix], "Title": picture.title}
        picture.figure.savefig(
            target, format=suffix, metadata=metadata, bbox_inches="tight", pad_inches=0.05, facecolor="white"
        )
    return target.getvalue()
