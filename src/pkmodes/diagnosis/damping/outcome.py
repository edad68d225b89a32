"""The result of a diagnosis of damping: plain data, beside that of the frequencies."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Damping:
    """What the damping says.

    Attributes
    ----------
    verdict : str
        Of the damping alone; ``insufficient_data`` where it says nothing.
    sentence : str
        Its reason.
    fitted : int
        Number of damping ratios that took part.
    before, after, held_out : float or None
        Root mean square factor between measured ratios and those of the model, over the fitted rows as declared and
        as diagnosed, and over the held-out ones as diagnosed; None where there are none, or nothing dissipates.
    """

    verdict: str
    sentence: str
    fitted: int
    before: float | None = None
    after: float | None = None
    held_out: float | None = None
