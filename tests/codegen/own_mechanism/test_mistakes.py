"""Definitions and robots with mistakes are refused: each is named with its place, and nothing is written."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest

from helpers.commands.adding_a_mechanism import COMMANDS, DEFINITION, ROBOT
from helpers.commands.answers import answer, refused

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
        '"rigidity", what',
        r"unknown dimension 'rigidity' .*use one of mass",
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
    "in a plane": (
        "PointMass(m_p, m.platform)",
        "PointMass(m_p, m.platform[:2])",
        r"a position has 2 components, expected 3 .*m.points\); write 0 for each missing one",
    ),
    "rods in a plane": ("(base, elbow)", "(base[:2], elbow[:2])", r"a position has 2 components, .*m.rods"),
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
    what: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    right, wrong, message = MISTAKES[what]
    assert right in DEFINITION
    (tmp_path / "five_bar.py").write_text(DEFINITION.replace(right, wrong))
    (tmp_path / "robot.toml").write_text(ROBOT)
    monkeypatch.chdir(tmp_path)
    assert re.search(message, error := refused(*COMMANDS[0])), error
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
def test_names_that_cannot_be(copy: Path, name: str, message: str) -> None:
    if name != "missing.py":
        shutil.copy(copy / "five_bar.py", copy / name)
    assert message in refused("generate", "--mechanism", name, "robot.toml", "--out", "new")


def test_nothing_is_written_for_a_wrong_robot(copy: Path) -> None:
    (copy / "robot.toml").write_text(ROBOT.replace("link", "rod"))
    arguments = ["generate", "--mechanism", "five_bar.py", "robot.toml", "--out", "new"]
    code, out, err = answer(*arguments)
    assert (code, out) == (2, "")
    assert 'unknown key "rod"' in err
    shutil.copy(Path(__file__).parents[3] / "robots/corexy-printer.toml", copy / "robot.toml")
    assert "the robot is a corexy, not a five_bar (robot.toml: mechanism)" in refused(*arguments)
    assert not (copy / "new").exists()
