"""Priors of a robot's candidates from the caller: the plausible deviation of each value from the declared one."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from decimal import Decimal
from typing import NoReturn

import numpy as np

from pkmodes.core.base.errors import PkmodesError, nearest, shown
from pkmodes.core.robot.robot import Robot
from pkmodes.core.robot.units import NUMBER, QuantityError, base_units
from pkmodes.diagnosis.problem import Candidate, Parameter


def with_priors(
    robot: Robot,
    parameters: Sequence[Parameter],
    candidates: Sequence[Candidate],
    priors: Mapping[str, float | str],
) -> list[Candidate]:
    """Return the candidates with priors, given by candidate name.

    Raises
    ------
    PkmodesError
        If there is no such candidate, or a prior is not a standard deviation of its parameters.
    """
    if not isinstance(priors, Mapping):
        what = f"expected standard deviations by candidate, found {shown(priors)}"
        raise PkmodesError(what, "priors", 'write for example {"parameter:link.length": "1 mm"}')
    by_name = {parameter.name: parameter for parameter in parameters}
    with_sigma = {candidate.name: candidate for candidate in candidates}
    known = [candidate.name for candidate in candidates if candidate.claimable]
    for name, given in priors.items():
        if name not in known:
            _refuse(robot, name, known)
        sigmas = tuple(_deviation(given, by_name[each], name) for each in with_sigma[name].parameters)
        with_sigma[name] = replace(with_sigma[name], sigma=sigmas)
    return list(with_sigma.values())


def _refuse(robot: Robot, name: object, known: Sequence[str]) -> NoReturn:
    """Raise an error that says why there is no such candidate."""
    path = str(name).removeprefix("parameter:")
    quantity = robot.quantities.get(path)
    if quantity is not None and quantity.sigma is not None:
        state = "refitted anyway, within its sigma" if quantity.sigma else "known exactly"
        what = f"{path} is not a candidate: the robot file gives a sigma, so it is {state}"
        raise PkmodesError(what, "priors", "leave it out, or remove the sigma from the robot file")
    raise PkmodesError(f"there is no candidate {shown(name)} for a prior", "priors", nearest(name, known))


def _deviation(given: float | str, parameter: Parameter, name: str) -> float:
    """Return a standard deviation in the unit of a parameter, from a number, text with a unit, or a percentage.

    Raises
    ------
    PkmodesError
        If it is not above 0.
    """
    where, example = f"priors: {name}", f'"0.01 {parameter.unit}"' if parameter.unit != "1" else "0.01"
    remedy = f"write a number in {parameter.unit}, or text with a unit such as {example}"
    value = given
    if isinstance(given, str):
        number, unit = NUMBER.fullmatch(given), ""
        if number is not None:
            value, unit = float(number[1]), number[2]
        try:
            if number is None or not unit:
                raise QuantityError(f"{shown(given)} is not a number with a unit")
            if unit == "%":
                value = float(value) / 100.0 * abs(parameter.value)
            else:
                factor, powers = base_units(unit)
                own, same = base_units(parameter.unit)
                if powers != same:
                    raise QuantityError(f"{shown(given)} has the wrong dimension")
                value = float(Decimal(number[1]) * factor / own)
        except QuantityError as error:
            what = f"expected a standard deviation in {parameter.unit}: {error}"
            raise PkmodesError(what, where, remedy) from None
    if isinstance(value, bool) or not isinstance(value, int | float | np.integer | np.floating):
        raise PkmodesError(f"expected a standard deviation, found {shown(given)}", where, remedy)
    if not 0.0 < value < np.inf:
        raise PkmodesError(f"expected a standard deviation above 0, found {shown(given)}", where, remedy)
    return float(value)
