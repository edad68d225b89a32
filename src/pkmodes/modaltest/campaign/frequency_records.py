"""Records of functions of frequency: frequency response functions, and power spectra, which have no phase."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import MeasurementError
from pkmodes.modaltest.campaign.campaign import Campaign, Record
from pkmodes.modaltest.campaign.conjugates import check_phase
from pkmodes.modaltest.campaign.mode_estimates import (
    NAMELESS,
    FileFit,
    FileModes,
    ModeEstimate,
    modes_from_fit,
)
from pkmodes.modaltest.campaign.quotients import force_factor, invert_functions
from pkmodes.modaltest.campaign.sensor_functions import (
    ACCELERATION,
    SensorFunctions,
    check_size,
    dead_channel_messages,
    errors_in_file,
    motion_of,
    refuse_repeated,
    sensor_functions,
)
from pkmodes.modaltest.campaign.sensors import MotionSensor, Transducer, without_sign
from pkmodes.modaltest.identification.estimates import Mode
from pkmodes.modaltest.identification.frf_identification import identify_frf
from pkmodes.modaltest.identification.frf_model_errors import nonlinearity_message
from pkmodes.modaltest.identification.spectra import identify_spectrum
from pkmodes.modaltest.identification.tones import tone_message
from pkmodes.modaltest.signals.functions import Function, FunctionKind

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]


@dataclass(frozen=True, eq=False)
class Responses:
    """The functions of a file.

    - frequencies: (F,) [Hz]
    - values: accelerations in SI units per force, (F, S, R); NaN where not measured
    - coherence: (F, S, R)
    - names: names of the S places in the shape
    - dead: sensors without a signal
    - references: names of the R references
    - messages: what is left out of the shapes
    - is_roving: whether the S places are those of forces
    """

    frequencies: Array
    values: Complex
    coherence: Array | None
    names: tuple[str, ...]
    dead: tuple[str, ...]
    references: tuple[str, ...]
    messages: tuple[str, ...] = ()
    is_roving: bool = False

    def as_roving(self, columns: Sequence[int], forces: Sequence[str]) -> Responses:
        """Return the functions with the forces of some references as places of the shape.

        By reciprocity: the hammer roves, and the sensors are the references.
        """
        transposed = self.values[:, :, columns].transpose(0, 2, 1)
        coherence = None if self.coherence is None else self.coherence[:, :, columns].transpose(0, 2, 1)
        return replace(
            self,
            values=transposed,
            coherence=coherence,
            names=tuple(forces),
            references=self.names,
            is_roving=True,
        )


@dataclass(frozen=True, eq=False)
class ResponseFile:
    """The content of a file of frequency response functions.

    - names_in_file: as in `FileModes`
    - messages: what the user should know of the file
    """

    source: str
    responses: Responses
    names_in_file: frozenset[str]
    messages: tuple[str, ...]


def frf_modes(path: Path, record: Record, setup: str, campaign: Campaign) -> FileModes:
    """Return the modes of the frequency response functions in a file, their shapes by sensor.

    Raises MeasurementError if the file is faulty, or its functions are not those of the campaign.
    """
    content = read_responses(path, record, setup, campaign)
    responses = content.responses
    with errors_in_file(content.source):
        fit = fit_responses(responses, record.averages, record, campaign)
    unnamed = (
        () if responses.is_roving else tuple(name for name in responses.references if name not in NAMELESS)
    )
    messages = (*content.messages, *fit_remarks(fit, content.source))
    forces = responses.names if responses.is_roving else ()
    return replace(modes_from_fit(fit, messages, content.names_in_file), unnamed=unnamed, forces=forces)


def read_responses(path: Path, record: Record, setup: str, campaign: Campaign) -> ResponseFile:
    """Return the frequency response functions in a file of a record, which cover its band.

    Raises MeasurementError if the file is faulty, or its functions are not those of the campaign.
    """
    sensors = campaign.sensors_in(setup)
    functions = sensor_functions(
        path, FunctionKind.FRF, frozenset(sensors), record, signs=campaign.signs_of_file
    )
    file = functions.file
    if record.invert:
        functions = replace(functions, used=invert_functions(functions.used, file.source))
    checked, doubts = check_phase(functions.used, record.band, record.conjugate, file.source)
    functions = replace(functions, used=checked)
    responses = arrange_responses(functions, sensors, campaign.forces_in(setup), campaign.channels)
    low, high = record.band
    first, last = responses.frequencies[0], responses.frequencies[-1]
    if low < first:
        problem = f"expected frequencies from the beginning of the band, {low:g} Hz, found {first:g} Hz"
        raise MeasurementError(problem, file.source, "narrow the band of the record")
    if high > last:
        problem = f"expected frequencies up to the end of the band, {high:g} Hz, found {last:g} Hz"
        raise MeasurementError(problem, file.source, "narrow the band of the record")
    names_in_file = {function.response for function in functions.used} | {
        without_sign(function.reference) for function in functions.used
    }
    if responses.is_roving:  # a reference without a name appears under that of its force
        names_in_file |= {without_sign(name) for name in responses.names}
    messages = (
        *file.messages,
        *doubts,
        *responses.messages,
        *dead_channel_messages(responses.dead, file.source),
    )
    return ResponseFile(file.source, responses, frozenset(names_in_file), messages)


def fit_responses(responses: Responses, averages: int | None, record: Record, campaign: Campaign) -> FileFit:
    """Fit frequency response functions in the band of a record; `averages` is None if unknown."""
    estimate = identify_frf(
        responses.frequencies,
        responses.values,
        band=record.band,
        derivative_order=ACCELERATION,
        coherence=responses.coherence,
        averages=averages,
        window_time_constant=record.exponential,
        tones=campaign.tones,
        edits=campaign.edits_of(record),
    )
    in_band = slice(*np.searchsorted(responses.frequencies, estimate.frequencies[[0, -1]]) + np.array([0, 1]))
    coherence = None if responses.coherence is None else responses.coherence[in_band]
    return FileFit(estimate, responses.names, responses.references, coherence)


def fit_remarks(fit: FileFit, source: str) -> list[str]:
    """Return messages about lines without bandwidth, and about spurious modes of a nonlinear machine."""
    estimate = fit.estimate
    remarks = [tone_message(tone) for tone in estimate.tones]
    if estimate.spurious_frequencies:
        remarks.append(nonlinearity_message(estimate.model_error, estimate.spurious_frequencies))
    return [f"{source}: {remark}" for remark in remarks]


def arrange_responses(
    functions: SensorFunctions,
    sensors: Mapping[str, MotionSensor],
    forces: Mapping[str, Transducer],
    channels: Mapping[str, str],
) -> Responses:
    """Arrange the frequency response functions of a file.

    If forces are declared, these are the places of the shape, and the sensors the references: a roving hammer, by
    reciprocity.

    Raises MeasurementError if one occurs twice, is not a motion over a force, or a unit is unknown or contradicts the
    campaign.
    """
    file, used = functions.file, functions.used
    f = used[0].abscissa
    rows = list(dict.fromkeys(function.response for function in used))
    columns = list(dict.fromkeys(function.reference for function in used))
    values = np.full((len(f), len(rows), len(columns)), complex(np.nan, np.nan))
    for function in used:
        index = (slice(None), rows.index(function.response), columns.index(function.reference))
        if np.isfinite(values[index]).any():
            refuse_repeated(
                function.response, f"the function {function.response}/{function.reference}", file.source
            )
        sensor = sensors[function.response]
        denominator = force_factor(function, file.source, sensor.motion)
        motion = motion_of(function, sensor, channels, file.source)
        values[index] = function.values * (
            motion.factor / denominator * (2j * np.pi * f) ** (ACCELERATION - motion.derivative)
        )
    check_size(values, file.source)
    dead = tuple(name for i, name in enumerate(rows) if not np.nan_to_num(values[:, i]).any())
    coherence = _coherence(file.functions, rows, columns, f)
    named_references = [name for name in columns if name not in NAMELESS or len(columns) == 1]
    acting = {
        name: force for name in named_references if (force := force_of_reference(name, forces)) is not None
    }
    unnamed = [name for name in columns if name and name not in acting]
    messages: tuple[str, ...] = ()
    if unnamed and acting:
        messages = (
            f"{file.source}: left out, as no [[force]] names them: the references {', '.join(unnamed)}",
        )
    responses = Responses(f, values, coherence, tuple(rows), dead, tuple(columns), messages)
    if acting:
        return responses.as_roving(
            [columns.index(name) for name in acting], [force.name for force in acting.values()]
        )
    return responses


def _coherence(
    functions: Sequence[Function], rows: Sequence[str], columns: Sequence[str], f: Array
) -> Array | None:
    coherence = np.full((len(f), len(rows), len(columns)), np.nan)
    for function in functions:
        matches = (
            function.kind is FunctionKind.COHERENCE
            and function.response in rows
            and function.reference in columns
        )
        if matches and np.array_equal(function.abscissa, f):
            coherence[:, rows.index(function.response), columns.index(function.reference)] = function.values
    return coherence if np.isfinite(coherence).any() else None


def force_of_reference(name: str, forces: Mapping[str, Transducer]) -> Transducer | None:
    """Return the force of a reference, ignoring signs in names; a nameless reference is that of the only force."""
    force = next(
        (
            candidate
            for force_name, candidate in forces.items()
            if without_sign(force_name) == without_sign(name)
        ),
        None,
    )
    if force is None and name in NAMELESS and len(forces) == 1:
        return next(iter(forces.values()))
    return force


def spectrum_modes(path: Path, record: Record, setup: str, campaign: Campaign) -> FileModes:
    """Return the modes of the spectra in a file, without damping and shapes.

    Raises MeasurementError if the file is faulty, or its spectra are not those of the campaign.
    """
    sensors = campaign.sensors_in(setup)
    names = frozenset({*sensors, *(name.removeprefix("psd_") for name in sensors)})
    functions = sensor_functions(path, FunctionKind.SPECTRUM, names, record)
    file, used = functions.file, functions.used
    f = used[0].abscissa
    power = np.stack([np.abs(function.values) for function in used], axis=1)
    # Sensors may have different units: each gets the same weight.
    scale = power[(f >= record.band[0]) & (f <= record.band[1])].sum(axis=0)
    with errors_in_file(file.source):
        relative = power / np.where(scale > 0.0, scale, 1.0)
        estimate, messages = identify_spectrum(f, relative, band=record.band, edits=campaign.edits_of(record))
    line_spacing = float(np.median(np.diff(f)))

    def to_estimate(mode: Mode) -> ModeEstimate:
        return ModeEstimate(mode.frequency, sigma_frequency=mode.sigma_frequency, resolution=line_spacing)

    dead = dead_channel_messages([used[i].response for i in np.flatnonzero(~power.any(axis=0))], file.source)
    all_messages = (*file.messages, *dead, *(f"{file.source}: {message}" for message in messages))
    names_in_file = frozenset(
        {function.response for function in used} | {f"psd_{function.response}" for function in used}
    )
    responses = tuple(function.response for function in used)
    return modes_from_fit(FileFit(estimate, responses), all_messages, names_in_file, to_estimate)
