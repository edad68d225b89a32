"""Standard deviations of frequencies: against robots drawn at random, and closed forms."""

from __future__ import annotations

import numpy as np
import pytest

import pkmodes


@pytest.mark.parametrize(
    ("robot", "pose", "values"),
    [
        ("corexy-printer", [0.1, 0.15], {}),
        ("clavel-delta", [0.1, 0.05, -0.8], {}),
        (
            "linear-delta-2022",
            [0.6, 0.03, -0.245],
            {
                "platform.mass": {"sigma": 0.05},
                "belt.width": {"sigma": 0.0005},
                "axis.2.joint.x": {"sigma": 0.0005},
                "axis.1.limits.max": {"sigma": 0.002},
            },
        ),
    ],
)
@pytest.mark.parametrize("drives", ["free", "held"])
@pytest.mark.usefixtures("backend")
def test_they_are_the_root_of_the_sum_of_squares_of_differences(
    robot: str, pose: list[float], values: dict[str, object], drives: str
) -> None:
    model = pkmodes.load(f"robots/{robot}.toml").with_values(values)
    found = model.frequency_sigmas(pose, drives=drives)
    rigid = model.modes(pose, drives=drives).rigid_modes
    squares = np.zeros(len(found) - rigid)
    for path, quantity in model.robot.quantities.items():
        if quantity.sigma:
            h = 1e-4 * quantity.sigma
            up, down = (
                model.with_values({path: quantity.value + step}).frequencies(pose, drives=drives)[rigid:]
                for step in (h, -h)
            )
            squares += (quantity.sigma * (up - down) / (2.0 * h)) ** 2
    np.testing.assert_allclose(found[rigid:], np.sqrt(squares), rtol=1e-6)  # rounding of f over a step of h


def test_they_are_those_of_robots_drawn_at_random() -> None:
    """400 draws know a standard deviation to 1/sqrt(800) = 3.5 %; three times that."""
    model = pkmodes.load("robots/corexy-printer.toml")
    drawn = model.map({"x": 0.1, "y": 0.15}, samples=400, seed=250731)
    scatter = drawn["frequency"].values.reshape(400, -1).std(axis=0)
    np.testing.assert_allclose(model.frequency_sigmas([0.1, 0.15])[-2:], scatter, rtol=0.11)


def test_a_spring_and_a_mass_have_the_closed_form() -> None:
    """With motors held, f of CoreXY goes with sqrt(k): sigma_f / f = sigma_k / (2 k); also in many poses at once."""
    model = pkmodes.load("robots/corexy-printer.toml").with_values(
        {"toolhead.mass": {"sigma": None}, "gantry.mass": {"sigma": None}}
    )
    poses = np.array([[[0.1, 0.15], [0.2, 0.05]], [[0.05, 0.05], [0.15, 0.15]]])
    f = model.frequencies(poses, drives="held")
    np.testing.assert_allclose(model.frequency_sigmas(poses, drives="held"), 0.05 * f, rtol=1e-9)


def test_repeated_modes_have_the_root_mean_square_over_their_group() -> None:
    """On its axis the Clavel delta has a pair of modes, which one softer reducer splits.

    Over robots drawn at random the mean square of both about the declared frequency has a law to first order; that of
    the lower one alone, which only goes down, has none.
    """
    model = pkmodes.load("robots/clavel-delta.toml").with_values(
        {
            "platform.mass": {"sigma": None},
            "reducer.stiffness": {"sigma": None},
            "axis.1.reducer.stiffness": {"value": 4000.0, "sigma": 200.0},
            "axis.2.reducer.stiffness": {"value": 4000.0, "sigma": 100.0},
        }
    )
    pose = [0.0, 0.0, -0.8]
    found, f = model.frequency_sigmas(pose)[-3:], model.frequencies(pose)[-3:]
    assert f[0] == pytest.approx(f[1], rel=1e-9)
    assert found[0] == found[1]
    drawn = model.map({"x": 0.0, "y": 0.0, "z": -0.8}, samples=400, seed=250732)
    deviation = drawn["frequency"].values.reshape(400, -1) - f
    assert found[0] == pytest.approx(np.sqrt(np.mean(deviation[:, :2] ** 2)), rel=0.11)  # 400 draws, as above
    assert found[2] == pytest.approx(np.sqrt(np.mean(deviation[:, 2] ** 2)), rel=0.11)  # 400 draws, as above


def test_rigid_modes_have_none_and_poses_outside_neither() -> None:
    model = pkmodes.load("robots/corexy-printer.toml")
    found = model.frequency_sigmas([[0.1, 0.15], [5.0, 0.15]], "nan")
    rigid = model.modes([0.1, 0.15]).rigid_modes
    assert np.isnan(found[0, :rigid]).all()
    assert np.isfinite(found[0, rigid:]).all()
    assert np.isnan(found[1]).all()


def test_a_robot_without_standard_deviations_is_refused() -> None:
    model = pkmodes.load("robots/linear-delta-2022.toml")
    with pytest.raises(
        pkmodes.PkmodesError, match=r"no value of the robot .* has a standard deviation"
    ) as caught:
        model.frequency_sigmas([0.6, 0.0, -0.245])
    assert "sigma" in caught.value.remedy


def test_a_damping_ratio_is_no_reason_for_a_band() -> None:
    model = pkmodes.load("robots/linear-delta-2022.toml").with_values(
        {"damping.ratio": {"value": 0.02, "sigma": 0.005}}
    )
    with pytest.raises(pkmodes.PkmodesError, match="that changes a frequency"):
        model.frequency_sigmas([0.6, 0.0, -0.245])
