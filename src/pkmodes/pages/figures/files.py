"""Write the figures of a robot."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pkmodes.core.base.arguments import check_argument, one_of
from pkmodes.core.base.errors import OutputError
from pkmodes.core.support.replacing import check_replaced, contains_mark
from pkmodes.core.support.writing import write_files
from pkmodes.pages.figures.pictures import PICTURES, Picture, pictures
from pkmodes.pages.plots.style import GREY, figure_style

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from pkmodes.core.model import Model

FORMATS = ("svg", "png", "pdf")
#: Distance between a figure and the caption below it [inch].
CAPTION_GAP = 0.08


def write_pictures(
    model: Model,
    folder: Path,
    grid: Any = None,
    formats: Sequence[str] = ("svg",),
    *,
    drives: str | None = None,
    overwrite: bool = False,
) -> list[Path]:
    """Draw the figures of a robot and write them, all or none.

    A figure that would show the same value everywhere is not written; its file of an earlier run is removed.

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
    drives : {"free", "held"}, optional
        As for `pkmodes.Model.modes`.
    overwrite : bool
        Whether to replace a file that has the name of a figure but is something else.

    Returns
    -------
    list of Path
        The files.

    Raises
    ------
    PkmodesError, MissingExtraError
        As for `pictures`.
    OutputError
        If a format is unknown, a file of that name exists and is something else, or the folder cannot be written.
    """
    return write_pictures_and_sentences(model, folder, grid, formats, drives=drives, overwrite=overwrite)[0]


def write_pictures_and_sentences(
    model: Model, folder: Path, grid: Any, formats: Sequence[str], *, drives: str | None, overwrite: bool
) -> tuple[list[Path], dict[str, str]]:
    """Write as `write_pictures` does; return the files, and the sentences that replace figures, by figure name."""
    for file_format in formats:
        check_argument(file_format, one_of(FORMATS), "formats", "choose one of the three", OutputError)
    for kind in PICTURES:
        problem = "the file exists, and is not such a figure"
        paths = [folder / f"{kind.name}.{file_format}" for file_format in formats]
        remedy = "choose another folder, or replace what is there with overwrite=True (--overwrite)"
        check_replaced(
            paths,
            "folder",
            overwrite,
            contains_mark(kind.mark),
            what=problem,
            remedy=remedy,
        )
    files: dict[str, bytes] = {}
    sentences: dict[str, str] = {}
    for picture in pictures(model, grid, drives=drives):
        if picture.instead:
            sentences[picture.name] = picture.instead
            continue
        for file_format in formats:
            files[f"{picture.name}.{file_format}"] = image_bytes(picture, file_format)
    written = write_files(folder, files)
    for kind in PICTURES:  # a figure left from an earlier run would be taken for one of this robot
        stale = [folder / f"{kind.name}.{file_format}" for file_format in formats if kind.name in sentences]
        for path in stale:
            if path.is_file() and contains_mark(kind.mark)(path):
                path.unlink()
    return written, sentences


def image_bytes(picture: Picture, file_format: str) -> bytes:
    """Return the file of a figure: on a white background, with a caption below; the same bytes at every run."""
    fixed_metadata: dict[str, dict[str, Any]] = {
        "svg": {"Date": None, "Description": picture.description},
        "pdf": {"CreationDate": None, "Subject": picture.description},
        "png": {"Software": None, "Description": picture.description},
    }
    target = BytesIO()
    with figure_style(), _with_caption_below(picture.figure, picture.about):
        metadata = {**fixed_metadata[file_format], "Title": picture.title}
        picture.figure.savefig(
            target,
            format=file_format,
            metadata=metadata,
            bbox_inches="tight",
            pad_inches=0.05,
            facecolor="white",
        )
    return target.getvalue()


@contextmanager
def _with_caption_below(figure: Figure, caption: str) -> Iterator[None]:
    """Write a caption below everything that a figure shows, while it is saved."""
    if not caption:
        yield
        return
    figure.draw_without_rendering()
    box = figure.get_tightbbox()
    width, height = figure.get_size_inches()
    text = figure.text(
        box.x0 / width,
        (box.y0 - CAPTION_GAP) / height,
        caption,
        va="top",
        fontsize=7,
        color=GREY,
        in_layout=True,
    )
    try:
        yield
    finally:
        text.remove()
