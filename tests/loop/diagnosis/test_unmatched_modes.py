"""What is told of measured modes without a partner: in a comparison, a diagnosis, on pages and on the terminal.

The example's rail gives one mode more than the model has, so that measured modes change places with others.
"""

from __future__ import annotations

import math
import re
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from pkmodes import read_robot
from pkmodes.core.robot.robot import Robot
from pkmodes.loop import updating
from pkmodes.loop.diagnosis import Comparison, Diagnosis, Measurements
from pkmodes.pages.plots.evidence import PlottedEvidence
from pkmodes.pages.report.action import recommended_action
from pkmodes.pages.report.comparison import comparison_summary
from pkmodes.pages.report.mode_table import mode_table
from pkmodes.pages.report.numbers import error_blocks
from pkmodes.pages.report.report_context import ReportContext
from pkmodes.pages.report.sections import glossary_section

EXAMPLE = Path(__file__).parents[3] / "examples/loose_rail"
#: Line of the mode at 151.7 Hz whose nearest mode of the model, at 137 Hz, has nothing of its shape.
STRANGER = 68
LEFT_OUT = (
    "Left out: 9 modes for which the model has none left within a factor of 1.8, and 5 modes whose nearest mode "
    "has another shape (MAC below 0.5)."
)


@cache
def example() -> tuple[Robot, Measurements]:
    robot = read_robot(EXAMPLE / "robot.toml")
    return robot, updating.read(EXAMPLE / "measured.csv", None, robot)


@cache
def compared() -> Comparison:
    return updating.compare(*example())


@cache
def diagnosed() -> Diagnosis:
    return updating.diagnose(*example(), terms=False)


def context() -> ReportContext:
    robot, data = example()
    return ReportContext(robot.name, robot, data, (), None)


def texts(facts: Any) -> dict[str, str]:
    return {name: " ".join(cell.text for cell in cells) for name, cells in facts.entries}


def test_no_pair_of_a_comparison_has_another_shape_and_none_counts_in_its_numbers() -> None:
    result = compared()
    stranger = next(row for row in result.rows if row.line == STRANGER)
    assert (stranger.predicted, stranger.partner, stranger.residual, stranger.sigmas) == (None,) * 4
    assert stranger.mac is None
    assert stranger.nearest_mac is not None
    assert stranger.nearest_mac < 0.01
    assert stranger.nearest == pytest.approx(137.2, abs=0.1)
    paired = [row for row in result.rows if row.predicted is not None]
    assert (
        min(row.mac for row in paired if row.mac is not None) > 0.45
    )  # the errors explain up to 0.1 of 1 - MAC
    residual = np.array([row.residual for row in paired], dtype=float)
    sigmas = np.array([row.sigmas for row in paired], dtype=float)
    assert result.rms_relative == pytest.approx(np.sqrt(np.mean(residual**2)))
    # Uncertain poses correlate the modes of a pose; here they are stated as exact.
    assert result.chi2_per_dof == pytest.approx(np.mean(sigmas**2))
    document = result.as_json("worn-delta")
    assert document["unpaired"] == len(result.unpaired) == 14 == len(result.rows) - len(paired)


def test_a_comparison_says_what_its_numbers_are_of_and_what_they_leave_out() -> None:
    result = compared()
    summary = comparison_summary(result, context())
    assert f"The rms, chi\u00b2 and p are of the 53 paired modes. {LEFT_OUT}" in summary.reason
    facts = dict(summary.facts)
    assert facts["chi\u00b2 per degree of freedom of the 53 paired modes"].value == result.chi2_per_dof


def test_the_table_says_why_a_mode_near_one_of_the_model_is_unmatched() -> None:
    _, data = example()
    table = mode_table(compared(), PlottedEvidence.of(compared(), data), context())
    row = next(row for row in table.rows if row[1].text == str(STRANGER))
    assert row[-1].text == "unmatched: the nearest mode, 137.197 Hz, has another shape, MAC 0.001"
    assert row[-1].terminal_text == "unmatched: MAC 0.001"
    assert (
        "An unmatched mode with a MAC: the nearest mode of the model has another shape (MAC below 0.5)."
        in (table.caption)
    )


def test_a_diagnosis_tells_no_pair_of_another_shape_though_its_chi_square_counts_it() -> None:
    """The chi-square of all rows, with the nearest mode or a factor of 1.8, is that of the pairing of the fit."""
    result = diagnosed()
    stranger = next(row for row in result.rows if row.line == STRANGER)
    assert stranger.before is None
    assert stranger.refit is None
    assert stranger.held_out
    assert stranger.nearest == pytest.approx(138.06, abs=0.01)
    assert {row.line for row in result.unpaired} == {row.line for row in compared().unpaired}
    assert result.before is not None
    by_line = {row.line: row for row in compared().rows}
    squares, differences = [], {True: [], False: []}
    for row in result.rows:
        declared = by_line[row.line]
        model = declared.predicted or declared.nearest
        difference = math.log(model / row.measured) if model else 0.6  # the reach of the pairing, ln 1.8
        if not row.held_out:
            squares.append((difference * row.measured / row.sigma) ** 2)
        if declared.residual is not None:
            differences[row.held_out].append(declared.residual)
    assert result.before.chi2_per_dof == pytest.approx(np.mean(squares), rel=1e-6)
    assert result.before.rms_relative == pytest.approx(np.sqrt(np.mean(np.square(differences[False]))))
    assert result.before.held_out_rms_relative == pytest.approx(
        np.sqrt(np.mean(np.square(differences[True])))
    )


def test_what_is_said_first_of_a_diagnosis_is_of_pairs() -> None:
    """Neither "14 Hz at most" of a mode of another shape, nor a mode that the model does not have."""
    difference = texts(recommended_action(diagnosed(), context()))["difference"]
    largest = re.search(r"and by ([\d.]+) Hz at most", difference)
    assert largest is not None
    pairs = [abs(row.refit - row.measured) for row in diagnosed().rows if row.refit is not None]
    assert float(largest[1]) == pytest.approx(max(pairs), rel=0.05)
    assert "14 others have no partner in the model." in difference
    counted = " ".join(getattr(block, "text", "") for block in error_blocks(diagnosed()))
    fitted = [row for row in diagnosed().unpaired if not row.held_out]
    strangers = sum(row.nearest is not None for row in fitted)
    assert f"{len(fitted)} fitted modes have no partner in the model (as declared). In chi\u00b2, " in counted
    assert f"{strangers} count as the difference from the nearest mode, which has another shape" in counted


def test_the_size_of_a_residual_is_the_root_of_the_chi_square_of_its_page() -> None:
    """23615 is in the table, and its root in the sentence; not the root of another number."""
    result = diagnosed()
    assert result.refit is not None
    size = re.search(
        r"the residual is significant: (\d+) times as large as the stated errors \(the root of chi2 per degree of "
        r"freedom, (\d+)\)",
        result.reason,
    )
    assert size is not None
    assert int(size[2]) == round(result.refit.chi2_per_dof)
    assert float(size[1]) == pytest.approx(math.sqrt(result.refit.chi2_per_dof), rel=0.05)
    rest = re.search(
        r"leaves a residual ([\d.]+) times as large as the stated errors \(the root of chi2 per degree of freedom, "
        r"([\d.]+); p",
        result.reason,
    )
    assert rest is not None
    assert float(rest[1]) == pytest.approx(math.sqrt(float(rest[2])), rel=0.05)


@pytest.mark.parametrize(
    ("is_diagnosis", "counted"),
    [(False, "the others have no difference, and are left out"), (True, "counts too")],
)
def test_the_glossary_says_which_modes_a_chi_square_is_of(is_diagnosis: bool, counted: str) -> None:
    (facts,) = glossary_section(is_diagnosis).blocks
    meanings = texts(facts)
    assert counted in meanings["chi\u00b2 per dof"]
    assert (
        "none is left within a factor of 1.8 in frequency, or the one left has another shape"
        in (meanings["unmatched"])
    )


def test_the_best_of_the_catalogue_has_one_chi_square_in_sentence_and_table() -> None:
    """The explanation that the reason names, without errors of the measurement, not one with rows set aside."""
    result = updating.diagnose(*example())
    assert result.beyond is not None
    assert result.beyond.catalogue is not None
    name, error = result.beyond.catalogue
    assert name == "link_compliance + frame_compliance.compliance_y"
    assert f"(the root of chi2 per degree of freedom, {error.chi2_per_dof:.0f}; p" in result.reason
