"""Measure how often the most probable explanation of a diagnosis is right, on the cases of all suites.

    python -m studies.calibration --seed 20271127 --out docs/results/probabilities        # `make suites`

`COUNT` cases drawn from all suites run with a fresh seed.  What is found is kept in a file, a line of JSON for each
case, so that a run which was stopped goes on where it was.  The most probable statement is right if it is the truth
of the case: nothing missing, the class that contains the cause, the pair of both causes, or something outside the
candidates, as a wrong value of a single axis is, which is no candidate.  A class with one of two causes is wrong, and
so is that nothing is missing where a cause is too small to be seen.
"""

from __future__ import annotations

import itertools
import sys
import traceback
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from pkmodes.loop.diagnosis.posterior.document import Probabilities
from studies import clear_cases, clear_suites, judging, mechanism_cases, mechanism_suites
from studies.cases import Case
from studies.clear_cases import ClearCase
from studies.judging import same_of
from studies.mechanism_cases import MechanismCase
from studies.running import Kept, Outcome, command_line
from studies.suites import SUITES
from studies.tables import Table, Tables, publish, stacked

#: Number of cases, and the seed by default.
COUNT, SEED = 1000, 20271127
#: Seeds with which the probabilities were developed.
SEEN = "70001, 20270401, 20270402 and 20270403"
#: Bounds of the bins of the largest probability.
BOUNDS = tuple(itertools.pairwise((0.0, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95, 0.99, 1.0)))
#: Suites whose data are mistaken on purpose: what is true of them is not among the explanations.
MISTAKEN = ("units and wiring", "wrong drives")


def cases(without: Sequence[str] = MISTAKEN) -> Iterator[tuple[str, Any, Callable[[Any], Any]]]:
    """Yield the cases of all suites but some, by default the mistaken ones: suite, case, and how it is run."""
    for name, suite in SUITES.items():
        if name not in without:
            yield from ((f"linear delta, {name}", case, judging.run) for case in suite())
    for other in mechanism_suites.cases():
        if other.suite not in without:
            yield f"{other.specimen.machine}, {other.suite}", other, mechanism_cases.run
    for clear in clear_suites.cases():
        yield f"{clear.machine}, clear, {clear.suite}", clear, clear_cases.run


def right(case: Any, probabilities: Probabilities, candidates: Sequence[str]) -> bool:
    """Return whether the most probable statement is the truth of a case."""
    top, (names, is_outside) = probabilities.top[0], truth_of(case)
    if top == "nothing_missing":
        return not names and not is_outside
    if top == "outside":
        # A value of a single axis, for which the file gives one for all, is no candidate.
        return is_outside or any(not truth & set(candidates) for truth in _truths(case))
    return explains(case, top)


def explains(case: Any, members: Sequence[str | tuple[str, str]]) -> bool:
    """Return whether one of the members of a class, or one of some pairs, is the cause or both causes of a case."""
    truths = _truths(case)
    explanations = [(member,) if isinstance(member, str) else member for member in members]
    return any(
        len(causes) == len(truths)
        and any(
            all(member in truth for member, truth in zip(order, truths, strict=True))
            for order in (causes, causes[::-1])
        )
        for causes in explanations
    )


def explains_a_part(case: Any, members: Sequence[str | tuple[str, str]]) -> bool:
    """Return whether one of the members of a class is one of several causes of a case."""
    truths = _truths(case)
    return len(truths) > 1 and any(member in truth for member in members for truth in truths)


def truth_of(case: Any) -> tuple[tuple[str, ...], bool]:
    """Return the causes that should be named, and whether something outside the candidates is right."""
    if isinstance(case, ClearCase):
        return case.names, case.outside
    truth = case.truth if isinstance(case, Case) else case.specimen
    return case.names, bool(truth.outside)


def _truths(case: Any) -> list[set[str]]:
    """Return the names that are right for each cause."""
    same = _same(case)
    return [{name, *same.get(name, ())} for name in truth_of(case)[0]]


def _same(case: Any) -> Mapping[str, tuple[str, ...]]:
    if isinstance(case, ClearCase):
        return same_of(case.machine)
    if isinstance(case, MechanismCase):
        return same_of(case.specimen.machine)
    return judging.SAME


# Running -----------------------------------------------------------------------------------------------------


def main() -> None:
    """Run the cases that are not kept yet, and write the tables."""
    parser = command_line("Measure the calibration of the probabilities.", SEED)
    parser.add_argument("--kept", type=Path, default=Path("build/calibration.jsonl"), help="what was found")
    parser.add_argument("--count", type=int, default=COUNT, help="number of cases")
    arguments = parser.parse_args()
    kept = Kept(arguments.kept)
    known = {record["case"] for record in kept.lines}
    every = list(cases())
    # Shuffled: a part of them is a sample of all.
    for place in np.random.default_rng(0).permutation(len(every))[: arguments.count].tolist():
        suite, case, run = every[place]
        case = replace(case, seed=arguments.seed)
        name = f"{suite}: {case.label}, seed {case.seed}"
        if name not in known:
            kept.add({"case": name, "suite": suite, **_found(case, run)})
    publish(tables(kept.lines, arguments.seed), arguments.out)


def _found(case: Any, run: Callable[[Any], Outcome[Any]]) -> dict[str, Any]:
    try:
        outcome = run(case)
    except Exception:
        print(traceback.format_exc(limit=-8), file=sys.stderr, flush=True)
        return {"state": "failed"}
    probabilities = outcome.probabilities
    found: dict[str, Any] = {"state": outcome.state, "verdict": outcome.verdict, "seconds": outcome.seconds}
    if probabilities is None:
        return found
    top, probability = probabilities.top
    return found | {
        "names": list(truth_of(case)[0]),
        "outside": truth_of(case)[1],
        "top": top,
        "probability": probability,
        "right": right(case, probabilities, outcome.candidates),
    }


# Tables ------------------------------------------------------------------------------------------------------


def tables(found: Sequence[Mapping[str, Any]], seed: int) -> Tables:
    """Return how often what was most probable was right."""
    some = [record for record in found if "right" in record]
    facts = {
        "seed": seed,
        "developed with the seeds": SEEN,
        "cases": len(found),
        "with probabilities": len(some),
        "failed": sum(record["state"] == "failed" for record in found),
        "expected calibration error": f"{error(some):.3f}",
    }
    bins = {f"{low:g} to {high:g}": _in_bin(some, low, high) for low, high in BOUNDS}
    suites = sorted({record["suite"] for record in some})
    groups = {
        "largest probability": bins | {"all": some},
        "most probable": {
            kind: [record for record in some if _kind(record["top"]) == kind] for kind in KINDS
        },
        "verdict": {
            name: [record for record in some if _verdict(record) == name]
            for name in sorted({_verdict(record) for record in some})
        },
        "suite": {name: [record for record in some if record["suite"] == name] for name in suites},
    }
    head = ("group", "cases", "mean probability", "right", "fraction right")
    return {
        "summary": Table.of(("quantity", "value"), facts.items()),
        "probabilities": stacked(
            "by",
            {
                by: Table.of(head, [_line(name, part) for name, part in parts.items()])
                for by, parts in groups.items()
            },
        ),
    }


#: Kinds of statements.
KINDS = ("nothing missing", "a class", "a pair", "outside")


def error(found: Sequence[Mapping[str, Any]]) -> float:
    """Return the expected calibration error: the mean over all cases of the error of their bin."""
    parts = [_in_bin(found, low, high) for low, high in BOUNDS]
    apart = [abs(sum(record["probability"] - record["right"] for record in part)) for part in parts]
    return sum(apart) / max(len(found), 1)


def _kind(top: Any) -> str:
    if isinstance(top, str):
        return "outside" if top == "outside" else "nothing missing"
    return "a class" if isinstance(top[0], str) else "a pair"


def _verdict(record: Mapping[str, Any]) -> str:
    """Return the verdict, and of a claim whether it is right."""
    return f"effect_found, {record['state']}" if record["verdict"] == "effect_found" else record["verdict"]


def _in_bin(found: Sequence[Mapping[str, Any]], low: float, high: float) -> list[Mapping[str, Any]]:
    return [record for record in found if low < record["probability"] <= high]


def _line(what: str, part: Sequence[Mapping[str, Any]]) -> tuple[object, ...]:
    count, good = len(part), sum(bool(record["right"]) for record in part)
    mean = f"{np.mean([record['probability'] for record in part]):.3f}" if count else ""
    return what, count, mean, good, f"{good / count:.3f}" if count else ""


if __name__ == "__main__":
    main()
