"""``pkmodes generate`` and ``pkmodes check``: what stands alone, and what makes a model not current."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from pkmodes import writing
from pkmodes.checking import products
from pkmodes.checking.consistency import Generated, check_consistency, oblique_robot
from pkmodes.cli import run
from pkmodes_derive.emit import manifest, product
from pkmodes_generated import linear_delta
from robot_text import PUBLISHED, published

MODULE = "linear_delta_2022.py"


@pytest.fixture(scope="module")
def pristine(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A robot file and its generated model, to be copied and spoilt."""
    folder = tmp_path_factory.mktemp("pristine")
    (folder / "robot.toml").write_text(published(), encoding="utf-8")
    assert run(["generate", str(folder / "robot.toml"), "--out", str(folder / "model")]) == 0
    return folder


@pytest.fixture
def copy(pristine: Path, tmp_path: Path) -> Path:
    return Path(shutil.copytree(pristine, tmp_path / "copy"))


def check(folder: Path, capsys: pytest.CaptureFixture[str]) -> tuple[int, str]:
    capsys.readouterr()
    code = run(["check", str(folder / "model")])
    return code, capsys.readouterr().out


def edit(path: Path, old: str, new: str) -> None:
    text = path.read_text(encoding="utf-8")
    assert old in text
    path.write_text(text.replace(old, new, 1), encoding="utf-8")


def test_the_generated_module_stands_alone(pristine: Path) -> None:
    """It is imported by an interpreter that sees NumPy and nothing of this project."""
    code = (
        "import sys, json; sys.path.insert(0, '.'); import linear_delta_2022 as m; "
        "M, K = m.modal_matrices([0.6, 0.03, -0.245]); "
        "print(json.dumps([M.tolist(), K.tolist(), sorted(n for n in sys.modules if n.startswith('pkmodes'))]))"
    )
    environment = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
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


def test_a_fresh_model_is_current(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    code, out = check(copy, capsys)
    assert code == 0
    assert "relations agree with finite differences" in out
    assert "mend" not in out


def test_a_comment_in_the_robot_file_changes_nothing(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    edit(copy / "robot.toml", "format = 1", "# a remark\nformat = 1")
    assert check(copy, capsys)[0] == 0


@pytest.mark.parametrize(
    ("old", "new", "field"),
    [
        ('mass = "1.5 kg"', 'mass = "1.6 kg"', "platform.mass is 1.6, the model was generated with 1.5"),
        ("branch = 1\n", 'branch = 1\n[axis.belt]\nwidth = "20 mm"\n', "axis.1.belt.width is 0.02"),
        ("driven_pulley = 1", "driven_pulley = 2", "axis.1.driven_pulley is 2"),
        ('"-200 mm"', '"-210 mm"', "axis.2.origin.y is -0.21"),
    ],
)
def test_a_changed_robot_file_names_the_field(
    copy: Path, capsys: pytest.CaptureFixture[str], old: str, new: str, field: str
) -> None:
    edit(copy / "robot.toml", old, new)
    code, out = check(copy, capsys)
    assert code == 1
    assert f"the robot file changed: {field}" in out
    assert "(derived now)" in out, "the difference is shown"
    assert f"mend it with: pkmodes generate {copy / 'robot.toml'} --out {copy / 'model'}" in out


def test_the_mending_command_mends(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    edit(copy / "robot.toml", 'mass = "1.5 kg"', 'mass = "1.6 kg"')
    edit(copy / "robot.toml", 'name = "linear-delta-2022"', 'name = "heavier"')
    code, out = check(copy, capsys)
    assert code == 1
    command = out.partition("mend it with: ")[2].split()
    assert run(command[1:]) == 0
    assert check(copy, capsys)[0] == 0
    assert not (copy / "model" / MODULE).exists(), "the module under the former name is gone"


def test_a_hand_edited_output_is_found_and_shown(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    edit(copy / "model" / MODULE, "x_1 = p_x + np.sqrt", "x_1 = p_x - np.sqrt")
    code, out = check(copy, capsys)
    assert code == 1
    assert f"{MODULE} was edited by hand" in out
    assert "-    x_1 = p_x - np.sqrt" in out
    assert "+    x_1 = p_x + np.sqrt" in out


@pytest.mark.parametrize("name", ["linear_delta_2022.c", "linear_delta_2022.h", "manifest.json"])
def test_any_edited_output_is_found(copy: Path, capsys: pytest.CaptureFixture[str], name: str) -> None:
    path = copy / "model" / name
    path.write_text(path.read_text(encoding="utf-8") + "\n", encoding="utf-8")
    code, out = check(copy, capsys)
    assert code == 1
    assert f"{name} was edited by hand" in out


def test_missing_and_orphan_files_are_found(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (copy / "model" / MODULE).rename(copy / "model" / "other.py")
    code, out = check(copy, capsys)
    assert code == 1
    assert f"{MODULE} is missing" in out
    assert "other.py does not belong to this model: an orphan" in out


def test_another_sympy_version_is_found(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = copy / "model" / "manifest.json"
    content = json.loads(path.read_text(encoding="utf-8"))
    content["generator"]["sympy"] = "1.12"
    path.write_text(json.dumps(content), encoding="utf-8")
    code, out = check(copy, capsys)
    assert code == 1
    assert "another SymPy version: generated with 1.12, installed is 1." in out


@pytest.mark.parametrize("source", ["chain.py", "emit/templates/module.py.j2"])
def test_a_changed_derivation_or_template_is_found(
    copy: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, source: str
) -> None:
    digests = {**manifest.source_digests(), source: "0" * 64}
    monkeypatch.setattr(manifest, "source_digests", lambda: digests)
    code, out = check(copy, capsys)
    assert code == 1
    assert f"changed: {source} is not what it was" in out


def test_a_module_that_does_not_run_fails_without_a_traceback(
    copy: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    edit(
        copy / "model" / MODULE,
        "import numpy as np",
        "import numpy as np\nraise SystemExit(7) if 0 else RuntimeError",
    )
    code, out = check(copy, capsys)
    assert code == 1
    assert "RuntimeError" in out


def test_folders_without_a_model_are_refused(
    tmp_path: Path, copy: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["check", str(tmp_path)]) == 2
    assert "found no manifest.json" in capsys.readouterr().err
    (copy / "model" / "manifest.json").write_text("{", encoding="utf-8")
    assert run(["check", str(copy / "model")]) == 2
    assert "the manifest cannot be read: it is not valid JSON" in capsys.readouterr().err
    (copy / "model" / "manifest.json").write_text("[]", encoding="utf-8")
    assert run(["check", str(copy / "model")]) == 2
    (copy / "robot.toml").unlink()


def test_a_lost_robot_file_is_named(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (copy / "robot.toml").unlink()
    assert run(["check", str(copy / "model")]) == 2
    assert (
        "the robot file ../robot.toml that this model was generated from is not there"
        in capsys.readouterr().err
    )


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


def test_a_failure_half_way_leaves_what_was_there(copy: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    before = {path.name: path.read_bytes() for path in (copy / "model").iterdir()}
    edit(copy / "robot.toml", "1.5 kg", "1.6 kg")
    calls = []

    def fail_at_the_third(temporary: str) -> None:
        calls.append(temporary)
        if len(calls) == 3:
            raise OSError(28, "No space left on device")

    monkeypatch.setattr(writing, "_usual_permissions", fail_at_the_third)
    assert run(["generate", str(copy / "robot.toml"), "--out", str(copy / "model")]) == 2
    assert {path.name: path.read_bytes() for path in (copy / "model").iterdir()} == before


def test_json_of_a_check(copy: Path, tmp_path: Path) -> None:
    edit(copy / "robot.toml", "1.5 kg", "1.6 kg")
    out = tmp_path / "check.json"
    assert run(["check", str(copy / "model"), "--json", str(out)]) == 1
    content = json.loads(out.read_text(encoding="utf-8"))
    (target,) = content["targets"]
    assert content["holds"] is False
    assert target["findings"][0]["subject"] == "platform.mass"
    assert target["mend"].startswith("pkmodes generate")
    assert target["consistency"]
    assert all(c["holds"] for c in target["consistency"])


def test_the_committed_model_and_the_robots_hold(capsys: pytest.CaptureFixture[str]) -> None:
    robots = sorted(str(path) for path in PUBLISHED.parent.glob("*.toml"))
    assert run(["check"]) == 0
    assert run(["check", *robots]) == 0
    assert capsys.readouterr().out.count("current\n") == 1 + len(robots)


class Broken:
    """A generated module with one result replaced."""

    def __init__(self, name: str, factor: float) -> None:
        self.name, self.factor = name, factor

    def __getattr__(self, name: str) -> object:
        function = getattr(linear_delta, name)
        if name != self.name:
            return function

        def scaled(*arguments: object) -> object:
            result = function(*arguments)
            return (
                tuple(self.factor * r for r in result) if isinstance(result, tuple) else self.factor * result
            )

        return scaled


NOT_COMPARED = {"reach_margin", "belt_spans", "belt_stiffness", "jacobian_condition"}


@pytest.mark.parametrize(
    "name", sorted({f.name for f in product.derive("linear_delta").functions} - NOT_COMPARED)
)
def test_consistency_finds_one_part_in_a_hundred_thousand(name: str) -> None:
    """Every derived function but the margins: a relative error of 1e-5 in it fails some relation."""
    robot = oblique_robot()
    checks = check_consistency(Generated(Broken(name, 1 + 1e-5), robot), robot.limits, robot.link_length)
    assert not all(one.holds for one in checks)


def test_consistency_needs_a_regular_pose() -> None:
    robot = oblique_robot()
    checks = check_consistency(
        Generated(linear_delta, robot._replace(link_length=np.full(3, 0.01))), robot.limits, robot.link_length
    )
    assert [one.holds for one in checks] == [False]


def test_a_missing_generator_is_named(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(sys.modules, "pkmodes_derive.emit.product", None)
    with pytest.raises(pkmodes.PkmodesError, match="pip install 'pkmodes\\[derive\\]'"):
        products.check_committed()
    assert run(["check"]) == 2
    assert "is not installed" in capsys.readouterr().err
