"""What was measured as data of a fit: a further quantity of measured modes is a class and an entry in a table."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy import stats
from scipy.linalg import eigh

from pkmodes.loop.diagnosis import Candidate, MatrixStructure, Measurements, Parameter, Prediction, diagnose
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Hypothesis
from pkmodes.loop.diagnosis.fit.observations import QUANTITIES, ObservationInput
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.match.pairing import Pairing, tile_indices

SIGMA, RESIDUE_SIGMA = 1e-3, 0.02
#: Stiffness of the lower storey by setup, and the true size of the structure relative to the declared one.
STOREYS, TRUE = {f"k{i}": 1e5 * (2.0 + i) for i in range(6)}, 1.25


def matrices(values: dict[str, float], setup: str) -> tuple[np.ndarray, np.ndarray]:
    """A frame of two floors: of another size, all its masses and stiffnesses are larger by one factor."""
    k1, k2 = STOREYS[setup], 3e5 * values["upper"]
    M, K = np.diag([30.0, 20.0]), np.array([[k1 + k2, -k2], [-k2, k2]])
    return values["size"] * M, values["size"] * K


def modes(values: dict[str, float]) -> tuple[np.ndarray, np.ndarray]:
    """Frequencies [Hz] and the shapes at unit modal mass, mode by mode, setup by setup."""
    every = [eigh(*reversed(matrices(values, setup))) for setup in STOREYS]
    f = np.concatenate([np.sqrt(eigenvalues) / (2.0 * np.pi) for eigenvalues, _ in every])
    return f, np.concatenate([vectors.T for _, vectors in every])


def frame() -> MatrixStructure:
    parameters = [Parameter("size", 1.0, lower=0.1), Parameter("upper", 1.0, lower=0.1)]
    each = [Candidate("size", ("size",)), Candidate("upper", ("upper",))]
    return MatrixStructure(parameters, each, matrices, channels=["lower", "upper"], setups=list(STOREYS))


@dataclass(frozen=True)
class Residues:
    """Logarithms of driving-point residues at a channel: of the squared amplitude there at unit modal mass."""

    log: np.ndarray
    sigma: np.ndarray
    pose: NDArray[np.intp]
    setups: int
    channel: int
    shape_rates = True

    @classmethod
    def of(cls, measured: ObservationInput, log: dict[int, float]) -> Residues:
        data = measured.data
        values = np.array([log[line] for line in data.lines.tolist()])
        sigma = np.full((len(values), 1), RESIDUE_SIGMA)
        return cls(values, sigma, data.pose, len(data.labels), measured.structure.channels.index("upper"))

    @property
    def known(self) -> np.ndarray:
        return np.ones(len(self.log), dtype=bool)

    stated = known

    @property
    def count(self) -> np.ndarray:
        return np.ones(len(self.log), dtype=int)

    def tiled(self, count: int) -> Residues:
        pose = tile_indices(self.pose, count, self.setups)
        return Residues(
            np.tile(self.log, count), np.tile(self.sigma, (count, 1)), pose, self.setups, self.channel
        )

    def _amplitude(self, prediction: Prediction, pairing: Pairing) -> np.ndarray:
        return prediction.shapes[self.pose, np.maximum(pairing.partner, 0), self.channel]

    def residual(self, prediction: Prediction, pairing: Pairing, used: np.ndarray) -> np.ndarray:
        log = 2.0 * np.log(np.abs(self._amplitude(prediction, pairing)))
        return np.where(used & (pairing.partner >= 0), self.log - log, 0.0)[:, None]

    def rates(self, prediction: Prediction, pairing: Pairing, used: np.ndarray) -> np.ndarray:
        if prediction.shape_rates is None:
            return np.zeros((len(self.log), 1, prediction.rates.shape[-1]))
        amplitude = self._amplitude(prediction, pairing)[:, None]
        moved = prediction.shape_rates[self.pose, np.maximum(pairing.partner, 0), self.channel]
        counts = (used & (pairing.partner >= 0))[:, None]
        return np.where(counts, 2.0 * moved / amplitude, 0.0)[:, None]


def measured(values: dict[str, float], seed: int) -> tuple[Measurements, dict[int, float]]:
    """The modes of a frame, and ln of its residues by line."""
    rng = np.random.default_rng(seed)
    f, shapes = modes(values)
    f = f * np.exp(SIGMA * rng.standard_normal(len(f)))
    pose = np.repeat(list(STOREYS), 2).tolist()
    data = Measurements.from_rows(pose, f, SIGMA * f)
    log = 2.0 * np.log(np.abs(shapes[:, 1])) + RESIDUE_SIGMA * rng.standard_normal(len(f))
    return data, dict(zip(data.lines.tolist(), log.tolist(), strict=True))


def residues() -> np.ndarray:
    """The logarithms of the residues of the declared frame, mode by mode."""
    return 2.0 * np.log(np.abs(modes({"size": 1.0, "upper": 1.0})[1][:, 1]))


def with_residues(monkeypatch: pytest.MonkeyPatch, log: dict[int, float]) -> None:
    monkeypatch.setitem(QUANTITIES, "residue", lambda measured: Residues.of(measured, log))


def test_an_added_quantity_finds_what_frequencies_and_shapes_do_not_show(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """A frame with all masses and stiffnesses 25 % larger has the same frequencies, and moves less per force."""
    data, log = measured({"size": TRUE, "upper": 1.0}, 1)
    without = diagnose(frame(), data)
    assert (without.verdict, without.effects) == ("adequate", ())
    with_residues(monkeypatch, log)
    found = diagnose(frame(), data)
    assert found.verdict == "effect_found"
    (effect,) = found.effects
    assert effect.members == ("size",)
    (value,) = effect.parameters
    assert found.probabilities is not None
    assert found.probabilities.top == (("size",), pytest.approx(0.95, abs=0.05))
    # Each of the 10 fitted residues is the squared amplitude, 1 / size: ln size has the mean error of ten rows.
    # The fitted size, not the true one, is in the sigma: the two differ by some 0.6 %.
    assert value.sigma == pytest.approx(TRUE * RESIDUE_SIGMA / np.sqrt(10.0), rel=0.02)
    assert abs(value.value - TRUE) < 3.0 * value.sigma


def test_an_added_quantity_has_degrees_and_a_p_value_of_its_own(monkeypatch: pytest.MonkeyPatch) -> None:
    data, log = measured({"size": 1.0, "upper": 1.0}, 2)
    with_residues(monkeypatch, log)
    fitter = Fitter(frame(), data)
    assert fitter.observations.size == 24
    assert fitter.observations.degrees_of_freedom(fitter.observations.all_rows) == 24
    fit = fitter.fit(Hypothesis())
    assert fit is not None
    misfit = fitter.misfit(fit, "residue", stated=True)
    left = (np.array([log[line] for line in data.lines.tolist()]) - residues()) / RESIDUE_SIGMA
    assert misfit.squares == pytest.approx(float(left @ left), rel=1e-9)
    assert misfit.degrees == 12


def test_a_contradiction_of_an_added_quantity_is_more_than_noise(monkeypatch: pytest.MonkeyPatch) -> None:
    """Residues that differ by a factor of their own at each pose are explained by nothing, and said not to be."""
    data, log = measured({"size": 1.0, "upper": 1.0}, 3)
    rng = np.random.default_rng(4)
    wrong = {line: value + 0.3 * rng.standard_normal() for line, value in log.items()}
    with_residues(monkeypatch, wrong)
    found = diagnose(frame(), data)
    assert found.verdict not in ("adequate", "effect_found")
    store = FitStore(Fitter(frame(), data))
    fit = store.fit(Hypothesis())
    assert fit is not None
    left = (np.array([wrong[line] for line in data.lines.tolist()]) - residues()) / RESIDUE_SIGMA
    away = np.log(data.frequency / modes({"size": 1.0, "upper": 1.0})[0]) / SIGMA
    assert store.frequency_p_value(fit) == pytest.approx(stats.chi2.sf(away @ away, 12), rel=1e-6)
    assert store.p_value(fit) == pytest.approx(stats.chi2.sf(left @ left, 12), rel=1e-6)


@pytest.mark.parametrize("free", ["size", "upper"])
def test_data_of_all_quantities_have_the_derivatives_of_their_differences(
    monkeypatch: pytest.MonkeyPatch, free: str
) -> None:
    data, log = measured({"size": 1.1, "upper": 1.05}, 5)
    with_residues(monkeypatch, log)
    structure = frame()
    fitter = Fitter(structure, data)
    seen, by = fitter.observations, [p.name for p in structure.parameters].index(free)
    prediction = structure.predict(fitter.declared, (by,), shape_rates=True)
    pairing = seen.pairer.pair(prediction, seen.all_rows)
    rates = seen.rates(prediction, pairing, seen.all_rows)[:, 0]
    step = 1e-5
    sides = []
    for sign in (1.0, -1.0):
        values = fitter.declared.copy()
        values[by] += sign * step
        sides.append(seen.residual(structure.predict(values, ()), pairing, seen.all_rows))
    np.testing.assert_allclose(rates, (sides[1] - sides[0]) / (2.0 * step), rtol=1e-6, atol=1e-6)


def test_copies_give_each_prediction_the_same_data(monkeypatch: pytest.MonkeyPatch) -> None:
    """Many values evaluated together have the residuals and derivatives of each alone, to rounding."""
    data, log = measured({"size": 1.0, "upper": 1.1}, 6)
    with_residues(monkeypatch, log)
    structure = frame()
    seen = Fitter(structure, data).observations
    values = np.array([[1.0, 1.0], [1.2, 1.0], [1.0, 1.3]])
    some = seen.all_rows
    some[3] = False
    together = list(seen.evaluate_many(structure, values, [(0, 1)] * 3, [seen.all_rows, some, seen.all_rows]))
    assert [one.set_index for one in together] == [0, 1, 2]
    for one in together:
        used = some if one.set_index == 1 else seen.all_rows
        alone = structure.predict(values[one.set_index], (0, 1), shape_rates=True)
        pairing = seen.pairer.pair(alone, used)
        np.testing.assert_allclose(one.residual, seen.residual(alone, pairing, used), rtol=1e-9, atol=1e-12)
        np.testing.assert_allclose(one.rates, seen.rates(alone, pairing, used), rtol=1e-6, atol=1e-9)
