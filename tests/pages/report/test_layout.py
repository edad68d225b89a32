"""What is drawn on a page is not cut off and does not cover anything, and a long page opens short."""

from __future__ import annotations

import itertools
import json
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
import xarray

import pkmodes
from helpers.pages.browser import opened
from pkmodes.pages.plots import influence
from pkmodes.pages.report import map as map_pages
from pkmodes.pages.report.blocks import Summary
from pkmodes.pages.report.page import page
from pkmodes.pages.view import page as view_page
from pkmodes.pages.view import page_data, scene

#: The rectangles of the labels in the picture, and of what stands on it [px].
LABELS = """() => {
  const root = document.querySelector('.pkview'), { stage } = root.viewer, { camera, labels } = stage;
  const box = stage.renderer.domElement.getBoundingClientRect(), m = camera.projectionMatrix.elements;
  camera.updateMatrixWorld();
  const place = (label) => {
    const at = label.position.clone().project(camera);
    const [w, h] = [label.scale.x * m[0], label.scale.y * m[5]];
    const [x, y] = [at.x + (0.5 - label.center.x) * w, at.y + (0.5 - label.center.y) * h];
    return { left: box.left + ((x - w / 2 + 1) / 2) * box.width, right: box.left + ((x + w / 2 + 1) / 2) * box.width,
      top: box.top + ((1 - y - h / 2) / 2) * box.height, bottom: box.top + ((1 - y + h / 2) / 2) * box.height };
  };
  const over = ['.pkview-title', '.pkview-legend'].map((part) => root.querySelector(part).getBoundingClientRect());
  return { shown: labels.children.filter((one) => one.visible).map(place), count: labels.children.length,
    over: over.map(({ left, right, top, bottom }) => ({ left, right, top, bottom })) };
}"""


def cover(a: dict[str, float], b: dict[str, float]) -> bool:
    return (
        min(a["right"], b["right"]) - max(a["left"], b["left"]) > 0.5
        and min(a["bottom"], b["bottom"]) - max(a["top"], b["top"]) > 0.5
    )


@pytest.mark.parametrize("width", [1280, 700, 390])
@pytest.mark.parametrize(
    ("robot", "pose"),
    [("hexaglide", [0.04, 0.0, 0.12, 0.0, 0.0, 0.0]), ("linear-delta-2022", [0.6, 0.02, -0.245])],
)
def test_labels_of_the_view_stay_off_its_caption(
    robot: str, pose: list[float], width: int, tmp_path: Path
) -> None:
    file = tmp_path / "view.html"
    file.write_text(view_page(scene(pkmodes.load(f"robots/{robot}.toml"), pose)), encoding="utf-8")
    with opened(file, width=width, motion="reduce") as browser:
        browser.until("document.querySelector('.pkview')?.viewer?.fitted")
        drawn = browser.page.evaluate(LABELS)
    assert len(drawn["shown"]) == drawn["count"] > 0
    assert not [label for label in drawn["shown"] for part in drawn["over"] if cover(label, part)]


def test_a_large_view_is_packed_and_moves_all_the_same(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    shown = scene(pkmodes.load("robots/linear-delta-2022.toml"), [0.6, 0.02, -0.245])
    plain, file = page_data.scene_data(shown), tmp_path / "view.html"
    monkeypatch.setattr(page_data, "MAX_PLAIN_CHARACTERS", 100)
    file.write_text(view_page(shown), encoding="utf-8")
    assert '<script type="application/json">' not in file.read_text(encoding="utf-8")
    with opened(file) as browser:
        browser.until("document.querySelector('.pkview')?.viewer?.fitted")
        assert browser.page.evaluate("document.querySelector('.pkview').viewer.data") == json.loads(
            json.dumps(plain)
        )
        assert browser.problems == []


def test_no_label_of_a_tall_volume_is_cut_off(tmp_path: Path) -> None:
    x, z = np.linspace(-0.2, 0.2, 9), np.linspace(-0.5, 0.5, 21)
    X, Y, Z = np.meshgrid(x, x, z, indexing="ij")
    valid = X**2 + Y**2 <= 0.04
    dims = ("x", "y", "z")
    dataset = xarray.Dataset(
        {
            "valid": (dims, valid),
            "frequency": ((*dims, "mode"), np.where(valid, 50.0 + Z, np.nan)[..., None]),
            "unstable_modes": (dims, np.zeros(valid.shape, int)),
        },
        {name: (name, places, {"units": "m"}) for name, places in zip(dims, (x, x, z), strict=True)},
    )
    model: Any = SimpleNamespace(mechanism=SimpleNamespace(directions=dims))
    (section,) = map_pages._volume_sections(model, dataset)
    file = tmp_path / "page.html"
    file.write_text(page(Summary("s", "Map", headline="h"), [section]), encoding="utf-8")
    with opened(file) as browser:
        names, cut = browser.page.evaluate(
            """() => { const svg = document.querySelector('#volume svg'), box = svg.getBoundingClientRect();
            const texts = [...svg.querySelectorAll('text')];
            const out = texts.filter((text) => { const one = text.getBoundingClientRect();
              return one.left < box.left - 1 || one.right > box.right + 1 || one.top < box.top - 1
                || one.bottom > box.bottom + 1; });
            return [texts.map((text) => text.textContent), out.map((text) => text.textContent)]; }"""
        )
    assert {"x [mm]", "y [mm]", "z [mm]"} <= set(names)
    assert cut == []


@pytest.mark.parametrize("modes", [6, 12, 18])
def test_the_modes_of_a_table_of_influences_are_apart(modes: int) -> None:
    relative = np.random.default_rng(4).normal(size=(1, 1, 5, modes))
    drawing = influence.influence_table([f"value.number_{k}" for k in range(5)], relative)
    drawing.figure.draw_without_rendering()
    (panel,) = drawing.wide.panels
    boxes = sorted(
        (text.get_window_extent() for text in panel.axes.get_xticklabels()), key=lambda box: box.x0
    )
    assert len(boxes) == modes
    assert all(a.x1 + 2.0 < b.x0 for a, b in itertools.pairwise(boxes))
    names = next(column for column in drawing.table if column[0].endswith("(name)") and "mode 1" in column)
    assert f"mode {modes}" in names
