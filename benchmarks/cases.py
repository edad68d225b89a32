"""What a case of the suites is, and how it is measured.

In every case the true values of the uncertain parameters are drawn from their priors, so that the specimen is not the
one that its model declares.  Everything is fixed by seeds.
"""

from __future__ import annotations

import zlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from buildings import Building
from pkmodes.diagnosis.diagnose import split
from pkmodes_rig import (
    POSES,
    ROBOTS,
    SENSORS,
    Identified,
    Laboratory,
    TrueModes,
    identified,
    joined,
    mistaken,
    parsed,
    read,
    written,
)
from strengths import MODES, SEED, SIGMA, Truth, measurements

ROBOT_NAMES = tuple(ROBOTS)

#: An outlier of 25 standard deviations, and half of what few accelerometers would show missing.
OUTLIER, BLANK = 0.05, 0.5
#: Fewest rows of a file, and how many laboratories are asked for them.
LEAST, TRIALS = 2, 50
#: Range of gross errors where there are few rows: the smallest is 15 standard deviations.
GROSS = (0.03, 0.15)


@dataclass(frozen=True)
class Case:
    """A specimen on the rig, and how it is measured.

    Attributes
    ----------
    suite, number
        Which case it is.
    plan : str
        Poses of a robot; what tables say of a building.
    truth : Truth or Building
        What the specimen lacks or has wrong; the nuisance parameters are drawn in addition.
    names : tuple of str
        Candidates that should be named: none where nothing is missing, or nothing in the catalogue fits.
    kind : str
        What tables call it.
    shapes : tuple of str
        Shape components that are measured, where the case has no laboratory.
    options : mapping
        Of `pkmodes_rig.measurements.identified`; they replace those of the laboratory.
    edit : str
        What happens to the rows of the file, see `edited`.
    seed : int
        Of everything that is drawn, with suite and number.
    realistic : bool
        Whether a laboratory is drawn, with modes missed, nodes, a band and a varying number of modes.
    laboratory : Laboratory, optional
        One that is not drawn.
    poses : tuple of int
        Indices of the poses that are measured; all without any.
    rows : int
        Rows that the file is thinned to; 0 for all.
    mistake : str
        One of `pkmodes_rig.mistakes.MISTAKES`.
    """

    suite: str
    number: int
    plan: str
    truth: Truth | Building
    names: tuple[str, ...] = ()
    kind: str = ""
    shapes: tuple[str, ...] = SENSORS
    options: Mapping[str, object] = field(default_factory=dict)
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
        return f"{self.suite} {self.number}"

    @property
    def points(self) -> list[np.ndarray]:
        """Where it is measured; a building stays where it is."""
        if isinstance(self.truth, Building):
            return [np.zeros(3)] * len(self.truth.loads)
        points = POSES[self.truth.robot][self.plan]
        return [points[i] for i in self.poses or range(len(points))]


@dataclass(frozen=True)
class Trial:
    """A case that has been measured.

    Attributes
    ----------
    text : str
        The file.
    modes : list of TrueModes
        The truth at each pose.
    rows : list of Identified
        What was found, before any mistake.
    laboratory : Laboratory or None
        Who found it.
    """

    text: str
    modes: list[TrueModes]
    rows: list[Identified]
    laboratory: Laboratory | None


def measured(case: Case) -> str:
    """Text of the file of a case's measurements."""
    return tried(case).text


def tried(case: Case) -> Trial:
    """Measure a case."""
    rng = np.random.default_rng([case.seed, _key(case.suite), case.number])
    modes = _true(case, rng)
    for _ in range(TRIALS):
        laboratory = Laboratory.drawn(rng, *_expected(case)) if case.realistic else case.laboratory
        options: dict[str, object] = {"sigma": SIGMA, "modes": MODES, "shapes": case.shapes}
        options |= laboratory.options() if laboratory else {}
        options |= case.options
        stated = options.pop("band_stated", False)
        rows = identified(modes, rng=rng, **options)
        if len(rows) >= LEAST:  # nobody would send less
            break
    else:
        raise ValueError(f"{case.label} has hardly any modes to measure")
    if case.rows:
        kept = rng.permutation(len(rows))[: case.rows]
        rows = [rows[i] for i in sorted(kept)]
    text = written(
        rows,
        case.points,
        options["shapes"],
        band=options.get("band") if stated else None,
        sigma_shape=options.get("sigma_shape", "absent") != "absent",
    )
    text = edited(text, case.edit, rng) if case.edit else text
    return Trial(mistaken(text, case.mistake, rng) if case.mistake else text, modes, rows, laboratory)


#: Suites that were published before others were added: their places in that list are part of their seeds.
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
    uncertain = {path: q for path, q in read(case.truth.robot).quantities.items() if q.sigma}
    drawn = {path: q.value + q.sigma * rng.standard_normal() for path, q in uncertain.items()}
    return replace(case.truth, values={**drawn, **case.truth.values}).modes(case.points)


def _expected(case: Case) -> tuple[tuple[float, float], Sequence[str]]:
    """Lowest and highest frequency of the declared model, and where sensors can be."""
    if isinstance(case.truth, Building):
        frequencies = case.truth.declared().frequencies
        return (float(frequencies[0]), float(frequencies[-1])), case.truth.channels
    (modes,) = Truth(case.truth.robot).modes(case.points[:1])
    vibrations = modes.frequencies[modes.rigid :]
    return (float(vibrations[0]), float(vibrations[-1])), SENSORS


def edited(text: str, edit: str, rng: np.random.Generator) -> str:
    """Change the rows of a file: a gross error in a row that is fitted, another numbering, or blanks for shapes."""
    comments, rows = parsed(text)
    if edit == "outlier":
        fitted = fitted_poses(text)
        row = rows[rng.choice([i for i, r in enumerate(rows) if r["pose"] in fitted])]
        row["frequency"] = f"{float(row['frequency']) * (1.0 + OUTLIER):.9g}"
    if edit == "gross":
        row = rows[rng.integers(len(rows))]
        size = rng.uniform(*GROSS) * rng.choice([-1.0, 1.0])
        row["frequency"] = f"{float(row['frequency']) * (1.0 + size):.9g}"
        # Nobody hands in a row outside the band that the same file states.
        comments = [comment for comment in comments if "band" not in comment]
    for i, row in enumerate(rows):
        if edit == "numbers":
            row["mode"] = str(len(rows) - i)
        for name in [key for key in row if key.startswith("shape:")]:
            if edit == "blanks" and rng.random() < BLANK:
                row[name] = ""
    return joined(comments, rows)


def fitted_poses(text: str) -> list[str]:
    """Labels of the poses that a diagnosis fits."""
    data = measurements(text)
    return [data.labels[i] for i in split(data, None)[0]]
