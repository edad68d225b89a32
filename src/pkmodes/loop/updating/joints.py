"""Equal parts that an effect changes by one factor each, named in the words of the mechanism.

"relative change of the stiffness of leg 3" is that of leg 3; the declared value that changes is the one whose key is
a stiffness and whose description counts legs: ``axis.3.leg.stiffness``.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from pkmodes.core.mechanism.described import Mechanism
from pkmodes.core.robot.layout import items
from pkmodes.core.support.words import ENTRY_LETTER
from pkmodes.loop.diagnosis.problem import Joint
from pkmodes_description import EffectParameter

#: Description of an effect's parameter that changes one of several equal parts.
CHANGE = re.compile(r"relative change of the (\w[\w ]*) of (\w[\w ]*) (\d+)")


def joints_of(
    mechanism: Mechanism, paths: Sequence[str], parameters: Sequence[EffectParameter], prefix: str
) -> tuple[Joint, ...]:
    """Return the equal parts that the parameters of an effect change, one for each parameter; else none.

    - paths: of the parameters
    - prefix: of a term that is a declared value
    """
    matches = [CHANGE.fullmatch(p.description) for p in parameters]
    joints = []
    for path, match in zip(paths, matches, strict=True):
        if match is None or len(paths) < 2:
            return ()
        quantity, part, number = match.groups()
        part_pattern = re.compile(rf"\b{re.escape(part)} {ENTRY_LETTER}\b")
        declared_paths = [
            item.path
            for item in items(mechanism)
            if item.entry == int(number) - 1
            and item.key.name.split("_")[-1] == quantity.split()[-1]
            and part_pattern.search(item.key.description)
        ]
        term = f"{prefix}{declared_paths[0]}" if len(declared_paths) == 1 else ""
        joints.append(Joint(path, f"{part} {number}", quantity, term))
    return tuple(joints)
