"""Shapes as data of a fit: residuals, derivatives, and decisions that frequencies alone do not allow."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy import stats
from scipy.linalg import eigh

import pkmodes
from helpers.diagnoses.robot_structures import declared, index, suspected
from helpers.robots.small_structures import columns, each, in_a_row, normalised
from pkmodes.loop.diagnosis import MatrixStructure, Measurements, Parameter, Prediction, diagnose
from pkmodes.loop.diagnosis.criteria import Criteria
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Hypothesis
from pkmodes.loop.diagnosis.fit.shapes import ShapeRows
from pkmodes.loop.diagnosis.match.pairing import Pairing
from pkmodes.loop.updating.channels import channels
from pkmodes_rig.robots import POSES, read

CRITERIA = Criteria()


def rows(shapes: np.ndarray, frequency: np.ndarray, sigma: float | None, scatter: float = 0.05) -> ShapeRows:
    data = Measurements.from_rows(
        ["A"] * len(shapes),
        frequency,
        0.001 * frequency,
        shapes=columns(shapes, "c", 0),
        shape_sigma=None if sigma is None else np.full(len(shapes), sigma),
    )
    channels = shapes.shape[1]
    return ShapeRows(data, np.arange(channels), ["m"] * channels, np.ones((1, channels)), scatter, CRITERIA)


def paired(shapes: np.ndarray, frequency: np.ndarray) -> tuple[Prediction, Pairing, np.ndarray]:
    prediction = Prediction((2 * np.pi * frequency[None]) ** 2, np.zeros((1, len(shapes), 0)), shapes[None])
    count = len(shapes)
    return prediction, Pairing(np.arange(count), np.full(count, np.nan)), np.ones(count, dtype=bool)


@pytest.mark.parametrize("gap", [0.3, 0.01])
def test_the_squares_of_true_shapes_are_chi_square_with_one_degree_less_for_each_mode_compared(
    gap: float,
) -> None:
    rng = np.random.default_rng(1)
    modes, frequency = rng.standard_normal((2, 5)), 10.0 * np.exp([0.0, gap])
    modes /= np.abs(modes).max(axis=1, keepdims=True)
    squares = []
    for _ in range(400):
        measured = modes.copy()
        if gap < CRITERIA.pairing.mixed:  # any mixture of the two
            measured = rng.standard_normal((2, 2)) @ modes
        measured /= np.abs(measured).max(axis=1, keepdims=True)
        measured = (measured + 0.01 * rng.standard_normal(measured.shape)) * rng.normal(0.0, 50.0, (2, 1))
        data = rows(measured, frequency, 0.01)
        left = data.residual(*paired(modes, frequency)) / data.sigma
        squares += list((left**2).sum(axis=1))
    count = 5 - (1 if gap > CRITERIA.pairing.mixed else 2)
    assert data.count.tolist() == [count, count]
    assert stats.kstest(squares, "chi2", (count,)).pvalue > 1e-3
    assert np.mean(squares) == pytest.approx(count, rel=0.1)


def test_the_mac_is_what_the_residual_leaves_of_a_shape() -> None:
    rng = np.random.default_rng(2)
    model, measured = rng.standard_normal((2, 4)), rng.standard_normal((2, 4))
    measured[0, 2] = np.nan
    frequency = np.array([10.0, 20.0])
    data = rows(measured, frequency, None)
    left = data.residual(*paired(model, frequency))
    for k, seen in enumerate(np.isfinite(measured)):
        a, b = model[k, seen], measured[k, seen]
        assert 1.0 - (left[k] ** 2).sum() / ((b / np.abs(b).max()) ** 2).sum() == pytest.approx(
            (a @ b) ** 2 / (a @ a) / (b @ b)
        )


def chain(values: dict[str, float], _: str) -> tuple[np.ndarray, np.ndarray]:
    k = np.array([values[f"k{i}"] for i in range(4)])
    return np.diag([values["m"], 2.0, 1.5, 1.0]), in_a_row(k)


def chain_structure(**sigmas: float) -> MatrixStructure:
    parameters = [Parameter(f"k{i}", 1e4 * (i + 2), "N/m", sigmas.get(f"k{i}"), lower=1.0) for i in range(4)]
    parameters.append(Parameter("m", 2.0, "kg", sigmas.get("m"), lower=0.1))
    causes = each(p.name for p in parameters if p.sigma is None)
    return MatrixStructure(parameters, causes, chain, channels=[f"x{i}" for i in range(4)])


def chain_modes(changes: dict[str, float]) -> tuple[np.ndarray, np.ndarray]:
    values = {f"k{i}": 1e4 * (i + 2) for i in range(4)} | {"m": 2.0} | changes
    M, K = chain(values, "")
    eigenvalues, vectors = eigh(K, M)
    return np.sqrt(eigenvalues) / (2 * np.pi), vectors.T


def of_chain(
    frequencies: np.ndarray, shapes: np.ndarray | None = None, sigma: float | None = None
) -> Measurements:
    return Measurements.from_rows(
        ["rig"] * 4,
        frequencies,
        1e-3 * frequencies,
        shapes=None if shapes is None else columns(shapes, "x", 0),
        shape_sigma=None if sigma is None else np.full(4, sigma),
    )


#: All springs are a little uncertain.
STIFF = {"m": 0.05, **{f"k{i}": 500.0 for i in range(4)}}


def test_derivatives_of_the_residual_agree_with_differences() -> None:
    structure = chain_structure(m=0.2, k1=1e3)
    fitter = Fitter(structure, of_chain(*chain_modes({"k2": 5e4})))
    used, by = np.ones(4, dtype=bool), (0, 1, 2, 4)
    pairing = fitter.observations.pairer.pair(structure.predict(fitter.declared, ()), used)
    rates = fitter.observations.rates(structure.predict(fitter.declared, by, shape_rates=True), pairing, used)
    for column, i in enumerate(by):
        step = 1e-5 * fitter.declared[i]
        there, back = fitter.declared.copy(), fitter.declared.copy()
        there[i] += step
        back[i] -= step
        difference = fitter.observations.residual(structure.predict(there, ()), pairing, used)
        difference = (
            difference - fitter.observations.residual(structure.predict(back, ()), pairing, used)
        ) / (2 * step)
        # The derivative with the model's shape held in its own direction: what is along it is not fitted.
        frequency = fitter.observations.frequency_slice
        assert -rates[frequency, column] == pytest.approx(difference[frequency], rel=1e-6)
        residual = fitter.observations.residual(structure.predict(fitter.declared, ()), pairing, used)
        exact = (
            difference[fitter.observations.data_slice("shape")]
            @ residual[fitter.observations.data_slice("shape")]
        )
        assert -rates[fitter.observations.data_slice("shape"), column] @ residual[
            fitter.observations.data_slice("shape")
        ] == pytest.approx(exact, rel=1e-4)


@pytest.mark.parametrize("effects", [{}, {"gearbox_compliance.compliance": 1e-4, "payload.mass": 0.3}])
def test_the_shape_rates_of_a_robot_are_those_of_nelsons_linear_systems(effects: dict[str, float]) -> None:
    robot = replace(read("asymmetric"), effects=effects)
    points = np.array(POSES["asymmetric"]["scattered"][:3])
    structure = suspected(robot, points)
    values = declared(structure)
    paths = [p.name for p in structure.parameters if not p.name.startswith("measurement.")]
    known = [i for i, name in enumerate(paths) if name.count(".") < 3 or not name.startswith("effects.")]
    found = structure.predict(values, known, shape_rates=True)
    model = pkmodes.Model(robot)
    expected = model.sensitivities(points, [paths[i] for i in known])
    columns = [list(channels(model.mechanism)).index(name) for name in model.coordinates]
    signs = np.sign((found.shapes[..., columns] * model.modes(points).shapes).sum(axis=-1))
    assert found.shape_rates is not None
    for t in range(len(known)):
        theirs = expected.shapes[:, t] * signs[..., None]
        ours = found.shape_rates[..., columns, t]
        scale = np.abs(theirs[:, 3:]).max(axis=(1, 2), keepdims=True) + 1e-12
        assert ours[:, 3:] / scale == pytest.approx(theirs[:, 3:] / scale, abs=1e-6)


def test_a_platforms_shape_rates_agree_with_differences() -> None:
    robot = read("tower")
    points = np.array(POSES["tower"]["scattered"][:2])
    structure, step = suspected(robot, points), 1e-6
    for name in ("link.length", "axis.joint_radius", "measurement.yaw"):
        a, b = (
            structure.predict(declared(structure, {name: sign * step}), ()).shapes[:, 3:, -3:]
            for sign in (1, -1)
        )
        at = structure.predict(declared(structure), (index(structure, name),), shape_rates=True)
        assert at.shape_rates is not None
        own = at.shapes[:, 3:, -3:]
        a, b = (s * np.sign((s * own).sum(axis=-1, keepdims=True)) for s in (a, b))
        scale = np.abs((a - b) / (2 * step)).max()
        assert at.shape_rates[:, 3:, -3:, 0] / scale == pytest.approx((a - b) / (2 * step) / scale, abs=1e-5)


def test_shapes_distinguish_causes_that_explain_the_frequencies_equally_well() -> None:
    """A symmetric chain of equal masses: its frequencies do not tell which spring is soft."""

    def matrices(values: dict[str, float], _: str) -> tuple[np.ndarray, np.ndarray]:
        k = 1e4 * np.array([1.0, 1.0 + values["a"], 1.0, 1.0, 1.0 + values["b"], 1.0])
        K = in_a_row(k[:-1])
        K[-1, -1] += k[-1]
        return np.eye(5), K

    parameters = [Parameter("a", 0.0, lower=-0.9), Parameter("b", 0.0, lower=-0.9)]
    structure = MatrixStructure(parameters, each("ab"), matrices, channels=[f"x{i}" for i in range(5)])
    M, K = matrices({"a": 0.0, "b": -0.15}, "")
    eigenvalues, vectors = eigh(K, M)
    rng = np.random.default_rng(4)
    f = np.sqrt(eigenvalues) / (2 * np.pi) * (1 + 0.002 * rng.standard_normal(5))
    shapes = vectors.T + 0.01 * rng.standard_normal((5, 5))
    without, found = (
        diagnose(structure, Measurements.from_rows(["rig"] * 5, f, 0.002 * f, shapes=given), holdout=())
        for given in (None, columns(shapes, "x", 0))
    )
    assert without.verdict != "effect_found" or set(without.effects[0].members) == {"a", "b"}
    assert [e.members for e in found.effects] == [("b",)]
    relative = 0.01 / np.abs(vectors).max(axis=0)
    assert found.shape_scatter == pytest.approx(np.sqrt(np.mean(relative**2)), rel=0.4)


def test_a_stated_error_of_shapes_is_tested_and_one_that_is_not_is_estimated() -> None:
    structure, (frequencies, shapes) = chain_structure(**STIFF), chain_modes({})
    noisy = normalised(shapes.T) + 0.1 * np.random.default_rng(7).standard_normal((4, 4))

    def verdict(sigma: float | None) -> str:
        return diagnose(structure, of_chain(frequencies, noisy, sigma), holdout=()).verdict

    assert verdict(0.1) == "adequate"
    assert verdict(None) == "adequate"
    assert verdict(0.01) != "adequate"


def test_a_model_whose_shapes_disagree_is_not_adequate() -> None:
    frequencies, shapes = chain_modes({})
    shapes = shapes[[1, 0, 2, 3]]  # two of them exchanged: other modes than the frequencies say
    found = diagnose(chain_structure(**STIFF), of_chain(frequencies, shapes), holdout=())
    assert found.verdict == "unexplained"
    assert any("shapes" in note for note in found.notes)


def test_a_hypothesis_is_a_mixture_of_close_modes_of_which_one_was_missed() -> None:
    """Two modes 0.1 % apart, one measured: its shape may be anything between them."""
    modes, frequency = np.eye(4)[:2], np.array([10.0, 10.01])
    prediction = Prediction((2 * np.pi * frequency[None]) ** 2, np.zeros((1, 2, 0)), modes[None])
    data = rows(np.array([[1.0, -0.8, 0.0, 0.0]]), np.array([10.0]), 0.01)
    used, pairing = np.ones(1, dtype=bool), Pairing(np.array([0]), np.array([np.nan]))
    assert data.residual(prediction, pairing, used) == pytest.approx(0.0, abs=1e-12)
    apart = Prediction((2 * np.pi * np.array([[10.0, 11.0]])) ** 2, np.zeros((1, 2, 0)), modes[None])
    assert np.abs(data.residual(apart, pairing, used)).max() == pytest.approx(0.8)


def test_without_shapes_the_data_are_the_frequencies() -> None:
    fit = Fitter(chain_structure(m=0.1), of_chain(chain_modes({})[0])).fit(Hypothesis())
    assert fit is not None
    assert fit.residual.shape == (4,)
    assert fit.white.shape == (5,)


def test_shapes_are_not_taken_for_better_than_sensors_are() -> None:
    """A sensitivity off by half a per cent, beside an identification that leaves 1e-4 open."""
    modes, frequency = np.array([[1.0, -0.6, 0.3], [0.2, 1.0, 0.8]]), np.array([10.0, 20.0])
    data = rows(modes * [1.005, 1.0, 1.0], frequency, 1e-4)
    left = data.residual(*paired(modes, frequency)) / data.sigma
    assert np.abs(left).max() < 1.0
    np.testing.assert_array_equal(rows(modes, frequency, 0.02).sigma, 0.02)


def test_a_machine_that_settles_anew_turns_shapes_as_far_as_is_allowed_for() -> None:
    """Springs of three masses scatter: how far their shapes turn, by NumPy, against the angle by the errors."""
    rng = np.random.default_rng(3)
    stiffness = np.array([1.0, 0.06, 1.02, 0.6])

    def modes(k: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        K = np.array([[k[0] + k[1], -k[1], 0.0], [-k[1], k[1] + k[2], 0.0], [0.0, 0.0, k[3]]])
        values, vectors = np.linalg.eigh(K)
        return np.sqrt(values), (vectors / np.abs(vectors).max(axis=0)).T

    frequency, shapes = modes(stiffness)
    drawn = [modes(stiffness * (1.0 + 0.008 * rng.standard_normal(4))) for _ in range(300)]
    drawn = [(f, s * np.sign((s * shapes).sum(axis=1, keepdims=True))) for f, s in drawn]
    errors = np.std([f / frequency for f, _ in drawn], axis=0)
    turned = np.sqrt(np.mean([((s - shapes) ** 2).sum(axis=1) for _, s in drawn], axis=0))
    data = Measurements.from_rows(
        ["A"] * 3,
        frequency,
        errors * frequency,
        shapes=columns(shapes, "c", 0),
        shape_sigma=np.full(3, 1e-4),
    )
    found = ShapeRows(data, np.arange(3), ["m"] * 3, np.ones((1, 3)), 0.05, CRITERIA)
    pair = np.argsort(turned)[1:]  # the third mass is on its own
    assert turned[pair].min() > 2.0 * CRITERIA.shapes.least_sigma
    np.testing.assert_allclose(np.log(found.sigma[pair, 0] / turned[pair]), 0.0, atol=np.log(2.0))
