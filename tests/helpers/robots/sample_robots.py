"""Robots for tests: the published one, a tower printer, and random ones that have nothing in common.

The first two are symmetric, where terms vanish or cancel and a wrong one may hide; in the random ones no two
numbers are equal, so that every exchange of axes, pulleys or coordinates shows.  All of them stand inside their
limits and away from singular poses: agreement to rounding can only be asked where the problem has a condition.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import NamedTuple

import numpy as np

from pkmodes.core.robot.reading import read_robot
from pkmodes_generated.linear_delta import Parameters

ROBOTS = Path(__file__).resolve().parents[3] / "robots"

#: Largest Frobenius condition number of D_l: the least is 3, and the paper's working plane has about 3.5.
LARGEST_CONDITION = 12.0
#: Bounds of the cosine between linkage and rail: x(p) is singular at 0, and a linkage along its rail is special.
COSINES = (0.35, 0.95)


class Sample(NamedTuple):
    """A robot and a pose of its platform, both without batch."""

    parameters: Parameters
    pose: np.ndarray


def published(pose: tuple[float, float, float] = (0.62, 0.0, -0.245)) -> Sample:
    """Return the robot of the paper; by default on its plane of symmetry y = 0 and in its working plane."""
    return Sample(read_robot(ROBOTS / "linear-delta-2022.toml").parameters, np.array(pose))


def tower_printer(pose: tuple[float, float, float] = (0.0, 0.0, 0.1)) -> Sample:
    """Return a printer with three vertical rails on a circle, alike but for their place.

    The pulleys at the top are driven; by default the pose is on the axis of symmetry.
    """
    angles = 2 * np.pi * np.arange(3) / 3
    outward = np.stack([np.cos(angles), np.sin(angles), np.zeros(3)], axis=-1)

    def same(value: float) -> np.ndarray:
        return np.full(3, value)

    parameters = Parameters(
        platform_mass=0.3,
        gravity=np.array([0.0, 0.0, -9.81]),
        origin=0.17 * outward,
        direction=np.tile([0.0, 0.0, 1.0], (3, 1)),
        joint=0.03 * outward,
        link_length=same(0.3),
        link_mass=same(0.06),
        carriage_mass=same(0.15),
        carriage_length=same(0.04),
        belt_specific_stiffness=same(0.9e6),
        belt_width=same(6e-3),
        pulley_radius=same(6e-3),
        pulley_inertia=same(0.3e-6),
        motor_inertia=same(5e-6),
        gear_ratio=same(1.0),
        drive=np.tile([1.0, 0.0], (3, 1)),
        limits=np.tile([0.0, 0.9], (3, 1)),
        branch=same(1.0),
    )
    return Sample(parameters, np.array(pose))


def random_robot(rng: np.random.Generator) -> Sample:
    """Draw a robot and a pose inside its limits.

    The pose and the linkages come first, and the rails are laid through the carriages: so every draw is
    reachable, on either branch of each axis, and well conditioned.
    """
    pose = rng.uniform(-0.5, 0.5, 3)
    joint = rng.uniform(-0.1, 0.1, (3, 3))
    length = rng.uniform(0.25, 0.6, 3)
    linkage = _linkages(rng, length)
    direction, cosine = _rails(rng, linkage / length[:, None])
    x = rng.uniform(-0.5, 0.9, 3)
    carriage_length = rng.uniform(0.02, 0.1, 3)
    return Sample(
        Parameters(
            platform_mass=rng.uniform(0.5, 3.0),
            gravity=9.81 * _unit_vectors(rng, 1)[0],
            origin=pose + joint - linkage - x[:, None] * direction,
            direction=direction,
            joint=joint,
            link_length=length,
            link_mass=rng.uniform(0.2, 1.5, 3),
            carriage_mass=rng.uniform(0.5, 2.0, 3),
            carriage_length=carriage_length,
            belt_specific_stiffness=rng.uniform(1e6, 3e6, 3),
            belt_width=rng.uniform(9e-3, 25e-3, 3),
            pulley_radius=rng.uniform(15e-3, 40e-3, 3),
            pulley_inertia=rng.uniform(50e-6, 300e-6, 3),
            motor_inertia=rng.uniform(5e-6, 40e-6, 3),
            gear_ratio=rng.uniform(1.0, 12.0, 3),
            drive=np.eye(2)[rng.integers(0, 2, 3)],
            limits=np.stack(
                [
                    x - carriage_length / 2 - rng.uniform(0.05, 0.6, 3),
                    x + carriage_length / 2 + rng.uniform(0.05, 0.6, 3),
                ],
                axis=-1,
            ),
            branch=-np.sign(cosine),
        ),
        pose,
    )


def _unit_vectors(rng: np.random.Generator, count: int) -> np.ndarray:
    vectors = rng.normal(size=(count, 3))
    return vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)


def _linkages(rng: np.random.Generator, length: np.ndarray) -> np.ndarray:
    """Vectors from carriage to joint, one row for each axis, that are far from lying in one plane."""
    while True:
        linkage = length[:, None] * _unit_vectors(rng, 3)
        if np.linalg.cond(linkage, "fro") < LARGEST_CONDITION:
            return linkage


def _rails(rng: np.random.Generator, linkage: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Directions of the rails and their cosines with the linkages."""
    while True:
        direction = _unit_vectors(rng, 3)
        cosine = np.sum(direction * linkage, axis=-1)
        if np.all((np.abs(cosine) > COSINES[0]) & (np.abs(cosine) < COSINES[1])):
            return direction, cosine


SYMMETRIC = ("published-symmetric", "tower-symmetric")
RANDOM = tuple(f"random-{seed}" for seed in range(8))
SAMPLES = (*SYMMETRIC, "published-aside", "tower-aside", *RANDOM)


@cache
def sample(name: str) -> Sample:
    """One of `SAMPLES`: shared by tests, so not to be changed in place."""
    kind, _, detail = name.partition("-")
    if kind == "random":
        return random_robot(np.random.default_rng(int(detail)))
    if kind == "published":
        return published() if detail == "symmetric" else published((0.47, 0.06, -0.22))
    return tower_printer() if detail == "symmetric" else tower_printer((0.05, -0.03, 0.17))
