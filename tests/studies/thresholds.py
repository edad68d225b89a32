"""Which thresholds of the diagnosis the suites notice when they are halved and doubled.

    python -m studies.thresholds --out docs/results/thresholds                           # `make suites`

A case runs once with shadows (`studies.shadows`) of all thresholds of `Criteria`, at half and at double.
Where a shadow made no difference to any decision, neither would the threshold; in one case of `TESTED`, one such
threshold is changed nevertheless.  Of the others, those that were tried least so far, and of these the rarest, are
changed, each in a run of its own, as many as there is time for in `SECONDS`, and the outcomes compared; each of them
in `TRIED` cases at most.

The cases of all suites are shuffled: a part of them is a sample of each suite.  What is found is kept in a file, a
line of JSON for each case, so that a run which was stopped goes on where it was.

*Decisions* are the cases in which some decision on the way, or some number that was calculated, is another one.
*Changed* are, of the outcomes that were *tried*, those that are others: the verdict, that on the damping, the
classes, the deciding rule, or values of causes by more than `SAME_VALUE` standard deviations.  What is only said in
notes, limits, probabilities or proposals is not compared.  Why a threshold stays that changed no outcome is in
`REASONS`, and a test that fails with half or double of it in `NOTICED_BY`.
"""

from __future__ import annotations

import os
import signal
import string
import time
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import fields, replace
from pathlib import Path
from typing import Any

import numpy as np

from pkmodes.loop.diagnosis import Criteria
from studies.deciding import SUITES, name_of
from studies.running import Kept, Outcome, command_line
from studies.shadows import Shadowed
from studies.tables import Table, Tables, publish

#: Number of cases.
COUNT = 400
#: Processor time in which thresholds are changed in a case, one at least [s], and most cases for each of them.
SECONDS, TRIED = 3.0, 8
#: One case in this many tests that a threshold which is not noticed changes nothing.
TESTED = 4
#: A diagnosis that takes this many times as long as before does not end.
LATE = 15
FACTORS = {"half": 0.5, "double": 2.0}
WHAT = ("decisions", "changed", "tried")
#: Values of causes that differ by no more than this part of their standard deviation are the same.
SAME_VALUE = 0.05
#: Thresholds of what is at most 1: more than that is never reached.
PARTS = {
    f"{part}.{name}"
    for part, names in {
        "shapes": ("strange_mac", "good_mac"),
        "search": ("much",),
        "claim": ("alone",),
        "readings": ("same_shape", "unit_paired"),
    }.items()
    for name in names
}
#: Why thresholds stay that changed no outcome.
REASONS = {
    "how much is tried: computing time, and an outcome only where a search or a fit ends too early": """
        fits.steps fits.rough_steps fits.rounds search.most_additions search.pairs
        search.few_rows search.much search.little search.promising search.at_least search.best_few
        search.nearly search.misled claim.contenders claim.near""",
    "only notes, limits, proposals or the words of a reason depend on it, which are not compared": """
        claim.seen claim.worth_measuring claim.worth_loading readings.same_shape
        readings.same_place[0] readings.same_place[1]""",
    "a level or a difference of chi2 with which the error rates are measured; no outcome that was tried is near": """
        gate.level gate.surely gate.plainly search.survives search.worth search.most_causes search.price_of_row
        claim.claimed claim.specific claim.spread claim.many claim.told_apart fits.most_shared damping.specific[1]
        reasons.far""",
    "pairs and weighs modes; those of the outcomes that were tried are clearly close or clearly apart": """
        pairing.reach pairing.shape_weight pairing.shape_sigmas pairing.close pairing.mixed
        pairing.mixed_sigmas pairing.most_mixed gate.margin gate.visible""",
    "the start or a limit of what is estimated": """
        shapes.least_sigma shapes.scatter shapes.least_scatter shapes.most_scatter damping.floor
        damping.resolution damping.least damping.outlier""",
    "guards against few or bad rows; those of the outcomes that were tried are many, or clearly bad": """
        shapes.good_mac shapes.strange_allowed search.hopeless search.rows_to_set_aside search.rows_per_outlier
        search.redundant search.strange claim.rows_for_two claim.alone claim.most_pairs""",
    "tells mistakes and wrong errors from causes, which the outcomes that were tried do by more than twice": """
        damping.most reasons.nearly_all[0] reasons.nearly_all[1] reasons.dispersed[0] reasons.dispersed[1]
        reasons.no_direction readings.rewired_misfit readings.rewired_scatter readings.rewired
        readings.rewired_certain readings.rewired_noise readings.rewired_told_apart readings.dead[0]
        readings.dead[1] readings.unit_gain readings.unit_difference readings.drives_gain
        readings.drives_difference readings.drives_rows""",
    "of a rule that decides no case of the suites, but a test, `test_what_a_claim_rests_on.py`": """
        claim.bounded claim.absent claim.moved""",
}
LETTERS = dict(zip(REASONS, string.ascii_lowercase, strict=False))
#: Tests that fail with half or double of such a threshold.
NOTICED_BY = {
    "pairing.most_mixed": "test_what_a_claim_rests_on.py",
    "claim.many": "test_verdicts.py",
    "claim.rows_for_two": "test_verdicts.py",
    "claim.most_pairs": "test_judgement.py",
    "claim.worth_measuring": "test_next_measurement.py",
    "claim.worth_loading": "test_verdicts.py",
    "damping.most": "test_damping_inputs.py",
    "reasons.nearly_all[1]": "test_what_a_claim_rests_on.py",
    "readings.same_shape": "test_notes.py",
    "claim.moved": "test_what_a_claim_rests_on.py",
}
#: A threshold, which is named after its place in `Criteria`, and a factor.
Key = tuple[str, str]


# Thresholds --------------------------------------------------------------------------------------------------


def numbers() -> dict[str, float]:
    """Return all thresholds: "gate.level", "damping.specific[0]"."""
    found: dict[str, float] = {}
    for part in fields(Criteria):
        for field in fields(getattr(Criteria(), part.name)):
            name, value = f"{part.name}.{field.name}", getattr(getattr(Criteria(), part.name), field.name)
            several = isinstance(value, tuple)
            found |= {f"{name}[{i}]": number for i, number in enumerate(value)} if several else {name: value}
    return found


def scaled(value: float, factor: float) -> float:
    """Return half or double a threshold; a whole number remains one, and at least 1."""
    return max(1, round(value * factor)) if isinstance(value, int) else value * factor


@contextmanager
def defaults(values: Mapping[str, Any]) -> Iterator[None]:
    """Diagnose with other thresholds where none are given."""
    former = Criteria.__init__.__defaults__
    parts = []
    for part in fields(Criteria):
        group = getattr(Criteria(), part.name)
        changed: dict[str, Any] = {}
        for field in fields(group):
            name, value = f"{part.name}.{field.name}", getattr(group, field.name)
            if isinstance(value, tuple):
                changed[field.name] = tuple(
                    values.get(f"{name}[{i}]", number) for i, number in enumerate(value)
                )
            elif name in values:
                changed[field.name] = values[name]
        parts.append(replace(group, **changed))
    Criteria.__init__.__defaults__ = tuple(parts)
    try:
        yield
    finally:
        Criteria.__init__.__defaults__ = former


@contextmanager
def limited(seconds: float) -> Iterator[None]:
    """Raise an error when more processor time is used than this."""

    def late(*_: object) -> None:
        raise TimeoutError("it does not end")

    former = signal.signal(signal.SIGVTALRM, late)
    signal.setitimer(signal.ITIMER_VIRTUAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0.0)
        signal.signal(signal.SIGVTALRM, former)


# Cases -------------------------------------------------------------------------------------------------------


def sample() -> list[tuple[str, Any, Callable[[Any], Outcome[Any]]]]:
    """Return all cases in an order of which each beginning has the same part of each suite: name, case, and run."""
    rng, placed = np.random.default_rng(0), []
    for suite, (cases, run) in SUITES.items():
        every = list(cases())
        for place, i in enumerate(rng.permutation(len(every)).tolist()):
            named = f"{suite}: {name_of(every[i])}", every[i], run
            placed.append(((place + 1) / len(every), named))
    return [named for _, named in sorted(placed, key=lambda each: each[0])]


def content(outcome: Outcome[Any]) -> dict[str, Any]:
    """Return what an outcome says of a case."""
    return {
        "verdict": outcome.verdict,
        "rule": outcome.rule,
        "classes": [list(members) for members in outcome.classes],
        "damping": getattr(outcome, "of_damping", ""),
        "values": {name: [float(value), float(sigma)] for name, value, sigma, _ in outcome.values},
    }


def differs(first: Mapping[str, Any], second: Mapping[str, Any]) -> str:
    """Return what is different in another outcome: "verdict", or the first other part; empty if nothing is."""
    for what in ("verdict", "damping", "classes", "rule"):
        if first[what] != second[what]:
            return what
    apart = [
        abs(a - b) / max(sigma, 1e-300)
        for name, (value, sigma) in first["values"].items()
        for a, b in zip((value, sigma), second["values"][name], strict=True)
    ]
    return "values" if max(apart, default=0.0) > SAME_VALUE else ""


def found(
    case: Any, run: Callable[[Any], Outcome[Any]], before: Sequence[Mapping[str, Any]]
) -> dict[str, Any]:
    """Return which shadows make a difference to decisions in a case, and which thresholds change its outcome.

    Parameters
    ----------
    before : sequence
        What was found in other cases.
    """
    noticed: set[Key] = set()
    others = {
        name: {(name, word): scaled(value, factor) for word, factor in FACTORS.items()}
        for name, value in numbers().items()
    }
    start = time.process_time()
    with defaults({name: Shadowed(value, others[name], noticed) for name, value in numbers().items()}):
        first = content(run(case))
    seconds = time.process_time() - start

    def changed(key: Key) -> str:
        try:
            with defaults({key[0]: others[key[0]][key]}), limited(LATE * seconds):
                return differs(first, content(run(case)))
        except Exception as error:  # a threshold with which the diagnosis does not run is noticed
            return f"failed: {type(error).__name__}: {error}"

    rng = np.random.default_rng(len(before))
    rest = sorted({key for shadows in others.values() for key in shadows} - noticed)
    drawn = [rest[rng.integers(len(rest))]] if len(before) % TESTED == 0 else []
    tried, often = tries(before)[0], Counter(tuple(key) for record in before for key in record["noticed"])
    rarely = [key for key in sorted(noticed) if tried[key] < TRIED]
    rarely.sort(key=lambda key: (tried[key], often[key], rng.random()))
    chosen = rarely[: max(1, round(SECONDS / seconds))]
    return {
        "rule": first["rule"],
        "noticed": sorted(noticed),
        "tried": [(key, changed(key)) for key in chosen],
        "unnoticed": [(key, changed(key)) for key in drawn],
    }


def tries(kept: Sequence[Mapping[str, Any]]) -> tuple[Counter[Key], Counter[Key]]:
    """Return how often each threshold was changed, and how often the outcome was then another one."""
    every = [(tuple(key), what) for record in kept for key, what in record["tried"]]
    return Counter(key for key, _ in every), Counter(key for key, what in every if what)


def main() -> None:
    """Run the cases that are not kept yet, and write the table."""
    parser = command_line("Halve and double the thresholds of the diagnosis.")
    parser.add_argument("--kept", type=Path, default=Path("build/thresholds.jsonl"), help="what was found")
    parser.add_argument("--count", type=int, default=COUNT, help="number of cases")
    arguments = parser.parse_args()
    kept = Kept(arguments.kept)
    for name, case, run in sample():
        if len(kept.lines) >= arguments.count:
            break
        if all(record["case"] != name for record in kept.lines):
            kept.add({"case": name, **found(case, run, kept.lines)})
    publish(tables(kept.lines), arguments.out)


def why_it_stays(name: str) -> str:
    """Return the letter of the reason why a threshold stays that changed no outcome, and the test that notices it."""
    letter = next((LETTERS[reason] for reason, names in REASONS.items() if name in names.split()), "")
    return f"{letter}, {test}" if (test := NOTICED_BY.get(name, "")) else letter


# Tables ------------------------------------------------------------------------------------------------------


def tables(kept: Sequence[Mapping[str, Any]]) -> Tables:
    """Return what half and double of each threshold change."""
    tested = [what for record in kept for _, what in record["unnoticed"]]
    differ = Counter(tuple(key) for record in kept for key in record["noticed"])
    tried, changed = tries(kept)
    rows = []
    for name, value in numbers().items():
        keys = [(name, word) for word in FACTORS]
        cells = [number for key in keys for number in (differ[key], changed[key], tried[key])]
        why = "" if any(changed[key] for key in keys) else why_it_stays(name)
        rows.append([name, f"{value:g}", *cells, "yes" if name in PARTS else "", why])
    head = ("threshold", "value", *(f"{word}: {what}" for word in FACTORS for what in WHAT))
    facts = {
        "cases": len(kept),
        **{
            f"of {suite}": n
            for suite, n in Counter(record["case"].partition(":")[0] for record in kept).items()
        },
        "deciding rules": len({record["rule"] for record in kept}),
        "diagnoses with another threshold": sum(tried.values()),
        "not noticed, and tried": len(tested),
        "not noticed, but changed": sum(map(bool, tested)),
    }
    return {
        "summary": Table.of(("quantity", "value"), facts.items()),
        "thresholds": Table.of((*head, "double is above 1", "why it stays"), rows),
        "reasons": Table.of(("letter", "why it stays"), [(letter, why) for why, letter in LETTERS.items()]),
    }


if __name__ == "__main__":
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    main()
