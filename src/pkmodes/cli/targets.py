"""The files that a command writes: checked before anything is computed, and refused if they must not be written."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from pkmodes.core.base.errors import OutputError, shown
from pkmodes.core.support.pasting import shell_path
from pkmodes.core.support.places import resolve_path


@dataclass(frozen=True)
class Target:
    """A file that a command writes.

    - option: the option that names it
    - path: as given; None if it is not requested
    - label: what it will be, such as "the report"
    - endings: allowed endings of its name; empty for any
    - checked_when_written: whether it may be a folder, or lie in one that does not exist yet; it is then checked when
      it is written
    """

    option: str
    path: str | Path | None
    label: str
    endings: tuple[str, ...] = ()
    checked_when_written: bool = False


def report_target(file: Path | None) -> Target:
    """Return the target of ``--report``."""
    return Target("--report", file, "the report", (".html",))


def check_targets(json_file: str | None, inputs: Sequence[Path | None], *other_targets: Target) -> None:
    """Check the target of ``--json`` and those of other options.

    - inputs: files that the command reads; None for an option that is not given

    Raises OutputError if one of them cannot be written, is an input, is the same file as another, or has a wrong
    ending.
    """
    json_target = Target("--json", None if json_file == "-" else json_file, "the result")
    labels_by_path: dict[Path, str] = {}
    for targets in ([json_target], other_targets):  # of several mistakes, that of --json is reported first
        for target in targets:
            if target.path is not None and not target.checked_when_written:
                _check_place("" if target.path == Path() else str(target.path), target.option)
        for target in targets:
            if target.path is None:
                continue
            path = Path(str(target.path))
            resolved_path = resolve_path(path, target.option)
            where = f"{target.option} {target.path if target.option == '--json' else path}"
            if resolved_path in labels_by_path:
                problem = f"{labels_by_path[resolved_path]} and {target.label} would be the same file"
                raise OutputError(problem, where, "choose another file")
            existing_inputs = (source for source in inputs if source and source.exists() and path.exists())
            if any(source.samefile(path) for source in existing_inputs):
                raise OutputError(f"{target.label} would replace its own input", where, "choose another file")
            labels_by_path[resolved_path] = target.label
    for target in other_targets:
        if target.path is None or not target.endings:
            continue
        path = Path(target.path)
        is_not_regular_file = path.exists() and not path.is_file()  # a pipe or a device may have any name
        alternative_endings = (".htm",) if ".html" in target.endings else ()
        if not is_not_regular_file and path.suffix.lower() not in (*alternative_endings, *target.endings):
            problem = f"expected a name that ends in {' or '.join(target.endings)}, found {shown(path.name)}"
            shown_name = target.path if isinstance(target.path, Path) else shown(target.path)
            remedy = f"write {shell_path(path.with_suffix(target.endings[0]))}"
            raise OutputError(problem, f"{target.option} {shown_name}", remedy)


def _check_place(file: str, option: str) -> None:
    """Reject a target that is not a file in an existing folder."""
    where, path = f"{option} {shown(file)}", Path(file)
    if not file or "\0" in file or file == "-":
        raise OutputError("expected the name of a file", where, "give the name of a file")
    if path.is_dir():
        raise OutputError("expected a file, found a folder", where, "name a file in it")
    if not path.parent.exists():
        raise OutputError(
            f"the folder {path.parent} does not exist", where, "create it, or choose another place"
        )
    if not path.parent.is_dir():
        raise OutputError(f"{path.parent} is not a folder", where, "choose another place")
