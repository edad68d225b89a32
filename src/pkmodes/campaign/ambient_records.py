"""Records of responses alone: ambient vibration, decays or sweeps, of one board or of several beside each other."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

import numpy as np

from pkmodes.campaign.boards import Board, together, with_clocks
from pkmodes.campaign.campaign import Campaign, Record
from pkmodes.campaign.found import FileModes, Fit
from pkmodes.campaign.sensor_functions import in_file
from pkmodes.campaign.time_records import BRIDGED, TimeSignals, time_signals, with_bridges, with_levels
from pkmodes.core.base.errors import MeasurementError, shown
from pkmodes.identification.clocks import Delay
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
    given, delays, columns = _beside(path, record, setup, campaign)

    def found(signals: Sequence[TimeSignals]) -> tuple[Fit, tuple[str, ...]]:
        estimate, messages = identify_responses(
            given.step,
            signals[0].pieces,
            band=record.band,
            tones=campaign.tones,
            asked=campaign.asked(record),
        )
        return Fit(estimate, given.names), tuple(f"{given.source}: {message}" for message in messages)

    with in_file(given.source), _gaps_named(given):
        fit, messages = with_bridges(found, [given], given.source)
    shortest = FEWEST_PERIODS / record.band[0]
    short = [piece for piece in given.pieces if len(piece) * given.step < shortest]
    if short:
        messages = (
            *messages,
            f"{given.source}: {len(short)} pieces between gaps are shorter than {shortest:.3g} s and were left out",
        )
    unsigned: dict[str, list[str]] = {}

    def accelerations(mode: Mode) -> Mode:
        whole = replace(mode, shape=mode.shape * given.as_accelerations(mode.pole))
        known, lost = with_clocks(whole, columns, delays)
        for name in lost:
            unsigned.setdefault(name, []).append(f"{mode.frequency:.4g}")
        return known

    fit = replace(fit, estimate=fit.estimate.changed(accelerations))
    lost = [
        f"{given.source}: the modes at {', '.join(modes)} Hz have no components of {name}: its clock is not known"
        " well enough to tell their sign"
        for name, modes in unsigned.items()
    ]
    said = (*given.messages, *messages, *lost)
    return with_levels(fit, said, given)


def _beside(
    path: Path, record: Record, setup: str, campaign: Campaign
) -> tuple[TimeSignals, Mapping[str, Delay], Mapping[str, slice]]:
    """Return the signals of a file with those of other boards that were recorded together with it.

    Sensors of other boards go by the names that they have in the campaign.

    Returns
    -------
    signals : TimeSignals
    delays, columns : mapping
        What was added to the times of each other board, and the columns of its signals, by setup.
    """
    given = time_signals(path, record, setup, campaign, highest=record.band[1])
    others = {
        name: time_signals(file, record, name, campaign, highest=record.band[1])
        for name, file in record.beside(path).items()
    }
    if not others:
        return given, {}, {}
    names, columns, seen = list(given.names), {}, set(given.seen)
    taken = {campaign.sensors_in(setup)[name].key for name in names}
    for name, other in others.items():
        sensors = campaign.sensors_in(name)
        keys = [sensors[one].key for one in other.names]
        seen |= {sensors[one].key for one in other.seen}
        twice = next((key for key in keys if key in taken), None)
        if twice is not None:
            what = f"the sensor {shown(twice)} is in the files of both {setup} and {name}"
            raise MeasurementError(what, other.source, f'give each [[sensor]] its own: setup = "{name}"')
        columns[name] = slice(len(names), len(names) + len(keys))
        names += keys
        taken |= set(keys)
    boards = {
        name: Board(one.source, one.step, one.starts, one.pieces)
        for name, one in {setup: given, **others}.items()
    }
    found = together(boards, record.clocks, record.band)
    every = (given, *others.values())
    bridged = any(one.once_more is not None for one in every)
    more = (
        (f"{given.source}: what interpolating adds to sigma is not known of several boards",)
        if bridged
        else ()
    )
    joint = replace(
        given,
        step=found.step,
        pieces=found.pieces,
        starts=found.starts,
        names=tuple(names),
        derivatives=np.concatenate([one.derivatives for one in every]),
        seen=frozenset(seen),
        messages=(*(said for one in every for said in one.messages), *found.messages, *more),
        gap=max(one.gap for one in every),
        once_more=None,
    )
    return joint, found.delays, columns


@contextmanager
def _gaps_named(given: TimeSignals) -> Iterator[None]:
    """Say, where a record is too short because it is split, up to which frequency its gaps can be bridged."""
    try:
        yield
    except MeasurementError as error:
        if not given.gap > 0.0:
            raise
        what = f"{error.what}: {len(given.pieces) - 1} gaps of {1e3 * given.gap:.3g} ms split it"
        remedy = f"end the band at {BRIDGED / given.gap:.3g} Hz or lower, where they are bridged; or {error.remedy}"
        raise MeasurementError(what, error.where, remedy) from None
