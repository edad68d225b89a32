"""Faults at random places: which bodies, directions, joints and values of one axis each mechanism has."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from pkmodes_rig.one_place.faults import FORMS, Fault

#: A spring between two bodies has a line of its own in the tables.
PAIR = "spring between bodies"
KINDS = (*FORMS[:2], PAIR, *FORMS[2:])
SPACE, PLANE, TURNS = ("x", "y", "z"), ("x", "y"), ("rx", "ry", "rz")
#: Largest cosine of the angle between a rail and the direction in which it yields: along itself it changes nothing.
ACROSS = 0.5
#: Part of the carriage's or tool head's mass that a bearing of a pulley has, in every second case; else it has none.
BLOCK = 0.3
#: Frequencies of resonators relative to the lowest and highest vibration of the machine.
TUNED = (0.6, 1.1)
#: Values of one axis.
VALUES = {
    "linear_delta": (
        *("carriage.mass", "link.mass", "link.length", "belt.width", "pulley.radius", "pulley.inertia"),
        *("motor.inertia", "belt.specific_stiffness"),
    ),
    "hexaglide": (
        "carriage.mass",
        "link.mass",
        "link.length",
        "belt.width",
        "pulley.inertia",
        "motor.inertia",
    ),
    "rotary_delta": (
        *("arm.length", "arm.inertia", "link.length", "link.mass", "reducer.stiffness", "motor.inertia"),
    ),
    "hexapod": ("leg.stiffness", "leg.rod_mass", "leg.rod_center", "leg.base_inertia", "motor.inertia"),
    "corexy": ("belt.width", "pulley.radius", "motor.inertia", "lengths.1", "lengths.2"),
    "cartesian": ("belt.width", "pulley.radius", "motor.inertia", "lengths.1"),
    "bed_slinger": ("belt.width", "pulley.radius", "motor.inertia", "lengths.1"),
}
#: Legs of the machines with closed loops, and what releases their joints.
LEGS = {"linear_delta": 3, "rotary_delta": 3, "hexapod": 6, "hexaglide": 6}
JOINTS = {
    "linear_delta": ("psi", "eps", "delta"),
    "hexaglide": ("psi", "eps", "delta"),
    "rotary_delta": ("delta",),
    "hexapod": (),
    "corexy": ("psi", "eps"),
    "cartesian": ("psi", "eps"),
    "bed_slinger": ("psi", "eps"),
}
#: Bodies that slide, rotate, or move in space, of which each leg or belt has one.
SLIDING = {"linear_delta": ("carriage",), "hexaglide": ("carriage",)}
ROTATING = {"rotary_delta": ("arm", "motor"), "hexapod": ("motor",)}
SPATIAL = {
    "linear_delta": ("link",),
    "hexaglide": ("link",),
    "rotary_delta": ("link",),
    "hexapod": ("leg", "rod"),
}
ON_RAILS, TURNING = ("linear_delta", "hexaglide"), ("hexapod", "hexaglide")
#: Bodies of printers, with the directions in which each moves.
PRINTERS: dict[str, dict[str, tuple[str, ...]]] = {
    "corexy": {"platform": PLANE, "gantry": ("",)},
    "cartesian": {"platform": PLANE, "beam": ("",)},
    "bed_slinger": {"toolhead": ("",), "bed": ("",)},
}


@dataclass(frozen=True)
class Drawn:
    """A fault of any size.

    Attributes
    ----------
    fault : Fault
        With the values that do not depend on the size.
    sized_by : str
        The parameter that is the size; of a value of one axis its relative change.
    sign : float
        Of the change of a value of one axis.
    """

    fault: Fault
    sized_by: str
    sign: float = 1.0

    def of_size(self, size: float) -> Fault:
        """Return the fault of this size."""
        return replace(self.fault, values={self.sized_by: self.sign * size, **self.fault.values})


def drawn(mechanism: str, q: Any, kind: str, span: tuple[float, float], rng: np.random.Generator) -> Drawn:
    """Draw a fault of one of `KINDS` at a random place.

    Parameters
    ----------
    mechanism : str
    q : Parameters
        The machine.
    kind : str
    span : tuple of two floats
        Lowest and highest frequency of its vibrations [Hz].
    rng : numpy.random.Generator
    """
    some = list(_EVERY[kind](mechanism, q))
    fault = some[int(rng.integers(len(some)))]
    amount = "inertia" if _rotates(mechanism, fault.places[0]) else "mass"
    if fault.form == "mass":
        return Drawn(fault, amount)
    if fault.form == "resonator":
        low, high = TUNED[0] * span[0], TUNED[1] * span[1]
        frequency = float(np.exp(rng.uniform(np.log(low), np.log(high))))
        return Drawn(replace(fault, values={"frequency": frequency}), amount)
    if fault.form == "mount":
        with_mass = fault.places[0].startswith("pulley") and rng.random() < 0.5
        values = {"mass": BLOCK * _carried(mechanism, q)} if with_mass else {}
        return Drawn(replace(fault, values=values), "compliance")
    if fault.form == "parameter":
        return Drawn(fault, "change", float(rng.choice([-1.0, 1.0])))
    return Drawn(fault, "stiffness" if fault.form == "spring" else "compliance")


def kinds_of(mechanism: str, q: Any) -> tuple[str, ...]:
    """Return the kinds of faults that a mechanism has places for."""
    return tuple(kind for kind in KINDS if any(True for _ in _EVERY[kind](mechanism, q)))


def _carried(mechanism: str, q: Any) -> float:
    return float(np.mean(q.carriage_mass)) if mechanism in ON_RAILS else float(q.toolhead_mass)


def _rotates(mechanism: str, place: str) -> bool:
    """Return whether the coordinate of a body is an angle; that of a hexapod's motor is a length."""
    return mechanism != "hexapod" and place.partition("_")[0] in ("pulley", *ROTATING.get(mechanism, ()))


def _each(mechanism: str, stems: Sequence[str]) -> list[str]:
    return [f"{stem}_{j + 1}" for stem in stems for j in range(LEGS[mechanism])]


def _pulleys(mechanism: str) -> list[str]:
    if mechanism in PRINTERS:
        return ["pulley_1", "pulley_2"]
    if mechanism not in ON_RAILS:
        return []
    return [f"pulley_{j + 1}_{k}" for j in range(LEGS[mechanism]) for k in (1, 2)]


def _bodies(mechanism: str) -> Iterator[tuple[str, str]]:
    """Yield all bodies with each direction in which they translate, or rotate about an axis of their own."""
    if mechanism in PRINTERS:
        yield from ((body, d) for body, directions in PRINTERS[mechanism].items() for d in directions)
    else:
        yield from (("platform", d) for d in SPACE)
        yield from ((body, "") for body in _each(mechanism, SLIDING.get(mechanism, ())))
        yield from ((body, "") for body in _each(mechanism, ROTATING.get(mechanism, ())))
        yield from ((body, d) for body in _each(mechanism, SPATIAL[mechanism]) for d in SPACE)
    yield from ((pulley, "") for pulley in _pulleys(mechanism))


def _masses(mechanism: str, q: Any) -> Iterator[Fault]:
    yield from (Fault("mass", (body,)) for body in dict.fromkeys(body for body, _ in _bodies(mechanism)))


def _springs(mechanism: str, q: Any) -> Iterator[Fault]:
    yield from (Fault("spring", (body,), d) for body, d in _bodies(mechanism))
    if mechanism != "bed_slinger":
        yield Fault("spring", ("platform",))
    if mechanism in TURNING:
        yield from (Fault("spring", ("platform",), d) for d in TURNS)


def _between(mechanism: str, q: Any) -> Iterator[Fault]:
    """Yield springs between two bodies that slide, between two that rotate, and from the platform to another body."""
    alike = [_pulleys(mechanism)]
    if mechanism in LEGS:
        alike.append(_each(mechanism, SLIDING.get(mechanism, ())))
        alike.append(_each(mechanism, ROTATING.get(mechanism, ())))
        others = _each(mechanism, (*SLIDING.get(mechanism, ()), *SPATIAL[mechanism]))
        yield from (Fault("spring", ("platform", body), d) for body in others for d in SPACE)
    for bodies in alike:
        yield from (Fault("spring", pair) for pair in itertools.combinations(bodies, 2))


def _compliances(mechanism: str, q: Any) -> Iterator[Fault]:
    of_each = range(LEGS.get(mechanism, 2))
    yield from (Fault("compliance", (f"{stem}_{j + 1}",)) for stem in JOINTS[mechanism] for j in of_each)
    frame = PLANE if mechanism in PRINTERS else SPACE
    yield from (Fault("compliance", (f"u_{d}",)) for d in frame)


def _mounts(mechanism: str, q: Any) -> Iterator[Fault]:
    yield from (Fault("mount", (pulley,)) for pulley in _pulleys(mechanism))
    base = {"rotary_delta": "arm", "hexapod": "leg"}.get(mechanism)
    if base is not None:
        yield from (Fault("mount", (body,), d) for body in _each(mechanism, (base,)) for d in SPACE)
    elif mechanism in ON_RAILS:
        for j, rail in enumerate(np.asarray(q.direction)):
            along = np.abs(rail) / np.linalg.norm(rail)
            across = [d for d, cosine in zip(SPACE, along, strict=True) if cosine <= ACROSS]
            yield from (Fault("mount", (f"carriage_{j + 1}",), d) for d in across)


def _resonators(mechanism: str, q: Any) -> Iterator[Fault]:
    yield from (Fault("resonator", (body,), d) for body, d in _bodies(mechanism))


def _values(mechanism: str, q: Any) -> Iterator[Fault]:
    table = "belt_path" if mechanism == "corexy" else "axis"
    for j, value in itertools.product(range(LEGS.get(mechanism, 2)), VALUES[mechanism]):
        yield Fault("parameter", (f"{table}.{j + 1}.{value}",))


_EVERY: dict[str, Callable[[str, Any], Iterator[Fault]]] = dict(
    zip(
        KINDS,
        (_masses, _springs, _between, _compliances, _mounts, _resonators, _values),
        strict=True,
    )
)
