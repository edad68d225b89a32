"""The commands that the headers of generated files print."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

from helpers.generated.generated_model import MODULE
from helpers.robots.robot_text import published
from pkmodes.cli import run
from pkmodes_derive.emit.provenance import pasteable


@pytest.mark.parametrize("place", ["plain", "it's a folder", 'q"uote', "star*", "-dash", "a*/b", "$HOME`x`"])
def test_the_command_in_the_header_works_where_it_is_printed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], place: str
) -> None:
    folder = tmp_path / place
    folder.mkdir(parents=True)
    (folder / "-my robot.toml").write_text(published(), encoding="utf-8")
    assert run(["generate", str(folder / "-my robot.toml"), "--out", str(tmp_path / "model")]) == 0
    programs = tmp_path / "programs"
    programs.mkdir()
    # The arguments as the shell passes them on.
    (programs / "pkmodes").write_text("#!/bin/sh\nprintf '%s\\0' \"$@\"\n")
    (programs / "pkmodes").chmod(0o755)
    monkeypatch.setenv("PATH", f"{programs}{os.pathsep}{os.environ['PATH']}")
    for name in (MODULE, "linear_delta_2022.c", "linear_delta_2022.h"):
        header = (tmp_path / "model" / name).read_text(encoding="utf-8").split("\n")[2]
        before, _, rest = header.partition("regenerate with `")
        command, _, where = rest.rpartition("`")
        assert before.endswith("Do not edit: ")
        assert where == ", run in this folder."
        assert "*/" not in command
    (tmp_path / "model" / MODULE).unlink()
    done = subprocess.run(
        ["/bin/sh", "-c", command], cwd=tmp_path / "model", capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stderr) == (0, "")
    monkeypatch.chdir(tmp_path / "model")
    capsys.readouterr()
    assert run(done.stdout.split("\0")[:-1]) == 0
    assert capsys.readouterr().err == ""
    assert (tmp_path / "model" / MODULE).exists()


def test_a_robot_file_that_cannot_be_printed_is_not_named_in_the_header() -> None:
    for name in ("two\nlines.toml", "bell\a.toml", "\udcff.toml"):
        assert pasteable(name) == "ROBOT.toml"
