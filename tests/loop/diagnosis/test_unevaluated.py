"""Fits blocked by values without matrices are reported: they are no evidence against a cause."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np
import pytest

from helpers.diagnoses.robot_structures import declared
from helpers.robots.small_structures import LOADS, STIFFNESS, altered, frame, frame_matrices, frame_measured
from pkmodes.loop.diagnosis import Criteria, MatrixStructure, Measurements, diagnose, update
from pkmodes.loop.diagnosis.criteria import FitCriteria
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Hypothesis
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.verdict.unevaluated import unevaluated


def walled(wall: Callable[[Mapping[str, float]], bool]) -> MatrixStructure:
    """A frame that cannot be evaluated beyond a limit value."""
    plain, matrices = frame(LOADS), frame_matrices(4, LOADS)

    def some(values: Mapping[str, float], setup: str) -> tuple[np.ndarray, np.ndarray]:
        M, K = matrices(values, setup)
        return M, K * (np.nan if wall(values) else 1.0)

    return altered(plain, some)


def measured(**truth: float) -> Measurements:
    return frame_measured(
        LOADS, {name.replace("_", " "): value for name, value in truth.items()}, np.random.default_rng(1)
    )


def stopped(notes: tuple[str, ...]) -> list[str]:
    return [note for note in notes if "could not be followed" in note]


@pytest.mark.parametrize(("wall", "shown"), [(8e4, "8e4"), (1e5, "1e5"), (1e3, "1000")])
def test_a_cause_whose_fit_is_blocked_is_named(wall: float, shown: str) -> None:
    # From 1e3 on no start of its fit can be evaluated.
    result = diagnose(walled(lambda values: values["brace 2"] > wall), measured(brace_2=1.6e5))
    assert result.verdict != "effect_found"
    expected = f"brace 2 could not be followed above {shown} N/m: the model cannot be evaluated there"
    assert stopped(result.notes) == [expected]


@pytest.mark.parametrize("wall", [1.75e5, 3e5])
def test_a_wall_beyond_the_solution_is_not_mentioned(wall: float) -> None:
    result = diagnose(walled(lambda values: values["brace 2"] > wall), measured(brace_2=1.6e5))
    assert [found.name for found in result.effects] == ["brace 2"]
    assert not stopped(result.notes)


def test_a_cause_that_would_not_matter_is_not_mentioned() -> None:
    wall = {"brace 1": 1e3, "brace 3": 1e3}
    structure = walled(lambda values: any(values[name] > most for name, most in wall.items()))
    result = diagnose(structure, measured(brace_2=1.6e5))
    assert [found.name for found in result.effects] == ["brace 2"]
    assert not stopped(result.notes)


def test_a_step_that_is_too_long_is_not_reported_as_blocked() -> None:
    # From 1.5 times the stiffness a linear model leads to 1.5 (1 - ln 1.5) = 0.89, and the answer is 1.
    structure, data = walled(lambda values: values["storey"] < 0.95 * STIFFNESS), measured()
    fitter, far = Fitter(structure, data), declared(structure)
    far[1] = 1.5 * STIFFNESS
    (descent,) = Fitter(structure, data, Criteria(fits=FitCriteria(rough_steps=0))).rough_descents(
        [(Hypothesis(), far)]
    )
    fit = fitter.rough_fit(Hypothesis(), descent)
    assert fit is not None
    assert fit.values[1] == 1.5 * STIFFNESS
    assert not list(unevaluated(FitStore(fitter), fit))


def test_a_blocked_nuisance_is_named_too() -> None:
    wall = 0.97 * STIFFNESS
    structure = walled(lambda values: values["storey"] < wall)
    data = measured(storey=0.92 * STIFFNESS)
    assert wall == 3.88e5
    text = "the fit could not be followed to storey below 3.88e5 N/m: the model cannot be evaluated there"
    assert text in diagnose(structure, data).notes
    notes = update(structure, data, ["mass", "storey"]).notes
    assert stopped(notes) == [text.replace("the fit", "update")]
    assert not stopped(update(walled(lambda values: False), data, ["mass", "storey"]).notes)
