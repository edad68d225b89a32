"""What each loss gives each mode: against dense modes of all coordinates, and losses written down by hand."""

from __future__ import annotations

import numpy as np
import pytest

import pkmodes
from helpers.diagnoses.robot_structures import declared, structure_at
from helpers.references.damping_by_hand import friction_by_hand, loss_by_hand
from helpers.references.motors_by_hand import followers
from helpers.references.whole_system import whole_modes
from helpers.robots.one_of_each import FILES, POSES, model_of
from pkmodes.loop.updating.robot_structure import RobotStructure

EFFECTS = {"gearbox_compliance.compliance": 2e-3, "belt_end_compliance.compliance": 2e-6}
#: What the motors do at each pose, and a payload that is set there.
DRIVES = ("free", "held", "free", "held")
PAYLOADS = (np.nan, np.nan, 0.3, 0.3)
PAYLOAD = "effects.payload.mass"


def points(mechanism: str) -> np.ndarray:
    return POSES[mechanism] + 0.01 * np.arange(len(DRIVES))[:, None]


def structure(model: pkmodes.Model, settings: dict[str, tuple[float, ...]]) -> RobotStructure:
    """The robot at four poses, with one row each."""
    robot, damping = model.robot, np.full(len(DRIVES), 0.01)
    at = points(robot.mechanism_name)
    return structure_at(robot, at, damping=damping, drives=DRIVES, settings=settings)


def by_hand(model: pkmodes.Model, p: np.ndarray, drives: str, path: str) -> np.ndarray:
    """Ratio of each vibration mode per unit of a loss."""
    if path == "damping.ratio":
        return np.ones(1)
    part = 1e-3
    lossy = model.with_values({path: part})
    M, K = model.matrices(p)
    rigid = model.modes(p, drives=drives).rigid_modes
    omega, phi, _ = whole_modes(M, K, followers(model, drives)[0], rigid)
    of_springs = np.einsum("ai,ab,bi->i", phi, loss_by_hand(lossy, p), phi) / (2 * omega**2)
    of_joints = np.einsum("ai,ab,bi->i", phi, friction_by_hand(lossy), phi) / (2 * omega)
    return (of_springs + of_joints) / part


@pytest.mark.parametrize("effects", [{}, EFFECTS], ids=["plain", "compliances"])
@pytest.mark.parametrize("mechanism", FILES)
def test_ratios_per_unit_of_each_loss_are_those_by_hand(mechanism: str, effects: dict[str, float]) -> None:
    """With free and held motors, with and without a payload that is set at the pose."""
    model = model_of(mechanism, effects)
    one = structure(model, {PAYLOAD: PAYLOADS})
    rates = one.damping_rates(declared(one))
    for k, (p, drives, payload) in enumerate(zip(points(mechanism), DRIVES, PAYLOADS, strict=True)):
        there = model if np.isnan(payload) else model.with_values({PAYLOAD: payload})
        for j, loss in enumerate(one.losses):
            expected = by_hand(there, p, drives, loss.parameter.name)
            found = rates[k, :, j]
            found = found[~np.isnan(found)]
            if loss.effect:
                assert len(found) == len(expected)
            # The dense eigenproblem of all coordinates loses half of the digits of a mode that a joint hardly moves.
            np.testing.assert_allclose(
                found, np.resize(expected, len(found)), rtol=1e-6, atol=1e-9 * found.max()
            )


@pytest.mark.parametrize("mechanism", FILES)
def test_friction_of_motors_that_are_held_damps_nothing(mechanism: str) -> None:
    one = structure(model_of(mechanism), {})
    rates = one.damping_rates(declared(one))
    (drives,) = (j for j, loss in enumerate(one.losses) if loss.candidate == "drive_friction")
    held = np.array(DRIVES) == "held"
    assert np.nanmax(np.abs(rates[held][:, :, drives])) == 0.0
    assert np.nanmin(np.nanmax(rates[~held][:, :, drives], axis=1)) > 0.0


def test_a_pose_at_which_the_measurements_set_a_loss_says_nothing_about_it() -> None:
    loss = "effects.belt_loss.loss_factor"
    one = structure(model_of("corexy"), {loss: (np.nan, 0.02, np.nan, 0.02)})
    rates = one.damping_rates(declared(one))
    (belts,) = (j for j, each in enumerate(one.losses) if each.parameter.name == loss)
    blank = np.isnan(rates[:, :2])  # the modes that both free and held motors have
    assert blank[1::2, :, belts].all()
    assert not blank[::2].any()
    assert not np.delete(blank, belts, axis=2).any()
