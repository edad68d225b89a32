"""The tables ``[[covariance]]`` of a robot file: what they may say, what is refused, and what becomes of them."""

from __future__ import annotations

import pickle
from pathlib import Path

import numpy as np
import pytest

from helpers.robots.robot_text import published
from pkmodes.codegen.generation import specification
from pkmodes.core.base.errors import RobotFileError
from pkmodes.core.robot.covariance import Covariance
from pkmodes.core.robot.reading import read_robot
from pkmodes.core.robot.robot import Robot
from pkmodes.core.support.covariance import covariance_of, priors_of
from pkmodes.loop.robot_files.differences import differences
from pkmodes.machine.dataset.robot_text import robot_file_text

MASS, WIDTH, RADIUS = '"1.5 kg"', '"15 mm"', '"35 mm"'
TWO = """
[[covariance]]
paths = ["platform.mass", "belt.width"]
correlation = [[1, -0.8], [-0.8, 1]]
"""


def read(folder: Path, tables: str, mass: str = "0.1 kg", width: str = "1 mm") -> Robot:
    """Read the published robot with sigmas of its platform, belts and pulleys."""
    text = published()
    for value, sigma in ((MASS, mass), (WIDTH, width), (RADIUS, "1 mm")):
        assert text.count(value) == 1
        text = text.replace(value, f'{{ value = {value}, sigma = "{sigma}" }}')
    path = folder / "robot.toml"
    path.write_text(text + tables, encoding="utf-8")
    return read_robot(path)


def test_a_table_correlates_values_and_all_others_are_independent(tmp_path: Path) -> None:
    robot = read(tmp_path, TWO)
    assert robot.covariance == (Covariance(("platform.mass", "belt.width"), ((1.0, -0.8), (-0.8, 1.0))),)
    found = covariance_of(robot, ["belt.width", "pulley.radius", "platform.mass"])
    expected = [[1e-6, 0.0, -8e-5], [0.0, 1e-6, 0.0], [-8e-5, 0.0, 1e-2]]
    np.testing.assert_allclose(found, expected, rtol=1e-12, atol=0.0)
    np.testing.assert_allclose(covariance_of(robot, ["belt.width"]), [[1e-6]], rtol=1e-12)


def test_a_table_may_have_smaller_sigmas_of_its_own(tmp_path: Path) -> None:
    """They are those of the frequencies; a prior has the value's own, and the same covariance."""
    robot = read(tmp_path, TWO + 'sigma = ["50 g", "2 %"]\n')
    found = covariance_of(robot, ["platform.mass", "belt.width"])
    s, t = 0.05, 0.02 * 0.015
    np.testing.assert_allclose(found, [[s**2, -0.8 * s * t], [-0.8 * s * t, t**2]], rtol=1e-12)
    prior = priors_of(robot)["platform.mass"]
    assert prior.sigma == 0.1
    ((other, rate),) = prior.correlated
    assert other == "belt.width"
    assert rate == pytest.approx(-0.8 * s * t / (0.1 * 1e-3))


def test_a_sigma_that_is_that_of_the_table_but_for_its_digits_has_those_of_the_table(tmp_path: Path) -> None:
    """With a correlation near 1 a rounded sigma would make one beyond it: 1.001."""
    table = (
        '[[covariance]]\npaths = ["platform.mass", "belt.width"]\n'
        'sigma = ["100.44439 g", "0.99706845 mm"]\ncorrelation = [[1, -0.9999], [-0.9999, 1]]\n'
    )
    for mass in ("0.1 kg", "0.101 kg"):  # rounded to the nearest, and up
        priors = priors_of(read(tmp_path, table, mass))
        assert priors["platform.mass"].sigma == pytest.approx(0.10044439, rel=1e-12)
        ((_, rate),) = priors["platform.mass"].correlated
        assert rate == pytest.approx(-0.9999, rel=1e-12)


REFUSED = [
    ("", ".paths", ["expected a list of dotted paths, found nothing", "write paths = ["]),
    ("paths = []", ".paths", ["found an empty list"]),
    ('paths = "platform.mass"', ".paths", ['found "platform.mass"']),
    ("paths = [1]", ".paths.1", ["expected the dotted path of a value with a sigma, found 1"]),
    (
        'paths = ["platform.mas"]',
        ".paths.1",
        ['found "platform.mas", which this file does not declare', 'did you mean "platform.mass"?'],
    ),
    ('paths = ["belt.width", "motor.inertia"]', ".paths.2", ["which has no sigma", "give it a sigma"]),
    ('paths = ["belt.width", "belt.width"]', ".paths.2", ["found belt.width also in covariance.1"]),
    ('paths = ["belt.width"]', ".correlation", ["matrix of 1 by 1 correlations, found nothing"]),
    ('paths = ["belt.width"]\ncorrelation = 1', ".correlation", ["found 1"]),
    ('paths = ["belt.width"]\ncorrelation = [[1, 0], [0, 1]]', ".correlation", ["found a list of 2"]),
    (
        'paths = ["belt.width", "platform.mass"]\ncorrelation = [[1, 0.5], [1]]',
        ".correlation",
        ["matrix of 2 by 2 correlations, found rows of 2, 1", "write 2 rows of 2"],
    ),
    (
        'paths = ["belt.width", "platform.mass"]\ncorrelation = [[1, "0.5"], [0.5, 1]]',
        ".correlation.1.2",
        ['expected a correlation from -1 to 1, found "0.5"'],
    ),
    (
        'paths = ["belt.width", "platform.mass"]\ncorrelation = [[1, nan], [nan, 1]]',
        ".correlation.1.2",
        ["expected a correlation from -1 to 1, found nan"],
    ),
    (
        'paths = ["belt.width", "platform.mass"]\ncorrelation = [[1, 1.5], [1.5, 1]]',
        ".correlation.1.2",
        ["expected a correlation from -1 to 1, found 1.5"],
    ),
    (
        'paths = ["belt.width", "platform.mass"]\ncorrelation = [[1, 0.5], [0.5, 0.9]]',
        ".correlation.2.2",
        ["expected 1 on the diagonal, found 0.9", "write correlations, not covariances"],
    ),
    (
        'paths = ["belt.width", "platform.mass"]\ncorrelation = [[1, 0.5], [-0.5, 1]]',
        ".correlation.1.2",
        ["expected a symmetric matrix, found 0.5 here and -0.5 in row 2"],
    ),
    (
        'paths = ["belt.width", "platform.mass", "pulley.radius"]\n'
        "correlation = [[1, 0.9, 0.9], [0.9, 1, -0.9], [0.9, -0.9, 1]]",
        ".correlation",
        ["expected a positive semidefinite matrix, found an eigenvalue of -0.8"],
    ),
    (
        'paths = ["belt.width"]\ncorrelation = [[1]]\nsigma = ["1 kg"]',
        ".sigma.1",
        ['expected a length such as "400 mm", found "1 kg"'],
    ),
    (
        'paths = ["belt.width"]\ncorrelation = [[1]]\nsigma = ["2 mm"]',
        ".sigma.1",
        ["above 0 and at most that of the value, 0.001 m, found 0.002 m", "enlarge the sigma"],
    ),
    ('paths = ["belt.width"]\ncorrelation = [[1]]\nsigma = [0]', ".sigma.1", ["found 0 m"]),
    ('paths = ["belt.width"]\ncorrelation = [[1]]\nsigma = []', ".sigma", ["expected 1 standard"]),
    (
        'paths = ["belt.width"]\ncorrelation = [[1]]\ncorelation = 1',
        ".corelation",
        ['unknown key "corelation"', 'did you mean "correlation"?'],
    ),
]


def test_what_is_refused(subtests: pytest.Subtests, tmp_path: Path) -> None:
    for table, place, parts in REFUSED:
        with subtests.test(table=table):
            with pytest.raises(RobotFileError) as caught:
                read(tmp_path, f"\n[[covariance]]\n{table}\n")
            (problem,) = caught.value.problems
            assert problem.where == f"{tmp_path / 'robot.toml'}: covariance.1{place}"
            said = f"{problem.what}; {problem.remedy}"
            assert [part for part in parts if part not in said] == [], said


def test_no_value_is_in_two_tables_and_none_that_is_known_exactly(tmp_path: Path) -> None:
    with pytest.raises(RobotFileError, match=r"found belt\.width also in covariance\.1"):
        read(tmp_path, TWO + '\n[[covariance]]\npaths = ["belt.width"]\ncorrelation = [[1]]\n')
    with pytest.raises(RobotFileError, match="whose sigma is 0: it is known exactly"):
        read(tmp_path, TWO, width="0 mm")
    with pytest.raises(RobotFileError, match="expected tables, found"):
        read(tmp_path, "\n[covariance]\npaths = []\n")


def test_a_value_that_an_effect_takes_is_in_a_table_under_either_name(tmp_path: Path) -> None:
    """The mass of the frame is one value: it counts once, and cannot be in a table twice."""
    mass = '\n[frame]\nmass = { value = "50 kg", sigma = "5 kg" }\n'
    effect = '\n[effects.frame_compliance]\ncompliance = { value = "1e-7 m/N", sigma = "1e-8 m/N" }\n'
    table = (
        '\n[[covariance]]\npaths = ["{}", "effects.frame_compliance.compliance"]\n'
        "correlation = [[1, 0.5], [0.5, 1]]\n"
    )
    first, second = (
        read(tmp_path, mass + effect + table.format(name))
        for name in ("frame.mass", "effects.frame_compliance.mass")
    )
    assert first.covariance == second.covariance
    assert first.covariance[0].paths[0] == "frame.mass"
    with pytest.raises(RobotFileError, match=r"found frame\.mass also in covariance\.1"):
        read(
            tmp_path,
            f'{mass}{effect}\n[[covariance]]\npaths = ["frame.mass", "effects.frame_compliance.mass"]\n'
            "correlation = [[1, 0], [0, 1]]\n",
        )


def test_tables_stay_with_a_robot_and_its_variants(tmp_path: Path) -> None:
    robot = read(tmp_path, TWO + 'sigma = ["50 g", "0.5 mm"]\n')
    assert pickle.loads(pickle.dumps(robot)) == robot
    assert robot != read(tmp_path, TWO)
    assert robot.with_values({"platform.mass": "2 kg"}).covariance == robot.covariance
    other = robot.with_values({"platform.mass": {"sigma": "20 g"}})
    assert other.covariance[0].sigmas == (0.02, 0.0005)
    assert other.covariance[0].correlation == robot.covariance[0].correlation
    for known in (None, 0):
        alone = robot.with_values({"platform.mass": {"sigma": known}})
        assert alone.covariance == (Covariance(("belt.width",), ((1.0,),), (0.0005,)),)
        assert alone.with_values({"belt.width": {"sigma": None}}).covariance == ()
    written = tmp_path / "written.toml"
    written.write_text(robot_file_text(other), encoding="utf-8")
    assert read_robot(written) == other


def test_generated_code_does_not_depend_on_correlations(tmp_path: Path) -> None:
    plain = specification(read(tmp_path, ""), "robot.toml")
    assert plain == specification(read(tmp_path, TWO), "robot.toml")


def test_a_comparison_of_robots_names_them(tmp_path: Path) -> None:
    plain, some = read(tmp_path, ""), read(tmp_path, TWO)
    (found,) = differences(plain, some).choices
    assert (found.path, found.first, found.second) == (
        "covariance",
        "no correlations",
        "correlations of 2 values",
    )
    others = read(tmp_path, TWO.replace("-0.8", "0.1"))
    (found,) = differences(some, others).choices
    assert found.second == "correlations of 2 values, which differ from those by up to 0.9"
    narrower = read(tmp_path, TWO + 'sigma = ["50 g", "0.5 mm"]\n')
    (found,) = differences(some, narrower).choices
    assert found.second == "correlations of 2 values, the same with other standard deviations"
    assert differences(some, read(tmp_path, TWO)).choices == ()
