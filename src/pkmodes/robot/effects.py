"""Effects as a robot file declares them, read with the catalogue that the generated model carries.

Nothing here lists the effects: names, parameters, units and bounds come with the generated code.
"""

from __future__ import annotations

import difflib
from collections.abc import Mapping
from typing import Any, NamedTuple

from pydantic_core import PydanticCustomError

from pkmodes.errors import PkmodesError, shown
from pkmodes.robot import schema
from pkmodes.robot.units import DIMENSIONS, Quantity, article
from pkmodes_generated.linear_delta import extended


class Parameter(NamedTuple):
    """A parameter of an effect, as the generated model describes it."""

    name: str
    unit: str
    description: str
    greater_than: float
    fitted: bool


class Effect(NamedTuple):
    """An effect, as the generated model describes it."""

    name: str
    sentence: str
    grounds: bool
    coordinates: tuple[str, ...]
    parameters: tuple[Parameter, ...]


CATALOGUE: dict[str, Effect] = {
    name: Effect(name, sentence, grounds, coordinates, tuple(Parameter(*p) for p in parameters))
    for name, sentence, grounds, coordinates, parameters in extended.EFFECTS
}


def read_effects(
    tables: Mapping[str, Any], defaults: Mapping[str, Quantity], source: str, problems: list[PkmodesError]
) -> dict[str, Quantity]:
    """Read the tables ``[effects.<name>]``.

    Parameters
    ----------
    tables : mapping
        The raw tables by effect.
    defaults : mapping of str to Quantity
        Values of parameters that another table of the file declares, by ``<effect>.<parameter>``.
    source : str
        The robot file, for messages.
    problems : list
        What is wrong is added to it.

    Returns
    -------
    dict
        Quantities by ``<effect>.<parameter>``, for the effects that the file names.
    """
    found: dict[str, Quantity] = {}
    for name, table in tables.items():
        where = f"{source}: effects.{name if name in CATALOGUE else shown(name)}"
        if name not in CATALOGUE:
            problems.append(PkmodesError(f"unknown effect {shown(name)}", where, _nearest(name, CATALOGUE)))
        elif not isinstance(table, dict):
            remedy = f"write a table [effects.{name}]"
            problems.append(PkmodesError(f"expected a table, found {shown(table)}", where, remedy))
        else:
            _read_effect(CATALOGUE[name], table, defaults, where, problems, found)
    return found


def _read_effect(
    effect: Effect,
    table: Mapping[str, Any],
    defaults: Mapping[str, Quantity],
    where: str,
    problems: list[PkmodesError],
    found: dict[str, Quantity],
) -> None:
    known = {parameter.name: parameter for parameter in effect.parameters}
    for key in table:
        if key not in known:
            problems.append(PkmodesError(f"unknown parameter {shown(key)}", where, _nearest(key, known)))
    grouped = len(known) > 1 and all(parameter.unit == "1" for parameter in effect.parameters)
    for parameter in effect.parameters:
        path = f"{effect.name}.{parameter.name}"
        place = f"{where}.{parameter.name}"
        if parameter.name not in table:
            if path in defaults:
                found[path] = defaults[path]
            elif grouped:  # of a group of relative changes, those that are not given are zero
                found[path] = Quantity(0.0, parameter.unit)
            else:
                example = DIMENSIONS[_dimension(parameter.unit)][1]
                what = f"the parameter {parameter.name} is missing"
                problems.append(PkmodesError(what, place, f'add it, such as {parameter.name} = "{example}"'))
            continue
        try:
            found[path] = _value(parameter, table[parameter.name])
        except PydanticCustomError as error:
            remedy = (error.context or {})["remedy"]
            problems.append(PkmodesError(error.message(), place, remedy))


def _value(parameter: Parameter, raw: Any) -> Quantity:
    """Zero is the null value and always allowed; otherwise the physical bound holds."""
    dimension = _dimension(parameter.unit)
    quantity = schema.quantity(raw, dimension)
    if quantity.value != 0.0 and quantity.value <= parameter.greater_than:
        bound = f"{parameter.greater_than:g}" + ("" if parameter.unit == "1" else f" {parameter.unit}")
        raise schema.refused(
            f"expected {article(dimension)} greater than {bound}, or 0 for none, found {shown(raw)}",
            "check the sign and the number",
        )
    return quantity


def _dimension(unit: str) -> str:
    """Name of the dimension that has this SI unit; a spring's name where two have it."""
    names = [name for name, (si_unit, _) in DIMENSIONS.items() if si_unit == unit]
    return names[-1]


def _nearest(name: str, known: Mapping[str, object]) -> str:
    nearest = difflib.get_close_matches(name, known, n=1, cutoff=0.5)
    return f'did you mean "{nearest[0]}"?' if nearest else f"known are: {', '.join(known)}"
