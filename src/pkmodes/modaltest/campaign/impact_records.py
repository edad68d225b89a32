"""Records of hammer blows in time: the functions of a file, or of all points over which a hammer roved.

When the hammer roves and the sensors stay in place, the points hit become the shape's degrees of freedom and the
sensors its references.  Their functions, though measured one after the other, are those of one structure, and are
fitted together.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import MeasurementError, shown
from pkmodes.core.base.numbers import plain
from pkmodes.core.support.ordering import listed
from pkmodes.modaltest.campaign.campaign import Campaign, Record
from pkmodes.modaltest.campaign.frequency_records import (
    Responses,
    fit_remarks,
    fit_responses,
    force_of_reference,
)
from pkmodes.modaltest.campaign.mode_estimates import NAMELESS, FileFit, FileModes
from pkmodes.modaltest.campaign.roving import RovingPoint
from pkmodes.modaltest.campaign.sensor_functions import errors_in_file, signal_request
from pkmodes.modaltest.campaign.sensors import Transducer, without_sign
from pkmodes.modaltest.campaign.time_records import (
    TimeSignals,
    fit_with_bridges,
    modes_with_levels,
    time_signals,
)
from pkmodes.modaltest.identification.estimates import Mode
from pkmodes.modaltest.identification.frf_estimates import (
    ImpactEstimate,
    impact_estimate,
    shortest_blow_length,
)
from pkmodes.modaltest.signals.functions import MAX_NAMES
from pkmodes.modaltest.signals.reading import read_signals

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
#: Shortest record of blows, in periods of the lower end of the band.
MIN_RECORD_PERIODS = 2.0
#: Largest relative difference between the rates of two files that counts as rounding.
ROUNDING = 1e-9


@dataclass(frozen=True, eq=False)
class _Blows:
    """The signals of a file of blows, and the campaign's force that acts in it; None if the campaign has none."""

    signals: TimeSignals
    force: Transducer | None


def impact_modes(path: Path, record: Record, setup: str, campaign: Campaign) -> FileModes:
    """Return the modes of the blows in a file, their shapes by sensor, or by force where the hammer roved.

    Raises MeasurementError if the file is faulty, has no force, or has fewer blows than the campaign states.
    """
    blows = _read_blows(path, record, setup, campaign)
    names = () if blows.force is None else (blows.force.name,)
    file_modes = _modes([blows], names, record, campaign, blows.signals.source)
    unnamed = (blows.signals.force,) if not names and blows.signals.force not in NAMELESS else ()
    names_in_file = blows.signals.names_in_file | set(map(without_sign, names))
    return replace(file_modes, names_in_file=names_in_file, unnamed=unnamed, forces=names)


def roving_modes(points: Mapping[str, RovingPoint], record: Record, campaign: Campaign) -> FileModes:
    """Return the modes of the blows at all points of a hammer that roved, their shapes by the keys of the forces.

    - points: a file of each setup, each with a force of the campaign

    Raises MeasurementError if a file is faulty, or they differ in their sensors or rates.
    """
    files = [_read_blows(point.path, record, setup, campaign) for setup, point in points.items()]
    first = files[0].signals
    for signals in (file.signals for file in files):
        if signals.names_in_file != first.names_in_file or abs(signals.step / first.step - 1.0) > ROUNDING:
            problem = f"expected the sensors and the rate of {first.source}"
            raise MeasurementError(problem, signals.source, "measure all points alike")
    names = [name for name in first.names if all(name in file.signals.names for file in files)]
    if not names:
        problem = "expected a sensor that is not silent at any point that was hit, found none"
        raise MeasurementError(problem, record.pose, "check the sensors and their cables")
    files = [replace(file, signals=file.signals.select(names)) for file in files]
    force_keys = [file.force.key for file in files if file.force is not None]
    return _modes(files, force_keys, record, campaign, record.pose, list(points.values()))


def _read_blows(path: Path, record: Record, setup: str, campaign: Campaign) -> _Blows:
    """Read a file of blows.

    Raises MeasurementError if it is faulty, or its force is none of the campaign's, or could be any of several.
    """
    signals = time_signals(path, record, setup, campaign)
    if not signals.forces:
        functions = read_signals(path, replace(signal_request(record), force=False)).functions
        names = list(dict.fromkeys(function.response for function in functions))
        signal_names = listed([*map(shown, names)], MAX_NAMES)
        remedy = f'state in the record which of {signal_names} it is, names = {{ force = "NAME" }}'
        remedy += ", or give its type in a universal file; without a force the kind is ambient"
        raise MeasurementError("expected a force, found none", signals.source, remedy)
    if len(signals.pieces) > 1:
        problem = f"expected one piece of even sampling, found {len(signals.pieces)}"
        raise MeasurementError(problem, signals.source, "measure the blows again, or leave the file out")
    if not np.ptp(signals.forces[0]):
        problem = "expected blows, found a constant force"
        raise MeasurementError(problem, signals.source, "check the hammer's cable")
    seconds = len(signals.forces[0]) * signals.step
    if seconds * record.band[0] < MIN_RECORD_PERIODS:
        expected = f"expected at least {MIN_RECORD_PERIODS:g} periods of {record.band[0]:g} Hz"
        problem = f"{expected}, found {plain(seconds, 3)} s"
        raise MeasurementError(problem, signals.source, "measure longer, or narrow the band")
    forces = campaign.forces_in(setup)
    if not forces:
        return _Blows(signals, None)
    force = force_of_reference(signals.force, forces)
    if force is None:
        expected = ", ".join(map(shown, forces))
        problem = f"expected a force of the campaign, {expected}, found {shown(signals.force)}"
        remedy = 'name each [[force]] as in the files; where these say only "force", give each its setup'
        raise MeasurementError(problem, signals.source, remedy)
    return _Blows(signals, force)


def _modes(
    files: Sequence[_Blows],
    forces: Sequence[str],
    record: Record,
    campaign: Campaign,
    source: str,
    points: Sequence[RovingPoint] = (),
) -> FileModes:
    """Return the modes of files of blows, with shapes at the named forces, or else at the sensors."""
    recordings = [file.signals for file in files]
    fit, bridge_messages = fit_with_bridges(
        lambda bridged: _fit(bridged, forces, record, campaign, source, points), recordings, source
    )
    messages = (*(message for recording in recordings for message in recording.messages), *bridge_messages)
    joint = replace(
        recordings[0], pieces=tuple(piece for recording in recordings for piece in recording.pieces)
    )
    return modes_with_levels(fit, messages, joint, record.exponential)


def _fit(
    recordings: Sequence[TimeSignals],
    forces: Sequence[str],
    record: Record,
    campaign: Campaign,
    source: str,
    points: Sequence[RovingPoint],
) -> tuple[FileFit, tuple[str, ...]]:
    """Return the fit of files of blows, and messages about it."""
    hits, step, sensors = record.hits, recordings[0].step, recordings[0].names
    messages = list[str]()
    lengths, values, estimates = list[int](), list[Complex](), list[ImpactEstimate]()
    for recording in recordings:
        with errors_in_file(recording.source):
            lengths.append(shortest_blow_length(step, recording.forces[0], hits))
    for recording in recordings:
        with errors_in_file(recording.source):
            estimate = impact_estimate(
                step,
                recording.forces[0],
                recording.pieces[0],
                hits=hits,
                exponential=record.exponential,
                max_length=min(lengths),
            )
        messages += [f"{recording.source}: {message}" for message in estimate.messages]
        values.append(estimate.H * recording.as_accelerations(2j * np.pi * estimate.frequencies)[:, :, None])
        estimates.append(estimate)
    last_estimate = estimates[-1]  # all have the same lines and averages
    f, record_length = last_estimate.frequencies, float(1.0 / last_estimate.frequencies[1])
    known_coherences = [estimate.coherence for estimate in estimates if estimate.coherence is not None]
    coherence = np.concatenate(known_coherences, axis=2) if len(known_coherences) == len(recordings) else None
    size_sigmas = [estimate.sigma_size for estimate in estimates]
    reference = recordings[0].force if len(recordings) == 1 else ""
    responses = Responses(f, np.concatenate(values, axis=2), coherence, sensors, (), (reference,))
    if forces:
        responses = responses.as_roving(range(len(forces)), forces)
    if points:
        changes = [
            point.correction(f, [force], sensors, record.exponential, record_length)
            for point, force in zip(points, forces, strict=True)
        ]
        responses = replace(responses, values=responses.values + np.concatenate(changes, axis=1))
    with errors_in_file(source):
        fit = fit_responses(responses, last_estimate.averages, record, campaign)
    messages += fit_remarks(fit, source)

    def to_full_decay(mode: Mode) -> Mode:
        # The record of a blow cuts off the decays; participations are those of complete ones.
        pole = mode.pole - (1.0 / record.exponential if record.exponential else 0.0)
        full_participation = np.asarray(mode.participation) / (1.0 - np.exp(pole * record_length))
        mode = replace(mode, participation=full_participation)
        # The functions of a file share a relative scale error, common to one shape component (several files) or
        # all (one file).
        if len(recordings) > 1:
            return replace(mode, sigma_shape=float(np.hypot(mode.sigma_shape, max(size_sigmas))))
        return replace(mode, sigma_size=float(np.hypot(mode.sigma_size, max(size_sigmas))))

    return replace(fit, estimate=fit.estimate.map_modes(to_full_decay)), tuple(messages)
