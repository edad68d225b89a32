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
from pkmodes_rig import Identified, Laboratory, drawn_values, identified, written
from pkmodes_rig.suites.judging import diagnosed, same_of
from pkmodes_rig.suites.running import Outcome
from pkmodes_rig.suites.sizes import TYING
from pkmodes_rig.suites.specimens import (
    MACHINES,
    Specimen,
    measurements_of,
    robot_of,
    with_effect,
    with_outside,
)
from pkmodes_rig.suites.strengths import signal

#: Numbers of modes at a pose, by the number of vibration modes of the mechanism.
MODES = {"linear_delta": (4, 8), "rotary_delta": (2, 6), "corexy": (2, 4)}
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
    """

    suite: str
    number: int
    machine: str
    kinds: tuple[str, ...]
    targets: tuple[float, float]
    outside: bool = False
    seed: int = 1
    laboratory: int = 0

    @property
    def label(self) -> str:
        """Name for reports."""
        return f"{self.machine}, {self.suite} {self.number}"

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
    robot, kind = robot_of(case.machine), MACHINES[case.machine]
    diagnosis, said = diagnosed(
        case.names,
        specimen.sizes,
        lambda: updating.diagnose(robot, measurements_of(text, robot), holdout=holdout),
        same_of(case.machine),
    )
    predicted = signal(specimen, kind.points, holdout=diagnosis.held_out_poses, rows=rows)
    return ClearOutcome(case=case, **said, signal=predicted, rows=len(rows))


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
    )
    rows, text = _found(case, both)
    return both, rows, text


def _alone(case: ClearCase, kind: str, size: float) -> Specimen:
    """Return a machine with one cause."""
    return (with_outside if case.outside else with_effect)(case.machine, kind, size)


def _size(case: ClearCase, place: int) -> float:
    """Find a size of one of the causes whose predicted signal is a value drawn from the range asked for.

    The modes found change with the size, so the signal may jump beyond the range: an added mode is seen or not.  The
    size at which it is first seen is then exceeded by a factor, because a mode that is seen once shows no cause.
    """
    kind, rng = case.kinds[place], np.random.default_rng([*_seeds(case), place])
    target = float(np.exp(rng.uniform(*np.log(case.targets))))

    def measured_signal(size: float) -> float:
        specimen = _alone(case, kind, size)
        least = MACHINES[case.machine].rigid if kind in TYING else 0
        rows = [row for row in _found(case, specimen)[0] if row.mode >= least]
        return signal(specimen, MACHINES[case.machine].points, rows=rows) if rows else 0.0

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


def _found(case: ClearCase, specimen: Specimen) -> tuple[list[Identified], str]:
    """Return the modes that the laboratory of a case finds and the text of their file.

    The true uncertain values are drawn from their priors.
    """
    kind, rng = MACHINES[case.machine], np.random.default_rng(_seeds(case))
    drawn = drawn_values(robot_of(case.machine), rng)
    true = replace(specimen, values={**drawn, **specimen.values})
    modes = true.modes(kind.points)
    for _ in range(TRIALS):
        laboratory = Laboratory.drawn(rng, _span(case.machine), kind.shapes, modes=MODES[case.mechanism])
        options = laboratory.options()
        stated = options.pop("band_stated")
        rows = identified(modes, rng=rng, base_rigid=kind.rigid, **options)  # type: ignore[arg-type]
        if len(rows) >= LEAST:
            break
    text = written(
        rows,
        list(kind.points),
        laboratory.shapes,
        band=laboratory.band if stated else None,
        sigma_shape=laboratory.sigma_shape != "absent",
        components=kind.components,
    )
    return rows, text


@cache
def _span(machine: str) -> tuple[float, float]:
    """Return the lowest and highest vibration frequency of the declared model at the first pose [Hz]."""
    (modes,) = Specimen(machine).modes(MACHINES[machine].points[:1])
    vibrations = modes.frequencies[modes.rigid :]
    return float(vibrations[0]), float(vibrations[-1])


def _seeds(case: ClearCase) -> list[int]:
    key = zlib.crc32(f"{case.machine} {case.suite}".encode())
    return [case.seed, key, case.number + 1000 * case.laboratory]
