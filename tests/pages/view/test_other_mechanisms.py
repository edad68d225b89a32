"""Drawings of mechanisms that do not come with pkmodes: written by hand, declared by a user, or not declared."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.commands.adding_a_mechanism import BLOCKS, DEFINITION, ROBOT
from pkmodes.codegen.checking.consistency import check_drawing
from pkmodes.codegen.derivation import Definition, derive_mechanism, register_definition, staged_mechanism
from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.mechanism import registry as known
from pkmodes.core.mechanism.regular import sample_parameters
from pkmodes.core.robot.robot import Robot
from pkmodes.pages.view import page, poses_around, scene, typical_pose

PAIR = known._load("planar_pair")
POSE = [0.03, -0.42]
#: What docs/how-to/adding-a-mechanism.md adds to draw the five-bar.
DECLARED = textwrap.indent(next(text for _, text in BLOCKS if "m.draw.wheel" in text), "    ")


@pytest.fixture(autouse=True)
def _known_here_only(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(known, "_package_by_name", {})


def test_a_mechanism_written_by_hand_is_shown() -> None:
    known.add("planar_pair")
    effects = {"clamp_compliance.compliance": 2e-5, "cable_stiffness.stiffness": 3e3}
    robot = Robot("pair", PAIR.name, "pair.toml", sample_parameters(PAIR), {}, effects)
    model = pkmodes.Model(robot)
    shown = scene(model, [0.1, 0.05])
    assert [spring.name for spring in shown.springs] == [
        *("belt 1", "belt 2", "cable along x", "cable along y"),
        *("clamp 1", "clamp 2"),
    ]
    modes = model.modes([0.1, 0.05])
    total = 0.5 * np.einsum("mn,nk,mk->m", modes.shapes, modes.stiffness_matrix, modes.shapes)
    np.testing.assert_allclose(shown.energies[0].sum(axis=-1), total, rtol=1e-9)
    # Clamp and belt are in series: they share the energy as their compliances.
    belts = 1.0 / PAIR.model.belts(np.array([0.1, 0.05]), robot.parameters)
    np.testing.assert_allclose(shown.energies[0][:, 4:] * belts, shown.energies[0][:, :2] * 2e-5, rtol=1e-8)
    assert "belt 1 [%]" in page(shown)


def test_the_checks_see_a_wrong_motion_and_a_wrong_spring(monkeypatch: pytest.MonkeyPatch) -> None:
    known.add("planar_pair")
    assert all(check.holds for check in check_drawing(PAIR, sample_parameters(PAIR)))
    assert {check.name.split(" (")[0] for check in check_drawing(PAIR, sample_parameters(PAIR))} == {
        *("motion of drawn points", "springs")
    }
    right = PAIR.drawn.drawing_motion
    monkeypatch.setattr(
        PAIR.drawn, "drawing_motion", lambda p, parameters: right(p, parameters)[..., ::-1, :, :]
    )
    failed = {
        check.name.split(" (")[0] for check in check_drawing(PAIR, sample_parameters(PAIR)) if not check.holds
    }
    assert failed == {"motion of drawn points"}
    monkeypatch.undo()
    springs = PAIR.drawn.springs
    monkeypatch.setattr(PAIR.drawn, "springs", lambda *given: (2.0 * springs(*given)[0], springs(*given)[1]))
    failed = {
        check.name.split(" (")[0] for check in check_drawing(PAIR, sample_parameters(PAIR)) if not check.holds
    }
    assert failed == {"springs"}


def five_bar(definition: str, tmp_path: Path) -> Iterator[pkmodes.Model]:
    file = tmp_path / "five_bar.py"
    file.write_text(definition, encoding="utf-8")
    (tmp_path / "robot.toml").write_text(ROBOT, encoding="utf-8")
    with staged_mechanism(
        "five_bar", derive_mechanism("five_bar", Definition("five_bar", definition, file), "five_bar.py")
    ):
        yield pkmodes.load(tmp_path / "robot.toml")


def test_a_mechanism_without_a_drawing_is_drawn_from_its_parts(tmp_path: Path) -> None:
    for model in five_bar(DEFINITION, tmp_path):
        shown = scene(model, POSE)
        assert [(e.shape, e.kind, e.name) for e in shown.elements] == [
            ("line", "link", "arm 1"),
            ("line", "link", "link 1"),
            ("line", "link", "arm 2"),
            ("line", "link", "link 2"),
            ("ball", "platform", "tool"),
        ]
        arms = [np.diff(shown.points[0, list(e.points)], axis=0) for e in shown.elements[:4]]
        np.testing.assert_allclose(np.linalg.norm(arms, axis=-1).ravel(), [0.22, 0.33, 0.22, 0.33])
        assert [spring.name for spring in shown.springs] == ["reducer 1", "reducer 2"]
        np.testing.assert_allclose(shown.shares[0, 2:].sum(axis=-1), 1.0)
        pose = typical_pose(model)
        assert model.check(pose).valid
        assert pose[1] < 0, "the tool hangs below the motors"
        assert page(poses_around(model, pose)).count("reducer 1 [%]") == 1


def test_a_declared_drawing_colours_its_springs(tmp_path: Path) -> None:
    for model in five_bar(DEFINITION + DECLARED, tmp_path):
        shown = scene(model, POSE)
        reducers = [e for e in shown.elements if e.kind == "reducer"]
        assert [(e.spring, e.turns) for e in reducers] == [(0, "phi_1"), (1, "phi_2")]
        centre, tip = shown.points[0, list(reducers[0].points)]
        np.testing.assert_allclose(centre, [-0.08, 0.0, 0.0])
        np.testing.assert_allclose(tip - centre, [0.0, 0.0, 0.22 / 8])


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ('m.draw.ball("platform", "tool", p)', "has three components, found 2"),
        ('m.draw.line("link", "link", m.platform, (0, 0))', "has three components, found 2"),
    ],
)
def test_mistakes_in_a_drawing_are_reported_with_their_line(line: str, message: str, tmp_path: Path) -> None:
    text = f"{DEFINITION}\n    {line}\n"
    with pytest.raises(PkmodesError, match=message) as error:
        register_definition(Definition("five_bar", text, tmp_path / "five_bar.py"))
    assert f"five_bar.py:{len(text.splitlines())}" in error.value.where
