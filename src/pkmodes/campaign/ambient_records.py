"""Records of responses alone: ambient vibration, decays and sweeps."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from pkmodes.base.errors import MeasurementError
from pkmodes.campaign.campaign import Campaign, Record
from pkmodes.campaign.found import Found
from pkmodes.campaign.frf_records import found_of
from pkmodes.campaign.time_records import time_signals
from pkmodes.identification.ssi_identification import FEWEST_PERIODS, identify_responses


def ambient_modes(
    path: Path, record: Record, setup: str, campaign: Campaign
) -> tuple[list[Found], list[str]]:
    """Return the modes of the responses in a file, their shapes by sensor, and sentences for the user.

    Raises
    ------
    MeasurementError
        If the file is faulty, or too short for the band.
    """
    given = time_signals(path, record, setup, campaign)
    try:
        estimate, messages = identify_responses(
            given.step, given.pieces, band=record.band, tones=campaign.tones
        )
    except MeasurementError as error:
        raise MeasurementError(error.what, f"{given.source}: {error.where}", error.remedy) from None
    shortest = FEWEST_PERIODS / record.band[0]
    short = [piece for piece in given.pieces if len(piece) * given.step < shortest]
    if short:
        messages = (
            *messages,
            f"{len(short)} pieces between gaps are shorter than {shortest:.3g} s and were left out",
        )
    found = [
        found_of(replace(mode, shape=mode.shape * given.as_accelerations(mode.pole)), given.names)
        for mode in estimate.modes
    ]
    return found, [*given.messages, *(f"{given.source}: {message}" for message in messages)]
