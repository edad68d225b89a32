"""A mode as found in one file or several; and the result of one file: its modes and the fit behind them."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import MeasurementError
from pkmodes.core.robot.units import LARGEST, SMALLEST
from pkmodes.modaltest.identification.estimates import Estimate, Mode, alike
from pkmodes.modaltest.identification.level import LevelShift

#: References that do not say where the force acts: it may act at a different place in each setup.
NAMELESS = ("", "force")


@dataclass(frozen=True, eq=False)
class Found:
    """A mode found in files.

    - frequency: undamped [Hz]
    - damping: damping ratio; NaN where unknown
    - shape: by sensor or by channel, in one unit of acceleration or displacement, at any scale; without the
      components that were not measured
    - sigma_frequency, sigma_damping: standard deviations from the identification itself [Hz, 1]; 0 where it states
      none
    - sigma_shape: likewise for a component of the shape, relative to the largest one; NaN where unknown
    - found_in: number of model orders in which it was found, and their total
    - resolution: spacing below which the file cannot tell two modes apart [Hz]
    - level: of its vibration in the file; NaN where unknown
    - shift: how the frequency changes with the level within the file; over several files, the largest change
    - participation: by named reference: its product with the shape is the residue, an acceleration per force
    - sigma_size: standard deviation of the largest residue, relative; NaN where unknown
    """

    frequency: float
    damping: float = np.nan
    shape: Mapping[str, complex] = field(default_factory=dict)
    sigma_frequency: float = 0.0
    sigma_damping: float = 0.0
    sigma_shape: float = np.nan
    found_in: tuple[int, int] | None = None
    resolution: float = 0.0
    level: float = np.nan
    shift: LevelShift | None = None
    participation: Mapping[str, complex] = field(default_factory=dict)
    sigma_size: float = np.nan


def mac(first: Mapping[str, complex], second: Mapping[str, complex]) -> float:
    """Return the modal assurance criterion over the components common to both shapes; 1 for fewer than two.

    Notes
    -----
    Allemang and Brown, Proc. 1st Int. Modal Analysis Conf., 1982.
    """
    common = [name for name in first if name in second]
    if len(common) < 2:
        return 1.0
    return alike(*(np.array([shape[name] for name in common]) for shape in (first, second)))


def check_shape(shape: Mapping[str, complex], where: str) -> None:
    """Refuse a shape of zeros, or of numbers whose squares overflow.

    Raises MeasurementError.
    """
    size = max((abs(value) for value in shape.values()), default=1.0)
    if not SMALLEST <= size <= LARGEST:
        problem = f"expected a mode shape, found components up to {size:g}"
        raise MeasurementError(problem, where, "leave the shape out where it was not measured")


@dataclass(frozen=True, eq=False)
class FileFit:
    """The fit of a file, kept for inspection.

    - estimate: its functions are S responses per R references, or S power spectra
    - responses, references: names of the S responses and the R references; no references for spectra
    - coherence: on the lines of the estimate, (F, S, R)
    """

    estimate: Estimate
    responses: tuple[str, ...]
    references: tuple[str, ...] = ()
    coherence: NDArray[np.float64] | None = None


@dataclass(frozen=True, eq=False)
class FileModes:
    """The modes of a file.

    - messages: what the user should know
    - names_in_file: names of the sensors and, without their signs, of the forces in the file; None if it needs none
    - added: for each frequency at which the user requested a mode: the mode, or why there is none
    - fit: None for modes that are already identified
    - unnamed: references of the file, if the campaign names none of them: its shapes are then at the sensors
    - forces: names of the forces at whose places the shapes are defined; empty if they are at the sensors
    """

    modes: tuple[Found, ...]
    messages: tuple[str, ...]
    names_in_file: frozenset[str] | None
    added: tuple[Found | str, ...] = ()
    fit: FileFit | None = None
    unnamed: tuple[str, ...] = ()
    forces: tuple[str, ...] = ()

    def changed(self, change: Callable[[Found], Found]) -> FileModes:
        """Return it with `change` applied to each mode, including those the user requested."""
        added = tuple(
            candidate if isinstance(candidate, str) else change(candidate) for candidate in self.added
        )
        return replace(self, modes=tuple(map(change, self.modes)), added=added)


def found_of(mode: Mode, names: Sequence[str], references: Sequence[str] = ()) -> Found:
    """Return a fitted mode with its shape by name, as accelerations, and its participations by reference."""
    shape = {
        name: complex(value) for name, value in zip(names, mode.shape, strict=True) if np.isfinite(value)
    }
    pairs = () if mode.participation is None else zip(references, mode.participation, strict=True)
    return Found(
        mode.frequency,
        mode.damping,
        shape,
        mode.sigma_frequency,
        mode.sigma_damping,
        mode.sigma_shape,
        mode.found_in,
        participation={name: complex(value) for name, value in pairs if name not in NAMELESS},
        sigma_size=mode.sigma_size,
    )


def modes_of_fit(
    fit: FileFit,
    messages: Sequence[str],
    names_in_file: frozenset[str],
    convert: Callable[[Mode], Found] | None = None,
) -> FileModes:
    """Return the modes of a file from its fit; `convert` turns a fitted mode into one of the file, as `found_of`."""
    made = convert or (lambda mode: found_of(mode, fit.responses, fit.references))
    return FileModes(
        tuple(made(mode) for mode in fit.estimate.modes),
        tuple(messages),
        names_in_file,
        tuple(
            candidate if isinstance(candidate, str) else made(candidate) for candidate in fit.estimate.added
        ),
        fit,
    )
