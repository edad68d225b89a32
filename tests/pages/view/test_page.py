"""The page in a real browser: nothing leaves it, the robot moves, and everyone can use it."""

from __future__ import annotations

import base64
import io
import json
import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

import pkmodes
from helpers.pages.browser import Opened, opened
from pkmodes.cli import run
from pkmodes.pages.view import assets, fragment, page, poses_around, scene
from pkmodes.pages.view.page_data import script_json

ROBOTS = Path(__file__).parents[3] / "robots"
POSES = {
    "linear-delta-2022": [0.6, 0.0, -0.245],
    "clavel-delta": [0.0, 0.0, -0.55],
    "corexy-printer": [0.1, 0.2],
}
#: Largest page [bytes].
LARGEST = 1_500_000


@pytest.fixture(scope="module")
def pages(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """Return the page of each robot file, as the command writes it."""
    folder = tmp_path_factory.mktemp("pages")
    found = {}
    for name, pose in POSES.items():
        found[name] = folder / f"{name}.html"
        arguments = ["show", str(ROBOTS / f"{name}.toml"), "--pose", ",".join(map(str, pose))]
        assert run([*arguments, "--out", str(found[name])]) == 0
    return found


def picture(seen: Opened) -> np.ndarray:
    """Return the pixels of the picture, without what lies over it."""
    seen.page.evaluate("document.querySelectorAll('.pkview').forEach((one) => one.viewer.draw())")
    shot = seen.page.evaluate("document.querySelector('canvas').toDataURL()")
    return np.asarray(Image.open(io.BytesIO(base64.b64decode(shot.split(",")[1]))).convert("RGB"), dtype=int)


def stage(seen: Opened, expression: str) -> Any:
    return seen.page.evaluate(
        f"(() => {{ const viewer = document.querySelector('.pkview').viewer; return {expression}; }})()"
    )


def text(seen: Opened, part: str) -> str:
    return str(seen.page.locator(f'[data-part="{part}"]').first.inner_text())


def clean(seen: Opened) -> None:
    assert seen.problems == []
    assert seen.outside == []


@pytest.mark.parametrize("name", POSES)
def test_a_page_is_one_small_file_that_draws_a_moving_robot(pages: dict[str, Path], name: str) -> None:
    assert pages[name].stat().st_size < LARGEST
    with opened(pages[name], offline=True) as seen:
        seen.page.evaluate("window.first = document.querySelector('.pkview').viewer.stage.displacedPoints()")
        now = "document.querySelector('.pkview').viewer.stage.displacedPoints()"
        seen.until(f"{now}.some((r, i) => Math.abs(r - first[i]) > 0.001)")  # plays by itself
        pixels = picture(seen)
        background = pixels[2, 2]
        assert (np.abs(pixels - background).sum(axis=-1) > 60).mean() > 0.02, "the picture is not blank"
        seen.page.get_by_role("button", name="Pause").click()
        still = stage(seen, "viewer.stage.displacedPoints()")
        seen.page.wait_for_timeout(300)
        assert stage(seen, "viewer.stage.displacedPoints()") == still
        clean(seen)


@pytest.mark.parametrize("width", [390, 820, 1280])
def test_no_label_is_cut_at_the_edge_of_the_picture(tmp_path: Path, width: int) -> None:
    robot = ROBOTS / "linear-delta-2022-identified.toml"
    assert run(["show", str(robot), "--out", str(tmp_path / "page.html")]) == 0
    with opened(tmp_path / "page.html", width=width, motion="reduce") as seen:
        labels = stage(seen, "viewer.stage.labels.visible") and picture(seen)
        seen.page.locator('[data-part="labels"]').uncheck()
        changed = np.abs(labels - picture(seen)).sum(axis=-1) > 30
        assert changed.any()
        assert not changed[:, :2].any()
        assert not changed[:, -2:].any()
        legend, buttons = (
            seen.page.locator(f".pkview-{part}").bounding_box() for part in ("legend", "buttons")
        )
        assert legend is not None
        assert buttons is not None
        beside = legend["x"] + legend["width"] + 8 <= buttons["x"]
        assert beside or legend["y"] + legend["height"] <= buttons["y"]


@pytest.mark.parametrize("name", POSES)
def test_no_label_covers_another_from_any_side(pages: dict[str, Path], name: str) -> None:
    boxes = """viewer.stage.labels.children.filter((one) => one.visible).map((one) => {
      const { x, y } = one.position.clone().project(viewer.stage.camera);
      const m = viewer.stage.camera.projectionMatrix.elements;
      const [w, h] = [one.scale.x * m[0], one.scale.y * m[5]], { x: u, y: v } = one.center;
      return [x - w * u, x + w * (1 - u), y - h * v, y + h * (1 - v)];
    })"""
    with opened(pages[name], width=500, motion="reduce") as seen:
        for _ in range(4):
            stage(seen, "[viewer.stage.orbit(0.8, 0), viewer.draw()]")
            found = np.array(stage(seen, boxes))
            assert len(found)
            for i, one in enumerate(found):
                for other in found[i + 1 :]:
                    apart = [one[k] >= other[k + 1] or other[k] >= one[k + 1] for k in (0, 2)]
                    assert any(apart), (one, other)


def test_what_moves_is_the_mode_of_the_model(pages: dict[str, Path]) -> None:
    """The displacement of the platform in the picture has the direction of the model, and the size of the slider."""
    model = pkmodes.load(ROBOTS / "linear-delta-2022.toml")
    modes = model.modes(POSES["linear-delta-2022"])
    shown = scene(model, POSES["linear-delta-2022"])
    with opened(pages["linear-delta-2022"], motion="reduce") as seen:
        for m in range(3, 9):
            seen.page.locator(f'[data-part="mode"][value="{m}"]').check()
            rest = stage(seen, "viewer.state.points")
            moved = np.subtract(stage(seen, "viewer.stage.displacedPoints()"), rest).reshape(-1, 3)
            expected = modes.platform_shapes[m]
            cosine = moved[0] @ expected / np.linalg.norm(moved[0]) / np.linalg.norm(expected)
            assert abs(cosine) == pytest.approx(1.0, abs=1e-4)
            whole = shown.displacements(0, m) * shown.scale(0, m) * 0.06 * shown.size
            np.testing.assert_allclose(moved, whole, atol=2e-5)
            assert text(seen, "title") == f"Mode {m - 2}: {modes.frequencies[m]:.2f} Hz"
            announced = text(seen, "status")  # to screen readers, of what was chosen
            assert f"{modes.frequencies[m]:.2f} Hz" in announced or m == 3
        assert seen.page.locator('[aria-live="polite"][data-part="status"]').count() == 1
        clean(seen)


def test_modes_poses_amplitude_and_speed_change_what_is_shown(pages: dict[str, Path]) -> None:
    with opened(pages["linear-delta-2022"], motion="reduce") as seen:
        before = picture(seen)
        seen.page.locator('[data-part="mode"][value="8"]').check()
        other_mode = picture(seen)
        assert (before != other_mode).any()
        assert text(seen, "title").startswith("Mode 6")
        shares = seen.page.locator('[data-part="share"]').all_inner_texts()
        points = stage(seen, "viewer.state.points")
        seen.page.locator('[data-part="level"]').nth(1).press("ArrowRight")
        assert stage(seen, "viewer.state.points") != points
        assert seen.page.locator('[data-part="share"]').all_inner_texts() != shares
        assert (picture(seen) != other_mode).any()
        moved = stage(seen, "viewer.stage.displacedPoints()")
        seen.page.locator('[data-part="amplitude"]').press("ArrowRight")
        assert stage(seen, "viewer.stage.displacedPoints()") != moved
        assert text(seen, "amplitude-value") == "6.5 %"
        assert "changes the length" not in text(seen, "enlarged")
        seen.page.locator('[data-part="amplitude"]').press("End")
        assert "visibly changes the length of rigid links" in text(seen, "enlarged")
        seen.page.locator('[data-part="speed"]').press("ArrowRight")
        assert text(seen, "speed-value") == "0.55 /s"
        clean(seen)


def test_an_unreachable_corner_leads_to_the_nearest_reachable_pose(pages: dict[str, Path]) -> None:
    model = pkmodes.load(ROBOTS / "linear-delta-2022.toml")
    with opened(pages["linear-delta-2022"], motion="reduce") as seen:
        said = ""
        for slider in seen.page.locator('[data-part="level"]').all():
            slider.press("End")
            pose = stage(seen, "viewer.state.pose")
            assert model.check(pose).valid
            said += text(seen, "status")
        assert "nearest pose" in said
        clean(seen)


def test_another_part_of_the_page_moves_the_robot_and_learns_of_its_moves(pages: dict[str, Path]) -> None:
    with opened(pages["linear-delta-2022"], motion="reduce") as seen:
        seen.page.evaluate(
            "window.moves = []; document.addEventListener('pkmodes-moved', (e) => moves.push(e.detail.pose))"
        )
        far = stage(seen, "viewer.data.poses.at(-1)")
        between = stage(seen, "viewer.states.nearestReachable([1.5, 2.5, 1.5])")
        seen.page.evaluate(
            "(pose) => document.dispatchEvent(new CustomEvent('pkmodes-pose', { detail: { pose } }))", far
        )
        assert seen.page.evaluate("moves") == [], "what was asked for is not told"
        shown = ", ".join(f"{name} = {1e3 * value:.1f} mm" for name, value in zip("xyz", far, strict=True))
        assert text(seen, "place").replace("\u2212", "-") == shown
        near = stage(seen, f"viewer.states.stateAt({between}).pose")
        seen.page.evaluate(
            "(pose) => document.dispatchEvent(new CustomEvent('pkmodes-pose', { detail: { pose } }))", near
        )
        assert stage(seen, "viewer.state.pose") == pytest.approx(near, abs=1e-9)
        seen.page.locator('[data-part="level"]').nth(0).press("Home")
        (told,) = seen.page.evaluate("moves")
        assert told == stage(seen, "viewer.state.pose")
        assert told[0] < near[0]
        clean(seen)


def test_the_table_gives_the_shares_of_the_energy(pages: dict[str, Path]) -> None:
    shown = scene(pkmodes.load(ROBOTS / "corexy-printer.toml"), POSES["corexy-printer"])
    with opened(pages["corexy-printer"], motion="reduce", java_script_enabled=False) as seen:
        rows = [row.split("\t") for row in seen.page.locator("table").inner_text().splitlines()]
        cells = {row[0]: row[1:] for row in rows}
        for k, spring in enumerate(shown.springs):
            expected = [f"{100 * share:.1f}" for share in shown.shares[0, shown.rigid_modes :, k]]
            assert cells[f"{spring.name} [%]"] == expected
        assert seen.page.locator("noscript p").is_visible()
        assert seen.page.locator(".pkview-svg").is_visible(), "the still"
        assert not seen.page.locator("canvas").first.is_visible()


def test_without_webgl_a_message_and_the_table_remain(pages: dict[str, Path]) -> None:
    arguments = ("--disable-gpu", "--disable-3d-apis")
    with opened(pages["linear-delta-2022"], arguments=arguments) as seen:
        assert "WebGL is not available" in text(seen, "message")
        seen.page.locator('[data-part="mode"][value="8"]').check()
        assert "Mode 6" in text(seen, "status")
        assert seen.page.locator('[data-part="share"]').first.is_visible()
        assert seen.page.locator(".pkview-svg").is_visible(), "the still"
        assert seen.outside == []
        assert not [one for one in seen.problems if "WebGL" not in one]


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("width", [1280, 390])
def test_everyone_can_use_the_page(pages: dict[str, Path], scheme: Any, width: int) -> None:
    with opened(pages["linear-delta-2022"], width=width, height=844, scheme=scheme, motion="reduce") as seen:
        assert seen.findings() == []
        assert not seen.sideways
        assert not stage(seen, "viewer.isPlaying"), "motion that was not asked for"
        lightness = picture(seen)[2, 2].mean()
        assert lightness < 60 if scheme == "dark" else lightness > 200
        clean(seen)


def test_keys_turn_the_view_and_reset_it(pages: dict[str, Path]) -> None:
    position = "viewer.stage.camera.position.toArray()"
    with opened(pages["clavel-delta"], motion="reduce") as seen:
        start = stage(seen, position)
        canvas = seen.page.locator("canvas[tabindex]")
        for key in ("ArrowLeft", "ArrowUp", "+"):
            before = stage(seen, position)
            canvas.press(key)
            assert np.abs(np.subtract(stage(seen, position), before)).max() > 1e-3
        seen.page.get_by_role("button", name="Reset view").click()
        np.testing.assert_allclose(stage(seen, position), start, atol=1e-9)
        canvas.press(" ")
        assert seen.page.get_by_role("button", name="Pause").is_visible()
        box = canvas.bounding_box()
        assert box is not None
        seen.page.mouse.move(box["x"] + 300, box["y"] + 300)
        seen.page.mouse.down()
        seen.page.mouse.move(box["x"] + 380, box["y"] + 330, steps=4)
        seen.page.mouse.up()
        assert np.abs(np.subtract(stage(seen, position), start)).max() > 1e-3
        clean(seen)


def test_a_printed_page_is_light_and_still(pages: dict[str, Path]) -> None:
    with opened(pages["linear-delta-2022"], scheme="dark") as seen:
        before = stage(seen, "viewer.stage.cameraView().map((one) => one.toArray())")
        seen.page.emulate_media(media="print", color_scheme="dark")
        seen.until("document.querySelector('.pkview').viewer.printing")
        assert picture(seen)[2, 2].mean() > 200
        corner = "[...document.querySelector('.pkview-still').getContext('2d').getImageData(2, 2, 1, 1).data]"
        assert np.mean(seen.page.evaluate(corner)) > 200
        assert seen.page.locator("canvas.pkview-still").is_visible()
        wide, high = seen.page.evaluate(
            "[...['width', 'height'].map((k) => document.querySelector('.pkview-still')[k])]"
        )
        assert wide > 2 * high, "as wide as paper"
        assert not seen.page.locator(".pkview-svg").is_visible()
        first = stage(seen, "viewer.stage.displacedPoints()")
        seen.page.wait_for_timeout(300)
        assert stage(seen, "viewer.stage.displacedPoints()") == first
        assert not seen.page.get_by_role("button", name="Pause").is_visible()
        assert seen.page.locator("table").is_visible()
        seen.page.emulate_media(media="screen")
        after = stage(seen, "viewer.stage.cameraView().map((one) => one.toArray())")
        np.testing.assert_allclose(after, before, atol=1e-9)


def test_a_hostile_name_is_only_text(tmp_path: Path) -> None:
    name = '"></script><script>alert(1)</script><img src=x onerror=alert(2)>&"\''
    model = pkmodes.load(ROBOTS / "corexy-printer.toml")
    hostile = pkmodes.Model(replace(model.robot, name=name))
    file = tmp_path / "hostile.html"
    file.write_text(page(scene(hostile, POSES["corexy-printer"])), encoding="utf-8")
    with opened(file, motion="reduce") as seen:
        seen.page.on("dialog", lambda dialog: seen.problems.append(dialog.message))
        seen.page.reload()
        assert seen.page.locator("h1").inner_text() == name
        labels = [one.get_attribute("aria-label") for one in seen.page.locator("[aria-label]").all()]
        assert [str(label).partition(name)[1] for label in labels[:2]] == [name, name], "section and picture"
        assert seen.page.locator("img").count() == 0
        assert seen.page.locator("select").input_value() == "0"
        clean(seen)
    assert not set("<>&") & set(script_json({"name": name}))
    assert json.loads(script_json({"name": name})) == {"name": name}


def test_several_viewers_share_one_library(tmp_path: Path) -> None:
    robots = [("a", "linear-delta-2022"), ("b", "clavel-delta")]
    parts = [
        fragment(scene(pkmodes.load(ROBOTS / f"{name}.toml"), [POSES[name]]), key) for key, name in robots
    ]
    whole = (
        f"<!doctype html><html lang=en><title>two</title><main><h1>Two</h1>{''.join(parts)}</main>{assets()}"
    )
    file = tmp_path / "two.html"
    file.write_text(whole, encoding="utf-8")
    assert whole.count("var PkmodesThree") == 1
    with opened(file, motion="reduce") as seen:
        ids = seen.page.evaluate("[...document.querySelectorAll('[id]')].map((one) => one.id)")
        assert len(ids) == len(set(ids))
        assert seen.page.evaluate(
            "[...document.querySelectorAll('.pkview')].every((one) => one.viewer.stage)"
        )
        assert seen.findings() == []
        clean(seen)


def test_the_same_robot_gives_the_same_bytes() -> None:
    model = pkmodes.load(ROBOTS / "clavel-delta.toml")
    first, second = (page(poses_around(model, POSES["clavel-delta"])) for _ in range(2))
    assert first == second
    assert not re.search(r"https?://(?!www\.w3\.org/)", first.split("PkmodesThree")[0])


@pytest.fixture
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_the_command_names_its_page_after_the_robot_file(
    here: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["show", str(ROBOTS / "clavel-delta.toml")]) == 0
    assert capsys.readouterr().out == "clavel-delta.html\n"
    data = re.search(
        r'<script type="application/json">(.*?)</script>', (here / "clavel-delta.html").read_text()
    )
    assert data is not None
    assert len(json.loads(data[1])["poses"]) > 20


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--pose", "0.6,0"], "expected 3 components X,Y,Z, found 2"),
        (["--pose", "0.6,0,-0.9"], "the pose is out of reach: link 2 is"),
        (["--pose", "600,0,-245"], "the numbers look like millimetres"),
        (["--out", "missing/page.html"], "the folder missing does not exist"),
        (["--out", ""], "expected the name of a file"),
        (["--out", "page.png"], 'expected a name that ends in .html or .gif, found "page.png"'),
        (["--out", str(ROBOTS / "linear-delta-2022.toml")], "the page would replace its own input"),
    ],
)
def test_bad_input_is_refused_and_nothing_is_written(
    here: Path, capsys: pytest.CaptureFixture[str], arguments: list[str], message: str
) -> None:
    robot = ROBOTS / "linear-delta-2022.toml"
    before = robot.read_bytes()
    assert run(["show", str(robot), *arguments]) == 2
    captured = capsys.readouterr()
    assert captured.err.startswith("error: ")
    assert message in captured.err
    assert captured.err.count("\n") == 1
    assert captured.out == ""
    assert not list(here.iterdir())
    assert robot.read_bytes() == before
