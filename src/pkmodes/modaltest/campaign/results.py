"""Results of an identification: the modes of each record, with the parts of their standard deviations."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Annotated, Any

import numpy as np
from msgspec import Meta

from pkmodes.core.support.documents import Count, Document, Probability, Size
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.modaltest.campaign.campaign import Record
from pkmodes.modaltest.campaign.inspection import Inspection, Repeats
from pkmodes.modaltest.campaign.mode_estimates import in_metres


class Parts(Document, frozen=True):
    """What the standard deviation of a frequency consists of [Hz], added in quadrature."""

    scatter: Annotated[Size, Meta(description="Of the mean over repeats; 0 for a single file.")]
    fit: Annotated[Size, Meta(description="Uncertainty of the identification itself.")]
    repeatability: Annotated[Size, Meta(description="What approaching the pose again changes.")]

    @property
    def total(self) -> float:
        """The standard deviation."""
        return float(np.sqrt(self.scatter**2 + self.fit**2 + self.repeatability**2))


class ModeDocument(Document, frozen=True):
    """A mode of a record."""

    frequency: Annotated[Size, Meta(description="Undamped natural frequency [Hz].")]
    sigma: Annotated[Size, Meta(description="Its standard deviation [Hz].")]
    sigma_parts: Annotated[Parts, Meta(description="What it consists of.")]
    damping: Annotated[float | None, Meta(description="Damping ratio; null where unknown.")]
    sigma_damping: Annotated[Size | None, Meta(description="Its standard deviation; null where unknown.")]
    complexity: Annotated[
        Probability | None,
        Meta(description="Modal phase collinearity, 1 for a real shape; null without a shape."),
    ]
    found_in: Annotated[
        tuple[int, ...] | None,
        Meta(description="In how many model orders, of how many; null for spectra and identified modes."),
    ]
    files: Annotated[Count, Meta(description="In how many files it was found.")]
    edited: Annotated[str | None, Meta(description='"added" if the campaign asked for it.')]


@dataclass(frozen=True, eq=False)
class IdentifiedMode:
    """A mode of a record: a row of the result.

    - frequency, sigma: [Hz]
    - damping, sigma_damping: NaN where unknown
    - shape: by channel, relative to the largest component
    - sigma_shape: standard deviation of a component of it; NaN where unknown
    - complexity: modal phase collinearity; NaN without a shape
    - found_in: number of model orders in which it was found, and their total
    - files: number of files in which it was found
    - edited: "added" if the user added it
    - complex_shape: the shape before its imaginary part was left out
    - blank, uncertain: components of a turning platform that are left out: see `ChannelShape`
    - lengths: what makes metres of the components that are angles
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
    blank: tuple[str, ...] = ()
    uncertain: tuple[str, ...] = ()
    lengths: Mapping[str, float] = field(default_factory=dict)

    @property
    def shape_in_metres(self) -> dict[str, complex]:
        """The shape before its imaginary part was left out, angles times the characteristic length."""
        return in_metres(self.complex_shape, self.lengths)

    @property
    def sigma(self) -> float:
        """The standard deviation of the frequency [Hz]."""
        return self.parts.total

    def document(self) -> ModeDocument:
        """Return it in the form described in docs/reference/json.md."""
        return ModeDocument.of(self, sigma_parts=self.parts)


class LeftOut(Document, frozen=True):
    """A faulty file that was left out."""

    file: Annotated[str, Meta(description="Its path.")]
    reason: Annotated[str, Meta(description="What is wrong with it.")]


class RecordDocument(Document, frozen=True):
    """The modes of a record."""

    pose: Annotated[str, Meta(description="Its label.")]
    kind: Annotated[str, Meta(description="Of the record.")]
    modes: Annotated[tuple[ModeDocument, ...], Meta(description="Ascending in frequency.")]
    struck: Annotated[
        tuple[float, ...], Meta(description="Frequencies of modes that the campaign strikes out [Hz].")
    ]
    left_out: Annotated[
        tuple[LeftOut, ...], Meta(description="Faulty files; all of them where the record is left out.")
    ]
    messages: Annotated[tuple[str, ...], Meta(description="What the reader should know.")]


@dataclass(frozen=True, eq=False)
class RecordResult:
    """The modes of a record.

    - struck: frequencies of the modes that the user struck out [Hz]
    - messages: what the user should know
    - inspections: inspections of the first file of each setup, if requested
    - repeats: repeated measurements of each setup
    """

    record: Record
    modes: tuple[IdentifiedMode, ...]
    struck: tuple[float, ...]
    left_out: tuple[LeftOut, ...]
    messages: tuple[str, ...]
    inspections: tuple[Inspection, ...] = ()
    repeats: tuple[Repeats, ...] = ()

    @property
    def is_left_out(self) -> bool:
        """Whether none of its files could be used."""
        return not self.repeats

    def document(self) -> RecordDocument:
        """Return them in the form described in docs/reference/json.md."""
        modes = tuple(mode.document() for mode in self.modes)
        return RecordDocument.of(self, pose=self.record.pose, kind=self.record.kind, modes=modes)


class IdentifyDocument(Document, frozen=True):
    """The modes of a campaign."""

    records: Annotated[tuple[RecordDocument, ...], Meta(description="In the order of the campaign.")]
    repeatability: Annotated[
        Size, Meta(description="Relative standard deviation of a frequency when a pose is approached again.")
    ]


@dataclass(frozen=True, eq=False)
class Identification:
    """The modes of a campaign.

    - repeatability: relative; as stated, or from poses measured twice
    - measurements: input of a diagnosis
    """

    records: tuple[RecordResult, ...]
    repeatability: float
    measurements: Measurements
    messages: tuple[str, ...]

    def as_json(self) -> dict[str, Any]:
        """Return them in the form described in docs/reference/json.md, without NaN."""
        return IdentifyDocument.of(
            self, records=tuple(record.document() for record in self.records)
        ).as_json()
