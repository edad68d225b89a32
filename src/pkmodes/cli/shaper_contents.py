"""The JSON of ``pkmodes shaper``, made from a choice of shapers: for a robot, and for measured modes."""

from __future__ import annotations

from typing import TYPE_CHECKING, cast

import numpy as np

from pkmodes.cli.shaper_documents import (
    AxisDocument,
    CandidateDocument,
    LeftAtPoseDocument,
    LeftDocument,
    MeasuredCandidateDocument,
    MeasuredModeDocument,
    MeasuredShaperDocument,
    ScheduleDocument,
    ShaperDocument,
    SpectrumDocument,
    StepDocument,
    UnshapedDocument,
)
from pkmodes.core.base.drives import Drives
from pkmodes.machine.shaping.measured_modes import of_measured
from pkmodes.machine.shaping.version_lines import lines_by_version, schedule_lines_by_version

if TYPE_CHECKING:
    from pkmodes.core.model import Model
    from pkmodes.machine.shaping.measured_spectrum import MeasuredSpectrum
    from pkmodes.machine.shaping.results import Amplitude, Candidate, Choice, Schedule


def shaper_document(model: Model, choice: Choice, spectrum: MeasuredSpectrum | None) -> ShaperDocument:
    """Return the result for a robot."""
    from pkmodes.machine.shaping.remarks import firmware_remarks
    from pkmodes.machine.shaping.version_lines import current_lines

    spectrum_part, spectrum_notes = SpectrumDocument.with_notes(spectrum, choice)
    return ShaperDocument(
        robot=model.robot.name,
        drives=cast("Drives", choice.ringing.drives),
        poses=len(choice.ringing.poses),
        modes=choice.ringing.frequencies.shape[1],
        unshaped=_unshaped(choice),
        shapers=_candidates(choice),
        recommended=choice.recommended,
        axes=[
            AxisDocument(
                axis=axis,
                modes=part.ringing.modes,
                unshaped=_unshaped(part),
                shapers=_candidates(part),
                recommended=part.recommended,
                schedule=None if part.schedule is None else _schedule(part, part.schedule),
            )
            for axis, part in choice.by_axis.items()
        ],
        spectrum=spectrum_part,
        firmware=current_lines(choice),
        firmware_versions=lines_by_version(choice),
        schedule=None if choice.schedule is None else _schedule(choice, choice.schedule),
        notes=[*choice.notes, *firmware_remarks(choice), *spectrum_notes],
    )


def _unshaped(choice: Choice) -> UnshapedDocument:
    return UnshapedDocument.of(choice.unshaped, settings=_settings(choice.unshaped))


def _candidates(choice: Choice) -> list[CandidateDocument]:
    no_design = dict.fromkeys(("frequencies_hz", "damping_ratios", "amplitudes", "delays_s"))
    return [
        CandidateDocument.of(
            candidate,
            **(no_design if candidate.follows_pose else _design(candidate)),
            duration_s=candidate.duration,
            left=_left(candidate.left),
            left_at_pose=_left_at_pose(candidate.left_at_pose),
        )
        for candidate in choice.candidates
    ]


def _schedule(choice: Choice, schedule: Schedule) -> ScheduleDocument:
    from pkmodes.machine.shaping.results import command_of

    steps = [
        StepDocument(
            settings=dict(step.setting.values),
            serves=None if step.serves is None else list(step.serves),
            heights_m=None if step.heights is None else list(step.heights),
            poses=len(step.choice.ringing.poses),
            kind=step.best.kind,
            **_design(step.best),
            duration_s=step.best.duration,
            rounding_s2=step.best.rounding,
            left=_left(step.best.left),
            left_at_ends=step.at_ends,
            left_by_fixed=step.fixed,
            firmware=command_of(step.best, schedule.axis),
        )
        for step in schedule.steps
    ]
    return ScheduleDocument(
        units=dict(schedule.steps[0].setting.units),
        left=_left(schedule.left),
        left_at_pose=_left_at_pose(schedule.left_at_pose),
        steps=steps,
        firmware=schedule.lines(),
        firmware_versions=schedule_lines_by_version(choice, schedule),
    )


def _settings(amplitude: Amplitude) -> dict[str, float]:
    return {} if amplitude.setting is None else dict(amplitude.setting.values)


def _left(amplitude: Amplitude) -> LeftDocument:
    return LeftDocument.of(amplitude, settings=_settings(amplitude))


def _left_at_pose(amplitude: Amplitude) -> LeftAtPoseDocument:
    return LeftAtPoseDocument.of(amplitude, settings=_settings(amplitude))


def _design(candidate: Candidate) -> dict[str, list[float]]:
    return {
        "frequencies_hz": list(candidate.frequencies),
        "damping_ratios": [candidate.damping_ratio] * len(candidate.frequencies),
        "amplitudes": candidate.shaper.amplitudes.tolist(),
        "delays_s": candidate.shaper.delays.tolist(),
    }


def measured_document(choice: Choice, spectrum: MeasuredSpectrum | None) -> MeasuredShaperDocument:
    """Return the result for measured modes."""
    from pkmodes.machine.shaping.choice import lines_of
    from pkmodes.machine.shaping.remarks import firmware_remarks

    measured_choice = of_measured(choice)
    data, best = measured_choice.data, choice.best
    spectrum_part, spectrum_notes = SpectrumDocument.with_notes(spectrum, choice)
    shapers = []
    for candidate in choice.candidates:
        shapers.append(
            MeasuredCandidateDocument(
                kind=candidate.kind,
                **_design(candidate),
                duration_s=candidate.duration,
                max_acceleration=candidate.max_acceleration,
                rounding_s2=candidate.rounding,
                left=measured_choice.shares(candidate),
            )
        )
    modes = []
    for row, share, largest_share in zip(measured_choice.rows, *measured_choice.left_of(best), strict=True):
        has_damping = np.isfinite(data.damping[row])
        modes.append(
            MeasuredModeDocument(
                pose=data.labels[data.pose[row]],
                line=int(data.lines[row]),
                frequency_hz=float(data.frequency[row]),
                sigma_hz=float(data.sigma[row]),
                damping_ratio=float(data.damping[row]) if has_damping else measured_choice.assumed,
                left=float(share),
                left_uncertain=float(largest_share),
            )
        )
    return MeasuredShaperDocument(
        measured=data.source,
        drives=cast("Drives", measured_choice.drives),
        poses=len(np.unique(data.pose[measured_choice.rows])),
        modes=len(measured_choice.rows),
        shapers=shapers,
        recommended=choice.recommended,
        measured_modes=modes,
        spectrum=spectrum_part,
        firmware=lines_of(best),
        firmware_versions=lines_by_version(choice),
        notes=[*choice.notes, *firmware_remarks(choice), *spectrum_notes],
    )
