"""What a saved robot file says of its values, and a second diagnosis of the file with the same measurements."""

from __future__ import annotations

from pathlib import Path

import pytest

from helpers.commands.own_folder import inside
from helpers.pages.documentation import ROOT
from pkmodes.cli import run
from pkmodes.loop.diagnosis.verdict.findings import Corrected, Unseen, wider_than_declared_in_words
from pkmodes.loop.updating.saved_term import change_note

CLOSED_LOOP = ROOT / "examples" / "closed_loop"
HEXAPOD = ROOT / "examples" / "hexapod" / "robot.toml"


def stiffness(value: float, unseen_sigma: float) -> Corrected:
    """Return a fitted stiffness of 2.42e6 +- 4.8e4 N/m as declared."""
    unseen = Unseen(unseen_sigma, "parameter:belt.width")
    return Corrected(
        "belt.specific_stiffness",
        value,
        2.7e3,
        "N/m",
        declared=2.42e6,
        prior_sigma=4.8e4,
        at_bound=False,
        unseen=unseen,
    )


def test_a_standard_deviation_larger_than_declared_is_explained() -> None:
    value = stiffness(2.448e6, 9.0e4)
    assert value.saved_sigma == pytest.approx((4.8e4**2 + 2.8e4**2) ** 0.5)  # declared value, and the move
    assert wider_than_declared_in_words(value) == (
        "that is more than the declared sigma, 4.8e4 N/m, because it may be all that moved the value, by 2.8e4 N/m"
    )
    assert not wider_than_declared_in_words(stiffness(2.448e6, 3.0e4))


def test_a_value_that_did_not_move_is_not_called_refitted() -> None:
    assert change_note(stiffness(2.42e6 + 0.1, 0.0), 2.42e6, "refitted") == "unchanged by pkmodes diagnose"
    assert change_note(stiffness(2.43e6, 0.0), 2.42e6, "refitted") == (
        "was 2.42e+06 N/m: refitted by pkmodes diagnose"
    )


def test_a_second_diagnosis_with_the_same_measurements_says_that_they_count_twice(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    measured = str(CLOSED_LOOP / "measured.csv")
    with inside(tmp_path):
        run(["diagnose", str(CLOSED_LOOP / "robot.toml"), measured, "--save-robot", "saved.toml"])
        assert "count twice" not in capsys.readouterr().out
        run(["diagnose", "saved.toml", measured])
    printed = " ".join(capsys.readouterr().out.split())
    assert "if that fit had these same measurements, they count twice" in printed
