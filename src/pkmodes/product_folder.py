"""The folder of a generated model: where one may be written, and which files there are the generator's.

A user may keep files of their own beside generated ones; nothing here replaces or removes those.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

from pkmodes.errors import OutputError

MANIFEST = "manifest.json"
ELSEWHERE = "name a new or empty folder, such as --out build/my-robot"


def check_place(out: Path, beside: Sequence[Path], recorded: Mapping[str, Any] | None) -> None:
    """Refuse a folder that is not one for generated files, before anything is derived.

    Parameters
    ----------
    out : Path
    beside : sequence of Path
        What may lie there: the robot file, and what is looked at for itself.
    recorded : mapping or None
        The manifest that is there.

    Raises
    ------
    OutputError
        If it is the root of a file system or of a repository, the home folder, or holds other things than a model.
    """
    place = out.resolve()
    if place == Path(place.anchor):
        raise OutputError("a model is not written into the root of the file system", str(out), ELSEWHERE)
    if _is_home(place):
        raise OutputError("a model is not written into the home folder itself", str(out), ELSEWHERE)
    if recorded is not None or not place.is_dir():
        return
    if (place / ".git").exists():
        raise OutputError("a model is not written into the root of a repository", str(out), ELSEWHERE)
    allowed = {path.resolve() for path in beside}
    try:
        foreign = sorted(
            entry.name
            for entry in place.iterdir()
            if not entry.name.startswith(".") and entry.resolve() not in allowed
        )
    except OSError as error:
        raise OutputError(
            f"cannot write: {(error.strerror or str(error)).lower()}",
            str(out),
            "choose another place or free it",
        ) from None
    if foreign:
        others = f" and {len(foreign) - 1} more" if len(foreign) > 1 else ""
        raise OutputError(
            f"the folder holds other things ({foreign[0]}{others}), and no manifest that says it was generated",
            str(out),
            ELSEWHERE,
        )


def check_owner(out: Path, recorded: Mapping[str, Any], reference: str, name: str) -> None:
    """Refuse a folder that holds the model of another robot.

    The model of a robot file that is not where it was, and that had the same name, is taken over: the folder or
    the file was moved.

    Raises
    ------
    OutputError
        If the model there is not one of this robot.
    """
    robot = recorded.get("robot") if isinstance(recorded.get("robot"), dict) else {}
    owner = robot.get("file") if robot else None
    if owner == reference:
        return
    if isinstance(owner, str) and robot and robot.get("name") == name and not _is_file(out, owner):
        return
    found = f"the robot file {owner}" if owner else f"the mechanism {recorded.get('mechanism')}"
    raise OutputError(
        f"the folder already holds the model generated from {found}",
        str(out),
        "choose another folder, or remove that one",
    )


def check_mechanism(folder: Path, recorded: Mapping[str, Any] | None, name: str) -> None:
    """Refuse a folder that holds another product than the code of a mechanism.

    Raises
    ------
    OutputError
    """
    if recorded is not None and ("robot" in recorded or recorded.get("product") != name):
        what = f"the folder holds another product than the code of the mechanism {name}"
        raise OutputError(what, str(folder), "choose another folder, or remove that one")


def stale_outputs(
    out: Path, recorded: Mapping[str, Any], names: Iterable[str], generated: Callable[[Path], bool]
) -> list[Path]:
    """Outputs of an earlier generation, under a name that the robot had then.

    Parameters
    ----------
    out : Path
    recorded : mapping
        The manifest that is there.
    names : iterable of str
        Files that are going to be written.
    generated : callable
        Whether a file carries the generator's header.

    Raises
    ------
    OutputError
        If one of the new outputs would replace a file that the generator did not write.
    """
    former = recorded["outputs"]
    for name in names:
        path = out / name
        if name != MANIFEST and name not in former and path.exists() and not generated(path):
            raise OutputError(
                f"{name} would be replaced, and was not generated",
                str(out),
                "move that file, or choose another folder",
            )
    # Only files in this very folder: a manifest cannot make us remove anything elsewhere.
    beside = [path for path in out.iterdir() if path.is_file() and not path.is_symlink()]
    return [path for path in beside if path.name in former.keys() - set(names) and generated(path)]


def _is_file(folder: Path, name: str) -> bool:
    try:
        return (folder / name).is_file()
    except (OSError, ValueError):  # a name that cannot be one of a file
        return False


def _is_home(place: Path) -> bool:
    try:
        return place == Path.home().resolve()
    except RuntimeError:  # there is none
        return False
