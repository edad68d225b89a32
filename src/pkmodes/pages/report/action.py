"""What to do about a diagnosis, in the owner's words: what to inspect, its effect, how certain, what to measure.

Each sentence holds by itself, and none claims more than the verdict.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import permutations

import numpy as np

from pkmodes.core.base.drives import FREE
from pkmodes.core.support.motors import motors_in_words
from pkmodes.core.support.numbers import plain, rounded
from pkmodes.core.support.ordering import joined
from pkmodes.loop.diagnosis.posterior.document import NOTHING_MISSING, OUTSIDE, Probabilities
from pkmodes.loop.diagnosis.problem import Array
from pkmodes.loop.diagnosis.verdict.findings import NextMeasurement, saved_as
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.loop.diagnosis.verdict.stability_words import same, stable
from pkmodes.loop.diagnosis.verdict.terms import DECLARED, Beyond, TermClass
from pkmodes.loop.diagnosis.verdict.verdicts import VERDICTS
from pkmodes.pages.report.blocks import Cell, Facts
from pkmodes.pages.report.formatting import clean, label, named, number, plural, pointer, sentence, unit
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
#: Probabilities above this are not distinguished.
SUREST = 0.99
#: Most explanations for which the report states where to look.
MOST = 5


def action(result: Diagnosis, setting: ReportSetting) -> Facts:
    """Return what to inspect, its effect in hertz, how certain that is, and what to measure next."""
    effect = _effect(result, setting)
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
        yield "inspect", [Cell(sentence(f"{VERDICTS[result.verdict].inspect}{also}"))]


def _where(name: str, result: Diagnosis, setting: ReportSetting) -> str:
    """Return where to look for a cause; its sentence if no advice is listed."""
    if name in result.alone:
        joint_change, (_, colon, advice) = result.alone[name], WHERE.get(name, "").partition(": ")
        return f"{joint_change.joint.words}, which is {joint_change.compared}{colon}{advice}"
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


def _effect(result: Diagnosis, setting: ReportSetting) -> list[Cell]:
    """Return the effect of the causes on the frequencies at the measured poses; empty without causes.

    Modes are matched by rank; where a cause adds modes, such as those of a moving frame, by frequency.
    """
    stages = result.stages
    if stages is None or stages.after is None or stages.without is None:
        return []
    count = int(stages.after.mode.max(initial=1))
    spectra = zip(stages.after.spectrum, stages.without, strict=True)
    pairs = [_alike(after, without) for after, without in spectra]
    changes = [
        (float(stages.after.spectrum[i, k] - stages.without[i, n]), i, k, n)
        for i, pose_pairs in enumerate(pairs)
        for k, n in pose_pairs
        if k < count
    ]
    if not changes:
        return []
    sizes = [change for change, *_ in changes]
    largest, at, mode, partner = max(changes, key=lambda entry: abs(entry[0]))
    labels = [*dict.fromkeys(row.pose for row in result.rows)]
    new = [f for k, f in enumerate(stages.after.spectrum[at, :count]) if k not in dict(pairs[at])]
    verb = "lower" if max(sizes) <= 0.0 else "raise" if min(sizes) >= 0.0 else "change"
    who = f"they {verb}" if len(result.effects) > 1 else f"it {verb}s"
    place = "setup" if setting.robot is None else "pose"
    before, now = (
        rounded(float(f), abs(largest)).columns[0]
        for f in (stages.without[at, partner], stages.after.spectrum[at, mode])
    )
    are = "another is" if len(new) == 1 else "others are"
    new_modes = f"; {are} new, there {joined([f'{f:.4g}' for f in new])} Hz" if new else ""
    return [
        Cell(
            f"In the model {who} the natural frequencies at the {plural(len(labels), f'measured {place}')} by up to "
            f"{plain(abs(largest), 2)} Hz: that of mode {mode + 1} at"
        ),
        label(labels[at]),
        Cell(f"from {before} to {now} Hz{new_modes}."),
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
        rounded(frequency, abs(largest)).columns[0] for frequency in (row.measured, row.measured + largest)
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
    claim = VERDICTS[result.verdict].sure.format(likely=likely, what=_claim(result, alike))
    sentences = [claim if p is None else f"{claim} (probability {_percent(p)})"]
    if alike:
        sentences.append("the tests exclude all others that act alike")
    if any(len(effect.members) > 1 for effect in result.effects):
        sentences.append("these data cannot tell which of the alternatives it is")
    if size := _size(result):
        sentences.append(f"how large it is, is known to {size}")
    if result.settled and result.stability and not stable(result):
        changed = [entry.change for entry in result.stability if not same(result, entry)]
        words = joined([CHANGES.get(change, change) for change in changed], "or")
        sentences.append(f"with {words}, the verdict is another")
    if not result.settled and not result.survivors and result.probabilities is not None:
        sentences.append(_most_probable(result, result.probabilities))
    text = " ".join(map(sentence, sentences))
    return [Cell(text.replace(" %", "\u00a0%"), plain=text)]


def _sure_of_terms(beyond: Beyond, term_class: TermClass) -> Iterator[str]:
    """Yield how certain a claim beyond the catalogue is."""
    several = len(term_class.finding.members) > 1
    yield (
        f"of {beyond.tried} changes at one place each that were tried where the catalogue does not explain the "
        f"measurements, the tests leave {'these alone' if several else 'this alone'}"
    )
    if several:
        yield "these data cannot tell which of the alternatives it is"
    elif len(term_class.finding.parameters) == 1:
        (value,) = term_class.finding.parameters
        declared = next(
            (parameter.declared for parameter in term_class.corrected if parameter.name == value.name), 0.0
        )
        if value.value != declared:
            part = plain(100.0 * value.sigma / abs(value.value - declared), 2)
            yield f"how large it is, is known to {part} % (one standard deviation)"


def _claim(result: Diagnosis, alike: bool) -> str:
    """Return what was claimed to be the cause, as a clause."""
    one_of = any(len(effect.members) > 1 for effect in result.effects)
    several = len(result.effects) > 1
    who = "these" if several else "one of these" if one_of else "this"
    like = f", or what acts like {'this' if who == 'this' else 'these'}," if alike else ""
    return f"{who}{like} {'are the causes' if several else 'is the cause'}"


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
        matches = [
            _claimed((member,) if isinstance(member, str) else member, claimed)
            for member in statement.members
        ]
        if any(matches):
            p, alike = p + statement.probability, alike or not all(matches)
    return p, alike


def _claimed(causes: tuple[str, ...], claimed: list[set[str]]) -> bool:
    """Return whether causes are those claimed, one of each class."""
    return any(all(map(set.__contains__, claimed, order)) for order in permutations(causes))


def _percent(p: float) -> str:
    return f"over {100 * SUREST:.0f} %" if p > SUREST else f"{100 * p:.0f} %"


def _most_probable(result: Diagnosis, probabilities: Probabilities) -> str:
    """Return the most probable explanation where none is certain enough for the verdict."""
    explanation, p = probabilities.top
    if explanation == OUTSIDE:
        return f"most probable is something that is no candidate ({_percent(p)})"
    words = _explanation(explanation if isinstance(explanation, str) else _joined(explanation[0]), result)
    like = "" if isinstance(explanation, str) or len(explanation) == 1 else ", or what acts like this"
    return f"most probable, but not sure enough to be claimed, is: {words}{like} ({_percent(p)})"


def _joined(causes: str | tuple[str, str]) -> str:
    return causes if isinstance(causes, str) else " + ".join(causes)


def _explanation(name: str, result: Diagnosis) -> str:
    """Return an explanation in words, with its names."""
    if name == NOTHING_MISSING:
        return "nothing is missing"
    sentences = dict(result.sentences)
    for group in result.beyond.classes if result.beyond is not None else ():
        sentences |= {name: group.finding.member(name).sentence for name in group.finding.members}
    return named(name, sentences)


def _size(result: Diagnosis) -> str:
    """Return how well the size of the only cause is known, in per cent; empty where it has several values."""
    values = [
        value for effect in result.effects for name in effect.members for value in effect.alternatives[name]
    ]
    saved = saved_as(values[0], result.corrected) if len(values) == 1 else None
    if saved is None or saved.value == saved.declared:
        return ""
    part = saved.saved_sigma / abs(saved.value - saved.declared)
    return f"{plain(100.0 * part, 2)} % (one standard deviation)"


def _next(result: Diagnosis, setting: ReportSetting) -> list[Cell]:
    """Return the measurement that is expected to separate the explanations best, or why none is proposed."""
    proposed = result.next_measurement
    if proposed is None:
        return [Cell(f"No next measurement is proposed: {clean(result.next_measurement_reason)}.")]
    at, text, cells = "next_measurement", "At", list[Cell]()
    components = setting.components(len(proposed.pose))
    for k, ((name, symbol), value) in enumerate(zip(components, proposed.pose, strict=True)):
        cells += [Cell(f"{text} {name} ="), number(value, ".4f", pointer(at, "pose", k))]
        text = f"{unit(symbol)},"
    if proposed.drives:
        text += f" {_motors(result, setting, proposed)},"
    first, second = (_explanation(name, result) for name in proposed.separates)
    told = f"which is expected to tell most about what is true: {first}, or {second}; they differ there by"
    caveat = f" {sentence(proposed.caveat)}" if proposed.caveat else ""
    load = [Cell("Set"), setting.load(proposed.load)] if proposed.load else []
    sigmas = number(proposed.sigmas, ".0f", pointer(at, "sigmas"))
    return [*cells, Cell(f"{text} {told}"), sigmas, Cell(f"standard deviations.{caveat}"), *load]


def _motors(result: Diagnosis, setting: ReportSetting, proposed: NextMeasurement) -> str:
    """Return what to do with the motors; free ones that yield, as declared or claimed, are not called free."""
    if setting.robot is None or proposed.drives != FREE:
        return proposed.motors
    claimed = [effect.members[0] for effect in result.effects if len(effect.members) == 1]
    return motors_in_words(setting.robot, proposed.drives, claimed)
