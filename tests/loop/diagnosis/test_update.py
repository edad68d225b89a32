"""Updates of many parameters at once, against regularised least squares."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from helpers.robots.small_structures import SIGMA, LogLinear, each, ladder, logs_measured
from pkmodes.core.base.errors import PkmodesError
from pkmodes.loop.diagnosis import Measurements, Parameter, update

COUNT = 12


def model(seed: int = 0, setups: int = 6, modes: int = 4, **changes: object) -> LogLinear:
    rng = np.random.default_rng(seed)
    parameters = [Parameter(f"k{i}", 1.0, sigma=0.1, lower=0.2) for i in range(COUNT)]
    G = 0.05 * rng.standard_normal((setups, modes, COUNT))
    G[..., -1] = 0.0  # the last one changes nothing
    return LogLinear(ladder(setups, modes) - G.sum(axis=-1), G, parameters)


def measured(structure: LogLinear, values: np.ndarray, seed: int = 1) -> Measurements:
    rng = np.random.default_rng(seed)
    y = structure.base + structure.G @ values
    return logs_measured(y + SIGMA * rng.standard_normal(y.shape), SIGMA)


TRUE = 1.0 + 0.1 * np.random.default_rng(9).standard_normal(COUNT)


def test_it_is_the_most_probable_model_given_data_and_priors() -> None:
    structure = model()
    data = measured(structure, TRUE)
    found = update(structure, data, holdout=())
    J = np.vstack([structure.G.reshape(-1, COUNT) / SIGMA, np.eye(COUNT) / 0.1])
    right = np.concatenate([(np.log(data.frequency) - structure.base.ravel()) / SIGMA, np.full(COUNT, 10.0)])
    expected = np.linalg.lstsq(J, right, rcond=None)[0]
    covariance = np.linalg.inv(J.T @ J)
    assert [p.after for p in found.parameters] == pytest.approx(expected, rel=1e-5)
    assert [p.sigma for p in found.parameters] == pytest.approx(np.sqrt(np.diagonal(covariance)), rel=1e-5)
    size = np.sqrt(np.diagonal(covariance))
    assert found.correlation == pytest.approx(covariance / np.outer(size, size), abs=1e-6)
    resolution = 1.0 - np.diagonal(covariance) / 0.01
    assert [p.resolution for p in found.parameters] == pytest.approx(resolution, abs=1e-5)
    assert found.parameters[-1].resolution == pytest.approx(0.0, abs=1e-9)
    assert found.parameters[-1].after == pytest.approx(1.0)
    assert any("these data do not determine" in note and "k11" in note for note in found.notes)
    assert found.p_value > 1e-3


def test_it_predicts_held_out_setups() -> None:
    structure = model(2, setups=12)
    data = measured(structure, TRUE, 3)
    found = update(structure, data)
    assert found.held_out_poses
    assert found.before.held_out_rms_relative > 3 * found.after.held_out_rms_relative
    assert found.after.held_out_rms_relative < 3 * SIGMA


def test_only_the_chosen_parameters_change() -> None:
    structure = model()
    data = measured(structure, np.where(np.arange(COUNT) < 3, TRUE, 1.0))
    found = update(structure, data, ["k0", "k2"], holdout=())
    assert [p.name for p in found.parameters] == ["k0", "k2"]
    assert set(found.values) == {"k0", "k2"}


def test_a_residual_beyond_the_stated_errors_is_noted() -> None:
    structure = model()
    data = measured(structure, TRUE)
    shifts = np.exp(0.05 * np.random.default_rng(4).standard_normal(len(data.frequency)))
    found = update(structure, replace(data, frequency=data.frequency * shifts), holdout=())
    assert found.p_value < 1e-3
    assert any("something else is missing" in note for note in found.notes)


def test_parameters_of_candidates_have_the_candidates_prior() -> None:
    structure = model()
    free = [Parameter(p.name, p.value, lower=p.lower) for p in structure.parameters]
    same = LogLinear(structure.base, structure.G, free, each((p.name for p in free), sigma=(0.1,)))
    data = measured(structure, TRUE)
    a, b = (update(s, data, holdout=()) for s in (structure, same))
    assert [p.after for p in a.parameters] == pytest.approx([p.after for p in b.parameters])


def test_the_word_all_stands_for_every_parameter() -> None:
    structure = model()
    data = measured(structure, TRUE)
    every, said = (update(structure, data, names, holdout=()) for names in (None, "all"))
    assert [one.name for one in said.parameters] == [p.name for p in structure.parameters]
    assert said.parameters == every.parameters


@pytest.mark.parametrize(
    ("names", "what"),
    [("k0", "expected a list of names"), (["k99"], 'no parameter "k99"'), (["free"], "has no prior")],
)
def test_what_cannot_be_updated_is_refused(names: object, what: str) -> None:
    structure = model()
    G = np.concatenate([structure.G, structure.G[..., :1]], axis=-1)
    more = LogLinear(structure.base, G, [*structure.parameters, Parameter("free", 0.0)])
    with pytest.raises(PkmodesError, match=what):
        update(more, measured(structure, TRUE), names, holdout=())  # type: ignore[arg-type]


def test_without_any_prior_nothing_can_be_updated() -> None:
    structure = model()
    free = LogLinear(structure.base, structure.G, [Parameter(p.name, p.value) for p in structure.parameters])
    with pytest.raises(PkmodesError, match="no parameter has a prior"):
        update(free, measured(structure, TRUE), holdout=())
