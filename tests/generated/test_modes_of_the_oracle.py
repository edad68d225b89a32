"""Frequencies, shapes and torques from the user interface against modes of the oracle's matrices in 60 digits.

The generated matrices are compared elsewhere; these tests cover the runtime: free coordinates, joints of a given
compliance, massless clamps, and the platform's absolute motion.
"""

from __future__ import annotations

import numpy as np
import pytest

from helpers.references.oracle_modes import exact, model_of
from helpers.robots.sample_mechanisms import (
    NAMES,
    TOGETHER,
    effect_names,
    effects,
    oracle,
    sample,
)

SEEDS = range(2)
CHOICES = [
    (name, label)
    for name in NAMES
    for label in TOGETHER
    if label in ("nothing", "everything") or set(TOGETHER[label]) & set(effect_names(name))
]


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize(("name", "label"), CHOICES)
def test_modes_are_those_of_the_oracle(name: str, label: str, seed: int) -> None:
    robot, chosen = sample(name, seed), effects(name, TOGETHER[label])
    it, modes, kept = exact(name, robot, chosen)
    found = model_of(name, robot, chosen).modes(robot.pose)
    assert found.coordinates == tuple(it.coordinates[i] for i in kept)
    values = modes.values()
    expected = np.sign(values) * np.sqrt(np.abs(values)) / (2 * np.pi)
    assert found.frequencies.shape == expected.shape
    # The error of a symmetric eigenproblem is relative to the largest eigenvalue; measured: 1.1e-14 of it.
    error = np.abs(np.sign(found.frequencies) * (2 * np.pi * found.frequencies) ** 2 - values)
    assert error.max() < 1e-13 * values[-1]

    motion = it.platform_motion().astype(float)[:, kept]
    rows = modes.rows()
    gaps = np.abs(values[:, None] - values) + np.diag(np.full(len(values), np.inf))
    for k in range(len(values)):
        if gaps[k].min() < 1e-7 * values[-1]:
            assert values[k] < 1e-7 * values[-1]  # the shapes of repeated rigid modes are arbitrary
            continue
        sign = np.sign(found.shapes[k] @ rows[k])
        # rounding of a shape grows as the distance to the nearest other mode shrinks; measured: 1.3e-14
        bound = 2e-13 * values[-1] / gaps[k].min() * np.abs(rows[k]).max()
        assert np.abs(sign * found.shapes[k] - rows[k]).max() < bound
        moved = motion @ rows[k]
        assert np.abs(sign * found.platform_shapes[k] - moved).max() < bound


@pytest.mark.parametrize("name", NAMES)
def test_torques_are_those_of_the_oracle(name: str) -> None:
    robot, chosen = sample(name, 0), effects(name, ("",))
    torques, displacements = oracle(name, robot, chosen).static_equilibrium()
    found = model_of(name, robot, chosen).statics(robot.pose)
    # the same functions that `test_oracle` compares to a few 1e-15 of the largest
    for one, other in ((found.torques, torques), (found.rotations, displacements)):
        assert np.abs(one - other.astype(float)).max() < 1e-13 * np.abs(one).max()
