"""``pkmodes generate``: standalone output, and files that are written whole or not at all."""

from __future__ import annotations

import dataclasses
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.generated.generated_model import edit
from helpers.robots.robot_text import PUBLISHED, published
from pkmodes.cli import run
from pkmodes.codegen.generation import specification
from pkmodes.core.robot.reading import read_robot
from pkmodes.core.support import writing
from pkmodes_derive.emit import product


def test_the_generated_module_stands_alone(pristine: Path) -> None:
    """It is imported by an interpreter that has NumPy but not this project."""
    code = (
        "import sys, json; sys.path.insert(0, '.'); import linear_delta_2022 as m; "
        "M, K = m.modal_matrices([0.6, 0.03, -0.245]); "
        "print(json.dumps([M.tolist(), K.tolist(), sorted(n for n in sys.modules if n.startswith('pkmodes'))]))"
    )
    environment = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
    environment["PYTHONDONTWRITEBYTECODE"] = "1"  # the folder is copied by other tests
    run_ = subprocess.run(
        [sys.executable, "-c", code], cwd=pristine / "model", env=environment, capture_output=True, check=True
    )
    M, K, foreign = json.loads(run_.stdout)
    assert foreign == []
    expected = pkmodes.load(PUBLISHED).modes([0.6, 0.03, -0.245])
    np.testing.assert_allclose(M, expected.mass_matrix, rtol=1e-12, atol=1e-14)
    np.testing.assert_allclose(K, expected.stiffness_matrix, rtol=1e-12, atol=1e-9)


def test_generating_again_gives_the_same_bytes(pristine: Path, copy: Path) -> None:
    before = {path.name: path.read_bytes() for path in (copy / "model").iterdir()}
    assert run(["generate", str(copy / "robot.toml"), "--out", str(copy / "model")]) == 0
    assert {path.name: path.read_bytes() for path in (copy / "model").iterdir()} == before


def test_names_and_paths_cannot_become_code(tmp_path: Path) -> None:
    """The schema rejects such names; the code generator does not rely on that."""
    robot = read_robot(PUBLISHED)
    nasty = 'a"""; raise SystemExit; """*/ int x; /* \\N{foo}\n\x00'
    texts = product.specialised(specification(dataclasses.replace(robot, name=nasty), f"{nasty}.toml"))
    module = next(text for name, text in texts.items() if name.endswith(".py"))
    compile(module, "module", "exec")
    header = next(text for name, text in texts.items() if name.endswith(".h"))
    assert "int x" not in re.sub(r"/\*.*?\*/", "", header, flags=re.DOTALL)


def test_a_folder_of_another_robot_is_not_overwritten(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    shutil.copy(copy / "robot.toml", copy / "second.toml")
    before = {path.name: path.read_bytes() for path in (copy / "model").iterdir()}
    assert run(["generate", str(copy / "second.toml"), "--out", str(copy / "model")]) == 2
    assert "already holds the model generated from the robot file ../robot.toml" in capsys.readouterr().err
    assert {path.name: path.read_bytes() for path in (copy / "model").iterdir()} == before


def test_a_wrong_robot_file_writes_nothing(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "robot.toml").write_text(published().replace("1.5 kg", "-1.5 kg"), encoding="utf-8")
    assert run(["generate", str(tmp_path / "robot.toml"), "--out", str(tmp_path / "model")]) == 2
    assert not (tmp_path / "model").exists()


@pytest.mark.parametrize("error", [OSError(28, "No space left on device"), KeyboardInterrupt()])
@pytest.mark.parametrize("method", ["replace", "chmod"])
def test_a_failure_half_way_leaves_what_was_there(
    copy: Path, monkeypatch: pytest.MonkeyPatch, method: str, error: BaseException
) -> None:
    before = {path.name: path.read_bytes() for path in (copy / "model").iterdir()}
    edit(copy / "robot.toml", "1.5 kg", "1.6 kg")
    original, calls = getattr(Path, method), []

    def fail_at_the_third(self: Path, *arguments: object) -> object:
        calls.append(self)
        if len(calls) == 3:
            raise error
        return original(self, *arguments)

    monkeypatch.setattr(Path, method, fail_at_the_third)
    assert run(["generate", str(copy / "robot.toml"), "--out", str(copy / "model")]) in (2, 130)
    monkeypatch.undo()
    assert len(calls) >= 3
    assert {path.name: path.read_bytes() for path in (copy / "model").iterdir()} == before


def test_links_pipes_and_permissions_of_a_target_are_kept(tmp_path: Path) -> None:
    target, link, private = tmp_path / "target.json", tmp_path / "link.json", tmp_path / "private.json"
    target.write_text("", encoding="utf-8")
    link.symlink_to(target)
    private.write_text("", encoding="utf-8")
    private.chmod(0o600)
    for path in (link, private, Path(os.devnull)):
        writing.write_file(path, "text")
    assert link.is_symlink()
    assert target.read_text(encoding="utf-8") == "text"
    assert private.stat().st_mode & 0o777 == 0o600
    assert not Path(os.devnull).is_file()


def test_a_result_does_not_replace_its_input(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    robot = tmp_path / "robot.toml"
    robot.write_text(published(), encoding="utf-8")
    for command in (["modes", str(robot), "--pose", "0.6,0,-0.245"], ["check", str(robot)]):
        assert run([*command, "--json", str(robot)]) == 2
        assert "would replace its own input" in capsys.readouterr().err
    assert robot.read_text(encoding="utf-8") == published()
