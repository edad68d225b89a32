"""Records of impacts: force and responses in time."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from pkmodes.campaign.campaign import Campaign, Record
from pkmodes.campaign.file_modes import FileModes, Fit
from pkmodes.campaign.levels import with_levels
from pkmodes.campaign.sensor_functions import ACCELERATION, added_of, found_of, in_file
from pkmodes.campaign.time_records import time_signals
from pkmodes.core.base.errors import MeasurementError
from pkmodes.identification.frf_estimates import impact_estimate
from pkmodes.identification.frf_identification import identify_frf
from pkmodes.identification.tones import no_bandwidth

#: Periods of the lower end of the band that a record of blows has at least.
FEWEST_PERIODS = 2.0


def impact_modes(path: Path, record: Record, setup: str, campaign: Campaign) -> FileModes:
    """Return the modes of the blows in a file, their shapes by sensor.

    Raises
    ------
    MeasurementError
        If the file is faulty, has no force, or fewer blows than the campaign says.
    """
    given = time_signals(path, record, setup, campaign)
    if not given.forces:
        remedy = "name its column force, or give its type in the universal file; without a force the kind is ambient"
        raise MeasurementError("expected a force, found none", given.source, remedy)
    if len(given.pieces) > 1:
        what = f"expected one piece of even sampling, found {len(given.pieces)}"
        raise MeasurementError(what, given.source, "measure the blows again, or leave the file out")
    force = given.forces[0]
    if not np.ptp(force):
        raise MeasurementError(
            "expected blows, found a constant force", given.source, "check the hammer's cable"
        )
    seconds = len(force) * given.step
    if seconds * record.band[0] < FEWEST_PERIODS:
        what = f"expected at least {FEWEST_PERIODS:g} periods of {record.band[0]:g} Hz, found {seconds:.3g} s"
        raise MeasurementError(what, given.source, "measure longer, or narrow the band")
    with in_file(given.source):
        functions = impact_estimate(
            given.step,
            force,
            given.pieces[0],
            hits=record.hits,
            exponential=record.exponential,
            names=given.names,
        )
        factors = given.as_accelerations(2j * np.pi * functions.frequencies)
        estimate = identify_frf(
            functions.frequencies,
            functions.H * factors[:, :, None],
            band=record.band,
            power=ACCELERATION,
            coherence=functions.coherence,
            averages=functions.averages,
            exponential=record.exponential,
            tones=campaign.tones,
            asked=campaign.asked(record),
        )
    f = functions.frequencies
    inside = slice(*np.searchsorted(f, estimate.frequencies[[0, -1]]) + np.array([0, 1]))
    coherence = None if functions.coherence is None else functions.coherence[inside]
    return FileModes(
        with_levels(
            [found_of(mode, given.names) for mode in estimate.modes],
            estimate.modes,
            given,
            record.exponential,
        ),
        (
            *given.messages,
            *(f"{given.source}: {message}" for message in functions.messages),
            *(f"{given.source}: {no_bandwidth(tone)}" for tone in estimate.tones),
        ),
        frozenset(given.names) | campaign.unsigned_forces_in(setup),
        added_of(estimate.added, given.names),
        Fit(estimate, given.names, ("force",), coherence),
    )
