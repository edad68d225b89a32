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
from helpers.commands.printed_tables import printed_table
from helpers.robots.robot_text import PUBLISHED, edited, published
from pkmodes_rig.robots import ROBOTS

pytestmark = pytest.mark.usefixtures("backend")

POSE, POINT = "0.6,0.03,-0.245", [0.6, 0.03, -0.245]
MODES = [f"mode {number}" for number in range(1, 7)]


def sensitivities(*arguments: object, robot: Path = PUBLISHED) -> str:
    return printed("sensitivities", robot, "--pose", POSE, *arguments)


def as_json(*arguments: object, robot: Path = PUBLISHED) -> dict[str, Any]:
    return json.loads(sensitivities("--json", "-", *arguments, robot=robot))


def per_cent(out: str) -> dict[str, list[str]]:
    """Return the per cent of each frequency for one of a quantity, by the quantities that act as one."""
    return {name: cells for name, *cells in printed_table(out, "quantity", *MODES)}


def per_unit(out: str) -> dict[str, list[str]]:
    """Return value, unit and the Hz of each mode per unit, by the quantity."""
    return {name: cells for name, *cells in printed_table(out, "quantity", "value", "unit", *MODES)}


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
    shares, rates = per_cent(out), per_unit(out)
    assert [*shares] == ["pulley.radius", "belt.width", "platform.mass", "gravity.z"]
    assert [*rates] == [*shares, "effects.payload.mass"]
    assert rates["platform.mass"][:2] == ["1.5", "kg"]
    assert rates["effects.payload.mass"][:2] == ["0", "kg"]
    # A payload acts like additional platform mass.
    assert rates["effects.payload.mass"][2:] == rates["platform.mass"][2:]
    assert "No frequency depends on frame.mass." in out
    model = pkmodes.load(PUBLISHED)
    found = model.sensitivities(POINT, [*shares])
    of_one_per_cent = found.frequencies[:, 3:] * found.values[:, None] / model.frequencies(POINT)[3:]
    for path, expected, share in zip(shares, found.frequencies[:, 3:], of_one_per_cent, strict=True):
        assert rates[path][2:] == [f"{rate:.4g}" for rate in expected]
        assert [*map(float, shares[path])] == pytest.approx(share, abs=5.1e-5)


def test_every_quantity_is_in_the_tables_per_unit_once() -> None:
    out = sensitivities("--all")
    still = out.partition("No frequency depends on ")[2].partition(".\n")[0].replace(",", " ").split()
    shown = [*(row[0] for row in printed_table(out, "quantity", "value", "unit", *MODES)), *still]
    assert sorted(shown) == sorted(as_json()["parameters"])
    assert "e-30" not in out, "rounding is shown as 0"


def test_without_a_choice_the_ten_largest_per_cent_are_printed() -> None:
    robot = PUBLISHED.with_name("linear-delta-2022-identified.toml")
    out = sensitivities(robot=robot)
    assert "The 10 largest of 11, by their largest change in any mode." in " ".join(out.split())
    found = as_json(robot=robot)
    # Largest by the JSON, which has all: of the quantities of the file and of wholes, without coordinates.
    rigid, size = found["rigid_modes"], {}
    for path, relative in zip(found["parameters"], found["relative_derivatives"], strict=True):
        if not path.startswith("axis.") or path in ("axis.span", "axis.joint_radius"):
            size[path] = max(abs(share or 0.0) for share in relative[rigid:])
    largest = sorted((path for path in size if size[path] > 1e-9), key=lambda path: -size[path])
    shown = per_cent(out)
    named = [path for names in shown for path in names.split(", ")]
    assert set(largest[:11]) == set(named), "two of them are one row"
    assert len(shown) == 10
    for names, cells in shown.items():
        of_all = found["relative_derivatives"][found["parameters"].index(names.split(", ")[0])][rigid:]
        assert [*map(float, cells)] == pytest.approx(of_all, abs=5.1e-5)
    assert "Hz per unit" not in out.partition("--all")[0]
    assert len(out.splitlines()) < 45


def test_parameters_of_which_only_the_product_enters_are_one_row() -> None:
    both = ["belt.specific_stiffness", "belt.width"]
    for more in ([], ["--all"], ["--parameters", "belt.width,platform.mass,belt.specific_stiffness"]):
        out = sensitivities(*more)
        (row,) = (names for names in per_cent(out) if names.startswith("belt."))
        assert sorted(row.split(", ")) == both
        assert "Quantities in one row act as one" in out


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
    rows = {name: cells for name, *cells in printed_table(out, "quantity", "sigma", "mode 1", "mode 2")}
    model = pkmodes.load(robot)
    squares = np.zeros(2)
    stated = {path: q for path, q in model.robot.quantities.items() if q.sigma}
    for path, quantity in stated.items():
        h = 1e-4 * quantity.value
        up, down = (
            model.with_values({path: quantity.value + step}).frequencies([0.1, 0.15])[-2:] for step in (h, -h)
        )
        change = quantity.sigma * (up - down) / (2 * h)
        number, unit = rows[path].pop(0).split()
        assert unit == quantity.unit
        assert float(number) == pytest.approx(quantity.sigma, rel=5e-3)  # three digits
        assert rows[path] == [f"{value:+.3f}" for value in change]
        squares += change**2
    assert rows["all together"] == ["", *(f"{value:.3f}" for value in np.sqrt(squares))]
    assert rows.keys() == {*stated, "all together"}


def head(out: str) -> dict[str, str]:
    """Return the frequencies above the tables, by their titles."""
    return dict(re.findall(r"^  (mode \d+ \[Hz\]): (.*)$", out, re.M))


def test_the_head_has_the_frequencies() -> None:
    frequencies = pkmodes.load(PUBLISHED).frequencies(POINT)[3:]
    assert [*head(sensitivities()).values()] == [f"{frequency:.3f}" for frequency in frequencies]


@pytest.mark.parametrize("stiffness", ["2.6e6 N/m", "1e-3 N/m", "1e-9 N/m"])
def test_frequencies_have_their_standard_deviations_however_low_they_are(
    tmp_path: Path, stiffness: str
) -> None:
    text = Path("robots/corexy-printer.toml").read_text(encoding="utf-8").replace("2.6e6 N/m", stiffness)
    (tmp_path / "soft.toml").write_text(text, encoding="utf-8")
    model = pkmodes.load(tmp_path / "soft.toml")
    frequencies, sigmas = (found([0.1, 0.15])[-2:] for found in (model.frequencies, model.frequency_sigmas))
    assert (frequencies < 0.01).all() == (stiffness != "2.6e6 N/m")
    shown = head(printed("sensitivities", tmp_path / "soft.toml", "--pose", "0.1,0.15"))
    for text, frequency, sigma in zip(shown.values(), frequencies, sigmas, strict=True):
        found = re.fullmatch(r"\(?(\S+) \+- ([^ )]+)\)?(e-\d+)?", text)
        assert found is not None
        value, spread, power = found.groups(default="")
        # The standard deviation has two digits, and the frequency ends where they end.
        assert float(value + power) == pytest.approx(frequency, abs=0.05 * sigma)
        assert float(spread + power) == pytest.approx(sigma, rel=0.05)


def test_a_single_quantity_that_is_0_or_that_nothing_depends_on() -> None:
    """Neither has a per cent; the headline is then that of all quantities."""
    absent, still = (sensitivities("--parameters", path) for path in ("effects.payload.mass", "frame.mass"))
    for out in (absent, still):
        assert (
            "Modes 4, 5 and 6 depend most on the radius of the pulleys of each axis (pulley.radius): +0.98 to +0.99 %"
            in " ".join(out.split())
        )
        assert "Per cent of each frequency" not in out
    (rates,) = pkmodes.load(PUBLISHED).sensitivities(POINT, ["effects.payload.mass"]).frequencies
    expected = ["0", "kg", *(f"{rate:.4g}" for rate in rates[3:])]
    assert per_unit(absent) == {"effects.payload.mass": expected}
    assert still.endswith("\n\nNo frequency depends on frame.mass.\n")
    assert "Hz per unit" not in still


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
    assert "At x = 600 mm, y = 30 mm, z = -245 mm, motors held;" in " ".join(out.split())
    assert "No frequency depends on motor.inertia.\n" in out
