"""What notebooks show: tables of modes, figures with captions, and the moving robot."""

from __future__ import annotations

import re
from dataclasses import replace
from html import unescape

import numpy as np
import pytest

import pkmodes
from pkmodes.figures.pictures import pictures
from pkmodes.view import scene

pytestmark = pytest.mark.usefixtures("backend")

POSES = [[0.6, 0.0, -0.245], [0.5, 0.02, -0.245], [0.1, 0.0, -0.245]]


def test_modes_are_a_table_of_frequencies(model: pkmodes.Model) -> None:
    modes = model.modes(POSES, "nan")
    text = modes._repr_html_()
    assert text is not None
    rows = [re.findall(r"<td>(.*?)</td>", row) for row in re.findall(r"<tr>(.*?)</tr>", text)[1:]]
    assert [row[:3] for row in rows] == [
        ["0.6", "0", "-0.245"],
        ["0.5", "0.02", "-0.245"],
        ["0.1", "0", "-0.245"],
    ]
    np.testing.assert_allclose(np.array(rows[:2])[:, 3:].astype(float), modes.frequencies[:2, 3:], atol=5e-4)
    assert rows[2][3:] == ["limits"] * 6
    assert "f1 [Hz]" in text
    assert model.modes(POSES[0])._repr_html_() is not None
    assert model.modes(POSES[0], fields=["shapes"])._repr_html_() is None


def test_many_poses_are_shortened(model: pkmodes.Model) -> None:
    text = model.modes(np.repeat(POSES[:1], 1000, axis=0))._repr_html_()
    assert text is not None
    assert text.count("<tr>") == 21
    assert "980 more poses" in text


def test_a_figure_comes_with_its_caption() -> None:
    model = pkmodes.load("robots/corexy-printer.toml")
    grid = {"x": np.linspace(0.1, 0.2, 3), "y": np.linspace(0.1, 0.2, 3)}
    picture = next(one for one in pictures(model, grid) if one.name == "frequencies")
    text = picture._repr_html_()
    assert text.count("<svg") == 1
    assert picture.title in unescape(text)


def test_a_scene_is_its_page_in_a_frame(model: pkmodes.Model) -> None:
    text = scene(model, POSES[0])._repr_html_()
    (source,) = re.findall(r'srcdoc="([^"]*)"', text)
    assert unescape(source).startswith("<!doctype html>")
    assert "linear-delta-2022" in unescape(source)


def test_a_hostile_name_is_only_text() -> None:
    name = "<img src=x onerror=alert(1)>\"'</figcaption></caption>"
    robot = pkmodes.load("robots/corexy-printer.toml").robot
    model = pkmodes.Model(replace(robot, name=name))
    grid = {"x": np.linspace(0.1, 0.2, 3), "y": np.linspace(0.1, 0.2, 3)}
    table = model.modes([0.1, 0.2])._repr_html_()
    assert table is not None
    for text in (
        table,
        next(iter(pictures(model, grid)))._repr_html_(),
        scene(model, [0.1, 0.2])._repr_html_(),
    ):
        assert "<img" not in text
        assert "onerror" in text, "shown as it is"
    assert table.count("</caption>") == 1
