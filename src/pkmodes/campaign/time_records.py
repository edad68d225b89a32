"""Records of signals in time: the columns of a file as arrays, evenly sampled."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.base.errors import MeasurementError, shown
from pkmodes.campaign.campaign import Campaign, Record
from pkmodes.campaign.sensor_functions import (
    ACCELERATION,
    check_size,
    dead_channels,
    motion_of,
    sensor_functions,
)
from pkmodes.signals.functions import Kind
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


def time_signals(path: Path, record: Record, setup: str, campaign: Campaign) -> TimeSignals:
    """Read the signals of a file.

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
    table = np.stack([one.values.real * of.factor for one, of in zip(used, motions, strict=True)], axis=1)
    dead = [one.response for one, column in zip(used, table.T, strict=True) if not np.ptp(column)]
    check_size(table, read.source)
    if len(dead) == len(used):
        what = f"expected signals, found only constant ones: {', '.join(dead)}"
        raise MeasurementError(what, read.source, "check the sensors and their cables")
    if record.band[1] > 0.5 / pieces[0].step:
        half = 0.5 / pieces[0].step
        what = f"expected a band below half the sampling rate, {half:.6g} Hz, found {record.band[1]:g} Hz"
        raise MeasurementError(what, read.source, "narrow the band of the record, or sample faster")
    return TimeSignals(
        read.source,
        pieces[0].step,
        tuple(table[piece.part] for piece in pieces),
        tuple(np.asarray(force.values.real)[piece.part] for force in forces for piece in pieces),
        tuple(names),
        np.array([of.derivative for of in motions]),
        (*read.messages, *gaps, *dead_channels(dead, read.source)),
    )
