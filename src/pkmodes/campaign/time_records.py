"""Records of signals in time: the columns of a file as arrays, evenly sampled."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.base.errors import MeasurementError, nearest, shown
from pkmodes.campaign.campaign import Campaign, Record
from pkmodes.campaign.frf_records import ACCELERATION, check_size, dead_channels, motion_of, refuse_strangers
from pkmodes.campaign.sensors import Sensor, check_motion
from pkmodes.signals.formats import Asked
from pkmodes.signals.functions import Function, Kind
from pkmodes.signals.reading import read_signals
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
    read = read_signals(path, Asked(rate=record.rate, sensors=frozenset(sensors) or None))
    functions = [one for one in read.functions if one.kind is Kind.TIME]
    if not any(not one.force for one in functions):
        refuse_strangers(path, Kind.TIME, sensors)
    used = _used(functions, sensors, read.source)
    time = used[0].abscissa
    forces = [one for one in functions if one.force]
    if len(forces) > 1:
        what = f"expected one force, found {len(forces)}"
        raise MeasurementError(what, read.source, "give one excitation in each file")
    for one in (*used, *forces):
        if not np.array_equal(one.abscissa, time):
            what = f"the times of {shown(one.response)} differ from those of {shown(used[0].response)}"
            raise MeasurementError(what, read.source, "sample all signals of a file together")
    motions = [
        sensors[one.response].motion or motion_of(one, f"{read.source}: {one.response}") for one in used
    ]
    for one, found in zip(used, motions, strict=True):
        check_motion(found, sensors[one.response], campaign.channels, f"{read.source}: {one.response}")
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
        tuple(one.response for one in used),
        np.array([of.derivative for of in motions]),
        (*read.messages, *gaps, *dead_channels(dead, read.source)),
    )


def _used(functions: list[Function], sensors: Mapping[str, Sensor], source: str) -> list[Function]:
    if not functions:
        raise MeasurementError(
            "expected signals in time, found none", source, "choose another kind of record"
        )
    used = [one for one in functions if one.response in sensors and not one.force]
    names = [one.response for one in used]
    if not used:
        found = list(dict.fromkeys(one.response for one in functions if not one.force))
        what = f"expected a sensor of the campaign, found {', '.join(map(shown, found[:6])) or 'none'}"
        remedy = (
            nearest(found[0], sensors) if sensors and found else "add [[sensor]] for each measured direction"
        )
        raise MeasurementError(what, source, remedy)
    repeated = next((name for i, name in enumerate(names) if name in names[:i]), None)
    if repeated is not None:
        raise MeasurementError(
            f"the signal {shown(repeated)} occurs twice", source, "give repeats as files of their own"
        )
    return used
