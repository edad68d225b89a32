"""Golden outcomes of commands: what each printed and wrote, as text."""

from __future__ import annotations

import contextlib
import io
import re
import shlex
import tomllib
from collections.abc import Mapping
from pathlib import Path

import pytest

from helpers.pages.page_reading import Element, read
from helpers.pages.without_drawing import without_drawing
from helpers.runs.processes import without_progress
from pkmodes.cli import run

ROOT = Path(__file__).parents[3]
GOLDEN = ROOT / "tests" / "golden"
#: What was printed, in the folder of an outcome.
TERMINAL = "terminal.txt"
#: Files that a command writes, which are text; of a page its visible text is kept, as ``.txt``.
KEPT = (".json", ".csv", ".toml")
#: What depends on the clock.
VARIABLE = re.compile(r'(?<="seconds": )[\d.e+-]+')
#: Elements whose text is not seen, and the date.
HIDDEN = {"script", "style", "svg", "template", "time"}
#: Elements that begin a line, and cells of a table.
BLOCKS = {"div", "section", "header", "footer", "figcaption", "caption"}
LINES = {"p", "h1", "h2", "h3", "h4", "tr", "li", "dt", *BLOCKS}
CELLS = {"td", "th", "dd"}


def commands() -> dict[str, str]:
    """Return all commands by ``command/name``."""
    table = tomllib.loads((GOLDEN / "commands.toml").read_text(encoding="utf-8"))
    return {f"{command}/{name}": line for command, some in table.items() for name, line in some.items()}


def outcome(line: str, folder: Path) -> dict[str, str]:
    """Run a command in an empty folder, and return what it printed and wrote, by file name.

    Parameters
    ----------
    line : str
        Arguments, as typed in a shell.
    folder : Path
        The robots, examples and golden outcomes of the repository are linked into it.
    """
    for name, to in (("robots", ROOT / "robots"), ("examples", ROOT / "examples"), ("golden", GOLDEN)):
        (folder / name).symlink_to(to)
    linked = set(folder.iterdir())
    out, errors = io.StringIO(), io.StringIO()
    with pytest.MonkeyPatch.context() as patch, without_drawing():
        patch.chdir(folder)
        patch.setenv("COLUMNS", "110")
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(errors):
            code = run(shlex.split(line))
    printed = without_progress(errors.getvalue())
    said = f"--- errors\n{printed}" if printed else ""
    found = {TERMINAL: f"{out.getvalue()}{said}--- exit code {code}\n"}
    for path in sorted(folder.iterdir()):
        if path in linked or path.is_dir():
            continue
        if path.suffix == ".html":
            found[f"{path.stem}.txt"] = visible(path.read_text(encoding="utf-8"))
        elif path.suffix in KEPT:
            found[path.name] = VARIABLE.sub("0.0", path.read_text(encoding="utf-8"))
    return found


def golden(name: str) -> Mapping[str, str]:
    """Return the golden outcome of a command; empty if there is none."""
    return {path.name: path.read_text(encoding="utf-8") for path in sorted((GOLDEN / name).glob("*.*"))}


def update(name: str, found: Mapping[str, str]) -> None:
    """Make an outcome the golden one."""
    folder = GOLDEN / name
    folder.mkdir(parents=True, exist_ok=True)
    for path in folder.iterdir():
        path.unlink()
    for file, text in found.items():
        (folder / file).write_text(text, encoding="utf-8")


def visible(page: str) -> str:
    """Return the visible text of a page: a line for each paragraph and each row of a table."""
    lines = (" ".join(line.split()) for line in _text(read(page)).splitlines())
    return "\n".join(line for line in lines if line.strip("| ")) + "\n"


def _text(element: Element | str) -> str:
    if isinstance(element, str):
        return element.replace("\n", " ")
    if element.tag in HIDDEN:
        return ""
    inside = "".join(map(_text, element.children))
    if element.tag in LINES:
        return f"\n{inside}\n"
    return f" | {inside}" if element.tag in CELLS else inside
