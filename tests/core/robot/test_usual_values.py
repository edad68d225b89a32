"""What a value of a robot can be: ranges outside of which a claimed value is marked as implausible."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from helpers.diagnoses.diagnose_command import PUBLISHED, edited
from pkmodes import read_robot
from pkmodes.core.mechanism.registry import mechanism
from pkmodes.core.robot.layout import Item
from pkmodes.loop.diagnosis import Measurements, Parameter
from pkmodes.loop.updating.measured_robot import MeasuredRobot
from pkmodes.loop.updating.usual import plausible_range

#: A value of every kind without a sigma, as declared in the published robot.
SUSPECTED = edited(
    PUBLISHED,
    ('mass = { value = "1.5 kg", sigma = "1 %" }', 'mass = "1.5 kg"'),
)
POINTS = np.array([[0.5, 0.0, -0.245], [0.7, 0.1, -0.24]])


def parameters(folder: Path, text: str, sigma: float = 0.0) -> dict[str, Parameter]:
    """Return the parameters of a robot measured at two poses, with errors of the poses [m]."""
    (folder / "robot.toml").write_text(text, encoding="utf-8")
    data = Measurements.from_rows(
        ["P1", "P2"],
        np.array([30.0, 31.0]),
        np.array([0.1, 0.1]),
        points=POINTS,
        point_sigma=np.full(POINTS.shape, sigma),
    )
    structure = MeasuredRobot.of(read_robot(folder / "robot.toml"), data).structure()
    return {p.name: p for p in structure.parameters}


def test_a_span_may_be_wrong_by_a_few_per_cent_and_a_mass_by_a_factor_of_two(tmp_path: Path) -> None:
    found = parameters(tmp_path, SUSPECTED)
    span, mass = found["axis.span"], found["platform.mass"]
    assert span.usual == pytest.approx((0.95 * span.value, 1.05 * span.value))
    assert mass.usual == pytest.approx((0.75, 3.0))
    low, high = found["gravity.z"].usual or (0.0, 0.0)
    assert low == -high == pytest.approx(-9.81 * 1.01)


def test_a_small_length_may_be_that_of_another_part(tmp_path: Path) -> None:
    """A belt of 10 mm on a machine declared with one of 15 mm is nothing strange."""
    width = parameters(tmp_path, SUSPECTED)["belt.width"]
    assert width.usual == pytest.approx((0.010, 0.020))


def test_a_value_with_a_sigma_and_an_effect_have_no_such_range(tmp_path: Path) -> None:
    found = parameters(tmp_path, PUBLISHED)
    assert found["platform.mass"].usual is None
    assert found["effects.gearbox_compliance.compliance"].usual is None


def test_where_the_file_states_errors_of_the_poses_a_common_shift_is_of_their_size(tmp_path: Path) -> None:
    stated, without = (parameters(tmp_path, PUBLISHED, sigma) for sigma in (3e-4, 0.0))
    assert stated["measurement.offset.z"].usual == pytest.approx((-9e-4, 9e-4))
    assert stated["measurement.yaw"].usual == pytest.approx(np.array([-1.0, 1.0]) * 9e-4 / np.hypot(0.7, 0.1))
    # Without a statement it is some millimetres, as of a part.
    assert without["measurement.offset.z"].usual == pytest.approx((-0.005, 0.005))
    assert without["measurement.yaw"].usual == pytest.approx(
        np.array([-1.0, 1.0]) * 0.005 / np.hypot(0.7, 0.1)
    )


def test_teeth_and_threads_can_be_counted(tmp_path: Path) -> None:
    ratio = parameters(tmp_path, SUSPECTED)["motor.gear_ratio"]
    assert ratio.usual == pytest.approx((0.95 * ratio.value, 1.05 * ratio.value))
    travel = next(key for table in mechanism("hexapod").tables for key in table.keys if key.name == "travel")
    item = Item("motor.travel", travel, (), None, "", ("motor", "travel"))
    assert plausible_range(item, 0.8e-3, "m", 0.0) == pytest.approx((0.76e-3, 0.84e-3))


def test_the_belts_of_one_axis_may_be_half_or_twice_as_stiff(tmp_path: Path) -> None:
    found = parameters(tmp_path, SUSPECTED)
    assert found["effects.axis_belt_stiffness.factor_2"].usual == pytest.approx((-0.5, 1.0))
