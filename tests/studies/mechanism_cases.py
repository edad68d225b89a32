"""Cases for the rotary delta and the CoreXY: how they are measured, diagnosed and judged.

Measurements are made as for the linear delta, except that all modes in a band are sought.
"""

from __future__ import annotations

import zlib
from dataclasses import dataclass, replace

import numpy as np

from pkmodes import updating
from pkmodes_rig import Identified, drawn_values, drives_of, identified, written
from studies.cases import edited
from studies.judging import diagnosed, mentioned, same_of
from studies.motors import words
from studies.running import Outcome
from studies.specimens import KINDS, SIGMA, Specimen, band, measurements_of, robot_of
from studies.strengths import signal

#: Standard deviation of shapes relative to their largest component; part of the modes missed in a realistic case.
SHAPE_NOISE, MISSING = 0.02, 0.15


@dataclass(frozen=True)
class MechanismCase:
    """A specimen, the causes that should be named, and how it is measured, as in `cases.Case`."""

    suite: str
    number: int
    specimen: Specimen
    names: tuple[str, ...] = ()
    kind: str = ""
    shapes: bool = True
    realistic: bool = False
    poses: int = 12
    seed: int = 1
    edit: str = ""

    @property
    def label(self) -> str:
        """Name for reports."""
        return f"{self.specimen.machine}, {self.suite} {self.number}{words(self.specimen.drives)}"

    @property
    def points(self) -> np.ndarray:
        """Poses at which it is measured."""
        return KINDS[self.specimen.machine].points[: self.poses]


@dataclass(frozen=True)
class MechanismOutcome(Outcome[MechanismCase]):
    """Outcome of a case.

    Attributes
    ----------
    noted : bool
        Whether the notes say that the motors did something else than the file says.
    """

    noted: bool = False


def run(case: MechanismCase) -> MechanismOutcome:
    """Measure, diagnose and judge a case."""
    specimen = case.specimen
    robot, (rows, text) = robot_of(specimen.machine), measured(case)
    diagnosis, fields = diagnosed(
        case.names,
        specimen.sizes,
        lambda: updating.diagnose(robot, measurements_of(text, robot), terms=False),
        same_of(specimen.machine),
    )
    lacking = specimen.effects or specimen.values or specimen.outside
    return MechanismOutcome(
        case=case,
        **fields,
        signal=signal(specimen, case.points, holdout=diagnosis.held_out_poses, rows=rows) if lacking else 0.0,
        noted=mentioned("drives", diagnosis.notes),
    )


def measured(case: MechanismCase) -> tuple[list[Identified], str]:
    """Return the modes found and the text of their file; the true uncertain values are drawn from their priors."""
    specimen = case.specimen
    kind, limits = KINDS[specimen.machine], band(specimen.machine)
    rng = np.random.default_rng(
        [case.seed, zlib.crc32(f"{specimen.machine} {case.suite}".encode()), case.number]
    )
    drawn = drawn_values(robot_of(specimen.machine), rng)
    shapes = kind.shapes if case.shapes else ()
    modes = replace(specimen, values={**drawn, **specimen.values}).modes(case.points)
    rows = identified(
        modes,
        rng=rng,
        sigma=SIGMA,
        missing=MISSING if case.realistic else 0.0,
        band=limits,
        shapes=shapes,
        shape_noise=SHAPE_NOISE,
        base_rigid=kind.rigid,
    )
    stated = limits if case.realistic and case.number % 4 == 0 else None
    text = written(
        rows, list(case.points), shapes, band=stated, components=kind.components, drives=drives_of(modes)
    )
    return rows, edited(text, case.edit, rng) if case.edit else text
