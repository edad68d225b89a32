"""A third back end takes a solver and an entry in the registry; everything that evaluates modes then uses it."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.references.loop_solver import LoopSolver
from helpers.robots.one_of_each import load_free
from pkmodes.core.robot.robot import Robot
from pkmodes.core.solve import backends
from pkmodes.core.system.evaluation import ExtendedSystem
from pkmodes.loop.updating.modes_of_systems import modes_of_systems

ROBOTS = Path(__file__).parents[3] / "robots"
#: Robots of every mechanism with poses, some of them out of reach, and an effect that releases joints.
CASES = {
    "linear-delta-2022": ([[0.6, 0.02, -0.245], [0.5, 0.05, -0.245], [9.0, 0.0, 0.0]], "clamp_compliance"),
    "clavel-delta": ([[0.01, 0.05, -0.7], [0.02, -0.03, -0.65], [2.0, 0.0, -0.7]], "link_compliance"),
    "corexy-printer": ([[0.1, 0.2], [0.15, 0.05], [0.2, 9.0]], "belt_end_compliance"),
}
#: Both solvers err by rounding of the largest eigenvalue; shapes of modes a percent apart lose two more digits.
FREQUENCY, SHAPE = 1e-9, 1e-7


@pytest.fixture(autouse=True)
def registered(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(backends.SOLVERS, LoopSolver.name, LoopSolver)


@pytest.fixture(params=[(name, released) for name in CASES for released in (False, True)], ids=str)
def model(request: pytest.FixtureRequest) -> pkmodes.Model:
    name, released = request.param
    plain = load_free(f"{name}.toml")
    return plain.with_values({f"effects.{CASES[name][1]}.compliance": 1e-6}) if released else plain


def poses_of(robot: Robot) -> list[list[float]]:
    return CASES[Path(robot.source).stem][0]


@pytest.mark.parametrize("other", ["numpy", pytest.param("compiled", marks=pytest.mark.compiler)])
def test_modes_are_those_of_the_other_back_ends(model: pkmodes.Model, other: str) -> None:
    poses = poses_of(model.robot)
    modes, expected = (model.modes(poses, "nan", backend=name) for name in (LoopSolver.name, other))
    assert modes.backend == "loop"
    assert modes.reason.tolist() == expected.reason.tolist()
    assert modes.valid.tolist() == [True, True, False]
    rigid = modes.rigid_modes
    np.testing.assert_allclose(
        modes.frequencies[:, rigid:], expected.frequencies[:, rigid:], rtol=FREQUENCY, equal_nan=True
    )
    for name in ("shapes", "platform_shapes"):
        found, wanted = (getattr(one, name)[:2, rigid:] for one in (modes, expected))
        np.testing.assert_allclose(found, wanted, rtol=0, atol=SHAPE * np.abs(wanted).max())
        assert np.isnan(getattr(modes, name)[2]).all()
    for name in ("mass_matrix", "stiffness_matrix", "joint_positions"):
        found, wanted = getattr(modes, name), getattr(expected, name)
        np.testing.assert_allclose(found, wanted, rtol=0, atol=1e-13 * np.nanmax(np.abs(wanted)))


def test_fields_alone_and_in_arrays_of_the_caller(model: pkmodes.Model) -> None:
    poses = poses_of(model.robot)[:2]
    whole = model.modes(poses, backend="loop")
    out = np.empty(whole.frequencies.shape)
    assert model.frequencies(poses, out=out, backend="loop") is out
    np.testing.assert_array_equal(out, whole.frequencies)
    alone = model.modes(poses, fields=["platform_shapes"], backend="loop").platform_shapes
    np.testing.assert_array_equal(alone, whole.platform_shapes)


def test_poses_out_of_reach_are_refused_with_the_same_words(model: pkmodes.Model) -> None:
    texts = []
    for backend in ("loop", "numpy"):
        with pytest.raises(pkmodes.PoseError) as error:
            model.frequencies(poses_of(model.robot), backend=backend)
        texts.append(str(error.value))
    assert texts[0] == texts[1]


def test_sensitivities_maps_and_diagnoses_use_it(
    model: pkmodes.Model, monkeypatch: pytest.MonkeyPatch
) -> None:
    poses, rigid = poses_of(model.robot)[:2], model.modes(poses_of(model.robot)[0]).rigid_modes
    rates, expected = (
        model.sensitivities(poses, ["gravity.x"], fields=["eigenvalues"], backend=name).eigenvalues
        for name in ("loop", "numpy")
    )
    np.testing.assert_allclose(rates, expected, rtol=0, atol=1e-6 * np.abs(expected).max() + 1e-6)
    pytest.importorskip("xarray")
    dataset = model.map(poses, backend="loop")
    np.testing.assert_array_equal(
        dataset["frequency"].values, model.frequencies(poses, backend="loop")[:, rigid:]
    )
    systems, points = [ExtendedSystem.of(model.robot)] * 2, np.tile(poses, (2, 1))
    monkeypatch.setenv("PKMODES_BACKEND", "numpy")
    by_numpy = modes_of_systems(systems, points)
    monkeypatch.setenv("PKMODES_BACKEND", "loop")
    by_loop = modes_of_systems(systems, points)
    np.testing.assert_allclose(
        by_loop.eigenvalues[:, rigid:], by_numpy.eigenvalues[:, rigid:], rtol=FREQUENCY
    )
    size = np.abs(by_numpy.motions).max()
    np.testing.assert_allclose(by_loop.motions[:, rigid:], by_numpy.motions[:, rigid:], atol=SHAPE * size)


def test_an_unknown_back_end_is_answered_with_all_names() -> None:
    model = pkmodes.load(ROBOTS / "corexy-printer.toml")
    with pytest.raises(
        pkmodes.PkmodesError, match=r'expected "auto", "numpy", "compiled" or "loop", found "C"'
    ):
        model.frequencies([0.1, 0.1], backend="C")


def test_a_batch_is_evaluated_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Also where the caller's arrays have to stay as they are if a pose is refused."""
    counts = []

    class Counting(LoopSolver):
        name = "counting"

        def compute(self, at, arrays, threads=1):  # type: ignore[no-untyped-def]
            counts.append(len(at.points))
            return super().compute(at, arrays, threads)

    monkeypatch.setitem(backends.SOLVERS, "counting", Counting)
    model = pkmodes.load(ROBOTS / "linear-delta-2022.toml")
    poses = CASES["linear-delta-2022"][0]
    out = np.full((2, 9), 7.0)
    model.modes(poses[:2], out={"frequencies": out}, backend="counting")
    assert counts == [2]
    out = np.full((3, 9), 7.0)
    with pytest.raises(pkmodes.PoseError):
        model.frequencies(poses, out=out, backend="counting")
    assert counts == [2]
    assert (out == 7.0).all()
