"""The numbers and colours of the page follow pose and mode: those of the model at the pose that is shown."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import pkmodes
from helpers.pages.browser import Opened, opened
from helpers.robots.one_of_each import load_free
from pkmodes.machine.maps.workspace import box_of
from pkmodes.pages.view import page, poses_around, scene
from pkmodes.pages.view.interpolation import mean_frequency
from pkmodes.pages.view.page import SLIDER_STEPS

ROBOTS = Path(__file__).parents[3] / "robots"
POSES = {"linear-delta-2022": [0.6, 0.0, -0.245], "corexy-printer": [0.1, 0.2]}


@pytest.fixture(scope="module")
def pages(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    folder = tmp_path_factory.mktemp("pages")
    for name, pose in POSES.items():
        text = page(poses_around(load_free(f"{name}.toml"), pose))
        (folder / f"{name}.html").write_text(text, encoding="utf-8")
    return {name: folder / f"{name}.html" for name in POSES}


@pytest.fixture
def seen(pages: dict[str, Path]) -> Iterator[Opened]:
    with opened(pages["linear-delta-2022"], motion="reduce") as found:
        yield found


def data_of(file: Path) -> dict[str, Any]:
    (text,) = re.findall(r'<script type="application/json">(.*?)</script>', file.read_text(encoding="utf-8"))
    found: dict[str, Any] = json.loads(text)
    return found


def ask(seen: Opened, expression: str) -> Any:
    return seen.page.evaluate(
        f"(() => {{ const viewer = document.querySelector('.pkview').viewer; return {expression}; }})()"
    )


def numbers(seen: Opened, part: str) -> dict[tuple[str | None, ...], float]:
    """The numbers of the cells of a kind, by mode and row."""
    row = {"share": "data-spring", "direction": "data-component"}.get(part, "data-part")
    return {
        (cell.get_attribute("data-mode"), cell.get_attribute(row)): float(
            cell.inner_text().removesuffix(" Hz").replace("\u2212", "-")
        )
        for cell in seen.page.locator(f'td[data-part="{part}"]').all()
    }


def to_the_next_computed_pose(seen: Opened, axis: int) -> None:
    """Move a slider from one computed pose to the next by its keys."""
    for _ in range(SLIDER_STEPS):
        seen.page.locator('[data-part="level"]').nth(axis).press("ArrowRight")
    assert said(seen, "between") == "Computed for this pose."


def said(seen: Opened, part: str) -> str:
    return str(seen.page.locator(f'[data-part="{part}"]').first.inner_text())


def expect_numbers_of_the_model(seen: Opened, model: pkmodes.Model, pose: list[float], mode: int) -> None:
    modes, shown = model.modes(pose), scene(model, pose)
    units = modes.platform_shapes / np.linalg.norm(modes.platform_shapes, axis=-1, keepdims=True)
    vibrations = range(modes.rigid_modes, len(modes.frequencies))
    assert numbers(seen, "frequency") == {
        (str(m), "frequency"): pytest.approx(modes.frequencies[m], abs=0.0051) for m in vibrations
    }
    assert numbers(seen, "direction") == {
        (str(m), str(k)): pytest.approx(units[m, k], abs=0.0051)
        for m in vibrations
        for k in range(units.shape[1])
    }
    assert numbers(seen, "share") == {
        (str(m), str(k)): pytest.approx(100.0 * shown.shares[0, m, k], abs=0.0551)
        for m in vibrations
        for k in range(len(shown.springs))
    }
    place = ", ".join(f"{name} = {1e3 * value:.1f} mm" for name, value in zip("xyz", pose, strict=False))
    assert said(seen, "place").replace("\u2212", "-") == place
    number = mode - modes.rigid_modes + 1
    assert said(seen, "title") == f"Mode {number}: {modes.frequencies[mode]:.2f} Hz"
    most = int(shown.shares[0, mode].argmax())
    share, named = said(seen, "held").split(" % of the strain energy in ")
    assert float(share) == pytest.approx(100.0 * shown.shares[0, mode, most], abs=0.51)
    told = re.split(", | and ", named.removeprefix("each of "))
    for spring, part in zip(shown.springs, shown.shares[0, mode], strict=True):
        assert (spring.name in told) == (part > shown.shares[0, mode, most] - 5e-4)
    motion = said(seen, "motion").replace("\u2212", "-").removeprefix("Platform moves along ")
    listed = dict(part.split() for part in motion.split(", "))
    expected = {
        name: share
        for name, share in zip(shown.directions, units[mode].tolist(), strict=True)
        if abs(share) >= 0.005
    }
    assert {name: float(value) for name, value in listed.items()} == pytest.approx(expected, abs=0.0051)


def test_table_title_and_motion_are_those_of_the_pose_and_mode_shown(seen: Opened) -> None:
    model = pkmodes.load(ROBOTS / "linear-delta-2022.toml")
    to_the_next_computed_pose(seen, 0)
    to_the_next_computed_pose(seen, 1)
    seen.page.locator('[data-part="mode"][value="4"]').check()
    pose = ask(seen, "viewer.data.poses[viewer.stateIndex]")
    assert all(abs(a - b) > 1e-3 for a, b in zip(pose[:2], POSES["linear-delta-2022"][:2], strict=True))
    expect_numbers_of_the_model(seen, model, pose, 4)
    outputs = seen.page.locator('[data-part="level-value"]').all_inner_texts()
    assert [one.replace("\u2212", "-") for one in outputs] == [f"{1e3 * value:.1f} mm" for value in pose]
    shown = scene(model, pose)
    size = scene(model, POSES["linear-delta-2022"]).size
    moved = shown.points[0] + 0.06 * size * shown.scale(0, 4) * shown.displacements(0, 4)
    np.testing.assert_allclose(
        np.reshape(ask(seen, "viewer.stage.displacedPoints()"), (-1, 3)), moved, atol=2e-4
    )
    # Played at half a period per second.
    hertz = model.modes(pose).frequencies[4]
    told = re.fullmatch(
        r"The largest displacement is shown as ([\d.]+) mm, slowed down ([\d.]+) times\.",
        said(seen, "enlarged"),
    )
    assert told is not None
    assert float(told[1]) == pytest.approx(60.0 * size, abs=0.06)
    assert float(told[2]) == pytest.approx(hertz / 0.5, abs=0.51)


def test_springs_that_hold_equal_shares_by_symmetry_are_named_together(pages: dict[str, Path]) -> None:
    """In the middle plane, the robot is its own mirror image: belts 2 and 3 hold the same energy in mode 1."""
    expected = "43 % of the strain energy in each of span 2 of belt 2 and span 2 of belt 3"
    with opened(pages["linear-delta-2022"], motion="reduce") as found:
        assert said(found, "held") == expected
    with opened(pages["linear-delta-2022"], java_script_enabled=False) as found:
        assert said(found, "held") == expected


def test_readouts_of_sliders_stay_inside_the_panel(pages: dict[str, Path]) -> None:
    for width in (1280, 360):
        with opened(pages["linear-delta-2022"], width=width, motion="reduce") as found:
            found.page.locator('[data-part="level"]').nth(2).press("Home")
            found.page.locator('[data-part="level"]').nth(2).press("ArrowRight")
            edge = found.page.locator(".pkview-panel").bounding_box()
            assert edge is not None
            boxes = [one.bounding_box() for one in found.page.locator(".pkview-row output").all()]
            assert {round(box["x"] + box["width"], 1) for box in boxes if box} == {
                round(edge["x"] + edge["width"], 1)
            }
            sliders = [one.bounding_box() for one in found.page.locator(".pkview-row input").all()]
            assert len({(round(box["x"], 1), round(box["width"], 1)) for box in sliders if box}) == 1
            widths = found.page.evaluate(
                "[...document.querySelectorAll('.pkview-row output')].map((one) => one.scrollWidth - one.clientWidth)"
            )
            assert max(widths) <= 0


def test_without_a_program_the_table_is_that_of_the_pose_shown_first(pages: dict[str, Path]) -> None:
    model = load_free("corexy-printer.toml")
    modes = model.modes(POSES["corexy-printer"])
    units = modes.platform_shapes / np.linalg.norm(modes.platform_shapes, axis=-1, keepdims=True)
    with opened(pages["corexy-printer"], motion="reduce", java_script_enabled=False) as found:
        rows = [row.split("\t") for row in found.page.locator("table").inner_text().splitlines()]
        cells = {row[0]: row[1:] for row in rows}
        sigmas = model.frequency_sigmas(POSES["corexy-printer"])[2:]
        assert all(1.0 < sigma < 10.0 for sigma in sigmas)  # two digits: one decimal
        pairs = list(zip(modes.frequencies[2:], sigmas, strict=True))
        assert cells["Frequency"] == [f"{value:.1f} \u00b1 {sigma:.1f} Hz" for value, sigma in pairs]
        for k, name in enumerate("xy"):
            assert [
                float(cell.replace("\u2212", "-")) for cell in cells[f"Tool head along {name}"]
            ] == pytest.approx(units[2:, k].tolist(), abs=0.0051)
        listed = [one.split() for one in found.page.locator(".pkview-modes label").all_inner_texts()]
        assert [one[-2:] for one in listed[:2]] == [[f"{value:.1f}", "Hz"] for value in modes.frequencies[2:]]
        assert said(found, "place") == "x = 100.0 mm, y = 200.0 mm"


def test_the_more_energy_a_belt_holds_the_darker_it_is(seen: Opened) -> None:
    springs = "viewer.stage.shapes.filter((s) => s.element.spring >= 0)"
    to_the_next_computed_pose(seen, 1)
    pose = ask(seen, "viewer.data.poses[viewer.stateIndex]")
    model = pkmodes.load(ROBOTS / "linear-delta-2022.toml")
    shares = scene(model, pose).shares[0]
    for mode in (3, 5, 8):
        seen.page.locator(f'[data-part="mode"][value="{mode}"]').check()
        of = ask(seen, f"{springs}.map((s) => s.element.spring)")
        colours = ask(seen, f"{springs}.map((s) => s.material.color.getHexString())")
        light = np.array([[int(one[i : i + 2], 16) for i in (0, 2, 4)] for one in colours]) @ [
            0.3,
            0.59,
            0.11,
        ]
        order = np.argsort(shares[mode][of])
        assert (np.diff(light[order]) <= 1.0).all(), (mode, shares[mode][of], light)
        assert light[order[0]] - light[order[-1]] > 40.0
    seen.page.locator('[data-part="mode"][value="0"]').check()
    assert len(set(ask(seen, f"{springs}.map((s) => s.material.color.getHexString())"))) == 1


def test_the_scale_of_energy_is_the_same_on_all_pages(pages: dict[str, Path]) -> None:
    for file in pages.values():
        text = file.read_text(encoding="utf-8")
        assert "<span>0 %</span><span>50 %</span><span>100 %</span>" in text
    with opened(pages["corexy-printer"], motion="reduce") as found:
        held = ask(found, "viewer.state.shares[viewer.mode]")
        painted = ask(
            found, "viewer.stage.shapes.filter((s) => s.element.spring >= 0).map((s) => s.widthFactor)"
        )
        springs = [one["spring"] for one in data_of(pages["corexy-printer"])["elements"]]
        expected = [1.0 + 1.4 * held[k] for k in springs if k >= 0]
        assert painted == pytest.approx(expected), "thickness and colour follow the share itself"


def test_between_computed_poses_the_page_interpolates_and_says_so(seen: Opened) -> None:
    """Half-way between two poses on the x axis: compliances of paired modes average, shapes keep their sign."""
    model = pkmodes.load(ROBOTS / "linear-delta-2022.toml")
    before = ask(seen, "viewer.state")
    for _ in range(SLIDER_STEPS // 2):
        seen.page.locator('[data-part="level"]').nth(0).press("ArrowRight")
    found = ask(seen, "viewer.state")
    levels = ask(seen, "viewer.data.levels[0]")
    low = levels.index(before["pose"][0])
    x = 0.5 * (levels[low] + levels[low + 1])
    assert found["pose"] == pytest.approx([x, *before["pose"][1:]])
    ends = [model.modes([value, *before["pose"][1:]]) for value in levels[low : low + 2]]
    # The frequencies of neighbouring poses are far apart and in the same order here.
    ranked = np.stack([one.frequencies[3:] for one in ends])
    assert found["frequencies"][3:] == pytest.approx(mean_frequency(ranked).tolist(), abs=2e-4)
    assert found["frequencies"] == sorted(found["frequencies"])
    assert said(seen, "title") == f"Mode 1: \u2248 {found['frequencies'][3]:.1f} Hz"
    checked = np.arange(1, SLIDER_STEPS) / SLIDER_STEPS
    values = [(1 - t) * levels[low] + t * levels[low + 1] for t in checked]
    exact = [model.frequencies([value, *before["pose"][1:]])[3:] for value in values]
    between = [mean_frequency(ranked, np.array([1 - t, t])) for t in checked]
    off = np.abs(np.array(between) / np.array(exact) - 1.0).max()
    assert found["deviation"] == pytest.approx(off, abs=6e-6), (
        "that of this edge of the grid, not of a cell beside it"
    )
    assert said(seen, "between") == (
        f"Interpolated between computed poses: frequencies are off by up to {float(f'{100 * off:.2g}'):g} %."
    )
    assert said(seen, "place").endswith(", interpolated")
    shapes = [np.array(one["displacements"][3]) for one in (before, found)]
    cosine = shapes[0] @ shapes[1] / np.linalg.norm(shapes[0]) / np.linalg.norm(shapes[1])
    assert cosine > 0.9
    assert np.linalg.norm(np.reshape(found["displacements"][3], (-1, 3)), axis=1).max() <= 1.0 + 1e-9
    assert sum(found["shares"][3]) == pytest.approx(1.0, abs=1e-3)


def test_pulleys_turn_with_the_belt_that_pulls_the_carriage(seen: Opened) -> None:
    """In a rigid-body motion the top of every pulley, where the belt is clamped, moves as the carriage does."""
    seen.page.locator('[data-part="mode"][value="1"]').check()
    state = """(() => {
      const stage = viewer.stage, at = (phase) => {
        stage.phase = phase; stage.render();
        return stage.shapes.filter((s) => s.element.kind === "pulley").map((s) => s.group.quaternion.toArray());
      };
      return [at(0), at(1)];
    })()"""
    still, turned = (Rotation.from_quat(quaternions) for quaternions in ask(seen, state))
    vectors = (turned * still.inv()).as_rotvec()
    assert np.linalg.norm(vectors, axis=1).max() < 3.0, "less than half a turn, so that the sign is known"
    elements, rest = (
        ask(seen, "viewer.data.elements"),
        np.reshape(ask(seen, "viewer.data.points[viewer.stateIndex]"), (-1, 3)),
    )
    moved = np.reshape(ask(seen, "viewer.stage.displacedPoints()"), (-1, 3)) - rest
    pulleys = [one for one in elements if one["kind"] == "pulley"]
    assert len(pulleys) == 6
    for pulley, vector in zip(pulleys, vectors, strict=True):
        axis = pulley["name"].rsplit(" ", 1)[1]
        (carriage,) = (one for one in elements if one["name"] == f"carriage {axis}")
        expected = moved[carriage["points"][0]]
        top = np.cross(vector, [0.0, 0.0, 0.035])
        np.testing.assert_allclose(top, expected, atol=2e-4)
    assert np.abs(moved).max() > 0.01


def test_the_arrow_points_along_the_motion_of_the_platform(seen: Opened) -> None:
    modes = pkmodes.load(ROBOTS / "linear-delta-2022.toml").modes(POSES["linear-delta-2022"])
    for mode in (3, 4):
        seen.page.locator(f'[data-part="mode"][value="{mode}"]').check()
        (bar,) = Rotation.from_quat([ask(seen, "viewer.stage.trace[0].quaternion.toArray()")]).apply(
            [0, 1, 0]
        )
        expected = modes.platform_shapes[mode] / np.linalg.norm(modes.platform_shapes[mode])
        assert abs(bar @ expected) == pytest.approx(1.0, abs=1e-3)


def test_a_slider_leads_to_the_nearest_place_with_its_own_value(seen: Opened) -> None:
    found = ask(seen, "viewer.data")
    sizes = [len(values) for values in found["levels"]]
    places = np.reshape(found["places"], sizes)
    assert (places < 0).any()
    for i, slider in enumerate(seen.page.locator('[data-part="level"]').all()):
        wanted = np.array(ask(seen, "viewer.state.gridPosition"), dtype=float)
        wanted[i] = sizes[i] - 1
        slider.press("End")
        at = np.array(ask(seen, "viewer.state.gridPosition"), dtype=float)
        computed = np.argwhere(places >= 0)
        computed = computed[computed[:, i] == wanted[i]]
        assert len(computed)
        assert at[i] == wanted[i]
        least = ((computed - wanted) ** 2).sum(axis=1).min()
        assert ((at - wanted) ** 2).sum() <= least, "no computed pose is nearer"


@pytest.mark.parametrize("name", POSES)
def test_the_workspace_in_the_page_has_the_axes_of_the_poses(pages: dict[str, Path], name: str) -> None:
    model = pkmodes.load(ROBOTS / f"{name}.toml")
    low, high = box_of(model, np.array(POSES[name]))
    vertices = np.reshape(data_of(pages[name])["workspace"]["vertices"], (-1, 3))[:, : len(low)]
    # Its tips at the ends of the rails are thinner than a cell of the grid: some 6 cm of 1 m are cut off.
    np.testing.assert_allclose(vertices.min(axis=0), low, atol=0.08)
    np.testing.assert_allclose(vertices.max(axis=0), high, atol=0.08)
