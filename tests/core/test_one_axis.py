"""A mechanism with one pose component, as a user writes it: a carriage on one belt, through every command."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.pages.page_reading import read
from pkmodes.cli import run
from pkmodes.core.mechanism import registry as mechanism
from pkmodes.pages.view import poses_around

pytestmark = pytest.mark.usefixtures("slide")
DEFINITION = r'''"""A carriage on one belt with a motor pulley."""

from pkmodes_derive.description import Margin
from pkmodes_derive.functions import Output
from pkmodes_derive.machine import Extra
from pkmodes_derive.parts import Clamp, PointMass, Run

TITLE = "a carriage on one belt"
DIRECTIONS = ("x",)


def declare(m):
    """Declare the slide."""
    (m_c,) = m.tables.single("carriage", "the carriage").quantity("mass", "m_c", "mass", "mass", above=0)
    m.add_gravity()
    axis = m.tables.repeated("axis", 1, "the belt")
    belt = axis.shared("belt", "one timing belt")
    what = "specific stiffness"
    (k_sp,) = belt.quantity("specific_stiffness", "k_sp", what, what, latex="k_{{sp,{j}}}", above=0)
    (w_b,) = belt.quantity("width", "w_b", "length", "width", latex="w_{{b,{j}}}", above=0)
    (l_t,) = belt.quantity("length", "l_t", "length", "distance of the pulleys", latex="l_{{t,{j}}}", above=0)
    pulley = axis.shared("pulley", "the motor pulley")
    (R_p,) = pulley.quantity("radius", "R_p", "length", "radius", latex="R_{{p,{j}}}", above=0)
    what = "moment of inertia"
    (I_p,) = pulley.quantity("inertia", "I_p", what, what, latex="I_{{p,{j}}}", above=0)
    low, high = m.tables.single("workspace", "travel").ranges(("x",), "travel", "the travel along {i}", "{i}")
    m.add_frame()
    m.generalised(
        [("x", "m", "position of the carriage", "{x}", {})],
        [("theta_{j}", "rad", "rotation of pulley {j}", r"{{\vartheta}}_{j}", {"j": 1})],
    )
    x, theta = m.coordinates
    m.independent_pose((x,), "carriage in the base frame")
    m.moves_platform((x,), "xx", "positions")
    m.platform = (x, 0, 0)
    m.points.append(PointMass(m_c, m.platform))
    new = m.vocabulary.declare
    l_f = [new("l_{j}_{s}", "m", "length of run {s}", "l_{{{j},{s}}}", j=1, s=s) for s in (1, 2)]
    k = [new("k_{j}_{s}", "N/m", "stiffness of run {s}", "k_{{{j},{s}}}", j=1, s=s) for s in (1, 2)]
    (tau,) = m.each("tau_st", "N m", "static torque on pulley {j}", r"\tau_{{st,{j}}}")
    clamp = Clamp()
    slide, rim = ({x: 1}, clamp), ({theta: R_p}, None)
    runs = [Run(l_f[0], k[0], l_t - x, (slide, rim)), Run(l_f[1], k[1], x, (rim, slide))]
    m.belt(w_b * k_sp, runs, clamp)
    m.drive([(m.rotor(theta, 0), 1)], I_p, tau, winds_up=False)
    m.follows[theta] = x / R_p
    res = Output("margin", (1, 2), (x - low[0], high[0] - x), "m", "at least zero")
    m.extras.append(Extra("travel_margin", "Margin of travel.", "the travel", (res,)))
    out, ends = "the pose is out of travel", (("x",), ("lower end", "upper end"))
    miss = f"{out}: {{0}} {{1}} by {{missing}}"
    m.margins = (Margin("reachable", "travel_margin", 0, "at_least_zero", out, miss, "come nearer", ends),)
    m.sample = {
        "carriage_mass": 0.2, "gravity": [0.3, -9.7, 0.4], "belt_specific_stiffness": [1e6],
        "belt_width": [0.01], "belt_length": [1.0], "pulley_radius": [0.01], "pulley_inertia": [1e-5],
        "workspace": [[0.1, 0.8]],
    }  # fmt: skip
'''
ROBOT = """\
format = 1
name = "slide"
mechanism = "slide"
gravity = [0.0, 0.0, -9.81]
[carriage]
mass = "0.5 kg"
[belt]
specific_stiffness = "1e6 N/m"
width = "10 mm"
length = "1 m"
[pulley]
radius = "10 mm"
inertia = "1e-5 kg*m^2"
[[axis]]
[workspace]
x = ["100 mm", "800 mm"]
"""
POSE = 0.3


def frequency(x: float) -> float:
    """By hand: carriage and pulley, 0.5 kg and 0.1 kg at the rim, on runs of 10 kN each per metre of length."""
    return float(np.sqrt(1e4 * (1.0 / x + 1.0 / (1.0 - x)) * (1.0 / 0.5 + 1.0 / 0.1)) / (2.0 * np.pi))


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("slide")
    (folder / "slide.py").write_text(DEFINITION, encoding="utf-8")
    (folder / "robot.toml").write_text(ROBOT, encoding="utf-8")
    options = ["--mechanism", str(folder / "slide.py"), "--out", str(folder / "generated")]
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(mechanism, "_package_by_name", {})
        assert run(["generate", str(folder / "robot.toml"), *options]) == 0
    return folder


@pytest.fixture
def slide(made: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(mechanism, "_package_by_name", {})
    monkeypatch.setenv("PKMODES_BACKEND", "numpy")  # it is not compiled for this test
    monkeypatch.chdir(made)


MECHANISM = ["robot.toml", "--mechanism", "generated/slide"]


def test_its_frequency_is_that_of_two_masses_on_a_spring(tmp_path: Path) -> None:
    out = tmp_path / "modes.json"
    assert run(["modes", *MECHANISM, "--pose", str(POSE), "--json", str(out)]) == 0
    assert json.loads(out.read_text())["frequencies_hz"][1] == pytest.approx(frequency(POSE), rel=1e-12)


def test_its_map_is_a_line_and_the_report_draws_it(tmp_path: Path) -> None:
    out, page = tmp_path / "map.json", tmp_path / "map.html"
    assert run(["map", *MECHANISM, "--json", str(out), "--report", str(page)]) == 0
    content = json.loads(out.read_text())
    assert content["poses"] <= 1500
    low, high = content["ranges"]["x"]
    assert 0.1 < low < 0.105
    assert 0.795 < high < 0.8
    (mode,) = content["modes"]
    assert mode["minimum_hz"] == pytest.approx(frequency(0.5), rel=1e-9)
    assert mode["minimum_at"]["x"] == pytest.approx(0.5, abs=1e-9)
    assert mode["maximum_hz"] == pytest.approx(frequency(low), rel=1e-9)
    found = read(page.read_text(encoding="utf-8"))
    assert "mode 1" in found.by_id("line").text
    assert 'id="figures"' not in page.read_text(encoding="utf-8")


def test_figures_say_that_they_need_a_plane(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    assert run(["figures", *MECHANISM, "--out", str(tmp_path / "figures")]) == 2
    assert "the figures need two components of the pose, slide has only x" in capsys.readouterr().err
    assert not (tmp_path / "figures").exists()


def test_a_view_of_a_single_point_is_as_large_as_its_way(tmp_path: Path) -> None:
    assert run(["show", *MECHANISM, "--out", str(tmp_path / "slide.html")]) == 0
    shown = poses_around(pkmodes.load("robot.toml"), [POSE])
    assert shown.size == pytest.approx(np.ptp(shown.poses[:, 0]))
    assert 0.6 < shown.size < 0.7
