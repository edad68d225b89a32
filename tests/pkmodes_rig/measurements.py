"""Simulated modal measurements of the virtual test rig: CSV text with noise, missing modes and rows in any order.

The true modes come from `engine`.  This module adds the experimenter: frequency errors, independent or common to a
pose, missed modes, arbitrarily scaled shapes, shuffled rows and arbitrary mode numbers.  `laboratory` describes a
single test, `mistakes` the errors made in writing the file.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from pkmodes_generated.linear_delta import Parameters
from pkmodes_rig.engine import TrueModes, true_modes
from pkmodes_rig.laboratory import SENSORS, seen

#: Number of rigid-body modes of the robot without effects.
BASE_RIGID = 3

#: Lowest frequency that the accelerometers detect [Hz], for rigid-body modes that an effect ties to ground.
LOWEST_FREQUENCY = 2.0


#: Largest standard deviation of a shape that a file may state.
MOST_NOISE = 0.9


@dataclass(frozen=True)
class Identified:
    """One identified mode.

    Attributes
    ----------
    pose, mode : int
        Indices of the pose and of the true mode.
    frequency, sigma, stated : float
        Measured frequency, its true standard deviation, and the stated one [Hz].
    number : str
        The experimenter's mode number.
    shape : ndarray
        Measured components.
    sigma_shape : float or None
        Stated standard deviation of the shape, None if not stated.
    """

    pose: int
    mode: int
    frequency: float
    sigma: float
    stated: float
    number: str
    shape: np.ndarray
    sigma_shape: float | None = None


def measure(
    parameters: Parameters,
    poses: Sequence[np.ndarray],
    *,
    effects: Mapping[str, float] = {},
    outside: Mapping[str, float] = {},
    **options: Any,
) -> str:
    """Measure a robot at poses; see `engine.true_modes` for the first arguments, `measure_modes` for `options`."""
    modes_list = [true_modes(parameters, p, effects, outside) for p in poses]
    return measure_modes(modes_list, poses, drift=outside.get("thermal_drift", 0.0), **options)


def measure_modes(
    modes_list: Sequence[TrueModes],
    poses: Sequence[np.ndarray],
    *,
    shapes: Sequence[str] = (),
    labels: Sequence[str] | None = None,
    band: tuple[float, float] | None = None,
    band_stated: bool = False,
    sigma_shape: str = "absent",
    **options: Any,
) -> str:
    """Measure modes that have been computed already, which is the slow part.

    Parameters
    ----------
    modes_list, shapes, band, sigma_shape, options
        As for `identified`.
    poses : array_like, shape (N, 3)
        Platform centres [m].
    labels : sequence of str, optional
        Names of the poses; P1, P2 ... by default.
    band_stated : bool
        Whether the file states the band.
    """
    rows = identified(modes_list, shapes=shapes, band=band, sigma_shape=sigma_shape, **options)
    stated = band if band_stated else None
    return written(
        rows,
        poses,
        shapes,
        labels=labels,
        band=stated,
        sigma_shape=sigma_shape != "absent",
        drives=drives_of(modes_list),
    )


def drives_of(modes_list: Sequence[TrueModes]) -> list[str]:
    """Return what the motors did at each pose."""
    return ["held" if modes.held else "free" for modes in modes_list]


def held_at(drives: str, poses: int) -> list[bool]:
    """Return at which poses the motors are held in a test with motors free, held or, at every second pose, mixed."""
    return [drives == "held" or (drives == "mixed" and i % 2 == 1) for i in range(poses)]


def identified(
    modes_list: Sequence[TrueModes],
    *,
    rng: np.random.Generator,
    sigma: float = 0.002,
    uneven: float = 0.0,
    common: float = 0.0,
    missing: float = 0.0,
    nodes: float = 0.0,
    band: tuple[float, float] | None = None,
    modes: int | tuple[int, int] = 6,
    sensors: Sequence[str] = SENSORS,
    shapes: Sequence[str] = (),
    shape_noise: float = 0.02,
    sigma_shape: str = "absent",
    sigma_scale: float = 1.0,
    drift: float = 0.0,
    base_rigid: int = BASE_RIGID,
    lever: float = 0.0,
) -> list[Identified]:
    """Identify modes, in random order.

    Parameters
    ----------
    modes_list : sequence of TrueModes
        True modes at each pose.
    rng : numpy.random.Generator
        Source of all errors.
    sigma, uneven, sigma_scale, missing, nodes, band, sensors, shapes, shape_noise, sigma_shape
        See `pkmodes_rig.laboratory.Laboratory`.
    common : float
        Standard deviation of an error common to all rows of a pose, which the file does not state.
    modes : int or tuple of two ints
        Number of modes beyond the first three that are identified at each pose.  In addition, those of the first
        three that are not rigid-body modes and are above `LOWEST_FREQUENCY` are identified.  Two numbers are the
        smallest and largest number of modes at a pose, including former rigid-body modes.
    drift : float
        Relative change of all frequencies from each pose to the next.
    base_rigid : int
        Number of rigid-body modes of the robot without effects, which depends on the mechanism; 0 where motors are
        held.
    lever : float
        Distance over which displacements measure rotations [m]: the errors of ``r_x`` are those of displacements over
        this distance.  If 0, all components have the same error in their own units.
    """
    rows: list[Identified] = []
    most = modes if isinstance(modes, int) else modes[1]
    for index, true in enumerate(modes_list):
        shared = rng.normal(0.0, common)
        looked_for = _looked_for(true, modes, band, rng, 0 if true.held else base_rigid)
        chance = _chances(true, looked_for, shapes or sensors, nodes)
        for i, visible in zip(looked_for, chance, strict=True):
            part = sigma * np.exp(rng.normal(0.0, uneven)) if uneven else sigma
            error = rng.normal(0.0, part) + shared
            shape, noise = _shape(true, i, shapes, shape_noise, rng, lever)
            if rng.random() < missing or (nodes and rng.random() > visible):
                continue
            frequency = true.frequencies[i] * (1 + drift * index) * np.exp(error)
            if band and not band[0] <= frequency <= band[1]:
                continue
            number = str(rng.integers(1, 3 * most + 1))
            says = sigma_shape == "stated" or (sigma_shape == "some" and rng.random() < 0.5)
            stated = frequency * part * sigma_scale
            known = noise if says else None
            rows.append(Identified(index, i, frequency, frequency * part, stated, number, shape, known))
    rng.shuffle(rows)
    return rows


def written(
    rows: Sequence[Identified],
    poses: Sequence[np.ndarray],
    shapes: Sequence[str] = (),
    *,
    labels: Sequence[str] | None = None,
    band: tuple[float, float] | None = None,
    sigma_shape: bool = False,
    components: Sequence[str] = ("x", "y", "z"),
    drives: Sequence[str] = (),
) -> str:
    """Return the text of a file with these rows.

    `band` is the band to state, `sigma_shape` adds a column ``sigma_shape``, `components` names those of a pose, and
    `drives` says what the motors did at each pose: a comment says it for all, or a column.
    """
    text = io.StringIO()
    text.write("# virtual test rig\n")
    if band:
        text.write(f"# band: {_digits(band[0])} Hz, {_digits(band[1])} Hz\n")
    did = set(drives)
    if did == {"held"}:
        text.write("# drives: held\n")
    writer = csv.writer(text, lineterminator="\n")
    motors = ["drives"] if len(did) > 1 else []
    extra = ["sigma_shape"] if sigma_shape and shapes else []
    columns = [f"shape:{name}" for name in shapes]
    writer.writerow(["pose", *components, *motors, "frequency", "sigma", "mode", *columns, *extra])
    for row in rows:
        label = labels[row.pose] if labels else f"P{row.pose + 1}"
        cells = [label, *map(_digits, poses[row.pose]), *(drives[row.pose] for _ in motors)]
        # Sensors at nodes of a mode tell no shape.
        moves = bool(np.isfinite(row.shape).all() and np.any(row.shape))
        cells += [*map(_digits, (row.frequency, row.stated)), row.number]
        cells += [_digits(value) if moves else "" for value in row.shape]
        known = row.sigma_shape if moves else None
        writer.writerow([*cells, *("" if known is None else _digits(known) for _ in extra)])
    return text.getvalue()


def exact(
    rows: Sequence[Identified], modes_list: Sequence[TrueModes], shapes: Sequence[str]
) -> list[Identified]:
    """Return the same modes without errors, with the true standard deviations stated."""
    errorless = []
    for row in rows:
        true = modes_list[row.pose]
        frequency = float(true.frequencies[row.mode])
        size = frequency * row.sigma / row.frequency
        shape = np.array([true.shapes[name][row.mode] for name in shapes])
        errorless.append(replace(row, frequency=frequency, sigma=size, stated=size, shape=shape))
    return errorless


def _looked_for(
    true: TrueModes,
    modes: int | tuple[int, int],
    band: tuple[float, float] | None,
    rng: np.random.Generator,
    base_rigid: int,
) -> list[int]:
    """Return the indices of the modes within the scope of the test."""
    low, high = band or (0.0, np.inf)
    tied = [i for i in range(true.rigid, base_rigid) if true.frequencies[i] > LOWEST_FREQUENCY]
    if isinstance(modes, int):
        indices = [*tied, *range(base_rigid, min(base_rigid + modes, len(true.frequencies)))]
        return [i for i in indices if low <= true.frequencies[i] <= high]
    indices = [
        i for i in (*tied, *range(base_rigid, len(true.frequencies))) if low <= true.frequencies[i] <= high
    ]
    return indices[: int(rng.integers(modes[0], modes[1] + 1))]


def _chances(true: TrueModes, looked_for: Sequence[int], sensors: Sequence[str], nodes: float) -> np.ndarray:
    """Return the probability that each of these modes is detected at the sensors."""
    if not nodes or not looked_for:
        return np.ones(len(looked_for))
    motion = np.array([true.shapes[name][looked_for] for name in sensors])
    return seen(motion.T, nodes)


def _shape(
    true: TrueModes,
    mode: int,
    names: Sequence[str],
    noise: float,
    rng: np.random.Generator,
    lever: float = 0.0,
) -> tuple[np.ndarray, float]:
    """Return the measured components of a shape, at a random scale.

    The second number is the largest of their standard deviations relative to the largest component.
    """
    components = np.array([true.shapes[name][mode] for name in names])
    if components.size:
        # in displacements of the sensors
        arms = np.array([lever if lever and name.startswith("r_") else 1.0 for name in names])
        components = components * arms / np.abs(components * arms).max()
        components = (components + rng.normal(0.0, noise, components.shape)) / arms
        largest = np.abs(components).max()
        components *= rng.choice([-1.0, 1.0]) * np.exp(rng.normal(0.0, 2.0))
        if lever:
            noise = min(noise / float(arms.min() * largest), MOST_NOISE)
    return components, noise


def _digits(number: float) -> str:
    return f"{number:.9g}"
