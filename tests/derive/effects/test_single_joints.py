"""Compliances of single joints and values of single axes, candidates outside the catalogue, against the test rig."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.diagnoses.robot_structures import declared, index, suspected
from helpers.robots.robot_text import PUBLISHED, edited
from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.robot.units import Quantity
from pkmodes.loop.sensitivity.paths import change_quantities, resolve
from pkmodes.loop.updating.candidates import suspects
from pkmodes.loop.updating.robot_structure import RobotStructure
from pkmodes_rig.engine import true_modes
from pkmodes_rig.robots import POSES, ROBOTS, read

JOINT = "gearbox_compliance.compliance.psi_2"
#: Wind-up per torque that changes some frequency by a few per cent.
COMPLIANCE = {"published": 1e-3, "tower": 0.2, "asymmetric": 4e-3}


def structure(robot: str) -> RobotStructure:
    return suspected(read(robot), np.array(POSES[robot]["scattered"][:3]))


@pytest.mark.parametrize("robot", ROBOTS)
@pytest.mark.parametrize("beside", [0.0, 0.5])
def test_one_soft_gearbox_is_that_of_the_engine(robot: str, beside: float) -> None:
    c = COMPLIANCE[robot]
    everywhere = {"gearbox_compliance.compliance": beside * c} if beside else {}
    for p in POSES[robot]["grid"][:3]:
        model = pkmodes.Model(replace(read(robot), effects={**everywhere, JOINT: c}))
        expected = true_modes(read(robot).parameters, p, everywhere, {"one_gearbox": c})
        found = model.modes(p)
        assert model.coordinates[9:] == (("psi_1", "psi_2", "psi_3") if beside else ("psi_2",))
        # The first three are rigid: near zero, only rounding.
        np.testing.assert_allclose(found.frequencies[..., 3:].ravel(), expected.frequencies[3:], rtol=1e-9)


@pytest.mark.parametrize("robot", ROBOTS)
@pytest.mark.parametrize("share", [0.0, 1.0])
def test_its_derivatives_are_differences_of_the_engine(robot: str, share: float) -> None:
    at, name = structure(robot), f"effects.{JOINT}"
    c = share * COMPLIANCE[robot]
    prediction = at.predict(declared(at, {name: c}), [index(at, name)])
    step = 1e-3 * COMPLIANCE[robot]
    for setup, p in enumerate(at.points):

        def engine(compliance: float, p: np.ndarray = p) -> np.ndarray:
            found = true_modes(read(robot).parameters, p, {}, {"one_gearbox": compliance})
            return (2 * np.pi * found.frequencies[3:9]) ** 2

        # Of second order, and one-sided at zero, the lower bound.
        if share:
            rate = (engine(c + step) - engine(c - step)) / (2 * step)
        else:
            rate = (-3 * engine(0.0) + 4 * engine(step) - engine(2 * step)) / (2 * step)
        found = prediction.rates[setup, 3:9, 0]
        assert np.abs(found - rate).max() < 2e-3 * np.abs(found).max()


@pytest.mark.parametrize("robot", ROBOTS)
def test_the_compliance_of_all_joints_counts_free_and_locked_ones(robot: str) -> None:
    """Gearbox 2 is already compliant, the others are rigid: both respond to the compliance of all."""
    at, c = structure(robot), COMPLIANCE[robot]
    values = declared(at, {f"effects.{JOINT}": c})
    prediction = at.predict(values, [index(at, "effects.gearbox_compliance.compliance")])
    step = 1e-3 * c
    for setup, p in enumerate(at.points):

        def engine(compliance: float, p: np.ndarray = p) -> np.ndarray:
            everywhere = {"gearbox_compliance.compliance": compliance}
            found = true_modes(read(robot).parameters, p, everywhere, {"one_gearbox": c})
            return (2 * np.pi * found.frequencies[3:9]) ** 2

        rate = (-3 * engine(0.0) + 4 * engine(step) - engine(2 * step)) / (2 * step)
        found = prediction.rates[setup, 3:9, 0]
        assert np.abs(found - rate).max() < 2e-3 * np.abs(found).max()
        model = pkmodes.Model(replace(read(robot), effects={JOINT: c}))
        whole = model.sensitivities(p, ["effects.gearbox_compliance.compliance"])
        np.testing.assert_allclose(np.ravel(whole.eigenvalues)[3:9], found, rtol=1e-9)


def test_a_single_direction_of_the_frame_takes_its_mass_from_the_file() -> None:
    robot = read("asymmetric")
    at = structure("asymmetric")
    values = declared(at, {"effects.frame_compliance.compliance.u_y": 2e-8})
    mass = robot.constants["frame_compliance.mass"]
    frequencies = np.exp(at.predict(values, ()).log_frequencies)
    # Frequency of the frame alone on its spring; the mass of the robot lowers it.
    alone = np.sqrt(1 / (2e-8 * mass)) / (2 * np.pi)
    assert ((frequencies > 0.5 * alone) & (frequencies < alone)).any(axis=1).all()


def test_they_are_remote_and_joints_have_no_name_to_be_claimed_by() -> None:
    robot = pkmodes.read_robot(PUBLISHED)
    _, candidates, _ = suspects(robot)
    remote = {c.name: c for c in candidates if c.remote}
    joints = {name for name, c in remote.items() if not c.nameable}
    assert joints == {
        *(f"gearbox_compliance of psi_{j} alone" for j in (1, 2, 3)),
        *(f"link_compliance of delta_{j} alone" for j in (1, 2, 3)),
        *(f"clamp_compliance of eps_{j} alone" for j in (1, 2, 3)),
        "frame_compliance with another frame.mass",
        *(f"frame_compliance.compliance_{i} with another frame.mass" for i in "xyz"),
    }
    assert {f"frame_compliance.compliance_{i}" for i in "xyz"} < {c.name for c in candidates if c.claimable}
    assert "parameter:axis.2.carriage.mass" in remote.keys() - joints
    assert not any(c.remote for c in suspects(robot, ["effects", "parameters"])[1] if c.nameable)
    assert suspects(robot, [])[1] == []
    with pytest.raises(PkmodesError):
        resolve(robot, f"effects.{JOINT}")


def test_what_is_known_exactly_is_known_of_every_axis(tmp_path: Path) -> None:
    known = tmp_path / "robot.toml"
    known.write_text(edited('mass = "1 kg"', 'mass = { value = "1 kg", sigma = "0 kg" }'), encoding="utf-8")
    before, after = ({c.name for c in suspects(pkmodes.read_robot(path))[1]} for path in (PUBLISHED, known))
    assert after < before
    assert before - after == {
        "parameter:carriage.mass",
        *(f"parameter:axis.{j}.carriage.mass" for j in (1, 2, 3)),
    }


def test_a_shared_value_with_a_sigma_is_refitted_for_all_axes_and_not_suspected_of_one(
    tmp_path: Path,
) -> None:
    """Otherwise both would change the axis, and its value in a file would be ambiguous."""
    robot = read("published")
    assert robot.quantities["motor.inertia"].sigma
    assert not any("motor.inertia" in c.name for c in suspects(robot)[1])
    with pytest.raises(PkmodesError, match=r"motor.inertia is refitted for all together.*to suspect axis\.2"):
        suspects(robot, ["parameter:axis.2.motor.inertia"])


def test_one_axis_that_alone_follows_a_shared_value_is_not_suspected_twice() -> None:
    robot = read("asymmetric")
    own = {path for path in robot.quantities if path.startswith("axis.") and path.endswith("carriage.mass")}
    assert own == {"axis.3.carriage.mass"}
    names = {c.name for c in suspects(robot)[1] if c.remote}
    assert {"parameter:axis.1.carriage.mass", "parameter:axis.2.carriage.mass"} < names
    alone = replace(robot, quantities={**robot.quantities, "axis.2.carriage.mass": Quantity(1.0, "kg")})
    assert "parameter:axis.1.carriage.mass" not in {c.name for c in suspects(alone)[1]}


def test_joints_of_an_effect_that_is_known_exactly_are_none_to_look_at(tmp_path: Path) -> None:
    known = tmp_path / "robot.toml"
    effect = '[effects.gearbox_compliance]\ncompliance = {value = "1e-4 rad/(N*m)", sigma = "0 rad/(N*m)"}\n'
    known.write_text(PUBLISHED.read_text(encoding="utf-8") + "\n" + effect, encoding="utf-8")
    names = {c.name for c in suspects(pkmodes.read_robot(known))[1]}
    assert not any("gearbox_compliance" in name for name in names)
    assert "link_compliance of delta_1 alone" in names


def test_moving_one_axis_leaves_the_others() -> None:
    robot = pkmodes.read_robot(PUBLISHED)
    path = resolve(robot, "axis.2.carriage.mass")
    masses = (
        change_quantities(robot, [(path, 0.25)]).parameters.carriage_mass - robot.parameters.carriage_mass
    )
    np.testing.assert_array_equal(masses, [0.0, 0.25, 0.0])
