"""Where a probability and the verdict disagree: explanations that are probable but refused, by the rule that refuses.

    python -m studies.refused --seed 20290202 --limit 5 --out docs/results/refused       # `make suites`

Cases of all suites run in turn, up to `--limit` of each, then all cases of the suites with the fewest measured modes,
where refusals are most frequent.  Those of one fault at one place, which are decided by rules of their own, have no
part.  What is found is kept in a file, a line of JSON for each case, so that a run which was
stopped goes on where it was.  Terms are not tried.

The most probable class or pair of each case is held against its verdict and the truth.  *Claimed*: `effect_found`,
with this class or pair and nothing else; *refused*: any other verdict or claim.  *Right*: it contains the cause, or
both causes; *one of two*: a class that contains one of two causes; *wrong* otherwise, also where nothing is missing
or the cause is outside the catalogue.

The stated probability of a class or pair contains the doubt that its verdict leaves (`DOUBT_IF_ACCEPTED`,
`DOUBT_IF_REFUSED`, `DOUBT_IF_UNEXPLAINED` of `probabilities`), so that none of an `unexplained` case is high,
whatever the data say; *as if accepted* it has the doubt of an accepted explanation in its place.

Every case that is refused by a rule which is asked where causes leave noise, however probable its best explanation,
is diagnosed again without that rule: what is then claimed, or which other rules refuse.  A claim is also wrong if a
row was set aside without the redundancy to tell which row is wrong.  The other rules cannot be left out: where they
decide, no causes leave noise.
"""

from __future__ import annotations

import itertools
import sys
import traceback
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any
from unittest import mock

import numpy as np

from pkmodes.loop.diagnosis.posterior.document import Probabilities
from pkmodes.loop.diagnosis.posterior.probabilities import (
    DOUBT_IF_ACCEPTED,
    DOUBT_IF_REFUSED,
    DOUBT_IF_UNEXPLAINED,
)
from pkmodes.loop.diagnosis.verdict import rules
from pkmodes.loop.diagnosis.verdict.unexplained import UNEXPLAINED_RULES
from pkmodes.loop.diagnosis.verdict.verdicts import EFFECT_FOUND, UNEXPLAINED
from studies import calibration, clear_cases, six_legged_suites
from studies.calibration import explains, explains_a_part, truth_of
from studies.running import Kept, Outcome, command_line
from studies.tables import Table, Tables, publish, stacked

#: The probability above which an explanation should not be refused without a reason.
PROBABLE = 0.95
SEED, LIMIT = 20290202, 5
#: Suites of which all cases run.
WHOLE = ("linear delta, few rows", "linear delta, outliers among few")
#: Machines whose cases take a minute each.
SLOW = ("hexaglide",)
#: What a claim of an explanation would be: with every cause, with one of two, or with something that is none.
RIGHT, PART, WRONG = "right", "one of two", "wrong"
STATES = (RIGHT, PART, WRONG)
#: What becomes of a case without the rule that decided it, by the state of its outcome.
WITHOUT = {"named": RIGHT, "partly": PART, "wrong": WRONG}
#: Members of a class that are listed.
MENTIONED = 4
OPEN_RULES = frozenset(rule.name for rule in UNEXPLAINED_RULES)
#: Rules that a diagnosis can do without: the last one always applies.
CLAIM_RULES = frozenset(rule.name for rule in rules.CLAIM_RULES[:-1])
FOUND = rules.CLAIM_RULES[-1].name
#: Members of a class, or pairs.
Members = Sequence[str] | Sequence[tuple[str, str]]
Run = Callable[[Any], Outcome[Any]]
Line = Mapping[str, Any]


# Cases -------------------------------------------------------------------------------------------------------


def cases() -> Iterator[tuple[str, Any, Run]]:
    """Yield the cases of the suites: suite, case, and how it is run."""
    yield from calibration.cases(without=())
    for case in six_legged_suites.cases():
        if case.machine not in SLOW:
            yield f"{case.machine}, clear, {case.suite}", case, clear_cases.run


def in_turn(some: Sequence[tuple[str, Any, Run]], limit: int) -> list[tuple[str, Any, Run]]:
    """Return cases in the order in which they run: one of each suite, drawn at random, then the next of each.

    Clear causes are suites on all machines alike.
    """
    suites: dict[str, list[tuple[str, Any, Run]]] = {}
    for entry in some:
        suites.setdefault(pooled(entry[0]), []).append(entry)
    drawn = [
        [suite[k] for k in np.random.default_rng(0).permutation(len(suite))[:limit].tolist()]
        for suite in suites.values()
    ]
    return [entry for turn in itertools.zip_longest(*drawn) for entry in turn if entry is not None]


def pooled(suite: str) -> str:
    """Return the name of a suite, without the machine where it is one of clear causes."""
    machine, clear, rest = suite.partition(", clear, ")
    return clear + rest or machine


# What is found -----------------------------------------------------------------------------------------------


def best(probabilities: Probabilities) -> tuple[Members, float] | None:
    """Return the most probable class or pair, with its probability; None if none has one."""
    explanations: list[tuple[Members, float]] = [
        (explanation.members, explanation.probability) for explanation in probabilities.classes
    ]
    explanations += [(explanation.members, explanation.probability) for explanation in probabilities.pairs]
    return max(explanations, key=lambda explanation: explanation[1], default=None)


def as_accepted(probability: float, verdict: str, rule: str) -> float:
    """Return what the probability of a class or pair would be if the verdict accepted it.

    The doubt depends on the verdict: it is undone, and that of an accepted explanation put in its place.
    """
    doubt = DOUBT_IF_ACCEPTED
    if verdict == UNEXPLAINED.word:
        doubt = DOUBT_IF_UNEXPLAINED if rule in OPEN_RULES else DOUBT_IF_REFUSED
    return probability * (1.0 - DOUBT_IF_ACCEPTED) / (1.0 - doubt)


def claimed(members: Members, outcome: Outcome[Any]) -> bool:
    """Return whether a verdict claims what a class or a pair says: each cause in a class, and no other class."""
    if outcome.verdict != EFFECT_FOUND.word:
        return False
    for member in members:
        causes = (member,) if isinstance(member, str) else member
        for order in itertools.permutations(causes):
            if len(order) == len(outcome.classes) and all(
                cause in found for cause, found in zip(order, outcome.classes, strict=True)
            ):
                return True
    return False


def held(case: Any, members: Members) -> str:
    """Return whether a claim of a class or pair would be right."""
    if explains(case, members):
        return RIGHT
    is_class = all(isinstance(member, str) for member in members)
    return PART if is_class and explains_a_part(case, members) else WRONG


@contextmanager
def without(rule: str) -> Iterator[None]:
    """Decide without one of the rules that are asked where causes leave noise."""
    with mock.patch.object(
        rules, "CLAIM_RULES", tuple(other for other in rules.CLAIM_RULES if other.name != rule)
    ):
        yield


def line_of(case: Any, run: Run) -> dict[str, Any]:
    """Run a case, again without the rule that refused to claim, and return what is found."""
    outcome = _attempt(case, run)
    if outcome is None:
        return {"rule": "", "verdict": "failed"}
    causes, outside = truth_of(case)
    found: dict[str, Any] = {
        "names": list(causes),
        "outside": outside,
        "rule": outcome.rule,
        "verdict": outcome.verdict,
        "state": outcome.state,
        "classes": outcome.classes,
        "signal": outcome.signal,
        "seconds": outcome.seconds,
        "reason": outcome.reason,
    }
    if outcome.rule in CLAIM_RULES:
        with without(outcome.rule):
            again = _attempt(case, run)
        found["without"] = (
            ["failed", ""] if again is None else [WITHOUT.get(again.state, "refused"), again.rule]
        )
    top = None if outcome.probabilities is None else best(outcome.probabilities)
    if top is None:
        return found
    members, probability = top
    return found | {
        "members": [member if isinstance(member, str) else " + ".join(member) for member in members],
        "probability": probability,
        "accepted": as_accepted(probability, outcome.verdict, outcome.rule),
        "held": held(case, members),
        "claimed": claimed(members, outcome),
    }


def _attempt(case: Any, run: Run) -> Outcome[Any] | None:
    try:
        return run(case)
    except Exception:
        print(traceback.format_exc(limit=-8), file=sys.stderr, flush=True)
        return None


# Running -----------------------------------------------------------------------------------------------------


def main() -> None:
    """Run the cases that are not kept yet, and write the tables."""
    parser = command_line("Measure what becomes of probable explanations that are refused.", SEED)
    parser.add_argument("--kept", type=Path, default=Path("build/refused.jsonl"), help="what was found")
    parser.add_argument("--limit", type=int, default=LIMIT, help="largest number of cases per suite")
    parser.add_argument("--no-whole", action="store_true", help="leave out those of which all cases run")
    arguments = parser.parse_args()
    kept = Kept(arguments.kept)
    known = {record["case"]: record for record in kept.lines}

    def of(suite: str, case: Any, run: Run) -> Line:
        case = replace(case, seed=arguments.seed)
        name = f"{suite}: {case.label}, seed {case.seed}"
        if name not in known:
            kept.add({"case": name, "suite": suite, **line_of(case, run)})
            known[name] = kept.lines[-1]
        return known[name]

    every = list(cases())
    drawn = [of(*entry) for entry in in_turn(every, arguments.limit)]
    whole = [] if arguments.no_whole else [of(*entry) for entry in every if entry[0] in WHOLE]
    publish(tables(drawn, whole, arguments.seed), arguments.out)


# Tables ------------------------------------------------------------------------------------------------------


def tables(drawn: Sequence[Line], whole: Sequence[Line], seed: int) -> Tables:
    """Return the tables of cases drawn from all suites, and of all those of a few suites."""
    some = [record for record in drawn if "members" in record]
    every = list({record["case"]: record for record in (*drawn, *whole)}.values())
    facts = {
        "seed": seed,
        "cases drawn": len(drawn),
        "suites": len({pooled(record["suite"]) for record in drawn}),
        "with a class or pair": len(some),
        "cases with few rows": len(whole),
        "failed": sum(record["verdict"] == "failed" for record in every),
        "doubt, accepted [%]": f"{100 * DOUBT_IF_ACCEPTED:.0f}",
        "doubt, refused [%]": f"{100 * DOUBT_IF_REFUSED:.0f}",
        "doubt, none left [%]": f"{100 * DOUBT_IF_UNEXPLAINED:.0f}",
    }
    return {
        "summary": Table.of(("quantity", "value"), facts.items()),
        "shares": stacked(
            "probability",
            {"as stated": _shares(some, "probability"), "as if accepted": _shares(some, "accepted")},
        ),
        "rules": stacked("cases", {"drawn": _by_rule(drawn), "few rows": _by_rule(whole)}),
        "without": _without(every),
        "cases": _listed([record for record in every if _refused(record) and record["accepted"] > PROBABLE]),
    }


def _refused(record: Line) -> bool:
    """Return whether a case has a class or pair with a probability that is not claimed."""
    return "members" in record and not record["claimed"]


def _shares(some: Sequence[Line], key: str) -> Table:
    """Return how often what is probable is right, where it is claimed and where it is refused."""
    high = [record for record in some if record[key] > PROBABLE]
    groups = {
        "claimed": [record for record in high if record["claimed"]],
        "refused": [record for record in high if not record["claimed"]],
        "all": high,
    }
    rows = [[name, *_counts(group, "held"), _part(group)] for name, group in groups.items()]
    return Table.of([f"above {PROBABLE}", "cases", *STATES, "fraction right"], rows)


def _by_rule(some: Sequence[Line]) -> Table:
    """Return, of the cases that a rule refuses, all with a probability, and those where it is high as if accepted."""
    rows = []
    for rule in _ordered(some):
        decided = [record for record in some if record["rule"] == rule and _refused(record)]
        probable = [record for record in decided if record["accepted"] > PROBABLE]
        if probable:
            stated = sum(record["probability"] > PROBABLE for record in probable)
            name = f"{rule}, with another claim" if rule == FOUND else rule
            counted = [*_counts(probable, "held"), _part(probable), str(stated)]
            rows.append([name, str(len(decided)), *counted])
    return Table.of(["rule", "decided", "probable", *STATES, "fraction right", "above as stated"], rows)


def _without(some: Sequence[Line]) -> Table:
    again, rows = [record for record in some if "without" in record], []
    for rule in _ordered(again):
        group = [record for record in again if record["rule"] == rule]
        states = [record["without"][0] for record in group]
        others = sorted({record["without"][1] for record in group if record["without"][0] == "refused"})
        still = states.count("refused")
        rows.append(
            [
                rule,
                str(len(group)),
                *(str(states.count(state)) for state in STATES),
                *(str(still), ", ".join(others)),
            ]
        )
    head = ["without", "cases", *(f"claim {state}" for state in STATES), "still refused", "by"]
    return Table.of(head, rows)


def _listed(doubted: Sequence[Line]) -> Table:
    order = {rule: k for k, rule in enumerate(_ordered(doubted))}
    rows = [
        [
            record["rule"],
            record["case"].partition(": ")[2].rpartition(", seed")[0],
            " + ".join(record["names"]) or ("outside" if record["outside"] else "nothing missing"),
            _some(record["members"]),
            f"{record['accepted']:.3f}",
            record["held"],
            _then(record),
        ]
        for record in sorted(doubted, key=lambda record: order[record["rule"]])
    ]
    head = ["rule", "case", "truth", "class or pair", "as if accepted", "it is", "without the rule"]
    return Table.of(head, rows)


def _some(members: Sequence[str]) -> str:
    """Return the first members of a class, and how many more it has."""
    more = len(members) - MENTIONED
    return " or ".join(members[:MENTIONED]) + (f", {more} more" if more > 0 else "")


def _then(record: Line) -> str:
    """Return what a case gives without the rule that refused."""
    state, rule = record.get("without", ("", ""))
    return f"refused, {rule}" if state == "refused" else f"claim {state}" if state in STATES else state


def _ordered(some: Sequence[Line]) -> list[str]:
    """Return the rules that decided, in the order in which they are asked."""
    asked = [rule.name for rule in (*rules.ADEQUACY_RULES, *rules.CLAIM_RULES, *UNEXPLAINED_RULES)]
    decided = dict.fromkeys(record["rule"] for record in some)
    return sorted(decided, key=lambda name: asked.index(name) if name in asked else -1)


def _counts(group: Sequence[Line], key: str) -> list[str]:
    return [str(len(group)), *(str(sum(record[key] == state for record in group)) for state in STATES)]


def _part(group: Sequence[Line]) -> str:
    return f"{sum(record['held'] == RIGHT for record in group) / len(group):.2f}" if group else ""


if __name__ == "__main__":
    main()
