"""What the data of a diagnosis do not exclude: plain data of its result."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Limit:
    """How large a parameter of a candidate that is not claimed may still be.

    Attributes
    ----------
    candidate : str
        Its name.
    value : float or None
        Largest deviation from the declared value at 95 %, for an absent effect its largest size; None if the data
        do not bound it within its plausible range.
    change : float
        Relative change of some frequency of the model at the limit; 0 without a limit.
    """

    candidate: str
    value: float | None
    unit: str
    change: float = 0.0


@dataclass(frozen=True)
class Unseen:
    """What a candidate that is not claimed could have done to a fitted value.

    Attributes
    ----------
    sigma : float
        As a standard deviation of the value.
    candidate : str
        The one that could have done most.
    """

    sigma: float
    candidate: str
