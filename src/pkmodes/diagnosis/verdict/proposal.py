"""A measurement that is proposed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True)
class NextMeasurement:
    """The pose at which two explanations differ most, and how to measure there.

    Attributes
    ----------
    load : mapping of str to float
        Values to set, by name.
    drives : str or None
        What the motors are to do; None for a structure without motors.
    hidden_by : str
        The uncertain value that could make up most of the difference within its standard deviation; empty for none.
    """

    pose: tuple[float, ...]
    separates: tuple[str, str]
    sigmas: float
    load: Mapping[str, float] = field(default_factory=dict)
    drives: str | None = None
    hidden_by: str = ""

    @property
    def caveat(self) -> str:
        """What to do about a value that could hide the difference; empty if there is none."""
        if not self.hidden_by:
            return ""
        return (
            f"{self.hidden_by} could make up for most of that within its sigma: measure several poses in this way, "
            "or state it more exactly"
        )
