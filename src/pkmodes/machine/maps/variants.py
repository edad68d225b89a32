"""The robots of a map: with swept values, and with values drawn from their standard deviations."""

from __future__ import annotations

import itertools
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.arguments import NATURAL_NUMBER, POSITIVE_INTEGER, check_argument
from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.robot.layout import table_sources
from pkmodes.core.robot.parameter_groups import elements_at_value, groups_by_path
from pkmodes.core.robot.robot import Robot
from pkmodes.core.support.axes import swept_values
from pkmodes.core.support.covariance import covariance_of, covariance_root, sigmas_by_path

Array = NDArray[np.float64]
SAMPLE = "sample"
#: Maximum number of draws of one sample: if none gives a valid robot, a standard deviation is too large by mistake.
MAX_DRAWS = 100


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
      correlations; the draws do not depend on the swept values
    - seed: seed of the generator

    Raises PkmodesError if a path is unknown, values are invalid, or the robot declares no standard deviation to draw
    from.
    Raises RobotFileError if a robot file with these values would be rejected.
    """
    swept = {} if sweep is None else swept_values(sweep, "sweep")
    draws: list[tuple[dict[str, float], Robot]] = [({}, robot)]
    if samples is not None:
        check_argument(samples, POSITIVE_INTEGER, "samples", "for example: 200")
        check_argument(seed, NATURAL_NUMBER, "seed", "for example: 0")
        draws = _draw_robots(robot, paths_set_by_sweep(robot, swept), int(samples), seed)
    robots = []
    for values in itertools.product(*swept.values()):
        changes = {path: float(value) for path, value in zip(swept, values, strict=True)}
        robots += [robot.with_values({**changes, **draw}) if changes else sample for draw, sample in draws]
    drawn = {path: np.array([draw[path] for draw, _ in draws]) for path in draws[0][0]}
    return Variants(swept, drawn, samples, tuple(robots))


def _draw_robots(
    robot: Robot, swept_paths: Collection[str], samples: int, seed: int
) -> list[tuple[dict[str, float], Robot]]:
    """Draw values by path, each time with the robot that has them.

    Values that a robot file could not declare, such as a negative mass, are drawn again.
    """
    paths = [path for path in sigmas_by_path(robot) if path not in swept_paths]
    if not paths:
        problem = "no value of the robot has a standard deviation from which it could be drawn"
        remedy = 'declare some, such as mass = { value = "1.5 kg", sigma = "1 %" }'
        raise PkmodesError(problem, f"{robot.source}: samples", remedy)
    rng, root = np.random.default_rng(seed), covariance_root(covariance_of(robot, paths))
    declared_values = np.array([robot.quantities[path].value for path in paths])
    draws: list[tuple[dict[str, float], Robot]] = []
    for _ in range(samples):
        for _ in range(MAX_DRAWS):
            deviation = root @ rng.standard_normal(root.shape[1])
            values = dict(zip(paths, (declared_values + deviation).tolist(), strict=True))
            try:
                draws.append((values, robot.with_values(values)))
                break
            except PkmodesError as error:
                last_error = error
        else:
            message = f"none of {MAX_DRAWS} draws gave a robot that can exist: {last_error.what}"
            raise PkmodesError(message, last_error.where, "check the standard deviation of this value")
    return draws


def paths_set_by_sweep(robot: Robot, swept: Mapping[str, Array]) -> set[str]:
    """Return the paths of all values that a sweep sets: also elements of a group of parameters, and aliases.

    - swept: values by path
    """
    paths = set(swept)
    for path, values in swept.items():
        if path in groups_by_path(robot.mechanism):
            paths |= set(elements_at_value(robot, groups_by_path(robot.mechanism)[path], float(values[0])))
    for path, lender in table_sources(robot.mechanism).items():
        if {path, lender} & paths:
            paths |= {path, lender}
    return paths
