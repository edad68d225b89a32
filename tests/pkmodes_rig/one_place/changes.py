"""What can change on a machine between two campaigns: one thing at one place, or the same on all axes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from pkmodes_rig.one_place import Fault
from pkmodes_rig.one_place.draws import JOINTS, LEGS, Drawn, drawn, kinds_of

#: The drive of one axis has lost stiffness; a mass on what the machine carries; all drives have lost stiffness.
SOFTER, PAYLOAD, ALL_DRIVES = "softer drive", "payload", "all drives softer"
#: The same joint of all axes yields, by the coordinate that it releases.
ALL_YIELD = {"psi": "all gearboxes yield", "eps": "all clamps yield", "delta": "all links yield"}
#: The stiffness of the drive of one axis.
DRIVES = {
    "rotary_delta": "axis.{}.reducer.stiffness",
    "hexapod": "axis.{}.leg.stiffness",
    "corexy": "belt_path.{}.belt.specific_stiffness",
}
BELT = "axis.{}.belt.specific_stiffness"


@dataclass(frozen=True)
class Change:
    """A change of any size: faults that all have it."""

    parts: tuple[Drawn, ...]

    @property
    def sized_by(self) -> str:
        """The parameter that is the size; of a value its relative change."""
        return self.parts[0].sized_by

    def of_size(self, size: float) -> tuple[Fault, ...]:
        """Return the faults of this size."""
        return tuple(part.of_size(size) for part in self.parts)


def kinds_of_changes(mechanism: str, q: Any) -> tuple[str, ...]:
    """Return the kinds of changes that a mechanism has places for."""
    yielding = [ALL_YIELD[stem] for stem in JOINTS[mechanism]]
    return (*kinds_of(mechanism, q), SOFTER, PAYLOAD, ALL_DRIVES, *yielding)


def change_drawn(
    mechanism: str, q: Any, kind: str, span: tuple[float, float], rng: np.random.Generator
) -> Change:
    """Draw a change of one of `kinds_of_changes`; see `draws.drawn` for the arguments."""
    axes = range(1, LEGS.get(mechanism, 2) + 1)
    stem = next((stem for stem, name in ALL_YIELD.items() if name == kind), "")
    if stem:
        return Change(tuple(Drawn(Fault("compliance", (f"{stem}_{j}",)), "compliance") for j in axes))
    if kind == PAYLOAD:
        place = "bed" if mechanism == "bed_slinger" else "platform"
        return Change((Drawn(Fault("mass", (place,)), "mass"),))
    if kind == ALL_DRIVES:
        return Change(tuple(_softer(mechanism, j) for j in axes))
    if kind == SOFTER:
        return Change((_softer(mechanism, int(rng.choice(axes))),))
    return Change((drawn(mechanism, q, kind, span, rng),))


def deviating(q: Any, largest: float, rng: np.random.Generator) -> Any:
    """Return the values of a machine whose masses, inertias and stiffnesses are not the declared ones.

    Parameters
    ----------
    q : Parameters
    largest : float
        Each number is multiplied by a factor of its own, evenly distributed up to so much from 1.
    rng : numpy.random.Generator
    """
    return q._replace(
        **{
            name: np.asarray(value, dtype=float) * rng.uniform(1 - largest, 1 + largest, np.shape(value))
            for name, value in q._asdict().items()
            if name.endswith(("mass", "inertia", "stiffness"))
        }
    )


def _softer(mechanism: str, axis: int) -> Drawn:
    path = DRIVES.get(mechanism, BELT).format(axis)
    return Drawn(Fault("parameter", (path,)), "change", -1.0)
