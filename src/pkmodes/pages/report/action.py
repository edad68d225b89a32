"""What to do about a diagnosis, in the owner's words: what to inspect, its effect, how certain, what to measure.

Each sentence holds by itself, and none claims more than the verdict.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from pkmodes.core.base.drives import FREE
from pkmodes.core.base.numbers import format_factor, plain, round_to_sigma
from pkmodes.core.support.motors import motors_in_words
from pkmodes.core.support.ordering import joined
from pkmodes.loop.diagnosis.problem import Array
from pkmodes.loop.diagnosis.verdict import caveats
from pkmodes.loop.diagnosis.verdict.findings import saved_as
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.loop.diagnosis.verdict.terms import DECLARED
from pkmodes.loop.diagnosis.verdict.verdicts import ADEQUATE, VERDICTS
from pkmodes.pages.report.blocks import Cell, Facts
from pkmodes.pages.report.certainty import certainty, claimed_term_class, explanation_in_words
from pkmodes.pages.report.contrast import contrast_of_parts
from pkmodes.pages.report.formatting import (
    clean,
    frequency_cell,
    label_cell,
    number_cell,
    plural,
    pointer,
    sentence_cell,
    to_sentence,
    unit_text,
)
from pkmodes.pages.report.report_context import ReportContext

Entry = tuple[str, list[Cell]]
#: Where to look for a cause, and what to do there.
ADVICE_BY_CAUSE = {
    "axis_belt_stiffness": "the belts: whether all have the same type, width, tension and wear",
    "axis_leg_stiffness": "the legs: nuts, bearings and joints, and any play in them",
    "axis_reducer_stiffness": "the reducers: whether all are of the same type, and equally worn",
    "belt_end_compliance": "the ends of the belts: how their teeth sit on the pulleys and in the clamps",
    "belt_mass": "the belts: weigh a length of one",
    "belt_tension_stiffness": "the tension of the belts: measure it, for example by the tone of a plucked belt",
    "cable_stiffness": "the cables and hoses at the platform: take them off, and measure again",
    "clamp_compliance": "the clamps of the belts: whether a belt gives in them",
    "frame_compliance": "the frame: its screws and corners, and what it stands on",
    "gantry_racking": "the guides of the beam: whether it yields when its ends are pushed in opposite directions",
    "gearbox_compliance": "the gearboxes: hold a motor, load its pulley, and see how far the pulley turns",
    "gearbox_inertia": "the gearboxes: look up their moment of inertia",
    "link_compliance": "the linkages: whether their joints are tight, and their rods as stiff as they should be",
    "payload": "the platform: weigh what moves with it, such as a tool, cables and hoses",
    "servo_stiffness": "the motors: whether they were switched on during the measurement",
}
#: Where to look for other causes, by the prefix of their names.
ADVICE_BY_PREFIX = {
    "measurement:": "the measurement: whether its poses have the origin and the axes of the robot file",
    "parameter:": "the {words}: measure or look it up again",
}
#: Factor on the standard deviation of a size from which what makes it larger is worth measuring.
MIN_SIGMA_FACTOR = 2.0
#: Maximum number of places to inspect that are listed: one for each leg of a machine with six.
MAX_PLACES = 6


def recommended_action(result: Diagnosis, context: ReportContext) -> Facts:
    """Return what to inspect, its effect in hertz, how certain that is, and what to measure next."""
    effect_cells = _effect_on_frequencies(result)
    return Facts(
        [
            *_inspection_entries(result, context),
            ("effect", effect_cells) if effect_cells else ("difference", _remaining_difference(result)),
            ("how sure", certainty(result)),
            ("measure next", _next_measurement(result, context)),
        ]
    )


def _inspection_entries(result: Diagnosis, context: ReportContext) -> Iterator[Entry]:
    """Yield where to look for each cause, or for each remaining explanation."""
    causes = [effect.members for effect in result.effects]
    if term_class := claimed_term_class(result):
        causes = [term_class.finding.members]
    elif result.survivors:
        causes = [tuple(name for group in result.survivors for name in group)]
    for cause_index, names in enumerate(causes):
        places = [
            *dict.fromkeys(
                joined([_inspection_advice(cause, result, context) for cause in name.split(" + ")])
                for name in names
            )
        ]
        for place_index, place in enumerate(places[:MAX_PLACES]):
            yield "or" if place_index else "and" if cause_index else "inspect", [Cell(to_sentence(place))]
        if len(places) > MAX_PLACES:
            yield (
                "or",
                [Cell(f"{plural(len(places) - MAX_PLACES, 'further place')}: see the explanations below.")],
            )
    if not causes:
        headline_clause = f"; but {clean(result.headline)}" if result.headline else ""
        undetectable = caveats.undetectable_in_words(
            result.undetectable, any(limit.value for limit in result.limits.values())
        )
        undetectable_note = (
            f" {to_sentence(clean(undetectable))}" if undetectable and result.verdict == ADEQUATE.word else ""
        )
        advice = to_sentence(f"{VERDICTS[result.verdict].inspect}{headline_clause}") + undetectable_note
        yield "inspect", [sentence_cell(advice)]


def _inspection_advice(name: str, result: Diagnosis, context: ReportContext) -> str:
    """Return where to look for a cause; its sentence if no advice is listed."""
    listed_advice = ADVICE_BY_CAUSE.get(name, "")
    if context.robot is not None:
        listed_advice = context.robot.mechanism.in_own_words(listed_advice)
    _, colon, advice = listed_advice.partition(": ")
    if name in result.alone:
        joint_change = result.alone[name]
        return f"{joint_change.joint.words}, which is {joint_change.comparison}{colon}{advice}"
    contrasts = [contrast_of_parts(effect, context) for effect in result.effects if effect.name == name]
    if contrasts and contrasts[0] is not None:
        return f"{contrasts[0].part}, which is {contrasts[0].comparison}{colon}{advice}"
    if listed_advice:
        return listed_advice
    term_class = claimed_term_class(result)
    if term_class and term_class.forms.get(name, DECLARED) not in ("", DECLARED):
        return f"look for {clean(term_class.finding.member(name).words)}"
    for prefix, template in ADVICE_BY_PREFIX.items():
        if name.startswith(prefix):
            path = name.removeprefix(prefix)
            return template.format(words=context.meaning(path).partition(",")[0] or f"value of {clean(path)}")
    return explanation_in_words(name, result)


def _effect_on_frequencies(result: Diagnosis) -> list[Cell]:
    """Return the effect of the causes on the measured modes, and the largest with the refitted values; else empty.

    The effect is that of the causes at the values of the last model, whose modes with and without them are matched by
    rank, or by frequency where a cause adds modes, such as those of a moving frame.  The frequencies are those of the
    table of all measured modes: as declared, and with the causes.
    """
    stages = result.stages
    if stages is None or stages.with_causes is None or stages.without is None:
        return []
    with_causes, stage_key = stages.with_causes, "beyond" if stages.after is None else "after"
    spectra = zip(with_causes.elastic_frequencies, stages.without, strict=True)
    partners = [dict(_match_modes(after, without)) for after, without in spectra]
    pose_indices = {
        pose: pose_index for pose_index, pose in enumerate(dict.fromkeys(row.pose for row in result.rows))
    }
    changes = []
    for i, row in enumerate(result.rows):
        pose_index, mode_index = pose_indices[row.pose], int(with_causes.partner_mode[i]) - 1
        has_partner = getattr(row, stage_key) is not None and not row.outlier
        if has_partner and mode_index in partners[pose_index]:
            partner = partners[pose_index][mode_index]
            changes.append(
                (
                    with_causes.elastic_frequencies[pose_index, mode_index]
                    - stages.without[pose_index, partner],
                    i,
                )
            )
    if not changes:
        return []
    sizes = [change for change, _ in changes]
    largest_change = max(sizes, key=abs)
    # The example has a partner in the model as declared, too.
    examples = [(abs(change), i) for change, i in changes if result.rows[i].before is not None]
    if not examples:
        return []
    _, i = max(examples, key=lambda size_and_row: size_and_row[0])
    row, pose_index = result.rows[i], pose_indices[result.rows[i].pose]
    mode_count = int(with_causes.partner_mode.max(initial=1))
    new_frequencies = [
        frequency
        for mode_index, frequency in enumerate(with_causes.elastic_frequencies[pose_index, :mode_count])
        if mode_index not in partners[pose_index]
    ]
    verb = "lower" if max(sizes) <= 0.0 else "raise" if min(sizes) >= 0.0 else "change"
    subject = f"they {verb}" if len(result.effects) > 1 else f"it {verb}s"
    refitted = any(value.after != value.before for value in result.refitted)
    causes = "these" if len(result.effects) > 1 else "this"
    example_start = f". With {causes} and the other refitted values together, mode" if refitted else ": mode"
    new_modes_start = "another is" if len(new_frequencies) == 1 else "others are"
    unpaired_count = len(result.rows) - len(changes)
    measured_modes = (
        f"{len(changes)} of the {plural(len(result.rows), 'measured mode')}"
        if unpaired_count
        else f"the {plural(len(changes), 'measured mode')}"
    )
    new_modes = joined([f"{frequency:.4g}" for frequency in new_frequencies])
    new_modes_clause = f"; {new_modes_start} new there, at {new_modes} Hz" if new_frequencies else ""
    return [
        Cell(
            f"In the model {subject} the frequencies of {measured_modes} by up to "
            f"{plain(abs(largest_change), 2)} Hz{example_start} {with_causes.partner_mode[i]} at"
        ),
        label_cell(row.pose),
        Cell("goes from"),
        frequency_cell(row.before, pointer("rows", i, "before_hz")),
        Cell(f"Hz {result.errors['before'][0].removeprefix('before: ')} to"),
        frequency_cell(getattr(row, stage_key), pointer("rows", i, f"{stage_key}_hz")),
        Cell(f"Hz{new_modes_clause}."),
    ]


def _match_modes(after: Array, without: Array) -> list[tuple[int, int]]:
    """Return the matching frequencies of two models, as pairs of indices."""
    after_frequencies, without_frequencies = (
        spectrum[np.isfinite(spectrum)] for spectrum in (after, without)
    )
    if len(after_frequencies) == len(without_frequencies):
        return [(row, row) for row in range(len(after_frequencies))]
    from scipy.optimize import linear_sum_assignment

    cost = np.log(after_frequencies[:, None] / without_frequencies) ** 2
    return [(int(row), int(column)) for row, column in zip(*linear_sum_assignment(cost), strict=True)]


def _remaining_difference(result: Diagnosis) -> list[Cell]:
    """Return how far the last model without causes is from the measured frequencies."""
    rows = [row for row in result.rows if not row.outlier]
    predicted = [row.before if result.refit is None else row.refit for row in rows]
    differences = [(f - row.measured, row) for f, row in zip(predicted, rows, strict=True) if f is not None]
    if not differences:
        return [Cell("No measured mode has a partner in the model.")]
    rms = float(np.sqrt(np.mean([difference**2 for difference, _ in differences])))
    largest, row = max(differences, key=lambda difference_and_row: abs(difference_and_row[0]))
    title = "as declared" if result.refit is None else "with its uncertain values refitted"
    unmatched_count = len(rows) - len(differences)
    verb = "has" if unmatched_count == 1 else "have"
    unmatched_note = (
        f" {plural(unmatched_count, 'other')} {verb} no partner in the model." if unmatched_count else ""
    )
    measured, modelled = (
        round_to_sigma(frequency, abs(largest)).columns[0]
        for frequency in (row.measured, row.measured + largest)
    )
    return [
        Cell(
            f"The model {title} differs from {plural(len(differences), 'measured mode')} by {plain(rms, 2)} "
            f"Hz (rms), and by {plain(abs(largest), 2)} Hz at most: at"
        ),
        label_cell(row.pose),
        Cell(f"it predicts {modelled} Hz where {measured} Hz are measured.{unmatched_note}"),
    ]


def _next_measurement(result: Diagnosis, context: ReportContext) -> list[Cell]:
    """Return the measurement that is expected to separate the explanations best, or why none is proposed."""
    proposed = result.next_measurement
    if proposed is None and (advice := _confounder_advice(result)):
        return [sentence_cell(to_sentence(advice))]
    if proposed is None:
        return [sentence_cell(f"No next measurement is proposed: {result.next_measurement_reason}.")]
    json_key, text, cells = "next_measurement", "At", list[Cell]()
    components = context.components(len(proposed.pose))
    for component_index, ((name, symbol), value) in enumerate(zip(components, proposed.pose, strict=True)):
        cells += [
            Cell(f"{text} {name} ="),
            number_cell(value, ".4f", pointer(json_key, "pose", component_index)),
        ]
        text = f"{unit_text(symbol)},"
    if proposed.drives:
        motors = proposed.motors
        if context.robot is not None and proposed.drives == FREE:
            # Those that yield, as declared or claimed, are not called free.
            claimed = [effect.members[0] for effect in result.effects if len(effect.members) == 1]
            motors = motors_in_words(context.robot, proposed.drives, claimed)
        text += f" {motors},"
    first, second = (explanation_in_words(name, result) for name in proposed.separates)
    separation = f"which is expected to separate the explanations best: {first} and {second} differ there by"
    caveat = f" {to_sentence(proposed.caveat)}" if proposed.caveat else ""
    load_cells = [Cell("Set"), context.load_cell(proposed.load)] if proposed.load else []
    sigmas = number_cell(proposed.sigmas, ".0f", pointer(json_key, "sigmas"))
    return [*cells, Cell(f"{text} {separation}"), sigmas, Cell(f"standard deviations.{caveat}"), *load_cells]


def _confounder_advice(result: Diagnosis) -> str:
    """Return what would make the size of a cause far better known: what the data do not show; empty for nothing."""
    values = [saved_as(value, result.corrected) for effect in result.effects for value in effect.parameters]
    if any(len(effect.members) > 1 or effect.relative() for effect in result.effects):
        return ""
    least_certain = max(
        (value for value in values if value is not None and value.unseen is not None),
        key=lambda value: value.saved_sigma / value.sigma,
        default=None,
    )
    if (
        least_certain is None
        or least_certain.unseen is None
        or least_certain.saved_sigma < MIN_SIGMA_FACTOR * least_certain.sigma
    ):
        return ""
    factor, confounder = format_factor(least_certain.saved_sigma / least_certain.sigma), least_certain.unseen
    if confounder.default:
        remedy = f"declare {confounder.default.removeprefix('a ').partition(' of ')[0]}"
    else:
        path = confounder.candidate.removeprefix("parameter:")
        remedy = f"measure {path} itself" if path != confounder.candidate else f"rule out {path}"
    return (
        f"to know the size better, {remedy}: these data do not show it, which makes the standard deviation of "
        f"{least_certain.name.removeprefix('effects.')} {factor} as large as that of the fit"
    )
