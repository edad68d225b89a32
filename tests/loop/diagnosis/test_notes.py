"""Notes to a verdict, and its stability."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest
from scipy import stats
from scipy.linalg import eigh

from helpers.robots.small_structures import (
    SIGMA,
    LogLinear,
    columns,
    each,
    in_a_row,
    ladder,
    log_linear,
    logs_measured,
    normalised,
    of_signatures,
    some_rows,
    with_changes,
)
from pkmodes.loop.diagnosis import Diagnosis, MatrixStructure, Measurements, Parameter, compare, diagnose
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Hypothesis
from pkmodes.loop.diagnosis.search.unmeasured import count_modes, p_unmeasured

FLOORS = [f"floor {i}" for i in range(1, 5)]
LOADS = {f"{load:g} kg": load for load in (0.0, 2.0, 4.0, 6.0, 8.0)}


def matrices(values: dict[str, float], setup: str) -> tuple[np.ndarray, np.ndarray]:
    M = np.diag([20.0, 20.0, 20.0, 20.0 + LOADS[setup]])
    return M, in_a_row(values["k"] * np.array([1.0, 1.0 + values["brace"], 0.8, 0.7]))


def structure(sigma: float = 0.02) -> MatrixStructure:
    parameters = [
        Parameter("k", 4e5, "N/m", sigma=sigma * 4e5, lower=1e4),
        Parameter("brace", 0.0, lower=0.0),
    ]
    return MatrixStructure(parameters, each(["brace"]), matrices, channels=FLOORS, setups=list(LOADS))


def measured(k: float = 4e5, brace: float = 0.0, seed: int = 0, shapes: bool = True) -> Measurements:
    rng = np.random.default_rng(seed)
    pose, f, rows = [], [], []
    for setup in LOADS:
        M, K = matrices({"k": k, "brace": brace}, setup)
        eigenvalues, vectors = eigh(K, M)
        pose += [setup] * 4
        f += list(np.sqrt(eigenvalues) / (2 * np.pi) * np.exp(SIGMA * rng.standard_normal(4)))
        rows += list(normalised(vectors) + 0.02 * rng.standard_normal((4, 4)))
    f = np.array(f)
    return Measurements.from_rows(pose, f, SIGMA * f, shapes=columns(np.array(rows)) if shapes else None)


def notes(data: Measurements, **options: float) -> Diagnosis:
    return diagnose(structure(**options), data, holdout=())


def test_good_measurements_of_a_good_model_give_no_notes() -> None:
    found = notes(measured())
    assert found.verdict == "adequate"
    assert found.notes == ()
    assert found.as_json()["notes"] == []


@pytest.mark.parametrize(
    ("factor", "name"), [(2 * np.pi, "rad/s"), (60.0, "1/min"), (1e-3, "kHz"), (360.0, "deg/s")]
)
def test_frequencies_in_another_unit_are_noticed_before_any_cause(factor: float, name: str) -> None:
    data = measured(brace=0.5)
    found = notes(replace(data, frequency=data.frequency * factor, sigma=data.sigma * factor))
    assert found.verdict == "unexplained"
    assert found.effects == ()
    assert f"write frequency [{name}]" in found.reason
    assert found.notes[0] == found.reason


def test_a_wrong_unit_in_the_header_is_recognised_from_the_numbers() -> None:
    data = measured()
    for header, hertz, is_in in (
        ("kHz", 1e3, "Hz"),
        ("rad/s", 1 / (2 * np.pi), "Hz"),
        ("1/min", 1 / 60, "Hz"),
    ):
        changed = replace(data, frequency=data.frequency * hertz, sigma=data.sigma * hertz, unit=header)
        found = notes(changed)
        assert found.reason.startswith(
            f"the header says {header}, but the numbers fit the declared model as {is_in} ("
        )
        assert f"write frequency [{is_in}]" in found.reason
    assert notes(replace(data, unit="Hz")).verdict == "adequate"
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(
            "pkmodes.loop.diagnosis.readings.units.MAX_SETUPS", 2
        )  # of the setups tell the unit of all
        assert "write frequency [Hz]" in notes(changed).reason
        assert notes(data).verdict == "adequate"


def test_periods_are_recognised() -> None:
    data = measured()
    periods = 1.0 / data.frequency
    found = notes(replace(data, frequency=periods, sigma=periods * data.sigma / data.frequency))
    assert found.verdict == "unexplained"
    assert "as periods in s (" in found.reason
    assert "write frequencies, 1 / period" in found.reason


def test_frequencies_that_were_converted_twice_are_recognised() -> None:
    data = measured()
    found = notes(replace(data, frequency=data.frequency / (2 * np.pi), sigma=data.sigma / (2 * np.pi)))
    assert "as rad/s, converted twice" in found.reason
    assert "multiply them by 6.283" in found.reason


def test_a_comparison_notes_another_unit() -> None:
    data = measured()
    assert compare(structure(), data).notes == ()
    (note,) = compare(
        structure(), replace(data, frequency=data.frequency / 1e3, sigma=data.sigma / 1e3)
    ).notes
    assert "write frequency [kHz]" in note


def test_exchanged_channels_are_noticed() -> None:
    data = measured()
    found = notes(replace(data, shapes=data.shapes[:, [1, 0, 2, 3]]))
    assert found.verdict == "unexplained"
    assert found.reason.startswith("floor 1 and floor 2 are exchanged: the shapes differ from the model by ")
    assert "rename the column shape:floor 1 to shape:floor 2, " in found.reason
    assert found.notes[0] == found.reason
    turned = notes(replace(data, shapes=data.shapes * [1.0, 1.0, -1.0, 1.0]))
    assert turned.verdict == "unexplained"
    assert turned.reason.startswith("floor 3 is reversed: ")
    assert "change the sign of the column shape:floor 3, or check the sensor's direction" in turned.reason
    assert "in the poses" not in turned.reason


def test_a_dead_sensor_is_noticed() -> None:
    data = measured()
    dead = notes(replace(data, shapes=data.shapes * [1.0, 0.0, 1.0, 1.0]))
    assert (dead.verdict, dead.rule) == ("unexplained", "after.dead_channel")
    assert "channel floor 2 is 0 in every row: is the sensor connected?" in dead.notes[0]
    # What is wrong in the file is no reason to look for terms that explain it.
    mistaken = replace(data, shapes=data.shapes * [1.0, 0.0, 1.0, 1.0])
    assert diagnose(structure(), mistaken, holdout=(), terms=True).beyond is None
    shapes = data.shapes * [1.0, 0.0, 1.0, 1.0]
    shapes[:, 1] = np.nan
    assert notes(replace(data, shapes=shapes)).verdict == "adequate"


def test_a_shape_that_was_copied_to_another_row_is_named_with_both_lines() -> None:
    data = measured()
    shapes = data.shapes.copy()
    shapes[9] = shapes[2]
    found = diagnose(structure(), replace(data, shapes=shapes), holdout=[data.labels[2]])
    assert "the shapes in lines 3 and 10 are identical: was one copied?" in found.notes


def test_poses_at_one_position_with_other_frequencies_are_named() -> None:
    data = measured(shapes=False)
    points = np.column_stack([np.arange(5.0), np.zeros(5), np.ones(5)])
    assert notes(replace(data, points=points)).notes == ()
    points[3] = points[1]
    (note,) = notes(replace(data, points=points)).notes
    most = (data.frequency[4:8] / data.frequency[12:16]).max() - 1.0
    assert note.startswith(
        "poses 2 kg and 6 kg are at the same position, but their frequencies differ by up to "
    )
    assert float(note.split(" %")[0].split()[-1]) == pytest.approx(100 * most, rel=0.05)
    held = diagnose(structure(), replace(data, points=points), holdout=["6 kg"])
    assert held.notes == (note,)  # whether or not one of them is held out
    same = data.frequency.copy()
    same[12:16] = same[4:8]
    assert "same position" not in "".join(notes(replace(data, frequency=same, points=points)).notes)


@pytest.mark.parametrize("scale", [1.0, 1e-100])
def test_shapes_that_are_all_the_same_are_noticed(scale: float) -> None:
    data = measured()
    found = notes(replace(data, shapes=scale * np.tile(data.shapes[:1], (len(data.shapes), 1))))
    assert found.verdict == "unexplained"
    assert any("are the same" in note for note in found.notes)


def test_stated_errors_far_too_large_are_noticed_and_right_ones_are_not() -> None:
    data = measured(shapes=False)
    found = notes(replace(data, sigma=data.sigma * 50.0))
    assert found.verdict == "adequate"
    (note,) = found.notes
    factor = float(note.split(" times too large")[0].split()[-1])
    assert factor == pytest.approx(50.0, rel=0.4)


def test_a_nuisance_far_from_its_prior_is_noticed() -> None:
    found = notes(measured(k=4.4e5, shapes=False), sigma=0.01)
    far = [note for note in found.notes if note.startswith("k = ")]
    assert len(far) == 1
    assert float(far[0].split(" sigma from")[0].split()[-1]) > 3.0


def test_a_row_that_is_set_aside_is_named() -> None:
    data = measured(shapes=False)
    f = data.frequency.copy()
    f[6] *= 1.06
    found = notes(replace(data, frequency=f))
    assert found.verdict == "adequate"
    assert any(note.startswith("line 7 (2 kg") and "set aside" in note for note in found.notes)


def test_a_mode_in_the_band_that_was_never_measured_is_named() -> None:
    data = measured(shapes=False)
    third = np.arange(len(data.frequency)) % 4 == 2
    (note,) = notes(some_rows(data, ~third, band=(1.0, 100.0))).notes
    assert "expected at 5 poses but never measured" in note
    low, high = (float(text) for text in note.split(" Hz was")[0].removeprefix("a mode at ").split(" to "))
    assert low * 0.99 <= data.frequency[third].min()
    assert high * 1.01 >= data.frequency[third].max()


def test_a_residual_that_varies_with_the_pose_is_not_called_a_wrong_sigma() -> None:
    data = measured(shapes=False)
    drift = np.linspace(0.25, -0.29, 5)[data.pose]
    found = notes(replace(data, frequency=data.frequency * (1.0 + drift)), sigma=0.001)
    assert found.verdict == "unexplained"
    assert "varies with the pose, from +" in found.reason
    assert "sigma is too small" not in found.reason


def test_stability_says_what_other_errors_and_priors_would_change() -> None:
    found = notes(measured(brace=0.3))
    assert found.verdict == "effect_found"
    assert [s.change for s in found.stability] == ["sigma x 0.5", "sigma x 2", "priors x 2"]
    assert found.stability[1].effects == found.stability[2].effects == ("brace",)
    assert found.as_json()["stability"][2] == {
        "change": "priors x 2",
        "verdict": "effect_found",
        "effects": ["brace"],
    }
    assert notes(measured()).stability[1].verdict == "adequate"


def test_a_diagnosis_is_printed_in_a_few_lines() -> None:
    found = notes(replace(measured(brace=0.3), band=(1.0, 100.0)))
    lines = str(found).splitlines()
    assert lines[0] == f"effect_found: {found.reason}"
    assert re.fullmatch(r"cause: brace \(p < 1e-6\): brace = 0\.[23]\d* \+- 0\.0\d+", lines[1])
    stages = [line for line in lines if "chi2 per degree of freedom" in line]
    assert [line.split()[0] for line in stages] == ["before", "refit", "after"]
    assert len(lines) == 5 + len(found.notes)
    assert str(notes(measured(shapes=False))).startswith(
        "adequate: the residual of the declared model is noise"
    )


def test_a_cause_that_other_errors_would_replace_is_not_claimed() -> None:
    """a is exact with the nuisance at five sigma, b needs less of it and leaves 7: doubled errors prefer b."""
    rng = np.random.default_rng(8)
    n, a, e = np.linalg.qr(rng.standard_normal((20, 3)))[0].T.reshape(3, 4, 5)
    n = 6.0 * n
    b = a + 0.25 * n + 0.35 * e
    model = of_signatures({"n": n, "a": a, "b": b}, 4, 5, known={"n": {"sigma": 1.0}})
    found = diagnose(model, with_changes(model, 20.0 * a + 5.0 * n), holdout=())
    assert [s.effects for s in found.stability] == [("a",), ("b",), ("a",)]
    assert found.verdict == "ambiguous"
    assert found.effects == ()
    assert found.survivors == (("a",), ("b",))
    assert "with sigma x 2, b would do so better" in found.reason


def six_modes(missed: list[tuple[int, int]], added: float) -> tuple[Fitter, LogLinear]:
    """Ten setups with six modes, some of them missed; a cause shifts all and may bring the last one among them."""
    base = ladder(10, 6)
    G = np.zeros((10, 6, 1))
    G[:, 5, 0] = added
    model = LogLinear(base, G, [Parameter("c", 0.0)], each("c"))
    kept = [(i, k) for i in range(10) for k in range(5) if (i, k) not in missed]
    f = np.exp([base[i, k] for i, k in kept])
    return Fitter(model, Measurements.from_rows([f"P{i}" for i, _ in kept], f, SIGMA * f)), model


def test_added_modes_that_nobody_measured_contradict_a_cause_by_the_hypergeometric_distribution() -> None:
    for missed in ([], [(i, 2) for i in range(5)]):
        fitter, model = six_modes(missed, -0.45)
        declared = fitter.fit(Hypothesis())
        there = fitter.fit(Hypothesis(model.candidates), np.array([1.0]))
        assert declared is not None
        assert there is not None
        with_cause = replace(there, prediction=model.predict(np.array([1.0]), ()), pairing=declared.pairing)
        count = 50 - len(missed)
        assert count_modes(fitter, declared) == (count + len(missed), len(missed))
        assert count_modes(fitter, with_cause) == (count + len(missed) + 10, len(missed) + 10)
        total, lost = count + len(missed) + 11, len(missed) + 10
        expected = np.sqrt(stats.hypergeom.sf(9, total, lost, 10))  # no sensor is known
        assert p_unmeasured(fitter, declared, with_cause) == pytest.approx(expected)
        assert expected < 1e-3


def test_modes_above_the_highest_measured_one_are_not_counted_as_missed_whatever_the_band() -> None:
    """A test may have stopped there."""
    fitter, model = six_modes([], 0.0)
    for limit in (1.1, 10.0):
        banded = Fitter(model, replace(fitter.data, band=(1.0, limit * float(np.exp(model.base[0, 4])))))
        declared = banded.fit(Hypothesis())
        assert declared is not None
        assert count_modes(banded, declared) == (50, 0)


def test_log_linear_structures_with_a_stated_band_are_as_without_it() -> None:
    rng = np.random.default_rng(2)
    model = log_linear(rng, 5, 4, [Parameter("n", 0.0, sigma=1.0), Parameter("c", 0.0)], each("c"))
    model.G *= SIGMA
    data = logs_measured(model.base + model.G @ [0.3, 9.0], SIGMA)
    plain = diagnose(model, data, holdout=())
    banded = diagnose(model, replace(data, band=(1.0, 1000.0)), holdout=())
    assert plain.effects == banded.effects


@pytest.mark.parametrize(("measured_at", "where"), [(5, "every pose"), (3, "3 of 5 poses"), (1, "")])
def test_modes_below_all_of_the_model_say_that_something_stands_on_a_spring(
    measured_at: int, where: str
) -> None:
    """The building stands on a base of 60 kg and a spring to ground, which the model lacks."""
    pose, f = list[str](), list[float]()
    for number, setup in enumerate(LOADS):
        M, K = (np.pad(one, (0, 1)) for one in matrices({"k": 4e5, "brace": 0.0}, setup))
        M[-1, -1] = 60.0
        K[0, -1] = K[-1, 0] = -4e5
        K[-1, -1] = 4e5 + 2e4
        true = np.sqrt(eigh(K, M, eigvals_only=True)) / (2.0 * np.pi)
        heard = true if number < measured_at else true[1:]
        pose += [setup] * len(heard)
        f += heard.tolist()
    result = notes(Measurements.from_rows(pose, np.array(f), SIGMA * np.array(f)))
    assert result.verdict == "unexplained"
    low = [note for note in result.notes if "below the lowest mode of the declared model" in note]
    if not where:  # a row that may be no mode at all
        assert not low
        return
    (note,) = low
    assert note.startswith(f"a measured mode lies below the lowest mode of the declared model at {where}, ")
    assert note.endswith("something stands on a spring, such as the machine on its base")
