"""Measured modes beside those of a scene: shapes scaled to those of the model, at the positions of the sensors.

A measured shape has any scale and sign, and is known only at the sensors.  Its factor is that of least squares on the
measured components, in units of each component's motion over all modes, as in the MAC:

    a = sum w^2 u v / sum w^2 v^2,  w = 1 / sqrt(sum over modes of u^2)

with v the measured components and u those of the model (the modal scale factor).  Only measured components are drawn.

References
----------
R. J. Allemang, "The modal assurance criterion: twenty years of use and abuse", Sound and Vibration 37(8), 2003.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.support.mac import channel_motion, motion_weights

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Channel:
    """A component at which shapes were measured: its name, such as ``p_x`` or a coordinate, and its SI unit."""

    name: str
    unit: str


@dataclass(frozen=True)
class MeasuredMode:
    """A measured mode at a pose of a scene.

    - pose: index of the pose
    - mode: index of its partner among all modes of the scene; None if the model has none
    - name: its name in the measurement
    - frequency, sigma: Hz
    - mac: modal assurance criterion with the partner; None without a shape
    - shape: as measured, one for each channel of the scene; NaN where not measured
    """

    pose: int
    mode: int | None
    name: str
    frequency: float
    sigma: float
    mac: float | None
    shape: tuple[float, ...]

    @property
    def has_shape(self) -> bool:
        """Whether a component was measured that is not zero."""
        return bool(np.any(np.nan_to_num(self.shape)))


def scale_factor(measured: Array, model: Array, weights: Array) -> float:
    """Return the factor of a measured shape that brings it closest to that of a model.

    - measured: (C,); NaN where not measured
    - model, weights: (C,)

    Returns 0 without a measured component.

    Examples
    --------
    >>> import numpy as np
    >>> scale_factor(np.array([1.0, np.nan, 2.0]), np.array([3.0, 9.0, 6.0]), np.ones(3))
    3.0
    """
    finite = np.isfinite(measured)
    v, u = np.where(finite, measured, 0.0) * weights, np.where(finite, model, 0.0) * weights
    norm_squared = float(v @ v)
    return float(u @ v) / norm_squared if norm_squared > 0.0 else 0.0


def channel_weights(shapes: Array) -> Array:
    """Return the weight of each channel from the shapes of all modes there, (m, C): 1 / motion; 0 without motion."""
    return motion_weights(channel_motion(shapes))
