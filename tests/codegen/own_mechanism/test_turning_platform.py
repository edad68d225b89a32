"""The steps of docs/how-to/adding-a-mechanism-that-turns.md, and the planar machine that it builds, by hand."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.commands.answers import printed, refused
from helpers.commands.own_folder import inside
from helpers.pages.documentation import blocks, same
from helpers.references.three_rrr_by_hand import ThreeRRR
from pkmodes.core.mechanism import registry as known

PAGE = "docs/how-to/adding-a-mechanism-that-turns.md"
DEFINITION, ROBOT, COMMANDS, SHOWN = (block.text for block in blocks(PAGE))
GENERATE, CHECK, MODES = (line.split()[1:] for line in COMMANDS.splitlines())
DECLARED = ThreeRRR(
    mass=0.6,
    centre=np.array([4e-3, -7e-3]),
    inertia=1.2e-3,
    gravity=np.array([0.0, -9.81]),
    origins=np.array([[-0.3, -0.173], [0.3, -0.173], [0.0, 0.346]]),
    joints=np.array([[-0.052, -0.03], [0.052, -0.03], [0.0, 0.06]]),
    branches=(1, 1, 1),
    arm_length=0.2,
    arm_mass=0.25,
    link_length=0.22,
    link_mass=0.12,
    stiffness=900.0,
    motor=0.02,
)
POSE = np.array([0.02, -0.01, np.radians(5.0)])
FAR = np.array([-0.03, 0.02, np.radians(-12.0)])


@pytest.fixture(scope="module")
def place(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    folder = tmp_path_factory.mktemp("turning")
    (folder / "three_rrr.py").write_text(DEFINITION, encoding="utf-8")
    (folder / "robot.toml").write_text(ROBOT, encoding="utf-8")
    with inside(folder):
        printed(*GENERATE)
        yield folder


@pytest.fixture
def model(place: Path) -> pkmodes.Model:
    known.add_folder(place / "build" / "three_rrr")
    return pkmodes.load(place / "robot.toml")


def test_the_page_is_short() -> None:
    text = (Path(__file__).parents[3] / PAGE).read_text(encoding="utf-8")
    assert len(text.splitlines()) <= 150


@pytest.mark.slow  # with the fixture
def test_the_commands_print_what_the_page_shows(place: Path) -> None:
    same(SHOWN, printed(*MODES), fit=True, shortened=True)
    assert printed(*CHECK).count(": current\n") == 1


def test_matrices_agree_with_positions_by_hand(model: pkmodes.Model) -> None:
    other = model.with_values(
        {
            "gravity": [3.0, -8.0, 1.0],
            "frame.mass": 12.0,
            "effects.payload.mass": 0.3,
            "effects.payload.offset_x": 0.03,
            "effects.payload.offset_y": -0.05,
            "effects.link_compliance.compliance": 2e-6,
            "effects.frame_compliance.compliance": 1e-6,
        }
    )
    by_hand = replace(
        DECLARED,
        gravity=np.array([3.0, -8.0]),
        frame_mass=12.0,
        payload=0.3,
        offset=np.array([0.03, -0.05]),
        link_compliance=2e-6,
        frame_compliance=1e-6,
    )
    for evaluated, expected, size in ((model, DECLARED, 6), (other, by_hand, 11)):
        for pose in (POSE, FAR):
            for found, wanted in zip(evaluated.matrices(pose), expected.matrices(pose), strict=True):
                part = wanted[:size, :size]
                scale = np.sqrt(np.outer(np.diag(part), np.diag(part)))
                np.testing.assert_allclose(found / scale, part / scale, rtol=0.0, atol=1e-8)
            at = np.concatenate([pose, np.zeros(5)])
            torques = evaluated.statics(pose).torques
            np.testing.assert_allclose(torques, expected.forces(at)[:3], atol=1e-8)


def test_gravity_in_the_plane_is_seen_in_the_stiffness(model: pkmodes.Model) -> None:
    """The comparison above tells K with gravity from K without: its share is far above the tolerance."""
    level = model.with_values({"gravity": [0.0, 0.0, -9.81]})
    _, K = model.matrices(POSE)
    _, without = level.matrices(POSE)
    assert np.abs(K - without).max() > 1e-4 * np.abs(K).max()


def test_the_platform_is_drawn_between_its_joints(model: pkmodes.Model, place: Path) -> None:
    drawn = json.loads((place / "build/three_rrr/description.json").read_text())["drawing"]["elements"]
    assert [one["name"] for one in drawn] == [
        *(f"{part} {j}" for j in (1, 2, 3) for part in ("arm", "link")),
        "centre of mass of the platform",
        "platform",
    ]
    assert (drawn[-1]["shape"], len(drawn[-1]["points"])) == ("plate", 3)
    assert model.characteristic_length == pytest.approx(np.sqrt((DECLARED.joints**2).sum() / 3), rel=1e-12)


MISTAKES = {
    "no rotations": (
        'ROTATIONS = ("z",)\n',
        "",
        r'the platform does not turn: the file has no ROTATIONS \(three_rrr.py:\d+\); .*ROTATIONS = \("z",\)',
    ),
    "no such axis": ('ROTATIONS = ("z",)', 'ROTATIONS = ("rz",)', r"ROTATIONS does not list axes .*'rz'"),
    "a string": ('ROTATIONS = ("z",)', 'ROTATIONS = ("z")', r"ROTATIONS does not list axes .* found 'z'"),
    "two axes": ('ROTATIONS = ("z",)', 'ROTATIONS = ("x", "z")', r"two axes, x and z: together they also"),
    "out of the plane": (
        'ROTATIONS = ("z",)',
        'ROTATIONS = ("x",)',
        r"the platform turns about x, but DIRECTIONS lacks z",
    ),
    "no lever": (
        "theta[j], lever[j])",
        "theta[j])",
        r"a link to a platform that turns has no lever \(three_rrr.py: m.link, link 1\); name its joint",
    ),
    "a lever in platform axes": (
        "theta[j], lever[j])",
        "theta[j], b[j])",
        r"the lever of a link is not a vector that is fixed in the platform .*link 1\); give the names",
    ),
    "the lever of another": (
        "theta[j], lever[j])",
        "theta[j], lever[0])",
        r"the vector of a link does not turn with its lever \(three_rrr.py: m.link, link 2\)",
    ),
    "three moments of inertia": (
        "m.body(m_p, c_p, I_p)",
        "m.body(m_p, c_p, (*I_p, *I_p, *I_p))",
        r"a body has 3 moments and 0 products of inertia \(three_rrr.py:\d+\); give one moment, I_zz",
    ),
    "a product of inertia": (
        "m.body(m_p, c_p, I_p)",
        "m.body(m_p, c_p, I_p, I_p)",
        r"a body has 1 moments and 1 products",
    ),
    "a centre in space": (
        "m.body(m_p, c_p, I_p)",
        "m.body(m_p, (*c_p, 0), I_p)",
        r"fixed in the platform has 3 components, expected 2 \(three_rrr.py:\d+\); give one for each of x, y",
    ),
    "two bodies": (
        "m.body(m_p, c_p, I_p)",
        "m.body(m_p, c_p, I_p); m.body(m_p, c_p, I_p)",
        r"the platform has a body already .*give m.body the mass, centre and inertia of both together",
    ),
    "before the pose": (
        '    p = m.platform_pose("p", "platform\'s origin in the base frame", "p")\n',
        '    m.body(m_p, c_p, I_p)\n    p = m.platform_pose("p", "platform\'s origin in the base frame", "p")\n',
        r"fixed in the platform before the pose is declared .*call m.platform_pose\(...\) first",
    ),
}


@pytest.mark.parametrize("what", MISTAKES)
def test_a_mistake_is_named_with_its_place(
    what: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    right, wrong, message = MISTAKES[what]
    assert right in DEFINITION
    (tmp_path / "three_rrr.py").write_text(DEFINITION.replace(right, wrong), encoding="utf-8")
    (tmp_path / "robot.toml").write_text(ROBOT, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    assert re.search(message, error := refused(*GENERATE)), error
    assert not (tmp_path / "build").exists()
