"""With few data the diagnosis abstains: it does not claim a cause, set rows aside, or call the model adequate."""

from __future__ import annotations

import re

import numpy as np
import pytest
from scipy import stats

from helpers.robots.small_structures import (
    columns,
    of_signatures,
    relative_frame,
    relative_modes,
    with_changes,
)
from pkmodes.loop.diagnosis import Diagnosis, MatrixStructure, Measurements, diagnose


def four_storeys(prior: float = 0.1) -> MatrixStructure:
    return relative_frame(prior, lambda name: 0.1 if name.startswith("storey") else 0.01, lower=0.05)


def measured(
    truth: dict[str, float], *, sigma: float = 0.005, noise: float = 0.02, seed: int = 0, shapes: bool = True
) -> Measurements:
    rng, (f, modes) = np.random.default_rng(seed), relative_modes(truth)
    f = f * np.exp(0.002 * rng.standard_normal(4))
    found = columns(modes + noise * rng.standard_normal(modes.shape)) if shapes else None
    return Measurements.from_rows(["frame"] * 4, f, sigma * f, shapes=found)


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
    signatures = {f"c{k}": one for k, one in enumerate(np.moveaxis(G, -1, 0))}
    model = of_signatures(signatures, *G.shape[:2])
    return diagnose(model, with_changes(model, y), holdout=(), **options)


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
    signatures = {"n": np.array([1.0, 1.0]), "a": np.array([1.0, -1.0]), "b": np.array([0.0, 0.01])}
    model = of_signatures(signatures, 1, 2, known={"n": {"sigma": 1.0}})
    model_of = {"fits": [0.5, 0.5], "contradicts": [3.5, -3.5], "contradicts plainly": [12.0, -12.0]}
    for kind, change in model_of.items():
        found = diagnose(model, with_changes(model, np.array(change)), holdout=())
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
