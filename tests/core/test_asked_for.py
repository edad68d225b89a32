"""What nobody asked for is not computed, and what a call does is worked out once for a model.

Calls are counted, and not timed; `benchmarks/one_core.py` measures what they take.
"""

from __future__ import annotations

import copy
import pickle
from collections.abc import Callable, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pkmodes
from helpers.references.loop_solver import LoopSolver
from pkmodes.core.compiled.evaluator import Evaluator, PoseBuffer
from pkmodes.core.solve import backends
from pkmodes.core.solve.fields import FIELDS
from pkmodes.core.solve.mode_fields import FieldPlan, ModeFields
from pkmodes.core.solve.results import Modes
from pkmodes.core.system.dissipation import Dissipation
from pkmodes.core.system.strain_free import StrainFreeMotions

ROBOT = Path(__file__).parents[2] / "robots/linear-delta-2022.toml"
POSES = np.array([[0.6, 0.02, -0.245], [0.5, 0.05, -0.245], [0.55, -0.03, -0.25]])
BAD = [9.0, 0.0, 0.0]
#: The fields of all that wait until they are read.
WAITING = {"damping_ratios", "vibration_amplitudes", "mass_matrix", "stiffness_matrix"}
BACKENDS = ["numpy", pytest.param("compiled", marks=pytest.mark.compiler)]
DRIVES = ["free", "held"]
#: A robot of each kind: without effects, with released joints, with losses.
KINDS: dict[str, dict[str, float]] = {
    "plain": {},
    "released": {"effects.clamp_compliance.compliance": 1e-6, "effects.gearbox_compliance.compliance": 1e-4},
    "lossy": {"damping.ratio": 0.01, "effects.clamp_compliance.compliance": 1e-6},
}


@pytest.fixture
def model() -> pkmodes.Model:
    return pkmodes.load(ROBOT)


def counting(calls: list[str], name: str, honest: Callable[..., Any]) -> Callable[..., Any]:
    def counted(*arguments: Any, **named: Any) -> Any:
        calls.append(name)
        return honest(*arguments, **named)

    return counted


@pytest.fixture
def calls(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Names of what was evaluated that takes time: damping, amplitudes."""
    made: list[str] = []
    for name in ("damping_ratios", "vibration_amplitudes"):
        field = FIELDS[name]
        monkeypatch.setitem(FIELDS, name, replace(field, function=counting(made, name, field.function)))
    honest = StrainFreeMotions.__call__
    monkeypatch.setattr(StrainFreeMotions, "__call__", counting(made, "strain-free motions", honest))
    monkeypatch.setattr(Dissipation, "matrices", counting(made, "C and K''", Dissipation.matrices))
    return made


@pytest.fixture
def filled(monkeypatch: pytest.MonkeyPatch) -> list[set[str]]:
    """The fields of each evaluation by the compiled library."""
    seen: list[set[str]] = []
    run, room = Evaluator.run, PoseBuffer.run

    def of_batch(self: Evaluator, points: Any, arrays: Mapping[str, Any], *more: Any, **named: Any) -> Any:
        seen.append(set(arrays))
        return run(self, points, arrays, *more, **named)

    def of_pose(self: PoseBuffer, point: Any) -> int:
        seen.append(set(self.arrays))
        return room(self, point)

    monkeypatch.setattr(Evaluator, "run", of_batch)
    monkeypatch.setattr(PoseBuffer, "run", of_pose)
    return seen


@pytest.mark.parametrize("backend", BACKENDS)
@pytest.mark.parametrize("poses", [POSES[0], POSES], ids=["pose", "batch"])
def test_a_machine_without_losses_has_no_damping_computed(
    model: pkmodes.Model, calls: list[str], poses: np.ndarray, backend: str
) -> None:
    by_name = model.modes(poses, fields=["damping_ratios"], backend=backend)
    assert (by_name.damping_ratios[..., by_name.rigid_modes :] == 0.0).all()
    assert np.isnan(by_name.damping_ratios[..., : by_name.rigid_modes]).all()
    read = model.modes(poses, backend=backend).damping_ratios
    np.testing.assert_array_equal(read, by_name.damping_ratios)
    assert not calls


@pytest.mark.compiler
def test_only_eigenvalues_say_whether_a_robot_without_losses_is_refused(
    model: pkmodes.Model, filled: list[set[str]]
) -> None:
    model.modes(POSES, fields=["damping_ratios"], backend="compiled")
    assert filled == [{"eigenvalues"}]


@pytest.mark.parametrize("backend", BACKENDS)
def test_free_motors_have_no_amplitudes_computed(
    model: pkmodes.Model, calls: list[str], backend: str
) -> None:
    modes = model.modes([*POSES, BAD], "nan", fields=["vibration_amplitudes"], backend=backend)
    assert modes.vibration_amplitudes.shape == (4, 9, 3)
    assert np.isnan(modes.vibration_amplitudes).all()
    assert not calls


@pytest.mark.parametrize("backend", BACKENDS)
@pytest.mark.parametrize("poses", [POSES[0], POSES], ids=["pose", "batch"])
def test_amplitudes_and_damping_are_computed_when_they_are_read_and_once(
    model: pkmodes.Model, calls: list[str], filled: list[set[str]], poses: np.ndarray, backend: str
) -> None:
    model = model.with_values(KINDS["lossy"])
    modes = model.modes(poses, drives="held", backend=backend)
    assert np.isfinite(modes.frequencies).all()
    assert np.isfinite(modes.platform_shapes).all()
    assert repr(modes).count("vibration_amplitudes") == 1
    assert not calls
    filled.clear()
    amplitudes = modes.vibration_amplitudes
    by_numpy = ["vibration_amplitudes", "strain-free motions"] if backend == "numpy" else []
    assert calls == by_numpy
    assert [one - {"eigenvalues"} for one in filled] == ([{"vibration_amplitudes"}] if not by_numpy else [])
    assert modes.vibration_amplitudes is amplitudes
    assert modes.damping_ratios is modes.damping_ratios
    assert calls == [*by_numpy, "damping_ratios", "C and K''"]
    for name in ("vibration_amplitudes", "damping_ratios"):
        by_name = model.modes(poses, fields=[name], drives="held", backend=backend)
        np.testing.assert_array_equal(getattr(modes, name), getattr(by_name, name))


@pytest.mark.compiler
@pytest.mark.parametrize("drives", DRIVES)
@pytest.mark.parametrize("poses", [POSES[0], POSES], ids=["pose", "batch"])
def test_the_library_fills_what_is_shown_and_matrices_when_they_are_read(
    model: pkmodes.Model, filled: list[set[str]], poses: np.ndarray, drives: str
) -> None:
    shown = {"frequencies", "shapes", "platform_shapes", "joint_positions"}
    modes = model.modes(poses, drives=drives, backend="compiled")
    assert len(filled) == 1
    assert filled[0] - {"eigenvalues"} == shown
    filled.clear()
    model.frequencies(poses, drives=drives, backend="compiled")
    assert filled == [{"frequencies"}]
    filled.clear()
    M = modes.mass_matrix
    assert filled == [{"mass_matrix", "stiffness_matrix"}]  # of a few poses both
    K = modes.stiffness_matrix
    assert len(filled) == 1
    expected = model.modes(poses, fields=["mass_matrix", "stiffness_matrix"], drives=drives)
    np.testing.assert_array_equal(M, expected.mass_matrix)
    np.testing.assert_array_equal(K, expected.stiffness_matrix)


def test_matrices_that_the_solver_has_are_not_evaluated_again(
    model: pkmodes.Model, monkeypatch: pytest.MonkeyPatch
) -> None:
    evaluated: list[str] = []
    system = type(model.system)
    honest = system.all_coordinates
    monkeypatch.setattr(system, "all_coordinates", counting(evaluated, "M and K", honest))
    modes = model.modes(POSES, backend="numpy")
    assert modes.mass_matrix.shape == modes.stiffness_matrix.shape == (3, 9, 9)
    assert evaluated == ["M and K"]


@pytest.mark.parametrize("drives", DRIVES)
def test_a_second_call_works_out_nothing(
    model: pkmodes.Model, drives: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    made: list[str] = []
    monkeypatch.setattr(ModeFields, "__init__", counting(made, "fields", ModeFields.__init__))
    monkeypatch.setattr("pkmodes.core.model.FieldPlan", counting(made, "plan", FieldPlan))
    monkeypatch.setattr(Evaluator, "buffer", counting(made, "room", Evaluator.buffer))
    honest = backends.solver_of
    for module in ("core.model", "core.solve.mode_fields"):
        monkeypatch.setattr(f"pkmodes.{module}.solver_of", counting(made, "solver", honest))

    def every_call() -> None:
        for poses in (POSES[0], POSES):
            model.frequencies(poses, drives=drives)
            modes = model.modes(poses, drives=drives)
            for name in WAITING:
                getattr(modes, name)
            model.modes(poses, fields=["shapes", "frequencies"], drives=drives)
            model.modes(poses, fields=["frequencies", "shapes", "shapes"], drives=drives)
            model.modes(poses, out={"frequencies": np.empty(modes.frequencies.shape)}, drives=drives)
            model.shaper("zv", poses)

    every_call()
    assert made.count("solver") <= 2
    kept = len(model._plans), len(model._fields_of)
    made.clear()
    every_call()
    assert not made
    assert (len(model._plans), len(model._fields_of)) == kept


def test_models_do_not_share_plans(model: pkmodes.Model) -> None:
    heavier = model.with_values({"platform.mass": 2.0 * float(model.robot.parameters.platform_mass)})
    first, other = (one.modes(POSES[0]).frequencies for one in (model, heavier))
    assert (first[3:] > other[3:]).any()
    np.testing.assert_array_equal(model.modes(POSES[0]).frequencies, first)


@pytest.mark.parametrize("backend", BACKENDS)
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("drives", DRIVES)
def test_fields_read_later_are_those_asked_for_by_name(
    model: pkmodes.Model, kind: str, drives: str, backend: str
) -> None:
    model, poses = model.with_values(KINDS[kind]), np.array([*POSES, BAD, [np.nan, 0.0, 0.0]])
    names = Modes.fields_of(model.mechanism)
    together = model.modes(poses, "nan", drives=drives, backend=backend)
    by_name = model.modes(poses, "nan", fields=names, drives=drives, backend=backend)
    assert not WAITING & vars(together).keys() - {*(WAITING if backend == "numpy" else ())}
    for name in names:
        alone = model.modes(poses, "nan", fields=[name], drives=drives, backend=backend)
        for one in (by_name, alone):
            np.testing.assert_array_equal(getattr(together, name), getattr(one, name), strict=True)
            np.testing.assert_array_equal(one.poses, poses)
            assert (one.coordinates, one.rigid_modes) == (together.coordinates, together.rigid_modes)
    frequencies = model.frequencies(poses, "nan", drives=drives, backend=backend)
    np.testing.assert_array_equal(frequencies, together.frequencies, strict=True)
    assert np.isnan(together.mass_matrix[3:]).all()


@pytest.mark.compiler
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("drives", DRIVES)
def test_a_pose_alone_has_the_bits_that_it_has_among_others(
    model: pkmodes.Model, kind: str, drives: str
) -> None:
    model = model.with_values(KINDS[kind])
    among = model.modes(POSES, drives=drives, backend="compiled")
    names = [name for name in Modes.fields_of(model.mechanism) if name not in WAITING]
    for fields in (None, *([name] for name in names)):
        for i, pose in enumerate(POSES):
            for one in (pose, pose[None], pose[None, None], pose.tolist()):
                alone = model.modes(one, fields=fields, drives=drives, backend="compiled")
                for name in fields or names:
                    array = getattr(alone, name)
                    assert array.shape == np.shape(one)[:-1] + getattr(among, name).shape[1:]
                    np.testing.assert_array_equal(
                        array.reshape(getattr(among, name)[i].shape), getattr(among, name)[i]
                    )


@pytest.mark.compiler
def test_results_of_poses_do_not_share_memory(model: pkmodes.Model) -> None:
    first, other = model.modes(POSES[0], backend="compiled"), model.modes(POSES[1], backend="compiled")
    before = first.shapes.copy()
    other.shapes[...] = 7.0
    assert not np.shares_memory(first.shapes, other.shapes)
    np.testing.assert_array_equal(first.shapes, before)
    np.testing.assert_array_equal(model.modes(POSES[0], backend="compiled").shapes, before)


@pytest.mark.compiler
def test_poses_that_numpy_solves_have_its_matrices(model: pkmodes.Model) -> None:
    """Also where they are read later: a joint so stiff that the library leaves the pose to NumPy.

    The library rounds K in another place.
    """
    model = model.with_values({"effects.gearbox_compliance.compliance": 1e-10})
    modes, by_numpy = (model.modes(POSES, backend=backend) for backend in ("compiled", "numpy"))
    for name in ("frequencies", "shapes", "mass_matrix", "stiffness_matrix"):
        np.testing.assert_array_equal(getattr(modes, name), getattr(by_numpy, name))
    alone = model.modes(POSES[0], backend="compiled")
    np.testing.assert_array_equal(alone.frequencies, model.modes(POSES[0], backend="numpy").frequencies)


def test_what_is_read_later_does_not_follow_what_the_caller_changes(
    model: pkmodes.Model, monkeypatch: pytest.MonkeyPatch
) -> None:
    counts: list[int] = []

    class Counting(LoopSolver):
        name = "counting"

        def compute(self, at, arrays, threads=1):  # type: ignore[no-untyped-def]
            counts.append(len(at.points))
            return super().compute(at, arrays, threads)

    monkeypatch.setitem(backends.SOLVERS, "counting", Counting)
    model, poses = model.with_values(KINDS["lossy"]), np.array([*POSES, BAD])
    wanted = model.modes(poses, "nan", drives="held", backend="counting")
    M, zeta, w = wanted.mass_matrix, wanted.damping_ratios, wanted.vibration_amplitudes
    monkeypatch.setenv("PKMODES_BACKEND", "counting")
    modes = model.modes(poses, "nan", drives="held")
    monkeypatch.setenv("PKMODES_BACKEND", "numpy")
    for changed in (modes.poses, modes.shapes, modes.codes, modes.frequencies, poses):
        changed[...] = 1
    counts.clear()
    np.testing.assert_array_equal(modes.damping_ratios, zeta)
    assert counts == [3]  # by the back end of the call
    np.testing.assert_array_equal(modes.vibration_amplitudes, w)
    np.testing.assert_array_equal(modes.mass_matrix, M)
    plain = pkmodes.load(ROBOT).modes([*POSES, BAD], "nan")
    plain.codes[...] = 1
    assert (plain.damping_ratios[:3, plain.rigid_modes :] == 0.0).all()


@pytest.mark.parametrize("again", [copy.copy, copy.deepcopy, lambda modes: pickle.loads(pickle.dumps(modes))])
def test_copies_have_all_fields_and_stand_alone(
    model: pkmodes.Model, again: Callable[[Modes], Modes]
) -> None:
    modes, whole = (model.modes([*POSES, BAD], "nan", drives="held") for _ in range(2))
    copied = again(modes)
    for name in Modes.fields_of(model.mechanism):
        np.testing.assert_array_equal(vars(copied)[name], getattr(whole, name))
    assert repr(copied) == repr(whole) == repr(modes)
    with pytest.raises(AttributeError, match="no attribute 'masses'"):
        _ = copied.masses  # type: ignore[attr-defined]


def test_repr_html_and_datasets_are_the_same_before_fields_are_read(model: pkmodes.Model) -> None:
    modes, read = (model.modes([*POSES, BAD], "nan", drives="held") for _ in range(2))
    for name in Modes.fields_of(model.mechanism):
        getattr(read, name)
    assert repr(modes) == repr(read)
    assert "mass_matrix (4, 9, 9)" in repr(modes)
    assert modes._repr_html_() == read._repr_html_()
    assert not WAITING & vars(modes).keys()
    pytest.importorskip("xarray")
    assert modes.to_dataset().identical(read.to_dataset())
    assert "mass_matrix" not in vars(modes)


@pytest.mark.parametrize("drives", DRIVES)
def test_threads_that_share_a_model_do_not_disturb_each_other(model: pkmodes.Model, drives: str) -> None:
    poses = np.repeat(POSES, 40, axis=0)
    expected = model.modes(poses, drives=drives)

    def one(i: int) -> tuple[np.ndarray, np.ndarray]:
        modes = model.modes(poses[i], drives=drives)
        return modes.shapes, model.frequencies(poses[i], drives=drives)

    with ThreadPoolExecutor(4) as pool:
        found = list(pool.map(one, range(len(poses))))
    for i, (shapes, frequencies) in enumerate(found):
        np.testing.assert_array_equal(shapes, expected.shapes[i])
        np.testing.assert_array_equal(frequencies, expected.frequencies[i])


def test_a_mechanism_is_shown_in_a_line(model: pkmodes.Model) -> None:
    assert repr(model.mechanism) == "Mechanism('linear_delta', pose (x, y, z), 9 coordinates)"
