"""Frequency responses of a hammer that roved, a file for each point: those of one structure, fitted together.

The points that were hit are the degrees of freedom of the shape, and the fixed sensors its references.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import shown
from pkmodes.modaltest.campaign.campaign import Campaign, Record
from pkmodes.modaltest.campaign.frequency_records import (
    ResponseFile,
    Responses,
    fit_remarks,
    fit_responses,
    read_responses,
)
from pkmodes.modaltest.campaign.mode_estimates import FileModes, modes_from_fit
from pkmodes.modaltest.campaign.roving import RovingPoint
from pkmodes.modaltest.campaign.sensor_functions import errors_in_file

Array = NDArray[np.float64]
T = TypeVar("T", bound=np.generic)
#: Lines that differ by less, in line spacings, are the same: tables round them.
SAME_LINE = 0.01


class SeparateFitError(Exception):
    """Why the files of several points cannot be fitted together."""


def roving_frf_modes(points: Mapping[str, RovingPoint], record: Record, campaign: Campaign) -> FileModes:
    """Return the modes of the functions at all points of a hammer that roved, their shapes by the keys of the forces.

    - points: a file of each setup, each with references that forces of the campaign name

    Raises MeasurementError if a file is faulty.
    Raises ApartError if their lines differ, or no sensor is in all of them.
    """
    files = []
    for setup, point in points.items():
        content = read_responses(point.path, record, setup, campaign)
        file_responses, forces = content.responses, campaign.forces_in(setup)
        names = tuple(forces[name].key for name in file_responses.names)
        # Corrected to the machine halfway through its change.
        correction = point.correction(
            file_responses.frequencies, names, file_responses.references, record.exponential
        )
        files.append(
            replace(
                content,
                responses=replace(file_responses, names=names, values=file_responses.values + correction),
            )
        )
    responses, partial_sensors = join_points(files, record.band)
    with errors_in_file(record.pose):
        fit = fit_responses(responses, record.averages, record, campaign)
    messages = [message for file in files for message in file.messages]
    if partial_sensors:
        messages.append(
            f"{record.pose}: not used, as only some of the points that were hit have it: {partial_sensors}"
        )
    names_in_file = frozenset[str]().union(*(file.names_in_file for file in files))
    return modes_from_fit(fit, [*messages, *fit_remarks(fit, record.pose)], names_in_file)


def join_points(files: Sequence[ResponseFile], band: tuple[float, float]) -> tuple[Responses, str]:
    """Return the functions of several points as those of one file, and the names of sensors that only some have.

    A point in several files gets the mean of its functions.

    Raises ApartError if their lines differ in the band [Hz], or no sensor is in all of them.
    """
    in_band = [_in_band(file, band) for file in files]
    f = in_band[0].frequencies
    for file, responses in zip(files, in_band, strict=True):
        lines = responses.frequencies
        if len(lines) != len(f) or np.abs(lines - f).max(initial=0.0) > SAME_LINE * _step(f):
            raise SeparateFitError(
                f"expected in {file.source} the frequencies of {files[0].source} in the band, {_describe_lines(f)}, "
                f"found {_describe_lines(lines)}; export all points with the same lines"
            )
    sensors = list(dict.fromkeys(name for responses in in_band for name in responses.references))
    common = [name for name in sensors if all(_has_signal(responses, name) for responses in in_band)]
    if not common:
        sensor_names = ", ".join(map(shown, sensors))
        raise SeparateFitError(
            f"expected a sensor with a signal for every point, found none among {sensor_names}"
        )
    selected = [_select_sensors(responses, common) for responses in in_band]
    names = [name for responses in selected for name in responses.names]
    points = tuple(dict.fromkeys(names))
    point_columns = [[i for i, name in enumerate(names) if name == point] for point in points]
    coherences = [
        responses.coherence
        for responses in selected
        if responses.coherence is not None and np.isfinite(responses.coherence).all()
    ]
    joint = replace(
        selected[0],
        values=_means([responses.values for responses in selected], point_columns),
        coherence=_means(coherences, point_columns) if len(coherences) == len(selected) else None,
        names=points,
    )
    return joint, ", ".join(name for name in sensors if name not in common)


def _in_band(file: ResponseFile, band: tuple[float, float]) -> Responses:
    """Return the functions of a file on the lines of a band [Hz]."""
    responses = file.responses
    f = responses.frequencies
    rounding = SAME_LINE * float(np.median(np.diff(f)))
    in_band = (f >= band[0] - rounding) & (f <= band[1] + rounding)
    coherence = None if responses.coherence is None else responses.coherence[in_band]
    return replace(responses, frequencies=f[in_band], values=responses.values[in_band], coherence=coherence)


def _step(f: Array) -> float:
    return float(np.median(np.diff(f))) if len(f) > 1 else 0.0


def _describe_lines(f: Array) -> str:
    """Describe the lines in words [Hz]."""
    ends = f" from {f[0]:.6g} Hz, {_step(f):.4g} Hz apart" if len(f) else ""
    return f"{len(f)} lines{ends}"


def _has_signal(responses: Responses, sensor: str) -> bool:
    """Return whether a sensor has a complete signal for every point in a file."""
    if sensor not in responses.references:
        return False
    values = responses.values[:, :, responses.references.index(sensor)]
    return bool(np.isfinite(values).all() and values.any(axis=0).all())


def _select_sensors(responses: Responses, names: Sequence[str]) -> Responses:
    """Return the functions of some sensors."""
    indices = [responses.references.index(name) for name in names]
    coherence = None if responses.coherence is None else responses.coherence[:, :, indices]
    return replace(
        responses, values=responses.values[:, :, indices], coherence=coherence, references=tuple(names)
    )


def _means(arrays: Sequence[NDArray[T]], point_columns: Sequence[Sequence[int]]) -> NDArray[T]:
    """Return the means over the columns, counted through all arrays, that belong to one point."""
    joined = np.concatenate(arrays, axis=1)
    return np.stack([joined[:, columns].mean(axis=1) for columns in point_columns], axis=1)
