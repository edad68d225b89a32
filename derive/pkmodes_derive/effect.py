"""Effects: each is one physical cause that the base model omits, and has no influence when its parameters are zero.

A *term* adds energy, changes a stiffness or dissipates.  A *released coordinate* frees a joint that the base model
locks: its parameter is a compliance c, and the joint always has a spring with the energy q^2 / (2 c).

Effects act on parts (belts, drives, links, the platform, the frame), so one file serves every mechanism that has
these parts; an effect does not apply to a mechanism without them.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from sympy import Expr, Symbol

from pkmodes_description import Effect as DescribedEffect
from pkmodes_description import EffectParameter as DescribedParameter
from pkmodes_description import Named, Requirement

#: The parameter of an effect that releases coordinates: the compliance of all of their springs.
COMPLIANCE = "compliance"


def _index_letter(name: str) -> str:
    """Return the letter of the index in a name, empty for none."""
    return next((letter for letter in "ij" if f"{{{letter}}}" in name), "")


def _with_carrier_words(text: str, machine: Any) -> str:
    """Return a text with a machine's words for the body that carries payloads."""
    carrier = machine.carries
    return text.replace("{carrier}", carrier.name).replace("{on_carrier}", carrier.place)


@dataclass(frozen=True)
class EffectParameter:
    """A parameter of an effect; its null value is 0.

    Attributes
    ----------
    name : str
        As in the robot file, ``[effects.<effect>] <name> = ...``; with ``{j}`` there is one for each part, with
        ``{i}`` for each direction.
    unit : str
        SI unit.
    description : str
        A noun phrase.
    symbol, latex : str
        Its symbol in formulas.
    greater_than, less_than : float or None
        Physical bounds: None when any value is meaningful; the null value itself is always allowed.
    fitted : bool
        Whether it is estimated from measurements; a declared constant of the machine is not.
    turning : bool
        Whether only a platform that turns has it, one for each direction with ``{i}`` for it.
    along_legs : tuple of str
        Unit and description where the drives move along legs; empty if these are the same.
    in_place_of : str
        The parameter that a robot file may have instead: of ``compliance``, for a single coordinate.
    place : str
        The part, number or direction, to which it belongs; empty for all, set by `at`.
    """

    name: str
    unit: str
    description: str
    symbol: str
    latex: str
    greater_than: float | None = 0.0
    fitted: bool = True
    less_than: float | None = None
    in_place_of: str = ""
    place: str = ""
    along_legs: tuple[str, str] | None = None
    turning: bool = False

    def on(self, machine: Any) -> EffectParameter:
        """Return the parameter with the unit and the description that it has on a machine."""
        unit, description = self.unit, self.description
        if self.along_legs is not None and machine.linear_drives:
            unit, description = self.along_legs
        return replace(self, unit=unit, description=_with_carrier_words(description, machine))

    def at(self, place: str) -> EffectParameter:
        """Return the parameter for one part, if it exists once for each."""
        if "{" not in self.name:
            return self
        texts = (self.name, self.description, self.symbol, self.latex)
        name, description, symbol, latex = (text.format(i=place, j=place) for text in texts)
        return replace(self, name=name, description=description, symbol=symbol, latex=latex, place=place)


@dataclass(frozen=True)
class Positive:
    """An expression that must be positive for an effect to be physical.

    Attributes
    ----------
    of : callable
        ``of(parameters)`` returns the expression, from the parameters by name.
    place : str
        The parameter that the error names.
    sentence, remedy : str
        Text of the error, with ``{value}``.
    unit : str
        Of the expression.
    """

    of: Callable[[Mapping[str, Symbol]], Expr]
    place: str
    sentence: str
    remedy: str
    unit: str = "1"


@dataclass(frozen=True)
class Coordinate:
    """A released coordinate, zero in the reference configuration, and its rate.

    `place` is its part, number or direction; empty for the only one of an effect.
    """

    position: Symbol
    rate: Symbol
    place: str = ""


@dataclass(frozen=True)
class Released:
    """The coordinates that an effect releases, one for each part.

    Attributes
    ----------
    name, description, latex : str
        With ``{j}`` for the number of a part, or ``{i}`` for a direction; without either there is only one.
    order : int
        Position among the coordinates of other effects.
    sprung : bool
        Whether each has a spring of its own, with the ``compliance`` of the effect; else `apply` adds its energies.
    """

    name: str
    unit: str
    description: str
    latex: str
    order: int
    sprung: bool = True

    @property
    def letter(self) -> str:
        """Letter of the index, empty for none."""
        return _index_letter(self.name)


@dataclass(frozen=True)
class Effect:
    """One effect; a module of `pkmodes_derive.effects` defines it as ``EFFECT``.

    Attributes
    ----------
    name : str
        As in the robot file.
    sentence : str
        What it means for the machine, as a sentence for reports; here and in descriptions of parameters ``{carrier}``
        is the body that carries payloads, ``{on_carrier}`` where they are on it.
    parts : callable
        ``parts(machine)`` returns the parts it acts on; if there are none, it does not apply.
    parameters : tuple of EffectParameter
        An effect that releases coordinates has a ``compliance``, used by their springs; each coordinate may have
        one of its own ``in_place_of`` it.
    apply : callable
        ``apply(machine, parameters, released)`` adds the effect to a machine, with parameters by name and the
        released coordinates in order.
    released : Released or None
        None for a term.
    grounds : bool
        Whether it ties the machine to ground; how many rigid-body modes are left follows from its energy.
    needs : Positive or None
        Condition on its parameters.
    dissipates : bool
        Whether it only dissipates: M, K and the frequencies are those without it.
    places : tuple of str
        Indices of the released coordinates on a machine, set by `on`.
    parameters_on : callable or None
        ``parameters_on(machine)`` returns parameters that depend on the machine, in place of `parameters`.
    """

    name: str
    sentence: str
    parts: Callable[[Any], Sequence[object]]
    parameters: tuple[EffectParameter, ...]
    apply: Callable[[Any, Mapping[str, Symbol], tuple[Coordinate, ...]], None]
    released: Released | None = None
    grounds: bool = False
    needs: Positive | None = None
    dissipates: bool = False
    places: tuple[str, ...] = ()
    parameters_on: Callable[[Any], tuple[EffectParameter, ...]] | None = None

    @property
    def order(self) -> int:
        """Position of its coordinates among those of other effects."""
        return self.released.order if self.released else 0

    def on(self, machine: Any) -> Effect:
        """Return the effect with the parameters and coordinates it has on a machine."""
        parts = self.parts(machine)
        numbers = [str(number) for number in range(1, len(parts) + 1)]
        places = {"": ("",), "i": tuple(map(str, parts)), "j": tuple(numbers)}
        declared = self.parameters if self.parameters_on is None else self.parameters_on(machine)
        described = [p.on(machine) for p in declared if machine.turning is not None or not p.turning]
        parameters = [p.at(place) for p in described for place in places[_index_letter(p.name)]]
        released = places[_index_letter(self.released.name)] if self.released else ()
        sentence = _with_carrier_words(self.sentence, machine)
        return replace(self, sentence=sentence, parameters=tuple(parameters), places=released)

    def softening(self, place: str) -> tuple[EffectParameter, ...]:
        """Return the compliances in series that one of its released coordinates has."""
        return tuple(
            p
            for p in self.parameters
            if p.name == COMPLIANCE or (p.in_place_of == COMPLIANCE and p.place == place)
        )

    def data(self) -> DescribedEffect:
        """Return the data that the runtime needs."""
        coordinates = {}
        if (q := self.released) is not None:
            for place in self.places:
                name, text = (t.format(i=place, j=place) for t in (q.name, q.description))
                coordinates[place] = Named(name, q.unit, text)
        return DescribedEffect(
            self.name,
            self.sentence,
            self.grounds,
            tuple(coordinates.values()),
            tuple(
                DescribedParameter(
                    p.name,
                    p.unit,
                    p.description,
                    p.greater_than,
                    p.fitted,
                    p.less_than,
                    tuple(one.name for place, one in coordinates.items() if p in self.softening(place)),
                    p.in_place_of,
                )
                for p in self.parameters
            ),
            self._requirements(),
            self.dissipates,
        )

    def _requirements(self) -> tuple[Requirement, ...]:
        if self.needs is None:
            return ()
        place = (f"effects.{self.name}.{self.needs.place}",)
        return (
            Requirement(
                f"{self.name}_margin",
                "above_zero",
                place,
                self.needs.sentence,
                self.needs.remedy,
                self.needs.unit,
            ),
        )
