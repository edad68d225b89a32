"""Records of frequency response functions: the functions of a file as one array, and their modes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.base.errors import MeasurementError, nearest, shown
from pkmodes.campaign.campaign import Campaign, Record
from pkmodes.campaign.file_modes import FileModes, Fit
from pkmodes.campaign.found import Found
from pkmodes.campaign.motion import Motion, motion
from pkmodes.campaign.sensors import Place, Sensor, check_motion, unsigned
from pkmodes.identification.estimates import Mode
from pkmodes.identification.frf_identification import identify_frf
from pkmodes.robot.units import LARGEST, SMALLEST
from pkmodes.signals.formats import Asked
from pkmodes.signals.functions import Function, Kind, SignalFile
from pkmodes.signals.reading import read_signals

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
#: Sensors are brought to accelerations: what most of them measure.
ACCELERATION = 2


@dataclass(frozen=True, eq=False)
class Responses:
    """The functions of a file.

    Attributes
    ----------
    frequencies : ndarray, shape (F,)
        [Hz].
    values : ndarray of complex128, shape (F, S, R)
        Accelerations in SI units per force; NaN where not measured.
    coherence : ndarray, shape (F, S, R), or None
    names : tuple of str
        Of the S places in the shape.
    dead : tuple of str
        Sensors that show nothing.
    """

    frequencies: Array
    values: Complex
    coherence: Array | None
    names: tuple[str, ...]
    dead: tuple[str, ...]


def frf_modes(path: Path, record: Record, setup: str, campaign: Campaign) -> FileModes:
    """Return the modes of the frequency response functions in a file, their shapes by sensor.

    Raises
    ------
    MeasurementError
        If the file is faulty, or its functions are not those of the campaign.
    """
    sensors = campaign.sensors_in(setup)
    read = read_signals(path, Asked(sensors=frozenset(sensors) or None))
    if not any(one.kind is Kind.FRF for one in read.functions):
        refuse_strangers(path, Kind.FRF, sensors)
    given = responses_of(read, sensors, campaign.forces_in(setup), campaign.channels)
    low, high = record.band
    if low < given.frequencies[0]:
        what = f"expected frequencies from the beginning of the band, {low:g} Hz, found {given.frequencies[0]:g} Hz"
        raise MeasurementError(what, read.source, "narrow the band of the record")
    if high > given.frequencies[-1]:
        what = (
            f"expected frequencies up to the end of the band, {high:g} Hz, found {given.frequencies[-1]:g} Hz"
        )
        raise MeasurementError(what, read.source, "narrow the band of the record")
    try:
        estimate = identify_frf(
            given.frequencies,
            given.values,
            band=(low, high),
            power=ACCELERATION,
            coherence=given.coherence,
            averages=record.averages,
            exponential=record.exponential,
            tones=campaign.tones,
        )
    except MeasurementError as error:
        raise MeasurementError(error.what, f"{read.source}: {error.where}", error.remedy) from None
    return FileModes(
        tuple(found_of(mode, given.names) for mode in estimate.modes),
        (*read.messages, *dead_channels(given.dead, read.source)),
        frozenset(
            {one.response for one in read.functions} | {unsigned(one.reference) for one in read.functions}
        ),
        Fit(read.source, estimate, given.names),
    )


def check_size(values: NDArray[Any], source: str) -> None:
    """Refuse numbers that no machine has: their squares would overflow.

    Raises
    ------
    MeasurementError
    """
    size = float(np.nanmax(np.abs(values), initial=0.0))
    if size > 0.0 and not SMALLEST <= size <= LARGEST:
        what = f"expected numbers in SI units of moderate size, found up to {size:.3g}"
        raise MeasurementError(what, source, "check the units of the sensors")


def refuse_strangers(path: Path, kind: Kind, sensors: Mapping[str, Sensor]) -> None:
    """Refuse a file that has functions of a kind, but none of the campaign's sensors.

    Raises
    ------
    MeasurementError
        It names what the file has.
    """
    read = read_signals(path)
    found = list(dict.fromkeys(one.response for one in read.functions if one.kind is kind and not one.force))
    if found:
        what = f"expected a sensor of the campaign, found {', '.join(map(shown, found[:6]))}"
        remedy = nearest(found[0], sensors) if sensors else "add [[sensor]] for each measured direction"
        raise MeasurementError(what, read.source, remedy)


def dead_channels(names: Sequence[str], source: str) -> list[str]:
    """Return a sentence for each sensor that shows nothing."""
    return [f"{source}: {name} shows nothing: all its values are equal; it is in no shape" for name in names]


def responses_of(
    read: SignalFile, sensors: Mapping[str, Sensor], forces: Mapping[str, Place], channels: Mapping[str, str]
) -> Responses:
    """Arrange the frequency response functions of a file.

    With forces declared, these are the places of the shape, and the sensors the references: a roving hammer, by
    reciprocity.

    Raises
    ------
    MeasurementError
        If there is none of the campaign's sensors, one occurs twice, frequencies differ, or a unit is unknown.
    """
    functions = [one for one in read.functions if one.kind is Kind.FRF]
    if not functions:
        what = f"expected frequency response functions, found {len(read.functions)} others"
        raise MeasurementError(what, read.source, "choose another kind of record")
    used = [one for one in functions if one.response in sensors]
    if not used:
        found = list(dict.fromkeys(one.response for one in functions))
        what = f"expected a sensor of the campaign, found {', '.join(map(shown, found[:6]))}"
        remedy = nearest(found[0], sensors) if sensors else "add [[sensor]] for each measured direction"
        raise MeasurementError(what, read.source, remedy)
    f = used[0].abscissa
    for one in used:
        if not np.array_equal(one.abscissa, f):
            what = f"the frequencies of {shown(one.response)} differ from those of {shown(used[0].response)}"
            raise MeasurementError(what, read.source, "measure all functions of a file with the same lines")
    rows = list(dict.fromkeys(one.response for one in used))
    columns = list(dict.fromkeys(one.reference for one in used))
    values = np.full((len(f), len(rows), len(columns)), complex(np.nan, np.nan))
    for one in used:
        place = (slice(None), rows.index(one.response), columns.index(one.reference))
        if np.isfinite(values[place]).any():
            what = f"the function {one.response}/{one.reference} occurs twice"
            raise MeasurementError(what, read.source, "give repeats as files of their own")
        values[place] = one.values * _to_acceleration(one, sensors[one.response], channels, f, read.source)
    check_size(values, read.source)
    dead = tuple(name for i, name in enumerate(rows) if not np.nan_to_num(values[:, i]).any())
    coherence = _coherence(read.functions, rows, columns, f)
    acting = {name: force for name in columns if (force := _of_reference(name, forces)) is not None}
    if acting:
        kept = [columns.index(name) for name in acting]
        turned = values[:, :, kept].transpose(0, 2, 1)
        of = None if coherence is None else coherence[:, :, kept].transpose(0, 2, 1)
        return Responses(f, turned, of, tuple(force.name for force in acting.values()), dead)
    return Responses(f, values, coherence, tuple(rows), dead)


def _to_acceleration(
    one: Function, sensor: Sensor, channels: Mapping[str, str], f: Array, source: str
) -> Complex:
    """Return the factor that makes SI accelerations of the numbers of a function."""
    where = f"{source}: {one.response}"
    found = sensor.motion or motion_of(one, where)
    check_motion(found, sensor, channels, where)
    return np.asarray(found.factor * (2j * np.pi * f) ** (ACCELERATION - found.derivative))


def motion_of(one: Function, where: str) -> Motion:
    """Return what a function measures, by the unit in its file.

    Raises
    ------
    MeasurementError
        If the file states none, or not that of a motion.
    """
    if one.unit is None:
        what = "expected the unit of the sensor, found none in the file"
        raise MeasurementError(what, where, 'give it in the campaign: unit = "m/s^2"')
    return motion(one.unit, where)


def _coherence(
    functions: Sequence[Function], rows: Sequence[str], columns: Sequence[str], f: Array
) -> Array | None:
    found = np.full((len(f), len(rows), len(columns)), np.nan)
    for one in functions:
        wanted = one.kind is Kind.COHERENCE and one.response in rows and one.reference in columns
        if wanted and np.array_equal(one.abscissa, f):
            found[:, rows.index(one.response), columns.index(one.reference)] = one.values
    return found if np.isfinite(found).any() else None


def _of_reference(name: str, forces: Mapping[str, Place]) -> Place | None:
    """Return the force of a reference; the sign in its name is only a name."""
    return next((place for own, place in forces.items() if unsigned(own) == unsigned(name)), None)


def found_of(mode: Mode, names: Sequence[str]) -> Found:
    """Return a mode of the fit with its shape by name, in accelerations; only their ratios count."""
    shape = {
        name: complex(value) for name, value in zip(names, mode.shape, strict=True) if np.isfinite(value)
    }
    return Found(
        mode.frequency,
        mode.damping,
        shape,
        mode.sigma_frequency,
        mode.sigma_damping,
        mode.sigma_shape,
        mode.found_in,
    )
