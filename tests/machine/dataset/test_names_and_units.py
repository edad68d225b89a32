"""What datasets and tables say for people and other programs: units, columns and their order, quoting, marks."""

from __future__ import annotations

import csv
import re
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

import pkmodes
from helpers.robots.one_of_each import load_free
from pkmodes.core.solve.fields import FIELDS
from pkmodes.machine.dataset.table import table_of, write_table
from pkmodes.machine.dataset.variables import EVENT_FLAGS

ROBOTS = Path(__file__).parents[3] / "robots"
pytest.importorskip("xarray")


@pytest.mark.parametrize(
    ("robot", "pose", "joints", "torques"),
    [
        ("linear-delta-2022", [0.6, 0.0, -0.245], "m", "N m"),
        ("clavel-delta", [0.0, 0.05, -0.7], "rad", "N m"),
        ("corexy-printer", [0.1, 0.2], "m", "N m"),
    ],
)
def test_joint_positions_and_torques_have_the_units_of_the_mechanism(
    robot: str, pose: list[float], joints: str, torques: str
) -> None:
    found = pkmodes.load(ROBOTS / f"{robot}.toml").map([pose])
    assert found["joint_position"].attrs["units"] == joints
    assert found["static_torque"].attrs["units"] == torques


def test_a_linear_drive_has_a_force_and_mixed_coordinates_have_no_common_unit() -> None:
    def coordinates(*units: str) -> SimpleNamespace:
        named = [SimpleNamespace(name=f"q_{i}", unit=unit) for i, unit in enumerate(units)]
        drives = [SimpleNamespace(name="1", unit="N")]
        return SimpleNamespace(coordinates=named, independent=("q_0", "q_1"), drives=drives)

    for units, expected in ((("rad", "rad", "m"), "rad"), (("m", "m", "rad"), "m"), (("m", "rad", "m"), "1")):
        assert FIELDS["joint_positions"].units_of(coordinates(*units)) == expected  # type: ignore[arg-type]
    assert FIELDS["static_torque"].units_of(coordinates("m", "m")) == "N"  # type: ignore[arg-type]


def test_columns_of_a_table_are_in_the_order_of_a_person_who_reads_it() -> None:
    """First where and which mode, then numbers of the mode and of the pose, then their components."""
    model = load_free("corexy-printer.toml")
    line = {"x": np.linspace(0.1, 0.2, 3), "y": 0.1}
    table = table_of(model.map(line, shapes=True, tracked=True))
    coordinates = list(model.coordinates)
    drives = [drive.name for drive in model.mechanism.drives]
    assert list(table) == [
        *("y", "x", "mode"),
        *("frequency", "in_plane", "out_of_plane", "rank", "tracking"),
        *("condition", "valid", "reason"),
        *("platform_shape:x", "platform_shape:y"),
        *(f"shape:{name}" for name in coordinates),
        *(f"joint_position:{name}" for name in coordinates),
        *(f"static_torque:{name}" for name in drives),
    ]


def test_text_in_a_table_is_quoted_where_it_has_to_be(tmp_path: Path) -> None:
    pandas = pytest.importorskip("pandas")
    said = ["plain", "two, parts", 'a "word"', "two\nlines", ""]
    table = pandas.DataFrame({"platform_shape:x": [0.5, np.nan, -1.0, 2.0, 3.0], "reason": said})
    write_table(table, tmp_path / "table.csv")
    first, second = (tmp_path / "table.csv").read_text(encoding="utf-8").splitlines()[:2]
    assert first == "platform_shape:x,reason"
    assert second == "0.5,plain"
    with (tmp_path / "table.csv").open(newline="", encoding="utf-8") as file:
        header, *rows = csv.reader(file)
    assert header == list(table)
    assert [row[1] for row in rows] == said
    assert [row[0] for row in rows] == ["0.5", "", "-1.0", "2.0", "3.0"]


def test_marks_of_tracked_modes_are_the_bits_of_the_documentation() -> None:
    page = (ROBOTS.parent / "docs/how-to/maps.md").read_text(encoding="utf-8")
    table = dict(re.findall(r"^\| `(\w+)` \| (\d) \|", page, re.MULTILINE))
    assert {name: str(bit) for name, bit in EVENT_FLAGS.items()} == table
    assert list(table) == ["crossing", "veering", "uncertain"]
