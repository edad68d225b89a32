"""Records of responses alone: ambient vibration, decays or sweeps, from one board or several recording together."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from pkmodes.core.base.errors import MeasurementError, shown
from pkmodes.core.base.numbers import plain
from pkmodes.modaltest.campaign.boards import Board, add_clock_uncertainty, align_boards
from pkmodes.modaltest.campaign.campaign import Campaign, Record
from pkmodes.modaltest.campaign.mode_estimates import FileFit, FileModes
from pkmodes.modaltest.campaign.sensor_functions import errors_in_file
from pkmodes.modaltest.campaign.time_records import (
    MAX_BRIDGED_PERIODS,
    TimeSignals,
    fit_with_bridges,
    modes_with_levels,
    time_signals,
)
from pkmodes.modaltest.identification.clocks import Delay
from pkmodes.modaltest.identification.estimates import Mode
from pkmodes.modaltest.identification.ssi_bands import MIN_PERIODS
from pkmodes.modaltest.identification.ssi_identification import identify_responses


def ambient_modes(path: Path, record: Record, setup: str, campaign: Campaign) -> FileModes:
    """Return the modes of the responses in a file, their shapes by sensor.

    Raises MeasurementError if the file is faulty, or too short for the band.
    """
    recording, delays, columns = _read_boards(path, record, setup, campaign)

    def fit_variant(variants: Sequence[TimeSignals]) -> tuple[FileFit, tuple[str, ...]]:
        estimate, messages = identify_responses(
            recording.step,
            variants[0].pieces,
            band=record.band,
            tones=campaign.tones,
            edits=campaign.edits_of(record),
        )
        return FileFit(estimate, recording.names), tuple(
            f"{recording.source}: {message}" for message in messages
        )

    with errors_in_file(recording.source):
        try:
            fit, messages = fit_with_bridges(fit_variant, [recording], recording.source)
        except MeasurementError as error:
            if not recording.gap > 0.0:
                raise
            # It may be too short only because its gaps split it.
            problem = f"{error.what}: {len(recording.pieces) - 1} gaps of {plain(1e3 * recording.gap, 3)} ms split it"
            bridged_band = plain(MAX_BRIDGED_PERIODS / recording.gap, 3)
            lower_band = f"end the band at {bridged_band} Hz or lower, where they are bridged"
            raise MeasurementError(problem, error.where, f"{lower_band}; or {error.remedy}") from None
    min_length = MIN_PERIODS / record.band[0]
    short_pieces = [piece for piece in recording.pieces if len(piece) * recording.step < min_length]
    if short_pieces:
        messages = (
            *messages,
            f"{recording.source}: {len(short_pieces)} pieces between gaps are shorter than {plain(min_length, 3)} s "
            "and were left out",
        )
    unsigned_modes: dict[str, list[str]] = {}

    def to_acceleration(mode: Mode) -> Mode:
        scaled = replace(mode, shape=mode.shape * recording.as_accelerations(mode.pole))
        adjusted, unsigned_setups = add_clock_uncertainty(scaled, columns, delays)
        for name in unsigned_setups:
            unsigned_modes.setdefault(name, []).append(f"{mode.frequency:.4g}")
        return adjusted

    fit = replace(fit, estimate=fit.estimate.map_modes(to_acceleration))
    sign_messages = [
        f"{recording.source}: the modes at {', '.join(modes)} Hz have no components of {name}: its clock is not known"
        " well enough to tell their sign"
        for name, modes in unsigned_modes.items()
    ]
    all_messages = (*recording.messages, *messages, *sign_messages)
    return modes_with_levels(fit, all_messages, recording)


def _read_boards(
    path: Path, record: Record, setup: str, campaign: Campaign
) -> tuple[TimeSignals, Mapping[str, Delay], Mapping[str, slice]]:
    """Return the signals of a file, joined with those that other boards recorded at the same time.

    Sensors of other boards keep their campaign names.

    Returns, in this order:
    - signals
    - delays, columns: offset added to the times of each other board, and the columns of its signals, by setup
    """
    signals = time_signals(path, record, setup, campaign, highest=record.band[1])
    other_boards = {
        name: time_signals(file, record, name, campaign, highest=record.band[1])
        for name, file in record.simultaneous_files(path).items()
    }
    if not other_boards:
        return signals, {}, {}
    names, columns, names_in_file = list(signals.names), {}, set(signals.names_in_file)
    used_keys = {campaign.sensors_in(setup)[name].key for name in names}
    for name, board_signals in other_boards.items():
        sensors = campaign.sensors_in(name)
        keys = [sensors[sensor_name].key for sensor_name in board_signals.names]
        names_in_file |= {sensors[sensor_name].key for sensor_name in board_signals.names_in_file}
        duplicate = next((key for key in keys if key in used_keys), None)
        if duplicate is not None:
            problem = f"the sensor {shown(duplicate)} is in the files of both {setup} and {name}"
            raise MeasurementError(
                problem, board_signals.source, f'give each [[sensor]] its own: setup = "{name}"'
            )
        columns[name] = slice(len(names), len(names) + len(keys))
        names += keys
        used_keys |= set(keys)
    boards = {
        name: Board(board.source, board.step, board.starts, board.pieces)
        for name, board in {setup: signals, **other_boards}.items()
    }
    aligned = align_boards(boards, record.clocks, record.band)
    all_signals = (signals, *other_boards.values())
    bridged = any(board.reinterpolated is not None for board in all_signals)
    caveats = (
        (f"{signals.source}: what interpolation adds to sigma is not known for several boards",)
        if bridged
        else ()
    )
    joint = replace(
        signals,
        step=aligned.step,
        pieces=aligned.pieces,
        starts=aligned.starts,
        names=tuple(names),
        derivatives=np.concatenate([board.derivatives for board in all_signals]),
        names_in_file=frozenset(names_in_file),
        messages=(
            *(message for board in all_signals for message in board.messages),
            *aligned.messages,
            *caveats,
        ),
        gap=max(board.gap for board in all_signals),
        reinterpolated=None,
    )
    return joint, aligned.delays, columns
