"""Fields of results: only requested fields are computed and kept, optionally in arrays of the caller."""

from __future__ import annotations

import copy
import json
import pickle
import tracemalloc
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.robots.robot_text import PUBLISHED
from pkmodes.core import model as model_module
from pkmodes.core.base.errors import NotComputedError
from pkmodes.core.solve import batch, mode_fields
from pkmodes.loop.sensitivity import sensitivities as sensitivity_module
from pkmodes.loop.sensitivity.sensitivities import Sensitivities

pytestmark = pytest.mark.usefixtures("backend")

POSE = np.array([0.6, 0.03, -0.245])
CENTRE = np.array([0.0, 0.0, 0.1])
EFFECTS = {"effects.gearbox_compliance.compliance": 1e-4, "effects.clamp_compliance.compliance": 1e-7}
PATHS = ["platform.mass", "link.length", "axis.span", "belt.width", "effects.link_compliance.compliance"]
BAD = [[9.0, 9.0, 9.0], [0.6, 0.0, 0.0], [0.1, 0.0, -0.245], [np.nan, 0.0, 0.0]]


@pytest.fixture(scope="module")
def extended(model: pkmodes.Model) -> pkmodes.Model:
    return model.with_values(EFFECTS)


@pytest.fixture(scope="module")
def tower(tmp_path_factory: pytest.TempPathFactory) -> pkmodes.Model:
    """A printer with three identical vertical rails: on its axis, modes come in pairs."""
    axes = ""
    for x, y in ((1.0, 0.0), (-0.5, 0.75**0.5), (-0.5, -(0.75**0.5))):
        axes += f"""
[[axis]]
origin = [{0.17 * x!r}, {0.17 * y!r}, 0]
direction = [0, 0, 1]
joint = [{0.03 * x!r}, {0.03 * y!r}, 0]
limits = ["0 mm", "900 mm"]
driven_pulley = 1
branch = 1
"""
    head = Path(PUBLISHED).read_text(encoding="utf-8").split("[[axis]]")[0]
    path = tmp_path_factory.mktemp("tower") / "tower.toml"
    path.write_text(head.replace("400 mm", "300 mm") + axes, encoding="utf-8")
    return pkmodes.load(path)


def around(pose: np.ndarray, *batch: int) -> np.ndarray:
    return pose + np.random.default_rng(5).uniform(-0.02, 0.02, (*batch, 3))


def test_digits_do_not_depend_on_the_parts(extended: pkmodes.Model, monkeypatch: pytest.MonkeyPatch) -> None:
    poses = np.concatenate([around(POSE, 19), BAD, around(POSE, 4)])
    whole, derivatives = extended.modes(poses, "nan"), extended.sensitivities(poses, PATHS, on_error="nan")
    rates = extended.sensitivities(poses, PATHS, on_error="nan", fields=["frequencies"]).frequencies
    statics = extended.statics(poses, "nan")
    monkeypatch.setattr(batch, "CHUNK", 6)
    monkeypatch.setattr(mode_fields, "CHUNK", 6)
    monkeypatch.setattr(model_module, "CHUNK", 6)
    monkeypatch.setattr(sensitivity_module, "POSES_PER_PART", 6)
    for name in pkmodes.Modes.FIELDS:
        np.testing.assert_array_equal(getattr(extended.modes(poses, "nan"), name), getattr(whole, name))
    parts = extended.sensitivities(poses, PATHS, on_error="nan")
    for name in Sensitivities.FIELDS:
        np.testing.assert_array_equal(getattr(parts, name), getattr(derivatives, name))
    again = extended.sensitivities(poses, PATHS, on_error="nan", fields=["frequencies"])
    np.testing.assert_array_equal(again.frequencies, rates)
    np.testing.assert_array_equal(extended.statics(poses, "nan").torques, statics.torques)


def test_what_was_not_asked_for_says_so(model: pkmodes.Model) -> None:
    modes = model.modes(POSE, fields=["platform_shapes", "frequencies"])
    with pytest.raises(NotComputedError, match=r"the field shapes was not requested") as error:
        _ = modes.shapes
    assert error.match(r'call Model\.modes with fields=\("frequencies", "shapes", "platform_shapes"\)')
    assert isinstance(error.value, pkmodes.PkmodesError)
    assert not hasattr(modes, "mass_matrix")
    assert hasattr(modes, "frequencies")
    np.testing.assert_array_equal(model.frequencies(POSE), modes.frequencies)
    with pytest.raises(AttributeError, match="'Modes' object has no attribute 'frequency'"):
        _ = modes.frequency
    found = model.sensitivities(POSE, ["platform.mass"], fields=["frequencies"])
    with pytest.raises(NotComputedError, match=r"Model\.sensitivities with fields="):
        _ = found.shapes
    assert repr(modes) == "Modes(1 of 1 valid; frequencies (9,), platform_shapes (9, 3))"
    with pytest.raises(AttributeError):
        modes.frequencies = np.zeros(9)


def test_results_are_copied_and_pickled_with_the_fields_that_they_have(model: pkmodes.Model) -> None:
    modes = model.modes([POSE, BAD[0]], on_error="nan", fields=["frequencies"])
    for twin in (copy.copy(modes), copy.deepcopy(modes), pickle.loads(pickle.dumps(modes))):
        np.testing.assert_array_equal(twin.frequencies, modes.frequencies)
        assert twin.reason.tolist() == ["", "reachable"]
        with pytest.raises(NotComputedError):
            _ = twin.shapes


@pytest.mark.parametrize(
    ("fields", "what", "remedy"),
    [
        ("frequencies", 'expected a list of fields, found "frequencies"', r'write \["frequencies"\]'),
        (3, "expected a list of fields, found 3", "for example: "),
        (["frequency"], 'unknown field "frequency"', 'did you mean "frequencies"'),
        (["zzz"], 'unknown field "zzz"', "known: "),
        ("zzz", 'unknown field "zzz"', "known: "),
        ("frequencies", "expected a list of fields", r'write \["frequencies"\]'),
        ([None], "unknown field None", "known: "),
        ([], "expected at least one field", "known: "),
    ],
)
def test_fields_that_are_not_there_are_refused(
    model: pkmodes.Model, fields: object, what: str, remedy: str
) -> None:
    for method in (model.modes, model.sensitivities):
        with pytest.raises(pkmodes.PkmodesError, match=what) as error:
            method(POSE, fields=fields)
        assert error.match(remedy)


def test_the_word_all_stands_for_every_name(model: pkmodes.Model) -> None:
    assert model.modes(POSE, fields="all").frequencies.shape == model.modes(POSE).frequencies.shape
    every, said = model.sensitivities(POSE), model.sensitivities(POSE, "all", fields="all")
    assert said.parameters == every.parameters
    np.testing.assert_array_equal(said.frequencies, every.frequencies)


def test_the_list_that_a_remedy_names_is_accepted(model: pkmodes.Model) -> None:
    for method in (model.modes, model.sensitivities):
        with pytest.raises(pkmodes.PkmodesError, match="expected a list of fields") as error:
            method(POSE, fields="frequencies")
        verb, _, fields = error.value.remedy.partition(" ")
        assert verb == "write"
        result = method(POSE, fields=json.loads(fields))
        np.testing.assert_allclose(result.frequencies, method(POSE).frequencies, rtol=1e-6)


def places(shape: tuple[int, ...]) -> list[np.ndarray]:
    """Arrays to fill: contiguous, in Fortran order, and views of larger ones."""
    large = np.full((*(2 * n for n in shape),), 7.0)
    return [np.empty(shape), np.empty(shape, order="F"), large[tuple(slice(None, None, 2) for _ in shape)]]


def test_arrays_are_filled_in_place(model: pkmodes.Model) -> None:
    poses = around(POSE, 3, 4)
    poses[1, 2] = BAD[0]
    expected = model.modes(poses, on_error="nan")
    for out in places((3, 4, 9, 3)):
        found = model.modes(poses, on_error="nan", out={"platform_shapes": out})
        assert found.platform_shapes is out
        assert not hasattr(found, "frequencies")  # by default the fields of out
        np.testing.assert_array_equal(out, expected.platform_shapes)
        assert np.isnan(out[1, 2]).all()
    for out in places((3, 4, 9)):
        assert model.frequencies(poses, on_error="nan", out=out) is out
        np.testing.assert_array_equal(out, expected.frequencies)
    both = model.modes(poses, "nan", fields=["frequencies", "shapes"], out={"shapes": np.empty((3, 4, 9, 9))})
    np.testing.assert_array_equal(both.shapes, expected.shapes)
    np.testing.assert_array_equal(both.frequencies, expected.frequencies)
    one = np.zeros((2, 9))
    model.frequencies(POSE, out=one[1])
    np.testing.assert_array_equal(one, [np.zeros(9), model.frequencies(POSE)])
    groups = np.zeros((3, 4, 9), dtype=np.intp)
    model.sensitivities(poses, ["platform.mass"], on_error="nan", out={"groups": groups})
    assert groups[1, 2].tolist() == [-1] * 9
    assert groups[0, 0].tolist() == list(range(9))


def test_arrays_of_invalid_poses_alone_are_filled_too(model: pkmodes.Model) -> None:
    out = np.zeros((2, 9))
    model.frequencies(BAD[:2], on_error="nan", out=out)
    assert np.isnan(out).all()
    with pytest.raises(pkmodes.PkmodesError, match="expected an array of shape"):
        model.frequencies(BAD[:2], on_error="nan", out=np.zeros((3, 9)))


def frozen(*shape: int) -> np.ndarray:
    array = np.zeros(shape)
    array.flags.writeable = False
    return array


SHARED = np.zeros((9, 9))


UNFIT = [
    (
        {"frequencies": np.zeros(8)},
        r"expected an array of shape \(9,\) and type float64, found shape \(8,\)",
    ),
    ({"frequencies": np.zeros((1, 9))}, "expected an array of shape"),
    ({"frequencies": np.zeros(9, dtype=np.float32)}, "found shape .* and type float32"),
    ({"frequencies": np.zeros(9, dtype=object)}, "type object"),
    ({"frequencies": np.zeros(9, dtype=">f8")}, "type >f8"),
    ({"frequencies": frozen(9)}, "the array is read-only"),
    ({"frequencies": [0.0] * 9}, 'expected an ndarray, found "list"'),
    ({"frequencies": None}, "expected an ndarray"),
    ({"frequency": np.zeros(9)}, 'unknown field "frequency"'),
    (
        {"mass_matrix": SHARED, "stiffness_matrix": SHARED},
        "mass_matrix and stiffness_matrix share memory",
    ),
    ({"mass_matrix": SHARED, "stiffness_matrix": SHARED.T}, "share memory"),
    ({}, "expected at least one field"),
    (np.zeros(9), "expected arrays by field"),
    ([np.zeros(9)], "expected arrays by field, found a list"),
]


def test_arrays_that_cannot_be_filled_are_refused(subtests: pytest.Subtests, model: pkmodes.Model) -> None:
    for out, what in UNFIT:
        with subtests.test(what), pytest.raises(pkmodes.PkmodesError, match=what):
            model.modes(POSE, out=out)


def test_out_is_for_fields_that_are_asked_for(model: pkmodes.Model) -> None:
    with pytest.raises(pkmodes.PkmodesError, match="the field is not requested") as error:
        model.modes(POSE, fields=["shapes"], out={"frequencies": np.zeros(9)})
    assert error.match("out: frequencies")


@pytest.mark.parametrize("which", ["model", "extended"])
def test_rates_of_the_frequencies_alone_are_those_of_differences(
    which: str, request: pytest.FixtureRequest
) -> None:
    """Central differences of the frequencies err by h^2: 1e-5 of the value leaves some 1e-9."""
    model = request.getfixturevalue(which)
    poses = around(POSE, 4)
    steps = {"platform.mass": 1.5e-5, "link.length": 4e-6, "axis.span": 1e-5, "belt.width": 1.5e-7}
    rates = model.sensitivities(poses, list(steps), fields=["frequencies"]).frequencies
    for t, (path, step) in enumerate(steps.items()):
        value = model.sensitivities(POSE, [path], fields=["frequencies"]).values[0]
        ahead, behind = (model.with_values({path: value + s * step}).frequencies(poses) for s in (1, -1))
        expected = (ahead - behind) / (2 * step)
        scale = np.abs(expected[:, 3:]).max()
        np.testing.assert_allclose(rates[:, t, 3:], expected[:, 3:], rtol=0, atol=1e-6 * scale)


@pytest.mark.parametrize(("which", "pose"), [("model", POSE), ("extended", POSE), ("tower", CENTRE)])
def test_both_routes_to_the_rates_agree(which: str, pose: np.ndarray, request: pytest.FixtureRequest) -> None:
    """Up to rounding: one sums whole matrices, the other only the entries that change."""
    model = request.getfixturevalue(which)
    poses = np.concatenate([around(pose, 3), pose[None], around(pose, 2)])
    everything = model.sensitivities(poses)
    alone = model.sensitivities(poses, fields=["frequencies", "eigenvalues", "groups"])
    np.testing.assert_array_equal(alone.groups, everything.groups)
    for name in ("eigenvalues", "frequencies"):
        found, expected = getattr(alone, name), getattr(everything, name)
        np.testing.assert_array_equal(np.isnan(found), np.isnan(expected))
        scale = np.nanmax(np.abs(expected), axis=-1, keepdims=True)
        assert not (np.abs(found - expected) > 1e-9 * scale).any()
    if which == "tower":
        assert everything.groups[3].max() < 8  # there are pairs, so that the groups' route was taken


def test_matrices_alone_need_no_modes(model: pkmodes.Model) -> None:
    poses = around(POSE, 3)
    everything = model.sensitivities(poses, PATHS)
    found = model.sensitivities(poses, PATHS, fields=["stiffness_matrix", "mass_matrix"])
    np.testing.assert_array_equal(found.mass_matrix, everything.mass_matrix)
    np.testing.assert_array_equal(found.stiffness_matrix, everything.stiffness_matrix)
    assert model.sensitivities(poses, [], fields=["frequencies"]).frequencies.shape == (3, 0, 9)


def peak(call: Callable[[], object]) -> int:
    tracemalloc.start()
    call()
    _, found = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    return found


@pytest.mark.parametrize(
    ("fields", "numbers"),
    [
        (("frequencies",), 9),
        (("frequencies", "platform_shapes"), 36),
        (None, 9 + 9 + 81 + 27 + 3 + 81 + 81 + 27),
    ],
)
def test_a_pose_takes_the_memory_of_its_result(
    model: pkmodes.Model, fields: tuple[str, ...] | None, numbers: int
) -> None:
    """Besides the requested fields, a pose takes its copy, three numbers, and some bytes of bookkeeping.

    With one thread, both batches are longer than the part for which more is kept, such as eigenvalues.
    """
    some, more = (around(POSE, n) for n in (6000, 18000))
    assert len(some) > mode_fields.POSES_PER_THREAD
    peaks = [peak(lambda p=p: model.modes(p, fields=fields, threads=1)) for p in (some, more)]
    assert (peaks[1] - peaks[0]) / 12000 < 8 * (numbers + 3) + 20


def test_sensitivities_take_the_memory_of_their_result(model: pkmodes.Model) -> None:
    paths = [
        "platform.mass",
        "belt.width",
        "effects.payload.mass",
    ]  # those of the geometry take long to trace
    part = 4096 if model.modes(POSE).backend == "compiled" else 128
    for fields, numbers, few in ((("frequencies",), 9, part), (("frequencies", "shapes"), 90, 128)):
        some, more = (around(POSE, n) for n in (few, 3 * few))
        peaks = [peak(lambda p=p, f=fields: model.sensitivities(p, paths, fields=f)) for p in (some, more)]
        assert (peaks[1] - peaks[0]) / (2 * few) < 8 * (len(paths) * numbers + 3) + 150
