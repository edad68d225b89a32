"""Replacing files: at any moment each of them is the old one or the new one, whole."""

from __future__ import annotations

import os
import subprocess
import sys
import threading
from pathlib import Path
from typing import Any

import pytest

from pkmodes.core.base.errors import OutputError
from pkmodes.core.support import writing

ROOT = Path(__file__).parents[3]
#: Larger than a page of memory, so that a file written in place would be seen in parts.
OLD, NEW = (letter * 50_000 for letter in "on")
NAMES = ("a.json", "b.json", "c.json")
#: Writes into a folder in a child process that is killed before its n-th call of the system, for n = 1, 2, ... until
#: one ends; prints after each what the files are.
KILLED = """
import os, signal, sys
from pathlib import Path
from pkmodes.core.support import writing

folder, names = Path(sys.argv[1]), sys.argv[2].split(",")
old, new = "o" * 50_000, "n" * 50_000
for number in range(1, 200):
    for name in names:
        (folder / name).write_text(old)
    child = os.fork()
    if child == 0:
        left = [number]
        def count(event, arguments):
            if event.startswith(("os.", "open", "shutil.", "tempfile.")):
                left[0] -= 1
                if left[0] == 0:
                    os.kill(os.getpid(), signal.SIGKILL)
        sys.addaudithook(count)
        writing.write_files(folder, dict.fromkeys(names, new))
        os._exit(0)
    _, status = os.waitpid(child, 0)
    found = [(folder / name).read_text() if (folder / name).exists() else "none" for name in names]
    print("".join({old: "o", new: "n", "none": "-"}.get(text, "?") for text in found), flush=True)
    if status == 0:
        break
"""


@pytest.mark.skipif(not hasattr(os, "fork"), reason="forks")
@pytest.mark.parametrize("count", [1, 3])
def test_a_kill_at_any_step_leaves_every_file_old_or_new(tmp_path: Path, count: int) -> None:
    done = subprocess.run(
        [sys.executable, "-c", KILLED, str(tmp_path), ",".join(NAMES[:count])],
        env={**os.environ, "PYTHONPATH": str(ROOT / "src")},
        capture_output=True,
        text=True,
        check=True,
        timeout=60,
    )
    found = done.stdout.split()
    assert found[0] == "o" * count
    assert found[-1] == "n" * count
    assert len(found) > 3 * count
    assert set("".join(found)) == {"o", "n"}


def test_a_reader_sees_whole_files_while_two_write(tmp_path: Path) -> None:
    path = tmp_path / "result.json"
    writing.write_file(path, OLD)
    errors: list[BaseException] = []

    def write(text: str) -> None:
        try:
            for _ in range(150):
                writing.write_file(path, text)
        except BaseException as error:
            errors.append(error)

    writers = [threading.Thread(target=write, args=(text,)) for text in (OLD, NEW)]
    for writer in writers:
        writer.start()
    seen = set()
    while any(writer.is_alive() for writer in writers):
        seen.add(path.read_text(encoding="utf-8"))
    assert errors == []
    assert seen <= {OLD, NEW}
    assert [entry.name for entry in tmp_path.iterdir()] == [path.name]


@pytest.mark.parametrize("links", [True, False], ids=["hard links", "no hard links"])
@pytest.mark.parametrize("error", [OSError(28, "No space left on device"), KeyboardInterrupt()])
@pytest.mark.parametrize("step", [1, 2, 3])
def test_a_failure_between_steps_restores_all(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, step: int, error: BaseException, links: bool
) -> None:
    """The first file is new, the others replace one with permissions of its own."""
    for name in NAMES[1:]:
        (tmp_path / name).write_text(OLD, encoding="utf-8")
        (tmp_path / name).chmod(0o640)
    replace, calls = Path.replace, []

    def failing(self: Path, target: Any) -> Path:
        calls.append(target)
        if len(calls) == step:
            raise error
        return replace(self, target)

    def forbidden(self: Path, target: Any) -> None:
        raise PermissionError(1, "Operation not permitted", str(self))

    monkeypatch.setattr(Path, "replace", failing)
    if not links:
        monkeypatch.setattr(Path, "hardlink_to", forbidden)
    with pytest.raises(OutputError if isinstance(error, OSError) else KeyboardInterrupt):
        writing.write_files(tmp_path, dict.fromkeys(NAMES, NEW))
    assert {entry.name for entry in tmp_path.iterdir()} == set(NAMES[1:])
    for name in NAMES[1:]:
        assert (tmp_path / name).read_text(encoding="utf-8") == OLD
        assert (tmp_path / name).stat().st_mode & 0o777 == 0o640
        assert (tmp_path / name).stat().st_nlink == 1


def test_an_interrupt_after_the_file_is_in_place_keeps_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "result.json"
    path.write_text(OLD, encoding="utf-8")
    replace = Path.replace

    def interrupted(self: Path, target: Any) -> Path:
        replace(self, target)
        raise KeyboardInterrupt

    monkeypatch.setattr(Path, "replace", interrupted)
    with pytest.raises(KeyboardInterrupt):
        writing.write_file(path, NEW)
    assert path.read_text(encoding="utf-8") == NEW


def test_a_name_of_the_greatest_length_is_written(tmp_path: Path) -> None:
    """The names beside it, of the temporary file and the old one, must not be longer than a file system allows."""
    names = ["\N{SNOWMAN}" * 85, "\N{COMET}" * 84]
    for text in (OLD, NEW):
        writing.write_files(tmp_path, dict.fromkeys(names, text))
    assert sorted(entry.name for entry in tmp_path.iterdir()) == sorted(names)
