"""How the most probable explanation is held against the truth of a case, and the tables of that."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from pkmodes.loop.diagnosis.posterior.document import (
    ClassProbability,
    PairProbability,
    Probabilities,
    Statement,
)
from studies import calibration
from studies.cases import Case
from studies.specimens import Specimen

ONE_AXIS = "parameter:axis.2.carriage.mass"
CANDIDATES = ("belt_mass", "payload", "gearbox_inertia", "parameter:motor.gear_ratio")
PAIR = ("belt_mass", "payload")


def said(top: Statement) -> Probabilities:
    """Probabilities with this statement first."""
    if isinstance(top, str):
        return Probabilities(
            **({"nothing_missing": 0.1, "outside": 0.1, "classes": (), "pairs": ()} | {top: 0.9})
        )
    if isinstance(top[0], str):
        return Probabilities(0.05, 0.05, (ClassProbability(top, 0.9),), ())
    return Probabilities(0.05, 0.05, (), (PairProbability(top, 0.9),))


@pytest.mark.parametrize(
    ("names", "outside", "top", "right"),
    [
        ((), False, "nothing_missing", True),
        ((), False, "outside", False),
        ((), True, "outside", True),
        ((), True, "nothing_missing", False),
        ((), True, ("payload",), False),
        (("payload",), False, ("belt_mass", "payload"), True),
        (("payload",), False, ("belt_mass",), False),
        (("payload",), False, "nothing_missing", False),
        (("payload",), False, "outside", False),
        (("payload",), False, (PAIR,), False),
        (("gearbox_inertia",), False, ("parameter:motor.gear_ratio",), True),
        (PAIR, False, (("belt_mass", "gearbox_inertia"), PAIR), True),
        (PAIR[::-1], False, (PAIR,), True),
        (PAIR, False, ("payload",), False),
        (PAIR, False, (("belt_mass", "gearbox_inertia"),), False),
        ((ONE_AXIS,), False, "outside", True),
        ((ONE_AXIS,), False, (ONE_AXIS,), True),
    ],
)
def test_the_most_probable_explanation_is_held_against_the_truth(
    names: tuple[str, ...], outside: bool, top: Statement, right: bool
) -> None:
    truth = Specimen("tower", outside={"tuned_absorber": 0.1} if outside else {})
    case = Case("one effect", 0, "middle", truth, names)
    assert calibration.right(case, said(top), CANDIDATES) is right


def test_every_case_has_a_name_of_its_own_and_none_a_mistaken_file() -> None:
    """A case whose name another has would never run."""
    every = [(suite, case.label) for suite, case, _ in calibration.cases()]
    assert len(every) == len({*every}) > calibration.COUNT
    assert not any(suite.endswith(mistaken) for suite, _ in every for mistaken in calibration.MISTAKEN)


def test_a_run_that_was_stopped_goes_on_and_its_table_counts_every_case(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    tried = []

    def found(case: Case, run: object) -> dict[str, object]:
        tried.append(case.number)
        good = case.number % 4 != 3
        top = ["nothing_missing", ["payload"], [list(PAIR)], "outside"][case.number % 4]
        return {"state": "named", "verdict": "effect_found", "top": top, "probability": 0.92, "right": good}

    every = [
        ("suite", Case("one effect", k, "middle", Specimen("tower")), lambda case: case) for k in range(12)
    ]
    monkeypatch.setattr(calibration, "cases", lambda: iter(every))
    monkeypatch.setattr(calibration, "_found", found)
    kept = tmp_path / "kept.jsonl"
    for count in ("5", "12"):
        monkeypatch.setattr("sys.argv", ["calibration", "--kept", str(kept), "--count", count])
        calibration.main()
    assert sorted(tried) == list(range(12))
    assert len({json.loads(line)["case"] for line in kept.read_text(encoding="utf-8").splitlines()}) == 12
    printed = capsys.readouterr().out
    assert "|largest probability|0.9 to 0.95|12|0.920|9|0.750|" in printed
    assert "|expected calibration error|0.170|" in printed
    assert "|most probable|outside|3|0.920|0|0.000|" in printed
