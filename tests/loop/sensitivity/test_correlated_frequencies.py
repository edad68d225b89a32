"""Standard deviations of frequencies with correlated values: closed forms, robots drawn by NumPy, and differences."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import pkmodes
from pkmodes.core.robot.covariance import Covariance


def correlated(
    model: pkmodes.Model, paths: tuple[str, ...], rates: object, sigmas: tuple[float, ...] | None = None
) -> pkmodes.Model:
    """Return a model with a table of correlations."""
    matrix = tuple(map(tuple, np.asarray(rates, dtype=float).tolist()))
    table = Covariance(paths, matrix, sigmas)
    return pkmodes.Model(replace(model.robot, covariance=(table,)))


@pytest.mark.parametrize("rate", [-1.0, -0.6, 0.0, 0.3, 1.0])
@pytest.mark.parametrize("drives", ["free", "held"])
def test_stiffness_and_width_of_a_belt_have_the_closed_form(rate: float, drives: str) -> None:
    """Belts of CoreXY go with w k_sp, and f with the root: sigma_f / f = root(a^2 + b^2 + 2 r a b) / 2."""
    model = pkmodes.load("robots/corexy-printer.toml").with_values(
        {
            "toolhead.mass": {"sigma": None},
            "gantry.mass": {"sigma": None},
            "belt.specific_stiffness": {"sigma": "4 %"},
            "belt.width": {"sigma": "3 %"},
        }
    )
    paths = ("belt.width", "belt.specific_stiffness")
    one = correlated(model, paths, [[1.0, rate], [rate, 1.0]])
    pose = [0.1, 0.15]
    rigid = model.modes(pose, drives=drives).rigid_modes
    f = model.frequencies(pose, drives=drives)[rigid:]
    a, b = 0.04, 0.03
    expected = 0.5 * np.sqrt(a**2 + b**2 + 2.0 * rate * a * b) * f
    np.testing.assert_allclose(one.frequency_sigmas(pose, drives=drives)[rigid:], expected, rtol=1e-9)
    half = correlated(model, paths, [[1.0, rate], [rate, 1.0]], (0.5 * b * 0.006, 0.5 * a * _k_sp(model)))
    np.testing.assert_allclose(half.frequency_sigmas(pose, drives=drives)[rigid:], 0.5 * expected, rtol=1e-9)


def _k_sp(model: pkmodes.Model) -> float:
    return model.robot.quantities["belt.specific_stiffness"].value


SIGMAS = {
    "platform.mass": 0.03,
    "belt.width": 0.0003,
    "axis.2.joint.x": 0.0005,
    "effects.clamp_compliance.compliance": 1e-7,
    "motor.inertia": 2e-7,
}
#: Three values in one table, an effect among them; two others are independent.
TABLE = ("effects.clamp_compliance.compliance", "platform.mass", "belt.width")


@pytest.fixture(scope="module")
def delta() -> pkmodes.Model:
    plain = pkmodes.load("robots/linear-delta-2022.toml").with_values(
        {"effects.clamp_compliance.compliance": 1e-6}
    )
    model = plain.with_values({path: {"sigma": sigma} for path, sigma in SIGMAS.items()})
    return correlated(model, TABLE, [[1.0, 0.9, 0.5], [0.9, 1.0, 0.2], [0.5, 0.2, 1.0]])


def covariance() -> np.ndarray:
    """Return the covariance of SIGMAS with these correlations, in their order, by hand."""
    rates = np.eye(5)
    rates[0, 3] = rates[3, 0] = 0.9
    rates[1, 3] = rates[3, 1] = 0.5
    rates[0, 1] = rates[1, 0] = 0.2
    sizes = np.array(list(SIGMAS.values()))
    return rates * np.outer(sizes, sizes)


@pytest.mark.parametrize("drives", ["free", "held"])
@pytest.mark.usefixtures("backend")
def test_they_follow_from_differences_and_the_covariance(delta: pkmodes.Model, drives: str) -> None:
    pose = [0.6, 0.03, -0.245]
    rigid, rates = delta.modes(pose, drives=drives).rigid_modes, []
    for path, sigma in SIGMAS.items():
        value, h = delta.robot.quantities[path].value, 1e-3 * sigma
        up, down = (
            delta.with_values({path: value + step}).frequencies(pose, drives=drives)[rigid:]
            for step in (h, -h)
        )
        rates.append((up - down) / (2.0 * h))
    expected = np.sqrt(np.einsum("im,ik,km->m", rates, covariance(), rates))
    found = delta.frequency_sigmas(pose, drives=drives)
    np.testing.assert_allclose(found[rigid:], expected, rtol=1e-5)
    independent = pkmodes.Model(replace(delta.robot, covariance=()))
    assert np.abs(independent.frequency_sigmas(pose, drives=drives)[rigid:] / expected - 1.0).max() > 0.1


def test_they_are_those_of_robots_that_numpy_draws(delta: pkmodes.Model) -> None:
    """250 draws know a standard deviation to 1/sqrt(500) = 4.5 %; three times that."""
    pose, rng = [0.6, 0.03, -0.245], np.random.default_rng(251101)
    centre = [delta.robot.quantities[path].value for path in SIGMAS]
    drawn = rng.multivariate_normal(centre, covariance(), 250, method="cholesky")
    many = [delta.with_values(dict(zip(SIGMAS, row, strict=True))).frequencies(pose)[3:] for row in drawn]
    np.testing.assert_allclose(delta.frequency_sigmas(pose)[3:], np.std(many, axis=0), rtol=0.135)


def test_samples_of_a_map_have_the_correlations(delta: pkmodes.Model) -> None:
    """150 draws know a correlation to 1/sqrt(150) = 0.082, a sigma to 1/sqrt(300) = 5.8 %; three times that."""
    found = delta.map({"x": 0.6, "y": 0.03, "z": -0.245}, samples=150, seed=251102)
    drawn = np.array([found[path].values for path in SIGMAS])
    np.testing.assert_allclose(drawn.std(axis=1), list(SIGMAS.values()), rtol=0.174)
    sizes = np.array(list(SIGMAS.values()))
    np.testing.assert_allclose(np.corrcoef(drawn), covariance() / np.outer(sizes, sizes), atol=0.246)


def test_what_a_sweep_sets_says_nothing_of_the_others(delta: pkmodes.Model) -> None:
    """The other values of a table keep their own covariance, whatever the swept one is."""
    swept = delta.map(
        {"x": 0.6, "y": 0.03, "z": -0.245}, sweep={"platform.mass": [1.2, 1.8]}, samples=60, seed=251103
    )
    clamp = swept["effects.clamp_compliance.compliance"].values
    assert clamp.mean() == pytest.approx(1e-6, abs=3.0 * 1e-7 / np.sqrt(60))
    assert clamp.std() == pytest.approx(1e-7, rel=3.0 / np.sqrt(120))


def test_exactly_proportional_values_are_drawn_so(delta: pkmodes.Model) -> None:
    one = correlated(delta, ("platform.mass", "belt.width"), [[1.0, -1.0], [-1.0, 1.0]])
    found = one.map({"x": 0.6, "y": 0.0, "z": -0.245}, samples=5, seed=1)
    mass, width = (
        (found[path].values - one.robot.quantities[path].value) / SIGMAS[path]
        for path in ("platform.mass", "belt.width")
    )
    np.testing.assert_allclose(mass, -width, rtol=0.0, atol=1e-9)
    assert mass.std() > 0.1


@pytest.mark.parametrize("rate", [-1.0, 0.7, 1.0])
def test_repeated_modes_share_the_expected_mean_square(rate: float) -> None:
    """On its axis the Clavel delta has a pair; two reducers of three that err together split it less than alone.

    With a and b the relative errors of two of the three equal reducers, and each alone moving the pair's eigenvalues
    by A_i, E trace(A^2) is computed from robots with both changed: a^2, b^2 and their product by polarisation.
    """
    names = ("axis.1.reducer.stiffness", "axis.2.reducer.stiffness")
    sigmas, pose = np.array([200.0, 100.0]), [0.0, 0.0, -0.8]
    model = pkmodes.load("robots/clavel-delta.toml").with_values(
        {
            "platform.mass": {"sigma": None},
            "reducer.stiffness": {"sigma": None},
            **{name: {"value": 4000.0, "sigma": s} for name, s in zip(names, sigmas.tolist(), strict=True)},
        }
    )
    f = model.frequencies(pose)[-3:-1]

    def square(*steps: float) -> float:
        """Return the sum of squares of the pair's changes, to second order in the steps."""
        total = 0.0
        for sign in (1.0, -1.0):
            values = {n: 4000.0 + sign * 0.02 * s for n, s in zip(names, steps, strict=True)}
            total += 0.5 * float(np.sum((model.with_values(values).frequencies(pose)[-3:-1] - f) ** 2))
        return total / 0.02**2

    first, second = square(sigmas[0], 0.0), square(0.0, sigmas[1])
    product = 0.5 * (square(*sigmas) - first - second)
    expected = np.sqrt((first + second + 2.0 * rate * product) / 2.0)
    one = correlated(model, names, [[1.0, rate], [rate, 1.0]])
    found = one.frequency_sigmas(pose)[-3:-1]
    assert found[0] == found[1] == pytest.approx(expected, rel=1e-3)


def test_a_mass_that_an_effect_takes_from_the_frame_counts_once() -> None:
    """It has two names, and one error: the band of the same mass in the table of the effect, and robots to draw."""
    plain = pkmodes.load("robots/linear-delta-2022.toml").with_values(
        {"effects.frame_compliance.compliance": 1e-7}
    )
    pose = [0.6, 0.0, -0.245]
    model = plain.with_values({"frame.mass": {"value": "50 kg", "sigma": "5 kg"}})
    up, down = (model.with_values({"frame.mass": 50.0 + h}).frequencies(pose)[3:] for h in (0.05, -0.05))
    np.testing.assert_allclose(
        model.frequency_sigmas(pose)[3:], 5.0 * np.abs(up - down) / 0.1, rtol=1e-4, atol=1e-7
    )
    drawn = model.map({"x": 0.6, "y": 0.0, "z": -0.245}, samples=3, seed=5)
    assert len(set(drawn["frame.mass"].values.tolist())) == 3
