"""Sliders for values of the robot: exact where computed, interpolated between, beside the declared robot."""

from __future__ import annotations

import itertools
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pkmodes
from helpers.pages.browser import opened
from pkmodes.cli import run
from pkmodes.cli.show import parse_vary
from pkmodes.core.base.errors import PkmodesError
from pkmodes.pages.view import varied

ROBOTS = Path(__file__).parents[3] / "robots"
ROBOT = ROBOTS / "linear-delta-2022.toml"
POSE = [0.6, 0.0, -0.245]


def test_every_state_is_the_model_with_its_values() -> None:
    model = pkmodes.load(ROBOT)
    shown = varied(model, POSE, {"platform.mass": [0.5, 3.0], "effects.payload.mass": [0.0, 1.0, 2.0]})
    assert shown.values is not None
    assert [one.name for one in shown.axes] == ["platform.mass", "effects.payload.mass"]
    assert shown.values.tolist() == [[m, p] for m in (0.5, 1.5, 3.0) for p in (0.0, 1.0, 2.0)]
    for values, frequencies in zip(shown.values, shown.frequencies, strict=True):
        machine = model.with_values(dict(zip([one.name for one in shown.axes], values, strict=True)))
        np.testing.assert_allclose(frequencies, machine.frequencies(POSE), rtol=1e-12, atol=1e-5)
    assert shown.declared is not None
    assert shown.values[shown.declared].tolist() == [1.5, 0.0]
    assert shown.chosen == shown.declared
    np.testing.assert_array_equal(shown.frequencies[shown.declared], model.modes(POSE).frequencies)


def test_the_declared_value_is_added_beyond_the_range() -> None:
    shown = varied(pkmodes.load(ROBOT), POSE, {"platform.mass": [2.0, 3.0]})
    assert shown.levels is not None
    assert shown.levels[0].tolist() == [1.5, 2.0, 3.0]


def test_values_that_release_joints_share_their_modes() -> None:
    """With a compliance of 0 at one end, the modes are as many as the rigid gearboxes leave."""
    model = pkmodes.load(ROBOT)
    path = "effects.gearbox_compliance.compliance"
    shown = varied(model, POSE, {path: [0.0, 2e-4]})
    released = model.with_values({path: 2e-4})
    assert len(shown.coordinates) == len(released.coordinates) > len(model.coordinates)
    np.testing.assert_allclose(shown.frequencies[0], model.frequencies(POSE), atol=1e-5)
    np.testing.assert_allclose(
        shown.frequencies[1], released.frequencies(POSE)[: len(model.coordinates)], rtol=1e-12, atol=1e-5
    )
    assert [spring.name for spring in shown.springs[-3:]] == [f"wind-up of gearbox {j}" for j in (1, 2, 3)]
    assert not shown.energies[0, :, -3:].any()
    np.testing.assert_allclose(np.nansum(shown.shares[:, 3:], axis=-1), 1.0)


def test_combinations_that_cannot_be_at_the_pose_have_no_place() -> None:
    shown = varied(pkmodes.load(ROBOT), POSE, {"link.length": [0.3, 0.4, 0.5]})
    assert shown.places is not None
    reachable = [
        pkmodes.load(ROBOT).with_values({"link.length": v}).check(POSE).valid for v in (0.3, 0.4, 0.5)
    ]
    assert (shown.places >= 0).tolist() == reachable


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("platform.mass", 'expected PATH=START:STOP, found "platform.mass"'),
        ("platform.mass=1", "expected start:stop or start:stop:count"),
        ("platfrm.mass=1:2", 'unknown parameter path "platfrm.mass"'),
        ("platform.mass=3:1", "the range is reversed"),
        ("platform.mass=1:2,platform.mass=1:2", "platform.mass is given twice"),
        ("a=1:2,b=1:2,c=1:2,d=1:2", "expected at most 3 parameters, found 4"),
        ("platform.mass=-1:2", "expected a mass greater than 0 kg, found -1"),
        ("platform.mass=1:2:40,effects.payload.mass=0:1:40", "expected at most 600 combinations of values"),
        ("platform.mass=1 m:2 m", 'expected a mass such as "1.5 kg", found "1 m", which is a length'),
        ("platform.mass=1:2:1", 'a slider needs several values, found "1:2:1"'),
        ("platform.mass=1:1", 'a slider needs several values, found "1:1"'),
        (
            "link.length=0.1:0.2",
            "the pose is out of reach with every value of link.length but the declared one",
        ),
    ],
)
def test_a_mistake_in_the_option_is_told_with_what_to_do(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], text: str, message: str
) -> None:
    out = tmp_path / "page.html"
    assert run(["show", str(ROBOT), "--pose", "0.6,0,-0.245", "--vary", text, "--out", str(out)]) == 2
    said = capsys.readouterr().err
    assert said.startswith("error: ")
    assert message in said
    assert said.count("\n") == 1
    assert not out.exists()


def test_ranges_are_read_with_units_and_counts() -> None:
    robot = pkmodes.read_robot(ROBOT)
    found = parse_vary("platform.mass=500 g:3 kg:6, effects.payload.mass=0:2", robot)
    np.testing.assert_allclose(found["platform.mass"], [0.5, 1.0, 1.5, 2.0, 2.5, 3.0])
    np.testing.assert_allclose(found["effects.payload.mass"], np.linspace(0.0, 2.0, 9))
    assert len(parse_vary("platform.mass=1:2", robot)["platform.mass"]) == 21
    with pytest.raises(PkmodesError, match="expected 1 to 3 parameters"):
        varied(pkmodes.load(ROBOT), POSE, {})


def test_a_slider_changes_the_robot_beside_the_declared_one(tmp_path: Path) -> None:
    file = tmp_path / "page.html"
    arguments = ["show", str(ROBOT), "--pose", "0.6,0,-0.245", "--vary", "platform.mass=0.5:3:11"]
    assert run([*arguments, "--out", str(file)]) == 0
    assert file.stat().st_size < 1_000_000
    model = pkmodes.load(ROBOT)
    declared, light = model.frequencies(POSE), model.with_values({"platform.mass": 0.5}).frequencies(POSE)
    with opened(file, motion="reduce") as seen:

        def text(part: str) -> str:
            return str(seen.page.locator(f'[data-part="{part}"]').first.inner_text())

        def asked(expression: str) -> Any:
            return seen.page.evaluate(
                f"(() => {{ const viewer = document.querySelector('.pkview').viewer; return {expression}; }})()"
            )

        slider = seen.page.locator('[data-part="level"]')
        assert text("level-value") == "1.5 kg"
        assert text("title") == f"Mode 1: {declared[3]:.2f} Hz"
        assert text("declared") == f", {declared[3]:.2f} Hz (0.0 %)"
        slider.press("Home")
        assert text("level-value") == "0.5 kg"
        assert text("title") == f"Mode 1: {light[3]:.2f} Hz"
        assert text("declared") == f", {declared[3]:.2f} Hz (+{100 * (light[3] / declared[3] - 1):.1f} %)"
        assert text("between") == "Computed for these values."
        # The ghost is the declared robot in its own mode, in phase with the one that is shown.
        ghost = np.array(asked("[...viewer.stage.ghost.geometry.attributes.position.array]")).reshape(-1, 3)
        lines = asked("viewer.data.elements.filter((e) => e.shape === 'line').map((e) => e.points)")
        own = asked("viewer.states.declaredMode(viewer.state, viewer.mode)")
        assert own["frequency"] == pytest.approx(declared[3], abs=1e-4)
        moved = np.reshape(
            asked(
                "viewer.stage.displace(viewer.data.points[viewer.data.declared],"
                " viewer.states.declaredMode(viewer.state, viewer.mode).displacements,"
                " viewer.states.declaredMode(viewer.state, viewer.mode).sign)"
            ),
            (-1, 3),
        )
        ends = [p for points in lines for pair in itertools.pairwise(points) for p in pair]
        np.testing.assert_allclose(ghost, moved[ends], atol=1e-5)
        for _ in range(5):
            slider.press("ArrowRight")
        assert text("title").startswith("Mode 1: \u2248 ")
        assert text("between").startswith(
            "Interpolated between computed values: half-way between them, frequencies "
        )
        mass = 0.5 + 0.5 * 0.25
        exact = model.with_values({"platform.mass": mass}).frequencies(POSE)[3:]
        off = asked("viewer.state.deviation")
        # Rounding of the data: 5e-5 Hz of frequencies, 5e-5 of the deviation.
        np.testing.assert_allclose(asked("viewer.state.frequencies")[3:], exact, rtol=off + 6e-5)
        assert seen.findings() == []
        assert seen.problems == []
