"""Kinds of candidates of a robot, in words, by which a class of candidates is named.

A class whose members share a kind is named by it: "a compliance in series with the belt (clamps, gearboxes)".  A
candidate that is not listed is named by its own sentence.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import replace

from pkmodes.core.mechanism.described import Mechanism
from pkmodes.loop.diagnosis.problem import Candidate

#: Kinds, each with its candidates and their distinguishing words.  A candidate of a single axis or belt is described
#: like that of all.
KINDS: dict[str, dict[str, str]] = {
    "a compliance in series with the belt": {
        "clamp_compliance": "clamps",
        "gearbox_compliance": "gearboxes",
        "belt_end_compliance": "belt ends",
    },
    "a compliance of the frame": {
        "frame_compliance": "in all directions",
        **{f"frame_compliance.compliance_{name}": f"along {name}" for name in "xyz"},
    },
    "another stiffness of the belt": {
        "parameter:belt.specific_stiffness": "specific stiffness",
        "parameter:belt.width": "width",
        "axis_belt_stiffness": "unequal belts",
        "belt_tension_stiffness": "tension",
    },
    "another mass at the platform": {
        "payload": "a payload",
        "parameter:platform.mass": "its own mass",
        "parameter:toolhead.mass": "its own mass",
        "parameter:bed.mass": "its own mass",
    },
    "another inertia of the drive": {
        "gearbox_inertia": "gearboxes",
        "parameter:motor.inertia": "motors",
        "parameter:motor.gear_ratio": "gear ratio",
        "parameter:pulley.inertia": "pulleys",
    },
    "a shift of all poses": {f"measurement:offset.{name}": f"along {name}" for name in "xyz"},
}
#: Prefix of a value that belongs to one entry of a repeated table: ``parameter:axis.2.`` of ``axis.2.belt.width``.
ENTRY = re.compile(r"^parameter:(\w+)\.(\d+)\.")


def with_kinds(candidates: Iterable[Candidate], mechanism: Mechanism) -> list[Candidate]:
    """Return candidates with the words for what they share, in those of their mechanism."""
    described = []
    for candidate in candidates:
        name, entry = ENTRY.sub("parameter:", candidate.name), ENTRY.match(candidate.name)
        entry_words = f" of {entry[1].replace('_', ' ')} {entry[2]}" if entry else ""
        kind = next((kind for kind, parts in KINDS.items() if name in parts), "")
        described.append(
            replace(candidate, kind=mechanism.in_own_words(kind), part=KINDS[kind][name] + entry_words)
            if kind
            else candidate
        )
    return described
