"""A diagnosis does not depend on units, on the order of its data, or on chance."""

from __future__ import annotations

import numpy as np
import pytest

from helpers.diagnoses.frame_diagnoses import CANDIDATES, SIX, TWO, causes, checked, drawn, spoiled
from helpers.robots.small_structures import (
    SIGMA,
    LogLinear,
    frame,
    ladder,
    some_rows,
)
from pkmodes.loop.diagnosis import Candidate, Diagnosis, MatrixStructure, Measurements, Parameter


def assert_same(found: Diagnosis, plain: Diagnosis, unit: float = 1.0) -> None:
    """Two diagnoses make the same claims, the first in kg / unit and N/m / unit."""
    assert found.verdict == plain.verdict
    first, second = (sorted(sorted(effect.members) for effect in d.effects) for d in (found, plain))
    assert first == second
    assert sorted(found.undetectable) == sorted(plain.undetectable)
    assert sorted(row.line for row in found.outliers) == sorted(row.line for row in plain.outliers)
    assert found.scatter == pytest.approx(plain.scatter, rel=1e-3)
    assert found.refit.chi2_per_dof == pytest.approx(plain.refit.chi2_per_dof, rel=1e-5)
    expected = {v.name: v for v in plain.corrected}
    assert {v.name for v in found.corrected} == set(expected)
    for v in found.corrected:
        assert v.value / unit == pytest.approx(expected[v.name].value, abs=1e-3 * expected[v.name].sigma)
        assert v.sigma / unit == pytest.approx(expected[v.name].sigma, rel=1e-4)
    scores = {c.name: c.p_value for c in plain.candidates}
    assert {c.name: c.p_value for c in found.candidates} == pytest.approx(scores, rel=1e-4)


CASES = {
    "nothing": {},
    "one": {"brace 3": 5.0e4},
    "two": {"brace 2": 6.0e4, "first floor": 3.0},
}


LOADS = dict(list(SIX.items())[:4])


@pytest.mark.parametrize("case", list(CASES))
def test_units_do_not_matter(subtests: pytest.Subtests, case: str) -> None:
    data = drawn(LOADS, 17, CASES[case])
    plain = checked(frame(LOADS), data)
    assert causes(plain) == sorted(CASES[case])
    for unit, exact in ((1e3, True), (1e9, False), (1e-6, False)):
        with subtests.test(unit=unit):
            assert_same(checked(frame(LOADS, unit=unit, exact=exact), data), plain, unit)


@pytest.mark.parametrize("case", list(CASES))
def test_the_order_of_rows_and_of_candidates_does_not_matter(case: str) -> None:
    data = spoiled(drawn(LOADS, 18, CASES[case]), 5, 1.05)
    plain = checked(frame(LOADS), data)
    order = np.random.default_rng(0).permutation(len(data.frequency))
    rows = some_rows(data, order, lines=data.lines[order])
    assert_same(checked(frame(LOADS), rows), plain)
    for names in (CANDIDATES[::-1], CANDIDATES[2:] + CANDIDATES[:2]):
        assert_same(checked(frame(LOADS, only=names), data), plain)


def test_a_diagnosis_is_the_same_each_time() -> None:
    data = drawn(TWO, 19, {"brace 2": 6.0e4}, shapes=0.02)
    structure = frame(TWO, exact=False)
    first = checked(structure, data)
    assert checked(structure, data).as_json() == first.as_json()
    assert checked(frame(TWO, exact=False), data).as_json() == first.as_json()


def test_two_modes_of_the_same_frequency_are_handled() -> None:
    # A mast equally stiff in two directions, with an undeclared stay in one of them.
    def matrices(values, setup):
        k = values["bending"]
        tip = np.diag([k, k + values["stay"], 9.0 * k, 9.0 * k])
        return np.eye(4) * (10.0 + (2.0 if setup == "loaded" else 0.0)), tip

    parameters = [Parameter("bending", 1e4, sigma=300.0), Parameter("stay", 0.0, lower=0.0)]
    mast = MatrixStructure(
        parameters,
        [Candidate("stay", ("stay",))],
        matrices,
        channels=["x", "y", "x2", "y2"],
        setups=list(TWO),
    )
    for stay in (0.0, 800.0):
        rng = np.random.default_rng(20)
        pose, logs = [], []
        for setup in TWO:
            M, K = matrices({"bending": 1.01e4, "stay": stay}, setup)
            pose += [setup] * 4
            logs += list(0.5 * np.log(np.diagonal(K) / np.diagonal(M)) + SIGMA * rng.standard_normal(4))
        f = np.exp(logs) / (2 * np.pi)
        found = checked(mast, Measurements.from_rows(pose, f, SIGMA * f))
        assert found.verdict == ("effect_found" if stay else "adequate")
        if stay:
            assert found.effects[0].parameters[0].value == pytest.approx(stay, rel=0.2)


#: Bounds and values of parameters: free, of one sign, of either, near their bounds, away from 0.
RANGES = [(-np.inf, np.inf, 0.0), (0.0, np.inf, 0.0), (-np.inf, 0.0, 0.0), (-1.0, 1.0, 0.0), (0.1, 3.0, 1.0)]


def anything(seed: int) -> tuple[LogLinear, Measurements]:
    """A structure with any number of setups, modes, nuisances and candidates, measured with gaps and mistakes."""
    rng = np.random.default_rng([seed, 99])
    setups, modes, nuisances = rng.integers(1, 9), rng.integers(1, 7), rng.integers(0, 4)
    parameters = [Parameter(f"n{i}", rng.normal(), sigma=10 ** rng.uniform(-3, 2)) for i in range(nuisances)]
    candidates = []
    for j in range(rng.integers(0, 7)):
        names = tuple(f"p{j}.{k}" for k in range(rng.choice([1, 1, 1, 2, 3])))
        for name in names:
            lower, upper, value = RANGES[rng.integers(len(RANGES))]
            parameters.append(Parameter(name, value, lower=lower, upper=upper))
        candidates.append(Candidate(f"c{j}", names))
    base = ladder(setups, modes)
    G = rng.standard_normal((setups, modes, len(parameters))) * 10 ** rng.uniform(-5, 0, len(parameters))
    if parameters:
        G[..., rng.integers(len(parameters))] *= rng.integers(2)  # perhaps one that does nothing
        if rng.random() < 0.3:
            G[..., 0] = G[..., -1]  # and two that do the same
    if modes > 1 and rng.random() < 0.2:
        base[:, 1], G[:, 1] = base[:, 0], G[:, 0]  # and a mode that is there twice
    true = np.array([p.value for p in parameters])
    true += (rng.random(len(true)) < 0.3) * rng.standard_normal(len(true)) * 10 ** rng.uniform(-1, 1.5)
    sigma = 10 ** rng.uniform(-4, -1.5)
    y = np.clip(base + G @ true, -20.0, 20.0) + sigma * rng.choice([0.1, 1.0, 3.0]) * rng.standard_normal(
        base.shape
    )
    pose, mode = np.nonzero((rng.random(y.shape) < rng.uniform(0.4, 1.0)) | (np.arange(modes) == 0))
    f, columns = np.exp(y[pose, mode]), None
    if rng.random() < 0.4:
        shapes = rng.normal(size=(len(f), 1)) * (
            np.eye(modes)[mode] + 0.05 * rng.standard_normal((len(f), modes))
        )
        shapes[rng.random(shapes.shape) < 0.2] = np.nan
        columns = {f"c{k}": shapes[:, k] for k in range(modes)}
    labels = [f"P{i}" for i in pose]
    data = Measurements.from_rows(labels, f, sigma * f, shapes=columns, mode=range(len(f)))
    return LogLinear(base, G, parameters, candidates), data


def test_whatever_is_asked_is_answered_with_numbers_in_whatever_order() -> None:
    """No warning, no NaN, and the same claims for candidates and rows in another order."""
    verdicts = set()
    for seed in range(50, 70):
        model, data = anything(seed)
        plain = checked(model, data)
        verdicts.add(plain.verdict)
        rng = np.random.default_rng(seed)
        shuffled = [model.candidates[i] for i in rng.permutation(len(model.candidates))]
        order = rng.permutation(len(data.frequency))
        rows = some_rows(
            data,
            order,
            shapes={name: data.shapes[order, k] for k, name in enumerate(data.channels)} or None,
            mode=order,
            lines=data.lines[order],
        )
        moved = model.subset([data.labels.index(label) for label in rows.labels])
        found = checked(LogLinear(moved.base, moved.G, moved.parameters, shuffled), rows)
        assert found.verdict == plain.verdict
        assert sorted(sorted(e.members) for e in found.effects) == sorted(
            sorted(e.members) for e in plain.effects
        )
        assert sorted(map(sorted, found.survivors)) == sorted(map(sorted, plain.survivors))
        assert {row.line for row in found.outliers} == {row.line for row in plain.outliers}
    assert {"adequate", "unexplained", "insufficient_data", "effect_found"} <= verdicts
