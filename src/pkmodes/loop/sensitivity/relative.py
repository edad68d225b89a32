"""Relative sensitivities d ln f / d ln p: the quantities for which a per cent is meaningful, and its effect."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.core.mechanism.regular import reach_bound
from pkmodes.core.model import Model
from pkmodes.core.robot.layout import effect_parameters, items
from pkmodes.core.robot.parameter_groups import group_value, group_weights, groups_by_path
from pkmodes.core.robot.robot import Robot
from pkmodes.loop.sensitivity.alike import EquivalentParameters, equivalent_parameters
from pkmodes.loop.sensitivity.paths import ParameterPath, paths
from pkmodes.loop.sensitivity.sensitivities import ResolvedPaths, sensitivities_at

Array = NDArray[np.float64]
#: Poses around a given one at which parameters are compared, and how far they lie from it: a fraction of the robot's
#: reach, or as many rad.  What is equal in a neighbourhood is equal everywhere, since frequencies are analytic in the
#: pose; what is equal by the symmetry of one pose differs there by about this fraction.
NEIGHBOUR_COUNT, NEIGHBOUR_DISTANCE = 12, 0.01
SEED = 20220101
#: Modes whose eigenvalues differ by less than this fraction are repeated, as for `pkmodes.Model.sensitivities`.
REPEATED_FRACTION = 1e-6


def scalable_quantities(robot: Robot) -> list[str]:
    """Return the quantities of a robot for which a per cent is meaningful and changes frequencies.

    These are its quantities that are not zero, and wholes such as ``axis.span``.  Components of vectors are left
    out, since a per cent of a coordinate depends on where the origin lies; so is what no frequency depends on:
    damping ratios, what only dissipates, and shared values that every entry overrides.
    """
    mechanism = robot.mechanism
    single = {
        number.path for item in items(mechanism) if item.key.kind == "quantity" for number in item.numbers
    }
    conservative = {
        path for path in effect_parameters(mechanism) if path.split(".")[1] in mechanism.conservative_effects
    }
    declared, varying = robot.quantities, set(paths(robot))
    nonzero = [path for path in declared if path in varying and _is_scalable(declared[path].value)]
    effects = [path for path in nonzero if path in conservative and path not in single]
    # A whole with a vector of zero has no direction in which it could change.
    group_paths = [
        path
        for path, group in groups_by_path(mechanism).items()
        if group_weights(robot, group) and _is_scalable(group_value(robot, group))
    ]
    return [*(path for path in nonzero if path in single), *effects, *group_paths]


def _is_scalable(value: float) -> bool:
    return value != 0.0 and bool(np.isfinite(value))


def rates_of(
    model: Model, poses: ArrayLike, paths: Sequence[str | ParameterPath], drives: str, on_error: str
) -> Array:
    """Return the derivatives of all frequencies, (..., T, m) [Hz per unit]: see `pkmodes.Model.sensitivities`."""
    derivatives = sensitivities_at(
        model,
        poses,
        paths,
        close=REPEATED_FRACTION,
        on_error="nan" if on_error == "nan" else "raise",
        fields=("frequencies",),
        drives=drives,
        threads=1,
    )
    return derivatives.frequencies


def relative_of(rates: Array, values: Array, frequencies: Array) -> Array:
    """Return d ln f / d ln p, NaN where the value or the frequency is 0.

    - rates: (..., T, m)
    - values: (T,)
    - frequencies: (..., m)
    """
    nonzero = np.where(values == 0.0, np.nan, values)
    sizes = np.where(frequencies == 0.0, np.nan, frequencies)
    relative: Array = rates * nonzero[:, None] / sizes[..., None, :]
    return relative


def equivalent_around(
    model: Model, pose: ArrayLike, paths: list[str], drives: str
) -> list[EquivalentParameters]:
    """Return which quantities act as one, whatever the pose.

    - pose: in SI units, (d,); what is compared lies around it
    - paths: quantities; those that are zero act like no other

    They are given by their indices in `paths`.
    """
    robot = model.robot
    distances = np.array(
        [
            NEIGHBOUR_DISTANCE
            * (reach_bound(robot.mechanism, robot.parameters) if component.unit == "m" else 1.0)
            for component in robot.mechanism.pose
        ]
    )
    rng = np.random.default_rng(SEED)
    poses = np.asarray(pose, dtype=float) + distances * rng.uniform(
        -1.0, 1.0, (NEIGHBOUR_COUNT, len(distances))
    )
    values = np.array([path.value for path in ResolvedPaths(robot, tuple(paths), drives).paths])
    rigid = model.solved(drives).rigid_modes
    frequencies = model.frequencies(poses, "nan", drives=drives)
    rates = rates_of(model, poses, paths, drives, "nan")
    relative = relative_of(rates, values, frequencies)[..., rigid:]
    relative[:, values == 0.0] = 0.0
    return equivalent_parameters(relative)
