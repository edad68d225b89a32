"""What the paper writes about its figures, as docs/explanation/published-figures.md reports it."""

from __future__ import annotations

import importlib
import re
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pkmodes
from helpers.pages.documentation import same

ROOT = Path(__file__).parents[1]
STUDY = ROOT / "docs/studies/published_figures"
#: Places along the axis of a made-up working area, from the lower to the upper end.
S = np.linspace(0.0, 1.0, 101)


@pytest.fixture(scope="module")
def claims() -> Iterator[Any]:
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(STUDY)
        yield importlib.import_module("claims")


def test_the_table_of_the_page_is_what_the_study_finds(claims: Any) -> None:
    page = (ROOT / "docs/explanation/published-figures.md").read_text(encoding="utf-8")
    (shown,) = re.findall(re.escape(claims.BEGIN) + r"\n(.*?)" + re.escape(claims.END), page, re.S)
    found = claims.table()
    for one, other in zip(shown.splitlines(), found.splitlines(), strict=True):
        same(one, other, fit=True)
    assert found.count("yes:") + found.count("**no**:") == 2 * len(claims.CLAIMS)
    rows = [line.strip("| ").split(" | ") for line in shown.splitlines()[2:]]
    for column in (-2, -1):
        agree = sum(row[column].startswith("yes: ") for row in rows[:-1])
        assert rows[-1][column] == f"**{agree} of {len(rows) - 1}**"


def test_the_sentences_of_the_page_have_the_numbers_of_the_study(claims: Any) -> None:
    page = (ROOT / "docs/explanation/published-figures.md").read_text(encoding="utf-8")
    assert len(claims.PARTS) == 3
    for begin, part in claims.PARTS.items():
        (shown,) = re.findall(re.escape(begin) + r"\n(.*?)" + re.escape(claims.END), page, re.S)
        for one, other in zip(shown.splitlines(), part().splitlines(), strict=True):
            same(one, other, fit=True)


def test_the_median_condition_number_hardly_depends_on_the_spacing_and_the_mean_does(claims: Any) -> None:
    means, medians, area = claims.sentences.condition_numbers()
    assert np.ptp(means) > 1.0
    assert np.ptp(medians) < 0.05
    # The picture's median, over the plane of docs/figures/identified.
    model = pkmodes.load(ROOT / "robots/linear-delta-2022-identified.toml")
    found = model.map(claims.sentences.PLANE)["condition"].values
    assert np.nanmedian(found) == pytest.approx(medians[0], abs=0.05)
    assert area == pytest.approx(np.isfinite(found).sum() * 0.01**2, rel=0.05)


def test_the_page_says_of_the_links_what_its_picture_shows(claims: Any) -> None:
    """Against differences at the poses of a coarse grid of the same plane."""
    model = pkmodes.load(ROOT / "robots/linear-delta-2022-identified.toml")
    grid = {**claims.sentences.PLANE, "x": np.linspace(0.29, 1.23, 48), "y": np.linspace(-0.16, 0.16, 17)}
    length, step = model.robot.quantities["link.length"].value, 1e-6
    up, down = (
        np.log(model.with_values({"link.length": length * (1 + s)}).map(grid)["frequency"].values)
        for s in (step, -step)
    )
    change = ((up - down) / (2 * step)).reshape(-1, 6)
    expected = np.median(change[np.isfinite(change).all(axis=1)], axis=0)
    text = claims.sentences.influences()
    found = re.search(
        r"length of the links matters most in modes (\d) \((.*?)\) and (\d) \((.*?)\)", " ".join(text.split())
    )
    assert found
    first, second = np.argsort(-np.abs(expected))[:2]
    assert (int(found[1]), int(found[3])) == (first + 1, second + 1)
    for shown, value in ((found[2], expected[first]), (found[4], expected[second])):
        assert float(shown.replace("\u2212", "-")) == pytest.approx(value, abs=0.05)


@pytest.mark.parametrize("name", ["identified", "declared"])
def test_the_page_has_its_pictures(name: str) -> None:
    page = (ROOT / "docs/explanation/published-figures.md").read_text(encoding="utf-8")
    pictures = re.findall(rf"\(\.\./(figures/{name}/\w+\.png)\)", page)
    assert len(pictures) >= 4
    for picture in pictures:
        assert (ROOT / "docs" / picture).read_bytes().startswith(b"\x89PNG"), picture


def along(*lines: np.ndarray) -> np.ndarray:
    """Values that are the same across the axis, (101, 5, 6): the first modes as given, the others 1."""
    every = [*lines, *[np.ones(101)] * (6 - len(lines))]
    return np.repeat(np.stack(every, axis=-1)[:, None], 5, axis=1)


def area(claims: Any, **fields: Any) -> Any:
    """Return a made-up area in which nothing varies but the fields given."""
    ones = along()
    plain = {"f": ones, "in_plane": ones, "out_of_plane": ones, "condition": 3.5, "radius": 0.035}
    plain |= {"p": np.tile([0.6, 0.0, 0.8], (101, 5, 6, 1)), "shape": np.ones((101, 5, 6, 9))}
    return importlib.import_module("working_area").Area(**{**plain, **fields})


def slopes(*parts: float) -> np.ndarray:
    """Return a rising line with these slopes on equal parts of the axis."""
    steps = np.repeat(np.array(parts), 100 // len(parts)) / 100.0
    return 50.0 + np.concatenate([[0.0], np.cumsum(steps)])


def test_places_and_slopes_of_frequencies_are_read_along_the_axis(claims: Any) -> None:
    """Frequencies whose answers are known by hand."""
    hill, wavy = 50.0 - 9.0 * (S - 0.45) ** 2, 50.0 + np.sin(20.0 * S)
    ones = np.ones(101)

    def of(*lines: np.ndarray) -> Any:
        return area(claims, f=along(*lines))

    top = claims.f.extreme(2, "maximum", 0.4, 0.5)
    assert top(of(ones, hill)) == (True, "maximum at 45 %")
    assert top(of(ones, hill[::-1])) == (False, "maximum at 55 %")
    assert claims.f.extreme(1, "minimum", 0.95, 1.0)(of(hill)) == (True, "minimum at 100 %")
    assert claims.f.falls_from_its_maximum(of(hill))[0]
    assert not claims.f.falls_from_its_maximum(of(wavy))[0]
    assert claims.f.steeper(2, "lower")(of(ones, slopes(4.0, 1.0))) == (True, "4.0 times")
    assert claims.f.steeper(2, "upper")(of(ones, slopes(4.0, 1.0))) == (False, "0.2 times")
    assert claims.f.changes(2, -1)(of(ones, -S)) == (True, "on 100 % of the axis")
    assert claims.f.changes(2, -1)(of(-S, hill)) == (False, "on 55 % of the axis")
    assert claims.f.changes(5, 1)(of(*[ones] * 4, S)) == (True, "on 100 % of the axis")
    assert claims.f.changes(5, 1)(of(*[ones] * 4, hill)) == (False, "on 45 % of the axis")
    third = claims.f.steep_near_the_ends
    assert third(of(ones, ones, slopes(6.0, 1.0, 2.0, 1.0, 6.0))) == (True, "3 times the middle")
    assert third(of(ones, ones, slopes(1.0, 6.0, 2.0, 6.0, 1.0)))[0] is False
    assert claims.f.symmetric_along(of(*[ones] * 3, 100.0 + (S - 0.5))) == (True, "within 1.0 %")
    assert claims.f.symmetric_along(of(*[ones] * 3, 100.0 + 10.0 * (S - 0.5))) == (False, "within 10.0 %")


def test_symmetry_is_that_to_the_axis(claims: Any) -> None:
    assert claims.f.symmetric(area(claims)) == (True, "to 1e-9")
    leaning = along()
    leaning[:, 4, 2] += 0.01
    assert not claims.f.symmetric(area(claims, f=leaning))[0]
    mirrored = np.tile([0.6, 0.64, 0.48], (101, 5, 6, 1))
    assert not claims.m.symmetric_directions(area(claims, p=mirrored))[0]
    mirrored[:, 2] = [0.6, 0.0, 0.8]
    mirrored[:, 3:, :, 1] *= -1.0
    assert claims.m.symmetric_directions(area(claims, p=mirrored)) == (True, "100.0 % of the poses")
    assert claims.f.condition(area(claims)) == (True, "3.50")
    assert not claims.f.condition(area(claims, condition=4.01))[0]


def test_pulleys_and_trucks_are_those_of_the_robot(claims: Any) -> None:
    """The driven pulleys of the robot file move by 1 in modes 1 to 3, the free ones in modes 4 to 6."""
    file = ROOT / "robots/linear-delta-2022-identified.toml"
    axes, robot = tomllib.loads(file.read_text(encoding="utf-8"))["axis"], pkmodes.load(file)
    driven = [f"theta_{j}_{axis['driven_pulley']}" for j, axis in enumerate(axes, start=1)]
    shape = np.zeros((101, 5, 6, 9))
    for i, name in enumerate(robot.coordinates):
        if name.startswith("theta"):
            shape[:, :, :3, i], shape[:, :, 3:, i] = (1.0, 0.2) if name in driven else (0.2, 1.0)
        else:  # 2 and 0.02 of the radius: the largest component of modes 1 to 3, a fiftieth of it in the others
            shape[:, :, :3, i], shape[:, :, 3:, i] = 0.07, -0.0007
    assert claims.m.driven_pulleys(area(claims, shape=shape)) == (True, "100 % of the modes")
    assert claims.m.driven_pulleys(area(claims, shape=shape[:, :, ::-1])) == (False, "0 % of the modes")
    assert claims.m.trucks(area(claims, shape=shape)) == (True, "50 times, median")
    assert not claims.m.trucks(area(claims, shape=shape[:, :, ::-1]))[0]


def test_sizes_and_changes_of_the_motion(claims: Any) -> None:
    """Modes 1 to 3 move by 3 in the plane and 4 out of it, the others by 1."""
    ones, none = np.ones(101), np.zeros(101)
    large = {
        "in_plane": along(3.0 * ones, 3.0 * ones, 3.0 * ones),
        "out_of_plane": along(*[4.0 * ones] * 3, *[none] * 3),
    }
    assert claims.m.significant(area(claims, **large)) == (True, "5.0 times modes 4 to 6, median")
    assert claims.m.negligible(area(claims, **large))[1] == "below 20 % of modes 1 to 3, at 90 % of the poses"
    assert claims.m.negligible(area(claims, **large))[0]
    assert not claims.m.significant(area(claims))[0]
    assert not claims.m.negligible(area(claims))[0]
    step, ramp = np.where(S > 0.495, 2.0, 1.0), 1.0 + S
    for field in ("in_plane", "out_of_plane"):
        rising = area(claims, **{field: along(ones, step)})
        assert claims.m.compare(field, 2, "upper")(rising) == (True, "lower 1.00, upper 2.00")
        assert not claims.m.compare(field, 2, "lower")(rising)[0]
        holds, text = claims.m.sudden(field, 2)(rising)
        assert holds
        assert re.fullmatch(r"100 % of the range at (47|48|49|50) %", text)
        assert claims.m.sudden(field, 1)(area(claims, **{field: along(ramp)}))[0] is False
        assert (
            claims.m.sudden(field, 1)(area(claims, **{field: along(np.where(S > 0.9, 2.0, 1.0))}))[0] is False
        )
    assert claims.m.no_sudden(area(claims, in_plane=along(ones, ones, ramp)))[0]
    assert not claims.m.no_sudden(area(claims, in_plane=along(ones, ones, step)))[0]
    # From 1 to 2 evenly: 80 % of 1 around the median of 1.5.
    assert claims.m.uniform(area(claims, out_of_plane=along(ones, ones, ramp))) == (
        False,
        "10 to 90 % quantiles within 53 % of the median",
    )
    assert claims.m.uniform(area(claims, out_of_plane=along(ones, ones, 3.0 + S)))[0]
