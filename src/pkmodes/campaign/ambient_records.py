"""Records of responses alone: ambient vibration, decays and sweeps."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from pkmodes.campaign.campaign import Campaign, Record
from pkmodes.campaign.file_modes import FileModes, Fit
from pkmodes.campaign.levels import with_levels
from pkmodes.campaign.sensor_functions import added_of, found_of, in_file
from pkmodes.campaign.time_records import time_signals
from pkmodes.identification.estimates import Mode
from pkmodes.identification.ssi_bands import FEWEST_PERIODS
from pkmodes.identification.ssi_identification import identify_responses


def ambient_modes(path: Path, record: Record, setup: str, campaign: Campaign) -> FileModes:
    """Return the modes of the responses in a file, their shapes by sensor.

    Raises
    ------
    MeasurementError
        If the file is faulty, or too short for the band.
    """
    given = time_signals(path, record, setup, campaign, highest=record.band[1])
    with in_file(given.source):
        estimate, messages = identify_responses(
            given.step,
            given.pieces,
            band=record.band,
            tones=campaign.tones,
            asked=campaign.asked(record),
        )
    shortest = FEWEST_PERIODS / record.band[0]
    short = [piece for piece in given.pieces if len(piece) * given.step < shortest]
    if short:
        messages = (
            *messages,
            f"{len(short)} pieces between gaps are shorter than {shortest:.3g} s and were left out",
        )

    def accelerations(mode: Mode) -> Mode:
        return replace(mode, shape=mode.shape * given.as_accelerations(mode.pole))

    modes = [accelerations(mode) for mode in estimate.modes]
    found = with_levels([found_of(mode, given.names) for mode in modes], modes, given)
    added = [one if isinstance(one, str) else accelerations(one) for one in estimate.added]
    said = (*given.messages, *(f"{given.source}: {message}" for message in messages))
    return FileModes(
        found,
        said,
        frozenset(given.names) | campaign.unsigned_forces_in(setup),
        added_of(added, given.names),
        Fit(estimate, given.names),
    )
