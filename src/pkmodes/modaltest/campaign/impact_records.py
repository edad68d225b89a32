"""Impact tests in time: fitting one file, or jointly the files of all points hit with a roving hammer.

When the hammer roves and the sensors stay in place, the points hit become the shape's degrees of freedom and the
sensors its references.  The functions, though measured one after the other, are those of one structure, and are
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
    shortest_decay_length,
)
from pkmodes.modaltest.signals.functions import MAX_NAMES
from pkmodes.modaltest.signals.reading import read_signals

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
#: Minimum length of a record of impacts, in periods of the lower end of the band.
MIN_RECORD_PERIODS = 2.0
#: Largest relative difference between the rates of two files that counts as rounding.
RATE_TOLERANCE = 1e-9


@dataclass(frozen=True, eq=False)
class _ImpactSignals:
    """The signals of one file of impacts, and the force of the campaign that acts in it.

    - force: None if the campaign declares no forces
    """

    signals: TimeSignals
    force: Transducer | None


def impact_modes(path: Path, record: Record, setup: str, campaign: Campaign) -> FileModes:
    """Return the modes of the impacts in a file, their shapes by sensor, or by force where a roving hammer was used.

    Raises MeasurementError if the file is faulty, has no force, or has fewer impacts than the campaign states.
    """
    impacts = _read_impact_signals(path, record, setup, campaign)
    force_names = () if impacts.force is None else (impacts.force.name,)
    file_modes = _modes([impacts], force_names, record, campaign, impacts.signals.source)
    undeclared_forces = (
        (impacts.signals.force,) if not force_names and impacts.signals.force not in NAMELESS else ()
    )
    names_in_file = impacts.signals.names_in_file | set(map(without_sign, force_names))
    return replace(file_modes, names_in_file=names_in_file, unnamed=undeclared_forces, forces=force_names)


def read_impact_responses(path: Path, record: Record, setup: str, campaign: Campaign) -> Responses:
    """Return the frequency responses of the impacts in a file, without fitting modes to them.

    Raises MeasurementError as `impact_modes` does for a faulty file.
    """
    impacts = _read_impact_signals(path, record, setup, campaign)
    estimates, _ = _estimate_responses([impacts.signals], record)
    force_keys = () if impacts.force is None else (impacts.force.name,)
    return _join_responses(estimates, [impacts.signals], force_keys)


def roving_modes(points: Mapping[str, RovingPoint], record: Record, campaign: Campaign) -> FileModes:
    """Return the modes of the points hit with a roving hammer, their shapes by the keys of the forces.

    - points: file of each setup, with a force of the campaign

    Raises MeasurementError if a file is faulty, or the files differ in their sensors or rates.
    """
    impact_files = [
        _read_impact_signals(point.path, record, setup, campaign) for setup, point in points.items()
    ]
    first = impact_files[0].signals
    for signals in (impact_file.signals for impact_file in impact_files):
        if (
            signals.names_in_file != first.names_in_file
            or abs(signals.step / first.step - 1.0) > RATE_TOLERANCE
        ):
            problem = f"expected the sensors and the rate of {first.source}"
            raise MeasurementError(problem, signals.source, "measure all points alike")
    sensor_names = [
        sensor_name
        for sensor_name in first.names
        if all(sensor_name in impact_file.signals.names for impact_file in impact_files)
    ]
    if not sensor_names:
        problem = "expected a sensor with a signal at every point that was hit, found none"
        raise MeasurementError(problem, record.pose, "check the sensors and their cables")
    impact_files = [
        replace(impact_file, signals=impact_file.signals.select(sensor_names)) for impact_file in impact_files
    ]
    force_keys = [impact_file.force.key for impact_file in impact_files if impact_file.force is not None]
    return _modes(impact_files, force_keys, record, campaign, record.pose, list(points.values()))


def _read_impact_signals(path: Path, record: Record, setup: str, campaign: Campaign) -> _ImpactSignals:
    """Read a file of impacts.

    Raises MeasurementError if it is faulty, or its force is none of the campaign's, or could be any of several.
    """
    signals = time_signals(path, record, setup, campaign)
    if not signals.forces:
        functions = read_signals(path, replace(signal_request(record), force=False)).functions
        names = list(dict.fromkeys(function.response for function in functions))
        signal_names = listed([*map(shown, names)], MAX_NAMES)
        remedy = f'state in the record which of {signal_names} it is, names = {{ force = "NAME" }}'
        remedy += ', or give its type in a universal file; or, if no force was measured, set kind = "ambient"'
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
        return _ImpactSignals(signals, None)
    force = force_of_reference(signals.force, forces)
    if force is None:
        expected = ", ".join(map(shown, forces))
        problem = f"expected a force of the campaign, {expected}, found {shown(signals.force)}"
        remedy = 'name each [[force]] as in the files; where these say only "force", give each its setup'
        raise MeasurementError(problem, signals.source, remedy)
    return _ImpactSignals(signals, force)


def _modes(
    impact_files: Sequence[_ImpactSignals],
    force_keys: Sequence[str],
    record: Record,
    campaign: Campaign,
    source: str,
    points: Sequence[RovingPoint] = (),
) -> FileModes:
    """Return the modes of files of impacts, with shapes at the named forces, or else at the sensors."""
    recordings = [impact_file.signals for impact_file in impact_files]
    fit, bridge_messages = fit_with_bridges(
        lambda recordings_with_bridged_gaps: _fit(
            recordings_with_bridged_gaps, force_keys, record, campaign, source, points
        ),
        recordings,
        source,
    )
    messages = (*(message for recording in recordings for message in recording.messages), *bridge_messages)
    all_signals = replace(
        recordings[0], pieces=tuple(piece for recording in recordings for piece in recording.pieces)
    )
    return modes_with_levels(fit, messages, all_signals, record.exponential)


def _fit(
    recordings: Sequence[TimeSignals],
    force_keys: Sequence[str],
    record: Record,
    campaign: Campaign,
    source: str,
    points: Sequence[RovingPoint],
) -> tuple[FileFit, tuple[str, ...]]:
    """Return the fit of files of impacts, and messages about it."""
    estimates, messages = _estimate_responses(recordings, record)
    last_estimate = estimates[-1]  # all have the same lines and averages
    record_length = float(1.0 / last_estimate.frequencies[1])
    responses = _join_responses(estimates, recordings, force_keys)
    if points:
        f, sensors = responses.frequencies, recordings[0].names
        corrections = [
            point.correction(f, [force_key], sensors, record.exponential, record_length)
            for point, force_key in zip(points, force_keys, strict=True)
        ]
        responses = replace(responses, values=responses.values + np.concatenate(corrections, axis=1))
    with errors_in_file(source):
        fit = fit_responses(responses, last_estimate.averages, record, campaign)
    messages += fit_remarks(fit, source)
    largest_scale_sigma = max(estimate.sigma_scale for estimate in estimates)

    def complete(mode: Mode) -> Mode:
        mode = _to_full_decay(mode, record.exponential, record_length)
        # The functions of a file share a relative scale error, which affects one shape component if each file is one
        # point, and all components if there is one file.
        if len(recordings) > 1:
            return replace(mode, sigma_shape=float(np.hypot(mode.sigma_shape, largest_scale_sigma)))
        return replace(mode, sigma_scale=float(np.hypot(mode.sigma_scale, largest_scale_sigma)))

    return replace(fit, estimate=fit.estimate.map_modes(complete)), tuple(messages)


def _estimate_responses(
    recordings: Sequence[TimeSignals], record: Record
) -> tuple[list[ImpactEstimate], list[str]]:
    """Return the frequency responses of each recording, as accelerations at the same lines, and messages."""
    step, hits = recordings[0].step, record.hits
    lengths = list[int]()
    for recording in recordings:
        with errors_in_file(recording.source):
            lengths.append(shortest_decay_length(step, recording.forces[0], hits))
    estimates, messages = list[ImpactEstimate](), list[str]()
    for recording in recordings:
        with errors_in_file(recording.source):
            estimate = impact_estimate(
                step,
                recording.forces[0],
                recording.pieces[0],
                hits=hits,
                window_time_constant=record.exponential,
                max_length=min(lengths),
            )
        messages += [f"{recording.source}: {message}" for message in estimate.messages]
        factors = recording.as_accelerations(2j * np.pi * estimate.frequencies)
        estimates.append(replace(estimate, H=estimate.H * factors[:, :, None]))
    return estimates, messages


def _join_responses(
    estimates: Sequence[ImpactEstimate], recordings: Sequence[TimeSignals], force_keys: Sequence[str]
) -> Responses:
    """Return the responses of recordings with the same lines, as those of a roving hammer if it has forces."""
    known_coherences = [estimate.coherence for estimate in estimates if estimate.coherence is not None]
    coherence = np.concatenate(known_coherences, axis=2) if len(known_coherences) == len(recordings) else None
    reference = recordings[0].force if len(recordings) == 1 else ""
    H = np.concatenate([estimate.H for estimate in estimates], axis=2)
    responses = Responses(estimates[-1].frequencies, H, coherence, recordings[0].names, (), (reference,))
    return responses.as_roving(range(len(force_keys)), force_keys) if force_keys else responses


def _to_full_decay(mode: Mode, window_time_constant: float | None, record_length: float) -> Mode:
    """Return a mode with the participations of complete decays: the record ends before the decays do."""
    pole = mode.pole - (1.0 / window_time_constant if window_time_constant else 0.0)
    full_participation = np.asarray(mode.participation) / (1.0 - np.exp(pole * record_length))
    return replace(mode, participation=full_participation)
