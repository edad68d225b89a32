"""The steps of docs/how-to/adding-a-mechanism.md: a mechanism outside the repository works with every command."""

from __future__ import annotations

import ctypes
import json
import re
import subprocess
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.commands.adding_a_mechanism import (
    COMMANDS,
    DECLARED,
    DEFINITION,
    IN_PYTHON,
    PAGE,
    POSE,
    POSES,
    SHOWN,
    measured,
)
from helpers.generated.compiled import COMPILER, FLAGS
from helpers.pages.documentation import same
from pkmodes import updating
from pkmodes.cli import run
from pkmodes_description import UNITS


def test_the_definition_is_short() -> None:
    assert len(DEFINITION.splitlines()) < 120


@pytest.mark.slow  # with the fixture
def test_the_commands_print_what_the_page_shows(place: Path, capsys: pytest.CaptureFixture[str]) -> None:
    printed = {}
    for arguments in COMMANDS[1:]:
        capsys.readouterr()
        assert run(arguments) == 0, arguments
        printed[arguments[0]] = capsys.readouterr().out
    same(SHOWN[0], printed["modes"], fit=True, shortened=True)
    same(SHOWN[1], printed["diagnose"], fit=True, shortened=True)
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


def test_the_page_lists_every_dimension_that_a_quantity_may_have() -> None:
    listed = re.search(r"Its dimension is one of (.*?)\.", " ".join(PAGE.split()))
    assert listed is not None
    assert re.findall(r"`(.*?)`", listed[1]) == list(UNITS)
