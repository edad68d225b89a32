"""Read the effects that a robot file declares, using the mechanism's description of the effects that apply to it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from pkmodes.core.base.errors import PkmodesError, nearest, shown
from pkmodes.core.mechanism import registry
from pkmodes.core.mechanism.described import Mechanism
from pkmodes.core.robot import schema
from pkmodes.core.robot.layout import EFFECTS
from pkmodes.core.robot.units import DIMENSIONS, Quantity, article
from pkmodes_description import Effect, EffectParameter


def read_effects(
    mechanism: Mechanism,
    tables: Mapping[str, Any],
    lent: Mapping[str, Quantity],
    source: str,
    problems: list[PkmodesError],
) -> dict[str, Quantity]:
    """Read the tables ``[effects.<name>]``.

    Parameters
    ----------
    tables : mapping
        The raw tables by effect.
    lent : mapping of str to Quantity
        Parameter values declared in another table of the file, by path (``effects.<effect>.<parameter>``).
    source : str
        The robot file, for messages.
    problems : list
        Problems are appended to it.

    Returns
    -------
    dict
        Quantities by path, for the effects in the file.
    """
    quantities: dict[str, Quantity] = {}
    for name, table in tables.items():
        where = f"{source}: {EFFECTS}.{name}"
        if name not in mechanism.effects:
            problems.append(_not_there(mechanism, name, source))
        elif not isinstance(table, dict):
            remedy = f"write a table [{EFFECTS}.{name}]"
            problems.append(PkmodesError(f"expected a table, found {shown(table)}", where, remedy))
        else:
            _read_effect(mechanism.effects[name], table, lent, where, problems, quantities)
    return quantities


def _not_there(mechanism: Mechanism, name: str, source: str) -> PkmodesError:
    where = f"{source}: {EFFECTS}.{shown(name)}"
    if any(name in registry.mechanism(other).effects for other in registry.names()):
        what = f"the effect {name} does not apply to the mechanism {mechanism.name}"
        return PkmodesError(what, where, f"effects that apply: {', '.join(mechanism.effects)}")
    return PkmodesError(f"unknown effect {shown(name)}", where, nearest(name, mechanism.effects))


def _read_effect(
    effect: Effect,
    table: Mapping[str, Any],
    lent: Mapping[str, Quantity],
    where: str,
    problems: list[PkmodesError],
    quantities: dict[str, Quantity],
) -> None:
    known = [parameter.name for parameter in effect.parameters]
    for key in table:
        if key not in known:
            problems.append(PkmodesError(f"unknown parameter {shown(key)}", where, nearest(key, known)))
    own = [name for name in known if f"{EFFECTS}.{effect.name}.{name}" not in lent]
    for parameter in effect.parameters:
        path = f"{EFFECTS}.{effect.name}.{parameter.name}"
        place = f"{where}.{parameter.name}"
        if parameter.name in table:
            try:
                quantities[path] = _value(parameter, table[parameter.name])
            except schema.RefusedError as error:
                problems.append(PkmodesError(error.what, place, error.remedy))
        elif path in lent:
            quantities[path] = lent[path]
        elif len(own) > 1:  # if an effect has several parameters, missing ones are zero
            quantities[path] = Quantity(0.0, parameter.unit)
        else:
            example = DIMENSIONS[_dimension(parameter.unit)][1]
            what = f"the parameter {parameter.name} is missing"
            problems.append(PkmodesError(what, place, f'add it, for example {parameter.name} = "{example}"'))


def _value(parameter: EffectParameter, raw: Any) -> Quantity:
    """Read a parameter; zero is the null value and always allowed, otherwise the physical bounds apply."""
    dimension = _dimension(parameter.unit)
    quantity = schema.quantity(raw, dimension)
    least = parameter.greater_than
    if least is not None and quantity.value != 0.0 and quantity.value <= least:
        bound = f"{least:g}" + ("" if parameter.unit == "1" else f" {parameter.unit}")
        raise schema.RefusedError(
            f"expected {article(dimension)} greater than {bound}, or 0 for no effect, found {shown(raw)}",
            "check the sign and the number",
        )
    if parameter.less_than is not None and quantity.value >= parameter.less_than:
        bound = f"{parameter.less_than:g}" + ("" if parameter.unit == "1" else f" {parameter.unit}")
        what = f"expected {article(dimension)} less than {bound}, found {shown(raw)}"
        raise schema.RefusedError(what, "check the number and its unit")
    return quantity


def _dimension(unit: str) -> str:
    """Return the dimension with this SI unit; of two, the one that describes a spring."""
    names = [name for name, (si_unit, _) in DIMENSIONS.items() if si_unit == unit]
    return names[-1]
