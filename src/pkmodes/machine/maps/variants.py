"""The robots of a map: with swept values, and with values drawn from their standard deviations."""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.arguments import NATURAL_NUMBER, POSITIVE_INTEGER, check_argument
from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.robot.layout import lent
from pkmodes.core.robot.parameter_groups import elements_of, groups_by_path
from pkmodes.core.robot.robot import Robot
from pkmodes.core.support.axes import swept_values
from pkmodes.core.support.covariance import covariance_of, root_of, sigmas_by_path

Array = NDArray[np.float64]
SAMPLE = "sample"
#: Draws of one sample before the robot is refused: a standard deviation that large is a mistake.
DRAWS = 100


@dataclass(frozen=True, eq=False)
class Variants:
    """The robots of a map.

    - swept: values of each swept parameter [SI], by path
    - drawn: drawn values, each (samples,) [SI], by path; empty without samples
    - robots: in the order of the swept values, the last one fastest, then the samples
    """

    swept: Mapping[str, Array]
    drawn: Mapping[str, Array]
    samples: int | None
    robots: tuple[Robot, ...]

    @property
    def dims(self) -> tuple[str, ...]:
        """The paths of the swept parameters, and ``sample``."""
        return (*self.swept, *([] if self.samples is None else [SAMPLE]))

    @property
    def shape(self) -> tuple[int, ...]:
        """Number of robots along each of `dims`."""
        return (*(len(v) for v in self.swept.values()), *([] if self.samples is None else [self.samples]))


def variants_of(robot: Robot, sweep: Mapping[str, Any] | None, samples: int | None, seed: int) -> Variants:
    """Make the robots of a map.

    - sweep: values of parameters in SI units, by path; every combination is evaluated
    - samples: robots whose values with a standard deviation are drawn from a normal distribution with their
      correlations, except swept values, which say nothing of the others
    - seed: of the generator

    Raises PkmodesError if a path is unknown, values are invalid, or the robot declares no standard deviation to draw
    from.
    Raises RobotFileError if a robot file with these values would be rejected.
    """
    swept = {} if sweep is None else swept_values(sweep, "sweep")
    drawn, count = _drawn(robot, swept, samples, seed)
    robots = [
        _robot(robot, dict(zip(swept, values, strict=True)), drawn, i)
        for values in itertools.product(*swept.values())
        for i in range(count)
    ]
    return Variants(swept, drawn, samples, tuple(robots))


def _robot(robot: Robot, swept: Mapping[str, float], drawn: Mapping[str, Array], i: int) -> Robot:
    changes = {
        **{path: float(v) for path, v in swept.items()},
        **{path: float(v[i]) for path, v in drawn.items()},
    }
    return robot.with_values(changes) if changes else robot


def _drawn(
    robot: Robot, swept: Mapping[str, Array], samples: int | None, seed: int
) -> tuple[dict[str, Array], int]:
    """Draw values; a sample that a robot file could not declare, such as a negative mass, is drawn again."""
    if samples is None:
        return {}, 1
    check_argument(samples, POSITIVE_INTEGER, "samples", "for example: 200")
    check_argument(seed, NATURAL_NUMBER, "seed", "for example: 0")
    swept_paths = taken(robot, swept)
    spread = [path for path in sigmas_by_path(robot) if path not in swept_paths]
    if not spread:
        problem = "no value of the robot has a standard deviation from which it could be drawn"
        remedy = 'declare some, such as mass = { value = "1.5 kg", sigma = "1 %" }'
        raise PkmodesError(problem, f"{robot.source}: samples", remedy)
    rng, root = np.random.default_rng(seed), root_of(covariance_of(robot, spread))
    centre = {path: robot.quantities[path].value for path in spread}
    draws: dict[str, list[float]] = {path: [] for path in spread}
    for _ in range(int(samples)):
        for path, value in _sample(robot, centre, root, rng).items():
            draws[path].append(value)
    return {path: np.array(values) for path, values in draws.items()}, int(samples)


def taken(robot: Robot, swept: Mapping[str, Array]) -> set[str]:
    """Return the paths of all values that a sweep sets, including the elements of a whole and the aliases of a value.

    - swept: values by path
    """
    paths = set(swept)
    for path, values in swept.items():
        if path in groups_by_path(robot.mechanism):
            paths |= set(elements_of(robot, groups_by_path(robot.mechanism)[path], float(values[0])))
    for path, lender in lent(robot.mechanism).items():
        if {path, lender} & paths:
            paths |= {path, lender}
    return paths


def _sample(
    robot: Robot, spread: Mapping[str, float], root: Array, rng: np.random.Generator
) -> dict[str, float]:
    for _ in range(DRAWS):
        away = root @ rng.standard_normal(root.shape[1])
        values = dict(zip(spread, (np.array(list(spread.values())) + away).tolist(), strict=True))
        try:
            robot.with_values(values)
        except PkmodesError as error:
            problem = error
        else:
            return values
    message = f"none of {DRAWS} draws gave a robot that can exist: {problem.what}"
    raise PkmodesError(message, problem.where, "check the standard deviation of this value")
