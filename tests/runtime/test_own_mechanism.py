"""The steps of docs/adding-a-mechanism.md: a mechanism outside the repository works with every command."""

from __future__ import annotations

import ctypes
import json
import multiprocessing
import pickle
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from adding_a_mechanism import (
    COMMANDS,
    DECLARED,
    DEFINITION,
    IN_PYTHON,
    MEASURING,
    POSES,
    ROBOT,
    SHOWN,
    measured,
)
from compiled import COMPILER, FLAGS
from documentation import same
from pkmodes import mechanism as known
from pkmodes import mechanism_packages, updating
from pkmodes.cli import run
from pkmodes.errors import PkmodesError

POSE = np.array([0.03, -0.42])


@pytest.fixture(scope="module")
def place(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """A folder with the files of the page, after its first command."""
    folder = tmp_path_factory.mktemp("own")
    (folder / "five_bar.py").write_text(DEFINITION, encoding="utf-8")
    (folder / "robot.toml").write_text(ROBOT, encoding="utf-8")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(known, "_added", {})
        patch.setenv("COLUMNS", "110")
        patch.chdir(folder)
        assert run(COMMANDS[0]) == 0
        exec(MEASURING, {})
        yield folder


@pytest.fixture
def copy(place: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A copy of it that may be changed."""
    shutil.copytree(place, tmp_path, dirs_exist_ok=True)
    monkeypatch.setattr(known, "_added", {})
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.fixture
def model(place: Path) -> pkmodes.Model:
    known.add_folder(place / "build" / "five_bar")
    return pkmodes.load(place / "robot.toml")


def refused(arguments: list[str], capsys: pytest.CaptureFixture[str]) -> str:
    """Return the error of a command that fails."""
    capsys.readouterr()
    assert run(arguments) == 2
    return capsys.readouterr().err


# Statements of the page.


def test_the_definition_is_short() -> None:
    assert len(DEFINITION.splitlines()) < 120


@pytest.mark.slow  # with the fixture
def test_the_commands_print_what_the_page_shows(place: Path, capsys: pytest.CaptureFixture[str]) -> None:
    printed = {}
    for arguments in COMMANDS[1:]:
        capsys.readouterr()
        assert run(arguments) == 0, arguments
        printed[arguments[0]] = capsys.readouterr().out
    same(SHOWN[0], printed["modes"], fit=True)
    same(SHOWN[1], printed["diagnose"][: len(SHOWN[1])], fit=True)
    assert printed["check"].count(": current\n") == 2
    assert "next: pkmodes generate --mechanism build/five_bar corrected.toml --out DIR" in printed["diagnose"]
    assert "payload" in (place / "corrected.toml").read_text(encoding="utf-8")
    exec(IN_PYTHON, {})
    assert capsys.readouterr().out.split() == ["[", "0.627", "0.713", "43.936", "46.103]"]


def test_the_made_up_measurements_are_those_of_the_machine_by_hand(place: Path, tmp_path: Path) -> None:
    (tmp_path / "by_hand.csv").write_text(measured(replace(DECLARED, tool=0.38)), encoding="utf-8")
    found, expected = (updating.read(path) for path in (place / "measured.csv", tmp_path / "by_hand.csv"))
    assert found.channels == expected.channels
    np.testing.assert_allclose(found.frequency, expected.frequency, rtol=1e-4)  # the same noise


def test_matrices_agree_with_positions_and_energies_by_hand(model: pkmodes.Model) -> None:
    other = model.with_values(
        {"axis.2.reducer.stiffness": 640.0, "tool.mass": 0.7, "gravity": [3.0, -8.0, 1.0], "link.mass": 0.4}
    )
    by_hand = replace(
        DECLARED, stiffness=(900.0, 640.0), tool=0.7, gravity=np.array([3.0, -8.0]), link_mass=0.4
    )
    for evaluated, expected in ((model, DECLARED), (other, by_hand)):
        for pose in map(np.array, POSES):
            M, K = expected.matrices(pose)
            found_M, found_K = evaluated.matrices(pose)
            np.testing.assert_allclose(found_M, M, rtol=0.0, atol=1e-9 * np.abs(M).max())
            np.testing.assert_allclose(found_K, K, rtol=0.0, atol=1e-9 * np.abs(K).max())
            np.testing.assert_allclose(evaluated.statics(pose).torques, expected.torques(pose), atol=1e-9)
            np.testing.assert_allclose(evaluated.platform_jacobian(pose), expected.jacobian(pose), atol=1e-9)
            np.testing.assert_allclose(evaluated.frequencies(pose), expected.modes(pose)[0], rtol=1e-7)


def test_sensitivities_agree_with_differences_by_hand(model: pkmodes.Model) -> None:
    names = {
        "tool.mass": "tool",
        "arm.length": "arm_length",
        "link.length": "link_length",
        "motor.inertia": "inertia",
    }
    found = model.sensitivities(POSE, [*names, "effects.payload.mass"]).frequencies
    rates = []
    for name in names.values():
        value, h = getattr(DECLARED, name), 1e-4 * getattr(DECLARED, name)
        up, down = (replace(DECLARED, **{name: value + side * h}).modes(POSE)[0] for side in (1.0, -1.0))
        rates.append((up - down) / (2.0 * h))
    np.testing.assert_allclose(found[:4], rates, rtol=1e-5, atol=1e-5 * np.abs(rates).max())
    np.testing.assert_allclose(found[4], found[0], rtol=1e-9)  # a payload is mass of the tool


@pytest.mark.parametrize(
    "name", ["build/pick_and_place", "build/five_bar/five_bar", "build/five_bar/five_bar_extended"]
)
@pytest.mark.compiler
def test_the_c_files_compile_without_a_warning(place: Path, tmp_path: Path, name: str) -> None:
    library = tmp_path / "code.so"
    subprocess.run([str(COMPILER), *FLAGS, str(place / f"{name}.c"), "-o", str(library), "-lm"], check=True)
    if name == "build/pick_and_place":
        p, M, K = ((ctypes.c_double * n)() for n in (2, 16, 16))
        p[:] = POSE.tolist()
        ctypes.CDLL(str(library)).pick_and_place_modal_matrices(p, M, K)
        wanted = DECLARED.matrices(POSE)
        for given, expected in zip((M, K), wanted, strict=True):
            np.testing.assert_allclose(
                np.reshape(given, (4, 4)), expected, atol=1e-9 * np.abs(expected).max()
            )


def test_a_wrong_value_is_found(place: Path, tmp_path: Path) -> None:
    (tmp_path / "modes.csv").write_text(measured(replace(DECLARED, arm_length=0.23)), encoding="utf-8")
    out = tmp_path / "found.json"
    arguments = [
        "--mechanism",
        "build/five_bar",
        "robot.toml",
        str(tmp_path / "modes.csv"),
        "--json",
        str(out),
    ]
    assert run(["diagnose", *arguments]) == 0
    found = json.loads(out.read_text(encoding="utf-8"))
    assert found["verdict"] == "effect_found"
    (cause,) = found["effects"]
    assert cause["name"] == "parameter:arm.length"
    assert cause["parameters"]["arm.length"]["value"] == pytest.approx(0.23, abs=1e-3)
    assert run(["compare", *arguments]) == 0


# Other processes, other ways to register it.


@pytest.mark.parametrize("method", ["fork", "spawn"])
def test_models_travel_to_other_processes(model: pkmodes.Model, method: str) -> None:
    loaded = model.with_values({"effects.link_compliance.compliance": 1e-6})
    assert pickle.loads(pickle.dumps(loaded)).robot == loaded.robot
    with multiprocessing.get_context(method).Pool(1) as pool:
        found = pool.map(loaded.frequencies, [POSE])
    np.testing.assert_array_equal(found[0], loaded.frequencies(POSE))


def test_a_folder_is_read_again_after_it_changed(copy: Path) -> None:
    first = known.add_folder(copy / "build/five_bar")
    assert known.add_folder(copy / "build/five_bar") is first
    description = copy / "build/five_bar/description.json"
    description.write_text(description.read_text().replace('"title": "two arms', '"title": "both arms'))
    assert known.add_folder(copy / "build/five_bar").title.startswith("both arms")


def test_an_installed_package_is_known_by_its_entry_point(
    copy: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    package = copy / "site" / "my_robots"
    shutil.copytree(copy / "build" / "five_bar", package / "five_bar")
    (package / "__init__.py").write_text("")
    metadata = copy / "site" / "my_robots-1.dist-info"
    metadata.mkdir()
    (metadata / "METADATA").write_text("Metadata-Version: 2.1\nName: my-robots\nVersion: 1\n")
    points = (
        "[pkmodes.mechanisms]\nfive_bar = my_robots.five_bar\ncorexy = my_robots.five_bar\nlost = nowhere\n"
    )
    (metadata / "entry_points.txt").write_text(points)
    monkeypatch.syspath_prepend(str(copy / "site"))
    mechanism_packages.installed.cache_clear()
    try:
        robot = pkmodes.read_robot(copy / "robot.toml")
        assert robot.kind.package == "my_robots.five_bar"
        assert known.mechanism("corexy").package != "my_robots.five_bar"
        assert run(["check", str(copy / "robot.toml")]) == 0
        with pytest.raises(PkmodesError, match=r"cannot read the description .* \(package nowhere\)"):
            known.mechanism("lost")
    finally:
        mechanism_packages.installed.cache_clear()
        for name in [name for name in sys.modules if name.startswith("my_robots")]:
            del sys.modules[name]


# Currency.


def test_a_changed_definition_is_found_and_mended(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    changed = DEFINITION.replace("m_a[j], (base, elbow)", "2 * m_a[j], (base, elbow)")
    assert changed != DEFINITION
    (copy / "five_bar.py").write_text(changed)
    assert run(["check", "build", "build/five_bar"]) == 1
    out = capsys.readouterr().out
    assert out.count("the definition changed: five_bar.py differs from the file this was derived from") == 2
    mend = "pkmodes generate --mechanism five_bar.py robot.toml --out build"
    assert f"fix with: {mend}\n" in out
    assert run(mend.split()[1:]) == 0
    assert run(["check", "--mechanism", "build/five_bar", "build", "build/five_bar"]) == 0


def test_what_was_edited_by_hand_is_found(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for name in ("model.py", "definition.py"):
        file = copy / "build/five_bar" / name
        text = file.read_text()
        file.write_text(text.replace("sqrt(", "sqrt(1.0 * ", 1))
        assert run(["check", "build/five_bar"]) == 1
        assert f"{name} was edited by hand" in capsys.readouterr().out
        file.write_text(text)


def test_a_folder_that_was_handed_on_alone_is_checked(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    moved = shutil.move(copy / "build/five_bar", copy / "elsewhere")
    (copy / "five_bar.py").unlink()
    assert run(["check", "--mechanism", moved]) == 0
    assert 'not checked: whether the definition "../../five_bar.py" has changed' in capsys.readouterr().out
    assert run(["generate", "--mechanism", moved, "robot.toml", "--out", "other"]) == 0
    assert sorted(path.name for path in (copy / "other").iterdir()) == [
        "manifest.json",
        *(f"pick_and_place.{end}" for end in ("c", "h", "py")),
    ]
    assert run(["check", "--mechanism", moved, "other"]) == 0
    known._added.clear()
    assert "--mechanism DIR/<mechanism>" in refused(["check", "build"], capsys)


# Rejected input, with its place.

MISTAKES = {
    "not Python": ("def declare(m):", "def declare(m:", r"not valid Python: .* \(five_bar.py:\d+\)"),
    "it raises": (
        "    m.add_gravity()",
        "    1 / 0",
        r"ZeroDivisionError: division by zero \(five_bar.py:20\)",
    ),
    "it imports what is not there": (
        "import atan2",
        "import atan3",
        r"ImportError: .*atan3.* \(five_bar.py:3\)",
    ),
    "no declare": ("def declare(m)", "def declares(m)", r"there is no function declare\(m\) \(five_bar.py\)"),
    "no title": ("TITLE =", "NAME =", r"TITLE is missing"),
    "directions": ('("x", "y")', '("y", "x")', r"DIRECTIONS is missing or does not list"),
    "declared twice": (
        '"m_a", "mass"',
        '"m_d", "mass"',
        r"symbol 'm_d_1' is declared twice \(five_bar.py:29\)",
    ),
    "taken by an effect": (
        '"m_p", "mass"',
        '"k_S", "mass"',
        r"symbol 'k_S' is declared twice \(five_bar.py, with",
    ),
    "taken by the derivation": (
        'm.each("C"',
        'm.each("G"',
        r"symbol 'G_1' is declared twice \(five_bar.py, during",
    ),
    "braces": ('"m_{{a,{j}}}"', '"m_{a,{j}}"', r"cannot fill in the indices {j} of .* \(five_bar.py:\d+\)"),
    "dimension": (
        '"torsional stiffness", what',
        '"stiffness", what',
        r"unknown dimension 'stiffness' .*use one of mass",
    ),
    "no such function": (
        '"reach_margin", 0',
        '"reach", 0',
        r'there is no function "reach" \(five_bar.py: m.margins, "rea',
    ),
    "nearly a function": ('"reach_margin", 0', '"reach_margins", 0', r'did you mean "reach_margin"\?'),
    "no such result": (
        '"jacobian_condition", 1',
        '"jacobian_condition", 2',
        r"jacobian_condition has no result 2",
    ),
    "names": ('(("1", "2"),)', '(("1",),)', r"the names have shape \(1,\), the result of reach_margin has"),
    "sentence": ("{{missing}}", "{{lacking}}", r'the sentence ".*" cannot be formatted'),
    "no spring": (
        "theta[j]: 1, phi[j]: -1",
        "phi[j]: 1",
        r"the equilibrium is not determined: no spring connects theta_1",
    ),
    "springs on one": ("theta[j]: 1, phi[j]: -1", "theta[j]: 1, phi[0]: -1", r"no spring acts on phi_2"),
    "no way": (
        "        m.follows[phi[j]] = theta[j]\n",
        "",
        r"the motion of phi_1 .* is not declared .*m.follows\[phi_1\]",
    ),
    "no inverse": (
        "        m.inverse[theta[j]] = atan2(s[j], c[j])\n",
        "",
        r"inverse kinematics does not give theta_1",
    ),
    "undefined": ("m.inverse[across[j]] =", "unused =", r"S_1 is used in .* but not defined"),
    "circular": ("= dot(r[j], r[j])", "= along[j]", r"definitions are circular: .*rho2_1"),
    "sample": (
        '"tool_mass": 0.2, ',
        "",
        r"there is no value for tool_mass \(five_bar.py: m.sample\); add one number, in kg",
    ),
    "shape of sample": ("[900, 1100]", "900", r"the value of reducer_stiffness has the wrong shape"),
    "no inertia": (
        "m.rotor(phi[j], 0), 1)], I_m[j]",
        "m.rotor(phi[j], 0), 1)], 0 * I_m[j]",
        r"phi_1 has no inertia",
    ),
    "sample of nothing": (
        '"tool_mass": 0.2',
        '"tool_mass": float("nan")',
        r"the value of tool_mass has the wrong shape, or is not finite",
    ),
    "a word of Python": (
        '"m_p", "mass"',
        '"lambda", "mass"',
        r"symbol 'lambda' is reserved in generated code",
    ),
    "a word of C": ('"m_p", "mass"', '"double", "mass"', r"symbol 'double' is reserved in generated code"),
    "a module": (
        '"m_p", "mass"',
        '"np", "mass"',
        r"symbol 'np' is reserved in generated code .*another name",
    ),
    "the name of M": (
        '"m_p", "mass"',
        '"M", "mass"',
        r"the symbol M has the name of an argument or a result",
    ),
    "a table twice": ('axis.shared("link"', 'axis.shared("arm"', r"the table arm is declared twice"),
    "a table of every robot file": (
        'single("tool"',
        'single("effects"',
        r'"effects" is a key of every robot',
    ),
    "a key with a dot": (
        'quantity("mass", "m_p"',
        'quantity("ma.ss", "m_p"',
        r"cannot be a key of a robot file",
    ),
    "without words": ("    m.add_gravity()", "    raise ValueError", r"error: ValueError \(five_bar.py:20\)"),
    "of several lines": (
        "    m.add_gravity()",
        "    raise ValueError('one\\ntwo')",
        r"error: one two \(five_bar.py:20\)",
    ),
    "without end": (
        "    m.add_gravity()",
        "    def f(): f()\n    f()",
        r"RecursionError: .* \(five_bar.py:20\)",
    ),
    "no exception of the usual kind": (
        "    m.add_gravity()",
        "    raise BaseException('x')",
        r"BaseException: x",
    ),
    "three rotors": (
        "m.drive([(m.rotor(phi[j], 0), 1)]",
        "m.drive([(m.rotor(phi[j], 0), 1)] * 3",
        r"one rotor or on one of a pair, found 3",
    ),
    "exit": ("SIDES = range(2)", "raise SystemExit(0)", r"SystemExit: 0 \(five_bar.py:13\)"),
}


@pytest.mark.parametrize("what", MISTAKES)
def test_a_mistake_is_named_with_its_place(
    what: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    right, wrong, message = MISTAKES[what]
    assert right in DEFINITION
    (tmp_path / "five_bar.py").write_text(DEFINITION.replace(right, wrong))
    (tmp_path / "robot.toml").write_text(ROBOT)
    monkeypatch.chdir(tmp_path)
    error = refused(COMMANDS[0], capsys)
    assert re.search(message, error), error
    assert error.startswith("error: ")
    assert error.count("\n") == 1
    assert not (tmp_path / "build").exists()


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("corexy.py", '"corexy" is already a mechanism of pkmodes'),
        ("Five-bar.py", '"Five-bar" is not a valid name for a mechanism'),
        ("double.py", '"double" is not a valid name for a mechanism'),
        ("five_bar.txt", "expected a Python file"),
        ("missing.py", "cannot read the definition: no such file"),
    ],
)
def test_names_that_cannot_be(
    copy: Path, capsys: pytest.CaptureFixture[str], name: str, message: str
) -> None:
    if name != "missing.py":
        shutil.copy(copy / "five_bar.py", copy / name)
    assert message in refused(["generate", "--mechanism", name, "robot.toml", "--out", "new"], capsys)


def test_nothing_is_written_for_a_wrong_robot(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (copy / "robot.toml").write_text(ROBOT.replace("link", "rod"))
    arguments = ["generate", "--mechanism", "five_bar.py", "robot.toml", "--out", "new"]
    assert 'unknown key "rod"' in refused(arguments, capsys)
    shutil.copy(Path(__file__).parents[2] / "robots/corexy-printer.toml", copy / "robot.toml")
    assert "the robot is a corexy, not a five_bar (robot.toml: mechanism)" in refused(arguments, capsys)
    assert not (copy / "new").exists()


def test_other_files_in_the_place_of_the_mechanism_are_left_alone(
    copy: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (copy / "new" / "five_bar").mkdir(parents=True)
    (copy / "new" / "five_bar" / "notes.txt").write_text("mine")
    arguments = ["generate", "--mechanism", "five_bar.py", "robot.toml", "--out", "new"]
    assert "the folder contains other files (notes.txt)" in refused(arguments, capsys)
    (copy / "new" / "five_bar" / "notes.txt").unlink()
    assert run(arguments) == 0
    shutil.copytree(copy / "build", copy / "third" / "five_bar")
    arguments[-1] = "third"
    assert "the folder holds generated files other than the code" in refused(arguments, capsys)


def test_folders_that_are_none(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    def said(folder: str) -> str:
        return refused(["modes", "--mechanism", folder, "robot.toml", "--pose", "0.03,-0.42"], capsys)

    assert "no such folder (nowhere); give the folder DIR/<mechanism>" in said("nowhere")
    assert "found a file (five_bar.py); give the folder DIR/<mechanism>" in said("five_bar.py")
    assert "give the mechanism folder inside it: build/five_bar" in said("build")
    file = copy / "build/five_bar/extended.py"
    whole = file.read_text()
    file.write_text(whole + "\nraise ValueError('broken')\n")
    assert "the generated code cannot be imported: ValueError: broken" in said("build/five_bar")
    error = refused(["modes", "robot.toml", "--pose", "0.03,-0.42"], capsys)
    assert 'unknown mechanism "five_bar" (robot.toml: mechanism); known: corexy, ' in error
    assert "--mechanism" in error
    file.write_text("")
    assert "AttributeError: module" in said("build/five_bar")
    file.write_text("raise SystemExit(0)\n")
    assert "the generated code cannot be imported: SystemExit: 0" in said("build/five_bar")
    file.write_text(whole)
    description = copy / "build/five_bar/description.json"
    shutil.copytree(copy / "build/five_bar", copy / "taken")
    text = description.read_text().replace('"mechanism": "five_bar"', '"mechanism": "corexy"')
    description.write_text(text)
    assert '"corexy" is a mechanism of pkmodes already' in said("build/five_bar")
