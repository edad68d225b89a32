"""Records of impacts: force and responses in time."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from pkmodes.base.errors import MeasurementError
from pkmodes.campaign.campaign import Campaign, Record
from pkmodes.campaign.found import Found
from pkmodes.campaign.frf_records import ACCELERATION, found_of
from pkmodes.campaign.time_records import time_signals
from pkmodes.identification.frf_estimates import impact_estimate
from pkmodes.identification.frf_identification import identify_frf


def impact_modes(path: Path, record: Record, setup: str, campaign: Campaign) -> tuple[list[Found], list[str]]:
    """Return the modes of the blows in a file, their shapes by sensor, and sentences for the user.

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
    try:
        functions = impact_estimate(
            given.step, given.forces[0], given.pieces[0], hits=record.hits, exponential=record.exponential
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
        )
    except MeasurementError as error:
        raise MeasurementError(error.what, f"{given.source}: {error.where}", error.remedy) from None
    said = [*given.messages, *(f"{given.source}: {message}" for message in functions.messages)]
    return [found_of(mode, given.names) for mode in estimate.modes], said
