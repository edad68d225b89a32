"""``pkmodes generate`` and ``pkmodes check``: standalone output, and what makes a model out of date."""

from __future__ import annotations

import dataclasses
import json
import os
import re
import runpy
import shlex
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

import numpy as np
import pytest
from scipy.linalg import eigh

import pkmodes
from broken_module import Broken
from pkmodes import writing
from pkmodes.checking import products
from pkmodes.checking.consistency import Check
from pkmodes.cli import run
from pkmodes.derivation import REQUIREMENTS
from pkmodes.generation import specification
from pkmodes.mechanism import mechanism, names
from pkmodes.robot.reading import read_robot
from pkmodes_derive.emit import manifest, product
from robot_text import PUBLISHED, published

MODULE = "linear_delta_2022.py"


def check(folder: Path, capsys: pytest.CaptureFixture[str]) -> tuple[int, str]:
    capsys.readouterr()
    code = run(["check", str(folder / "model")])
    return code, capsys.readouterr().out


def edit(path: Path, old: str, new: str) -> None:
    text = path.read_text(encoding="utf-8")
    assert old in text
    path.write_text(text.replace(old, new, 1), encoding="utf-8")


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
    assert f"fix with: pkmodes generate {copy / 'robot.toml'} --out {copy / 'model'}" in out


def test_the_mending_command_mends(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    edit(copy / "robot.toml", 'mass = "1.5 kg"', 'mass = "1.6 kg"')
    edit(copy / "robot.toml", 'name = "linear-delta-2022"', 'name = "heavier"')
    code, out = check(copy, capsys)
    assert code == 1
    command = out.partition("fix with: ")[2].split()
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
    assert "other.py was generated but does not belong to this model: an orphan" in out


def test_another_sympy_version_is_found(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = copy / "model" / "manifest.json"
    content = json.loads(path.read_text(encoding="utf-8"))
    content["generator"]["sympy"] = "1.12"
    path.write_text(json.dumps(content), encoding="utf-8")
    code, out = check(copy, capsys)
    assert code == 1
    assert "different SymPy version: generated with 1.12, installed is 1." in out


@pytest.mark.parametrize("source", ["chain.py", "emit/numpy/module.py.j2"])
def test_a_changed_derivation_or_template_is_found(
    copy: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, source: str
) -> None:
    digests = {**manifest.source_digests(), source: "0" * 64}
    monkeypatch.setattr(manifest, "source_digests", lambda: digests)
    code, out = check(copy, capsys)
    assert code == 1
    assert f"changed: {source} is modified" in out


@pytest.mark.parametrize("line", ["import sys; sys.exit(0)", "raise RuntimeError", "print('hi')", "x ="])
def test_an_edited_module_is_found_and_not_executed(
    copy: Path, capsys: pytest.CaptureFixture[str], line: str
) -> None:
    edit(copy / "model" / MODULE, "import numpy as np", f"import numpy as np\n{line}")
    code, out = check(copy, capsys)
    assert code == 1
    assert f"{MODULE} was edited by hand" in out
    assert f"-{line}" in out
    assert "hi\n" not in out.replace("print('hi')", "")


def test_other_line_endings_are_named(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = copy / "model" / MODULE
    path.write_bytes(path.read_bytes().replace(b"\n", b"\r\n"))
    code, out = check(copy, capsys)
    assert code == 1
    assert "has different line endings than generated" in out


def test_a_changed_name_is_found(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    edit(copy / "robot.toml", 'name = "linear-delta-2022"', 'name = "Linear-Delta-2022"')
    code, out = check(copy, capsys)
    assert code == 1
    assert 'the robot file changed: name is "Linear-Delta-2022"' in out


def test_the_mending_commands_can_be_pasted(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = tmp_path / "it's a folder"
    folder.mkdir()
    (folder / "my robot.toml").write_text(published(), encoding="utf-8")
    assert run(["generate", str(folder / "my robot.toml"), "--out", str(folder / "my model")]) == 0
    edit(folder / "my robot.toml", "1.5 kg", "1.6 kg")
    shutil.copy(folder / "my model" / MODULE, folder / "my model" / "a copy.py")
    assert run(["check", str(folder / "my model")]) == 1
    commands = capsys.readouterr().out.rpartition("fix with: ")[2].strip().split(" && ")
    remove, generate = (shlex.split(command) for command in commands)
    assert remove == ["rm", str(folder / "my model" / "a copy.py")]
    Path(remove[1]).unlink()
    assert run(generate[1:]) == 0
    assert run(["check", str(folder / "my model")]) == 0


def test_a_file_that_was_not_generated_is_not_overwritten(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / MODULE).write_text("mine", encoding="utf-8")
    assert run(["generate", str(PUBLISHED), "--out", str(tmp_path)]) == 2
    assert "no manifest of a generated model" in capsys.readouterr().err
    assert (tmp_path / MODULE).read_text(encoding="utf-8") == "mine"


@pytest.mark.parametrize("reference", [7, None, "a\0b", "x" * 5000, "\ud800", "/", ""])
def test_a_tampered_manifest_is_refused(
    copy: Path, capsys: pytest.CaptureFixture[str], reference: object
) -> None:
    path = copy / "model" / "manifest.json"
    content = json.loads(path.read_text(encoding="utf-8"))
    content["robot"]["file"] = reference
    path.write_text(json.dumps(content), encoding="utf-8")
    assert run(["check", str(copy / "model")]) == 2
    assert capsys.readouterr().err.startswith("error: the ")


def test_names_and_paths_cannot_become_code(tmp_path: Path) -> None:
    """The schema rejects such names; the code generator does not rely on that."""
    robot = read_robot(PUBLISHED)
    nasty = 'a"""; raise SystemExit; """*/ int x; /* \\N{foo}\n\x00'
    texts = product.specialised(specification(dataclasses.replace(robot, name=nasty), f"{nasty}.toml"))
    module = next(text for name, text in texts.items() if name.endswith(".py"))
    compile(module, "module", "exec")
    header = next(text for name, text in texts.items() if name.endswith(".h"))
    assert "int x" not in re.sub(r"/\*.*?\*/", "", header, flags=re.DOTALL)


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
    assert capsys.readouterr().out.count("current\n") == len(names()) + len(robots)


def test_long_rails_and_short_links_are_no_false_alarm(tmp_path: Path) -> None:
    text = (
        published().replace('"400 mm"', '"250 mm"').replace('200 mm"', '100 mm"').replace('"1.2 m"', '"6 m"')
    )
    (tmp_path / "robot.toml").write_text(text, encoding="utf-8")
    assert run(["check", str(tmp_path / "robot.toml")]) == 0


@pytest.mark.parametrize("target", [[], ["robot.toml"], ["model"]])
def test_current_but_inconsistent_code_fails(
    copy: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], target: list[str]
) -> None:
    failed = [Check("gravity Hessian", 0.5, 1e-10)]
    monkeypatch.setattr(products, "check_consistency", lambda *_: failed)
    assert run(["check", *(str(copy / name) for name in target)]) == 1
    out = capsys.readouterr().out
    assert "gravity Hessian: relative error 5.0e-01, expected at most 1e-10" in out
    assert "mend" not in out, "generating again would not help"


def test_a_specialised_model_that_differs_from_the_parametric_one_fails(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    kind = mechanism("linear_delta")
    monkeypatch.setitem(vars(kind), "model", Broken("modal_matrices", 1 + 1e-9))
    assert run(["check", str(PUBLISHED)]) == 1
    assert "M of the parametric model: relative error 1.0e-09" in capsys.readouterr().out


CLAMP = '\n[effects.clamp_compliance]\ncompliance = "1e-7 m/N"\n'


def test_a_model_with_a_massless_clamp_has_an_eigenproblem(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The steps of a new user: generate, import, solve with SciPy."""
    (tmp_path / "robot.toml").write_text(published() + CLAMP, encoding="utf-8")
    assert run(["generate", str(tmp_path / "robot.toml"), "--out", str(tmp_path / "model")]) == 0
    assert run(["check", str(tmp_path / "model")]) == 0
    assert "relations agree with finite differences" in capsys.readouterr().out
    module = runpy.run_path(str(tmp_path / "model" / MODULE))
    assert module["__doc__"].count("Coordinates without inertia: eps_1, eps_2, eps_3.") == 1
    assert "Coordinates without inertia: eps_1" in (tmp_path / "model" / "linear_delta_2022.h").read_text(
        encoding="utf-8"
    )
    pose = [0.6, 0.03, -0.245]
    M, K = module["modal_matrices"](pose)
    assert M.shape == (len(module["COORDINATES"]),) * 2
    expected = pkmodes.load(tmp_path / "robot.toml").modes(pose).frequencies[3:]
    np.testing.assert_allclose(np.sqrt(eigh(K, M, eigvals_only=True)[3:]) / (2 * np.pi), expected, rtol=1e-10)
    every = module["condensation"](pose)
    uncondensed_M, uncondensed_K = module["uncondensed_matrices"](pose)
    assert not uncondensed_M[9:].any()
    np.testing.assert_allclose(every.T @ uncondensed_K @ every, K, rtol=0, atol=1e-12 * K.max())


@pytest.mark.parametrize(
    ("broken", "check"),
    [
        ("modal_matrices", "K of the parametric model"),
        ("uncondensed_matrices", "uncondensed K of the parametric model"),
        ("condensation", "condensation of the parametric model"),
        ("platform_motion", "platform motion of the parametric model"),
        ("elastic_gradient", "elastic gradient (complex step)"),
        ("velocity_forces", "velocity forces (complex step)"),
        ("belt_spans", "belt spans (complex step)"),
    ],
)
def test_a_wrong_function_of_a_model_with_effects_is_found(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    broken: str,
    check: str,
) -> None:
    (tmp_path / "robot.toml").write_text(published() + CLAMP, encoding="utf-8")
    executed = products._executed

    def spoilt(texts: dict[str, str]) -> object:
        module = executed(texts)
        if not hasattr(module, broken):  # the module without effects
            return module
        right = getattr(module, broken)

        def wrong(*arguments: object) -> object:
            found = right(*arguments)
            return tuple(1.001 * a for a in found) if isinstance(found, tuple) else 1.001 * found

        setattr(module, broken, wrong)
        return module

    monkeypatch.setattr(products, "_executed", spoilt)
    assert run(["check", str(tmp_path / "robot.toml")]) == 1
    assert check in capsys.readouterr().out


def test_a_missing_generator_is_named(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(sys.modules, "pkmodes_derive.emit.product", None)
    with pytest.raises(pkmodes.PkmodesError, match=r"pip install 'jinja2>=3\.1' sympy==1\.14\.0"):
        products.check_committed("linear_delta")
    with (PUBLISHED.parents[1] / "pyproject.toml").open("rb") as file:
        declared = tomllib.load(file)["project"]["optional-dependencies"]["derive"]
    assert list(REQUIREMENTS) == declared
    assert run(["check"]) == 2
    assert "is not installed" in capsys.readouterr().err
