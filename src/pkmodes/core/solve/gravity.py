"""The part of K that is due to gravity, which the library evaluates as a derivative: K is linear in gravity."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.compiled.lanes import Terms, flattened
from pkmodes.core.solve.at_poses import RobotAtPoses
from pkmodes.core.solve.solver import Solver
from pkmodes.core.system.evaluation import ExtendedSystem

Array = NDArray[np.float64]


def gravitational_stiffness(solver: Solver, system: ExtendedSystem, p: Array) -> Array:
    """Return K_g at poses that can be evaluated, (N, n, n): separately, since K_el + K_g has few of its digits.

    - solver: of the robot; NumPy evaluates where it does not differentiate
    - system: the robot with free motors
    - p: (N, d)
    """
    parameters, gravity = system.parameters, np.asarray(system.parameters.gravity, dtype=float)
    index_of_gravity = flattened(parameters[: parameters._fields.index("gravity")]).size
    along_gravity = Terms(
        first=np.array([0, gravity.size], dtype=np.int32),
        places=np.arange(index_of_gravity, index_of_gravity + gravity.size, dtype=np.int32),
        weights=gravity,
        effects=flattened(system.effects),
        all_coordinates=False,
        locked_joints=False,
    )
    state = RobotAtPoses(system, np.ascontiguousarray(p), "", {})
    rates = solver.along(state, None, along_gravity, ["stiffness_rates"])
    if rates is not None:
        return rates["stiffness_rates"][:, 0]
    _, _, K_g = system.evaluate_function("extended_matrices", p)
    return system.free_part(system.in_basis(K_g))
