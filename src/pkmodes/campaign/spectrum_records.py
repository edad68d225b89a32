"""Records of power spectra without phase: frequencies only."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from pkmodes.base.errors import MeasurementError, nearest, shown
from pkmodes.campaign.campaign import Campaign, Record
from pkmodes.campaign.file_modes import FileModes, Fit
from pkmodes.campaign.frf_records import found_of, refuse_strangers
from pkmodes.campaign.sensors import unsigned
from pkmodes.identification.spectra import identify_spectrum
from pkmodes.signals.formats import Asked
from pkmodes.signals.functions import Kind
from pkmodes.signals.reading import read_signals


def spectrum_modes(path: Path, record: Record, setup: str, campaign: Campaign) -> FileModes:
    """Return the modes of the spectra in a file, without damping and shapes.

    Raises
    ------
    MeasurementError
        If the file is faulty, or its spectra are not those of the campaign.
    """
    sensors = campaign.sensors_in(setup)
    names = {**{name: name for name in sensors}, **{name.removeprefix("psd_"): name for name in sensors}}
    read = read_signals(path, Asked(sensors=frozenset(names) or None))
    if not any(one.kind is Kind.SPECTRUM for one in read.functions):
        refuse_strangers(path, Kind.SPECTRUM, sensors)
    spectra = [one for one in read.functions if one.kind is Kind.SPECTRUM]
    if not spectra:
        what = f"expected power spectra, found {len(read.functions)} other functions"
        raise MeasurementError(what, read.source, "choose another kind of record")
    used = [one for one in spectra if not sensors or one.response in names]
    if not used:
        found = list(dict.fromkeys(one.response for one in spectra))
        what = f"expected a sensor of the campaign, found {', '.join(map(shown, found[:6]))}"
        raise MeasurementError(what, read.source, nearest(found[0], sensors))
    f = used[0].abscissa
    for one in used:
        if not np.array_equal(one.abscissa, f):
            what = f"the frequencies of {shown(one.response)} differ from those of {shown(used[0].response)}"
            raise MeasurementError(what, read.source, "measure all spectra of a file with the same lines")
    power = np.stack([np.abs(one.values) for one in used], axis=1)
    # Sensors may have other units: each counts as much as the others.
    scale = power[(f >= record.band[0]) & (f <= record.band[1])].sum(axis=0)
    try:
        estimate, messages = identify_spectrum(f, power / np.where(scale > 0.0, scale, 1.0), band=record.band)
    except MeasurementError as error:
        raise MeasurementError(error.what, f"{read.source}: {error.where}", error.remedy) from None
    modes = tuple(
        replace(found_of(mode, ()), shape={}, damping=np.nan, sigma_damping=0.0, found_in=None)
        for mode in (replace(each, shape=np.empty(0, dtype=complex)) for each in estimate.modes)
    )
    said = (*read.messages, *(f"{read.source}: {message}" for message in messages))
    seen = frozenset({one.response for one in used} | {f"psd_{one.response}" for one in used})
    seen |= {unsigned(name) for name in campaign.forces_in(setup)}
    return FileModes(modes, said, seen, Fit(read.source, estimate, tuple(one.response for one in used)))
