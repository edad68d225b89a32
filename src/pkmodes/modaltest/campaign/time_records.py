"""Signals in time: the columns of a file as evenly sampled arrays.

Modes of such records also get the error that interpolated samples add, and the level of their vibration.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.core.base.errors import MeasurementError, shown
from pkmodes.core.base.numbers import plain
from pkmodes.modaltest.campaign.campaign import Campaign, Record
from pkmodes.modaltest.campaign.grouping import MAX_FREQUENCY_DIFFERENCE
from pkmodes.modaltest.campaign.mode_estimates import FileFit, FileModes, modes_from_fit
from pkmodes.modaltest.campaign.quotients import force_unit_factor
from pkmodes.modaltest.campaign.sensor_faults import find_silent_sensors, overload_messages
from pkmodes.modaltest.campaign.sensor_functions import (
    ACCELERATION,
    check_size,
    motion_of,
    refuse_repeated,
    sensor_functions,
)
from pkmodes.modaltest.identification.estimates import Mode
from pkmodes.modaltest.identification.level import levels
from pkmodes.modaltest.signals.checks import MIN_POINTS
from pkmodes.modaltest.signals.functions import FunctionKind
from pkmodes.modaltest.signals.reduction import reduce_signal, reduction_factor
from pkmodes.modaltest.signals.sampling import Piece, even_pieces, stated_pieces
from pkmodes.modaltest.signals.sensor_faults import find_stop

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
#: Longest gap that is bridged by interpolation, in periods of the upper end of the band.
MAX_BRIDGED_PERIODS = 0.1
#: Rates that differ by less, relative, are the same.
SAME_RATE = 1e-3


@dataclass(frozen=True, eq=False)
class TimeSignals:
    """Signals of a file.

    - step: between samples [s]
    - pieces: responses in SI units, each (n_i, S); a gap begins another piece
    - forces: in SI units where the file gives one, each (n_i,); empty without a force
    - force: name of the force in the file
    - names: names of the S sensors with a signal
    - derivatives: (S,); 0 for displacements, 1 for velocities, 2 for accelerations
    - names_in_file: names of all the campaign's sensors in the file
    - gap: median length of the gaps between the pieces [s]; 0 for a single piece
    - starts: times of the first samples of the pieces [s]
    - reinterpolated: the same signals with as many further samples interpolated; None without gaps
    """

    source: str
    step: float
    pieces: tuple[Array, ...]
    forces: tuple[Array, ...]
    force: str
    names: tuple[str, ...]
    derivatives: NDArray[np.intp]
    names_in_file: frozenset[str]
    messages: tuple[str, ...]
    gap: float = 0.0
    starts: tuple[float, ...] = ()
    reinterpolated: TimeSignals | None = None

    def select(self, names: Sequence[str]) -> TimeSignals:
        """Return the signals of some sensors."""
        columns = [self.names.index(name) for name in names]
        pieces = tuple(piece[:, columns] for piece in self.pieces)
        reinterpolated = None if self.reinterpolated is None else self.reinterpolated.select(names)
        return replace(
            self,
            pieces=pieces,
            names=tuple(names),
            derivatives=self.derivatives[columns],
            reinterpolated=reinterpolated,
        )

    def as_accelerations(self, s: ArrayLike) -> Complex:
        """Return factors that make accelerations of the responses, (..., S), at complex frequencies s [1/s]."""
        return np.asarray(np.asarray(s, dtype=complex)[..., None] ** (ACCELERATION - self.derivatives))


def time_signals(
    path: Path, record: Record, setup: str, campaign: Campaign, *, highest: float | None = None
) -> TimeSignals:
    """Read the signals of a file.

    - highest: highest frequency of interest [Hz]: long records are reduced to fewer samples

    Raises MeasurementError if the file is faulty, has none of the campaign's sensors, or its signals differ in their
    times.
    """
    sensors = campaign.sensors_in(setup)
    functions = sensor_functions(
        path, FunctionKind.TIME, frozenset(sensors), record, signs=campaign.signs_of_file
    )
    file, used = functions.file, functions.used
    time = used[0].abscissa
    forces = [function for function in file.functions if function.force]
    if len(forces) > 1:
        problem = f"expected one force, found {len(forces)}"
        raise MeasurementError(problem, file.source, "give one excitation in each file")
    if forces and not np.array_equal(forces[0].abscissa, time):
        problem = f"the times of the force differ from those of {shown(used[0].response)}"
        raise MeasurementError(problem, file.source, "sample all signals of a file together")
    names = [function.response for function in used]
    repeated = next((name for i, name in enumerate(names) if name in names[:i]), None)
    if repeated is not None:
        refuse_repeated(repeated, f"the signal {shown(repeated)}", file.source)
    motions = [
        motion_of(function, sensors[function.response], campaign.channels, file.source) for function in used
    ]
    pieces, gaps = _pieces(time, record, file.source)
    decimation = 1 if highest is None else reduction_factor(len(time), pieces[0].step, highest)
    overloads, blows = list[str](), bool(forces)
    for force in forces:
        overloads += overload_messages(force.response, force.values.real, file.source, of_blows=blows)
    rests: dict[int, slice] = {}
    columns, bridged_columns = list[list[Array]](), list[list[Array]]()
    bridged = any(piece.numbers is not None for piece in pieces)
    for i, (function, motion) in enumerate(zip(used, motions, strict=True)):
        values = function.values.real  # a long signal fills much of the memory: one at a time
        check_size(motion.factor * np.array([values.min(), values.max()]), file.source)
        if (rest := find_stop(values)) is not None:
            rests[i] = rest
        overloads += overload_messages(function.response, values, file.source, of_blows=blows)
        filled = [piece.fill_gaps(values) for piece in pieces]
        columns.append([motion.factor * reduce_signal(samples, decimation) for samples in filled])
        if bridged:
            refilled = (piece.reinterpolated(samples) for piece, samples in zip(pieces, filled, strict=True))
            bridged_columns.append(
                [motion.factor * reduce_signal(samples, decimation) for samples in refilled]
            )
    silent, silent_messages = find_silent_sensors(used, rests, time, file.source)
    if len(silent) == len(used):
        problem = f"expected signals, found only constant ones: {', '.join(names)}"
        raise MeasurementError(problem, file.source, "check the sensors and their cables")
    moving = [i for i in range(len(used)) if i not in silent]
    if record.band[1] > 0.5 / pieces[0].step:
        nyquist = 0.5 / pieces[0].step
        problem = (
            f"expected a band below half the sampling rate, {nyquist:.6g} Hz, found {record.band[1]:g} Hz"
        )
        raise MeasurementError(problem, file.source, "narrow the band of the record, or sample faster")
    units = [1.0 if force.unit is None else force_unit_factor(force.unit) for force in forces]
    force_pieces = tuple(
        piece.fill_gaps(np.asarray(force.values.real)) * unit
        for force, unit in zip(forces, units, strict=True)
        for piece in pieces
    )
    gap_times = [time[b.samples.start] - time[a.samples.stop - 1] - a.step for a, b in pairwise(pieces)]
    signals = TimeSignals(
        file.source,
        pieces[0].step * decimation,
        tuple(np.stack(parts, axis=1) for parts in zip(*(columns[i] for i in moving), strict=True)),
        force_pieces,
        forces[0].response if forces else "",
        tuple(names[i] for i in moving),
        np.array([motions[i].derivative for i in moving]),
        frozenset(names),
        (*file.messages, *gaps, *silent_messages, *overloads),
        float(np.median(gap_times)) if gap_times else 0.0,
        tuple(float(time[piece.samples.start]) for piece in pieces),
    )
    if not bridged:
        return signals
    interpolated = replace(
        signals,
        pieces=tuple(
            np.stack(parts, axis=1) for parts in zip(*(bridged_columns[i] for i in moving), strict=True)
        ),
        forces=tuple(
            piece.reinterpolated(force_samples)
            for piece, force_samples in zip(pieces * len(forces), force_pieces, strict=True)
        ),
    )
    return replace(signals, reinterpolated=interpolated)


def _pieces(time: Array, record: Record, source: str) -> tuple[tuple[Piece, ...], tuple[str, ...]]:
    """Return the even parts of a record, and messages about them; a stated rate prevails over uneven times."""
    rate = record.rate
    try:
        pieces, messages = even_pieces(time, source, MAX_BRIDGED_PERIODS / record.band[1])
    except MeasurementError:
        if rate is None or time.size < MIN_POINTS:
            raise
        pieces, messages = stated_pieces(time, rate, source)
        by_times = (time.size - 1) / float(time[-1] - time[0])
        uneven = f"{source}: its times are uneven: the rate of the record, {rate:g} Hz, is used; by the times it is"
        return pieces, (f"{uneven} {by_times:.6g} Hz", *messages)
    by_times = 1.0 / pieces[0].step
    if rate is not None and abs(by_times / rate - 1.0) > SAME_RATE:
        even = f"{source}: its times are even and used, {by_times:.6g} Hz; the record states {rate:g} Hz"
        missing_samples = time.size * (rate / by_times - 1.0)
        messages = (
            *messages,
            f"{even}: by that, {missing_samples:.0f} samples are missing" if missing_samples > 0.0 else even,
        )
    return pieces, messages


def fit_with_bridges(
    find: Callable[[Sequence[TimeSignals]], tuple[FileFit, tuple[str, ...]]],
    recordings: Sequence[TimeSignals],
    source: str,
) -> tuple[FileFit, tuple[str, ...]]:
    """Return the fit of signals and messages about it, with the effect of interpolated samples in its sigmas.

    It is the change from interpolating as many further samples, relative to the standard deviations, rms over all
    modes.
    """
    fit, messages = find(recordings)
    if not fit.estimate.modes or all(recording.reinterpolated is None for recording in recordings):
        return fit, messages
    bridged_modes = find([recording.reinterpolated or recording for recording in recordings])[
        0
    ].estimate.modes
    changes: list[float] = []
    for mode in fit.estimate.modes:
        counterpart = min(
            bridged_modes, key=lambda candidate: abs(candidate.frequency - mode.frequency), default=mode
        )
        if (
            counterpart is mode
            or abs(counterpart.frequency / mode.frequency - 1.0) > MAX_FREQUENCY_DIFFERENCE
        ):
            continue
        for name in ("frequency", "damping"):
            sigma = getattr(mode, f"sigma_{name}")
            changes += [(getattr(counterpart, name) - getattr(mode, name)) / sigma] if sigma > 0.0 else []
    if not changes:
        remark = "with as many further samples interpolated, no mode is found: none can be trusted"
        return fit, (*messages, f"{source}: {remark}")
    rms_change = float(np.sqrt(np.mean(np.square(changes))))

    def widen(mode: Mode) -> Mode:
        names = "sigma_frequency", "sigma_damping", "sigma_shape", "sigma_scale"
        return replace(mode, **{name: getattr(mode, name) * np.hypot(1.0, rms_change) for name in names})

    sentence = (
        f"{source}: interpolating as many further samples moves the modes by {plain(rms_change, 2)} of their "
        "standard deviations, rms: this is added in quadrature"
    )
    return replace(fit, estimate=fit.estimate.map_modes(widen)), (*messages, sentence)


def modes_with_levels(
    fit: FileFit, messages: Sequence[str], signals: TimeSignals, window_time_constant: float | None = None
) -> FileModes:
    """Return the modes of a file with their levels.

    - fit: with shapes in accelerations of the file's sensors
    - window_time_constant: time constant of a window that the responses have had [s]
    """
    file_modes = modes_from_fit(fit, messages, signals.names_in_file)
    modes = fit.estimate.modes
    if not modes:
        return file_modes
    poles = np.array([mode.pole for mode in modes])
    roving = fit.references == signals.names
    at_sensors = [mode.participation if roving else mode.shape for mode in modes]
    shapes = np.array(at_sensors) / signals.as_accelerations(poles)
    mode_levels = levels(signals.step, signals.pieces, poles, shapes, window_time_constant)
    pairs = zip(file_modes.modes, mode_levels, strict=True)
    levelled_modes = tuple(replace(mode, level=level.amplitude, shift=level.shift) for mode, level in pairs)
    return replace(file_modes, modes=levelled_modes)
