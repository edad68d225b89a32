"""From the files of a campaign to modes with standard deviations."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from pkmodes.base.errors import MeasurementError, nearest, shown
from pkmodes.campaign.averaging import Mean, averaged
from pkmodes.campaign.campaign import Campaign, Edit, Record
from pkmodes.campaign.found import Found
from pkmodes.campaign.grouping import grouped
from pkmodes.campaign.joining import joined
from pkmodes.campaign.kinds import KINDS, Kind
from pkmodes.campaign.levels import level_messages, with_half
from pkmodes.campaign.results import Identification, IdentifiedMode, LeftOut, Parts, RecordResult
from pkmodes.campaign.revisits import revisited
from pkmodes.campaign.rows import measurements_of
from pkmodes.campaign.sensors import Place
from pkmodes.campaign.shapes import by_channel, real_shape
from pkmodes.identification.estimates import collinearity

#: A mode must be in this share of the repeats.
OFTEN = 0.5
#: A frequency of the user means the mode within this of it, relative.
NEAR = 0.01
#: Relative standard deviation of a damping ratio below which it is rounding: of the same number written several
#: times, or of functions without noise.
LEAST = 1e-4
#: Modal phase collinearity below which a shape is said to be complex.
COMPLEX = 0.8


def identify(campaign: Campaign, *, keep_going: bool = False) -> Identification:
    """Identify the modes of a campaign.

    Parameters
    ----------
    keep_going : bool
        Whether faulty files are left out instead of refused.

    Raises
    ------
    MeasurementError
        If a file is faulty, an edit means no mode, or no mode is found at all.
    """
    measured: list[_Measured] = []
    for record in campaign.records:
        kind = KINDS.get(record.kind)
        where = f"{campaign.source}: record.{record.number}.kind"
        if kind is None:
            raise MeasurementError(f"unknown kind {shown(record.kind)}", where, nearest(record.kind, KINDS))
        measured.append(_measured(record, kind, campaign, keep_going))
    repeatability, notes = campaign.repeatability, list[str]()
    if repeatability is None:
        repeatability, notes = revisited([(one.record, one.means) for one in measured], campaign.source)
    _check_some_left(measured, campaign.source)
    results = tuple(
        _result(one, campaign, repeatability) for one in measured if one.means or not one.left_out
    )
    return Identification(results, repeatability, measurements_of(results, campaign), tuple(notes))


def _check_some_left(measured: Sequence[_Measured], source: str) -> None:
    """Refuse a campaign whose files are all faulty, with the reason of the first."""
    left_out = [one for each in measured for one in each.left_out]
    if left_out and not any(each.means for each in measured):
        what = f"expected modes, found none: {len(left_out)} files were left out, first {left_out[0].file}"
        raise MeasurementError(f"{what}: {left_out[0].reason}", source, "correct the files")


@dataclass(frozen=True, eq=False)
class _Measured:
    """The modes of a record over its repeats and setups, before they are edited."""

    record: Record
    means: Sequence[Mean]
    left_out: Sequence[LeftOut]
    messages: Sequence[str]


def _measured(record: Record, kind: Kind, campaign: Campaign, keep_going: bool) -> _Measured:
    setups: dict[str, list[Mean]] = {}
    left_out: list[LeftOut] = []
    messages: list[str] = []
    for setup, paths in record.setups.items():
        files: list[Sequence[Found]] = []
        seen: set[str] = set()
        for path in paths:
            try:
                found = kind.find(path, record, setup, campaign)
            except MeasurementError as error:
                if not keep_going:
                    raise
                left_out.append(LeftOut(str(path), f"{error.what} ({error.where})"))
                continue
            messages += [*found.messages, *_beside_tones(found.modes, path, campaign.tones)]
            files.append(
                [
                    _named(mode, setup, kind, campaign)
                    for mode in _in_band(found.modes, record, path, messages)
                ]
            )
            seen |= found.seen
        if files:
            unseen = sorted(campaign.named_in(setup) - seen)
            if unseen:
                names = f"sensors or forces that are in none of the files: {', '.join(unseen)}"
                messages.append(f"{record.pose}: {names}")
            often = max(1.0, OFTEN * len(files))
            setups[setup] = averaged([group for group in grouped(files) if len(group) >= often])
            if len(files) == 1:
                of = f" of the setup {setup}" if setup else ""
                messages.append(f"{record.pose}: a single file{of}: the scatter of repeats is unknown")
    means, notes = joined(setups) if setups else ([], [])
    said = [*messages, *(f"{record.pose}: {note}" for note in notes)]
    return _Measured(record, means, left_out, said)


def _in_band(modes: Sequence[Found], record: Record, path: Path, messages: list[str]) -> list[Found]:
    low, high = record.band
    inside = [mode for mode in modes if low <= mode.frequency <= high]
    if len(inside) < len(modes):
        outside = ", ".join(f"{mode.frequency:.4g}" for mode in modes if mode not in inside)
        messages.append(f"{path}: outside the band, left out: {outside} Hz")
    return inside


def _beside_tones(modes: Sequence[Found], path: Path, tones: Sequence[float]) -> list[str]:
    """Name the modes that lie beside a stated tone or one of its multiples."""
    found = []
    for mode in modes:
        for tone in tones:
            multiple = max(1, round(mode.frequency / tone))
            if abs(mode.frequency / (multiple * tone) - 1.0) <= NEAR:
                found.append(
                    f"{path}: the mode at {mode.frequency:.4g} Hz lies beside the tone at {multiple * tone:.4g} Hz"
                )
    return found


def _named(mode: Found, setup: str, kind: Kind, campaign: Campaign) -> Found:
    """Return a mode whose sensors have names of their own where they hold in one setup only."""
    if kind.by_channel:
        return mode
    known = {**campaign.forces_in(setup), **campaign.sensors_in(setup)}
    names = {name: place.key for name, place in known.items()}
    return Found(**{**vars(mode), "shape": {names[name]: value for name, value in mode.shape.items()}})


def _result(measured: _Measured, campaign: Campaign, repeatability: float) -> RecordResult:
    record, said = measured.record, list(measured.messages)
    places = {} if KINDS[record.kind].by_channel else campaign.places
    modes = [_mode(mean, places, repeatability) for mean in measured.means]
    kept, struck = _edited(
        modes, [edit for edit in campaign.edits if edit.pose == record.pose], campaign.source
    )
    reported = {mode.frequency for mode in kept}
    for mean in measured.means:
        if mean.mode.frequency in reported:
            said += level_messages(record.pose, mean.mode.frequency, mean.mode.shift, mean.between)
    for mode in kept:
        if mode.complexity < COMPLEX:
            said.append(
                f"{record.pose}: the shape of the mode at {mode.frequency:.4g} Hz is complex: its modal phase "
                f"collinearity is {mode.complexity:.2f}, and only its real part is used"
            )
    if any(mode.sigma == 0.0 for mode in kept):
        what = f"a mode of {record.pose} has no standard deviation"
        remedy = "measure repeats, state sigma in the table, or a repeatability above 0"
        raise MeasurementError(what, f"{campaign.source}: record.{record.number}", remedy)
    if any(mode.parts.scatter == mode.parts.fit == 0.0 for mode in kept):
        said.append(
            f"{record.pose}: sigma is the repeatability alone where neither repeats nor the file state more"
        )
    return RecordResult(record, tuple(kept), tuple(struck), tuple(measured.left_out), tuple(said))


def _mode(mean: Mean, places: Mapping[str, Place], repeatability: float) -> IdentifiedMode:
    mode = mean.mode
    shape = by_channel(mode.shape, places) if places else dict(mode.shape)
    parts = Parts(
        with_half(float(np.nan_to_num(mean.scatter)) * mode.frequency, mean.between),
        with_half(mode.sigma_frequency, mode.shift),
        repeatability * mode.frequency,
    )
    damping = float(np.hypot(np.nan_to_num(mean.damping_scatter) * mode.damping, mode.sigma_damping))
    of_shape = np.array([mean.shape_scatter, mode.sigma_shape])
    return IdentifiedMode(
        frequency=mode.frequency,
        parts=parts,
        damping=mode.damping,
        sigma_damping=damping if damping > LEAST * mode.damping else np.nan,
        shape=real_shape(shape),
        sigma_shape=float(np.sqrt(np.nansum(of_shape**2)))
        if len(shape) > 1 and np.isfinite(of_shape).any()
        else np.nan,
        complexity=collinearity(np.array(list(shape.values()))) if shape else np.nan,
        found_in=mode.found_in,
        files=len(mean.files),
    )


def _edited(
    modes: Sequence[IdentifiedMode], edits: Sequence[Edit], source: str
) -> tuple[list[IdentifiedMode], list[float]]:
    """Return the modes that the user leaves, and the frequencies of those struck out."""
    kept, struck = list(modes), []
    for edit in edits:
        for wanted in edit.strike:
            near = [mode for mode in kept if abs(mode.frequency / wanted - 1.0) <= NEAR]
            if not near:
                found = ", ".join(f"{mode.frequency:.4g}" for mode in kept) or "none"
                what = f"no mode of {edit.pose} lies within 1 % of {wanted:g} Hz, found {found} Hz"
                raise MeasurementError(what, f"{source}: edit", "correct the frequency, or leave it out")
            mode = min(near, key=lambda each: abs(each.frequency - wanted))
            kept.remove(mode)
            struck.append(mode.frequency)
        if edit.add:
            what = (
                f"no mode can be added at {edit.add[0]:g} Hz: the record of {edit.pose} has no signals to fit"
            )
            raise MeasurementError(what, f"{source}: edit", "add it to the file of modes")
    return kept, struck
