"""From the files of a campaign to modes with standard deviations."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from pkmodes.core.base.errors import MeasurementError, nearest_name, shown
from pkmodes.core.base.numbers import plain
from pkmodes.core.support.progress import report_progress
from pkmodes.core.support.threads import one_blas_thread
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.measured.quantities import DAMPING, SHAPE_SIGMA
from pkmodes.modaltest.campaign.campaign import Campaign
from pkmodes.modaltest.campaign.copies import refuse_copied_visits
from pkmodes.modaltest.campaign.edits import apply_edits
from pkmodes.modaltest.campaign.kinds import KINDS
from pkmodes.modaltest.campaign.levels import add_half_spread, level_messages
from pkmodes.modaltest.campaign.measuring import MeasuredRecord, measure_record
from pkmodes.modaltest.campaign.missing import refuse_missing
from pkmodes.modaltest.campaign.mode_estimates import ModeEstimate, in_metres
from pkmodes.modaltest.campaign.results import Identification, IdentifiedMode, Parts, RecordResult
from pkmodes.modaltest.campaign.revisits import estimate_repeatability
from pkmodes.modaltest.campaign.sensors import Transducer
from pkmodes.modaltest.campaign.shapes import (
    UNCERTAIN,
    UNDETERMINED,
    ChannelShape,
    blank_messages,
    combine_sensors,
    rotate_shape,
)
from pkmodes.modaltest.identification.estimates import collinearity
from pkmodes.modaltest.identification.requested_modes import NO_EDITS
from pkmodes.modaltest.identification.spectra import MIN_SIGMA as LEAST_LINE

#: Relative standard deviation of a damping ratio below which it is only rounding: the same number written several
#: times, or functions without noise.
MIN_DAMPING_SIGMA = 1e-4
#: Modal phase collinearity below which a shape is reported as complex.
MIN_COLLINEARITY = 0.8
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
        report_progress(f"record {record.number} of {len(campaign.records)}: {record.pose}")
        kind = KINDS.get(record.kind)
        where = f"{campaign.source}: record.{record.number}.kind"
        if kind is None:
            raise MeasurementError(
                f"unknown kind {shown(record.kind)}", where, nearest_name(record.kind, KINDS)
            )
        outcomes.append(measure_record(record, kind, campaign, keep_going, inspect))
    faulty_files = [file for outcome in outcomes for file in outcome.left_out]
    if not faulty_files:  # a file left out may have what the other files lack
        refuse_missing(
            [(outcome.record, *file) for outcome in outcomes for files in outcome.presence for file in files],
            campaign,
        )
    repeatability, messages = campaign.repeatability, list[str]()
    if repeatability is None:
        repeatability, message = estimate_repeatability(
            [(outcome.record, outcome.modes) for outcome in outcomes], campaign.source
        )
        messages.append(message)
    if faulty_files and not any(outcome.modes or outcome.added for outcome in outcomes):
        problem = f"expected modes, found none: {len(faulty_files)} files were left out, first {faulty_files[0].file}"
        raise MeasurementError(f"{problem}: {faulty_files[0].reason}", campaign.source, "correct the files")
    results = tuple(_result(outcome, campaign, repeatability) for outcome in outcomes)
    return Identification(results, repeatability, _to_measurements(results, campaign), tuple(messages))


def _result(outcome: MeasuredRecord, campaign: Campaign, repeatability: float) -> RecordResult:
    """Return the rows of a record: its modes after the user's edits, as far as a measurement file may hold them."""
    record, log, pose = outcome.record, outcome.log, outcome.record.pose
    transducers = {} if KINDS[record.kind].by_channel else campaign.transducers_at(record)
    modes = [_row(mode, transducers, repeatability) for mode in outcome.modes]
    added = [_row(mode, transducers, repeatability, ADDED) for mode in outcome.added]
    edits = campaign.edits_of(record) if outcome.repeats else NO_EDITS
    edited_modes, struck = apply_edits(modes, added, edits, pose, campaign.source)
    if KINDS[record.kind].signals and any(mode.shape for mode in edited_modes):
        log += [
            f"{pose}: the mode at {mode.frequency:.4g} Hz has no shape: no component stands out from the noise"
            for mode in edited_modes
            if not (mode.shape or mode.blank or mode.uncertain)
        ]
    reported_modes = [
        readable for mode in edited_modes if (readable := _limit_to_file(mode, pose, log)) is not None
    ]
    log += blank_messages(pose, UNDETERMINED, [(mode.frequency, mode.blank) for mode in reported_modes])
    log += blank_messages(pose, UNCERTAIN, [(mode.frequency, mode.uncertain) for mode in reported_modes])
    reported = {mode.frequency for mode in reported_modes}
    for estimate in (*outcome.modes, *outcome.added):
        if estimate.frequency in reported:
            log += level_messages(pose, estimate)
    log += [
        f"{pose}: the shape of the mode at {mode.frequency:.4g} Hz is complex: its modal phase collinearity is "
        f"{mode.complexity:.2f}, and only its real part is used"
        for mode in reported_modes
        if mode.complexity < MIN_COLLINEARITY
    ]
    if any(mode.sigma == 0.0 for mode in reported_modes):
        problem = f"a mode of {pose} has no standard deviation"
        remedy = "measure repeats, state sigma in the table, or a repeatability above 0"
        raise MeasurementError(problem, f"{campaign.source}: record.{record.number}", remedy)
    if any(mode.parts.scatter == mode.parts.fit == 0.0 for mode in reported_modes):
        log.append(f"{pose}: sigma is the repeatability alone where neither repeats nor the file state more")
    return RecordResult(
        record,
        tuple(reported_modes),
        tuple(struck),
        tuple(outcome.left_out),
        tuple(log),
        tuple(outcome.inspections),
        tuple(outcome.repeats),
    )


def _row(
    mode: ModeEstimate, transducers: Mapping[str, Transducer], repeatability: float, edit: str | None = None
) -> IdentifiedMode:
    """Return the row of a mode: its shape by channel, and its errors of all kinds combined."""
    shape_sigmas = np.array([mode.shape_scatter, mode.sigma_shape])
    sigma = float(np.sqrt(np.nansum(shape_sigmas**2))) if np.nan_to_num(shape_sigmas).any() else np.nan
    by_channel = (
        combine_sensors(mode.shape, transducers, sigma) if transducers else ChannelShape(dict(mode.shape))
    )
    shape, rotated = by_channel.values, rotate_shape(by_channel.values)
    parts = Parts(
        add_half_spread(float(np.nan_to_num(mode.scatter)) * mode.frequency, mode.shift_between_files),
        # Where a mode lies between two lines is the same in every repeat: averaging does not reduce this error.
        max(add_half_spread(mode.sigma_frequency, mode.shift), LEAST_LINE * mode.resolution),
        repeatability * mode.frequency,
    )
    damping = float(np.hypot(np.nan_to_num(mode.damping_scatter) * mode.damping, mode.sigma_damping))
    return IdentifiedMode(
        frequency=mode.frequency,
        parts=parts,
        damping=mode.damping,
        sigma_damping=damping if damping > MIN_DAMPING_SIGMA * mode.damping else np.nan,
        shape={name: value.real for name, value in rotated.items()},
        sigma_shape=sigma * by_channel.growth if len(shape) > 1 else np.nan,
        complexity=collinearity(np.array(list(in_metres(shape, mode.lengths).values()))) if shape else np.nan,
        found_in=mode.found_in,
        files=len(mode.files),
        edited=edit,
        complex_shape=rotated,
        blank=by_channel.blank,
        uncertain=by_channel.uncertain,
        lengths=mode.lengths,
    )


def _limit_to_file(mode: IdentifiedMode, pose: str, log: list[str]) -> IdentifiedMode | None:
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


def _to_measurements(results: Sequence[RecordResult], campaign: Campaign) -> Measurements:
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
    point_sigmas = np.array([[record.point_sigma[name] for name in components] for record, _, _ in rows])
    shapes = {name: [mode.shape.get(name, np.nan) for _, _, mode in rows] for name in channels}
    return Measurements.from_rows(
        [record.pose for record, _, _ in rows],
        [mode.frequency for _, _, mode in rows],
        [mode.sigma for _, _, mode in rows],
        points=points.reshape(len(rows), len(components)),
        point_sigma=point_sigmas.reshape(len(rows), len(components)),
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
