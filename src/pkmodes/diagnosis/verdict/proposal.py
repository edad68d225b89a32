"""A measurement that is proposed."""

from __future__ import annotations

from typing import Annotated

from msgspec import Meta, field

from pkmodes.core.base.drives import Drives
from pkmodes.support.documents import Document


class NextMeasurement(Document, frozen=True, omit_defaults=True):
    """The pose at which two explanations differ most, and how to measure there."""

    pose: Annotated[tuple[float, ...], Meta(description="Platform centre [m].")]
    separates: Annotated[
        tuple[str, ...], Meta(description="The two explanations.", min_length=2, max_length=2)
    ]
    sigmas: Annotated[float, Meta(description="By how many standard deviations they differ there.")]
    drives: Annotated[
        Drives | None, Meta(description="What the motors are to do; null for a structure without motors.")
    ]
    hidden_by: Annotated[
        str,
        Meta(
            description="The uncertain value that could make up most of that difference within its standard "
            "deviation, so that several such poses, or a more exact value, are needed; present only where one could."
        ),
    ] = ""
    load: Annotated[
        dict[str, float],
        Meta(
            description="Values to be set for it, by path, in SI units; present only where a payload is proposed."
        ),
    ] = field(name="set", default_factory=dict)

    @property
    def caveat(self) -> str:
        """What to do about a value that could hide the difference; empty if there is none."""
        if not self.hidden_by:
            return ""
        return (
            f"{self.hidden_by} could make up for most of that within its sigma: measure several poses in this way, "
            "or state it more exactly"
        )
