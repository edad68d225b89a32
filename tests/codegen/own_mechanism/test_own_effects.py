"""Effects of one's own on a mechanism of one's own: a mass and a resonator at the tool of the five-bar."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.commands.adding_a_mechanism import DECLARED, DEFINITION, POSE, ROBOT
from helpers.commands.answers import refused
from helpers.commands.own_folder import inside
from pkmodes.cli import run
from pkmodes.core.mechanism import registry as known

SWING = """\
from pkmodes_derive.terms import resonator

EFFECT = resonator("platform", along="x", name="ringing_tool")
"""
HEAVY = """\
from pkmodes_derive.terms import mass

EFFECT = mass("platform", name="extra")
"""
#: Of what swings.
MASS, FREQUENCY = 0.05, 11.0


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The five-bar with both effects."""
    folder = tmp_path_factory.mktemp("own_effects")
    for name, text in (("five_bar.py", DEFINITION), ("swing.py", SWING), ("heavy.py", HEAVY)):
        (folder / name).write_text(text, encoding="utf-8")
    (folder / "robot.toml").write_text(ROBOT, encoding="utf-8")
    with inside(folder):
        assert (
            run(["generate", "robot.toml", "--out", "both", *options("five_bar.py", "swing.py", "heavy.py")])
            == 0
        )
    return folder


def options(mechanism: str, *effects: str) -> list[str]:
    """What a command is told."""
    return ["--mechanism", mechanism, *(word for effect in effects for word in ("--effect", effect))]


def model(folder: Path, effects: str = "") -> pkmodes.Model:
    """The robot with values of its effects."""
    file = folder / "with_effects.toml"
    file.write_text(ROBOT + effects, encoding="utf-8")
    known.add_folder(folder / "both" / "five_bar")
    return pkmodes.load(file)


def table(name: str, **values: str) -> str:
    return f"\n[effects.{name}]\n" + "".join(f'{key} = "{value}"\n' for key, value in values.items())


@pytest.mark.slow
def test_a_resonator_is_the_one_by_hand(folder: Path) -> None:
    with inside(folder):
        swings = model(folder, table("ringing_tool", mass=f"{MASS} kg", frequency=f"{FREQUENCY} Hz"))
        M, K = swings.matrices(POSE)
    plain_M, _ = DECLARED.matrices(POSE)
    _, hanging_K = replace(DECLARED, tool=DECLARED.tool + MASS).matrices(POSE)  # its weight hangs on the tool
    J = DECLARED.jacobian(POSE)
    by_hand_M, by_hand_K = np.zeros((5, 5)), np.zeros((5, 5))
    by_hand_M[:4, :4], by_hand_K[:4, :4] = plain_M, hanging_K
    by_hand_M[:2, :2] += MASS * J.T @ J
    by_hand_M[4, :2] = by_hand_M[:2, 4] = MASS * J[0]
    by_hand_M[4, 4] = MASS
    by_hand_K[4, 4] = MASS * (2.0 * np.pi * FREQUENCY) ** 2
    np.testing.assert_allclose(M, by_hand_M, rtol=0.0, atol=1e-9 * np.abs(by_hand_M).max())
    np.testing.assert_allclose(K, by_hand_K, rtol=0.0, atol=1e-9 * np.abs(by_hand_K).max())


@pytest.mark.slow
def test_effects_that_are_null_change_nothing(folder: Path) -> None:
    null = table("ringing_tool", mass="0 kg", frequency="11 Hz") + table("extra", mass="0 kg")
    with inside(folder):
        for effects in ("", null):
            np.testing.assert_allclose(
                model(folder, effects).frequencies(POSE), DECLARED.modes(POSE)[0], rtol=1e-7
            )
        heavy = model(folder, table("extra", mass="0.4 kg")).frequencies(POSE)
    np.testing.assert_allclose(heavy, replace(DECLARED, tool=0.7).modes(POSE)[0], rtol=1e-7)


@pytest.mark.slow
def test_a_resonator_without_a_frequency_is_refused(folder: Path) -> None:
    with inside(folder):
        (folder / "limp.toml").write_text(ROBOT + table("ringing_tool", mass="0.05 kg"), encoding="utf-8")
        error = refused("modes", "limp.toml", "--mechanism", "both/five_bar", "--pose", "0.03,-0.42")
    assert "limp.toml: effects.ringing_tool.frequency" in error
    assert "expected the natural frequency of the resonator above 0, found 0 Hz" in error
    assert "declare frequency, such as 50 Hz" in error


@pytest.mark.slow
def test_the_order_of_the_effects_does_not_matter(folder: Path) -> None:
    with inside(folder):
        assert (
            run(
                [
                    "generate",
                    "robot.toml",
                    "--out",
                    "swapped",
                    *options("five_bar.py", "heavy.py", "swing.py"),
                ]
            )
            == 0
        )
        for name in ("both", "swapped"):
            assert run(["check", f"{name}/five_bar", name]) == 0
        texts = [
            {
                file.name: file.read_text(encoding="utf-8")
                for file in (folder / name / "five_bar").glob("*.py")
            }
            for name in ("both", "swapped")
        ]
    assert texts[0] == texts[1]


@pytest.mark.slow
def test_a_folder_keeps_its_effects_and_forgets_those_no_longer_given(folder: Path) -> None:
    for mechanism, effect, kept in (
        ("five_bar.py", "heavy.py", ["extra"]),
        ("grown/five_bar", "swing.py", ["extra", "ringing_tool"]),
        ("five_bar.py", "swing.py", ["ringing_tool"]),
    ):
        with inside(folder):
            assert run(["generate", "robot.toml", "--out", "grown", *options(mechanism, effect)]) == 0
            assert run(["check", "grown/five_bar", "grown"]) == 0
            manifest = json.loads((folder / "grown/five_bar/manifest.json").read_text(encoding="utf-8"))
        assert sorted(manifest["effects"].values()) == [f"effect_{name}.py" for name in kept]
        description = json.loads((folder / "grown/five_bar/description.json").read_text(encoding="utf-8"))
        names = {effect["name"] for effect in description["effects"]}
        assert sorted(names & {"extra", "ringing_tool"}) == kept


@pytest.mark.slow
def test_an_effect_that_is_not_there_is_named(folder: Path) -> None:
    with inside(folder):
        error = refused("generate", "robot.toml", "--out", "never", *options("five_bar.py", "none.py"))
    assert "none.py" in error
    assert "effect" in error
    assert not (folder / "never").exists()
