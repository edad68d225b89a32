"""From the files of a campaign to modes with standard deviations."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from pkmodes.core.base.errors import MeasurementError, nearest_name, shown
from pkmodes.core.base.numbers import plain
from pkmodes.core.support.progress import say
from pkmodes.core.support.threads import one_blas_thread
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.measured.quantities import DAMPING, SHAPE_SIGMA
from pkmodes.modaltest.campaign.campaign import Campaign
from pkmodes.modaltest.campaign.copies import refuse_copied_visits
from pkmodes.modaltest.campaign.edits import edited
from pkmodes.modaltest.campaign.kinds import KINDS
from pkmodes.modaltest.campaign.levels import level_messages, with_half
from pkmodes.modaltest.campaign.measuring import MeasuredRecord, measured
from pkmodes.modaltest.campaign.missing import refuse_missing
from pkmodes.modaltest.campaign.mode_estimates import ModeEstimate, in_metres
from pkmodes.modaltest.campaign.results import Identification, IdentifiedMode, Parts, RecordResult
from pkmodes.modaltest.campaign.revisits import revisited
from pkmodes.modaltest.campaign.sensors import Transducer
from pkmodes.modaltest.campaign.shapes import (
    UNCERTAIN,
    UNDETERMINED,
    Combined,
    combined,
    left_blank,
    turned_shape,
)
from pkmodes.modaltest.identification.asked import NOTHING
from pkmodes.modaltest.identification.estimates import collinearity
from pkmodes.modaltest.identification.spectra import LEAST as LEAST_LINE

#: Relative standard deviation of a damping ratio below which it is only rounding: the same number written several
#: times, or functions without noise.
LEAST = 1e-4
#: Modal phase collinearity below which a shape is reported as complex.
COMPLEX = 0.8
#: Value of `IdentifiedMode.edited` for a mode that the user added.
ADDED = "added"


@one_blas_thread()
def identify(campaign: Campaign, *, keep_going: bool = False, inspect: bool = False) -> Identification:
    """Identify the modes of a campaign.

    - keep_going: whether faulty files are left out instead of refused
    - inspect: whether the parts of the fits that a report draws are kept

    Raises MeasurementError if a file is faulty, an edit means no mode, or no mode is found at all.
    """
    if campaign.repeatability is None:
        refuse_copied_visits(campaign.records, campaign.source)
    outcomes: list[MeasuredRecord] = []
    for record in campaign.records:
        say(f"record {record.number} of {len(campaign.records)}: {record.pose}")
        kind = KINDS.get(record.kind)
        where = f"{campaign.source}: record.{record.number}.kind"
        if kind is None:
            raise MeasurementError(
                f"unknown kind {shown(record.kind)}", where, nearest_name(record.kind, KINDS)
            )
        outcomes.append(measured(record, kind, campaign, keep_going, inspect))
    left_out = [file for outcome in outcomes for file in outcome.left_out]
    if not left_out:  # a file left out may have what the other files lack
        refuse_missing(
            [(outcome.record, *file) for outcome in outcomes for files in outcome.places for file in files],
            campaign,
        )
    repeatability, messages = campaign.repeatability, list[str]()
    if repeatability is None:
        repeatability, message = revisited(
            [(outcome.record, outcome.modes) for outcome in outcomes], campaign.source
        )
        messages.append(message)
    if left_out and not any(outcome.modes or outcome.added for outcome in outcomes):
        problem = f"expected modes, found none: {len(left_out)} files were left out, first {left_out[0].file}"
        raise MeasurementError(f"{problem}: {left_out[0].reason}", campaign.source, "correct the files")
    results = tuple(_result(outcome, campaign, repeatability) for outcome in outcomes)
    return Identification(results, repeatability, _measurements_of(results, campaign), tuple(messages))


def _result(measured: MeasuredRecord, campaign: Campaign, repeatability: float) -> RecordResult:
    """Return the rows of a record: its modes after the user's edits, as far as a measurement file may hold them."""
    record, log, pose = measured.record, measured.log, measured.record.pose
    places = {} if KINDS[record.kind].by_channel else campaign.places_at(record)
    modes = [_row(mode, places, repeatability) for mode in measured.modes]
    added = [_row(mode, places, repeatability, ADDED) for mode in measured.added]
    edits = campaign.asked(record) if measured.repeats else NOTHING
    edited_modes, struck = edited(modes, added, edits, pose, campaign.source)
    if KINDS[record.kind].signals and any(mode.shape for mode in edited_modes):
        log += [
            f"{pose}: the mode at {mode.frequency:.4g} Hz has no shape: no component stands out from the noise"
            for mode in edited_modes
            if not (mode.shape or mode.blank or mode.uncertain)
        ]
    kept = [readable for mode in edited_modes if (readable := _readable(mode, pose, log)) is not None]
    log += left_blank(pose, UNDETERMINED, [(mode.frequency, mode.blank) for mode in kept])
    log += left_blank(pose, UNCERTAIN, [(mode.frequency, mode.uncertain) for mode in kept])
    reported = {mode.frequency for mode in kept}
    for estimate in (*measured.modes, *measured.added):
        if estimate.frequency in reported:
            log += level_messages(pose, estimate)
    log += [
        f"{pose}: the shape of the mode at {mode.frequency:.4g} Hz is complex: its modal phase collinearity is "
        f"{mode.complexity:.2f}, and only its real part is used"
        for mode in kept
        if mode.complexity < COMPLEX
    ]
    if any(mode.sigma == 0.0 for mode in kept):
        problem = f"a mode of {pose} has no standard deviation"
        remedy = "measure repeats, state sigma in the table, or a repeatability above 0"
        raise MeasurementError(problem, f"{campaign.source}: record.{record.number}", remedy)
    if any(mode.parts.scatter == mode.parts.fit == 0.0 for mode in kept):
        log.append(f"{pose}: sigma is the repeatability alone where neither repeats nor the file state more")
    return RecordResult(
        record,
        tuple(kept),
        tuple(struck),
        tuple(measured.left_out),
        tuple(log),
        tuple(measured.inspections),
        tuple(measured.repeats),
    )


def _row(
    mode: ModeEstimate, places: Mapping[str, Transducer], repeatability: float, edit: str | None = None
) -> IdentifiedMode:
    """Return the row of a mode: its shape by channel, and its errors of all kinds combined."""
    of_shape = np.array([mode.shape_scatter, mode.sigma_shape])
    sigma = float(np.sqrt(np.nansum(of_shape**2))) if np.nan_to_num(of_shape).any() else np.nan
    by_channel = combined(mode.shape, places, sigma) if places else Combined(dict(mode.shape))
    shape, turned = by_channel.values, turned_shape(by_channel.values)
    parts = Parts(
        with_half(float(np.nan_to_num(mode.scatter)) * mode.frequency, mode.between),
        # Where a mode lies between two lines is the same in every repeat: averaging does not reduce this error.
        max(with_half(mode.sigma_frequency, mode.shift), LEAST_LINE * mode.resolution),
        repeatability * mode.frequency,
    )
    damping = float(np.hypot(np.nan_to_num(mode.damping_scatter) * mode.damping, mode.sigma_damping))
    return IdentifiedMode(
        frequency=mode.frequency,
        parts=parts,
        damping=mode.damping,
        sigma_damping=damping if damping > LEAST * mode.damping else np.nan,
        shape={name: value.real for name, value in turned.items()},
        sigma_shape=sigma * by_channel.growth if len(shape) > 1 else np.nan,
        complexity=collinearity(np.array(list(in_metres(shape, mode.lengths).values()))) if shape else np.nan,
        found_in=mode.found_in,
        files=len(mode.files),
        edited=edit,
        complex_shape=turned,
        blank=by_channel.blank,
        uncertain=by_channel.uncertain,
        lengths=mode.lengths,
    )


def _readable(mode: IdentifiedMode, pose: str, log: list[str]) -> IdentifiedMode | None:
    """Return the part of a mode that a measurement file may hold, None if there is none; report what is left out."""
    where = f"{pose}: the mode at {mode.frequency:.4g} Hz"
    if mode.sigma >= mode.frequency:
        log.append(
            f"{where} is left out: the standard deviation of its frequency is {plain(mode.sigma, 3)} Hz"
        )
        return None
    if not SHAPE_SIGMA.range.holds(np.array(mode.sigma_shape)):
        log.append(
            f"{where} has no shape: its standard deviation is {plain(mode.sigma_shape, 3)} of the largest component"
        )
        mode = replace(mode, shape={}, sigma_shape=np.nan, complexity=np.nan, complex_shape={})
    if not DAMPING.sigma.range.holds(np.array(mode.sigma_damping)):
        log.append(f"{where} has no damping ratio: its standard deviation is {plain(mode.sigma_damping, 3)}")
        mode = replace(mode, damping=np.nan, sigma_damping=np.nan)
    return mode


def _measurements_of(results: Sequence[RecordResult], campaign: Campaign) -> Measurements:
    """Return the modes of all records as measurements.

    The band is stated if it is the same for all records.

    Raises MeasurementError if there is no mode, or a number breaks a rule of measurement files.
    """
    rows = [
        (result.record, number, mode) for result in results for number, mode in enumerate(result.modes, 1)
    ]
    if not rows:
        raise MeasurementError(
            "expected modes, found none in any record", campaign.source, "check files and band"
        )
    channels = [name for name in campaign.channels if any(name in mode.shape for _, _, mode in rows)]
    settings = list(dict.fromkeys(path for record, _, _ in rows for path in record.settings))
    components = (
        {}
        if campaign.model is None
        else {component.name: component.unit for component in campaign.model.mechanism.pose}
    )
    bands = {record.band for record in campaign.records}
    points = np.array([[record.point[name] for name in components] for record, _, _ in rows])
    spreads = np.array([[record.point_sigma[name] for name in components] for record, _, _ in rows])
    shapes = {name: [mode.shape.get(name, np.nan) for _, _, mode in rows] for name in channels}
    return Measurements.from_rows(
        [record.pose for record, _, _ in rows],
        [mode.frequency for _, _, mode in rows],
        [mode.sigma for _, _, mode in rows],
        points=points.reshape(len(rows), len(components)),
        point_sigma=spreads.reshape(len(rows), len(components)),
        damping=[mode.damping for _, _, mode in rows],
        damping_sigma=[mode.sigma_damping for _, _, mode in rows],
        mode=[number for _, number, _ in rows],
        shapes=shapes,
        shape_sigma=[mode.sigma_shape if mode.shape else np.nan for _, _, mode in rows],
        band=bands.pop() if len(bands) == 1 else None,
        source=campaign.source,
        components=components,
        drives=[record.drives for record, _, _ in rows],
        settings={path: [record.settings.get(path, np.nan) for record, _, _ in rows] for path in settings},
    )
