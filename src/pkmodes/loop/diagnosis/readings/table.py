"""Readings, in the order in which they are tested: possible mistakes in a file, and when they can be recognised.

A test returns what is wrong and what to do about it, or an empty text if the file is right.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterable
from dataclasses import dataclass

from pkmodes.loop.diagnosis.criteria import ReadingCriteria
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Fit
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.match.stage import MatchStage
from pkmodes.loop.diagnosis.readings.copies import copied_shapes, poses_at_one_position
from pkmodes.loop.diagnosis.readings.drives import other_drives_as_declared, other_drives_refitted
from pkmodes.loop.diagnosis.readings.units import other_unit
from pkmodes.loop.diagnosis.readings.wiring import certain_wiring, dead_channels, other_wiring

#: Largest number of remarks of each kind.
MAX_REMARKS = 4


@dataclass(frozen=True)
class Reading:
    """Another reading of the data, with a test for each stage at which it can be told from that of the file.

    - declared: test of the declared model, nothing fitted.  It decides a diagnosis unless there is `refitted`;
      otherwise it is a note of comparisons, and where the data are too few.
    - refitted: test of the fits of the declared model, with its uncertain values refitted, before any search
    - explained: test of the final fit
    - remarks: notes on all measurements, including held-out ones, which decide nothing
    """

    name: str
    declared: Callable[[Fitter], str] | None = None
    refitted: Callable[[FitStore], str] | None = None
    explained: Callable[[Fitter, Fit], str] | None = None
    remarks: Callable[[MatchStage, ReadingCriteria], Iterable[str]] | None = None


READINGS = (
    Reading("unit", declared=other_unit),
    Reading("drives", declared=other_drives_as_declared, refitted=other_drives_refitted),
    Reading("dead_channel", explained=dead_channels),
    Reading("wiring", refitted=certain_wiring, explained=other_wiring),
    Reading("pose", remarks=poses_at_one_position),
    Reading("copies", remarks=copied_shapes),
)


def answer_for_declared_model(fitter: Fitter) -> tuple[str, ...]:
    """Return the answer of the first reading with which the declared model fits far better, if there is one."""
    answers = (reading.declared(fitter) for reading in READINGS if reading.declared)
    return tuple(itertools.islice(filter(None, answers), 1))


def answer_for_final_fit(fitter: Fitter, fit: Fit) -> tuple[str, ...]:
    """Return the answer of the first reading that the final fit shows, if there is one."""
    answers = (reading.explained(fitter, fit) for reading in READINGS if reading.explained)
    return tuple(itertools.islice(filter(None, answers), 1))


def reading_remarks(stage: MatchStage, criteria: ReadingCriteria) -> tuple[str, ...]:
    """Return sentences about all measurements.

    - stage: its values determine which rows are the same mode
    """
    answers = (reading.remarks(stage, criteria) for reading in READINGS if reading.remarks)
    return tuple(text for texts in answers for text in itertools.islice(texts, MAX_REMARKS))
