"""A path of straight lines, by hand, and the frequencies along it on the page of a map."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.pages.page_reading import read
from pkmodes.cli import run
from pkmodes.core.base.errors import PoseError
from pkmodes.machine.maps.pose_path import PosePath
from pkmodes.pages.plots.sweeps import along_path

ROBOT = "robots/linear-delta-2022.toml"
CORNERS = [[0.4, 0.0, -0.245], [0.7, 0.0, -0.245], [0.7, 0.04, -0.215]]


def test_a_path_has_equal_distances_and_its_corners() -> None:
    """Of 300 mm along x, and 50 mm along a diagonal of 40 and 30 mm."""
    path = PosePath.through(pkmodes.load(ROBOT).mechanism, CORNERS)
    assert path.unit == "mm"
    assert path.corners == pytest.approx([0.0, 300.0, 350.0])
    np.testing.assert_allclose(path.poses.table[0], CORNERS[0])
    np.testing.assert_allclose(path.poses.table[-1], CORNERS[-1])
    for corner, at in zip(CORNERS, path.corners, strict=True):
        place = int(np.argmin(np.abs(path.distance - at)))
        np.testing.assert_allclose(path.poses.table[place], corner, atol=1e-12)
    travelled = np.linalg.norm(np.diff(path.poses.table, axis=0), axis=1).cumsum() * 1e3
    np.testing.assert_allclose(path.distance[1:], travelled)
    assert np.diff(path.distance).max() == pytest.approx(3.5)


def test_its_labels_have_the_digits_that_tell_its_steps_apart() -> None:
    """Steps of 3.5 mm need a tenth; a corner 0.02 mm beside another pose a hundredth."""
    mechanism = pkmodes.load(ROBOT).mechanism
    path = PosePath.through(mechanism, CORNERS)
    assert path.poses.labels[:3] == ("0.0 mm", "3.5 mm", "7.0 mm")
    near = PosePath.through(mechanism, [[0.4, 0.0, -0.245], [0.43502, 0.0, -0.245], [0.75, 0.0, -0.245]])
    assert {"35.00 mm", "35.02 mm"} <= set(near.poses.labels)


def test_the_head_of_its_map_names_the_path(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["map", ROBOT, "--path", "0.4,0,-0.245;0.7,0,-0.245;0.7,0.04,-0.215"]) == 0
    assert "102 poses along a path of 350 mm." in " ".join(capsys.readouterr().out.split())


@pytest.mark.parametrize(
    ("corners", "message"), [(CORNERS[:1], "at least two poses"), ([CORNERS[0]] * 2, "are equal")]
)
def test_what_is_no_path_is_refused(corners: list[list[float]], message: str) -> None:
    with pytest.raises(PoseError, match=message):
        PosePath.through(pkmodes.load(ROBOT).mechanism, corners)


def test_the_drawing_has_the_frequencies_of_the_model() -> None:
    model = pkmodes.load(ROBOT)
    path = PosePath.through(model.mechanism, CORNERS)
    columns = {column[0]: column[1:] for column in along_path(model.map(path.poses), path).table}
    modes = model.modes(CORNERS[1])
    for number in (1, 4):
        drawn = [
            (float(x), float(f))
            for name, x, f in zip(
                columns["series"], columns["distance along the path [mm]"], columns["f [Hz]"], strict=True
            )
            if name == f"mode {number}"
        ]
        at = min(drawn, key=lambda point: abs(point[0] - 300.0))
        assert at == pytest.approx((300.0, modes.frequencies[modes.rigid_modes + number - 1]), rel=1e-7)


def test_the_command_draws_a_path(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    page = tmp_path / "map.html"
    path = "400 mm,0,-245 mm; 0.7,0,-0.245"
    assert run(["map", ROBOT, "--path", path, "--report", str(page)]) == 0
    assert "Along the path" in read(page.read_text(encoding="utf-8")).by_id("poses").text
    assert run(["map", ROBOT, "--path", path, "--grid", "x=0.5,y=0,z=-0.245"]) == 2
    assert "--path excludes --grid and --poses" in capsys.readouterr().err
