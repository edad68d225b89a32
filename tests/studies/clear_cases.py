"""Clear causes on all mechanisms alike: the specimens, and how they are sized, measured, diagnosed and judged.

Each case has a laboratory of its own (`pkmodes_rig.laboratory`), and its causes are sized so that the modes that this
laboratory finds have the predicted signal asked for: a cause is neither hidden nor obvious.
"""

from __future__ import annotations

import zlib
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cache

import numpy as np

from pkmodes import updating
from pkmodes_rig import Identified, Laboratory, drawn_values, drives_of, identified, written
from studies.judging import diagnosed, same_of
from studies.motors import words
from studies.running import Outcome
from studies.sizes import TYING
from studies.specimens import (
    MACHINES,
    PLATFORM,
    SIX_LEGGED,
    Specimen,
    measurements_of,
    robot_of,
    with_effect,
    with_outside,
)
from studies.strengths import signal

#: Numbers of modes at a pose, by the number of vibration modes of the mechanism.
MODES = {
    "linear_delta": (4, 8),
    "rotary_delta": (2, 6),
    "corexy": (2, 4),
    "hexapod": (4, 6),
    "hexaglide": (6, 12),
}
#: Distance over which accelerometers measure how a platform turns [m], and what tells the draw of poses from others.
LEVER, OF_POSES = 0.1, 6
#: Fewest rows of a file, and how many laboratories are drawn to get them, and to see a cause.
LEAST, TRIALS, LABORATORIES = 12, 50, 10
#: First size of the search for one in SI units, far below any result, and its largest number of steps; the factor
#: beyond the size at which an added mode is first seen.
START, STEPS, BEYOND = 1e-12, 40, 1.5


@dataclass(frozen=True)
class ClearCase:
    """One or two causes of a given signal, and how they are measured.

    Attributes
    ----------
    suite, number, seed
        Identify the case and its random draws.
    machine : str
        One of `MACHINES`.
    kinds : tuple of str
        Effects of the catalogue, or one cause outside it.
    targets : tuple of two floats
        Range of the predicted signal of each cause alone.
    outside : bool
        Whether the cause is outside the catalogue.
    laboratory : int
        Number of the laboratory; earlier ones cannot see a cause, of whatever size.
    drives : str
        What the motors do: ``free`` or ``held``.
    """

    suite: str
    number: int
    machine: str
    kinds: tuple[str, ...]
    targets: tuple[float, float]
    outside: bool = False
    seed: int = 1
    laboratory: int = 0
    drives: str = "free"

    @property
    def label(self) -> str:
        """Name for reports."""
        return f"{self.machine}, {self.suite} {self.number}{words(self.drives)}"

    @property
    def points(self) -> np.ndarray:
        """Poses at which it is measured; for a machine with six legs drawn in the box of its own."""
        points = MACHINES[self.machine].points
        if self.machine not in SIX_LEGGED:
            return points
        rng = np.random.default_rng([*_seeds(self), OF_POSES])
        return np.round(rng.uniform(points.min(axis=0), points.max(axis=0), points.shape), 4)

    @property
    def sensors(self) -> tuple[str, ...]:
        """Sensors of the laboratory; for a machine with six legs on the platform, or on the legs or carriages."""
        shapes = MACHINES[self.machine].shapes
        if self.machine not in SIX_LEGGED:
            return shapes
        return PLATFORM if self.number % 2 else tuple(name for name in shapes if name not in PLATFORM)

    @property
    def mechanism(self) -> str:
        """Name of the mechanism."""
        return robot_of(self.machine).mechanism_name

    @property
    def names(self) -> tuple[str, ...]:
        """Causes that should be named."""
        return () if self.outside else self.kinds


@dataclass(frozen=True)
class ClearOutcome(Outcome[ClearCase]):
    """Outcome of a case with some poses held out, measured in so many rows."""

    rows: int = 0


def run(case: ClearCase) -> ClearOutcome:
    """Measure, diagnose and judge a case."""
    specimen, rows, text = measured(case)
    return _diagnosed(case, specimen, rows, text, None)


def splits(case: ClearCase) -> list[ClearOutcome]:
    """Diagnose a case once for each pose, with that pose alone held out."""
    specimen, rows, text = measured(case)
    labels = measurements_of(text, robot_of(case.machine)).labels
    return [_diagnosed(case, specimen, rows, text, [label]) for label in labels]


def _diagnosed(
    case: ClearCase,
    specimen: Specimen,
    rows: Sequence[Identified],
    text: str,
    holdout: Sequence[str] | None,
) -> ClearOutcome:
    robot = robot_of(case.machine)
    diagnosis, fields = diagnosed(
        case.names,
        specimen.sizes,
        lambda: updating.diagnose(robot, measurements_of(text, robot), holdout=holdout, terms=False),
        same_of(case.machine),
    )
    predicted = signal(specimen, case.points, holdout=diagnosis.held_out_poses, rows=rows)
    return ClearOutcome(case=case, **fields, signal=predicted, rows=len(rows))


class UnseenError(Exception):
    """No size of a cause has the wanted signal among the modes that a laboratory finds."""


def measured(case: ClearCase) -> tuple[Specimen, list[Identified], str]:
    """Return the specimen with its causes sized, the modes found and the text of their file.

    Raises
    ------
    UnseenError
        If several laboratories cannot see a cause.
    """
    for number in range(LABORATORIES - 1):
        with suppress(UnseenError):
            return _measured(replace(case, laboratory=number))
    return _measured(replace(case, laboratory=LABORATORIES - 1))


def _measured(case: ClearCase) -> tuple[Specimen, list[Identified], str]:
    each = [_alone(case, kind, _size(case, place)) for place, kind in enumerate(case.kinds)]
    both = Specimen(
        case.machine,
        {name: size for one in each for name, size in one.effects.items()},
        outside={name: size for one in each for name, size in one.outside.items()},
        drives=case.drives,
    )
    rows, text = found(case, both)
    return both, rows, text


def _alone(case: ClearCase, kind: str, size: float) -> Specimen:
    """Return a machine with one cause."""
    return replace(
        (with_outside if case.outside else with_effect)(case.machine, kind, size), drives=case.drives
    )


def _size(case: ClearCase, place: int) -> float:
    """Find a size of one of the causes whose predicted signal is a value drawn from the range asked for.

    The modes found change with the size, so the signal may jump beyond the range: an added mode is seen or not.  The
    size at which it is first seen is then exceeded by a factor, because a mode that is seen once shows no cause.
    """
    kind, rng = case.kinds[place], np.random.default_rng([*_seeds(case), place])
    target = float(np.exp(rng.uniform(*np.log(case.targets))))

    def measured_signal(size: float) -> float:
        specimen = _alone(case, kind, size)
        least = MACHINES[case.machine].rigid if kind in TYING and case.drives == "free" else 0
        rows = [row for row in found(case, specimen)[0] if row.mode >= least]
        return signal(specimen, case.points, rows=rows) if rows else 0.0

    low, high, size = 0.0, 0.0, START
    for _ in range(STEPS):
        value = measured_signal(size)
        if target / 1.05 <= value <= target * 1.05:
            return size
        if value < target:
            low = size
            # The signal grows in proportion to a small size, until a mode is added.
            most = 10.0 if value < 1e-3 * target else 3.0
            size = size * min(max(target / max(value, 1e-9), 1.5), most) if not high else (low * high) ** 0.5
        else:
            high = size
            size = (low * high) ** 0.5 if low else size / 10.0
        if high and low and high / low < 1.02:
            break
    if not high:
        raise UnseenError(f"{case.label}: no size of {kind} has a signal of {target:.3g}")
    return BEYOND * high


def found(case: ClearCase, specimen: Specimen) -> tuple[list[Identified], str]:
    """Return the modes that the laboratory of a case finds and the text of their file.

    The true uncertain values are drawn from their priors.
    """
    kind, rng = MACHINES[case.machine], np.random.default_rng(_seeds(case))
    drawn = drawn_values(robot_of(case.machine), rng)
    true = replace(specimen, values={**drawn, **specimen.values})
    modes = true.modes(case.points)
    for _ in range(TRIALS):
        laboratory = Laboratory.drawn(
            rng, _span(case.machine, case.drives), case.sensors, modes=MODES[case.mechanism]
        )
        options = laboratory.options()
        stated = options.pop("band_stated")
        lever = LEVER if case.machine in SIX_LEGGED else 0.0
        rows = identified(modes, rng=rng, base_rigid=kind.rigid, lever=lever, **options)  # type: ignore[arg-type]
        if len(rows) >= LEAST:
            break
    text = written(
        rows,
        list(case.points),
        laboratory.shapes,
        band=laboratory.band if stated else None,
        sigma_shape=laboratory.sigma_shape != "absent",
        components=kind.components,
        drives=drives_of(modes),
    )
    return rows, text


@cache
def _span(machine: str, drives: str) -> tuple[float, float]:
    """Return the lowest and highest vibration frequency of the declared model at the first pose [Hz]."""
    (modes,) = Specimen(machine, drives=drives).modes(MACHINES[machine].points[:1])
    vibrations = modes.frequencies[modes.rigid :]
    return float(vibrations[0]), float(vibrations[-1])


def _seeds(case: ClearCase) -> list[int]:
    key = zlib.crc32(f"{case.machine} {case.suite}".encode())
    return [case.seed, key, case.number + 1000 * case.laboratory]
