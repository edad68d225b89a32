"""Records of power spectra without phase: frequencies only."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from pkmodes.campaign.campaign import Campaign, Record
from pkmodes.campaign.file_modes import FileModes, Fit
from pkmodes.campaign.found import Found
from pkmodes.campaign.sensor_functions import in_file, sensor_functions
from pkmodes.identification.estimates import Mode
from pkmodes.identification.spectra import identify_spectrum
from pkmodes.signals.functions import Kind


def spectrum_modes(path: Path, record: Record, setup: str, campaign: Campaign) -> FileModes:
    """Return the modes of the spectra in a file, without damping and shapes.

    Raises
    ------
    MeasurementError
        If the file is faulty, or its spectra are not those of the campaign.
    """
    sensors = campaign.sensors_in(setup)
    functions = sensor_functions(
        path, Kind.SPECTRUM, frozenset({*sensors, *(name.removeprefix("psd_") for name in sensors)})
    )
    read, used = functions.read, functions.used
    f = used[0].abscissa
    power = np.stack([np.abs(one.values) for one in used], axis=1)
    # Sensors may have other units: each counts as much as the others.
    scale = power[(f >= record.band[0]) & (f <= record.band[1])].sum(axis=0)
    with in_file(read.source):
        relative = power / np.where(scale > 0.0, scale, 1.0)
        estimate, messages = identify_spectrum(f, relative, band=record.band, asked=campaign.asked(record))
    line = float(np.median(np.diff(f)))

    def found(mode: Mode) -> Found:
        return Found(mode.frequency, sigma_frequency=mode.sigma_frequency, resolution=line)

    modes = tuple(found(mode) for mode in estimate.modes)
    added = tuple(one if isinstance(one, str) else found(one) for one in estimate.added)
    said = (*read.messages, *(f"{read.source}: {message}" for message in messages))
    seen = frozenset({one.response for one in used} | {f"psd_{one.response}" for one in used})
    names = tuple(one.response for one in used)
    return FileModes(modes, said, seen | campaign.unsigned_forces_in(setup), added, Fit(estimate, names))
