"""What changed between states of any structure: differences are compared with differences."""

from __future__ import annotations

import importlib.util
import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
from scipy.linalg import eigh

from pkmodes.core.base.errors import PkmodesError
from pkmodes.loop.diagnosis import Candidate, Diagnosis, MatrixStructure, Measurements, Parameter, diagnose
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Hypothesis
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.states.result import Change
from pkmodes.loop.diagnosis.states.shared_errors import (
    MIN_SIGMA,
    MODE_SIGMA,
    FittedValues,
    scatter_between_setups,
    shared_errors,
    with_model_uncertainty,
)
from pkmodes.loop.diagnosis.states.words import reword

EXAMPLES = Path(__file__).parents[3] / "examples"
#: Says what is found in these states.
PAGE = (EXAMPLES.parent / "docs/explanation/changes.md").read_text(encoding="utf-8")
#: Relative errors of frequencies.
SIGMA = 0.002


@pytest.fixture(scope="module")
def three_storeys() -> ModuleType:
    place = EXAMPLES / "three_storeys" / "three_storeys.py"
    specification = importlib.util.spec_from_file_location("three_storeys", place)
    assert specification is not None
    assert specification.loader is not None
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


# A real structure ------------------------------------------------------------------------------------------------


def test_the_sliding_chain_lacks_a_spring_in_all_states(three_storeys: ModuleType) -> None:
    """LA-14393, nine states with known changes: what is missing is a spring that the chain does not have."""
    found = three_storeys.what_the_chain_lacks()
    assert found.verdict == "effect_found"
    (cause,) = found.effects
    assert all(name.startswith("spring of ") for name in cause.members)
    assert found.refit.chi2_per_dof > 3.0 > 1.0 > found.after.chi2_per_dof
    assert found.after.held_out_rms_relative < 0.2 * found.refit.held_out_rms_relative


#: What was changed in the states in which the data tell it (LA-14393, Table 4): the cause and its value.
TOLD = {
    4: ("storey 1 softer", 0.21875),
    5: ("storey 1 softer", 0.4375),
    6: ("storey 2 softer", 0.21875),
    7: ("storey 2 softer", 0.4375),
    8: ("storey 3 softer", 0.21875),
    9: ("storey 3 softer", 0.4375),
}


@pytest.mark.parametrize("state", TOLD)
def test_a_changed_storey_of_the_real_structure_is_named(three_storeys: ModuleType, state: int) -> None:
    found = three_storeys.what_changed_in(f"state {state}")
    assert (found.verdict, found.changed) == ("effect_found", True), found.reason
    (cause,) = found.effects
    name, value = TOLD[state]
    assert name in cause.members
    assert len(cause.members) <= 4
    (fitted,) = cause.alternatives[name]
    assert abs(fitted.value - value) < 2.5 * fitted.sigma
    assert cause.state == f"state {state}"
    printed = re.search(rf"{name} = ([\d.]+) \+- ([\d.]+)", str(found))
    assert printed is not None
    assert " ± ".join(f"{100 * float(number):.1f}" for number in printed.groups()) in PAGE


@pytest.mark.parametrize("state", [2, 3, 10, 11, 12, 13, 14])
def test_of_other_states_nothing_is_claimed(three_storeys: ModuleType, state: int) -> None:
    """A small mass, a class too large for three modes, and a bumper, which no linear structure has."""
    found = three_storeys.what_changed_in(f"state {state}")
    assert not found.effects
    if state in (10, 11, 12):
        assert found.changed is False
    if state == 3:
        assert "which these data cannot tell apart" in found.reason, "a class is a class in reasons too"


# Structures whose truth is known ----------------------------------------------------------------------------------


def chain(
    stiffness: Sequence[float], loads: Sequence[float], mass: float = 20.0
) -> tuple[np.ndarray, np.ndarray]:
    """Return M and K of a chain of masses and springs, the first spring to ground."""
    n = len(stiffness)
    k = np.array(stiffness)
    K = np.diag(k + np.append(k[1:], 0.0)) - np.diag(k[1:], 1) - np.diag(k[1:], -1)
    return mass * np.eye(n) + np.diag(loads), K


#: Setups of one state: nothing, and 8 kg on a floor.
FLOORS = 5
SETUPS = ("empty", "3 loaded", "5 loaded")


def loads_of(setup: str) -> np.ndarray:
    loads = np.zeros(FLOORS)
    if setup != "empty":
        loads[int(setup[0]) - 1] = 8.0
    return loads


def declared(sigma: float | None = 0.02, again: Sequence[str] = (" again",)) -> MatrixStructure:
    """Return the declared chain: each storey may be softer, each floor heavier."""
    storeys, floors = (
        [f"storey {i}" for i in range(1, FLOORS + 1)],
        [f"mass {i}" for i in range(1, FLOORS + 1)],
    )

    def matrices(values: Mapping[str, float], setup: str) -> tuple[np.ndarray, np.ndarray]:
        own = loads_of(setup.partition(" again")[0]) + [values[name] for name in floors]
        return chain([values["k"] * (1.0 - values[name]) for name in storeys], own, values["m"])

    parameters = [
        Parameter("m", 20.0, "kg", sigma=sigma, log=True),
        Parameter("k", 4e5, "N/m", sigma=sigma, log=True),
        *(Parameter(name, 0.0, "1", lower=-0.5, upper=0.9) for name in storeys),
        *(Parameter(name, 0.0, "kg", lower=0.0) for name in floors),
    ]
    candidates = [Candidate(name, (name,)) for name in (*storeys, *floors)]
    setups = [*SETUPS, *(f"{name}{suffix}" for suffix in again for name in SETUPS)]
    channels = [f"x_{i}" for i in range(1, FLOORS + 1)]
    return MatrixStructure(parameters, candidates, matrices, channels=channels, setups=setups)


def both_states(
    rng: np.random.Generator,
    softer: float = 0.0,
    storeys: Sequence[int] = (2,),
    wrong: float = 0.03,
    lost: float = 0.0,
) -> Measurements:
    """Return both states of a true chain, whose springs are all wrong by some per cent in both."""
    k = 4e5 * (1.0 + wrong * rng.uniform(-1.0, 1.0, FLOORS))
    pose: list[str] = []
    frequency: list[float] = []
    mode: list[int] = []
    for again in ("", " again"):
        now = k.copy()
        now[[storey - 1 for storey in storeys]] *= 1.0 - (softer if again else 0.0)
        for setup in SETUPS:
            M, K = chain(now, loads_of(setup))
            f = np.sqrt(eigh(K, M, eigvals_only=True)) / (2.0 * np.pi)
            for i, value in enumerate(f):
                if rng.uniform() >= lost:
                    pose.append(f"{setup}{again}")
                    mode.append(i + 1)
                    frequency.append(value * (1.0 + SIGMA * rng.standard_normal()))
    return Measurements.from_rows(pose, frequency, SIGMA * np.array(frequency), mode=mode)


def states_of(data: Measurements) -> dict[str, str]:
    return {label: "after" if "again" in label else "before" for label in data.labels}


def what_changed(data: Measurements, **options: object) -> Change:
    found = diagnose(declared(), data, states=states_of(data), **options)  # type: ignore[arg-type]
    assert isinstance(found, Change)
    return found


@pytest.mark.parametrize("seed", range(4))
def test_a_softer_storey_is_found_though_the_model_is_wrong_in_both_states(seed: int) -> None:
    rng = np.random.default_rng(seed)
    data = both_states(rng, softer=0.12, wrong=0.06)
    found = what_changed(data)
    assert (found.verdict, found.changed, found.states) == ("effect_found", True, ("before", "after"))
    (cause,) = found.effects
    assert cause.members == ("storey 2",)
    assert abs(cause.parameters[0].value - 0.12) < 3.0 * cause.parameters[0].sigma
    assert found.model_error > 2.0 * SIGMA, "the model is wrong in both"
    plain = diagnose(declared(), data.at([i for i, label in enumerate(data.labels) if "again" in label]))
    assert plain.verdict != "effect_found" or plain.effects[0].members != ("storey 2",)


def test_two_changes_at_once_are_not_claimed() -> None:
    found = what_changed(both_states(np.random.default_rng(3), softer=0.2, storeys=(1, 4)))
    assert (found.verdict, found.rule, found.changed) == ("unexplained", "claims.two_of_few", True)
    assert "storey 1" in found.reason
    assert "storey 4" in found.reason
    assert "two changes at once are not claimed: measure a state between them" in found.reason
    assert not found.effects


def test_nothing_changed_is_said() -> None:
    told = [what_changed(both_states(np.random.default_rng(seed))).changed for seed in range(30)]
    assert told.count(False) >= 28
    assert told.count(True) == 0


def test_rows_are_as_measured_beside_what_the_trusted_state_says() -> None:
    data = both_states(np.random.default_rng(1), softer=0.12)
    found = what_changed(data)
    later = [i for i, label in enumerate(data.labels) if "again" in label]
    assert [row.measured for row in found.rows] == data.at(later).frequency.tolist()
    for row, counterpart in zip(found.rows, found.counterparts, strict=True):
        assert counterpart is not None
        line = counterpart.line - 1
        assert counterpart.measured == data.frequency[line]
        assert data.labels[data.pose[line]] == row.pose.removesuffix(" again")
        # As in the trusted state means: what was measured there.
        assert row.before == pytest.approx(counterpart.measured, rel=4 * SIGMA)
        assert row.sigma / row.measured == pytest.approx(np.sqrt(2.0) * SIGMA, rel=0.15)
        assert row.after == pytest.approx(row.measured, rel=5 * SIGMA)


def test_whole_states_are_never_held_out() -> None:
    """By default one setup in six is held out, of the later state: of three setups none, of six one."""
    found = what_changed(both_states(np.random.default_rng(1), softer=0.12))
    assert found.held_out_poses == ()
    found = what_changed(
        both_states(np.random.default_rng(1), softer=0.12), holdout=["5 loaded again", "empty"]
    )
    assert found.held_out_poses == ("5 loaded again",), "setups of the trusted state are always fitted"
    assert found.after is not None
    assert found.after.held_out_rms_relative is not None
    assert found.after.held_out_rms_relative < 4 * SIGMA


def test_several_later_states_are_each_compared_with_the_trusted_one() -> None:
    first, second = (
        both_states(np.random.default_rng(3), softer=x, storeys=(s,)) for x, s in ((0.12, 2), (0.15, 4))
    )
    third = second.at([i for i, label in enumerate(second.labels) if "again" in label])
    data = Measurements.from_rows(
        [*(first.labels[i] for i in first.pose), *(f"{third.labels[i]} 2" for i in third.pose)],
        [*first.frequency, *third.frequency],
        [*first.sigma, *third.sigma],
    )
    states = states_of(data) | {label: "later" for label in data.labels if label.endswith(" 2")}
    found = diagnose(declared(again=(" again", " again 2")), data, states=states)
    assert isinstance(found, Change)
    assert found.states == ("before", "after", "later")
    assert [(one.members, one.state) for one in found.effects] == [
        (("storey 2",), "after"),
        (("storey 4",), "later"),
    ]
    content = found.as_json()
    assert content["by_state"].keys() == {"after", "later"}  # type: ignore[attr-defined]
    assert found.changed is True
    assert found.verdict == "effect_found"
    assert len(found.rows) == len(found.counterparts) == 30


# What is shared ----------------------------------------------------------------------------------------------------


def shared_of(data: Measurements, later: Sequence[int]):  # type: ignore[no-untyped-def]
    structure = declared(None)
    trusted = [i for i in range(len(data.labels)) if i not in later]
    places = [structure.setups.index(data.labels[i]) for i in trusted]
    fitter = Fitter(structure.subset(places), data.at(trusted))
    own = structure.subset([structure.setups.index(data.labels[i]) for i in later])
    return fitter, shared_errors(fitter, fitter.declared, own, data.at(list(later)))


@pytest.mark.parametrize("same", [True, False])
def test_the_prediction_of_an_error_is_that_of_a_normal_distribution(same: bool) -> None:
    """Its mean and variance given the trusted rows of that mode (conditional normal distribution, by hand).

    The variance of each row is at least what the sum of the moduli of its row in the covariance says.
    """
    trusted, other = (SETUPS, "empty again") if same else (SETUPS[1:], "empty again")
    data = both_states(np.random.default_rng(2), wrong=0.1)
    kept = data.at([i for i, label in enumerate(data.labels) if label in (*trusted, other)])
    fitter, shared = shared_of(kept, [kept.labels.index(other)])
    _, residual, sigma, _ = fitter.evaluate(fitter.declared, fitter.observations.all_rows)
    n = len(trusted)
    scatter = scatter_between_setups(
        residual,
        sigma,
        np.tile(np.arange(FLOORS), n),
        np.eye(n, dtype=bool),
        np.repeat(np.arange(n), FLOORS),
    )
    assert scatter > 0.0
    assert shared.counterpart.tolist() == (list(range(FLOORS)) if same else [-1] * FLOORS)
    for mode in range(FLOORS):
        rows = np.arange(n) * FLOORS + mode
        V = MODE_SIGMA**2 + np.diag(scatter**2 + sigma[rows] ** 2)
        cross = MODE_SIGMA**2 + scatter**2 * np.array([float(same and k == 0) for k in range(n)])
        gain = cross @ np.linalg.inv(V)
        assert shared.offset[mode] == pytest.approx(gain @ residual[rows], rel=1e-9)
        assert shared.variance[mode] == pytest.approx(MODE_SIGMA**2 + scatter**2 - gain @ cross, rel=1e-6)


def test_far_above_those_of_the_measurement_errors_of_the_model_are_taken_off_as_measured() -> None:
    """A difference of two measurements: its variance is the sum of theirs."""
    data = both_states(np.random.default_rng(2), wrong=0.3)
    data = Measurements.from_rows(
        [data.labels[i] for i in data.pose], data.frequency, 0.02 * data.sigma, mode=data.mode
    )
    later = [i for i, label in enumerate(data.labels) if "again" in label]
    fitter, shared = shared_of(data, later)
    _, residual, sigma, _ = fitter.evaluate(fitter.declared, fitter.observations.all_rows)
    np.testing.assert_allclose(shared.offset, residual, atol=0.02 * SIGMA)
    np.testing.assert_allclose(shared.variance, sigma**2, rtol=0.05)


def test_what_the_trusted_state_leaves_unknown_of_its_values_is_in_the_errors_of_modes() -> None:
    """Propagated to first order, with derivatives by differences of the predictions."""
    structure, names, steps = declared(), ("m", "k"), np.array([1e-3, 20.0])
    covariance = np.diag([0.2, 4e3]) @ np.array([[1.0, 0.6], [0.6, 1.0]]) @ np.diag([0.2, 4e3])
    values = np.array([p.value for p in structure.parameters])
    mode, setup = np.array([0, 3, 4]), np.array([2, 0, 1])

    def difference(k: int) -> tuple[np.ndarray, np.ndarray]:
        step = np.zeros_like(values)
        step[k] = steps[k]
        up, down = structure.predict(values + step, ()), structure.predict(values - step, ())
        sign = np.sign((up.shapes * down.shapes).sum(axis=-1, keepdims=True))
        logs, shapes = up.log_frequencies - down.log_frequencies, up.shapes - sign * down.shapes
        return logs[setup, mode] / (2.0 * steps[k]), shapes[setup, mode] / (2.0 * steps[k])

    of_logs, of_shapes = (np.stack(rates, axis=-1) for rates in zip(*map(difference, range(2)), strict=True))
    found = FittedValues(names, covariance).variances(structure, mode, setup)
    for rates, variance in zip((of_logs, of_shapes), found, strict=True):
        expected = ((rates @ np.linalg.cholesky(covariance)) ** 2).sum(axis=-1)
        np.testing.assert_allclose(variance, expected, rtol=1e-5, atol=1e-12)


def test_the_rows_of_a_later_state_have_these_errors_too() -> None:
    data = both_states(np.random.default_rng(2))
    later = [i for i, label in enumerate(data.labels) if "again" in label]
    fitter, without = shared_of(data, later)
    own = declared(None).subset([3, 4, 5])
    fitted = FittedValues(("m", "k"), np.diag([0.2, 4e3]) ** 2)
    shared = shared_errors(fitter, fitter.declared, own, data.at(later), fitted_values=fitted)
    mode, setup = np.array(data.at(later).mode, dtype=int) - 1, data.at(later).pose
    more, _ = fitted.variances(own, mode, setup)
    assert (more > 1e-6).all()
    np.testing.assert_allclose(shared.variance, without.variance + more, rtol=1e-12)


def test_a_candidate_that_is_less_likely_costs_its_odds() -> None:
    data = both_states(np.random.default_rng(1), softer=0.1)
    store = FitStore(Fitter(declared(), data))
    usual = declared().candidates[0]
    rare = replace(usual, name="rare", odds=0.1)
    one, other = (store.fit(Hypothesis((cause,))) for cause in (usual, rare))
    assert one is not None
    assert other is not None
    assert store.criterion(other) - store.criterion(one) == pytest.approx(2.0 * np.log(10.0))
    assert store.price(rare) - store.price(usual) == pytest.approx(2.0 * np.log(10.0))


def test_shapes_without_a_counterpart_are_as_uncertain_as_the_values_behind_their_modes() -> None:
    shapes, spread = np.array([[1.0, 0.5], [1.0, -0.5]]), np.array([0.01, 0.2])
    same, larger = with_model_uncertainty(shapes, np.full(2, 0.02), 0.03, spread)
    np.testing.assert_array_equal(same, shapes)
    np.testing.assert_allclose(larger, [np.sqrt(0.0004 + 0.0009 + 0.0001), np.sqrt(0.0004 + 0.0009 + 0.04)])
    # Where no error is stated, all have one scatter, and what is less certain is left out.
    fewer, unstated = with_model_uncertainty(shapes, np.full(2, np.nan), 0.03, spread)
    np.testing.assert_array_equal(fewer, [[1.0, 0.5], [np.nan, np.nan]])
    assert np.isnan(unstated).all()


def test_the_scatter_between_setups_is_an_upper_limit() -> None:
    """Of 2,000 sets of 4 setups with 4 modes, it is above the true one in 90 %, as `CONFIDENCE` says."""
    rng, true = np.random.default_rng(5), 0.006
    partner, pose = np.tile(np.arange(4), 4), np.repeat(np.arange(4), 4)
    sigma = np.full(16, SIGMA)
    above = 0
    for _ in range(2000):
        residual = rng.normal(0.0, 0.1, 4)[partner] + rng.normal(0.0, np.hypot(true, SIGMA), 16)
        above += scatter_between_setups(residual, sigma, partner, np.eye(4, dtype=bool), pose) > true
    assert 0.88 < above / 2000 < 0.92
    few = scatter_between_setups(
        np.zeros(2), sigma[:2], np.zeros(2, dtype=int), np.eye(2, dtype=bool), np.arange(2)
    )
    assert few == MIN_SIGMA, "two rows of one mode do not tell it"


# Words -------------------------------------------------------------------------------------------------------------


def test_a_diagnosis_in_the_words_of_a_change() -> None:
    said = "the residual of the declared model is not noise (p < 1e-6); explanation: the declared mass is wrong (m)"
    differs = "after differs from before by more than the errors of both (p < 1e-6)"
    assert reword(said, "before", "after") == f"{differs}; explanation: the mass changed (m)"
    two_days = "June differs from May only by what two days may differ by"
    for day, change in (
        ("from 0 to -0.012 (-0.8 sigma)", "1.2 % softer"),
        ("from 0 to -0.0120 +- 0.0031 (-0.8 sigma)", "1.20 +- 0.31 % softer"),
        ("from 0 to 0.012 (+0.8 sigma; an undetected payload would have the same effect)", "1.2 % stiffer"),
        (
            "from 0 to 0.012 (+0.8 sigma; a frame.mass other than 50 kg would have the same effect)",
            "1.2 % stiffer",
        ),
    ):
        noise = f"the residual is noise once the uncertain values are refitted: day.belt_stiffness {day}"
        assert reword(noise, "May", "June") == f"{two_days}: all belts are {change}"


# Bad input ---------------------------------------------------------------------------------------------------------


def test_bad_states_are_refused() -> None:
    data = both_states(np.random.default_rng(1))
    good = states_of(data)
    cases = {
        "expected a mapping of setups to states": ["before"],
        'no setup is called "emtpy"': {"emtpy": "before"},
        'the setup "5 loaded again" has no state': {k: v for k, v in good.items() if k != "5 loaded again"},
        'expected two states or more, found "before" only': dict.fromkeys(good, "before"),
    }
    for what, states in cases.items():
        with pytest.raises(PkmodesError) as refused:
            diagnose(declared(), data, states=states)  # type: ignore[arg-type]
        assert what in refused.value.what
        assert refused.value.remedy


def test_the_same_measurement_twice_is_refused() -> None:
    data = both_states(np.random.default_rng(1))
    first = data.at([i for i, label in enumerate(data.labels) if "again" not in label])
    labels = [first.labels[i] for i in first.pose]
    twice = Measurements.from_rows(
        [*labels, *(f"{label} again" for label in labels)], [*first.frequency] * 2, [*first.sigma] * 2
    )
    with pytest.raises(PkmodesError, match="have the same frequencies: they are one measurement"):
        diagnose(declared(), twice, states=states_of(twice))


def test_states_without_a_mode_in_common_are_refused() -> None:
    """The trusted state has modes 1 and 2, the later one mode 5."""
    data = both_states(np.random.default_rng(1))
    rows = [
        i
        for i in range(len(data.lines))
        if (data.mode[i] == "5") == ("again" in data.labels[data.pose[i]]) and data.mode[i] in ("1", "2", "5")
    ]
    some = Measurements.from_rows(
        [data.labels[data.pose[i]] for i in rows], data.frequency[rows], data.sigma[rows]
    )
    with pytest.raises(PkmodesError, match='no mode of "after" was measured in "before"'):
        diagnose(declared(), some, states=states_of(some))


def test_values_held_by_their_priors_are_no_unknowns() -> None:
    """Two values known to a millionth, two measured modes: enough to ask for a cause, but not if they are free."""
    data = both_states(np.random.default_rng(1), softer=0.3, wrong=0.0)
    rows = [i for i in range(len(data.lines)) if data.labels[data.pose[i]] == "empty again"][:2]
    two = Measurements.from_rows(["empty again"] * 2, data.frequency[rows], data.sigma[rows])
    known, free = (diagnose(declared(sigma), two) for sigma in (1e-6, 0.3))
    assert isinstance(known, Diagnosis)
    assert known.verdict != "insufficient_data"
    assert free.verdict == "insufficient_data"
