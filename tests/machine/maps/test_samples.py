"""Robots drawn from their standard deviations."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.stats import kstest

import pkmodes
from helpers.robots.robot_text import edited
from pkmodes.core.base.errors import PkmodesError

POSE = {"x": 0.6, "y": 0.0, "z": -0.245}


def declared(folder: Path, *changes: tuple[str, str]) -> pkmodes.Model:
    text = edited(*changes[0])
    for right, wrong in changes[1:]:
        assert right in text
        text = text.replace(right, wrong, 1)
    (folder / "robot.toml").write_text(text, encoding="utf-8")
    return pkmodes.load(folder / "robot.toml")


@pytest.fixture
def uncertain(tmp_path: Path) -> pkmodes.Model:
    return declared(
        tmp_path,
        ('mass = "1.5 kg"', 'mass = { value = "1.5 kg", sigma = "2 %" }'),
        ('length = "400 mm"', 'length = { value = "400 mm", sigma = "0.5 mm" }'),
    )


def test_values_are_drawn_from_their_normal_distributions(uncertain: pkmodes.Model) -> None:
    found = uncertain.map(POSE, samples=400)
    assert found["frequency"].dims == ("sample", "z", "y", "x", "mode")
    assert found["sample"].values.tolist() == list(range(1, 401))
    for path, mean, sigma in (("platform.mass", 1.5, 0.03), ("link.length", 0.4, 0.0005)):
        values = found[path]
        assert values.dims == ("sample",)
        assert kstest((values - mean) / sigma, "norm").pvalue > 0.01
    assert abs(np.corrcoef(found["platform.mass"], found["link.length"])[0, 1]) < 0.15


def test_each_sample_is_the_robot_with_its_drawn_values(uncertain: pkmodes.Model) -> None:
    found = uncertain.map(POSE, samples=5)
    for number in found["sample"].values:
        one = found.sel(sample=number)
        values = {path: float(one[path]) for path in ("platform.mass", "link.length")}
        frequencies = uncertain.with_values(values).frequencies([0.6, 0.0, -0.245])
        np.testing.assert_allclose(one["frequency"].squeeze(), frequencies[3:], rtol=1e-10)


def test_the_spread_is_that_of_the_sensitivities(uncertain: pkmodes.Model) -> None:
    """To first order, var f = sum of (df/dp sigma)^2; 400 draws give a standard deviation within 10 %."""
    found = uncertain.map(POSE, samples=400)["frequency"].squeeze()
    paths = ["platform.mass", "link.length"]
    rates = uncertain.sensitivities([0.6, 0.0, -0.245], paths).frequencies[:, 3:]
    expected = np.sqrt(((rates * np.array([[0.03], [0.0005]])) ** 2).sum(axis=0))
    np.testing.assert_allclose(found.std("sample")[:3], expected[:3], rtol=0.1)


def test_a_seed_gives_the_same_robots_again(uncertain: pkmodes.Model) -> None:
    first, again = uncertain.map(POSE, samples=3, seed=7), uncertain.map(POSE, samples=3, seed=7)
    assert first.identical(again)
    other = uncertain.map(POSE, samples=3, seed=8)
    assert (first["platform.mass"] != other["platform.mass"]).all()


def test_samples_are_common_to_all_values_of_a_sweep(uncertain: pkmodes.Model) -> None:
    found = uncertain.map(POSE, sweep={"belt.width": [0.01, 0.015]}, samples=3)
    assert found["frequency"].dims == ("belt.width", "sample", "z", "y", "x", "mode")
    alone = uncertain.map(POSE, samples=3)
    np.testing.assert_array_equal(found["platform.mass"], alone["platform.mass"])
    np.testing.assert_array_equal(found["frequency"].sel({"belt.width": 0.015}), alone["frequency"])


def test_a_swept_value_is_not_drawn(uncertain: pkmodes.Model) -> None:
    found = uncertain.map(POSE, sweep={"platform.mass": [1.4, 1.6]}, samples=3)
    assert found["platform.mass"].dims == ("platform.mass",)
    assert found["link.length"].dims == ("sample",)


def test_elements_of_a_swept_whole_are_not_drawn(tmp_path: Path) -> None:
    model = declared(
        tmp_path,
        ('mass = "1.5 kg"', 'mass = { value = "1.5 kg", sigma = "2 %" }'),
        ('limits = ["0 m", "1.2 m"]', 'limits = ["0 m", { value = "1.2 m", sigma = "1 mm" }]'),
    )
    assert "axis.1.limits.max" in model.map(POSE, samples=2).coords
    found = model.map(POSE, sweep={"axis.span": [1.2, 1.3]}, samples=2)
    assert "axis.1.limits.max" not in found.coords
    assert "platform.mass" in found.coords


def test_impossible_robots_are_drawn_again_and_refused_where_all_are(tmp_path: Path) -> None:
    often = declared(tmp_path, ('mass = "1.5 kg"', 'mass = { value = "1.5 kg", sigma = "1.5 kg" }'))
    found = often.map(POSE, samples=50)
    assert (found["platform.mass"] > 0.0).all()
    assert found["platform.mass"].min() < 1.0
    # Each of nine lengths is positive with probability 1/2, all of them hardly ever.
    wide = 'inertia = { value = "130e-6 kg*m^2", sigma = "130 kg*m^2" }'
    text = edited('inertia = "130e-6 kg*m^2"', wide).replace(
        'length = "400 mm"', 'length = { value = "400 mm", sigma = "4e9 mm" }'
    )
    text = text.replace('mass = "0.7 kg"', 'mass = { value = "0.7 kg", sigma = "7e9 kg" }')
    for key, unit in (("width", "mm"), ("radius", "mm")):
        before = {"width": "15", "radius": "35"}[key]
        text = text.replace(
            f'{key} = "{before} {unit}"', f'{key} = {{ value = "{before} {unit}", sigma = "1e9 {unit}" }}'
        )
    text = text.replace('mass = "1.5 kg"', 'mass = { value = "1.5 kg", sigma = "1e9 kg" }')
    text = text.replace('mass = "1 kg"', 'mass = { value = "1 kg", sigma = "1e9 kg" }')
    text = text.replace(
        'specific_stiffness = "2.42e6 N/m"',
        'specific_stiffness = { value = "2.42e6 N/m", sigma = "1e15 N/m" }',
    )
    (tmp_path / "wild.toml").write_text(text, encoding="utf-8")
    with pytest.raises(PkmodesError, match="none of 100 draws gave a robot that can exist") as error:
        pkmodes.load(tmp_path / "wild.toml").map(POSE, samples=200)
    assert "standard deviation" in error.value.remedy


@pytest.mark.parametrize("samples", [0, -1, 1.5, True, "3"])
def test_bad_numbers_of_samples(uncertain: pkmodes.Model, samples: object) -> None:
    with pytest.raises(PkmodesError, match="expected a positive integer"):
        uncertain.map(POSE, samples=samples)  # type: ignore[arg-type]


@pytest.mark.parametrize("seed", [-1, 1.5, "a", None])
def test_bad_seeds(uncertain: pkmodes.Model, seed: object) -> None:
    with pytest.raises(PkmodesError, match="expected an integer of at least 0"):
        uncertain.map(POSE, samples=2, seed=seed)  # type: ignore[arg-type]


def test_nothing_to_draw_from() -> None:
    model = pkmodes.load(Path(__file__).parents[3] / "robots" / "linear-delta-2022.toml")
    with pytest.raises(PkmodesError, match="no value of the robot has a standard deviation") as error:
        model.map(POSE, samples=3)
    assert "sigma" in error.value.remedy
