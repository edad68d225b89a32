"""Every robot that a diagnosis of the suites saves is read back, and needs no further cause.

One case in many is run every time; with ``--whole-suites`` all of them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from pkmodes import read_robot, updating
from pkmodes.core.robot.robot import Robot
from pkmodes.core.support.covariance import priors_of
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.loop.measured.measurements import Measurements
from studies import clear_cases, six_legged_suites
from studies.deciding import SUITES
from studies.specimens import MACHINES, text_of

#: The suites, and which share of their cases is run every time: one in this many.
CASES: dict[str, tuple[Callable[[], Iterator[Any]], Callable[[Any], Any], int]] = {
    "six legs": (six_legged_suites.cases, clear_cases.run, 40),
    "clear": (*SUITES["clear"], 120),
    "mechanisms": (*SUITES["mechanisms"], 140),
    "diagnosis": (*SUITES["diagnosis"], 400),
    "damping": (*SUITES["damping"], 120),
}
Diagnosed = tuple[Robot, Measurements, Diagnosis]


@pytest.fixture
def diagnosed(monkeypatch: pytest.MonkeyPatch) -> list[Diagnosed]:
    """What the suites diagnose in a test, in their order."""
    found: list[Diagnosed] = []
    diagnose = updating.diagnose

    def keeping(robot: Robot, data: Measurements, *more: Any, **options: Any) -> Diagnosis:
        diagnosis = diagnose(robot, data, *more, **options)
        found.append((robot, data, diagnosis))
        return diagnosis

    monkeypatch.setattr(updating, "diagnose", keeping)
    return found


@pytest.mark.slow
@pytest.mark.compiler
@pytest.mark.parametrize("suite", CASES)
def test_a_saved_robot_is_read_back_and_needs_no_further_cause(
    suite: str, diagnosed: list[Diagnosed], tmp_path: Path, pytestconfig: pytest.Config
) -> None:
    cases, run, every = CASES[suite]
    chosen = list(cases())
    if not pytestconfig.getoption("whole_suites"):
        chosen = chosen[every // 3 :: every]
    texts = {read(tmp_path, text).name: text for text in map(text_of, MACHINES)}
    wrong, saved = [], 0
    for case in chosen:
        diagnosed.clear()
        run(case)
        for robot, data, diagnosis in list(diagnosed):
            text = texts.get(robot.name)
            if text is None or not correctable(diagnosis):
                continue
            declared = read(tmp_path, text)
            if declared.declared != robot.declared:  # the case declares something else
                continue
            saved += 1
            if why := flaw(declared, data, diagnosis, tmp_path / "saved.toml"):
                wrong.append(f"{case.label}: {why}")
    assert saved
    assert not wrong, "\n".join(wrong)


def read(folder: Path, text: str) -> Robot:
    file = folder / "robot.toml"
    file.write_text(text, encoding="utf-8")
    return read_robot(file)


def correctable(diagnosis: Diagnosis) -> bool:
    """Whether all that was found is something in the robot, and something was found or refitted."""
    causes = [effect.name for effect in diagnosis.effects]
    of_robot = [value for value in diagnosis.corrected if not value.name.startswith("measurement.")]
    return diagnosis.settled and bool(of_robot) and not any(map(of_measurement, causes))


def of_measurement(cause: str) -> bool:
    return cause.startswith("measurement:")


def flaw(robot: Robot, data: Measurements, diagnosis: Diagnosis, file: Path) -> str:
    """What is wrong with the robot that a diagnosis saves; empty if nothing is."""
    updating.save_robot(robot, diagnosis, file)
    corrected = read_robot(file)
    for table in corrected.covariance:
        own = [corrected.quantities[path].sigma or 0.0 for path in table.paths]
        if table.sigmas is not None and (np.array(own) < np.array(table.sigmas) * (1.0 - 1e-12)).any():
            return f"a sigma is smaller than that of its table: {own}, {table.sigmas}"
    for path, prior in priors_of(corrected).items():
        if any(abs(rate) > 1.0 for _, rate in prior.correlated):
            return f"a correlation of {path} is beyond 1: {prior.correlated}"
    updating.compare(corrected, data)
    again = updating.diagnose(corrected, data)
    return "" if again.verdict == "adequate" else f"{again.verdict}: {again.reason}"
