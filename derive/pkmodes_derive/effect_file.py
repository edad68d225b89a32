"""An effect of one's own: a Python file with ``EFFECT``, as in the catalogue, added to one mechanism.

Every mistake in it is reported as what, where (file and line) and what to do, never as a traceback.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import fields, is_dataclass

from sympy import Expr, Integer, nan, oo, zoo

from pkmodes_derive.definition import DefinitionError, run
from pkmodes_derive.effect import Effect
from pkmodes_derive.effects import catalogue
from pkmodes_derive.machine import Machine
from pkmodes_derive.terms.places import places

#: Files of effects in the folder of a mechanism.
PREFIX = "effect_"


def file_name(effect: Effect) -> str:
    """Return the name of the file of an effect in the folder of a mechanism."""
    return f"{PREFIX}{effect.name}.py"


def read(text: str, place: str) -> Effect:
    """Run the text of an effect's file and return the effect.

    Parameters
    ----------
    place : str
        The file, for messages.

    Raises
    ------
    DefinitionError
        If it is not valid Python, raises an exception, has no ``EFFECT``, or one with a name that is taken.
    """
    effect = getattr(run("effect", text, place), "EFFECT", None)
    if not isinstance(effect, Effect):
        what = "EFFECT is missing" if effect is None else "EFFECT is not an Effect"
        remedy = "write EFFECT = Effect(...), as in docs/how-to/adding-an-effect.md, or give a file of --save-effect"
        raise DefinitionError(what, place, remedy)
    if not isinstance(effect.name, str) or not re.fullmatch(r"[a-z][a-z0-9_]*", effect.name):
        what = f"{effect.name!r} is not a valid name for an effect"
        raise DefinitionError(what, place, "use lower-case letters, digits and underscores")
    if any(effect.name == known_effect.name for known_effect in catalogue()):
        what = f'"{effect.name}" is an effect of the catalogue already'
        raise DefinitionError(what, place, "give the effect another name")
    return effect


def check(effect: Effect, plain_machine: Machine, with_effect: Machine, place: str) -> None:
    """Refuse an effect that does not apply to a machine, or that changes it where its parameters are zero.

    Parameters
    ----------
    plain_machine : Machine
        Without effects.
    with_effect : Machine
        With this effect alone.
    place : str
        Its file, for messages.

    Raises
    ------
    DefinitionError
    """
    if not effect.parts(plain_machine):
        known = ", ".join(places(plain_machine))
        what = f"the effect {effect.name} acts on parts that {plain_machine.name} does not have"
        raise DefinitionError(what, place, f"its bodies are {known}: act on one of these")
    zero = {s: Integer(0) for group in with_effect.effect_fields for s in group.symbols}
    released = {s for c in with_effect.released for s in (c.position, c.rate)}
    if not zero:
        raise DefinitionError(
            f"the effect {effect.name} has no parameter", place, "give it one, null at 0, with its unit"
        )
    plain_expressions = dict(_expressions(plain_machine))
    for name, value in _expressions(with_effect):
        plain_value, at_zero = plain_expressions.get(name, Integer(0)), value.xreplace(zero)
        if value == plain_value:
            continue
        if at_zero.has(nan, oo, -oo, zoo):
            what = f"the effect {effect.name} is not defined where its parameters are 0"
            raise DefinitionError(what, place, "write it so that nothing is divided by a parameter")
        remainder = (at_zero - plain_value).xreplace(dict.fromkeys(released, Integer(0)))
        if remainder != 0 and remainder.expand() != 0:
            what = f"the effect {effect.name} changes the machine where its parameters are 0: by {remainder}"
            raise DefinitionError(what, place, "an effect is null at 0: multiply what it adds by a parameter")
        for symbol in zero:
            rate = value.diff(symbol).xreplace(zero)
            if rate.has(nan, oo, -oo, zoo):
                what = f"the effect {effect.name} has no derivative with respect to {symbol} at 0"
                remedy = "let what it adds be proportional to a parameter near 0: no root, no absolute value"
                raise DefinitionError(what, place, remedy)


def _expressions(machine: Machine) -> Iterator[tuple[tuple[str, ...], Expr]]:
    """Yield the expressions of all parts and energies of a machine, each with its place."""
    parts_by_name: dict[str, Sequence[object]] = {
        name: getattr(machine, name)
        for name in (
            "points",
            "loads",
            "rods",
            "arms",
            "rotors",
            "drives",
            "belts",
            "reducers",
            "leg_springs",
            "springs",
        )
    }
    for name, parts in parts_by_name.items():
        for k, part in enumerate(parts):
            assert is_dataclass(part)
            for field in fields(part):
                value = getattr(part, field.name)
                if isinstance(value, Expr):
                    yield (name, str(k), field.name), value
    for name in ("kinetic", "elastic", "dissipation"):
        for k, energy in enumerate(getattr(machine, name)):
            yield (name, str(k)), energy
