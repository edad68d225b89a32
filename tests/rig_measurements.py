"""Measurements as a modal analysis on the virtual test rig would give them: CSV text with noise, gaps and disorder.

The truth comes from `rig_engine`; what is added here is the experimenter: errors of the frequencies, common to a
pose and not, modes that were missed, shapes of any scale, rows in any order and a numbering that means nothing.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Mapping, Sequence

import numpy as np

from pkmodes_generated.linear_delta import Parameters
from rig_engine import TrueModes, true_modes

#: Modes of the robot without effects that strain nothing.
BASE_RIGID = 3

#: What the accelerometers of the rig still notice [Hz], for modes that were rigid and are tied to ground.
LOWEST_FREQUENCY = 2.0


def measure(
    parameters: Parameters,
    poses: Sequence[np.ndarray],
    *,
    effects: Mapping[str, float] = {},
    outside: Mapping[str, float] = {},
    rng: np.random.Generator,
    sigma: float = 0.002,
    common: float = 0.0,
    missing: float = 0.0,
    modes: int = 6,
    shapes: Sequence[str] = (),
    shape_noise: float = 0.02,
    sigma_scale: float = 1.0,
    labels: Sequence[str] | None = None,
) -> str:
    """Measure a robot at poses; `effects` and `outside` as for `rig_engine.true_modes`, the rest as below."""
    return measure_modes(
        [true_modes(parameters, p, effects, outside) for p in poses],
        poses,
        rng=rng,
        sigma=sigma,
        common=common,
        missing=missing,
        modes=modes,
        shapes=shapes,
        shape_noise=shape_noise,
        sigma_scale=sigma_scale,
        labels=labels,
        drift=outside.get("thermal_drift", 0.0),
    )


def measure_modes(
    modes_list: Sequence[TrueModes],
    poses: Sequence[np.ndarray],
    *,
    rng: np.random.Generator,
    sigma: float = 0.002,
    common: float = 0.0,
    missing: float = 0.0,
    modes: int = 6,
    shapes: Sequence[str] = (),
    shape_noise: float = 0.02,
    sigma_scale: float = 1.0,
    labels: Sequence[str] | None = None,
    drift: float = 0.0,
) -> str:
    """Measure modes that are known already: computing them is what takes long.

    Parameters
    ----------
    modes_list : sequence of TrueModes
        Modes at each of the poses.
    poses : array_like, shape (N, 3)
        Platform centres [m].
    rng : numpy.random.Generator
        Source of every error.
    sigma : float
        Standard deviation of the logarithm of each frequency.
    common : float
        The same for an error that all rows of a pose share, and that the file does not state.
    missing : float
        Probability that a mode was not identified.
    modes : int
        How many modes beyond the first three are looked for at each pose.  Of the first three, those that are
        not rigid and oscillate faster than `LOWEST_FREQUENCY` are found in addition.
    shapes : sequence of str
        Components of the shapes that are measured, such as ``x_1`` or ``p_x``.
    shape_noise : float
        Standard deviation of their errors, as a part of the row's largest component.
    sigma_scale : float
        Stated standard deviation over the true one, `sigma`.
    labels : sequence of str, optional
        Names of the poses; P1, P2 ... by default.
    drift : float
        Relative change of all frequencies from each pose to the next.
    """
    labels = labels or [f"P{i + 1}" for i in range(len(poses))]
    rows: list[list[str]] = []
    for index, (label, p, true) in enumerate(zip(labels, poses, modes_list, strict=True)):
        shared = rng.normal(0.0, common)
        for i in _measurable(true, modes):
            error = rng.normal(0.0, sigma) + shared
            found = _shape(true, i, shapes, shape_noise, rng)
            if rng.random() < missing:
                continue
            frequency = true.frequencies[i] * (1 + drift * index) * np.exp(error)
            numbers = [*p, frequency, frequency * sigma * sigma_scale]
            number = str(rng.integers(1, 3 * modes + 1))
            rows.append([label, *map(_digits, numbers), number, *map(_digits, found)])
    rng.shuffle(rows)
    text = io.StringIO()
    text.write("# virtual test rig\n")
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(
        ["pose", "x", "y", "z", "frequency", "sigma", "mode", *(f"shape:{name}" for name in shapes)]
    )
    writer.writerows(rows)
    return text.getvalue()


def _measurable(true: TrueModes, modes: int) -> list[int]:
    """Modes that the analysis looks for."""
    tied = [i for i in range(true.rigid, BASE_RIGID) if true.frequencies[i] > LOWEST_FREQUENCY]
    return [*tied, *range(BASE_RIGID, min(BASE_RIGID + modes, len(true.frequencies)))]


def _shape(
    true: TrueModes, mode: int, names: Sequence[str], noise: float, rng: np.random.Generator
) -> np.ndarray:
    """Measured components of a shape, on a scale of this row's own."""
    components = np.array([true.shapes[name][mode] for name in names])
    if components.size:
        components = components / np.abs(components).max()
        components = components + rng.normal(0.0, noise, components.shape)
        components *= rng.choice([-1.0, 1.0]) * np.exp(rng.normal(0.0, 2.0))
    return components


def _digits(number: float) -> str:
    return f"{number:.9g}"
