"""Cases of the suites, and how they are measured.

In every case the true values of the uncertain parameters are drawn from their priors, so the specimen differs from
its declared model.  Everything is fixed by seeds.
"""

from __future__ import annotations

import zlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from pkmodes.loop.diagnosis.one_state import split_setups
from pkmodes_rig import (
    POSES,
    ROBOTS,
    SENSORS,
    Identified,
    Laboratory,
    TrueModes,
    drawn_values,
    drives_of,
    identified,
    joined,
    mistaken,
    parsed,
    written,
)
from studies.buildings import Building
from studies.motors import OTHER_DRIVES, words
from studies.specimens import MODES, SIGMA, Specimen, measurements, robot_of
from studies.strengths import SEED

ROBOT_NAMES = tuple(ROBOTS)

#: Relative size of an outlier (25 standard deviations), and fraction of shape components left blank.
OUTLIER, BLANK = 0.05, 0.5
#: Fewest rows of a file, and how many laboratories are drawn to get them.
LEAST, TRIALS = 2, 50
#: Range of gross errors in files with few rows: the smallest is 15 standard deviations.
GROSS = (0.03, 0.15)


@dataclass(frozen=True)
class Case:
    """A specimen on the rig, and how it is measured.

    Attributes
    ----------
    suite, number
        Identify the case.
    plan : str
        Poses of a robot; for a building, its description in tables.
    truth : Specimen or Building
        How the specimen differs from its declaration; the uncertain values are drawn in addition.
    names : tuple of str
        Candidates that should be named: none if nothing is missing, or if the cause is outside the catalogue.
    kind : str
        Its name in tables.
    shapes : tuple of str
        Measured shape components, for a case without a laboratory.
    options : mapping
        Options of `pkmodes_rig.measurements.identified`, overriding those of the laboratory.
    edit : str
        How the rows of the file are edited, see `edited`.
    seed : int
        Seed of all random draws, together with suite and number.
    realistic : bool
        Whether a laboratory is drawn, with missed modes, nodes, a band and a varying number of modes.
    laboratory : Laboratory, optional
        A fixed laboratory, instead of a drawn one.
    poses : tuple of int
        Indices of the measured poses; if empty, all.
    rows : int
        Number of rows to which the file is thinned; 0 for all.
    mistake : str
        One of `pkmodes_rig.mistakes.MISTAKES`, or empty.
    """

    suite: str
    number: int
    plan: str
    truth: Specimen | Building
    names: tuple[str, ...] = ()
    kind: str = ""
    shapes: tuple[str, ...] = SENSORS
    options: Mapping[str, Any] = field(default_factory=dict)
    edit: str = ""
    seed: int = SEED
    realistic: bool = False
    laboratory: Laboratory | None = None
    poses: tuple[int, ...] = ()
    rows: int = 0
    mistake: str = ""

    @property
    def label(self) -> str:
        """Name for reports."""
        return f"{self.suite} {self.number}{words(self.drives)}"

    @property
    def drives(self) -> str:
        """What the motors do in the test."""
        return "free" if isinstance(self.truth, Building) else self.truth.drives

    @property
    def points(self) -> list[np.ndarray]:
        """Points at which it is measured; for a building, the origin."""
        if isinstance(self.truth, Building):
            return [np.zeros(3)] * len(self.truth.loads)
        points = POSES[self.truth.machine][self.plan]
        return [points[i] for i in self.poses or range(len(points))]


@dataclass(frozen=True)
class Trial:
    """A measured case.

    Attributes
    ----------
    text : str
        Contents of the measurement file.
    modes : list of TrueModes
        True modes at each pose.
    rows : list of Identified
        Identified modes, before any mistake.
    laboratory : Laboratory or None
        The laboratory that identified them.
    """

    text: str
    modes: list[TrueModes]
    rows: list[Identified]
    laboratory: Laboratory | None


def measured(case: Case) -> str:
    """Return the contents of the measurement file of a case."""
    return tried(case).text


def tried(case: Case) -> Trial:
    """Measure a case."""
    rng = np.random.default_rng([case.seed, _key(case.suite), case.number])
    modes = _true(case, rng)
    for _ in range(TRIALS):
        laboratory = Laboratory.drawn(rng, *_expected(case)) if case.realistic else case.laboratory
        options: dict[str, Any] = {"sigma": SIGMA, "modes": MODES, "shapes": case.shapes}
        options |= laboratory.options() if laboratory else {}
        options |= case.options
        stated = options.pop("band_stated", False)
        rows = identified(modes, rng=rng, **options)
        if len(rows) >= LEAST:  # nobody would submit fewer
            break
    else:
        raise ValueError(f"{case.label} has hardly any measurable modes")
    if case.rows:
        kept = rng.permutation(len(rows))[: case.rows]
        rows = [rows[i] for i in sorted(kept)]
    text = written(
        rows,
        case.points,
        options["shapes"],
        band=options.get("band") if stated else None,
        sigma_shape=options.get("sigma_shape", "absent") != "absent",
        drives=drives_of(modes),
    )
    text = edited(text, case.edit, rng) if case.edit else text
    return Trial(mistaken(text, case.mistake, rng) if case.mistake else text, modes, rows, laboratory)


#: Suites published first: their positions in this list are part of their seeds.
FIRST = (
    "nothing missing",
    "one effect",
    "wrong parameter",
    "two effects",
    "outside the catalogue",
    "special",
)


def _key(suite: str) -> int:
    return FIRST.index(suite) if suite in FIRST else zlib.crc32(suite.encode())


def _true(case: Case, rng: np.random.Generator) -> list[TrueModes]:
    if isinstance(case.truth, Building):
        return case.truth.modes(rng)
    drawn = drawn_values(robot_of(case.truth.machine), rng)
    return replace(case.truth, values={**drawn, **case.truth.values}).modes(case.points)


def _expected(case: Case) -> tuple[tuple[float, float], Sequence[str]]:
    """Return the lowest and highest frequency of the declared model, and the possible sensor channels."""
    if isinstance(case.truth, Building):
        frequencies = case.truth.declared().frequencies
        return (float(frequencies[0]), float(frequencies[-1])), case.truth.channels
    poses = 2 if case.drives == "mixed" else 1  # one with free and one with held motors
    modes = Specimen(case.truth.machine, drives=case.drives).modes(case.points[:poses])
    lowest = min(float(m.frequencies[m.rigid]) for m in modes)
    return (lowest, max(float(m.frequencies[-1]) for m in modes)), SENSORS


def edited(text: str, edit: str, rng: np.random.Generator) -> str:
    """Edit a file: a gross error in a fitted or any row, another numbering, blank shape components, or other drives.

    With other drives, a file says that the motors were free where they were held, or held if they were free.
    """
    comments, rows = parsed(text)
    if edit == OTHER_DRIVES:
        drives = [comment for comment in comments if "drives" in comment]
        held = bool(drives) or "drives" in rows[0]
        comments = [*(c for c in comments if c not in drives), *([] if held else ["# drives: held"])]
        rows = [{name: cell for name, cell in row.items() if name != "drives"} for row in rows]
    if edit == "outlier":
        fitted = fitted_poses(text)
        row = rows[rng.choice([i for i, r in enumerate(rows) if r["pose"] in fitted])]
        row["frequency"] = f"{float(row['frequency']) * (1.0 + OUTLIER):.9g}"
    if edit == "gross":
        row = rows[rng.integers(len(rows))]
        size = rng.uniform(*GROSS) * rng.choice([-1.0, 1.0])
        row["frequency"] = f"{float(row['frequency']) * (1.0 + size):.9g}"
        # Nobody submits a row outside the band stated in the same file.
        comments = [comment for comment in comments if "band" not in comment]
    for i, row in enumerate(rows):
        if edit == "numbers":
            row["mode"] = str(len(rows) - i)
        for name in [key for key in row if key.startswith("shape:")]:
            if edit == "blanks" and rng.random() < BLANK:
                row[name] = ""
    return joined(comments, rows)


def fitted_poses(text: str) -> list[str]:
    """Return the labels of the poses that a diagnosis fits."""
    data = measurements(text)
    return [data.labels[i] for i in split_setups(data, None)[0]]
