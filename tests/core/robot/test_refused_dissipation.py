"""Losses and friction that a robot cannot have are refused."""

from __future__ import annotations

import pytest

import pkmodes
from helpers.robots.one_of_each import FILES, ROBOTS
from pkmodes.core.base.errors import PkmodesError


@pytest.mark.parametrize(
    "path", ["belt_loss.loss_factor", "rail_friction.viscous", "gearbox_compliance.compliance"]
)
def test_effects_of_parts_that_a_mechanism_does_not_have_are_refused(path: str) -> None:
    with pytest.raises(PkmodesError, match=path.split(".")[0]):
        pkmodes.load(ROBOTS / FILES["rotary_delta"]).with_values({f"effects.{path}": 0.01})


@pytest.mark.parametrize(
    ("path", "value"),
    [
        ("effects.belt_loss.loss_factor", 1.0),
        ("effects.belt_loss.loss_factor", -0.1),
        ("effects.reducer_loss.loss_factor", 1.5),
        ("effects.rail_friction.viscous", -1.0),
        ("effects.drive_friction.viscous", -1e-3),
        ("damping.ratio", 1.0),
        ("damping.ratio", -0.01),
    ],
)
def test_values_outside_their_bounds_are_refused(path: str, value: float) -> None:
    with pytest.raises(PkmodesError, match=r"expected .*(less than 1|greater than|at least)"):
        pkmodes.load(ROBOTS / FILES["corexy"]).with_values({path: value})
