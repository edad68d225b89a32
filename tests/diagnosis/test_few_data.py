"""With few data the diagnosis abstains: it does not claim a cause, set rows aside, or call the model adequate."""

from __future__ import annotations

import re

import numpy as np
import pytest
from scipy import stats
from scipy.linalg import eigh

from helpers.robots.small_structures import SIGMA, LogLinear, logs_measured
from pkmodes.diagnosis import Candidate, Diagnosis, MatrixStructure, Measurements, Parameter, diagnose

STOREYS = 4


def frame_matrices(values: dict[str, float], _: str) -> tuple[np.ndarray, np.ndarray]:
    k = 1e6 * values["stiffness"] * np.array([values[f"storey {i}"] for i in range(1, STOREYS + 1)])
    m = 100.0 * np.array([values[f"mass {i}"] for i in range(1, STOREYS + 1)])
    return np.diag(m), np.diag(k + np.append(k[1:], 0.0)) - np.diag(k[1:], 1) - np.diag(k[1:], -1)


def four_storeys(prior: float = 0.1) -> MatrixStructure:
    names = [f"{kind} {i}" for kind in ("storey", "mass") for i in range(1, STOREYS + 1)]
    parameters = [Parameter("stiffness", 1.0, sigma=prior, lower=0.1)]
    parameters += [Parameter(name, 1.0, lower=0.05) for name in names]
    causes = [Candidate(n, (n,), sigma=(0.1 if n.startswith("storey") else 0.01,)) for n in names]
    channels = [f"floor {i}" for i in range(1, STOREYS + 1)]
    return MatrixStructure(parameters, causes, frame_matrices, channels=channels)


def measured(
    truth: dict[str, float], *, sigma: float = 0.005, noise: float = 0.02, seed: int = 0, shapes: bool = True
) -> Measurements:
    values = {"stiffness": 1.0} | {f"{k} {i}": 1.0 for k in ("storey", "mass") for i in range(1, 5)} | truth
    M, K = frame_matrices(values, "")
    eigenvalues, vectors = eigh(K, M)
    rng = np.random.default_rng(seed)
    f = np.sqrt(eigenvalues) / (2 * np.pi) * np.exp(0.002 * rng.standard_normal(4))
    found = vectors.T / np.abs(vectors.T).max(axis=1, keepdims=True)
    found = found + noise * rng.standard_normal(found.shape)
    columns = {f"floor {i + 1}": found[:, i] for i in range(4)} if shapes else None
    return Measurements.from_rows(["frame"] * 4, f, sigma * f, shapes=columns)


@pytest.mark.parametrize("sigma", [0.002, 0.005, 0.01])
@pytest.mark.parametrize("prior", [0.05, 0.1, 0.15])
def test_the_cause_of_four_frequencies_and_four_shapes_does_not_depend_on_stated_errors(
    sigma: float, prior: float
) -> None:
    """A cause with wrong shapes is not claimed if another explanation fits all shapes."""
    for storey in (1, 2, 3):
        found = diagnose(four_storeys(prior), measured({f"storey {storey}": 0.75}, sigma=sigma), holdout=())
        if found.verdict == "effect_found":
            assert f"storey {storey}" in found.effects[0].members
            assert min(row.mac for row in found.rows if row.mac is not None) > 0.98
        assert found.verdict != "insufficient_data"  # sixteen values for three unknowns
        assert found.verdict != "adequate" or sigma == 0.01


def test_sixteen_values_find_a_soft_storey_and_four_abstain() -> None:
    found = diagnose(four_storeys(), measured({"storey 2": 0.75}), holdout=())
    assert [e.name for e in found.effects] == ["storey 2"]
    value = found.effects[0].parameters[0]
    assert value.value == pytest.approx(0.75, abs=3 * value.sigma)
    few = diagnose(four_storeys(), measured({"storey 2": 0.75}, shapes=False), holdout=())
    assert few.verdict != "effect_found"


def line(G: np.ndarray, y: np.ndarray, **options: object) -> Diagnosis:
    base = np.tile(np.log(10.0) + 0.35 * np.arange(G.shape[1]), (len(G), 1))
    parameters = [Parameter(f"c{k}", 0.0) for k in range(G.shape[2])]
    causes = [Candidate(p.name, (p.name,)) for p in parameters]
    model = LogLinear(base, SIGMA * G, parameters, causes)
    return diagnose(model, logs_measured(base + SIGMA * y, SIGMA), holdout=(), **options)


@pytest.mark.slow
def test_one_of_many_candidates_that_fits_a_residual_in_few_dimensions_is_not_claimed() -> None:
    """In three dimensions one of twelve directions is close to any residual; in forty dimensions none is."""
    rng = np.random.default_rng(3)

    def claimed(rows: int) -> int:
        count = 0
        for _ in range(40):
            G = rng.standard_normal((1, rows, 12))
            y = rng.standard_normal((1, rows))
            found = line(G, 20.0 * y / np.linalg.norm(y))
            count += found.verdict == "effect_found"
        return count

    assert claimed(3) == 0
    assert claimed(4) <= 1
    # The same candidates are found where they are the truth and there are data enough.
    G = rng.standard_normal((4, 10, 12))
    assert [e.name for e in line(G, 5.0 * G[..., 7]).effects] == ["c7"]


def test_a_class_of_more_than_five_members_is_not_claimed() -> None:
    rng = np.random.default_rng(4)
    g = rng.standard_normal((4, 10, 1))
    for count, verdict in ((5, "effect_found"), (6, "ambiguous")):
        G = np.concatenate(
            [g + 0.005 * rng.standard_normal((4, 10, count)), rng.standard_normal((4, 10, 2))], axis=-1
        )
        found = line(G, 5.0 * G[..., 0])
        assert found.verdict == verdict
        members = found.effects[0].members if found.effects else found.survivors[0]
        assert set(members) == {f"c{k}" for k in range(count)}


def test_with_few_data_every_pair_is_tried_and_a_mirror_pair_is_named() -> None:
    """Symmetric signatures: a + b and its mirror image have exactly the same effect."""
    rng = np.random.default_rng(5)
    a, b, c, d = rng.standard_normal((4, 12))
    mirror = (a + b) - c  # c + (a + b - c) is the same sum
    G = np.stack([a, b, c, mirror, d], axis=-1)[None]
    found = line(G, 12.0 * (a + b)[None])
    assert found.verdict == "ambiguous"
    named = {frozenset(name.split(" + ")) for names in found.survivors for name in names}
    assert {frozenset({"c0", "c1"}), frozenset({"c2", "c3"})} <= named


@pytest.mark.parametrize("rows", [2, 3, 6])
def test_a_row_is_not_set_aside_without_redundancy(rows: int) -> None:
    rng = np.random.default_rng(6)
    y = np.zeros((1, rows))
    y[0, 1] = 80.0
    found = line(rng.standard_normal((1, rows, 3)), y)
    assert found.outliers == ()
    assert found.verdict not in ("adequate", "effect_found")


def test_too_few_data_that_contradict_the_model_are_reported() -> None:
    parameters = [Parameter("n", 0.0, sigma=1.0), Parameter("a", 0.0), Parameter("b", 0.0)]
    base = np.log([[10.0, 14.0]])
    G = SIGMA * np.array([[[1.0, 1.0, 0.0], [1.0, -1.0, 0.01]]])
    causes = [Candidate("a", ("a",)), Candidate("b", ("b",))]
    model = LogLinear(base, G, parameters, causes)
    model_of = {"fits": [0.5, 0.5], "contradicts": [3.5, -3.5], "contradicts plainly": [12.0, -12.0]}
    for kind, change in model_of.items():
        found = diagnose(model, logs_measured(base + SIGMA * np.array([change]), SIGMA), holdout=())
        assert found.verdict == "insufficient_data"
        assert "2 measured modes are too few" in found.reason
        if kind == "fits":
            assert "does not contradict them" in found.reason
        else:
            squares = float(np.square(change).sum())  # the nuisance cannot do anything about a difference
            p_value = float(stats.chi2.sf(squares, 2))
            seen = re.search(r"\(p = ([\d.e-]+)\)", found.reason)
            if kind == "contradicts":
                assert seen is not None
                assert float(seen[1]) == pytest.approx(p_value, rel=0.05)  # two digits
            else:
                assert p_value < 1e-6
                assert "(p < 1e-6)" in found.reason
            assert "they would not with a" in found.reason
