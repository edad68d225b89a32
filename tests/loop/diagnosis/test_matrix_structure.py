"""Structures given by callables: modes and derivatives against closed forms, and values that cannot be evaluated."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from scipy import stats

from helpers.diagnoses.robot_structures import declared
from helpers.robots.small_structures import LOADS, frame
from pkmodes.loop.diagnosis import Candidate, MatrixStructure, Measurements, Parameter, compare
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Hypothesis

MASS, STIFFNESS, STOREYS = 20.0, 4.0e5, 4


def uniform(unit: float = 1.0, exact: bool = True) -> MatrixStructure:
    return frame({"empty": 0.0}, unit=unit, exact=exact)


def closed_form() -> tuple[np.ndarray, np.ndarray]:
    """Eigenvalues and mass-normalised shapes of n equal masses and springs in a row, one end on the ground."""
    j = np.arange(1, STOREYS + 1)[:, None]
    angle = (2 * j - 1) * np.pi / (2 * STOREYS + 1)
    shapes = np.sin(np.arange(1, STOREYS + 1) * angle) * 2.0 / np.sqrt(MASS * (2 * STOREYS + 1))
    return 4.0 * STIFFNESS / MASS * np.sin(angle[:, 0] / 2) ** 2, shapes


def closed_rates() -> np.ndarray:
    """d lambda / dp of the frame: phi^T (dK - lambda dM) phi, with the stretch of each spring."""
    eigenvalues, shapes = closed_form()
    stretch = np.diff(np.hstack([np.zeros((STOREYS, 1)), shapes]), axis=1)
    return np.column_stack(
        [-eigenvalues / MASS, eigenvalues / STIFFNESS, -eigenvalues * shapes[:, 0] ** 2, stretch**2]
    )


@pytest.mark.parametrize("exact", [True, False])
def test_modes_and_their_derivatives_are_those_of_the_closed_form(exact: bool) -> None:
    structure = uniform(exact=exact)
    found = structure.predict(declared(structure), range(7))
    eigenvalues, shapes = closed_form()
    assert found.eigenvalues[0] == pytest.approx(eigenvalues, rel=1e-12)
    assert np.abs(found.shapes[0]) == pytest.approx(np.abs(shapes), rel=1e-9)
    # Differences that change the matrices by a millionth: rounding and curvature are each some 1e-9.
    assert found.rates[0] == pytest.approx(closed_rates(), rel=1e-10 if exact else 1e-7, abs=1e-10)
    assert found.log_frequencies[0] == pytest.approx(np.log(np.sqrt(eigenvalues) / (2 * np.pi)))
    # A factor of the stiffness changes ln f by half its logarithm, one of the mass by minus that.
    assert found.log_rates[0, :, 0] == pytest.approx(-0.5 / MASS, rel=1e-7)
    assert found.log_rates[0, :, 1] == pytest.approx(0.5 / STIFFNESS, rel=1e-7)


@pytest.mark.parametrize("unit", [1e-12, 1e-3, 1.0, 1e3, 1e9])
def test_differences_are_as_good_in_any_unit(unit: float) -> None:
    # Causes are absent, at 0: only the matrices determine what a small step is.
    structure = uniform(unit, exact=False)
    found = structure.predict(declared(structure), range(7))
    assert found.rates[0] * unit == pytest.approx(closed_rates(), rel=1e-7, abs=1e-10)


@pytest.mark.parametrize("value", [1e-21, 1e-6, 1.0, 1e4])
def test_differences_do_not_depend_on_how_small_a_value_is(value: float) -> None:
    structure, exact = uniform(exact=False), uniform()
    values = declared(structure)
    values[3:] = value
    assert structure.predict(values, range(7)).rates == pytest.approx(
        exact.predict(values, range(7)).rates, rel=1e-6, abs=1e-10
    )


def single(
    K: Callable[[float], float], lower: float = -np.inf, upper: float = np.inf, value: float = 0.0
) -> MatrixStructure:
    return MatrixStructure(
        [Parameter("x", value, lower=lower, upper=upper)],
        [],
        lambda values, _: (np.eye(1), np.array([[K(values["x"])]])),
        channels=["only"],
    )


@pytest.mark.parametrize(
    ("K", "value", "expected"),
    [
        (lambda c: 1.0 / (1e-8 + c), 0.0, -1e16),  # a compliance in series with a spring of 1e8 N/m
        (lambda c: 1.0 / (1e-8 + c), 3e-8, -1.0 / (4e-8) ** 2),
        (lambda b: 1e9 + b**3, 1e3, 3e6),  # a thickness
        (lambda t: 1e5 * np.exp(-t / 300.0), 0.0, -1e5 / 300.0),  # a temperature
        (lambda b: 1.0, 0.0, 0.0),  # nothing at all
    ],
)
@pytest.mark.parametrize("side", ["inside", "lower", "upper"])
def test_differences_follow_nonlinear_matrices_and_stay_within_the_bounds(
    K: Callable[[float], float], value: float, expected: float, side: str
) -> None:
    lower, upper = value if side == "lower" else -np.inf, value if side == "upper" else np.inf

    def within(x: float) -> float:
        assert lower <= x <= upper
        return K(x)

    structure = single(within, lower, upper, value)
    # At a bound the difference is one-sided, with an error of the size of the step, a millionth of K.
    found = structure.predict(np.array([value]), (0,)).rates[0, 0, 0]
    assert found == pytest.approx(expected, rel=1e-7 if side == "inside" else 1e-4)


def test_a_step_that_is_right_as_declared_may_be_lost_elsewhere() -> None:
    # At 0 a step of 1e-17 changes K by a millionth; at 1 that is nothing.
    structure = single(lambda x: 1.0 + 1e11 * x if x < 0.5 else 1e11 + x, lower=0.0)
    assert structure.predict(np.zeros(1), (0,)).rates[0, 0, 0] == pytest.approx(1e11, rel=1e-4)
    assert structure.predict(np.array([1e8]), (0,)).rates[0, 0, 0] == pytest.approx(1.0, rel=1e-4)


def test_a_first_step_may_be_far_too_large() -> None:
    structure = single(lambda x: 1.0 + 1e9 * x if abs(x) < 1e-9 else np.inf)
    assert structure.predict(np.zeros(1), (0,)).rates[0, 0, 0] == pytest.approx(1e9, rel=1e-7)


def test_a_free_coordinate_may_be_held_by_a_cause() -> None:
    structure = MatrixStructure(
        [Parameter("ties", 0.0, lower=0.0)],
        [],
        lambda values, _: (np.eye(2), np.diag([values["ties"], 1e10])),
        channels=["a", "b"],
    )
    rates = structure.predict(np.zeros(1), (0,)).rates[0, :, 0]
    assert rates == pytest.approx([1.0, 0.0], abs=1e-9)


def test_a_parameter_of_one_setup_has_no_effect_in_the_other() -> None:
    structure = MatrixStructure(
        [Parameter("load", 0.0, "kg", lower=0.0)],
        [],
        lambda values, setup: (
            np.eye(2) * (2.0 + (values["load"] if setup == "B" else 0.0)),
            np.diag([1.0, 4.0]),
        ),
        channels=["a", "b"],
        setups=["A", "B"],
    )
    rates = structure.predict(np.zeros(1), (0,)).log_rates
    assert rates[0].tolist() == [[0.0], [0.0]]
    assert rates[1] == pytest.approx(-0.25, rel=1e-5)


def test_derivatives_of_all_parameters_in_any_order() -> None:
    structure = frame(LOADS)
    values = declared(structure)
    every = structure.predict(values, range(7))
    some = structure.predict(values, (5, 0, 2))
    assert some.rates == pytest.approx(every.rates[..., [5, 0, 2]])
    assert structure.predict(values, ()).rates.shape == (2, 4, 0)


def test_predictions_do_not_depend_on_earlier_ones() -> None:
    structure = frame(LOADS, exact=False)
    values = declared(structure)
    first = structure.predict(values, range(7)).rates
    structure.predict(values * 1.7 + 1e3, range(7))
    assert (structure.predict(values, range(7)).rates == first).all()


def test_a_subset_is_the_structure_in_these_setups() -> None:
    structure = frame({"a": 0.0, "b": 2.0, "c": 5.0})
    values = declared(structure)
    every, some = structure.predict(values, (1,)), structure.subset([2, 0]).predict(values, (1,))
    assert (some.eigenvalues == every.eigenvalues[[2, 0]]).all()
    assert (some.rates == every.rates[[2, 0]]).all()


def test_a_singular_mass_during_a_fit_is_a_value_that_cannot_be_evaluated() -> None:
    # More than the mass of the storey may be taken away: M is negative there.
    structure = MatrixStructure(
        [Parameter("taken", 0.0, "kg")],
        [Candidate("taken", ("taken",))],
        lambda values, _: (np.diag([20.0 - values["taken"], 20.0]), np.array([[8e5, -4e5], [-4e5, 4e5]])),
        channels=["a", "b"],
        setups=["A", "B"],
    )
    # Without its mass the storey follows the roof: two springs in a row.
    assert structure.predict(np.array([20.0]), ()).eigenvalues == pytest.approx(2e5 / 20.0 * np.ones((2, 1)))
    for taken in (20.1, 25.0, np.inf):
        found = structure.predict(np.array([taken]), (0,))
        assert np.isnan(found.eigenvalues).all()
        assert np.isnan(found.log_frequencies).all()
    values = np.array([19.0])
    f = np.exp(structure.predict(values, ()).log_frequencies)
    data = Measurements.from_rows(
        ["A", "A", "B", "B"], [*f[0], *f[1]], [1e-3 * x for x in [*f[0], *f[1]]], mode=["1", "2", "1", "2"]
    )
    fitter = Fitter(structure, data)
    hypothesis = Hypothesis(structure.candidates)
    assert fitter.fit(hypothesis, np.array([21.0])) is None
    assert fitter.chi2_of_many([(hypothesis, np.array([21.0]))]) == [np.inf]
    found = fitter.fit(hypothesis, np.array([18.0]))
    assert found is not None
    assert found.values[0] == pytest.approx(19.0, abs=1e-3)


def test_one_setup_that_cannot_be_evaluated_leaves_the_others() -> None:
    structure = MatrixStructure(
        [Parameter("taken", 0.0, "kg")],
        [],
        lambda values, setup: (np.eye(1) * ((1.0 if setup == "A" else 3.0) - values["taken"]), np.eye(1)),
        channels=["a"],
        setups=["A", "B"],
    )
    found = structure.predict(np.array([2.0]), (0,))
    assert np.isnan(found.eigenvalues[0, 0])
    assert found.eigenvalues[1, 0] == pytest.approx(1.0)
    assert found.rates[1, 0, 0] == pytest.approx(1.0, rel=1e-5)


def test_a_structure_that_buckles_has_no_frequencies() -> None:
    structure = single(lambda load: 100.0 - load, value=0.0)
    assert structure.predict(np.array([75.0]), ()).log_frequencies[0, 0] == pytest.approx(
        np.log(5 / (2 * np.pi))
    )
    assert np.isnan(structure.predict(np.array([125.0]), ()).log_frequencies).all()  # not 5 / (2 pi) again
    loose = MatrixStructure(
        [],
        [],
        lambda *_: (np.eye(2), np.array([[1.0, -1.0], [-1.0, 1.0 - 1e-12]])),
        channels=["a", "b"],
        rigid=0,
    )
    assert loose.predict(np.zeros(0), ()).eigenvalues[0] == pytest.approx(
        [0.0, 2.0], abs=1e-9
    )  # only rounding


@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_matrices_that_are_not_finite_are_a_value_that_cannot_be_evaluated(bad: float) -> None:
    structure = single(lambda x: 1.0 if x < 1.0 else bad)
    assert np.isnan(structure.predict(np.array([2.0]), (0,)).eigenvalues).all()


def test_a_comparison_pairs_predictions_with_measurements() -> None:
    structure = uniform()
    eigenvalues, _ = closed_form()
    f = np.sqrt(eigenvalues) / (2 * np.pi)
    off = np.array([0.01, -0.02, 0.005])
    measured = np.append(f[[3, 0, 1]] * np.exp(off), 10 * f[3])
    found = compare(structure, Measurements.from_rows(["empty"] * 4, measured, 0.004 * measured))
    assert [row.partner for row in found.rows] == [4, 1, 2, None]
    assert [row.predicted for row in found.rows[:3]] == pytest.approx(f[[3, 0, 1]])
    assert [row.sigmas for row in found.rows[:3]] == pytest.approx(-off / 0.004)
    assert [row.residual for row in found.rows[:3]] == pytest.approx(np.expm1(-off))
    assert found.unpaired == found.rows[3:]
    assert found.rms_relative == pytest.approx(np.sqrt(np.mean(np.expm1(-off) ** 2)))
    assert found.chi2_per_dof == pytest.approx(np.mean((off / 0.004) ** 2))
    assert found.p_value == pytest.approx(stats.chi2.sf(np.sum((off / 0.004) ** 2), 3))
