"""Shapes with displacements and rotations: a rotation counts as the displacement at the characteristic length."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from pkmodes.modaltest.campaign.campaign import Campaign, read_campaign
from pkmodes.modaltest.campaign.grouping import group_modes
from pkmodes.modaltest.campaign.identify import _row
from pkmodes.modaltest.campaign.mode_estimates import ModeEstimate, mac
from pkmodes.modaltest.campaign.results import IdentifiedMode
from pkmodes.pages.report.identified_record import auto_macs, lengths_note

EXAMPLES = Path(__file__).parents[3] / "examples"
#: Places of the joints on the platform of examples/hexapod/robot.toml [mm].
JOINTS = np.array([[87, -87], [87, 87], [32, 119], [-119, 32], [-119, -32], [32, -119]])


@pytest.fixture(scope="module")
def hexapod() -> Campaign:
    return read_campaign(EXAMPLES / "hexapod" / "campaign.toml")


def test_angles_are_times_the_distance_of_the_joints(hexapod: Campaign) -> None:
    length = 1e-3 * np.sqrt((JOINTS**2).sum(axis=1).mean())
    assert hexapod.lengths == pytest.approx(dict.fromkeys(("r_x", "r_y", "r_z"), length))
    assert read_campaign(EXAMPLES / "campaign" / "campaign.toml").lengths == {}  # nothing turns


def test_the_criterion_is_that_of_metres() -> None:
    """(1 - 1)^2 = 0 with L = 0.1 m; with 1 rad = 1 m it would be (1 - 100)^2 / 101^2 = 0.96."""
    first, second = {"p_x": 1.0 + 0j, "r_y": 10.0 + 0j}, {"p_x": 1.0 + 0j, "r_y": -10.0 + 0j}
    assert mac(first, second, {"r_y": 0.1}) == pytest.approx(0.0, abs=1e-12)
    assert mac(first, second, {}) == pytest.approx((99 / 101) ** 2)
    modes = [[ModeEstimate(50.0, shape=shape, lengths={"r_y": 0.1})] for shape in (first, second)]
    assert len(group_modes(modes)) == 2
    assert len(group_modes([[replace(mode, lengths={}) for mode in file] for file in modes])) == 1


def rows(campaign: Campaign) -> list[IdentifiedMode]:
    """The rows of the first six modes of the declared machine at the first pose, as if they had been measured."""
    assert campaign.model is not None
    record = campaign.records[0]
    modes = campaign.model.modes([*record.point.values()], drives="held")
    estimates = [
        ModeEstimate(f, 0.01, dict(zip(campaign.platform.components, shape.astype(complex), strict=True)))
        for f, shape in zip(modes.frequencies[:6], modes.platform_shapes[:6], strict=True)
    ]
    return [_row(replace(mode, lengths=campaign.lengths), {}, 1e-3) for mode in estimates]


def test_no_two_modes_of_a_hexapod_are_said_to_be_alike(hexapod: Campaign) -> None:
    modes = rows(hexapod)
    macs = auto_macs(modes)
    assert macs[~np.eye(6, dtype=bool)].max() < 0.3
    mixed = auto_macs([replace(mode, lengths={}) for mode in modes])
    assert mixed[~np.eye(6, dtype=bool)].max() > 0.7


def test_polar_plots_and_collinearity_are_in_metres() -> None:
    shape = {"p_x": 1.0 + 0.0j, "r_y": 0.0 + 10.0j}
    row = _row(ModeEstimate(50.0, 0.01, shape, lengths={"r_y": 0.1}), {}, 1e-3)
    drawn = np.abs([*row.shape_in_metres.values()])
    assert drawn[0] == pytest.approx(drawn[1])  # a circle: not collinear at all
    assert row.complexity == pytest.approx(0.0, abs=1e-12)
    assert "L = 0.1 m" in lengths_note([row])
    assert lengths_note([replace(row, lengths={})]) == ""
