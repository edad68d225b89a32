"""The examples: the closed loop on a machine of the rig, and a structure that is not a robot."""

from __future__ import annotations

import csv
import importlib.util
from dataclasses import replace
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

import pkmodes
from helpers.diagnoses import closed_loop_example
from helpers.diagnoses.examples import example
from helpers.runs.shared import Shared
from pkmodes import read_robot, updating
from pkmodes.core.robot.robot import Robot
from pkmodes.loop.diagnosis import Measurements, diagnose
from pkmodes.loop.diagnosis.verdict.result import Diagnosis

EXAMPLES = Path(__file__).parents[3] / "examples"
ROBOT, MEASURED = (EXAMPLES / "closed_loop" / name for name in ("robot.toml", "measured.csv"))


def rows(text: str) -> list[list[str]]:
    return list(csv.reader(line for line in text.splitlines() if not line.startswith("#")))


def test_the_example_is_reproduced_by_the_rig() -> None:
    assert ROBOT.read_text(encoding="utf-8") == closed_loop_example.robot_text()
    committed, made = (
        rows(text) for text in (MEASURED.read_text(encoding="utf-8"), closed_loop_example.measured_text())
    )
    assert committed[0] == made[0]
    assert [row[0] for row in committed] == [row[0] for row in made]
    numbers, again = (np.array([row[1:] for row in table[1:]], dtype=float) for table in (committed, made))
    np.testing.assert_allclose(numbers, again, rtol=1e-6)


def test_the_loop_closes(tmp_path: Path, shared: Shared) -> None:
    robot, data = read_robot(ROBOT), updating.read(MEASURED)
    found = example(shared, "closed_loop")
    assert found.verdict == "effect_found", found.reason
    (cause,) = found.effects
    assert cause.name == "gearbox_compliance"
    (compliance,) = cause.parameters
    assert abs(compliance.value - closed_loop_example.COMPLIANCE) < 3.0 * compliance.sigma
    for nuisance in found.refitted:
        truth = nuisance.before * closed_loop_example.ERRORS[nuisance.name.replace(".", "_")]
        assert abs(nuisance.after - truth) < 3.0 * nuisance.sigma, nuisance.name
    assert found.before
    assert found.refit
    assert found.after
    stages = [stage.rms_relative for stage in (found.before, found.refit, found.after)]
    assert None not in stages
    assert stages == sorted(stages, reverse=True)  # type: ignore[type-var]
    assert found.after.chi2_per_dof < 1.5 < found.refit.chi2_per_dof < found.before.chi2_per_dof

    corrected = tmp_path / "corrected.toml"
    updating.save_robot(robot, found, corrected)
    saved = read_robot(corrected)
    (table,) = saved.covariance
    assert list(table.paths) == [value.name for value in found.corrected]
    for value in found.corrected:
        assert saved.quantities[value.name].sigma == pytest.approx(value.saved_sigma, rel=1e-2)
    assert 0.5 < squared_part(saved, found, data) < len(table.paths)
    alone = replace(saved, covariance=())
    assert squared_part(alone, found, data) > 100.0

    again = updating.diagnose(saved, data)
    assert again.verdict == "adequate", again.reason
    twice = tmp_path / "twice.toml"
    updating.save_robot(saved, again, twice)
    (after,) = read_robot(twice).covariance
    assert set(after.paths) == set(table.paths)
    assert 0.25 < squared_part(read_robot(twice), again, data) < len(table.paths)


def squared_part(robot: Robot, found: Diagnosis, data: Measurements) -> float:
    """Return the sum over the fitted rows of the squared sigmas of prediction, relative to those of measurement.

    With the covariance of a least-squares fit it is the trace of its projection onto these data: at most the number
    of fitted values, whatever the model is, and less as far as shapes and priors determine them.
    """
    fitted = [i for i, row in enumerate(found.rows) if not (row.held_out or row.outlier)]
    sigmas = pkmodes.Model(robot).frequency_sigmas(data.points)
    rigid = sigmas.shape[1] - np.isfinite(sigmas[0]).sum()
    modes = found.stages.after if found.stages.after is not None else found.stages.refit
    own = sigmas[data.pose[fitted], rigid + modes.partner_mode[fitted] - 1]
    return float(np.sum((own / data.sigma[fitted]) ** 2))


@pytest.fixture(scope="module")
def lumped() -> ModuleType:
    """The example of a structure that is not a robot."""
    specification = importlib.util.spec_from_file_location("lumped", EXAMPLES / "lumped_structure.py")
    assert specification
    assert specification.loader
    example = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(example)
    return example


def test_a_lumped_structure_uses_the_same_engine(lumped: ModuleType) -> None:
    found = diagnose(lumped.structure, lumped.measure(np.random.default_rng(1)))
    assert found.verdict == "effect_found"
    assert [cause.name for cause in found.effects] == ["brace 2"]
    assert found.effects[0].parameters[0].value == pytest.approx(
        6.0e4, abs=3 * found.effects[0].parameters[0].sigma
    )


def test_a_brace_is_found_that_nobody_has_thought_of(lumped: ModuleType) -> None:
    """The brace of the second storey is a spring of 60 kN/m between the floors that it joins."""
    found = diagnose(lumped.bare, lumped.measure(np.random.default_rng(1)), terms=True)
    assert found.verdict == "unexplained"
    assert found.beyond is not None
    assert (found.beyond.status, found.beyond.tried) == ("found", 14)
    (member,) = found.beyond.document().classes[0].members
    assert member.term == "spring:floor 1/floor 2"
    value = member.parameters["stiffness"]
    assert value.value == pytest.approx(6.0e4, abs=3.0 * value.sigma)
    assert found.reason.startswith("Not in the catalogue: a spring between floor 1 and floor 2, ")
