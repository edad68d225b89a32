"""The viewer of measured modes in a report: its poses stand in the order of the tables and figures."""

from __future__ import annotations

from pathlib import Path

import pytest

from pkmodes import read_robot, updating
from pkmodes.pages.report.measured_view import measured_scene, shown_robot

LOOP = Path(__file__).parents[3] / "examples" / "closed_loop"


@pytest.mark.parametrize(
    ("renamed", "expected"),
    [
        ({"P4": "P10"}, ["P1", "P2", "P3", "P5", "P6", "P7", "P8", "P9", "P10"]),
        # With a label that has no number, all stay in the order of the file.
        ({"P4": "corner"}, ["P6", "P3", "P8", "P9", "P1", "P5", "P2", "P7", "corner"]),
    ],
)
def test_poses_are_in_the_order_of_tables_and_figures(
    renamed: dict[str, str], expected: list[str], tmp_path: Path
) -> None:
    text = (LOOP / "measured.csv").read_text("utf-8")
    for old, new in renamed.items():
        text = text.replace(f"\n{old},", f"\n{new},")
    (tmp_path / "measured.csv").write_text(text, encoding="utf-8")
    robot = read_robot(LOOP / "robot.toml")
    data = updating.read(tmp_path / "measured.csv", robot=robot)
    result = updating.compare(robot, data)
    seen = measured_scene(result, shown_robot(result, robot), data, "free")
    assert seen is not None
    assert list(seen.labels or ()) == expected
