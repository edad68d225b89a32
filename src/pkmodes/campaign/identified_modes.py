"""Records of modes that another program has identified: dataset 55 of universal files, and tables."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from pkmodes.campaign.campaign import Campaign, Record
from pkmodes.campaign.file_modes import FileModes
from pkmodes.campaign.found import Found, check_shape
from pkmodes.campaign.grouping import APART
from pkmodes.campaign.mode_tables import read_mode_table
from pkmodes.campaign.shapes import by_channel
from pkmodes.core.base.errors import MeasurementError
from pkmodes.signals.functions import ModeShape
from pkmodes.signals.reading import HEAD, read_signals
from pkmodes.signals.universal_file import UNIVERSAL_FILE

#: Modes of one file within the width in which those of two files may be the same: far above what any test tells
#: apart, and few enough that all pairs of them are compared in seconds.
MOST_ALIKE = 200


def identified_modes(path: Path, record: Record, setup: str, campaign: Campaign) -> FileModes:
    """Return the modes in a file, their shapes by channel.

    Raises
    ------
    MeasurementError
        If the file is faulty, or has no modes.
    """
    if not _universal(path):
        listed = tuple(read_mode_table(path, record.columns, campaign.channels, record.pose))
        _check_apart(listed, str(path))
        return FileModes(listed, (), frozenset(campaign.named_in(setup)))
    read = read_signals(path)
    if not read.modes:
        what = f"expected identified modes (dataset 55), found {len(read.functions)} functions and no mode"
        remedy = 'choose another kind of record, such as kind = "frf"'
        raise MeasurementError(what, read.source, remedy)
    for mode in read.modes:
        _check(mode, read.source)
    places = campaign.sensors_in(setup)
    found = tuple(
        Found(
            mode.frequency,
            np.nan if mode.damping is None else mode.damping,
            by_channel({name: value for name, value in mode.shape.items() if name in places}, places),
        )
        for mode in read.modes
    )
    _check_apart(found, read.source)
    seen = {name for mode in read.modes for name in mode.shape}
    messages = list(read.messages)
    if places and not seen & places.keys():
        messages.append(f"{read.source}: no sensor of the campaign is in the file: its shapes are left out")
    return FileModes(found, tuple(messages), frozenset(seen) | campaign.unsigned_forces_in(setup))


def _check_apart(modes: Sequence[Found], source: str) -> None:
    """Refuse a list in which modes are too many to be modes."""
    f = np.sort([mode.frequency for mode in modes])
    counts = np.searchsorted(f, f * (1.0 + APART), side="right") - np.arange(len(f))
    most = int(np.argmax(counts))
    if counts[most] > MOST_ALIKE:
        what = f"expected modes, found {counts[most]} within {100.0 * APART:g} % from {f[most]:.4g} Hz"
        remedy = "list each mode once, and each pose as a record of its own"
        raise MeasurementError(what, source, remedy)


def _check(mode: ModeShape, source: str) -> None:
    """Refuse a mode whose numbers no measurement file may have."""
    where = f"{source}: mode at {mode.frequency:g} Hz"
    if mode.damping is not None and not 0.0 <= mode.damping < 1.0:
        what = f"expected a damping ratio of at least 0 and below 1, found {mode.damping:g}"
        raise MeasurementError(what, where, "correct it, or export the modes again")
    check_shape(mode.shape, where)


def _universal(path: Path) -> bool:
    """Return whether a file is a universal file."""
    try:
        with path.open("rb") as file:
            head = file.read(HEAD)
    except (OSError, ValueError):  # the reader says why
        head = b""
    return UNIVERSAL_FILE.recognises(head) or path.suffix.lower() in UNIVERSAL_FILE.suffixes
