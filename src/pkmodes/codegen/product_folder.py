"""The folder of a generated model: where it may be written, and which of its files belong to the generator.

Users may keep other files in the folder; nothing here replaces or removes them.  One process at a time writes there.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

from pkmodes.core.base.errors import OutputError, shown
from pkmodes.core.support.ordering import listed
from pkmodes.core.support.places import resolve_path
from pkmodes.core.support.writing import write_error

MANIFEST = "manifest.json"
#: The lock file: hidden, and removed at the end.
LOCK = ".pkmodes-generate.lock"
#: Seconds to wait for another process that is writing.
PATIENCE = 60
ELSEWHERE = "name a new or empty folder, such as --out build/my-robot"


def check_place(out: Path, beside: Sequence[Path], recorded: Mapping[str, Any] | None) -> None:
    """Reject a folder that is not suitable for generated files, before anything is derived.

    - beside: paths that may be in the folder: the robot file, and others that are checked separately
    - recorded: the manifest in the folder

    Raises OutputError if it is the root of a file system or repository, the home folder, or contains other files than
    a model.
    """
    place = resolve_path(out, "--out")
    if place == Path(place.anchor):
        raise OutputError("cannot write a model into the root of the file system", str(out), ELSEWHERE)
    if _is_home(place):
        raise OutputError("cannot write a model into the home folder itself", str(out), ELSEWHERE)
    if recorded is not None or not place.is_dir():
        return
    if (place / ".git").exists():
        raise OutputError("cannot write a model into the root of a repository", str(out), ELSEWHERE)
    allowed = [path for path in beside if path.exists()]
    try:
        foreign = sorted(
            entry.name
            for entry in place.iterdir()
            if not entry.name.startswith(".")
            and not (entry.exists() and any(entry.samefile(path) for path in allowed))
        )
    except OSError as error:
        raise OutputError(
            f"cannot write: {(error.strerror or str(error)).lower()}",
            str(out),
            "choose another place or make it readable",
        ) from None
    if foreign:
        raise OutputError(
            f"the folder contains other files ({listed(foreign, 1)}) and no manifest of a generated model",
            str(out),
            ELSEWHERE,
        )


def check_owner(out: Path, recorded: Mapping[str, Any], reference: str, name: str) -> None:
    """Reject a folder that holds the model of another robot.

    If the recorded robot file no longer exists and the robot's name is the same, the folder or the file was moved,
    and the folder is accepted.

    Raises OutputError if the folder holds the model of another robot.
    """
    robot = recorded.get("robot") if isinstance(recorded.get("robot"), dict) else {}
    owner = robot.get("file") if robot else None
    if owner == reference:
        return
    if isinstance(owner, str) and robot and robot.get("name") == name and not _is_file(out, owner):
        return
    origin = f"the robot file {owner}" if owner else f"the mechanism {recorded.get('mechanism')}"
    raise OutputError(
        f"the folder already holds the model generated from {origin}",
        str(out),
        "choose another folder, or remove that one",
    )


def check_mechanism(folder: Path, recorded: Mapping[str, Any] | None, name: str) -> None:
    """Reject a folder that holds anything but the code of this mechanism.

    Raises OutputError.
    """
    if recorded is not None and ("robot" in recorded or recorded.get("product") != name):
        problem = f"the folder holds generated files other than the code of the mechanism {name}"
        raise OutputError(problem, str(folder), "choose another folder, or remove that one")


def check_no_link(path: Path) -> None:
    """Reject a symbolic link in the place of generated files: in a received folder it may lead anywhere.

    Raises OutputError.
    """
    if path.is_symlink():
        problem = f"expected a file or folder, found that {shown(path.name)} is a symbolic link"
        raise OutputError(problem, str(path.parent), "remove the link, or choose another folder")


def stale_outputs(
    out: Path, recorded: Mapping[str, Any], names: Iterable[str], generated: Callable[[Path], bool]
) -> list[Path]:
    """Return outputs of an earlier generation that are not among the new ones, as after renaming the robot.

    - recorded: the manifest in the folder
    - names: files that are about to be written
    - generated: returns whether a file carries the generator's header

    Raises OutputError if one of the new outputs would replace a file that the generator did not write.
    """
    former = recorded["outputs"]
    for name in names:
        path = out / name
        if name != MANIFEST and name not in former and path.exists() and not generated(path):
            raise OutputError(
                f"{name} would be replaced, but it was not generated",
                str(out),
                "move that file, or choose another folder",
            )
    # Only files directly in this folder, so that a manifest cannot cause the removal of anything elsewhere.
    beside = [path for path in out.iterdir() if path.is_file() and not path.is_symlink()]
    return [path for path in beside if path.name in former.keys() - set(names) and generated(path)]


@contextmanager
def alone(folder: Path) -> Iterator[None]:
    """Make a folder, and keep other processes from generating into it; what stays empty is removed again.

    Raises OutputError if the folder cannot be made or written, or another process does not finish.
    """
    from filelock import FileLock, Timeout

    made = [place for place in (folder, *folder.parents) if not place.exists()]
    lock = FileLock(folder / LOCK, timeout=PATIENCE)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        lock.acquire()
    except Timeout:
        problem = f"another process has been generating into the folder for {PATIENCE} s"
        raise OutputError(problem, str(folder), "end it, or choose another folder") from None
    except OSError as error:
        raise write_error(error, folder) from None
    except NotImplementedError:  # a file system without locks
        pass
    try:
        yield
    finally:
        with suppress(OSError):
            (folder / LOCK).unlink()
        lock.release()
        for place in made:
            with suppress(OSError):  # it is in use
                place.rmdir()


def _is_file(folder: Path, name: str) -> bool:
    try:
        return (folder / name).is_file()
    except (OSError, ValueError):  # not a valid file name
        return False


def _is_home(place: Path) -> bool:
    try:
        return place == Path.home().resolve()
    except RuntimeError:  # there is no home folder
        return False
