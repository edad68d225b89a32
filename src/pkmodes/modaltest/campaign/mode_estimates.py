"""A mode as estimated from one file, or over repeats and setups; and the modes of one file, with their fit."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import MeasurementError
from pkmodes.core.robot.units import MAX_MAGNITUDE, MIN_MAGNITUDE
from pkmodes.modaltest.identification.estimates import Estimate, Mode, complex_mac
from pkmodes.modaltest.identification.level import LevelShift

#: Names of references that do not identify the point of the force: it may differ between setups.
NAMELESS = ("", "force")


@dataclass(frozen=True, eq=False)
class ModeEstimate:
    """A mode of a record, from one file or as the mean over several.

    - frequency: undamped [Hz]
    - damping: damping ratio; NaN where unknown
    - shape: by sensor or by channel, in one unit of acceleration or displacement, at any scale; without the
      components that were not measured
    - sigma_frequency, sigma_damping: standard deviations from the identification itself [Hz, 1]; 0 where it states
      none
    - sigma_shape: likewise for a component of the shape, relative to the largest one; NaN where unknown
    - found_in: number of model orders in which it was found, and their total
    - resolution: spacing below which the file does not resolve two modes [Hz]
    - level: level of its vibration in the file; NaN where unknown
    - shift: how the frequency changes with the level within the file; over several files, the largest change
    - participation: by named reference: its product with the shape is the residue, an acceleration per force
    - sigma_scale: standard deviation of the largest residue, relative; NaN where unknown
    - scatter: standard deviation of the mean frequency from the scatter of the repeats, relative; NaN for a single
      one
    - damping_scatter: likewise of the damping ratio, relative
    - shape_scatter: likewise of a component of the shape, relative to the largest
    - variance: unbiased variance of the mean of ln f from the scatter; `scatter` is larger, as few repeats estimate
      it badly
    - shift_between_files: how the frequency changes with the level of the files
    - files: indices of those over which it is the mean; empty for a mode of one file
    - lengths: what makes metres of the components of the shape that are angles, see `Campaign.lengths`
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
    sigma_scale: float = np.nan
    scatter: float = np.nan
    damping_scatter: float = np.nan
    shape_scatter: float = np.nan
    variance: float = np.nan
    shift_between_files: LevelShift | None = None
    files: tuple[int, ...] = ()
    lengths: Mapping[str, float] = field(default_factory=dict)


def mac(first: Mapping[str, complex], second: Mapping[str, complex], lengths: Mapping[str, float]) -> float:
    """Return the modal assurance criterion over the components common to both shapes; 1 for fewer than two.

    - lengths: what makes metres of the components that are angles

    Notes
    -----
    Allemang and Brown, Proc. 1st Int. Modal Analysis Conf., 1982.
    """
    common = [name for name in first if name in second]
    if len(common) < 2:
        return 1.0
    first, second = in_metres(first, lengths), in_metres(second, lengths)
    return complex_mac(*(np.array([shape[name] for name in common]) for shape in (first, second)))


def in_metres(shape: Mapping[str, complex], lengths: Mapping[str, float]) -> dict[str, complex]:
    """Return a shape whose components are all lengths; `lengths` are the factors of those that are angles."""
    return {name: value * lengths.get(name, 1.0) for name, value in shape.items()}


def check_shape(shape: Mapping[str, complex], where: str) -> None:
    """Refuse a shape of zeros, or of numbers whose squares overflow.

    Raises MeasurementError.
    """
    size = max((abs(value) for value in shape.values()), default=1.0)
    if not MIN_MAGNITUDE <= size <= MAX_MAGNITUDE:
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

    modes: tuple[ModeEstimate, ...]
    messages: tuple[str, ...]
    names_in_file: frozenset[str] | None
    added: tuple[ModeEstimate | str, ...] = ()
    fit: FileFit | None = None
    unnamed: tuple[str, ...] = ()
    forces: tuple[str, ...] = ()

    def map_modes(self, change: Callable[[ModeEstimate], ModeEstimate]) -> FileModes:
        """Return it with `change` applied to each mode, including those the user requested."""
        added = tuple(
            candidate if isinstance(candidate, str) else change(candidate) for candidate in self.added
        )
        return replace(self, modes=tuple(map(change, self.modes)), added=added)


def to_mode_estimate(mode: Mode, names: Sequence[str], references: Sequence[str] = ()) -> ModeEstimate:
    """Return a fitted mode with its shape by name, as accelerations, and its participations by reference."""
    shape = {
        name: complex(value) for name, value in zip(names, mode.shape, strict=True) if np.isfinite(value)
    }
    pairs = () if mode.participation is None else zip(references, mode.participation, strict=True)
    return ModeEstimate(
        mode.frequency,
        mode.damping,
        shape,
        mode.sigma_frequency,
        mode.sigma_damping,
        mode.sigma_shape,
        mode.found_in,
        participation={name: complex(value) for name, value in pairs if name not in NAMELESS},
        sigma_scale=mode.sigma_scale,
    )


def modes_from_fit(
    fit: FileFit,
    messages: Sequence[str],
    names_in_file: frozenset[str],
    convert: Callable[[Mode], ModeEstimate] | None = None,
) -> FileModes:
    """Return the modes of a file from its fit; `convert` takes the place of `to_mode_estimate`."""
    to_estimate = convert or (lambda mode: to_mode_estimate(mode, fit.responses, fit.references))
    return FileModes(
        tuple(to_estimate(mode) for mode in fit.estimate.modes),
        tuple(messages),
        names_in_file,
        tuple(
            candidate if isinstance(candidate, str) else to_estimate(candidate)
            for candidate in fit.estimate.added
        ),
        fit,
    )
