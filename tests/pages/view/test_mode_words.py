"""Modes in words: what moves and where to, frequencies with their standard deviations, rigid-body motions."""

from __future__ import annotations

from pathlib import Path

import pytest

import pkmodes
from helpers.pages.browser import opened
from pkmodes.pages.view import page, poses_around
from pkmodes.pages.view.mode_words import energy_text, frequency_text, motion_text

HEXAPOD_POSE = [0.0, 0.0, 0.26, 0.0, 0.0, 0.0]
BODIES, SIX = ("platform",) * 6, ("x", "y", "z", "about x", "about y", "about z")


def text_of(seen: object, part: str) -> str:
    return str(seen.page.locator(f'[data-part="{part}"]').first.text_content())  # type: ignore[attr-defined]


@pytest.mark.parametrize(
    ("bodies", "components", "direction", "expected"),
    [
        (("tool head", "bed"), ("x", "y"), (0.004, -1.0), "bed moves along y"),
        (
            ("tool head", "bed"),
            ("x", "y"),
            (0.6, -0.8),
            "tool head moves along x 0.60; bed moves along y \u22120.80",
        ),
        (("tool head", "tool head"), ("x", "y"), (0.6, -0.8), "tool head moves along x 0.60, y \u22120.80"),
        (("tool head", "bed"), ("x", "y"), (0.0, 0.0), "tool head and bed do not move"),
        (BODIES, SIX, (0.0, 0.0, 0.0, 0.0, 0.0, 0.0), "platform does not move"),
        (BODIES, SIX, (0.0, 0.0, 0.0, 0.0, 0.0, 1.0), "platform turns about z"),
        (
            *(BODIES, SIX, (0.0, -0.98, 0.0, -0.19, 0.004, -0.01)),
            "platform moves along y \u22120.98 and turns about x \u22120.19, z \u22120.01",
        ),
    ],
)
def test_only_what_moves_is_named(
    bodies: tuple[str, ...], components: tuple[str, ...], direction: tuple[float, ...], expected: str
) -> None:
    assert motion_text(bodies, components, direction) == expected


def test_a_bed_that_moves_alone_is_named_alone(tmp_path: Path) -> None:
    """The first mode of a bed slinger is its bed on belt 2; with a program and without."""
    scene = poses_around(pkmodes.load("robots/bed-slinger.toml"), [0.12, 0.1])
    file = tmp_path / "page.html"
    file.write_text(page(scene), encoding="utf-8")
    for java_script in (True, False):
        with opened(file, java_script_enabled=java_script) as seen:
            assert text_of(seen, "motion") == "Bed moves along y"
            assert seen.problems == []


def test_the_program_tells_motions_as_the_page_does_and_rigid_ones_at_zero(tmp_path: Path) -> None:
    """Gravity makes a hexapod with free legs fall over: no spring holds it, and it is no vibration of -0.3 Hz."""
    model = pkmodes.load("robots/hexapod.toml")
    assert (model.frequencies(HEXAPOD_POSE)[:6] < -0.01).all()
    scene = poses_around(model, HEXAPOD_POSE)
    file = tmp_path / "page.html"
    file.write_text(page(scene), encoding="utf-8")
    directions = scene.platform_shapes[scene.chosen] * scene.lengths
    directions /= (directions**2).sum(axis=1, keepdims=True) ** 0.5
    with opened(file) as seen:
        for mode in range(12):
            seen.page.locator(f'[data-part="mode"][value="{mode}"]').check()
            expected = motion_text(scene.bodies, scene.moves, directions[mode].tolist())
            assert text_of(seen, "motion").lower() == expected
            if mode < 6:
                assert text_of(seen, "title") == f"Rigid-body motion {mode + 1}: 0 Hz"
                assert "no spring is strained; with gravity it falls away." in text_of(seen, "status")
        labels = seen.page.evaluate(
            "document.querySelector('.pkview').viewer.stage.labels.children.map((label) => label.name)"
        )
        assert (
            sorted(labels) == [f"leg {k}" for k in range(1, 7)] == [spring.name for spring in scene.springs]
        )
        numbers = seen.page.locator('[data-part="frequency"]').all_text_contents()
        assert not any(number.startswith("\u2212") for number in numbers)
        assert numbers.count("0 Hz") == 6


def test_frequencies_have_the_standard_deviations_of_the_robot_file(tmp_path: Path) -> None:
    model = pkmodes.load("robots/corexy-printer.toml")
    pose = [0.15, 0.15]
    scene = poses_around(model, pose)
    (first, _), (sigma, _) = model.frequencies(pose), model.frequency_sigmas(pose)
    assert frequency_text(scene, scene.chosen, 0, with_sigma=True) == f"{first:.1f} \u00b1 {sigma:.1f} Hz"
    assert frequency_text(scene, scene.chosen, 0) == f"{first:.1f} Hz"
    file = tmp_path / "page.html"
    file.write_text(page(scene), encoding="utf-8")
    with opened(file) as seen:
        assert text_of(seen, "title") == f"Mode 1: {first:.1f} \u00b1 {sigma:.1f} Hz"
        assert (
            "\u00b1: from the standard deviations in the robot file"
            in seen.page.locator("header").inner_text()
        )
        seen.page.locator('[data-part="level"]').first.fill("55")  # between two computed poses
        assert text_of(seen, "title").startswith("Mode 1: \u2248 ")
        assert " \u00b1 2.4 Hz" in text_of(seen, "title")


def test_space_does_not_stop_the_view_from_fitting_the_window(tmp_path: Path) -> None:
    file = tmp_path / "page.html"
    file.write_text(
        page(poses_around(pkmodes.load("robots/corexy-printer.toml"), [0.15, 0.15])), encoding="utf-8"
    )
    with opened(file) as seen:
        turned = "!!document.querySelector('.pkview').viewer.viewTurned"
        seen.page.locator("canvas").first.focus()
        for key, expected in ((" ", False), ("ArrowLeft", True), (" ", True), ("Home", False)):
            seen.page.keyboard.press(key)
            assert seen.page.evaluate(turned) == expected


def test_modes_of_one_frequency_are_said_to_mix(tmp_path: Path) -> None:
    """On its axis of symmetry, a delta vibrates sideways in any direction: the two shapes drawn are examples."""
    scene = poses_around(pkmodes.load("robots/clavel-delta.toml"), [0.0, 0.0, -0.52])
    file = tmp_path / "page.html"
    file.write_text(page(scene), encoding="utf-8")
    expected = {
        3: "; mode 2 has the same frequency: any mixture is a mode, too",
        4: "; mode 1 has the same frequency: any mixture is a mode, too",
        5: "",
    }
    with opened(file, java_script_enabled=False) as seen:
        assert text_of(seen, "held").endswith(expected[3])
    with opened(file) as seen:
        for mode, end in expected.items():
            seen.page.locator(f'[data-part="mode"][value="{mode}"]').check()
            text = text_of(seen, "held")
            assert text == energy_text(scene, scene.chosen, mode)
            assert text.partition(";")[2] == end.removeprefix(";")
