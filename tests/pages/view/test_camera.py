"""Where robots are looked at from: no plate hides the springs, and the viewer looks as the still picture does."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.pages.browser import opened
from pkmodes.pages.view import page, poses_around, scene, typical_pose
from pkmodes.pages.view.camera import camera, hiding_plates, seen_share
from pkmodes.pages.view.projection import view_rotation
from pkmodes.pages.view.scene import Scene

ROBOTS = (
    "corexy-printer",
    "bed-slinger",
    "cartesian-printer",
    "clavel-delta",
    "linear-delta-2022",
    "hexapod",
)


def shown(robot: str) -> Scene:
    model = pkmodes.load(f"robots/{robot}.toml")
    return scene(model, typical_pose(model))


@pytest.mark.parametrize("robot", ROBOTS)
def test_at_least_as_much_is_seen_as_from_the_usual_direction(robot: str) -> None:
    drawn = shown(robot)
    assert seen_share(drawn, camera(drawn)) >= seen_share(drawn, view_rotation(drawn))


def test_a_bed_above_its_belt_lets_it_shine_through() -> None:
    drawn = shown("bed-slinger")
    (index,) = hiding_plates(drawn)
    assert drawn.elements[index].name == "bed"
    raised = drawn.points.copy()
    raised[:, list(drawn.elements[index].points), 2] -= 0.2  # the bed below its belt hides nothing
    assert hiding_plates(replace(drawn, points=raised)) == frozenset()


def test_what_is_behind_a_plate_is_not_seen() -> None:
    """From straight above, the bed of a bed slinger covers what is under it; from below, nothing covers the belt."""
    drawn = shown("bed-slinger")
    above = np.eye(3)
    below = np.diag([1.0, -1.0, -1.0])
    belt = next(e for e in drawn.elements if e.name == "belt 2")
    only_belt = replace(
        drawn, elements=tuple(e for e in drawn.elements if e is belt or e.kind == "bed"), moving_bodies=()
    )
    assert seen_share(only_belt, above) < 0.85 < seen_share(only_belt, below)


def test_the_viewer_looks_from_where_the_still_picture_does(tmp_path: Path) -> None:
    drawn = poses_around(pkmodes.load("robots/bed-slinger.toml"), [0.12, 0.1])
    file = tmp_path / "page.html"
    file.write_text(page(drawn), encoding="utf-8")
    with opened(file) as seen:
        assert seen.problems == []
        towards = seen.page.evaluate(
            "(() => { const { camera, controls } = document.querySelector('.pkview').viewer.stage; "
            "return camera.position.clone().sub(controls.target).normalize().toArray(); })()"
        )
    assert towards == pytest.approx(camera(drawn)[2].tolist(), abs=1e-3)
