"""Wrong robot files of hexapods and hexaglides, and poses that they cannot take: each is named with its place."""

from __future__ import annotations

from collections.abc import Callable
from copy import deepcopy
from typing import Any

import numpy as np
import pytest

import pkmodes
from helpers.references.six_legs_by_hand import orthogonal, vertical
from helpers.robots.six_legged import Machine, hexaglide, hexapod, rotation, toml_text
from pkmodes.core.base.errors import PkmodesError, PoseError

DRAWN = {"hexapod": hexapod(3), "hexaglide": hexaglide(3)}


def _coincident(machine: Machine) -> None:
    machine["axis"][4] = deepcopy(machine["axis"][1])


def _crossed(machine: Machine) -> None:
    """Two legs whose joints on the platform are exchanged: they meet at two fifths of their lengths."""
    first, second = machine["axis"][1], machine["axis"][4]
    step = np.array([0.03, -0.02, 0.011])
    second["base"] = (np.array(first["base"]) + 2.0 * step).tolist()
    second["joint"] = (np.array(first["joint"]) - 3.0 * step).tolist()


def _same_line(machine: Machine) -> None:
    """The same rail with another origin along it: the same rod."""
    first = machine["axis"][1]
    along = 0.05 * np.array(first["direction"])
    machine["axis"][4] = {**deepcopy(first), "origin": (np.array(first["origin"]) + along).tolist()}


def _in_line(key: str) -> Callable[[Machine], None]:
    def change(machine: Machine) -> None:
        for place, axis in enumerate(machine["axis"]):
            axis[key] = (np.array([0.1, -0.2, 0.05]) + (place - 2.2) * np.array([0.03, 0.02, -0.01])).tolist()

    return change


def _five(machine: Machine) -> None:
    machine["axis"].pop()


def _no_body(machine: Machine) -> None:
    machine["platform"]["inertia"] = [0.01, 0.02, 0.031]
    machine["platform"].pop("products", None)


def _no_body_when_turned(machine: Machine) -> None:
    R = rotation([0.4, -0.3, 0.7])
    _tensor(machine, R @ np.diag([0.01, 0.02, 0.031]) @ R.T)


def _tensor(machine: Machine, tensor: np.ndarray) -> None:
    machine["platform"]["inertia"] = np.diag(tensor).tolist()
    machine["platform"]["products"] = [tensor[0, 1], tensor[0, 2], tensor[1, 2]]


BODY = "expected the inertia of a body, found one in which about some axes a moment exceeds the sum of the others"
MISTAKES: dict[str, tuple[str, Callable[[Machine], None], tuple[str, ...]]] = {
    "two legs": (
        "hexapod",
        _coincident,
        ("axis.2 and axis.5", "expected legs that differ, found two that coincide", "check base and joint"),
    ),
    "crossed legs": (
        "hexapod",
        _crossed,
        ("axis.2 and axis.5", "expected legs that do not cross, found two that meet", "may be exchanged"),
    ),
    "two rods": (
        "hexaglide",
        _coincident,
        ("axis.2 and axis.5", "expected rods that differ", "branch of both"),
    ),
    "two rods on a rail": ("hexaglide", _same_line, ("axis.2 and axis.5", "found two that coincide")),
    "platform joints": (
        "hexapod",
        _in_line("joint"),
        ("axis.joint", "expected joints on the platform that do not lie in one line", "check joint of every"),
    ),
    "base joints": (
        "hexapod",
        _in_line("base"),
        ("axis.base", "joints on the base", "check base of every axis"),
    ),
    "platform joints of rods": ("hexaglide", _in_line("joint"), ("axis.joint", "found all of them in one")),
    "five": ("hexapod", _five, ("expected exactly six [[axis]] tables, found 5", ": axis)")),
    "inertia": ("hexapod", _no_body, ("platform.inertia.z", BODY, "it is about the centre of mass")),
    "inertia about other axes": ("hexaglide", _no_body_when_turned, ("platform.products", BODY)),
}


@pytest.mark.parametrize("what", MISTAKES)
def test_a_wrong_robot_is_refused_with_its_place(what: str, tmp_path: Any) -> None:
    name, change, words = MISTAKES[what]
    machine = deepcopy(DRAWN[name].machine)
    change(machine)
    (tmp_path / "robot.toml").write_text(toml_text(machine), encoding="utf-8")
    with pytest.raises(PkmodesError) as caught:
        pkmodes.load(tmp_path / "robot.toml")
    for word in ("robot.toml", *words):
        assert word in str(caught.value)


@pytest.mark.parametrize("apart", [0.0, 2e-3, -2e-3])
def test_legs_that_meet_are_told_from_legs_that_pass_each_other(apart: float, tmp_path: Any) -> None:
    """Two legs that meet at one position of the platform meet at any, by the distance of the two lines.

    A base joint is moved aside by a part of the distance of the two base joints.
    """
    machine = deepcopy(DRAWN["hexapod"].machine)
    _crossed(machine)
    base = np.array([axis["base"] for axis in machine["axis"]])
    aside = np.cross(base[4] - base[1], [0.0, 0.0, 1.0])
    machine["axis"][4]["base"] = (base[4] + apart * aside).tolist()
    for position in ([0.0, 0.0, 0.4], [0.05, -0.1, 0.3]):
        feet, tops = (np.array([machine["axis"][j][key] for j in (1, 4)]) for key in ("base", "joint"))
        first, second = tops + position - feet
        normal = np.cross(first, second)
        distance = (feet[1] - feet[0]) @ normal / np.linalg.norm(normal)
        assert (abs(distance) > 1e-9) == (apart != 0.0)
    (tmp_path / "robot.toml").write_text(toml_text(machine), encoding="utf-8")
    if apart:
        pkmodes.load(tmp_path / "robot.toml")
        return
    with pytest.raises(PkmodesError, match="found two that meet whenever the platform is not turned"):
        pkmodes.load(tmp_path / "robot.toml")


def test_legs_may_share_a_joint(tmp_path: Any) -> None:
    """Stewart's platform and the octahedral hexapods have joints for two legs."""
    machine = deepcopy(DRAWN["hexapod"].machine)
    machine["axis"][4]["joint"] = machine["axis"][1]["joint"]
    machine["axis"][3]["base"] = machine["axis"][2]["base"]
    (tmp_path / "robot.toml").write_text(toml_text(machine), encoding="utf-8")
    pkmodes.load(tmp_path / "robot.toml")


@pytest.mark.parametrize("seed", range(3))
def test_a_thin_plate_is_a_body(seed: int, tmp_path: Any) -> None:
    """I_zz = I_xx + I_yy exactly, seen from any axes; one part in a million more is none."""
    machine = deepcopy(DRAWN["hexapod"].machine)
    R = rotation(np.random.default_rng(seed).normal(size=3)) if seed else np.eye(3)
    for third, right in ((0.03, True), (0.03 * (1 + 1e-6), False)):
        _tensor(machine, R @ np.diag([0.01, 0.02, third]) @ R.T)
        (tmp_path / "robot.toml").write_text(toml_text(machine), encoding="utf-8")
        if right:
            pkmodes.load(tmp_path / "robot.toml")
        else:
            with pytest.raises(PkmodesError, match="expected the inertia of a body"):
                pkmodes.load(tmp_path / "robot.toml")


def test_legs_that_depend_on_each_other_are_named(tmp_path: Any) -> None:
    """Six vertical legs hold three motions; of six, four that are parallel in one plane hold two."""
    case, _ = vertical()
    (tmp_path / "robot.toml").write_text(toml_text(case.machine), encoding="utf-8")
    with pytest.raises(PoseError, match=r"rows 1, 2, 3, 4, 5 and 6, one for each leg, depend on each"):
        pkmodes.load(tmp_path / "robot.toml").modes(case.pose)
    machine = deepcopy(case.machine)
    joints = [[0.1, 0, 0], [0.05, 0, 0], [-0.02, 0, 0], [0.1, 0.1, 0], [-0.1, 0.1, 0], [0.0, -0.1, 0]]
    feet = [[0, 0, 0], [0, 0, 0], [0, 0, 0], [0.3, 0, 0], [0, 0.4, 0], [-0.2, -0.5, 0]]
    for axis, joint, foot in zip(machine["axis"], joints, feet, strict=True):
        axis["joint"], axis["base"] = joint, (np.array(joint) + foot).tolist()
    (tmp_path / "robot.toml").write_text(toml_text(machine), encoding="utf-8")
    with pytest.raises(PoseError, match=r"condition number of D_l is .*; its rows 1, 2 and 3, one for"):
        pkmodes.load(tmp_path / "robot.toml").modes(case.pose)


def test_poses_beyond_limits_are_named(tmp_path: Any) -> None:
    case, _ = orthogonal(weight=False)
    machine = deepcopy(case.machine)
    (tmp_path / "robot.toml").write_text(toml_text(machine), encoding="utf-8")
    model = pkmodes.load(tmp_path / "robot.toml")
    with pytest.raises(PoseError, match=r"turned by 90 degrees or more, 0\.0292 rad too far"):
        model.modes([0.02, -0.03, 0.4, 0.0, 1.6, 0.0])
    machine["axis"][4]["limits"] = [0.51, 0.7]
    (tmp_path / "robot.toml").write_text(toml_text(machine), encoding="utf-8")
    with pytest.raises(
        PoseError, match=r"leg 5 is outside its limits: its length misses the least length by 0\.01 m"
    ):
        pkmodes.load(tmp_path / "robot.toml").modes(case.pose)
