"""What an effect is: one physical cause that the base model leaves out, null when its parameters are zero.

A *term* adds energy, or changes a stiffness.  A *released coordinate* frees a joint that the base model
locks: its parameter is a compliance, and the spring of that joint, energy q^2 / (2 c), is the same for all.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from sympy import Symbol


@dataclass(frozen=True)
class EffectParameter:
    """A parameter of an effect; its null value is 0.

    Attributes
    ----------
    name : str
        As in the robot file, ``[effects.<effect>] <name> = ...``.
    unit : str
        SI unit.
    description : str
        A noun phrase.
    symbol, latex : str
        How it is named in formulas.
    greater_than : float or None
        Physical bound: None when any value is meaningful; the null value itself is always allowed.
    fitted : bool
        Whether it can be estimated from measurements; a declared constant of the machine is not.
    """

    name: str
    unit: str
    description: str
    symbol: str
    latex: str
    greater_than: float | None = 0.0
    fitted: bool = True


@dataclass(frozen=True)
class Coordinate:
    """A released coordinate, zero in the reference configuration, and its rate."""

    position: Symbol
    rate: Symbol


@dataclass(frozen=True)
class Effect:
    """One effect; a module of `pkmodes_derive.effects` defines it as ``EFFECT``.

    Attributes
    ----------
    name : str
        As in the robot file.
    sentence : str
        What it says about the machine, for a person.
    parameters : tuple of EffectParameter
        A released effect has a ``compliance``, which the spring of its coordinates takes.
    apply : callable
        ``apply(machine, parameters, released)`` adds the effect to a machine: parameters by name, the released
        coordinates in order.
    coordinates : tuple of str
        Names of the released coordinates; empty for a term.
    coordinate_unit, coordinate_description : str
        Unit and noun phrase of the released coordinates.
    order : int
        Where its coordinates stand among those of other effects.
    grounds : bool
        Whether it ties the platform to ground, so that no rigid-body mode is left.
    """

    name: str
    sentence: str
    parameters: tuple[EffectParameter, ...]
    apply: Callable[[Any, Mapping[str, Symbol], tuple[Coordinate, ...]], None]
    coordinates: tuple[str, ...] = ()
    coordinate_unit: str = ""
    coordinate_description: str = ""
    order: int = 0
    grounds: bool = False
