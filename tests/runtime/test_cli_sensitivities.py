"""``pkmodes sensitivities``: derivatives against differences between robot files, units, order, errors."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pkmodes
from helpers.commands.answers import printed, refused
from helpers.robots.robot_text import PUBLISHED, edited, published
from pkmodes_rig.robots import ROBOTS

pytestmark = pytest.mark.usefixtures("backend")

POSE, POINT = "0.6,0.03,-0.245", [0.6, 0.03, -0.245]


def sensitivities(*arguments: object, robot: Path = PUBLISHED) -> str:
    return printed("sensitivities", robot, "--pose", POSE, *arguments)


def as_json(*arguments: object, robot: Path = PUBLISHED) -> dict[str, Any]:
    return json.loads(sensitivities("--json", "-", *arguments, robot=robot))


def frequencies(folder: Path, text: str) -> np.ndarray:
    (folder / "varied.toml").write_text(text, encoding="utf-8")
    return pkmodes.load(folder / "varied.toml").modes(POINT).frequencies


@pytest.mark.parametrize(
    ("path", "old", "new", "value", "unit"),
    [
        ("platform.mass", 'mass = "1.5 kg"', 'mass = "{} kg"', 1.5, "kg"),
        ("belt.width", 'width = "15 mm"', 'width = "{} m"', 0.015, "m"),
        ("motor.gear_ratio", "gear_ratio = 10", "gear_ratio = {}", 10.0, "1"),
    ],
)
def test_derivatives_are_those_of_other_robot_files(
    tmp_path: Path, path: str, old: str, new: str, value: float, unit: str
) -> None:
    found = as_json("--parameters", path)
    h = 1e-4 * value
    below, above = (frequencies(tmp_path, edited(old, new.format(repr(value + s)))) for s in (-h, h))
    slope = (above - below)[3:] / (2 * h)
    assert (found["parameters"], found["units"], found["values"]) == ([path], [unit], [value])
    (rates,), (shares,), (eigen,) = (
        found[f"{kind}_derivatives"] for kind in ("frequency", "relative", "eigenvalue")
    )
    f = np.array(found["frequencies_hz"][3:])
    np.testing.assert_allclose(rates[3:], slope, rtol=1e-6)  # central differences err by (h / value)^2
    np.testing.assert_allclose(shares[3:], slope * value / f, rtol=1e-6)
    np.testing.assert_allclose(eigen[3:], 8 * np.pi**2 * f * slope, rtol=1e-6)  # lambda = (2 pi f)^2


def test_an_absent_effect_has_the_derivative_of_a_little_of_it(tmp_path: Path) -> None:
    found = as_json("--parameters", "effects.payload.mass")
    base, some = (
        frequencies(tmp_path, published() + f'\n[effects.payload]\nmass = "{m} kg"\n') for m in (0, 1e-4)
    )
    np.testing.assert_allclose(found["frequency_derivatives"][0][3:], (some - base)[3:] / 1e-4, rtol=1e-3)
    assert found["values"] == [0.0]
    assert found["relative_derivatives"] == [[None] * 9]


def test_json_has_every_parameter_and_mode_of_the_model() -> None:
    found, model = as_json(), pkmodes.load(PUBLISHED)
    expected = model.sensitivities(POINT)
    assert (found["robot"], found["pose"], found["drives"]) == ("linear-delta-2022", POINT, "free")
    assert (found["rigid_modes"], len(found["groups"])) == (3, 9)
    assert {"platform.mass", "axis.2.origin.y", "effects.link_compliance.compliance"} <= set(
        found["parameters"]
    )
    assert found["parameters"] == list(expected.parameters)
    assert found["units"] == list(expected.units)
    np.testing.assert_array_equal(found["values"], expected.values)
    np.testing.assert_array_equal(found["frequencies_hz"], model.frequencies(POINT))
    # None, of rigid modes and relative to 0, becomes NaN.
    by_frequency, by_eigenvalue, relative = (
        np.array(found[f"{kind}_derivatives"], dtype=float)
        for kind in ("frequency", "eigenvalue", "relative")
    )
    np.testing.assert_array_equal(by_frequency, expected.frequencies)
    np.testing.assert_array_equal(by_eigenvalue, expected.eigenvalues)
    values = np.where(expected.values == 0.0, np.nan, expected.values)
    shares = expected.frequencies * values[:, None] / model.frequencies(POINT)
    np.testing.assert_allclose(relative, shares, rtol=1e-14)


def test_the_table_is_sorted_by_what_a_percent_does() -> None:
    paths = [
        "platform.mass",
        "effects.payload.mass",
        "belt.width",
        "gravity.z",
        "pulley.radius",
        "frame.mass",
    ]
    out = sensitivities("--parameters", ",".join(paths))
    relative, rates = out.split("Hz per unit of the value.\n")
    order = [line.split()[0] for line in relative.splitlines() if re.match(r"[a-z]+\.[a-z]+ ", line)]
    assert order == ["pulley.radius", "belt.width", "platform.mass", "gravity.z"]
    rows: dict[str, list[str]] = {}
    for line in rates.splitlines():  # two tables, so that both fit the terminal
        if re.match(r"[a-z]+\.[a-z.]+ ", line):
            path, *cells = line.split()
            rows.setdefault(path, []).extend(cells)
    assert [*rows] == [*order, "effects.payload.mass"]
    assert rows["platform.mass"][:2] == ["1.5", "kg"]
    assert rows["effects.payload.mass"][:2] == ["0", "kg"]
    # A payload acts like additional platform mass.
    assert rows["effects.payload.mass"][2:] == rows["platform.mass"][2:]
    assert "No frequency depends on frame.mass." in out
    model = pkmodes.load(PUBLISHED)
    expected = model.sensitivities(POINT, ["platform.mass"]).frequencies[0, 3:]
    assert rows["platform.mass"][2:] == [f"{rate:.4g}" for rate in expected]


def test_every_quantity_is_in_the_tables_per_unit_once() -> None:
    out = sensitivities("--all")
    rates, _, still = out.partition("Hz per unit of the value.\n")[2].partition("No frequency depends on ")
    # The table is too wide for the names of the quantities: each is on a line above its numbers, in every part.
    named = [line for line in rates.splitlines() if re.fullmatch(r"[a-z]+(\.\w+)+", line)]
    shown = list(dict.fromkeys(named))
    assert len(named) % len(shown) == 0
    shown += still.partition(".\n")[0].replace(",", " ").split()
    assert sorted(shown) == sorted(as_json()["parameters"])
    assert "e-30" not in out, "rounding is shown as 0"


def rows_of(out: str) -> list[str]:
    """The quantities of the first table; of those that act as one, all names."""
    table = out.partition("\nPer cent of each frequency")[2].partition("\n\n")[0]
    return re.findall(r"^(?:1/)?([a-z]+(?:\.\w+)+),?(?:  .*)?$", table, re.M)


def test_without_a_choice_the_ten_largest_per_cent_are_printed() -> None:
    robot = PUBLISHED.with_name("linear-delta-2022-identified.toml")
    out = sensitivities(robot=robot)
    assert "The 10 largest of 11, by their largest in any mode." in " ".join(out.split())
    found = as_json(robot=robot)
    # Largest by the JSON, which has all: of the quantities of the file and of wholes, without coordinates.
    rigid, size = found["rigid_modes"], {}
    for path, relative in zip(found["parameters"], found["relative_derivatives"], strict=True):
        if not path.startswith("axis.") or path in ("axis.span", "axis.joint_radius"):
            size[path] = max(abs(share or 0.0) for share in relative[rigid:])
    largest = sorted((path for path in size if size[path] > 1e-9), key=lambda path: -size[path])
    shown = rows_of(out)
    assert set(largest[:11]) == {path.rstrip(",") for path in shown}, "two of them are one row"
    assert "Hz per unit" not in out.partition("--all")[0]
    assert len(out.splitlines()) < 45


def test_parameters_of_which_only_the_product_enters_are_one_row() -> None:
    both = ["belt.specific_stiffness", "belt.width"]
    for more in ([], ["--all"], ["--parameters", "belt.width,platform.mass,belt.specific_stiffness"]):
        table = sensitivities(*more).partition("\nPer cent of each frequency")[2].partition("\n\n")[0]
        names = re.findall(r"^(?:1/)?(belt\.\w+)(,?)(.*)$", table, re.M)
        assert sorted(name for name, _, _ in names) == both
        assert [comma for _, comma, _ in names] == [",", ""]
        assert [bool(numbers) for _, _, numbers in names] == [True, False]
        assert "Quantities in one row act as one" in table


@pytest.mark.parametrize(
    ("robot", "pose"),
    [
        ("linear-delta-2022", "0.6,0,-0.245"),
        ("linear-delta-2022-identified", "0.6,0,-0.245"),
        ("clavel-delta", "0,0,-0.8"),
        ("corexy-printer", "0.1,0.15"),
    ],
)
@pytest.mark.parametrize("more", [[], ["--all"]])
def test_no_line_is_wider_than_a_terminal(robot: str, pose: str, more: list[str]) -> None:
    out = printed("sensitivities", f"robots/{robot}.toml", "--pose", pose, *more)
    assert max(map(len, out.splitlines())) <= 80


def test_standard_deviations_of_the_file_are_propagated() -> None:
    """Against differences of the frequencies, and the root of the sum of squares."""
    robot = "robots/corexy-printer.toml"
    out = printed("sensitivities", robot, "--pose", "0.1,0.15")
    out = out.partition("\nHz for one standard deviation")[2].partition("\nquantity  ")[2]
    rows = {line.split("  ")[0]: line.split()[-2:] for line in out.splitlines()[1:5]}
    model = pkmodes.load(robot)
    squares = np.zeros(2)
    stated = {path: q for path, q in model.robot.quantities.items() if q.sigma}
    for path, quantity in stated.items():
        h = 1e-4 * quantity.value
        up, down = (
            model.with_values({path: quantity.value + step}).frequencies([0.1, 0.15])[-2:] for step in (h, -h)
        )
        change = quantity.sigma * (up - down) / (2 * h)
        assert rows[path] == [f"{value:+.3f}" for value in change]
        squares += change**2
    assert rows["all together"] == [f"{value:.3f}" for value in np.sqrt(squares)]
    assert rows.keys() == {*stated, "all together"}


def test_modes_that_coincide_are_named(tmp_path: Path) -> None:
    """On the axis of symmetry of a tower printer, modes come in pairs."""
    (tmp_path / "tower.toml").write_text(ROBOTS["tower"], encoding="utf-8")
    found = pkmodes.load(tmp_path / "tower.toml").modes([0.0, 0.0, 0.2]).frequencies[3:]
    pairs = [i + 1 for i in range(5) if np.isclose(found[i], found[i + 1], rtol=1e-9)]
    assert pairs, "the tower of the rig has none here"
    some = ("--pose", "0,0,0.2", "--parameters", "platform.mass")
    out = " ".join(printed("sensitivities", tmp_path / "tower.toml", *some).split())
    for i in pairs:
        assert f"Modes {i}, {i + 1} coincide: the changes are those of the branches" in out


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--parameters", "platform.mas"], 'unknown parameter path "platform.mas"'),
        (["--parameters", "platform.mas"], 'did you mean "platform.mass"?'),
        (["--parameters", "link.mass,,axis.span"], "expected parameter paths separated by commas"),
        (["--parameters", ""], "expected parameter paths separated by commas"),
        (["--parameters", "axis.joint_radius"], "axis.joint_radius cannot vary"),
        (["--parameters", "link.mass", "--parameters", "axis.span"], "given more than once"),
        (["--json", str(PUBLISHED)], "the result would replace its own input"),
        (["--all", "--parameters", "axis.span"], "--all and --parameters exclude each other"),
    ],
)
def test_mistakes_are_one_line(arguments: list[str], message: str) -> None:
    assert message in refused("sensitivities", PUBLISHED, "--pose", POSE, *arguments)


def test_motors_are_held_if_asked() -> None:
    some = ("--parameters", "platform.mass,motor.inertia", "--drives", "held")
    found = as_json(*some)
    model = pkmodes.load(PUBLISHED)
    expected = model.sensitivities(POINT, ["platform.mass", "motor.inertia"], drives="held")
    np.testing.assert_array_equal(found["frequencies_hz"], model.frequencies(POINT, drives="held"))
    np.testing.assert_array_equal(found["frequency_derivatives"], expected.frequencies)
    assert (found["drives"], found["rigid_modes"]) == ("held", 0)
    out = sensitivities(*some)
    assert "At [0.6, 0.03, -0.245] m, motors held;" in " ".join(out.split())
    assert "No frequency depends on motor.inertia.\n" in out
