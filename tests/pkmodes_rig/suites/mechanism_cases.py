"""Cases for the rotary delta and the CoreXY: the specimens, and how they are measured, diagnosed and judged.

The rigs (`pkmodes_rig.corexy`, `pkmodes_rig.rotary_delta`) share no code with the model.  `strengths` defines the
predicted signal; measurements are made as for the linear delta, except that all modes in a band are sought.
"""

from __future__ import annotations

import tempfile
import time
import zlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cache
from pathlib import Path

import numpy as np

from pkmodes import updating
from pkmodes.core.robot.reading import read_robot
from pkmodes.core.robot.robot import Robot
from pkmodes.diagnosis.diagnose import split
from pkmodes.diagnosis.fit.fitter import Fitter
from pkmodes.diagnosis.fit.hypothesis import Hypothesis
from pkmodes.diagnosis.verdict.result import Diagnosis
from pkmodes.measured.measurements import Measurements
from pkmodes.sensitivity.paths import moved, resolve
from pkmodes.updating.measured_robot import MeasuredRobot
from pkmodes_rig import (
    BASE_RIGID,
    POSES,
    SENSORS,
    Identified,
    TrueModes,
    corexy,
    drawn_values,
    drives_of,
    exact,
    held_at,
    identified,
    read,
    rotary_delta,
    true_modes,
    written,
)
from pkmodes_rig import ROBOTS as DELTAS
from pkmodes_rig.suites.cases import edited
from pkmodes_rig.suites.judging import SAME, judged, mentioned
from pkmodes_rig.suites.motors import words
from pkmodes_rig.suites.strengths import NO_WEIGHT

ROBOTS = Path(__file__).resolve().parents[3] / "robots"

#: Standard deviations of ln f, and of shapes relative to their largest component; part of the modes missed in a
#: realistic case.
SIGMA, SHAPE_NOISE, MISSING = 0.002, 0.02, 0.15
#: The band: lowest frequency [Hz], highest relative to the highest frequency of the declared model at any pose.
LOWEST, HIGHEST = 2.0, 1.25


def _inertias(prefix: str, *more: str) -> tuple[str, ...]:
    return tuple(f"parameter:{prefix}{name}" for name in ("motor.inertia", "motor.gear_ratio", *more))


def _equivalent(*groups: tuple[str, ...]) -> dict[str, tuple[str, ...]]:
    return {name: group for group in groups for name in group}


@dataclass(frozen=True)
class Kind:
    """A mechanism on the rig.

    Attributes
    ----------
    file : str
        The robot's file in ``robots/``; empty for a linear delta of the rig.
    rig : callable
        Returns the true modes for parameters, pose, effects and outside causes.
    rigid : int
        Number of modes that strain nothing.
    components, shapes : tuple of str
        Components of a pose, and sensor channels.
    points : ndarray, shape (12, d)
        Poses.
    same : dict
        Candidates equivalent to the truth whatever is measured, like `judging.SAME`.
    """

    file: str
    rig: Callable[..., TrueModes]
    rigid: int
    components: tuple[str, ...]
    shapes: tuple[str, ...]
    points: np.ndarray
    same: Mapping[str, tuple[str, ...]]


def _spread(count: int, low: Sequence[float], high: Sequence[float]) -> np.ndarray:
    """Return poses that fill a box evenly, none on a plane of symmetry (Roberts' sequence R_d)."""
    d = len(low)
    golden = 2.0
    for _ in range(60):
        golden = (1.0 + golden) ** (1.0 / (d + 1))
    unit = (0.5 + np.outer(np.arange(1, count + 1), golden ** -np.arange(1.0, d + 1))) % 1.0
    return np.round(low + unit * (np.array(high) - low), 3)


KINDS = {
    "rotary_delta": Kind(
        "clavel-delta.toml",
        rotary_delta,
        3,
        ("x", "y", "z"),
        ("theta_1", "theta_2", "theta_3", "p_x", "p_y", "p_z"),
        _spread(12, (-0.15, -0.15, -0.62), (0.15, 0.15, -0.42)),
        # Only inertia * gear_ratio^2 at phi_j enters the modes.
        _equivalent(("gearbox_inertia", *_inertias("")), _inertias("axis.2.")),
    ),
    "corexy": Kind(
        "corexy-printer.toml",
        corexy,
        2,
        ("x", "y"),
        ("x", "y", "p_x", "p_y"),
        _spread(12, (0.0, 0.0), (0.3, 0.3)),
        # With rigid shafts, the modes depend only on (inertias at theta_i) / radius^2: theta_i is not measured here.
        # Another belt width changes the stiffness of each belt; and because the common stiffness is uncertain,
        # another width of one belt is equivalent to unequal stiffness of the two.
        _equivalent(
            ("gearbox_inertia", *_inertias("", "pulley.inertia", "pulley.radius")),
            _inertias("belt_path.2.", "pulley.inertia", "pulley.radius"),
        )
        | {
            "parameter:belt.width": ("axis_belt_stiffness",),
            "axis_belt_stiffness": tuple(f"parameter:belt_path.{i}.belt.width" for i in (1, 2)),
        },
    ),
}


#: These mechanisms, and the linear deltas of the rig, by name.
MACHINES = KINDS | {
    name: Kind("", true_modes, BASE_RIGID, ("x", "y", "z"), SENSORS, np.array(POSES[name]["scattered"]), SAME)
    for name in DELTAS
}


@dataclass(frozen=True)
class Specimen:
    """True state of one of `MACHINES`; `effects`, `values`, `outside` and `drives` as in `strengths.Truth`."""

    mechanism: str
    effects: Mapping[str, float] = field(default_factory=dict)
    values: Mapping[str, float] = field(default_factory=dict)
    outside: Mapping[str, float] = field(default_factory=dict)
    drives: str = "free"

    def built(self) -> Robot:
        """Return the robot with its true values."""
        declared = robot_of(self.mechanism)
        paths = [(resolve(declared, path), value) for path, value in self.values.items()]
        return moved(declared, [(path, value - path.value) for path, value in paths])

    def modes(self, points: np.ndarray) -> list[TrueModes]:
        """Return the true modes at some poses."""
        robot = self.built()
        effects = {**robot.constants, **self.effects}
        rig = MACHINES[self.mechanism].rig
        held = held_at(self.drives, len(points))
        return [
            rig(robot.parameters, p, effects, self.outside, held=h) for p, h in zip(points, held, strict=True)
        ]


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
        return f"{self.specimen.mechanism}, {self.suite} {self.number}{words(self.specimen.drives)}"


@dataclass(frozen=True)
class MechanismOutcome:
    """Outcome of a case, as in `judging.Outcome`."""

    case: MechanismCase
    state: str
    verdict: str
    classes: tuple[tuple[str, ...], ...]
    values: tuple[tuple[str, float, float, float], ...] = ()
    signal: float = 0.0
    seconds: float = 0.0
    reason: str = ""
    noted: bool = False


def run(case: MechanismCase) -> MechanismOutcome:
    """Measure, diagnose and judge a case."""
    kind, robot = KINDS[case.specimen.mechanism], robot_of(case.specimen.mechanism)
    rows, text = measured(case)
    start = time.perf_counter()
    diagnosis = updating.diagnose(robot, measurements_of(text, robot))
    seconds = time.perf_counter() - start
    specimen = case.specimen
    lacking = specimen.effects or specimen.values or specimen.outside
    return MechanismOutcome(
        case=case,
        state=judged(case.names, diagnosis, same=kind.same),
        verdict=diagnosis.verdict,
        classes=tuple(f.members for f in diagnosis.effects) or diagnosis.survivors,
        values=tuple(values_of(specimen, case.names, diagnosis)),
        signal=signal(specimen, case.poses, holdout=diagnosis.held_out_poses, rows=rows) if lacking else 0.0,
        seconds=seconds,
        reason=diagnosis.reason,
        noted=mentioned("drives", diagnosis.notes),
    )


def measured(case: MechanismCase) -> tuple[list[Identified], str]:
    """Return the modes found and the text of their file; the true uncertain values are drawn from their priors."""
    specimen = case.specimen
    kind, robot = KINDS[specimen.mechanism], robot_of(specimen.mechanism)
    rng = np.random.default_rng(
        [case.seed, zlib.crc32(f"{specimen.mechanism} {case.suite}".encode()), case.number]
    )
    drawn = drawn_values(robot, rng)
    points = kind.points[: case.poses]
    shapes, limits = kind.shapes if case.shapes else (), band(specimen.mechanism)
    modes = replace(specimen, values={**drawn, **specimen.values}).modes(points)
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
        rows, list(points), shapes, band=stated, components=kind.components, drives=drives_of(modes)
    )
    return rows, edited(text, case.edit, rng) if case.edit else text


def signal(
    specimen: Specimen,
    poses: int = 12,
    *,
    holdout: Sequence[str] | None = None,
    rows: Sequence[Identified] | None = None,
    tied: bool = True,
) -> float:
    """Compute the predicted signal of a specimen's causes, as defined by `strengths.signal`."""
    kind, robot = MACHINES[specimen.mechanism], robot_of(specimen.mechanism)
    points = kind.points[:poses]
    modes = specimen.modes(points)
    if rows is None:
        seen = [m if tied else replace(m, rigid=kind.rigid) for m in modes]
        rows = identified(
            seen,
            rng=np.random.default_rng(0),
            sigma=SIGMA,
            band=band(specimen.mechanism),
            base_rigid=kind.rigid,
        )
    # Shapes serve only to pair the modes; the signal is computed from the frequencies.
    text = written(
        exact(rows, modes, kind.shapes),
        list(points),
        kind.shapes,
        components=kind.components,
        drives=drives_of(modes),
    )
    data = measurements_of(text, robot)
    fitted, _ = split(data, holdout)
    structure = MeasuredRobot.of(robot, data).structure(candidates=()).subset(fitted)
    fitter = Fitter(structure, data.at(fitted), scatter=NO_WEIGHT)
    fit = fitter.fit(Hypothesis(()), fitter.declared.copy())
    if fit is None:
        raise ValueError(f"the declared model of {specimen.mechanism} cannot be evaluated")
    return float(np.sqrt(fit.chi2))


@cache
def robot_of(machine: str) -> Robot:
    """Return the declared robot."""
    return read(machine) if machine in DELTAS else read_robot(ROBOTS / KINDS[machine].file)


@cache
def band(machine: str) -> tuple[float, float]:
    """Return the frequency band that is searched for modes [Hz]."""
    highest = [modes.frequencies[-1] for modes in Specimen(machine).modes(MACHINES[machine].points)]
    return LOWEST, float(f"{HIGHEST * max(highest):.3g}")


def measurements_of(text: str, robot: Robot) -> Measurements:
    """Read the text of a measurement file."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "modes.csv"
        path.write_text(text, encoding="utf-8")
        return updating.read(path, robot=robot)


def values_of(
    specimen: Specimen, names: Sequence[str], diagnosis: Diagnosis
) -> list[tuple[str, float, float, float]]:
    """Return the parameters of the causes that were named: estimate, standard deviation and true value."""
    true = {**specimen.values, **{f"effects.{n}": v for n, v in specimen.effects.items()}}
    return [
        (value.name, value.value, value.sigma, true[value.name])
        for finding in diagnosis.effects
        for name in names
        for value in finding.alternatives.get(name, ())
        if value.name in true
    ]
