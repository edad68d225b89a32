"""Robots with values set in some setups: each setup has the modes of the robot with its values."""

from __future__ import annotations

import pickle
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
import pytest
from scipy.linalg import eigh

from helpers.diagnoses.robot_structures import declared, index, structure_at, suspected
from pkmodes import Robot, read_robot, updating
from pkmodes.cli import run
from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.system.evaluation import ExtendedSystem
from pkmodes.loop.diagnosis import Measurements, Prediction
from pkmodes.loop.sensitivity.paths import resolve
from pkmodes.loop.updating.candidates import suspects
from pkmodes.loop.updating.predictions import Motions, predict_along, solve_together
from pkmodes.loop.updating.robot_structure import RobotStructure
from pkmodes_rig.robots import POSES, read

COREXY = Path(__file__).parents[3] / "robots" / "corexy-printer.toml"
PAYLOAD = "effects.payload.mass"
TENSION = "effects.belt_tension_stiffness.tension"
COEFFICIENT = "effects.belt_tension_stiffness.coefficient"
BELTS = "belt.specific_stiffness"
Loads = Sequence[Mapping[str, float]]


def structure(
    robot: Robot, points: np.ndarray, loads: Loads, candidates: Sequence[str] | None = None
) -> RobotStructure:
    names = sorted({name for load in loads for name in load})
    settings = {name: [load.get(name, np.nan) for load in loads] for name in names}
    return structure_at(robot, points, candidates, settings=settings)


def same(a: Prediction, b: Prediction, rows: Sequence[int], others: Sequence[int]) -> None:
    """To the last digit."""
    np.testing.assert_array_equal(a.eigenvalues[rows], b.eigenvalues[others])
    np.testing.assert_array_equal(a.rates[rows], b.rates[others])
    np.testing.assert_array_equal(a.shapes[rows], b.shapes[others])
    assert a.rigid == b.rigid
    if a.shape_rates is not None:
        np.testing.assert_array_equal(np.asarray(a.shape_rates)[rows], np.asarray(b.shape_rates)[others])


@pytest.mark.parametrize("name", ["published", "asymmetric"])
@pytest.mark.parametrize("masses", [(0.2, 0.7, 0.2, 0.7), (0.2, np.nan, 0.2, 0.2), (0.1, 0.2, 0.3, 0.4)])
def test_a_setup_with_a_payload_has_the_modes_of_the_robot_with_it(
    name: str, masses: tuple[float, ...]
) -> None:
    """Values and derivatives agree with separate robots whose files declare the payload."""
    robot, points = read(name), np.array(POSES[name]["scattered"][:4])
    loads = [{} if np.isnan(m) else {PAYLOAD: m} for m in masses]
    one = structure(robot, points, loads, ("parameter:link.length", "measurement:yaw", "belt_mass"))
    values = declared(one, {"platform.mass": 0.05, "link.length": 1e-3, "measurement.yaw": 0.01})
    by = list(range(len(one.parameters)))
    found = one.predict(values, by, shape_rates=True)
    for mass in set(masses) - {np.nan}:
        rows = [i for i, m in enumerate(masses) if m == mass]
        if not rows:
            continue
        alone = robot.with_values({PAYLOAD: mass})
        separate = suspected(alone, points[rows], [c.name for c in one.candidates[:3]])
        names = [p.name for p in separate.parameters]
        order = [names.index(p.name) for p in one.parameters]
        there = np.empty(len(names))
        there[order] = values
        expected = separate.predict(there, order, shape_rates=True)
        if len(rows) > 1:  # of a single pose NumPy's numbers round otherwise than its arrays
            np.testing.assert_array_equal(found.eigenvalues[rows], expected.eigenvalues)
        np.testing.assert_allclose(found.eigenvalues[rows], expected.eigenvalues, rtol=1e-10, atol=1e-4)
        size = np.abs(expected.rates).max(axis=(0, 1))
        assert (np.abs(found.rates[rows] - expected.rates) <= 1e-9 * size).all()
        np.testing.assert_allclose(found.shapes[rows], expected.shapes, atol=1e-8)
        assert expected.shape_rates is not None
        along = np.asarray(expected.shape_rates)
        size = np.abs(along).max(axis=(0, 1, 2)) + 1e-12
        assert (np.abs(np.asarray(found.shape_rates)[rows] - along) <= 1e-6 * size).all()


def test_without_settings_and_with_blank_ones_a_structure_is_the_same() -> None:
    robot, points = read("published"), np.array(POSES["published"]["scattered"][:3])
    plain = suspected(robot, points)
    for loads in ([{}, {}, {}], [{PAYLOAD: np.nan}, {}, {}]):
        one = structure(robot, points, loads)
        assert one.candidates == plain.candidates
        some = [i for i, p in enumerate(one.parameters) if p.sigma]
        same(one.predict(declared(one), some), plain.predict(declared(plain), some), range(3), range(3))


def test_subsets_keep_the_set_values_and_other_places_drop_them() -> None:
    robot, points = read("published"), np.array(POSES["published"]["scattered"][:4])
    one = structure(robot, points, [{PAYLOAD: 0.3}, {}, {PAYLOAD: 0.3}, {PAYLOAD: 0.5}], ("belt_mass",))
    values, by = declared(one, {"platform.mass": 0.02}), [0, 1]
    whole = one.predict(values, by, shape_rates=True)
    same(one.subset([3, 1]).predict(values, by, shape_rates=True), whole, [0, 1], [3, 1])
    twin = pickle.loads(pickle.dumps(one))
    same(twin.predict(values, by, shape_rates=True), whole, range(4), range(4))
    rates = one.position_rates(values).rates
    step = 1e-6 * np.eye(3)
    for k in range(3):
        there, back = (
            structure(
                robot,
                points + sign * step[k],
                [{PAYLOAD: 0.3}, {}, {PAYLOAD: 0.3}, {PAYLOAD: 0.5}],
                ("belt_mass",),
            ).predict(values, ())
            for sign in (1, -1)
        )
        expected = (there.eigenvalues - back.eigenvalues) / 2e-6
        np.testing.assert_allclose(
            rates[:, 3:, k], expected[:, 3:], rtol=1e-5, atol=1e-4 * np.abs(expected).max()
        )
    places, there = one.elsewhere(5)
    plain = suspected(robot, places, ("belt_mass",))
    same(there.predict(values, by), plain.predict(values, by), range(5), range(5))
    assert there.settings == ()


def test_several_sets_of_values_are_those_taken_one_by_one() -> None:
    robot, points = read("asymmetric"), np.array(POSES["asymmetric"]["scattered"][:4])
    one = structure(robot, points, [{PAYLOAD: 0.1}, {PAYLOAD: 0.2}, {}, {PAYLOAD: 0.1}], ("parameters",))
    rng, by = np.random.default_rng(3), []
    values = np.tile(declared(one), (6, 1))
    for k in range(6):
        by.append(sorted(rng.choice(len(one.parameters), 3, replace=False).tolist()))
        values[k, by[k]] += 0.01 * np.maximum(np.abs(values[k, by[k]]), 1e-4)
    batches = one.predict_many(values, by, shape_rates=True)
    assert max(len(batch.sets) for batch in batches) > 1
    for batch in batches:
        for place, k in enumerate(batch.sets):
            alone = one.predict(values[k], by[k], shape_rates=True)
            part = slice(4 * place, 4 * place + 4)
            np.testing.assert_allclose(
                batch.prediction.eigenvalues[part], alone.eigenvalues, rtol=1e-10, atol=1e-3
            )
            np.testing.assert_allclose(batch.prediction.shapes[part], alone.shapes, atol=1e-7)
            size = np.abs(alone.rates).max()
            np.testing.assert_allclose(batch.prediction.rates[part][..., :3], alone.rates, atol=1e-7 * size)


def test_set_values_do_not_move_and_the_rest_of_a_shared_value_does() -> None:
    """A value of one axis is known and the shared one moves the others; a whole is known; against differences."""
    robot, points = read("published"), np.array(POSES["published"]["scattered"][:3])
    loads: Loads = [{"axis.1.belt.width": 0.02}, {"belt.width": 0.02, "axis.span": 1.3}, {}]
    names = ("parameter:belt.width", "parameter:axis.span", "parameter:platform.mass")
    one = structure(robot.with_values({"platform.mass": {"sigma": None}}), points, loads, names)
    by = [index(one, name) for name in ("belt.width", "axis.span")]
    found = one.predict(declared(one), by).rates[:, 3:]
    assert not found[1].any()
    assert (np.abs(found[[0, 2]]).max(axis=1) > 0.0).all()
    for k, step in enumerate((1e-7, 1e-6)):
        ends = []
        for sign in (1, -1):
            values = declared(one)
            values[by[k]] += sign * step
            ends.append(one.predict(values, ()).eigenvalues[:, 3:])
        expected = (ends[0] - ends[1]) / (2 * step)
        np.testing.assert_allclose(found[..., k], expected, atol=2e-6 * np.abs(expected).max())
    # The robot of the first setup with another width of the two that are not known.
    values = declared(one)
    values[by[0]] = 0.018
    alone = robot.with_values({"belt.width": 0.018, "axis.1.belt.width": 0.02})
    expected = RobotStructure(alone, points[:1], [], [], {}).predict(np.empty(0), ()).eigenvalues
    np.testing.assert_allclose(one.predict(values, ()).eigenvalues[:1], expected, rtol=1e-10, atol=1e-4)


def test_setups_may_have_more_modes_than_others() -> None:
    """A compliant gearbox in one, a cable to ground in another: rigid modes first, missing modes far above."""
    robot, points = read("published"), np.array(POSES["published"]["scattered"][:4])
    cable, gear, belts = (
        f"effects.{name}"
        for name in ("cable_stiffness.stiffness", "gearbox_compliance.compliance", "belt_mass.linear_density")
    )
    clamp = "effects.clamp_compliance.compliance"
    loads: Loads = [{gear: 5e-4}, {cable: 2e4}, {clamp: 1e-7}, {clamp: 1e-7, belts: 0.1}]
    one = structure(robot, points, loads, ("parameter:link.mass",))
    by = [i for i, p in enumerate(one.parameters) if not p.name.startswith("effects.")]
    found = one.predict(declared(one), by, shape_rates=True)
    assert found.rigid == 3
    assert np.isfinite(found.eigenvalues).all()
    for i, load in enumerate(loads):
        alone = robot.with_values(dict(load))
        separate = suspected(alone, points[[i]], ("parameter:link.mass",))
        expected = separate.predict(declared(separate), by, shape_rates=True)
        elastic = slice(3, 3 + expected.eigenvalues.shape[1] - expected.rigid)
        np.testing.assert_array_equal(
            found.eigenvalues[i, elastic], expected.eigenvalues[0, expected.rigid :]
        )
        np.testing.assert_array_equal(found.rates[i, elastic], expected.rates[0, expected.rigid :])
        np.testing.assert_array_equal(found.shapes[i, elastic], expected.shapes[0, expected.rigid :])
        lacking = found.eigenvalues[i, elastic.stop :]
        assert (lacking > 1e30).all()
        assert (lacking[1:] > 10.0 * lacking[:-1]).all(), "apart from each other, too"
    count = [(row[3:] < 1e30).sum() for row in found.eigenvalues]
    assert count == [9, 9, 6, 9]


def test_robots_evaluated_together_have_the_derivatives_of_each_alone() -> None:
    """Of shapes, too, along the geometry, which moves the platform's Jacobian."""
    robot, points = read("published"), np.array(POSES["published"]["scattered"][:2])
    moves = Motions((resolve(robot, "link.length"),), None)
    one, two = (
        solve_together([robot] * n, [ExtendedSystem.of(robot)] * n, np.tile(points, (n, 1))) for n in (1, 2)
    )
    alone, both = predict_along(one, [moves], True), predict_along(two, [moves, moves], True)
    for half in (slice(0, 2), slice(2, 4)):
        np.testing.assert_allclose(both.shape_rates[half], alone.shape_rates, rtol=1e-9, atol=1e-9)


def corexy_matrices(
    pose: Sequence[float], tension: float, coefficient: float, unit: float = 2.6e6 * 6e-3
) -> tuple[np.ndarray, np.ndarray]:
    """M and K of the CoreXY in robots/, from the contract: V_el = sum of k/2 (g . (dx, dy) + R dtheta)^2."""
    K, radius, rotor = np.zeros((4, 4)), 6.37e-3, 2e-7 + 5.4e-6
    for i, (g, lengths) in enumerate(zip(((1, -1), (-1, -1)), ((0.45, 0.75), (0.75, 0.75)), strict=True)):
        grown = g[0] * pose[0] + g[1] * pose[1]
        k = unit * (1 + coefficient * tension) * (1 / (lengths[0] + grown) + 1 / (lengths[1] - grown))
        strained = np.array([*g, 0.0, 0.0])
        strained[2 + i] = radius
        K += k * np.outer(strained, strained)
    return np.diag([0.5, 0.5 + 0.7, rotor, rotor]), K


def corexy_frequencies(pose: Sequence[float], tension: float, coefficient: float, unit: float) -> np.ndarray:
    M, K = corexy_matrices(pose, tension, coefficient, unit)
    return np.sqrt(eigh(K, M)[0][2:]) / (2 * np.pi)


PLACES = np.array([(0.05, 0.05), (0.25, 0.05), (0.15, 0.15), (0.05, 0.25), (0.25, 0.25), (0.1, 0.2)])
TENSIONS = (20.0, 40.0, 60.0)


def corexy_modes(coefficient: float, factor: float, seed: int) -> Measurements:
    """Modes at several tensions with 0.2 % noise."""
    rng, unit = np.random.default_rng(seed), 2.6e6 * 6e-3 * factor
    rows = [(i, t) for i in range(len(PLACES)) for t in TENSIONS]
    f = np.concatenate([corexy_frequencies(PLACES[i], t, coefficient, unit) for i, t in rows])
    f *= np.exp(0.002 * rng.standard_normal(len(f)))
    return Measurements.from_rows(
        [f"P{i} {t:g} N" for i, t in rows for _ in range(2)],
        f,
        0.002 * f,
        points=np.repeat([PLACES[i] for i, _ in rows], 2, axis=0),
        components={"x": "m", "y": "m"},
        settings={TENSION: np.repeat([t for _, t in rows], 2)},
    )


def test_the_derivative_with_respect_to_a_coefficient_includes_known_tensions() -> None:
    robot, points = read_robot(COREXY), PLACES[:4]
    loads: Loads = [{TENSION: 30.0}, {TENSION: 60.0}, {}, {TENSION: 0.0}]
    one = structure(robot, points, loads, ("belt_tension_stiffness",))
    i = index(one, COEFFICIENT)
    values = declared(one, {COEFFICIENT: 1e-3})
    found = one.predict(values, [i]).rates[:, 2:, 0]
    squares = [
        [(2 * np.pi * corexy_frequencies(p, t, c, 2.6e6 * 6e-3)) ** 2 for c in (1e-3 + 1e-6, 1e-3 - 1e-6)]
        for p, t in zip(points, (30.0, 60.0, 0.0, 0.0), strict=True)
    ]
    expected = np.array([(there - back) / 2e-6 for there, back in squares])
    np.testing.assert_allclose(found, expected, rtol=1e-6, atol=1e-3)
    assert not found[2:].any()


def test_a_coefficient_is_recovered_from_modes_at_several_tensions(tmp_path: Path) -> None:
    robot, data = read_robot(COREXY), corexy_modes(2e-3, 1.03, 1)
    assert "belt_tension_stiffness" not in {c.name for c in suspects(robot)[1]}
    found = updating.diagnose(robot, data)
    assert found.verdict == "effect_found"
    assert [effect.members for effect in found.effects] == [("belt_tension_stiffness",)]
    (value,) = found.effects[0].parameters
    assert value.value == pytest.approx(2e-3, abs=4 * value.sigma)
    assert value.sigma < 2e-4
    held = [row for row in found.rows if row.held_out]
    assert held
    assert found.after is not None
    assert found.after.held_out_rms_relative is not None
    assert found.after.held_out_rms_relative < 0.005
    # The corrected file has the coefficient, and no tension: that belongs to the measurements.
    updating.save_robot(robot, found, tmp_path / "corrected.toml")
    text = (tmp_path / "corrected.toml").read_text(encoding="utf-8")
    assert "coefficient" in text
    assert "tension =" not in text
    assert updating.diagnose(read_robot(tmp_path / "corrected.toml"), data).verdict == "adequate"
    updated = updating.update(
        robot.with_values({COEFFICIENT: {"value": 0.0, "sigma": 5e-3}}), data, holdout=()
    ).values
    assert updated[COEFFICIENT] == pytest.approx(2e-3, abs=3e-4)


def test_a_coefficient_is_told_from_a_wrong_stiffness() -> None:
    robot = read_robot(COREXY).with_values({BELTS: {"sigma": None}})
    for coefficient, factor, cause in (
        (2e-3, 1.0, "belt_tension_stiffness"),
        (0.0, 1.1, f"parameter:{BELTS}"),
    ):
        names = ["effects", f"parameter:{BELTS}"]
        found = updating.diagnose(robot, corexy_modes(coefficient, factor, 2), candidates=names)
        assert found.verdict == "effect_found", found.reason
        (effect,) = found.effects
        assert cause in effect.members
        assert not {"belt_tension_stiffness", f"parameter:{BELTS}"} <= set(effect.members)
        rows = updating.compare(robot, corexy_modes(coefficient, factor, 2)).rows
        assert {row.load[TENSION] for row in rows} == set(TENSIONS)


def test_a_value_set_in_every_setup_is_not_a_suspect() -> None:
    robot, points = read("published"), np.array(POSES["published"]["scattered"][:2])
    loads: Loads = [{PAYLOAD: 0.1, "platform.mass": 1.4}, {PAYLOAD: 0.3, "platform.mass": 1.5}]
    one = structure(robot, points, loads)
    assert "payload" not in {c.name for c in one.candidates}
    assert "platform.mass" not in {p.name for p in one.parameters}
    with pytest.raises(PkmodesError, match="the measurements set it at every pose"):
        structure(robot, points, loads, ("payload",))
    assert "payload" in {c.name for c in structure(robot, points, [loads[0], {}]).candidates}


def test_proposed_payloads_are_relative_to_the_mass_of_the_platform() -> None:
    robot, points = read("published"), np.array(POSES["published"]["scattered"][:3])
    one = structure(robot, points, [{PAYLOAD: 0.3}, {}, {}], ("belt_mass",))
    loaded = one.elsewhere(2)[1].loaded()
    assert [load for load, _ in loaded] == [{PAYLOAD: mass} for mass in (0.15, 0.45, 1.5)]
    for load, there in loaded:
        alone = RobotStructure(robot.with_values(load), there.points, [], [], {})
        expected = alone.predict(np.empty(0), ()).eigenvalues
        np.testing.assert_array_equal(there.predict(declared(there), ()).eigenvalues, expected)
    (load, _), *_ = structure(read_robot(COREXY), PLACES, [{}] * 6).loaded()
    assert load == {PAYLOAD: 0.05}  # a tenth of the tool head's


def test_the_command_says_which_constants_only_the_measurements_have(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    data = corexy_modes(2e-3, 1.0, 2)
    rows = [
        f"{data.labels[i]},{data.points[i][0]},{data.points[i][1]},{f},{sigma},{data.set_values[i][0]}"
        for i, f, sigma in zip(data.pose, data.frequency, data.sigma, strict=True)
    ]
    (tmp_path / "modes.csv").write_text(
        "\n".join(["# drives: free", f"pose,x,y,frequency,sigma,set:{TENSION}", *rows])
    )
    saved = tmp_path / "corrected.toml"
    arguments = [
        COREXY,
        tmp_path / "modes.csv",
        "--candidates",
        "belt_tension_stiffness",
        "--save-robot",
        saved,
    ]
    assert run(["diagnose", *map(str, arguments)]) == 0
    out = " ".join(capsys.readouterr().out.split())
    assert f"{TENSION} is known from the measurements alone: add its value in operation to {saved}" in out
