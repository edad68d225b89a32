"""How often each rule of the verdict decides on the virtual rig, and how often rightly.

    python -m studies.deciding --out tests/golden/rules.jsonl                            # `make suites`

Every case of the four suites is diagnosed once, with the seeds of tests/golden; a line for each is appended to
``--lines``, and a run that was interrupted goes on there.  docs/reference/verdicts.md prints the counts beside the
rules.
"""

from __future__ import annotations

import argparse
import json
import os
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

from pkmodes.loop.diagnosis.verdict.verdicts import ADEQUATE, AMBIGUOUS, EFFECT_FOUND, UNEXPLAINED
from pkmodes_rig import ASKEW, ORDERS
from studies import (
    clear_cases,
    clear_suites,
    damping_cases,
    judging,
    mechanism_cases,
    mechanism_suites,
)
from studies.cases import Case
from studies.judging import noticeable, same_of
from studies.motors import OTHER_DRIVES
from studies.requirements import CLEAR
from studies.running import Kept
from studies.suites import SUITES as OF_DIAGNOSIS

#: Seed of the cases of damping; the others have theirs.
SEED = 20261230
#: Cases of each suite, and how one is run.
SUITES: dict[str, tuple[Callable[[], Iterator[Any]], Callable[[Any], Any]]] = {
    "diagnosis": (lambda: (case for suite in OF_DIAGNOSIS.values() for case in suite()), judging.run),
    "mechanisms": (mechanism_suites.cases, mechanism_cases.run),
    "damping": (lambda: damping_cases.cases(SEED), damping_cases.run),
    "clear": (clear_suites.cases, clear_cases.run),
}
#: Rules that say what is wrong in the file, with the mistake that makes them right.
OF_FILES = {
    "before.unit": "unit",
    "before.drives": "drives",
    "before.wiring": "wiring",
    "after.dead_channel": "dead channel",
    "after.wiring": "wiring",
}
#: Edits, options and what a mistake of the wiring is called, of a `Case`.
GROSS, DISTURBED = ("outlier", "gross"), {"sigma_scale", "common", "drift"}
MISWIRED = ("exchanged", "channel")


class Truth(NamedTuple):
    """What is wrong in a case, and what a diagnosis should say.

    Attributes
    ----------
    names : tuple of str
        Candidates that should be named.
    outside : bool
        Whether there is a cause outside the candidates.
    mistake : str
        What the file has wrong: "unit", "drives", "wiring", or another mistake; empty for nothing.
    disturbed : bool
        Whether the measurements have errors that the file does not state.
    """

    names: tuple[str, ...]
    outside: bool = False
    mistake: str = ""
    disturbed: bool = False

    @classmethod
    def of(cls, case: Any) -> Truth:
        """Return what is wrong in a case of any suite."""
        if isinstance(case, damping_cases.Case):
            return cls(tuple(name.partition(".")[0] for name in case.effects))
        if isinstance(case, clear_cases.ClearCase):
            return cls(case.names, case.outside)
        drives = "drives" if case.edit == OTHER_DRIVES else ""
        if not isinstance(case, Case):
            return cls(case.names, bool(case.specimen.outside), drives)
        wiring = case.mistake in (*ORDERS, ASKEW) or any(word in case.mistake for word in MISWIRED)
        mistake = drives or ("wiring" if wiring else noticeable(case) or case.mistake)
        disturbed = case.edit in GROSS or bool(DISTURBED & case.options.keys())
        return cls(case.names, bool(case.truth.outside), mistake, disturbed)


def rightly(case: Any, outcome: Any) -> bool:
    """Return whether a verdict is right.

    * A rule that says what is wrong in the file: this is what is wrong.
    * ``effect_found``: each class has a true cause.
    * ``adequate``: the model lacks nothing, and the motors did what the file says.
    * ``ambiguous``: a true cause is among the survivors.
    * ``unexplained`` otherwise: something is wrong, and no clear cause was there to be named.
    * ``insufficient_data``: no clear cause was there to be named.

    A cause of the catalogue is clear if its predicted signal is above `CLEAR`, and neither unit, drives nor wiring
    are wrong.  Where no signal is predicted, as with few rows, no cause is clear.
    """
    truth, state, classes = Truth.of(case), outcome.state, outcome.classes
    if isinstance(case, damping_cases.Case):
        state, classes = outcome.of_frequencies
    if outcome.rule in OF_FILES:
        return truth.mistake == OF_FILES[outcome.rule]
    if outcome.verdict == EFFECT_FOUND.word:
        return state in ("named", "partly")
    if outcome.verdict == ADEQUATE.word:
        return state == "adequate" and not (truth.names or truth.outside or truth.mistake == "drives")
    if outcome.verdict == AMBIGUOUS.word:
        same = same_of(case.machine if hasattr(case, "machine") else _machine(case))
        true = {other for name in truth.names for other in (name, *same.get(name, ()))}
        return any(name in true for members in classes for one in members for name in one.split(" + "))
    clear = bool(truth.names) and outcome.signal > CLEAR and truth.mistake not in OF_FILES.values()
    wrong = bool(truth.names or truth.outside or truth.mistake or truth.disturbed)
    return not clear and (wrong or outcome.verdict != UNEXPLAINED.word)


def _machine(case: Any) -> str:
    return str((case.truth if isinstance(case, Case) else case.specimen).machine)


class Line(NamedTuple):
    """What decided a case."""

    suite: str
    case: str
    rule: str
    rightly: bool


def line_of(suite: str, case: Any, outcome: Any) -> Line:
    """Return the line of a case."""
    return Line(suite, name_of(case), outcome.rule, rightly(case, outcome))


def name_of(case: Any) -> str:
    """Return the name of a case within its suite."""
    return f"{case.label}, seed {case.seed}"


def read(path: Path) -> list[Line]:
    """Return the lines of a file; none if it does not exist."""
    return [Line(*json.loads(text)) for text in path.read_text().splitlines()] if path.exists() else []


def write(path: Path, lines: Iterable[Line]) -> None:
    """Add lines to a file, in place of former ones of their cases."""
    every = {line[:2]: line for line in (*read(path), *lines)}
    path.write_text("".join(json.dumps(line) + "\n" for line in every.values()))


def counts(lines: Iterable[Line]) -> dict[str, tuple[int, int]]:
    """Return how often each rule decided, and how often rightly."""
    lines = list(lines)
    right = Counter(line.rule for line in lines if line.rightly)
    return {rule: (number, right[rule]) for rule, number in Counter(line.rule for line in lines).items()}


def main() -> None:
    """Run the cases that are not yet in the file of lines, and write all of them in order."""
    parser = argparse.ArgumentParser(description="Count how often each rule of the verdict decides.")
    parser.add_argument("--lines", type=Path, default=Path("build/rules.jsonl"), help="lines of cases done")
    parser.add_argument("--out", type=Path, help="file for the lines of all cases, in their order")
    parser.add_argument("--every", type=int, default=1, help="run one case in this many")
    arguments = parser.parse_args()
    kept = Kept(arguments.lines)
    done = {line[:2]: line for line in (Line(*fields) for fields in kept.lines)}
    order = []
    for suite, (cases, run) in SUITES.items():
        for case in list(cases())[:: arguments.every]:
            order.append(key := (suite, name_of(case)))
            if key not in done:
                done[key] = line_of(suite, case, run(case))
                kept.add(done[key])
    for rule, (number, right) in sorted(counts(done[key] for key in order).items()):
        print(f"{rule}: {number}, rightly {right}")
    if arguments.out:
        arguments.out.unlink(missing_ok=True)
        write(arguments.out, (done[key] for key in order))


if __name__ == "__main__":
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    main()
