"""The springs of a machine: stiffness of each, and its elongation or twist per unit of each coordinate.

With the energy k (g . q)^2 / 2 of every spring, the sum over all springs is the elastic energy of the model, in small
displacements from the pose.  The springs of released joints are not among them: their elongation is the coordinate.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from sympy import Add, Expr, Symbol, diff

from pkmodes_derive.assembly.derived import Derived
from pkmodes_derive.assembly.placed import strains
from pkmodes_derive.machine import SMALL, Machine
from pkmodes_derive.parts import Reducer, Run
from pkmodes_description import Named

#: Prefixes to the name of a spring in the description of its stiffness or displacement.
DROPPED_PREFIXES = ("stiffness of ", SMALL, "small ")


@dataclass(frozen=True)
class Spring:
    """A spring, linear in small displacements.

    Attributes
    ----------
    named : Named
        Its name, the unit of its stiffness, and what it is.
    strain : tuple of sympy.Expr
        Elongation [m] or twist [rad] per unit of each coordinate.
    part : Run or Reducer or None
        None for a spring that an effect adds.
    """

    named: Named
    stiffness: Expr
    strain: tuple[Expr, ...]
    part: Run | Reducer | None = None


def springs(d: Derived) -> tuple[Spring, ...]:
    """Return the springs: belt spans, reducers, legs, then those that effects add."""
    machine, collected = d.machine, []
    for belt in machine.belts:
        for run in belt.runs:
            a, b = (machine.displacement(*end) for end in run.ends)
            collected.append(_spring(d, run.stiffness, a - b, run))
    for spring in machine.transmissions:
        twist = machine.displacement(spring.twist)
        collected.append(_spring(d, spring.stiffness, twist, spring))
    for energy, effect in zip(machine.elastic, machine.elastic_of, strict=True):
        collected += _springs_of_effect(d, energy, effect)
    for placed in machine.springs:
        (symbol,) = placed.stiffness.free_symbols
        what = machine.vocabulary[symbol]
        named = Named(_name(what.description), what.unit, f"spring of an effect: {what.description}")
        collected += [Spring(named, placed.stiffness, tuple(row)) for row in strains(machine, d.kin, placed)]
    return tuple(collected)


def _spring(d: Derived, stiffness: Symbol, elongation: Expr, part: Run | Reducer) -> Spring:
    quantity = d.machine.vocabulary[stiffness]
    return Spring(
        Named(_name(quantity.description), quantity.unit, quantity.description),
        stiffness,
        _strain(d, elongation),
        part,
    )


def _springs_of_effect(d: Derived, energy: Expr, effect: str) -> list[Spring]:
    """Return the springs of an energy, which is a quadratic form: one for each of its completed squares."""
    vocabulary, collected = d.machine.vocabulary, []
    for symbol, stiffness, elongation in _squares(energy, _displacements_in(d.machine, energy)):
        what = vocabulary[symbol]
        unit = "N m/rad" if what.unit == "rad" else "N/m"
        name = f"{effect.replace('_', ' ')}: {_name(what.description)}"
        collected.append(
            Spring(Named(name, unit, f"spring of the effect {effect}"), stiffness, _strain(d, elongation))
        )
    return collected


def _displacements_in(machine: Machine, energy: Expr) -> list[Symbol]:
    """Return the displacements in an energy: one of a pair of rotors may turn, their common wind-up comes last."""
    return [symbol for symbol in (*machine.small, *machine.delta_p) if symbol in energy.free_symbols]


def _squares(energy: Expr, symbols: Sequence[Symbol]) -> list[tuple[Symbol, Expr, Expr]]:
    """Return (symbol, k, e) with energy = sum of k e^2 / 2: the square is completed in one symbol after the other."""
    squares, remainder = [], energy
    for symbol in symbols:
        stiffness = diff(remainder, symbol, symbol)
        if stiffness != 0:
            elongation = Add(*(diff(remainder, symbol, other) / stiffness * other for other in symbols))
            squares.append((symbol, stiffness, elongation))
            remainder = (remainder - stiffness * elongation**2 / 2).expand()
    return squares


def _strain(d: Derived, elongation: Expr) -> tuple[Expr, ...]:
    return tuple(d.kin.chain.derivative(elongation, q, d.hold) for q in d.machine.small)


def _name(description: str) -> str:
    """Return the short name in a description: "stiffness of span 1 of belt 2 (...)" is that of span 1 of belt 2."""
    for words in DROPPED_PREFIXES:
        description = description.removeprefix(words)
    return description.split(" (")[0].split(", with")[0].replace(" from the pose, component ", " along ")
