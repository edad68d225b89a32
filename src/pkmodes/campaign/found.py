"""A mode as one file, or several together, show it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from pkmodes.core.base.errors import MeasurementError
from pkmodes.core.robot.units import LARGEST, SMALLEST
from pkmodes.identification.estimates import alike
from pkmodes.identification.level import LevelShift


@dataclass(frozen=True, eq=False)
class Found:
    """A mode found in files.

    Attributes
    ----------
    frequency : float
        Undamped [Hz].
    damping : float
        Damping ratio; NaN where unknown.
    shape : mapping of str to complex
        By sensor or by channel, in one unit of acceleration or displacement, any scale; what is not measured is left
        out.
    sigma_frequency, sigma_damping : float
        Standard deviations that the identification itself leaves [Hz, 1]; 0 where it states none.
    sigma_shape : float
        The same of a component of the shape, relative to the largest one; NaN where unknown.
    found_in : tuple of int, or None
        In how many model orders, of how many.
    resolution : float
        Distance within which the file tells no two modes apart [Hz].
    level : float
        Of its vibration in the file; NaN where unknown.
    shift : LevelShift or None
        How the frequency changes with the level within the file; over several files, the largest change.
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


def mac(one: Mapping[str, complex], other: Mapping[str, complex]) -> float:
    """Return the modal assurance criterion over the components that both shapes have; 1 for fewer than two.

    Notes
    -----
    Allemang and Brown, Proc. 1st Int. Modal Analysis Conf., 1982.
    """
    common = [name for name in one if name in other]
    if len(common) < 2:
        return 1.0
    return alike(*(np.array([shape[name] for name in common]) for shape in (one, other)))


def check_shape(shape: Mapping[str, complex], where: str) -> None:
    """Refuse a shape of zeros, or of numbers whose squares overflow.

    Raises
    ------
    MeasurementError
    """
    size = max((abs(value) for value in shape.values()), default=1.0)
    if not SMALLEST <= size <= LARGEST:
        what = f"expected a mode shape, found components up to {size:g}"
        raise MeasurementError(what, where, "leave the shape out where it was not measured")
