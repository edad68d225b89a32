"""What to do about a diagnosis, in the owner's words: what to inspect, its effect, how certain, what to measure.

Each sentence holds by itself, and none claims more than the verdict.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import permutations

import numpy as np

from pkmodes.core.base.drives import FREE
from pkmodes.core.base.numbers import format_factor, plain, round_to_sigma
from pkmodes.core.support.motors import motors_in_words
from pkmodes.core.support.ordering import joined
from pkmodes.loop.diagnosis.posterior.document import NOTHING_MISSING, OUTSIDE
from pkmodes.loop.diagnosis.problem import Array
from pkmodes.loop.diagnosis.verdict import caveats
from pkmodes.loop.diagnosis.verdict.findings import saved_as
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.loop.diagnosis.verdict.rows import Error
from pkmodes.loop.diagnosis.verdict.stability_words import is_stable, same_verdict
from pkmodes.loop.diagnosis.verdict.terms import DECLARED, Beyond, TermClass
from pkmodes.loop.diagnosis.verdict.verdicts import ADEQUATE, VERDICTS
from pkmodes.pages.report.blocks import Cell, Facts
from pkmodes.pages.report.contrast import contrast
from pkmodes.pages.report.formatting import (
    clean,
    hertz,
    label,
    named,
    number,
    plural,
    pointer,
    sentence,
    unit,
)
from pkmodes.pages.report.setting import ReportSetting
from pkmodes.pages.report.stability import CHANGES

Entry = tuple[str, list[Cell]]
#: Where to look for a cause, and what to do there.
WHERE = {
    "axis_belt_stiffness": "the belts: whether all have the same type, width, tension and wear",
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
WHERE_ELSE = {
    "measurement:": "the measurement: whether its poses have the origin and the axes of the robot file",
    "parameter:": "the {words}: measure or look it up again",
}
#: Wording of a probability, by its lower bound: 96, 80 and 52 % of the most probable explanations were right
#: (docs/reference/results.md).
LIKELY = ((0.9, "very likely that"), (0.7, "likely that"), (0.0, "doubtful whether"))
#: Probability below which a claim is doubtful.
DOUBTFUL = LIKELY[1][0]
#: Chi-square per degree of freedom below which the stated errors are far larger than the residual: twice as large.
TOO_SMALL = 0.25
#: Factor on the standard deviation of a size from which what makes it larger is worth measuring.
WORTH_KNOWING = 2.0
#: Probabilities above this are not distinguished.
SUREST = 0.99
#: Most places to inspect that are listed: one for each leg of a machine with six.
MOST = 6


def action(result: Diagnosis, setting: ReportSetting) -> Facts:
    """Return what to inspect, its effect in hertz, how certain that is, and what to measure next."""
    effect = _effect(result)
    return Facts(
        [
            *_inspect(result, setting),
            ("effect", effect) if effect else ("difference", _difference(result)),
            ("how sure", _sure(result)),
            ("measure next", _next(result, setting)),
        ]
    )


def _inspect(result: Diagnosis, setting: ReportSetting) -> Iterator[Entry]:
    """Yield where to look for each cause, or for each remaining explanation."""
    causes = [effect.members for effect in result.effects]
    if term_class := _beyond(result):
        causes = [term_class.finding.members]
    elif result.survivors:
        causes = [tuple(name for group in result.survivors for name in group)]
    for k, names in enumerate(causes):
        places = [
            *dict.fromkeys(
                joined([_where(cause, result, setting) for cause in name.split(" + ")]) for name in names
            )
        ]
        for i, place in enumerate(places[:MOST]):
            yield "or" if i else "and" if k else "inspect", [Cell(sentence(place))]
        if len(places) > MOST:
            yield "or", [Cell(f"{plural(len(places) - MOST, 'further place')}: see the explanations below.")]
    if not causes:
        also = f"; but {clean(result.headline)}" if result.headline else ""
        unseen = caveats.undetectable_in_words(
            result.undetectable, any(limit.value for limit in result.limits.values())
        )
        rest = f" {sentence(clean(unseen))}" if unseen and result.verdict == ADEQUATE.word else ""
        yield "inspect", [Cell(sentence(f"{VERDICTS[result.verdict].inspect}{also}") + rest)]


def _where(name: str, result: Diagnosis, setting: ReportSetting) -> str:
    """Return where to look for a cause; its sentence if no advice is listed."""
    _, colon, advice = WHERE.get(name, "").partition(": ")
    if name in result.alone:
        joint_change = result.alone[name]
        return f"{joint_change.joint.words}, which is {joint_change.comparison}{colon}{advice}"
    parts = [contrast(effect, setting) for effect in result.effects if effect.name == name]
    if parts and parts[0] is not None:
        return f"{parts[0].part}, which is {parts[0].compared}{colon}{advice}"
    if name in WHERE:
        return WHERE[name]
    if (term_class := _beyond(result)) and term_class.forms.get(name, DECLARED) not in ("", DECLARED):
        return f"look for {clean(term_class.finding.member(name).words)}"
    for beginning, where in WHERE_ELSE.items():
        if name.startswith(beginning):
            path = name.removeprefix(beginning)
            return where.format(words=setting.words(path).partition(",")[0] or f"value of {clean(path)}")
    return _explanation(name, result)


def _beyond(result: Diagnosis) -> TermClass | None:
    """Return the class found beyond the catalogue; None if the catalogue itself names a cause."""
    return result.beyond.found if result.beyond is not None and not result.effects else None


def _effect(result: Diagnosis) -> list[Cell]:
    """Return the effect of the causes on the measured modes, and the largest with the refitted values; else empty.

    The effect is that of the causes at the values of the last model, whose modes with and without them are matched by
    rank, or by frequency where a cause adds modes, such as those of a moving frame.  The frequencies are those of the
    table of all measured modes: as declared, and with the causes.
    """
    stages = result.stages
    if stages is None or stages.after is None or stages.without is None:
        return []
    spectra = zip(stages.after.spectrum, stages.without, strict=True)
    partners = [dict(_alike(after, without)) for after, without in spectra]
    index = {pose: k for k, pose in enumerate(dict.fromkeys(row.pose for row in result.rows))}
    changes = []
    for i, row in enumerate(result.rows):
        at, k = index[row.pose], int(stages.after.mode[i]) - 1
        if row.before is not None and k in partners[at] and not row.outlier:
            changes.append((stages.after.spectrum[at, k] - stages.without[at, partners[at][k]], i))
    if not changes:
        return []
    sizes = [change for change, _ in changes]
    largest, i = max(changes, key=lambda entry: abs(entry[0]))
    row, at = result.rows[i], index[result.rows[i].pose]
    count = int(stages.after.mode.max(initial=1))
    new = [f for k, f in enumerate(stages.after.spectrum[at, :count]) if k not in partners[at]]
    verb = "lower" if max(sizes) <= 0.0 else "raise" if min(sizes) >= 0.0 else "change"
    who = f"they {verb}" if len(result.effects) > 1 else f"it {verb}s"
    refitted = any(value.after != value.before for value in result.refitted)
    total = ". With the refitted values, mode" if refitted else ": mode"
    left = len(result.rows) - len(changes)
    all_modes = (
        f"{len(changes)} of the {plural(len(result.rows), 'measured mode')}"
        if left
        else f"the {plural(len(changes), 'measured mode')}"
    )
    are = "another is" if len(new) == 1 else "others are"
    new_modes = f"; {are} new there, at {joined([f'{f:.4g}' for f in new])} Hz" if new else ""
    return [
        Cell(
            f"In the model {who} the frequencies of {all_modes} by up to "
            f"{plain(abs(largest), 2)} Hz{total} {stages.after.mode[i]} at"
        ),
        label(row.pose),
        Cell("goes from"),
        hertz(row.before, pointer("rows", i, "before_hz")),
        Cell("Hz as declared to"),
        hertz(row.after, pointer("rows", i, "after_hz")),
        Cell(f"Hz{new_modes}."),
    ]


def _alike(after: Array, without: Array) -> list[tuple[int, int]]:
    """Return the matching frequencies of two models, as pairs of indices."""
    f, g = (spectrum[np.isfinite(spectrum)] for spectrum in (after, without))
    if len(f) == len(g):
        return [(k, k) for k in range(len(f))]
    from scipy.optimize import linear_sum_assignment

    apart = np.log(f[:, None] / g) ** 2
    return [(int(k), int(n)) for k, n in zip(*linear_sum_assignment(apart), strict=True)]


def _difference(result: Diagnosis) -> list[Cell]:
    """Return how far the last model without causes is from the measured frequencies."""
    rows = [row for row in result.rows if not row.outlier]
    predicted = [row.before if result.refit is None else row.refit for row in rows]
    apart = [(f - row.measured, row) for f, row in zip(predicted, rows, strict=True) if f is not None]
    if not apart:
        return [Cell("The model has no mode near any measured frequency.")]
    rms = float(np.sqrt(np.mean([size**2 for size, _ in apart])))
    largest, row = max(apart, key=lambda entry: abs(entry[0]))
    title = "as declared" if result.refit is None else "with its uncertain values refitted"
    lost = len(rows) - len(apart)
    without = f" It has no mode for {plural(lost, 'other')}." if lost else ""
    measured, modelled = (
        round_to_sigma(frequency, abs(largest)).columns[0]
        for frequency in (row.measured, row.measured + largest)
    )
    return [
        Cell(
            f"The model {title} differs from {plural(len(apart), 'measured mode')} by {plain(rms, 2)} Hz (rms), and "
            f"by {plain(abs(largest), 2)} Hz at most: at"
        ),
        label(row.pose),
        Cell(f"it predicts {modelled} Hz where {measured} Hz are measured.{without}"),
    ]


def _sure(result: Diagnosis) -> list[Cell]:
    """Return how certain the verdict is, what limits it, and how well the size of a cause is known."""
    if result.beyond is not None and (term_class := _beyond(result)):
        return [Cell(" ".join(map(sentence, _sure_of_terms(result.beyond, term_class))))]
    p, alike = _probability(result)
    likely = "the tests allow that" if p is None else f"it is {next(w for least, w in LIKELY if p >= least)}"
    several, one_of = len(result.effects) > 1, any(len(effect.members) > 1 for effect in result.effects)
    who = "these" if several else "one of these" if one_of else "this"
    like = f", or what acts like {'this' if who == 'this' else 'these'}," if alike else ""
    causes = f"{who}{like} {'are the causes' if several else 'is the cause'}"
    claim = VERDICTS[result.verdict].sure.format(likely=likely, what=causes)
    sentences = [claim if p is None else f"{claim} (probability {_percent(p)})"]
    if alike:
        sentences.append("the tests exclude all others that act alike")
    if one_of:
        sentences.append("these data cannot tell which of the alternatives it is")
    values = [
        value for effect in result.effects for name in effect.members for value in effect.alternatives[name]
    ]
    saved = saved_as(values[0], result.corrected) if len(values) == 1 else None
    if saved is not None and saved.value != saved.declared:
        part = saved.saved_sigma / abs(saved.value - saved.declared)
        error = None if any(not same_verdict(result, entry) for entry in result.stability) else result.after
        sentences += [known] if (known := _size_known(part, error)) else []
    if result.settled and result.stability and not is_stable(result):
        changed = [entry.change for entry in result.stability if not same_verdict(result, entry)]
        words = joined([CHANGES.get(change, change) for change in changed], "or")
        sentences.append(f"with {words}, the verdict changes")
    if not result.settled and not result.survivors and result.probabilities is not None:
        explanation, p = result.probabilities.top
        if explanation == OUTSIDE:
            sentences.append(f"most probable is something that is not among the candidates ({_percent(p)})")
        else:
            members = (explanation,) if isinstance(explanation, str) else explanation
            first = members[0] if isinstance(members[0], str) else " + ".join(members[0])
            like = ", or what acts like this" if len(members) > 1 else ""
            words = f"{_explanation(first, result)}{like}"
            sentences.append(
                f"the most probable explanation, not certain enough to be claimed, is: {words} ({_percent(p)})"
            )
    text = " ".join(map(sentence, sentences))
    return [Cell(text.replace(" %", "\u00a0%"), plain=text)]


def _size_known(part: float, error: Error | None) -> str:
    """Return how well the size of a cause is known, as a part of it; empty where other errors give another verdict.

    - error: of the model with the cause: with a residual far below the stated errors, these are wrong
    """
    if error is None:
        return ""
    known = f"its size is known to within {plain(100.0 * part, 2)} % (one standard deviation"
    if error.chi2_per_dof < TOO_SMALL:
        return f"{known} by the stated errors, which are far larger than the residual)"
    return f"{known})"


def _sure_of_terms(beyond: Beyond, term_class: TermClass) -> Iterator[str]:
    """Yield how certain a claim beyond the catalogue is."""
    several = len(term_class.finding.members) > 1
    yield (
        f"of {beyond.tried} changes at a single place that were tried where the catalogue does not explain the "
        f"measurements, the tests leave {'only these' if several else 'only this one'}"
    )
    if several:
        yield "these data cannot tell which of the alternatives it is"
    elif len(term_class.finding.parameters) == 1:
        (value,) = term_class.finding.parameters
        declared = next(
            (parameter.declared for parameter in term_class.corrected if parameter.name == value.name), 0.0
        )
        if value.value != declared:
            part = value.sigma / abs(value.value - declared)
            yield _size_known(part, term_class.errors[term_class.finding.name])


def doubt(result: Diagnosis) -> str:
    """Return the probability of a claim that is doubtful, in per cent; empty where none is."""
    p, _ = _probability(result)
    return _percent(p) if result.effects and p is not None and p < DOUBTFUL else ""


def _probability(result: Diagnosis) -> tuple[float | None, bool]:
    """Return the probability of the claim, and whether it includes causes that the tests of the verdict excluded.

    None if nothing is claimed, or its probability is unknown.
    """
    probabilities = result.probabilities
    if probabilities is None or not result.settled:
        return None, False
    if not result.effects:
        return probabilities.nothing_missing, False
    claimed = [set(effect.members) for effect in result.effects]
    p, alike = 0.0, False
    for statement in probabilities.classes if len(claimed) == 1 else probabilities.pairs:
        causes = [(member,) if isinstance(member, str) else member for member in statement.members]
        matches = [  # whether they are those claimed, one of each class
            any(all(map(set.__contains__, claimed, order)) for order in permutations(names))
            for names in causes
        ]
        if any(matches):
            p, alike = p + statement.probability, alike or not all(matches)
    return p, alike


def _percent(p: float) -> str:
    return f"over {100 * SUREST:.0f} %" if p > SUREST else f"{100 * p:.0f} %"


def _explanation(name: str, result: Diagnosis) -> str:
    """Return an explanation in words, with its names."""
    if name == NOTHING_MISSING:
        return "nothing is missing"
    sentences = dict(result.sentences)
    for group in result.beyond.classes if result.beyond is not None else ():
        sentences |= {name: group.finding.member(name).sentence for name in group.finding.members}
    return named(name, sentences)


def _next(result: Diagnosis, setting: ReportSetting) -> list[Cell]:
    """Return the measurement that is expected to separate the explanations best, or why none is proposed."""
    proposed = result.next_measurement
    if proposed is None and (confounder := _confounder(result)):
        return [Cell(sentence(clean(confounder)))]
    if proposed is None:
        return [Cell(f"No next measurement is proposed: {clean(result.next_measurement_reason)}.")]
    at, text, cells = "next_measurement", "At", list[Cell]()
    components = setting.components(len(proposed.pose))
    for k, ((name, symbol), value) in enumerate(zip(components, proposed.pose, strict=True)):
        cells += [Cell(f"{text} {name} ="), number(value, ".4f", pointer(at, "pose", k))]
        text = f"{unit(symbol)},"
    if proposed.drives:
        motors = proposed.motors
        if setting.robot is not None and proposed.drives == FREE:
            # Those that yield, as declared or claimed, are not called free.
            claimed = [effect.members[0] for effect in result.effects if len(effect.members) == 1]
            motors = motors_in_words(setting.robot, proposed.drives, claimed)
        text += f" {motors},"
    first, second = (_explanation(name, result) for name in proposed.separates)
    contrast = f"which is expected to separate the explanations best: {first} and {second} differ there by"
    caveat = f" {sentence(proposed.caveat)}" if proposed.caveat else ""
    load = [Cell("Set"), setting.load(proposed.load)] if proposed.load else []
    sigmas = number(proposed.sigmas, ".0f", pointer(at, "sigmas"))
    return [*cells, Cell(f"{text} {contrast}"), sigmas, Cell(f"standard deviations.{caveat}"), *load]


def _confounder(result: Diagnosis) -> str:
    """Return what would make the size of a cause far better known: what the data do not show; empty for nothing."""
    values = [saved_as(value, result.corrected) for effect in result.effects for value in effect.parameters]
    if any(len(effect.members) > 1 or effect.relative() for effect in result.effects):
        return ""
    worst = max(
        (value for value in values if value is not None and value.unseen is not None),
        key=lambda value: value.saved_sigma / value.sigma,
        default=None,
    )
    if worst is None or worst.unseen is None or worst.saved_sigma < WORTH_KNOWING * worst.sigma:
        return ""
    factor, unseen = format_factor(worst.saved_sigma / worst.sigma), worst.unseen
    if unseen.default:
        what = f"declare {unseen.default.removeprefix('a ').partition(' of ')[0]}"
    else:
        path = unseen.candidate.removeprefix("parameter:")
        what = f"measure {path} itself" if path != unseen.candidate else f"rule out {path}"
    return (
        f"to know the size better, {what}, which could have changed it unseen in these data: because of that, the "
        f"standard deviation of {worst.name.removeprefix('effects.')} is {factor} as large as that of the fit"
    )
