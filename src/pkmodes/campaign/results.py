"""What identification gives: the modes of each record, with the parts of their standard deviations."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from pkmodes.campaign.campaign import Record
from pkmodes.campaign.inspection import Inspection, Repeats
from pkmodes.measured.measurements import Measurements


@dataclass(frozen=True)
class Parts:
    """What a standard deviation of a frequency consists of [Hz], added in quadrature.

    Attributes
    ----------
    scatter : float
        Of the mean over repeats; 0 for a single one.
    fit : float
        Uncertainty of the identification itself.
    repeatability : float
        What approaching the pose again changes.
    """

    scatter: float
    fit: float
    repeatability: float

    @property
    def total(self) -> float:
        """The standard deviation."""
        return float(np.sqrt(self.scatter**2 + self.fit**2 + self.repeatability**2))


@dataclass(frozen=True, eq=False)
class IdentifiedMode:
    """A mode of a record: a row of the result.

    Attributes
    ----------
    frequency, sigma : float
        [Hz].
    damping, sigma_damping : float
        NaN where unknown.
    shape : mapping of str to float
        By channel, relative to the largest component.
    sigma_shape : float
        Of a component of it; NaN where unknown.
    complexity : float
        Modal phase collinearity; NaN without a shape.
    found_in : tuple of int, or None
        In how many model orders, of how many.
    files : int
        In how many files it was found.
    edited : str or None
        "added" if the user asked for it.
    complex_shape : mapping of str to complex
        The shape before its imaginary part was left out.
    """

    frequency: float
    parts: Parts
    damping: float
    sigma_damping: float
    shape: Mapping[str, float]
    sigma_shape: float
    complexity: float
    found_in: tuple[int, int] | None
    files: int
    edited: str | None = None
    complex_shape: Mapping[str, complex] = field(default_factory=dict)

    @property
    def sigma(self) -> float:
        """The standard deviation of the frequency [Hz]."""
        return self.parts.total


@dataclass(frozen=True)
class LeftOut:
    """A faulty file that was left out."""

    file: str
    reason: str


@dataclass(frozen=True, eq=False)
class RecordResult:
    """The modes of a record.

    Attributes
    ----------
    struck : tuple of float
        Frequencies of the modes that the user struck out [Hz].
    messages : tuple of str
        What the user should know.
    inspections : tuple of Inspection
        Of the first file of each setup, if they were asked for.
    repeats : tuple of Repeats
        Of each setup.
    """

    record: Record
    modes: tuple[IdentifiedMode, ...]
    struck: tuple[float, ...]
    left_out: tuple[LeftOut, ...]
    messages: tuple[str, ...]
    inspections: tuple[Inspection, ...] = ()
    repeats: tuple[Repeats, ...] = ()


@dataclass(frozen=True, eq=False)
class Identification:
    """The modes of a campaign.

    Attributes
    ----------
    repeatability : float
        Relative; the given one, or that of poses measured twice.
    measurements : Measurements
        What a diagnosis takes.
    """

    records: tuple[RecordResult, ...]
    repeatability: float
    measurements: Measurements
    messages: tuple[str, ...]
