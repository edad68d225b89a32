"""Realistic modal tests: frequency bands, nodes, few sensors, missed modes, and wrong standard deviations.

A `Laboratory` describes one modal test.  Its fields are options of `pkmodes_rig.measurements.measure_modes` with the
same names; `drawn` draws a realistic one.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields

import numpy as np

#: Accelerometers: along every rail, and on the platform.
SENSORS = ("x_1", "x_2", "x_3", "p_x", "p_y", "p_z")

#: Steepness of the detection probability as a function of visibility: from 6 to 94 % within a factor of four.
STEEPNESS = 4.0


@dataclass(frozen=True)
class Laboratory:
    """The procedure of a modal test, with its errors.

    Attributes
    ----------
    sigma : float
        Standard deviation of the logarithm of a frequency, the median over all rows.
    uneven : float
        Standard deviation of the logarithm of the standard deviations of single rows, which the file states.
    sigma_scale : float
        Ratio of stated to true standard deviations.
    missing : float
        Probability that a mode is missed at random.
    nodes : float
        Visibility at which half of the modes are missed (see `seen`).
    band : tuple of two floats, optional
        Lowest and highest frequency of the test [Hz].
    band_stated : bool
        Whether the file states the band.
    modes : int or tuple of two ints
        One int: the number of modes, as for `measure_modes`.  Two: smallest and largest number of modes at a pose,
        counted from the lowest in the band.
    sensors : tuple of str
        Sensors that decide whether a mode is visible if the file has no shapes.
    shapes : tuple of str
        Components of the shapes in the file.
    shape_noise : float
        Standard deviation of their errors, relative to the row's largest component.
    sigma_shape : str
        Whether the file states it: "absent", "stated", or "some" if about half of the rows are blank.
    """

    sigma: float = 0.002
    uneven: float = 0.0
    sigma_scale: float = 1.0
    missing: float = 0.0
    nodes: float = 0.0
    band: tuple[float, float] | None = None
    band_stated: bool = False
    modes: int | tuple[int, int] = 6
    sensors: tuple[str, ...] = SENSORS
    shapes: tuple[str, ...] = SENSORS
    shape_noise: float = 0.02
    sigma_shape: str = "absent"

    @classmethod
    def drawn(
        cls,
        rng: np.random.Generator,
        span: tuple[float, float],
        sensors: Sequence[str] = SENSORS,
        *,
        missing: float = 0.15,
        modes: tuple[int, int] = (4, 8),
    ) -> Laboratory:
        """Draw a laboratory at random.

        Parameters
        ----------
        rng : numpy.random.Generator
        span : tuple of two floats
            Lowest and highest frequency predicted by the model [Hz].  On either side, the band cuts into it in one
            case of three.
        sensors : sequence of str
            All sensors.  The file has shapes at half of them in one case of five, and no shapes in another one.
        missing, modes
            See `Laboratory`.
        """
        low = span[0] * (rng.uniform(0.95, 1.1) if rng.random() < 1 / 3 else rng.uniform(0.1, 0.8))
        high = span[1] * (rng.uniform(0.85, 1.0) if rng.random() < 1 / 3 else rng.uniform(1.1, 2.0))
        few = sorted(rng.choice(len(sensors), (len(sensors) + 1) // 2, replace=False))
        shapes = rng.choice(["all", "all", "all", "few", "none"])
        return cls(
            uneven=0.3,
            sigma_scale=float(np.exp(0.15 * rng.standard_normal())) if rng.random() < 1 / 4 else 1.0,
            missing=missing,
            nodes=0.15,
            band=(float(f"{low:.3g}"), float(f"{high:.3g}")),
            band_stated=bool(rng.random() < 1 / 2),
            modes=modes,
            sensors=tuple(sensors),
            shapes={"all": tuple(sensors), "few": tuple(sensors[i] for i in few), "none": ()}[str(shapes)],
            shape_noise=float(rng.uniform(0.01, 0.05)),
            sigma_shape=str(rng.choice(["absent", "stated", "some"])),
        )

    def options(self) -> dict[str, object]:
        """Return all fields as options of `measure_modes`."""
        return {f.name: getattr(self, f.name) for f in fields(self)}


def seen(motion: np.ndarray, nodes: float) -> np.ndarray:
    """Compute the probability that each mode is detected at the sensors.

    The visibility of a mode is the root mean square of its mass-normalised motion at the sensors (the height of its
    peaks), divided by the median over all modes in the test.

    Parameters
    ----------
    motion : ndarray, shape (m, C)
        Mass-normalised shapes at the sensors.
    nodes : float
        Visibility at which half of the modes are missed; 0 for none.
    """
    peaks = np.sqrt(np.mean(motion**2, axis=1))
    visibility = peaks / np.median(peaks)
    return visibility**STEEPNESS / (visibility**STEEPNESS + nodes**STEEPNESS)
