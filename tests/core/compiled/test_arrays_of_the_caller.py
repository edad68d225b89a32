"""Arrays given by the caller: filled in place, or left alone where poses are refused; poses left to NumPy."""

from __future__ import annotations

import numpy as np
import pytest

import pkmodes
from helpers.generated.libraries import POSE, ROBOT, ROOT
from helpers.robots.one_of_each import load_free
from pkmodes import PkmodesError
from pkmodes.core.solve import batch

pytestmark = pytest.mark.compiler


def test_out_is_filled_in_place_whatever_its_strides() -> None:
    model = load_free(ROBOT)
    poses = np.random.default_rng(1).uniform(0.01, 0.29, (40, 2))
    wide = np.full((40, 8), -1.0)
    model.modes(poses, out={"frequencies": wide[:, ::2]}, backend="compiled")
    np.testing.assert_array_equal(wide[:, ::2], model.frequencies(poses))
    assert (wide[:, 1::2] == -1.0).all()
    with pytest.raises(PkmodesError, match=r"expected an array of shape \(40, 4\) and type float64"):
        model.frequencies(poses, out=np.empty((40, 5)), backend="compiled")


def test_a_refused_batch_leaves_the_callers_array_alone() -> None:
    model = load_free(ROBOT)
    out = np.full((2, 4), -1.0)
    with pytest.raises(pkmodes.PoseError, match="pose 1 at"):
        model.frequencies([POSE, [9.0, 0.0]], out=out, backend="compiled")
    assert (out == -1.0).all()


@pytest.mark.parametrize("backend", ["compiled", "numpy"])
def test_a_joint_that_is_too_soft_leaves_the_callers_arrays_alone(backend: str) -> None:
    """NumPy refuses it, after the compiled evaluator; a pose out of reach is refused first."""
    plain = pkmodes.load(ROOT / "robots/linear-delta-2022.toml")
    model = plain.with_values({"effects.clamp_compliance.compliance": 100.0})
    poses = [[0.6, 0.05, -0.245]] * 2
    rates, frequencies = np.full((2, 1, 9), 7.0), np.full((2, 9), 7.0)
    with pytest.raises(pkmodes.PoseError, match="so soft"):
        model.sensitivities(poses, ["gravity.x"], out={"frequencies": rates}, backend=backend)
    with pytest.raises(pkmodes.PoseError, match="so soft"):
        model.frequencies(poses, out=frequencies, backend=backend)
    assert (rates == 7.0).all()
    assert (frequencies == 7.0).all()
    with pytest.raises(pkmodes.PoseError, match="pose 1 at"):
        model.frequencies([*poses[:1], [9.0, 9.0, 9.0]], backend=backend)


def test_poses_that_are_left_to_numpy_are_evaluated_in_parts(monkeypatch: pytest.MonkeyPatch) -> None:
    """The joint is too stiff for the compiled evaluator."""
    plain = pkmodes.load(ROOT / "robots/linear-delta-2022.toml")
    model = plain.with_values({"effects.gearbox_compliance.compliance": 1e-30})
    poses = np.array([0.6, 0.05, -0.245]) + np.linspace(0.0, 0.02, 7)[:, None]
    by_numpy = model.frequencies(poses, backend="numpy")
    monkeypatch.setattr(batch, "CHUNK", 3)
    np.testing.assert_array_equal(model.frequencies(poses, backend="compiled"), by_numpy)
