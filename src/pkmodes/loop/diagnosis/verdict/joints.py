"""The single joint of a cause with a value for each joint, in words: "leg 3 is 25 % softer than the others"."""

from __future__ import annotations

from dataclasses import dataclass

from pkmodes.core.base.numbers import plain
from pkmodes.loop.diagnosis.problem import Joint

#: Comparatives for a part with less, and with more, of a quantity than the others.
COMPARATIVES = {"stiffness": ("softer", "stiffer"), "mass": ("lighter", "heavier")}


@dataclass(frozen=True)
class JointAlone:
    """The single joint in which a cause with a value for each joint explains the data as well.

    - change, sigma: relative change in this joint, if the others have none, and its standard deviation
    - number_of_others: number of the other joints
    """

    joint: Joint
    change: float
    sigma: float
    number_of_others: int

    @property
    def comparison(self) -> str:
        """How it differs from the others: "25 % softer than the others"."""
        percent, is_larger = plain(100.0 * abs(self.change), 2), self.change > 0.0
        others, quantity = "the others" if self.number_of_others > 1 else "the other", self.joint.quantity
        if quantity in COMPARATIVES:
            return f"{percent} % {COMPARATIVES[quantity][is_larger]} than {others}"
        return f"{percent} % {'above' if is_larger else 'below'} {others} in {quantity}"

    @property
    def sentence(self) -> str:
        """What it means: "leg 3 is 25 % softer than the others"."""
        return f"{self.joint.words} is {self.comparison}"
