"""One fault at one place, in the words of a term: a form, one or two places, a direction, and its values.

The forms and what they mean on a machine:

* ``mass``: a body is heavier, with its weight; a link as a uniform rod, a leg's part at its centre of mass; a body
  that rotates about its axis has more inertia.
* ``spring``: a spring from a body to ground, or between two bodies, relaxed at the pose; with a direction it is
  strained by what the bodies are displaced along it.
* ``compliance``: one released joint of the catalogue, such as the wind-up of one gearbox.
* ``mount``: the bearing of a body yields: that of a pulley along the belt, away from it, of a rail or a base joint in
  a direction of the base frame.  The body's declared mass moves with it; of a pulley, a mass of its own, or none.
* ``resonator``: a body on a slide along a direction of another one, and on a spring; it rides along in all other
  directions, with its weight.  On a body that rotates it rotates about the same axis.
* ``parameter``: a value of one axis is another one; it is a change of the machine's values, not of its parts.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

FORMS = ("mass", "spring", "compliance", "mount", "resonator", "parameter")
DIRECTIONS = ("x", "y", "z", "rx", "ry", "rz")


@dataclass(frozen=True)
class Fault:
    """One fault at one place.

    Attributes
    ----------
    form : str
        One of `FORMS`.
    places : tuple of str
        One place, or two for a spring between bodies; the coordinate of a compliance, the path of a parameter.
    direction : str
        One of `DIRECTIONS`; empty where the bodies have one freedom, or for an isotropic spring.
    values : mapping of str to float
        In SI units, by the names of the parameters of a term.
    """

    form: str
    places: tuple[str, ...]
    direction: str = ""
    values: Mapping[str, float] = field(default_factory=dict)

    @property
    def term(self) -> str:
        """What a diagnosis calls it."""
        return f"{self.form}:{'/'.join(self.places)}{self.direction and '.'}{self.direction}"

    @property
    def amount(self) -> float:
        """Mass [kg] or, of a body that rotates, moment of inertia [kg m^2]."""
        return self.values["inertia"] if "inertia" in self.values else self.values["mass"]


def same_term(one: str, other: str) -> bool:
    """Return whether two terms are one: the places of a spring have no order."""
    return _sorted(one) == _sorted(other)


def _sorted(term: str) -> tuple[str, frozenset[str], str]:
    form, _, where = term.partition(":")
    places, dot, direction = where.rpartition(".")
    if not dot or direction not in DIRECTIONS:
        places, direction = where, ""
    return form, frozenset(places.split("/")), direction
