"""Frequency responses of a hammer that roved, a file for each point: those of one structure, fitted together.

The points that were hit are the places of the shape, and the sensors that stayed its references.
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
    frf_fit,
    read_responses,
    remarks_on,
)
from pkmodes.modaltest.campaign.mode_estimates import FileModes, modes_of_fit
from pkmodes.modaltest.campaign.roving import RovingPoint
from pkmodes.modaltest.campaign.sensor_functions import in_file

Array = NDArray[np.float64]
T = TypeVar("T", bound=np.generic)
#: Lines that differ by less, in line spacings, are the same: tables round them.
SAME_LINE = 0.01


class ApartError(Exception):
    """Why the files of several points cannot be fitted together."""


def roving_frf_modes(points: Mapping[str, RovingPoint], record: Record, campaign: Campaign) -> FileModes:
    """Return the modes of the functions at all points of a hammer that roved, their shapes by the keys of the forces.

    - points: a file of each setup, each with references that forces of the campaign name

    Raises MeasurementError if a file is faulty.
    Raises ApartError if their lines differ, or no sensor is in all of them.
    """
    files = []
    for setup, point in points.items():
        read = read_responses(point.path, record, setup, campaign)
        of_file, forces = read.responses, campaign.forces_in(setup)
        names = tuple(forces[name].key for name in of_file.names)
        # Corrected to the machine halfway through its change.
        change = point.change(of_file.frequencies, names, of_file.references, record.exponential)
        files.append(replace(read, responses=replace(of_file, names=names, values=of_file.values + change)))
    responses, left_out = points_together(files, record.band)
    with in_file(record.pose):
        fit = frf_fit(responses, record.averages, record, campaign)
    messages = [message for file in files for message in file.messages]
    if left_out:
        messages.append(
            f"{record.pose}: not used, as only some of the points that were hit have it: {left_out}"
        )
    names_in_file = frozenset[str]().union(*(file.names_in_file for file in files))
    return modes_of_fit(fit, [*messages, *remarks_on(fit, record.pose)], names_in_file)


def points_together(files: Sequence[ResponseFile], band: tuple[float, float]) -> tuple[Responses, str]:
    """Return the functions of several points as those of one file, and the names of sensors that only some have.

    A point in several files gets the mean of its functions.

    Raises ApartError if their lines differ in the band [Hz], or no sensor is in all of them.
    """
    inside = [_in_band(file, band) for file in files]
    f = inside[0].frequencies
    for file, responses in zip(files, inside, strict=True):
        lines = responses.frequencies
        if len(lines) != len(f) or np.abs(lines - f).max(initial=0.0) > SAME_LINE * _step(f):
            raise ApartError(
                f"expected in {file.source} the frequencies of {files[0].source} in the band, {_lines(f)}, found "
                f"{_lines(lines)}; export all points with the same lines"
            )
    sensors = list(dict.fromkeys(name for responses in inside for name in responses.references))
    common = [name for name in sensors if all(_shows(responses, name) for responses in inside)]
    if not common:
        which = ", ".join(map(shown, sensors))
        raise ApartError(f"expected a sensor with a signal for every point, found none among {which}")
    kept = [_of_sensors(responses, common) for responses in inside]
    names = [name for responses in kept for name in responses.names]
    points = tuple(dict.fromkeys(names))
    at = [[i for i, name in enumerate(names) if name == point] for point in points]
    coherences = [
        responses.coherence
        for responses in kept
        if responses.coherence is not None and np.isfinite(responses.coherence).all()
    ]
    joint = replace(
        kept[0],
        values=_means([responses.values for responses in kept], at),
        coherence=_means(coherences, at) if len(coherences) == len(kept) else None,
        names=points,
    )
    return joint, ", ".join(name for name in sensors if name not in common)


def _in_band(file: ResponseFile, band: tuple[float, float]) -> Responses:
    """Return the functions of a file on the lines of a band [Hz]."""
    responses = file.responses
    f = responses.frequencies
    rounding = SAME_LINE * float(np.median(np.diff(f)))
    inside = (f >= band[0] - rounding) & (f <= band[1] + rounding)
    coherence = None if responses.coherence is None else responses.coherence[inside]
    return replace(responses, frequencies=f[inside], values=responses.values[inside], coherence=coherence)


def _step(f: Array) -> float:
    return float(np.median(np.diff(f))) if len(f) > 1 else 0.0


def _lines(f: Array) -> str:
    """Describe the lines in words [Hz]."""
    ends = f" from {f[0]:.6g} Hz, {_step(f):.4g} Hz apart" if len(f) else ""
    return f"{len(f)} lines{ends}"


def _shows(responses: Responses, sensor: str) -> bool:
    """Return whether a sensor has a complete signal for every point in a file."""
    if sensor not in responses.references:
        return False
    values = responses.values[:, :, responses.references.index(sensor)]
    return bool(np.isfinite(values).all() and values.any(axis=0).all())


def _of_sensors(responses: Responses, names: Sequence[str]) -> Responses:
    """Return the functions of some sensors."""
    at = [responses.references.index(name) for name in names]
    coherence = None if responses.coherence is None else responses.coherence[:, :, at]
    return replace(responses, values=responses.values[:, :, at], coherence=coherence, references=tuple(names))


def _means(parts: Sequence[NDArray[T]], at: Sequence[Sequence[int]]) -> NDArray[T]:
    """Return the means over the columns, counted through all arrays, that belong to one point."""
    whole = np.concatenate(parts, axis=1)
    return np.stack([whole[:, places].mean(axis=1) for places in at], axis=1)
