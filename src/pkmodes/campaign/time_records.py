"""Records of signals in time: the columns of a file as arrays, evenly sampled."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.campaign.campaign import Campaign, Record
from pkmodes.campaign.sensor_functions import (
    ACCELERATION,
    check_size,
    dead_channels,
    motion_of,
    sensor_functions,
)
from pkmodes.core.base.errors import MeasurementError, shown
from pkmodes.signals.functions import Kind
from pkmodes.signals.reduction import reduced, reduction
from pkmodes.signals.sampling import even_pieces

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]


@dataclass(frozen=True, eq=False)
class TimeSignals:
    """Signals of a file.

    Attributes
    ----------
    step : float
        Between samples [s].
    pieces : tuple of ndarray, shape (n_i, S)
        Responses in SI units; a gap begins another piece.
    forces : tuple of ndarray, shape (n_i,)
        Empty without a force.
    names : tuple of str
    derivatives : ndarray of int, shape (S,)
        0 for displacements, 1 for velocities, 2 for accelerations.
    messages : tuple of str
    """

    source: str
    step: float
    pieces: tuple[Array, ...]
    forces: tuple[Array, ...]
    names: tuple[str, ...]
    derivatives: NDArray[np.intp]
    messages: tuple[str, ...]

    def as_accelerations(self, s: ArrayLike) -> Complex:
        """Return factors that make accelerations of the responses, (..., S), at complex frequencies s [1/s]."""
        return np.asarray(np.asarray(s, dtype=complex)[..., None] ** (ACCELERATION - self.derivatives))


def time_signals(
    path: Path, record: Record, setup: str, campaign: Campaign, *, highest: float | None = None
) -> TimeSignals:
    """Read the signals of a file.

    Parameters
    ----------
    highest : float, optional
        Frequency above which nothing is of interest [Hz]: long records are reduced to fewer samples.

    Raises
    ------
    MeasurementError
        If the file is faulty, has none of the campaign's sensors, or its signals differ in their times.
    """
    sensors = campaign.sensors_in(setup)
    functions = sensor_functions(path, Kind.TIME, frozenset(sensors), record.rate)
    read, used = functions.read, functions.used
    time = used[0].abscissa
    forces = [one for one in read.functions if one.force]
    if len(forces) > 1:
        what = f"expected one force, found {len(forces)}"
        raise MeasurementError(what, read.source, "give one excitation in each file")
    if forces and not np.array_equal(forces[0].abscissa, time):
        what = f"the times of the force differ from those of {shown(used[0].response)}"
        raise MeasurementError(what, read.source, "sample all signals of a file together")
    names = [one.response for one in used]
    repeated = next((name for i, name in enumerate(names) if name in names[:i]), None)
    if repeated is not None:
        what = f"the signal {shown(repeated)} occurs twice"
        raise MeasurementError(what, read.source, "give repeats as files of their own")
    motions = [motion_of(one, sensors[one.response], campaign.channels, read.source) for one in used]
    pieces, gaps = even_pieces(time, read.source)
    fewer = 1 if highest is None else reduction(len(time), pieces[0].step, highest)
    dead: list[str] = []
    columns: list[list[Array]] = []
    for one, of in zip(used, motions, strict=True):  # a long signal fills much of the memory: one at a time
        values = one.values.real
        least, largest = values.min(), values.max()
        check_size(of.factor * np.array([least, largest]), read.source)
        if least == largest:
            dead.append(one.response)
        columns.append([of.factor * reduced(values[piece.part], fewer) for piece in pieces])
    if len(dead) == len(used):
        what = f"expected signals, found only constant ones: {', '.join(dead)}"
        raise MeasurementError(what, read.source, "check the sensors and their cables")
    if record.band[1] > 0.5 / pieces[0].step:
        half = 0.5 / pieces[0].step
        what = f"expected a band below half the sampling rate, {half:.6g} Hz, found {record.band[1]:g} Hz"
        raise MeasurementError(what, read.source, "narrow the band of the record, or sample faster")
    return TimeSignals(
        read.source,
        pieces[0].step * fewer,
        tuple(np.stack(each, axis=1) for each in zip(*columns, strict=True)),
        tuple(np.asarray(force.values.real)[piece.part] for force in forces for piece in pieces),
        tuple(names),
        np.array([of.derivative for of in motions]),
        (*read.messages, *gaps, *dead_channels(dead, read.source)),
    )
