"""Motion of the places of terms, and springs between them."""

from __future__ import annotations

from collections.abc import Sequence

from sympy import Add, Expr, Integer, Rational, Symbol, default_sort_key

from pkmodes_derive.assembly import energy
from pkmodes_derive.assembly.kinematics import Kinematics
from pkmodes_derive.machine import Machine
from pkmodes_derive.parts import PlacedSpring
from pkmodes_derive.terms.places import Place
from pkmodes_derive.vocabulary import AXES

Row = list[Expr]
HALF = Rational(1, 2)


def motion(machine: Machine, kin: Kinematics, place: Place, direction: str) -> Row:
    """Return the displacement of a place along a direction per unit of every coordinate, at the pose.

    Parameters
    ----------
    direction : str
        One of the place's, or empty for its one freedom.
    """
    rates = machine.rates
    if place.coordinate is not None:
        own_rate = machine.velocities[machine.coordinates.index(place.coordinate)]
        return [Integer(rate == own_rate) for rate in rates]
    if direction.startswith("r"):
        assert machine.turning is not None
        w = machine.turning.rates[machine.turning.axes.index(direction[1:])]
        return _per_rate(kin, w, rates)
    velocity = energy.velocity(machine, place.position) if place.position else _frame_velocity(machine)
    if not direction:
        terms = [(rate, energy.scalar(machine, along, tuple(place.along))) for rate, along in velocity]
    else:
        terms = [(rate, along[AXES.index(direction)]) for rate, along in velocity]
    rows = [
        [factor * entry for entry in _per_rate(kin, rate, rates)] for rate, factor in terms if factor != 0
    ]
    at_pose = kin.reference
    return [Add(*column).xreplace(at_pose) for column in zip(*rows, strict=True)] or [Integer(0)] * len(rates)


def _frame_velocity(machine: Machine) -> energy.Velocity:
    return [(rate, e) for rate, e in zip(machine.frame_rate, energy.BASIS, strict=True) if rate != 0]


def _per_rate(kin: Kinematics, velocity: Expr, rates: Sequence[Symbol]) -> Row:
    return [kin.chain.derivative(velocity, rate) for rate in rates]


def energy_of_springs(machine: Machine, kin: Kinematics) -> tuple[Expr, tuple[Symbol, ...]]:
    """Return the energy of the springs of effects between places, and values that displacements leave unchanged."""
    V, symbols = [], set[Symbol]()
    for spring in machine.springs:
        for row in strains(machine, kin, spring):
            symbols.update(*(entry.free_symbols for entry in row))
            elongation = Add(*(entry * q for entry, q in zip(row, machine.small, strict=True)))
            V.append(HALF * spring.stiffness * elongation**2)
    return Add(*V), tuple(sorted(symbols, key=default_sort_key))


def strains(machine: Machine, kin: Kinematics, spring: PlacedSpring) -> list[Row]:
    """Return the elongation or twist of a spring in each of its directions, per unit of every coordinate."""
    rows = []
    for direction in spring.directions:
        ends = [motion(machine, kin, place, direction) for place in spring.places]
        rows.append(ends[0] if len(ends) == 1 else [a - b for a, b in zip(*ends, strict=True)])
    return rows
