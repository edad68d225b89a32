"""A machine with its true values at some poses: its modes with faults, what becomes of each mode, sizes of faults."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property

import numpy as np
from scipy.optimize import linear_sum_assignment

from pkmodes.core.robot.robot import Robot
from pkmodes.loop.sensitivity.paths import change_quantities, resolve
from pkmodes_rig import TrueModes
from pkmodes_rig.one_place import Fault, assembled
from pkmodes_rig.one_place.draws import Drawn

#: Largest number of steps of the search for a size, and how near it comes.
STEPS, WITHIN = 40, 1.05
#: Where the search for a size begins, by what is sized; largest sizes: beyond them it would be another machine.
STARTS = {"mass": 1e-3, "inertia": 1e-7, "stiffness": 1e2, "compliance": 1e-9, "change": 1e-3, "law": 1e-4}
MOST = {"change": 0.5}
LARGEST = 1e9


class TrueMachine:
    """A machine with its true values.

    Parameters
    ----------
    robot : Robot
        With the true values.
    points : array, shape (N, d)
        Poses.
    drives : float
        Factor of the stiffness of the belts, reducers or legs.
    """

    def __init__(self, robot: Robot, points: np.ndarray, drives: float = 1.0) -> None:
        self.robot, self.points, self.drives = robot, points, drives
        self.frame = float(robot.constants.get("frame_compliance.mass", 50.0))
        self.base = self.modes(())

    def modes(self, faults: Sequence[Fault], robot: Robot | None = None) -> list[TrueModes]:
        """Return the modes at all poses; a value of one axis is changed in the robot."""
        robot = robot or self.robot
        for fault in faults:
            if fault.form == "parameter":
                (path,) = fault.places
                robot = with_values(robot, {path: resolve(robot, path).value * (1 + fault.values["change"])})
        mechanism, q = robot.mechanism_name, robot.parameters
        machines = (assembled(mechanism, q, p, faults, frame=self.frame) for p in self.points)
        return [machine.modes(self.drives) for machine in machines]

    @cached_property
    def span(self) -> tuple[float, float]:
        """Lowest and highest frequency of its vibrations [Hz]."""
        each = [modes.frequencies[modes.rigid :] for modes in self.base]
        return float(min(one[0] for one in each)), float(max(one[-1] for one in each))

    def largest(self, fault: Drawn) -> float:
        """Return the largest size of a fault; of an extra mass, that of the platform or tool head."""
        if fault.sized_by != "mass" or fault.fault.places[0].startswith("motor"):
            return MOST.get(fault.sized_by, LARGEST)
        q = self.robot.parameters
        return float(q.toolhead_mass if hasattr(q, "toolhead_mass") else q.platform_mass)

    def partners(self, modes: Sequence[TrueModes]) -> dict[tuple[int, int], tuple[int, float]]:
        """Pair modes by their shapes with those of the machine without a fault.

        Returns
        -------
        dict
            By pose and mode without fault: the mode, and the change of ln f.
        """
        found_pairs = {}
        for pose, (plain, one) in enumerate(zip(self.base, modes, strict=True)):
            before, after = (np.array([m.shapes[name] for name in plain.coordinates]) for m in (plain, one))
            first = plain.rigid
            moving = plain.mass_matrix @ after
            # Without the fault a mode has size 1: an added one may look like another, but not be as large.
            size = np.sqrt(np.maximum(np.sum(after * moving, axis=0), 1e-30))
            likeness = np.abs(before[:, first:].T @ moving) / size * np.minimum(size, 1 / size)
            for i, k in zip(*linear_sum_assignment(-likeness), strict=True):
                if one.frequencies[k] > 0:
                    change = np.log(one.frequencies[k] / plain.frequencies[first + i])
                    found_pairs[pose, first + int(i)] = (int(k), float(change))
        return found_pairs

    def changes(self, modes: Sequence[TrueModes]) -> dict[tuple[int, int], float]:
        """Return the changes of ln f by pose and mode, for the modes that have a partner without the fault."""
        return {(pose, k): change for (pose, _), (k, change) in self.partners(modes).items()}


def sized(what: str, target: float, strength: Callable[[float], float], most: float = LARGEST) -> float:
    """Find the size whose strength is within `WITHIN` of a target; 0 if there is none.

    Parameters
    ----------
    what : str
        What is sized: a key of `STARTS`.
    target : float
    strength : callable
        By size.  A ValueError says that a size is beyond what the links can reach.
    most : float
        Largest size.
    """
    low, high, size = 0.0, 0.0, STARTS[what]
    for _ in range(STEPS):
        try:
            value = strength(size)
        except (ValueError, np.linalg.LinAlgError):
            value = np.inf
        if target / WITHIN <= value <= target * WITHIN:
            return size
        if value < target:
            low = size
            factor = min(max(target / max(value, 1e-12), 1.2), 30.0)
            size = min(size * factor, most) if not high else (low * high) ** 0.5
        else:
            high = size
            size = (low * high) ** 0.5 if low else size / 30.0
        if low >= most or (high and low and high / low < 1.01):
            break
    return 0.0


def with_values(robot: Robot, values: dict[str, float]) -> Robot:
    """Return a robot with other values, by path."""
    paths = [(resolve(robot, path), value) for path, value in values.items()]
    return change_quantities(robot, [(path, value - path.value) for path, value in paths])
