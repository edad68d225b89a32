"""What notebooks show: tables of modes, figures with captions, and the moving robot."""

from __future__ import annotations

import re
from dataclasses import replace
from html import unescape
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from pkmodes import updating
from pkmodes.pages.figures.pictures import pictures
from pkmodes.pages.view import scene

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
    assert "frequencies of vibration, motors free" in text
    assert "motors held" in str(model.modes(POSES[0], drives="held")._repr_html_())
    assert model.modes(POSES[0])._repr_html_() is not None
    assert model.modes(POSES[0], fields=["shapes"])._repr_html_() is None


def test_many_poses_are_shortened(model: pkmodes.Model) -> None:
    text = model.modes(np.repeat(POSES[:1], 1000, axis=0))._repr_html_()
    assert text is not None
    assert text.count("<tr>") == 21
    assert "980 more poses" in text


def cells_of(text: str) -> list[list[str]]:
    """Return the text of the rows of a table, without what is said about it."""
    rows = re.findall(r"<tr>(.*?)</tr>", text)
    return [
        [unescape(re.sub("<.*?>", "", cell)) for cell in re.findall(r"<t[hd].*?</t[hd]>", row)]
        for row in rows
    ]


def test_statics_are_a_table_of_torques_and_rotations(model: pkmodes.Model) -> None:
    statics = model.statics(POSES, "nan")
    head, *rows = cells_of(statics._repr_html_())
    assert head[:6] == ["x [m]", "y [m]", "z [m]", *(f"torque {i} [N\u00b7m]" for i in (1, 2, 3))]
    assert head[6:] == [f"theta_{axis}_{pulley} [rad]" for pulley in (1, 2) for axis in (1, 2, 3)]
    numbers = np.array([row[3:] for row in rows[:2]], dtype=float)
    np.testing.assert_allclose(numbers[:, :3], statics.torques[:2], rtol=1e-3)
    np.testing.assert_allclose(numbers[:, 3:], statics.rotations[:2], rtol=1e-3)
    assert rows[2][3:] == ["limits"] * 9
    assert cells_of(model.statics(POSES[0])._repr_html_())[1:] == [rows[0]]


def test_a_robot_is_a_table_of_its_values() -> None:
    robot = pkmodes.read_robot("robots/corexy-printer.toml")
    text = robot._repr_html_()
    head, *rows = cells_of(text)
    assert head == ["value", "", "\u03c3", "unit", ""]
    found = {row[0]: row[1:] for row in rows}
    assert found.keys() == robot.quantities.keys()
    assert found["toolhead.mass"][:3] == ["0.5", "0.01", "kg"]
    times = "\u2009\u00d7\u2009"
    assert found["belt.specific_stiffness"][:3] == [f"2.6{times}10\u2076", f"2.6{times}10\u2075", "N/m"]
    assert found["gravity.z"][:3] == ["\u22129.81", "\u2013", "m/s\u00b2"]
    assert "tool head on a gantry" in text
    longer = pkmodes.read_robot("robots/linear-delta-2022.toml")
    assert len(cells_of(longer._repr_html_())) == 21
    assert "18 more values: Robot.quantities" in longer._repr_html_()


def test_a_move_is_a_table_of_its_largest_deviations() -> None:
    model = pkmodes.load("robots/corexy-printer.toml")
    t = np.arange(0.0, 0.2, 0.001)
    x = 0.1 + 0.05 * np.clip(t / 0.05, 0.0, 1.0)
    move = model.simulate(t, np.stack([x, 0.0 * t + 0.1], axis=-1))
    text = move._repr_html_()
    head, along_x, along_y = cells_of(text)
    assert head == ["", "from", "to", "largest deviation [\u00b5m]", "at [s]"]
    assert along_x[:3] == ["x", "0.1 m", "0.15 m"]
    assert along_y[:3] == ["y", "0.1 m", "0.1 m"]
    at = np.argmax(np.abs(move.deviation[:, 0]))
    assert float(along_x[3]) == pytest.approx(1e6 * move.deviation[at, 0], rel=1e-3)
    assert float(along_x[4]) == pytest.approx(move.time[at])
    assert f"Largest distance {1e6 * move.largest():.4g} \u00b5m; 200 times in 0.199 s" in text


def test_shapers_are_a_table_of_what_they_leave() -> None:
    model = pkmodes.load("robots/corexy-printer.toml")
    choice = model.shapers([[0.1, 0.1], [0.2, 0.2]], ["zv", "mzv"])
    head, *rows = cells_of(choice._repr_html_())
    assert head[:5] == ["shaper", "design [Hz]", "lasts [ms]", "rms [%]", "worst [%]"]
    assert len(rows) == len(choice.candidates)
    for row, one in zip(rows, choice.candidates, strict=True):
        assert row[0].removesuffix(" *") == one.kind
        assert row[1] == ("of the pose" if one.follows_pose else f"{one.frequencies[0]:.2f}")
        assert [float(text) for text in row[2:5]] == pytest.approx(
            [1e3 * one.duration, 100 * one.left_at_pose.rms, 100 * one.left_at_pose.worst], abs=0.06
        )
    assert [row[0].endswith(" *") for row in rows].index(True) == choice.recommended


def test_a_comparison_and_a_diagnosis_say_what_was_found(tmp_path: Path) -> None:
    robot = pkmodes.read_robot("robots/linear-delta-2022.toml")
    modes = pkmodes.Model(robot).modes(POSES[:2])
    rows = [
        f"P{i},{','.join(map(str, p))},{f},{0.002 * f}"
        for i, (p, found) in enumerate(zip(POSES, modes.frequencies, strict=False))
        for f in found[3:]
    ]
    measured = tmp_path / "modes.csv"
    measured.write_text("\n".join(["pose,x,y,z,frequency,sigma", *rows]), encoding="utf-8")
    data = updating.read(measured, robot=robot)
    compared = updating.compare(robot, data)._repr_html_()
    assert compared.startswith(
        "<p><strong>The differences are within the measurement errors.</strong> Nothing was"
    )
    assert [row[0] for row in cells_of(compared)[2:]] == ["1", "2", "3", "4", "5", "6"]
    result = updating.diagnose(robot, data, candidates=["payload"])
    said = result._repr_html_()
    assert said.startswith("<p><strong>The model is adequate.</strong> ")
    assert unescape(said).count(result.reason[1:]) == 1
    assert "before: as declared" in said


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
        model.robot._repr_html_(),
        model.statics([0.1, 0.2])._repr_html_(),
        model.simulate([0.0, 0.1], [[0.1, 0.2]] * 2)._repr_html_(),
        next(iter(pictures(model, grid)))._repr_html_(),
        scene(model, [0.1, 0.2])._repr_html_(),
    ):
        assert "<img" not in text
        assert "onerror" in text, "shown as it is"
    assert table.count("</caption>") == 1
