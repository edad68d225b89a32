"""Losses of a robot, for the diagnosis: those that it may have, and the damping ratios that each would give.

Losses are the dissipating effects of the catalogue and the damping ratio common to all modes.  One that the file
declares without a standard deviation, or an effect that it does not declare, may be suspected.  A common ratio that
the file does not declare is not a cause, because it names no joint; but it competes with the causes.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.linalg.damping import damping_ratios
from pkmodes.core.mechanism.described import DAMPING_RATIO
from pkmodes.core.robot.layout import EFFECTS
from pkmodes.core.robot.robot import Robot
from pkmodes.core.support.covariance import Prior, priors_of
from pkmodes.core.system.dissipation import Dissipation
from pkmodes.core.system.evaluation import ExtendedSystem
from pkmodes.loop.diagnosis.problem import Loss, Parameter
from pkmodes.loop.updating.candidates import PREFIX, refuse_declared
from pkmodes.loop.updating.predictions import SolvedRobots

Array = NDArray[np.float64]
#: Name of the common damping ratio as a candidate.
RATIO = f"{PREFIX}{DAMPING_RATIO}"
#: Value at which an effect is evaluated: a power of two below all bounds, which makes scaling exact.
EVALUATION_VALUE = 0.5


def losses_of(robot: Robot, chosen: Sequence[str] | None = None) -> tuple[Loss, ...]:
    """Return the losses of a robot; empty if none is suspected.

    - chosen: names of candidates, as for `pkmodes.loop.updating.candidates.suspects`

    Raises PkmodesError if a chosen loss has a sigma, so that it is not a candidate.
    """
    names = None if chosen is None else set(chosen)
    losses, priors = [_common_ratio(robot, names)], priors_of(robot)
    for effect in robot.mechanism.effects.values():
        if not effect.dissipates:
            continue
        (parameter,) = effect.fitted
        path = f"{EFFECTS}.{effect.name}.{parameter.name}"
        quantity = robot.quantities.get(path)
        sigma = None if quantity is None else quantity.sigma
        if names is not None and effect.name in names:
            refuse_declared(f"the effect {effect.name}", [sigma])
        suspected = names is None or bool({effect.name, "effects"} & names)
        upper, prior = 1.0 if parameter.unit == "1" else np.inf, priors.get(path, Prior())
        losses.append(
            Loss(
                Parameter(
                    path,
                    0.0 if quantity is None else quantity.value,
                    parameter.unit.replace(" ", "*"),
                    prior.sigma,
                    0.0,
                    upper,
                    correlated=prior.correlated,
                ),
                effect.name if suspected and sigma is None else "",
                effect.sentence,
                quantity is not None,
            )
        )
    return tuple(losses) if any(loss.candidate and loss.claimable for loss in losses) else ()


def without_losses(robot: Robot, chosen: Sequence[str] | None) -> Sequence[str] | None:
    """Return chosen names of candidates without those of losses."""
    if chosen is None or isinstance(chosen, str):
        return chosen
    return [name for name in chosen if not is_loss(robot, name)]


def is_loss(robot: Robot, name: object) -> bool:
    """Return whether a candidate's name is that of a loss."""
    effects = robot.mechanism.effects
    return name == RATIO or (isinstance(name, str) and name in effects and effects[name].dissipates)


def _common_ratio(robot: Robot, names: set[str] | None) -> Loss:
    """Return the damping ratio that all modes have in common."""
    quantity = robot.quantities.get(DAMPING_RATIO)
    sigma = None if quantity is None else quantity.sigma
    requested = names is not None and RATIO in names
    if requested:
        refuse_declared(DAMPING_RATIO, [sigma])
    suspected = (
        names is None or bool({RATIO, "parameters"} & names) or (quantity is None and "effects" in names)
    )
    prior = priors_of(robot).get(DAMPING_RATIO, Prior())
    declared = quantity is not None
    return Loss(
        Parameter(
            DAMPING_RATIO, robot.damping_ratio, "1", prior.sigma, 0.0, 1.0, correlated=prior.correlated
        ),
        RATIO if suspected and sigma is None else "",
        f"the declared value of {DAMPING_RATIO} is wrong"
        if declared
        else "every mode has the same damping ratio",
        declared,
        effect=False,
        claimable=declared or requested,
    )


def rates_of_losses(solved: SolvedRobots, losses: Sequence[Loss]) -> Array:
    """Return the damping ratio of each mode per unit of each loss, (N, m, losses); NaN for rigid modes."""
    rigid, count = solved.system.rigid_modes, len(solved.points) // len(solved.robots)
    rates = np.full((*solved.eigenvalues.shape, len(losses)), np.nan)
    size = solved.system.joints.shape[-1]
    for b, robot in enumerate(solved.robots):
        rows = slice(b * count, (b + 1) * count)
        modes = solved.eigenvalues[rows], solved.channels[rows, :, :size]
        catalogue = robot.mechanism.effects
        conservative = {
            name: value
            for name, value in robot.effects.items()
            if not catalogue[name.partition(".")[0]].dissipates
        }
        for j, loss in enumerate(losses):
            if not loss.effect:
                rates[rows, rigid:, j] = 1.0
                continue
            # Only this effect dissipates.
            robot_with_loss = replace(
                robot,
                effects={**conservative, loss.parameter.name.removeprefix(f"{EFFECTS}."): EVALUATION_VALUE},
            )
            viscous, loss_matrix = Dissipation(
                robot_with_loss, ExtendedSystem.of(robot_with_loss)
            ).model_matrices(solved.points[rows])
            rates[rows, :, j] = damping_ratios(*modes, viscous, loss_matrix, 0.0, rigid) / EVALUATION_VALUE
    return rates
