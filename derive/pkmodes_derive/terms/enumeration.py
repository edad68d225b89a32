"""All terms of a machine: each form at each place, in words, as the search of a diagnosis takes them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Literal

from pkmodes_derive.effect import Effect
from pkmodes_derive.machine import Machine
from pkmodes_derive.parts import Rotor
from pkmodes_derive.terms import forms
from pkmodes_derive.terms.places import FRAME, PLATFORM, Place, places
from pkmodes_derive.vocabulary import AXES

FORMS = {"mass": forms.mass, "spring": forms.spring, "mount": forms.mount, "resonator": forms.resonator}


@dataclass(frozen=True)
class Term:
    """A form at a place.

    Attributes
    ----------
    form : str
        A key of `FORMS`.
    ends : tuple of Place
        One, or two for a spring between bodies.
    along : str
        A direction; empty for bodies with one freedom, and for an isotropic spring.
    sentence : str
        A noun phrase, such as "a torsional spring between pulley 1 of axis 2 and pulley 2 of axis 2".
    """

    form: Literal["mass", "spring", "mount", "resonator"]
    ends: tuple[Place, ...]
    along: str
    sentence: str

    @property
    def name(self) -> str:
        """As in results: "spring:pulley_2_1/pulley_2_2", "mount:carriage_1.y"."""
        ends = "/".join(place.name for place in self.ends)
        return f"{self.form}:{ends}" + (f".{self.along}" if self.along else "")

    @property
    def effect(self) -> Effect:
        """The term as an effect, like those of the catalogue."""
        names = [place.name for place in self.ends]
        direction = {"along": self.along} if self.along else {}
        effect: Effect = FORMS[self.form](*names, **direction, sentence=self.sentence)
        return effect


def terms(machine: Machine) -> tuple[Term, ...]:
    """Return all terms of a machine without effects, by form."""
    all_places = list(places(machine).values())
    return (
        *_masses(all_places),
        *_springs(all_places),
        *_mounts(machine, all_places),
        *_resonators(all_places),
    )


def _masses(all_places: Sequence[Place]) -> Iterator[Term]:
    for place in all_places:
        what = "extra moment of inertia of" if place.rotates else "an extra mass on"
        yield Term("mass", (place,), "", f"{what} {place.words}")


def _springs(all_places: Sequence[Place]) -> Iterator[Term]:
    for place in all_places:
        kind = "a torsional spring" if place.rotates else "a spring"
        if not place.directions:
            yield Term("spring", (place,), "", f"{kind} from {place.words} to ground")
        elif place.name == PLATFORM:
            yield Term("spring", (place,), "", f"an isotropic spring from {place.words} to ground")
        for along in place.directions:
            where = f"about {along[1:]}" if along.startswith("r") else f"along {along}"
            kind = "a torsional spring" if along.startswith("r") else "a spring"
            yield Term("spring", (place,), along, f"{kind} from {place.words} to ground {where}")
    for a, b in combinations(all_places, 2):
        between = f"between {a.words} and {b.words}"
        if not a.directions and not b.directions:
            if a.rotates == b.rotates:
                yield Term("spring", (a, b), "", f"a {'torsional ' if a.rotates else ''}spring {between}")
        elif {a.name, b.name} & {PLATFORM, FRAME} and a.position and (b.position or b.name == FRAME):
            for along in (d for d in AXES if d in a.directions or d in b.directions):
                yield Term("spring", (a, b), along, f"a spring {between} along {along}")


def _mounts(machine: Machine, all_places: Sequence[Place]) -> Iterator[Term]:
    for place in all_places:
        if isinstance(place.part, Rotor) and _carries_a_belt(machine, place.part):
            yield Term("mount", (place,), "", f"a bearing of {place.words} that yields along the belt")
        elif place.seat is not None:
            for along in machine.directions:
                yield Term("mount", (place,), along, f"a support of {place.words} that yields along {along}")


def _carries_a_belt(machine: Machine, rotor: Rotor) -> bool:
    bearing = rotor.bearing
    ends = (clamp for belt in machine.belts for run in belt.runs for _, clamp in run.ends)
    return any(clamp and clamp.released is bearing.released for clamp in ends)


def _resonators(all_places: Sequence[Place]) -> Iterator[Term]:
    for place in all_places:
        if not place.directions:
            kind = "a rotor on a torsional spring" if place.rotates else "a mass on a spring of its own"
            yield Term("resonator", (place,), "", f"{kind} on {place.words}")
        for along in place.translations:
            yield Term(
                "resonator", (place,), along, f"a mass on a spring of its own on {place.words}, along {along}"
            )
