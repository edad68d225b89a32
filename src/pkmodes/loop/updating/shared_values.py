"""Values of a machine that two states share although the robot file has them wrong, and values that may change.

Masses, inertias and stiffnesses of each axis differ by some per cent from what a file declares.  They are fitted to
the trusted state within a prior, like the values that the file declares as uncertain: the effect of a change on a
mode depends on its shape, and the shapes of close modes depend on such differences.

Masses and stiffnesses change in use.  Lengths, radii and gear ratios change only if a part is exchanged or moved.
"""

from __future__ import annotations

from dataclasses import replace

from pkmodes.core.robot.layout import items, items_by_path, overrides_by_path
from pkmodes.core.robot.parameter_groups import groups_by_path
from pkmodes.core.robot.robot import Robot
from pkmodes.loop.diagnosis.problem import Candidate, Parameter
from pkmodes.loop.sensitivity.paths import ParameterPath, paths, resolve
from pkmodes.loop.updating.candidates import PREFIX
from pkmodes.loop.updating.frame import PREFIX as OF_MEASUREMENT

#: Relative standard deviation of a declared mass, inertia or stiffness of an axis.
RELATIVE_SIGMA = 0.03
#: Dimensions of values that belong to a part, which do not change in use.
PART_DIMENSIONS = ("length", "angle", "acceleration", "number", "moment of inertia")
#: Dimensions of values that may be wrong by a few per cent in a robot file.
UNCERTAIN_DIMENSIONS = ("mass", "moment of inertia")
STIFFNESS = "stiffness"
#: Prefix of the deviations.
SHARED_PREFIX = "shared."
#: Prior deviation between the frames of two campaigns on one machine, relative to that between a campaign and the
#: robot file.
FRAME_SIGMA_FRACTION = 0.025


def axis_deviations(robot: Robot) -> tuple[list[Parameter], dict[str, ParameterPath]]:
    """Return the deviations of declared values from those of the machine, of each axis, and the path of each."""
    all_paths, parameters, parameter_paths = set(paths(robot)), [], {}
    shared = overrides_by_path(robot.mechanism)
    for item in items(robot.mechanism):
        key, dimension = item.key, item.key.dimension
        may_be_wrong = dimension in UNCERTAIN_DIMENSIONS or dimension.endswith(STIFFNESS)
        if not (may_be_wrong and key.kind == "quantity" and key.field):
            continue
        if item.path in shared or item.path not in all_paths:
            continue
        quantities = [robot.quantities[path] for path in (item.path, item.shared) if path in robot.quantities]
        path = resolve(robot, item.path)
        if path.value <= 0.0 or any(quantity.sigma == 0.0 for quantity in quantities[:1]):
            continue
        name = f"{SHARED_PREFIX}{item.path}"
        lower = -0.5 * path.value
        parameters.append(
            Parameter(name, 0.0, path.unit, RELATIVE_SIGMA * path.value, lower=lower, upper=path.value)
        )
        parameter_paths[name] = ParameterPath(name, 0.0, path.unit, path.weights)
    return parameters, parameter_paths


def changes_in_use(robot: Robot, candidate: Candidate) -> bool:
    """Return whether something may change while the parts of a machine stay the same and where they are."""
    if not candidate.name.startswith(PREFIX):
        return True
    item_at, groups = items_by_path(robot.mechanism), groups_by_path(robot.mechanism)
    path = candidate.name.removeprefix(PREFIX)
    item = item_at.get(path) or item_at.get(path.rpartition(".")[0])
    return path not in groups and item is not None and item.key.dimension not in PART_DIMENSIONS


def with_prior_of_one_machine(candidate: Candidate) -> Candidate:
    """Return a candidate with the prior that it has between two campaigns on one machine."""
    if not candidate.name.startswith(OF_MEASUREMENT) or candidate.sigma is None:
        return candidate
    return replace(candidate, sigma=tuple(FRAME_SIGMA_FRACTION * sigma for sigma in candidate.sigma))
