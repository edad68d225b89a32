"""Measured shapes beside the model's: scaled by least squares, drawn where the sensors are, and only there."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.pages.browser import opened
from pkmodes.pages.view import Scene, page, scene
from pkmodes.pages.view.measured_data import channel_shapes, measured_data
from pkmodes.pages.view.measured_modes import Channel, MeasuredMode, channel_weights, scale_factor

ROBOTS = Path(__file__).parents[3] / "robots"
POSES = [[0.6, 0.0, -0.245], [0.5, 0.05, -0.24]]
NAMES = ("x_1", "x_3", "theta_1_1", "u_x", "p_x", "p_z")
NAN = float("nan")


def measured_scene(shape: tuple[float, ...] = (), mode: int | None = 3) -> Scene:
    """A scene of two poses with one measured mode at the second, by default that of the model times -2.5."""
    bare = scene(pkmodes.load(ROBOTS / "linear-delta-2022.toml"), POSES, chosen=1)
    units = {"theta_1_1": "rad"}
    seen = replace(
        bare, channels=tuple(Channel(name, units.get(name, "m")) for name in NAMES), labels=("P1", "P2")
    )
    own = tuple(-2.5 * value for value in channel_shapes(seen, 1)[3])
    one = MeasuredMode(1, mode, "7", 48.25, 0.1, 0.987, shape or (*own[:3], NAN, own[4], NAN))
    return replace(seen, measured=(one,), what="as declared")


def test_the_factor_is_that_of_least_squares() -> None:
    """By hand: a = (1*2 + 4*3*1*(-1)) / (1 + 4*1) = -2, where the second component weighs twice."""
    found = scale_factor(np.array([1.0, -1.0, NAN]), np.array([2.0, 3.0, 100.0]), np.array([1.0, 2.0, 1.0]))
    assert found == pytest.approx((2.0 - 12.0) / 5.0)
    rng = np.random.default_rng(3)
    v, u, w = rng.normal(size=(3, 6))
    by_numpy = np.linalg.lstsq((w * v)[:, None], w * u, rcond=None)[0][0]
    assert scale_factor(v, u, w) == pytest.approx(by_numpy, rel=1e-12)
    assert scale_factor(np.full(2, NAN), np.ones(2), np.ones(2)) == 0.0


def test_a_channel_that_moves_more_weighs_less_and_a_still_one_nothing() -> None:
    np.testing.assert_allclose(channel_weights(np.array([[3.0, 0.0, 1.0], [4.0, 0.0, 0.0]])), [0.2, 0.0, 1.0])


def test_a_shape_of_another_scale_and_sign_lies_on_that_of_the_model() -> None:
    seen = measured_scene()
    found = measured_data(seen)
    assert found is not None
    (one,) = found["modes"]
    for measured, model, name in zip(one["measured"], one["model"], NAMES, strict=True):
        assert measured is None if name in ("u_x", "p_z") else measured == pytest.approx(model, abs=2e-4)
    moved = seen.displacements(1, 3) * seen.scale(1, 3)
    carriages = {e.name: e.points[0] for e in seen.elements if e.kind == "carriage"}
    arrows = {point: by for point, *by in one["arrows"]}
    assert set(arrows) >= {0}
    assert len(arrows) == 3, "the platform and two carriages"
    np.testing.assert_allclose(arrows.pop(0), [moved[0, 0], 0.0, 0.0], atol=2e-4)  # only p_x was measured
    for point, by in arrows.items():
        np.testing.assert_allclose(by, moved[point], atol=2e-4)
        near = [name for name, at in carriages.items() if np.allclose(moved[at], moved[point])]
        assert near
    ((element, angle),) = one["turns"]
    assert seen.elements[element].turns == "theta_1_1"
    turned = seen.shapes[1, 3, seen.coordinates.index("theta_1_1")] * seen.scale(1, 3)
    assert angle == pytest.approx(turned, abs=2e-4)


def test_a_wrong_component_moves_all_by_the_factor_of_least_squares() -> None:
    """With x_1 of the wrong sign the factor shrinks; it minimises the weighted distance, found by search."""
    exact = measured_scene().measured
    assert exact is not None
    shape = np.array(exact[0].shape)
    shape[0] *= -1.0
    seen = measured_scene(tuple(shape))
    found = measured_data(seen)
    assert found is not None
    (one,) = found["modes"]
    measured = np.array([NAN if v is None else v for v in one["measured"]])
    model, weights = np.array(one["model"]), channel_weights(channel_shapes(seen, 1))
    factor = measured[0] / shape[0]
    known = np.isfinite(shape)

    def distance(a: float) -> float:
        return float(np.sum(((a * shape - model) * weights)[known] ** 2))

    assert all(distance(factor) <= distance(factor * step) + 1e-9 for step in (0.98, 0.99, 1.01, 1.02))


@pytest.mark.parametrize("shape", [(NAN,) * 6, (0.0,) * 6])
def test_a_mode_without_shape_has_no_marks(shape: tuple[float, ...]) -> None:
    found = measured_data(measured_scene(shape))
    assert found is not None
    (one,) = found["modes"]
    assert one["shape"] is False
    assert "arrows" not in one


def test_the_page_moves_the_measured_marks_and_tells_them_in_numbers(tmp_path: Path) -> None:
    seen = measured_scene()
    file = tmp_path / "page.html"
    file.write_text(page(seen), encoding="utf-8")
    marks = "document.querySelector('.pkview').viewer.stage.marks"
    with opened(file, motion="reduce") as found:
        text = lambda part: str(found.page.locator(f'[data-part="{part}"]').first.inner_text())  # noqa: E731
        assert text("observed") == re.findall(r'"observed">(.*?)<', file.read_text(encoding="utf-8"))[0]
        assert text("observed") == "Measured: 48.25 \u00b1 0.10 Hz, MAC 0.987."
        assert "Model as declared" in found.page.locator(".pkview-title").inner_text()
        assert text("place").startswith("P2: x = 500.0 mm")
        # The balls lie where the model is: the measured shape is that of the model.
        moved = np.reshape(
            found.page.evaluate("document.querySelector('.pkview').viewer.stage.displacedPoints()"), (-1, 3)
        )
        balls = found.page.evaluate(f"{marks}.arrows.map((a) => [a.point, a.parts[0].position.toArray()])")
        assert len(balls) == 3
        for point, at in balls:
            expected = moved[point] if point else [moved[0, 0], *seen.points[1, 0, 1:]]
            np.testing.assert_allclose(at, expected, atol=2e-4)
        cells = [row.inner_text().split("\t") for row in found.page.locator('[data-part="component"]').all()]
        assert [cell[0] for cell in cells][2] == "theta_1_1 [mrad]"
        assert [cell[1] for cell in cells][3] == "\u2013", "u_x was not measured"
        for _, measured, model in (cells[i] for i in (0, 1, 2, 4)):
            assert float(measured.replace("\u2212", "-")) == pytest.approx(
                float(model.replace("\u2212", "-")), abs=2e-3
            )
        assert found.findings() == []
        found.page.locator('[data-part="mode"][value="4"]').check()
        assert text("observed") == "Not measured at this pose."
        assert "Not measured at this pose." in text("status")
        assert found.page.evaluate(f"{marks}.group.children.length") == 0
        found.page.locator("select").select_option("0")
        found.page.locator('[data-part="mode"][value="3"]').check()
        assert text("observed") == "Not measured at this pose."
        assert found.problems == []


def test_the_measured_modes_fit_a_phone(tmp_path: Path) -> None:
    file = tmp_path / "page.html"
    file.write_text(page(replace(measured_scene(), what="with the causes: " + "very long names " * 6)))
    with opened(file, width=360, height=800, motion="reduce") as found:
        assert not found.sideways
        boxes = [
            found.page.locator(f".pkview-{name}").bounding_box() for name in ("title", "legend", "buttons")
        ]
        picture = found.page.locator("canvas[tabindex]").bounding_box()
        title, legend, buttons = boxes
        assert title is not None
        assert legend is not None
        assert buttons is not None
        assert picture is not None
        assert title["y"] + title["height"] <= picture["y"] + 1
        assert picture["y"] + picture["height"] <= legend["y"] + 1
        assert legend["y"] + legend["height"] <= buttons["y"]
        edge = found.page.locator(".pkview-panel").bounding_box()
        assert edge is not None
        for label in found.page.locator(".pkview-modes label").all():
            box = label.bounding_box()
            assert box is not None
            assert box["x"] + box["width"] <= edge["x"] + edge["width"] + 1
        # The camera sees the whole robot from the beginning.
        corners = found.page.evaluate("""(() => {
          const { stage, state } = document.querySelector('.pkview').viewer, at = [];
          for (let i = 0; i < state.points.length; i += 3) {
            const p = stage.camera.position.clone().set(...state.points.slice(i, i + 3)).project(stage.camera);
            at.push(Math.max(Math.abs(p.x), Math.abs(p.y)));
          }
          return Math.max(...at);
        })()""")
        assert 0.3 < corners < 1.0


def test_a_measured_mode_without_a_partner_is_told(tmp_path: Path) -> None:
    file = tmp_path / "page.html"
    file.write_text(page(measured_scene(mode=None)), encoding="utf-8")
    with opened(file, motion="reduce") as found:
        said = found.page.locator('[data-part="unmatched"]').inner_text()
        assert said == "Measured, without a partner in the model: 48.25 \u00b1 0.10 Hz."
