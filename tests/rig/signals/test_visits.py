"""Machines as they are approached: settled anew, off the pose, warmer; and losses in the elements that yield."""

from __future__ import annotations

import numpy as np
import pytest

from pkmodes_rig import corexy
from pkmodes_rig.signals.small_motion import Losses
from pkmodes_rig.signals.visits import Machine, Visit, Wander
from studies.specimens import robot_of

POSE = np.array([0.11, 0.2])


def printer(losses: Losses | None = None, **effects: float) -> Machine:
    named = {name.replace("__", "."): value for name, value in effects.items()}
    return Machine(corexy, robot_of("corexy").parameters, named, losses=losses or Losses(), held=True)


def test_all_stiffness_in_the_belts_gives_half_their_loss_factor() -> None:
    truth = printer(Losses(0.004, factor=0.02)).at(Visit(POSE, np.zeros(2))).truth
    np.testing.assert_allclose(truth.ratios, 0.004 + 0.01, rtol=1e-4)  # differences of 1 % in stiffness


def test_a_lossless_compliance_in_series_keeps_its_share_from_the_belts() -> None:
    """Clamps that yield a million times as much as the belts hold practically all of the energy."""
    softer = printer(Losses(0.0, factor=0.02), clamp_compliance__compliance=1.0)
    assert softer.at(Visit(POSE, np.zeros(2))).truth.ratios.max() < 1e-4


def test_approaches_scatter_the_frequencies_and_warming_lowers_them() -> None:
    machine, poses = printer(), np.tile(POSE, (400, 1))
    rng = np.random.default_rng(6)
    visits = Wander(approach=0.002).visits(machine, poses, 1, rng)
    found = np.array([machine.at(one).truth.natural for (one,) in visits])
    still = machine.at(Visit(POSE, np.zeros(2))).truth.natural
    # A mode that strains both belts alike scatters by the root of the sum of the squares of half their shares.
    scatter = np.std(found / still, axis=0)
    assert np.all((scatter > 0.0013) & (scatter < 0.0022))

    (each,) = Wander(approach=0.0, warming=0.002).visits(machine, poses[:1], 3, rng)
    warm = np.array([machine.at(one).truth.natural for one in each])
    np.testing.assert_allclose(warm[2] / still, np.sqrt(1.0 - 0.002), rtol=1e-9)
    np.testing.assert_allclose(warm[0], still, rtol=1e-12)


def test_repeats_at_a_pose_are_one_approach() -> None:
    ((a, b), (c, _)) = Wander(approach=0.002, place=1e-3).visits(
        printer(), np.tile(POSE, (2, 1)), 2, np.random.default_rng(1)
    )
    np.testing.assert_array_equal(a.pose, b.pose)
    np.testing.assert_array_equal(a.stiffer, b.stiffer)
    assert np.all(a.pose != c.pose)
    assert np.abs(a.pose - POSE).max() == pytest.approx(1e-3, rel=3.0)
