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
LOCK_FILE = ".pkmodes-generate.lock"
#: Time to wait for another process that is writing [s].
LOCK_TIMEOUT = 60
FOLDER_REMEDY = "name a new or empty folder, such as --out build/my-robot"


def check_place(out: Path, allowed: Sequence[Path], manifest: Mapping[str, Any] | None) -> None:
    """Reject a folder that is not suitable for generated files, before anything is derived.

    - allowed: paths that may be in the folder: the robot file, and others that are checked separately
    - manifest: the manifest in the folder

    Raises OutputError if it is the root of a file system or repository, the home folder, or contains other files than
    a model.
    """
    resolved = resolve_path(out, "--out")
    if resolved == Path(resolved.anchor):
        raise OutputError("cannot write a model into the root of the file system", str(out), FOLDER_REMEDY)
    if _is_home(resolved):
        raise OutputError("cannot write a model into the home folder itself", str(out), FOLDER_REMEDY)
    if manifest is not None or not resolved.is_dir():
        return
    if (resolved / ".git").exists():
        raise OutputError("cannot write a model into the root of a repository", str(out), FOLDER_REMEDY)
    existing = [path for path in allowed if path.exists()]
    try:
        other_files = sorted(
            entry.name
            for entry in resolved.iterdir()
            if not entry.name.startswith(".")
            and not (entry.exists() and any(entry.samefile(path) for path in existing))
        )
    except OSError as error:
        raise OutputError(
            f"cannot write: {(error.strerror or str(error)).lower()}",
            str(out),
            "choose another place or make it readable",
        ) from None
    if other_files:
        raise OutputError(
            f"the folder contains other files ({listed(other_files, 1)}) and no manifest of a generated model",
            str(out),
            FOLDER_REMEDY,
        )


def check_owner(out: Path, manifest: Mapping[str, Any], reference: str, name: str) -> None:
    """Reject a folder that holds the model of another robot.

    If the recorded robot file no longer exists and the robot's name is the same, the folder or the file was moved,
    and the folder is accepted.

    Raises OutputError if the folder holds the model of another robot.
    """
    robot = manifest.get("robot") if isinstance(manifest.get("robot"), dict) else {}
    owner = robot.get("file") if robot else None
    if owner == reference:
        return
    if isinstance(owner, str) and robot and robot.get("name") == name and not _is_file(out, owner):
        return
    origin = f"the robot file {owner}" if owner else f"the mechanism {manifest.get('mechanism')}"
    raise OutputError(
        f"the folder already holds the model generated from {origin}",
        str(out),
        "choose another folder, or remove that one",
    )


def check_mechanism(folder: Path, manifest: Mapping[str, Any] | None, name: str) -> None:
    """Reject a folder that holds anything but the code of this mechanism.

    Raises OutputError.
    """
    if manifest is not None and ("robot" in manifest or manifest.get("product") != name):
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
    out: Path, manifest: Mapping[str, Any], names: Iterable[str], is_generated: Callable[[Path], bool]
) -> list[Path]:
    """Return outputs of an earlier generation that are not among the new ones, as after renaming the robot.

    - manifest: the manifest in the folder
    - names: files that are about to be written
    - is_generated: returns whether a file carries the generator's header

    Raises OutputError if one of the new outputs would replace a file that the generator did not write.
    """
    previous = manifest["outputs"]
    for name in names:
        path = out / name
        if name != MANIFEST and name not in previous and path.exists() and not is_generated(path):
            raise OutputError(
                f"{name} would be replaced, but it was not generated",
                str(out),
                "move that file, or choose another folder",
            )
    # Only files directly in this folder, so that a manifest cannot cause the removal of anything elsewhere.
    present = [path for path in out.iterdir() if path.is_file() and not path.is_symlink()]
    return [path for path in present if path.name in previous.keys() - set(names) and is_generated(path)]


@contextmanager
def folder_lock(folder: Path) -> Iterator[None]:
    """Create a folder and lock it against other processes that generate; folders that stay empty are removed again.

    Raises OutputError if the folder cannot be made or written, or another process does not finish.
    """
    from filelock import FileLock, Timeout

    created = [parent for parent in (folder, *folder.parents) if not parent.exists()]
    lock = FileLock(folder / LOCK_FILE, timeout=LOCK_TIMEOUT)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        lock.acquire()
    except Timeout:
        problem = f"another process has been generating into the folder for {LOCK_TIMEOUT} s"
        raise OutputError(problem, str(folder), "end it, or choose another folder") from None
    except OSError as error:
        raise write_error(error, folder) from None
    except NotImplementedError:  # a file system without locks
        pass
    try:
        yield
    finally:
        with suppress(OSError):
            (folder / LOCK_FILE).unlink()
        lock.release()
        for parent in created:
            with suppress(OSError):  # it is in use
                parent.rmdir()


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
