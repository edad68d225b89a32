"""Machines with faults at places: each form against the other rigs, matrices written by hand, or a closed form."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from pkmodes_rig.mujoco_engine import carriage_positions
from pkmodes_rig.mujoco_rotary_delta import arm_angles
from pkmodes_rig.one_place import Fault, assembled, modes_of
from pkmodes_rig.one_place.faults import same_term
from studies.specimens import MACHINES, ROBOTS, read_robot, robot_of

RIGID = 1e-3  # Hz, of a mode that strains nothing


def frequencies(machine: str, *faults: Fault, values: Mapping[str, Any] | None = None) -> np.ndarray:
    robot, p = robot_of(machine), MACHINES[machine].points[1]
    q = robot.parameters._replace(**values or {})
    return modes_of(robot.mechanism_name, q, p, faults).frequencies


def expected(
    machine: str,
    effects: Mapping[str, float] | None = None,
    outside: Mapping[str, float] | None = None,
    **values: Any,
) -> np.ndarray:
    """The same machine on the rig of the other suites."""
    robot, p = robot_of(machine), MACHINES[machine].points[1]
    rig = MACHINES[machine].rig
    settings = {**robot.constants, **(effects or {})}
    return np.asarray(rig(robot.parameters._replace(**values), p, settings, outside or {}).frequencies)


def agree(one: np.ndarray, other: np.ndarray, within: float = 1e-9) -> bool:
    assert one.shape == other.shape
    return np.allclose(one, other, rtol=within, atol=RIGID)


def at(machine: str, name: str, place: int, change: float) -> dict[str, np.ndarray]:
    """A value of one axis that is larger by a change."""
    value = np.array(getattr(robot_of(machine).parameters, name), dtype=float)
    value[place] += change
    return {name: value}


@pytest.mark.parametrize("machine", MACHINES)
def test_a_machine_without_faults_is_that_of_the_other_rigs(machine: str) -> None:
    assert agree(frequencies(machine), expected(machine))


@pytest.mark.parametrize("machine", MACHINES)
def test_a_mass_on_the_platform_is_a_payload_and_a_spring_at_it_a_cable(machine: str) -> None:
    mass, spring = Fault("mass", ("platform",), values={"mass": 0.3}), {"stiffness": 2e4}
    assert agree(frequencies(machine, mass), expected(machine, {"payload.mass": 0.3}))
    held = frequencies(machine, Fault("spring", ("platform",), values=spring))
    assert agree(held, expected(machine, {"cable_stiffness.stiffness": 2e4}))


@pytest.mark.parametrize(
    ("machine", "place", "name", "index", "factor"),
    [
        ("asymmetric", "carriage_2", "carriage_mass", 1, 1.0),
        ("asymmetric", "link_3", "link_mass", 2, 1.0),
        ("rotary_delta", "link_1", "link_mass", 0, 1.0),
        ("hexaglide", "link_4", "link_mass", 3, 1.0),
        ("hexapod", "leg_2", "leg_base_mass", 1, 1.0),
        ("hexapod", "rod_5", "leg_rod_mass", 4, 1.0),
        ("rotary_delta", "arm_3", "arm_inertia", 2, 1.0),
        ("rotary_delta", "motor_3", "motor_inertia", 2, 33.0**2),
        ("asymmetric", "pulley_2_2", "motor_inertia", 1, 3.0**2),
        ("corexy", "pulley_2", "motor_inertia", 1, 1.0),
        ("corexy", "gantry", "gantry_mass", (), 1.0),
    ],
)
def test_more_of_a_body_is_a_larger_declared_value(
    machine: str, place: str, name: str, index: Any, factor: float
) -> None:
    change = 0.3 * float(np.asarray(getattr(robot_of(machine).parameters, name), dtype=float)[index])
    amount = {"inertia" if "inertia" in name else "mass": change * factor}
    heavier = expected(machine, None, None, **at(machine, name, index, change))
    assert not agree(heavier, expected(machine), 1e-5)
    assert agree(frequencies(machine, Fault("mass", (place,), values=amount)), heavier)


def test_a_spring_between_two_bodies_pulls_each_as_much_as_the_other() -> None:
    robot, p = robot_of("published"), MACHINES["published"].points[1]
    fault = Fault("spring", ("pulley_2_1", "pulley_2_2"), values={"stiffness": 64.5})
    without, with_spring = (modes_of("linear_delta", robot.parameters, p, some) for some in ((), (fault,)))
    names = list(without.coordinates)
    pair = [names.index(name) for name in ("theta_2_1", "theta_2_2")]
    added = np.zeros((9, 9))
    added[np.ix_(pair, pair)] = 64.5 * np.array([[1, -1], [-1, 1]])
    assert np.allclose(with_spring.stiffness_matrix - without.stiffness_matrix, added, rtol=0, atol=1e-6)
    assert np.array_equal(with_spring.mass_matrix, without.mass_matrix)


@pytest.mark.parametrize(
    ("machine", "place", "outside"),
    [
        ("published", ("carriage_1", "carriage_2"), "hose"),
        ("rotary_delta", ("arm_1",), "arm_hose"),
        ("rotary_delta", ("motor_1",), "one_servo"),
        ("corexy", ("pulley_1",), "one_servo"),
        ("hexaglide", ("carriage_1",), "leg_hose"),
    ],
)
def test_springs_of_the_other_rigs(machine: str, place: tuple[str, ...], outside: str) -> None:
    fault = Fault("spring", place, values={"stiffness": 700.0})
    assert agree(frequencies(machine, fault), expected(machine, None, {outside: 700.0}))


def test_springs_at_a_link_and_along_a_direction_act_where_it_moves() -> None:
    robot, p = robot_of("hexaglide"), MACHINES["hexaglide"].points[1]
    machine = assembled("hexaglide", robot.parameters, p)
    ends = machine.rows.platform + np.cross(machine.rows.turning.T, machine_joint(robot, p, 1)).T
    carriage = np.outer(robot.parameters.direction[1], machine.rows.row(x_2=1.0))
    frame = np.array([machine.rows.row(**{f"u_{i}": 1.0}) for i in "xyz"])
    middle = (carriage + frame + ends) / 2
    assert np.allclose([machine.places["link_2"].rows[i] for i in "xyz"], middle, rtol=0, atol=1e-12)
    assert np.allclose(machine.places["platform"].rows["ry"], machine.rows.turning[1])


def test_a_spring_from_the_platform_to_a_carriage_is_strained_by_both() -> None:
    robot, p = robot_of("asymmetric"), MACHINES["asymmetric"].points[1]
    fault = Fault("spring", ("platform", "carriage_2"), "x", {"stiffness": 2e4})
    rows = [assembled("linear_delta", robot.parameters, p, some).rows for some in ((), (fault,))]
    strain = (
        rows[0].platform[0] - robot.parameters.direction[1][0] * rows[0].row(x_2=1.0) - rows[0].row(u_x=1.0)
    )
    assert np.allclose(rows[1].springs - rows[0].springs, 2e4 * np.outer(strain, strain), rtol=0, atol=1e-6)


def machine_joint(robot: Any, p: np.ndarray, j: int) -> np.ndarray:
    """Return the vector from the platform's origin to a joint, by Rodrigues' formula."""
    angle = np.linalg.norm(p[3:])
    k, b = p[3:] / angle, robot.parameters.joint[j]
    return np.asarray(b * np.cos(angle) + np.cross(k, b) * np.sin(angle) + k * (k @ b) * (1 - np.cos(angle)))


@pytest.mark.parametrize(
    ("machine", "stem", "effect", "compliance"),
    [
        ("published", "psi", "gearbox_compliance", 1e-4),
        ("asymmetric", "eps", "clamp_compliance", 4e-7),
        ("tower", "delta", "link_compliance", 1e-6),
        ("rotary_delta", "delta", "link_compliance", 6e-7),
        ("corexy", "psi", "gearbox_compliance", 0.03),
        ("corexy", "eps", "clamp_compliance", 1e-6),
        ("hexaglide", "psi", "gearbox_compliance", 0.01),
        ("hexaglide", "delta", "link_compliance", 2e-7),
    ],
)
def test_the_compliances_of_all_joints_are_the_effect_of_the_catalogue(
    machine: str, stem: str, effect: str, compliance: float
) -> None:
    axes = range(len(robot_of(machine).parameters.gear_ratio))
    faults = [Fault("compliance", (f"{stem}_{j + 1}",), values={"compliance": compliance}) for j in axes]
    assert agree(frequencies(machine, *faults), expected(machine, {f"{effect}.compliance": compliance}))


@pytest.mark.parametrize("machine", ["asymmetric", "hexapod"])
def test_the_frame_yields_in_one_direction(machine: str) -> None:
    fault = Fault("compliance", ("u_y",), values={"compliance": 1e-7})
    robot, p = robot_of(machine), MACHINES[machine].points[1]
    mass = robot.constants["frame_compliance.mass"]
    found = modes_of(robot.mechanism_name, robot.parameters, p, [fault], frame=mass).frequencies
    if machine == "hexapod":
        assert agree(found, expected(machine, {"frame_compliance.compliance_y": 1e-7}))
        return
    every = [Fault("compliance", (f"u_{i}",), values={"compliance": 1e-7}) for i in "xyz"]
    found = modes_of(robot.mechanism_name, robot.parameters, p, every, frame=mass).frequencies
    assert agree(found, expected(machine, {"frame_compliance.compliance": 1e-7}))


def test_the_bearings_of_all_second_pulleys_yield_as_on_the_other_rig() -> None:
    carriages = robot_of("published").parameters.carriage_mass
    faults = [
        Fault("mount", (f"pulley_{j + 1}_2",), values={"compliance": 2e-7, "mass": 0.2 * carriages[j]})
        for j in range(3)
    ]
    assert agree(frequencies("published", *faults), expected("published", None, {"pulley_mount": 2e-7}))


def test_a_bearing_without_mass_is_a_compliance_in_series() -> None:
    # both runs of a belt pull at the bearing, with their sum; its motion follows at once
    robot, p, c = robot_of("corexy"), MACHINES["corexy"].points[1], 3e-7
    q = robot.parameters
    g = q.belt_path_direction
    spans = q.belt_path_lengths + np.array([1.0, -1.0]) * (g @ p)[:, None]
    runs = (q.belt_width * q.belt_specific_stiffness)[:, None] / spans
    pull = np.column_stack([g, np.diag(q.pulley_radius)])  # x, y, theta_1, theta_2
    K = sum(runs[i].sum() * np.outer(pull[i], pull[i]) for i in (0, 1))
    sensed = runs[0, 0] - runs[0, 1]  # coupling of the bearing of pulley 1 and its belt
    K = K - np.outer(pull[0], pull[0]) * sensed**2 / (runs[0].sum() + 1 / c)
    rotors = q.pulley_inertia + q.gear_ratio**2 * q.motor_inertia
    M = np.diag([q.toolhead_mass, q.toolhead_mass + q.gantry_mass, *rotors])
    exact = np.sqrt(np.abs(np.sort(np.linalg.eigvals(np.linalg.solve(M, K)).real))) / (2 * np.pi)
    found = frequencies("corexy", Fault("mount", ("pulley_1",), values={"compliance": c}))
    assert agree(found, exact)


@pytest.mark.parametrize(
    ("machine", "place", "direction"),
    [("asymmetric", "carriage_2", "x"), ("rotary_delta", "arm_1", "z"), ("hexapod", "leg_3", "y")],
)
def test_a_bearing_that_yields_moves_the_place_where_the_leg_begins(
    machine: str, place: str, direction: str
) -> None:
    """The closed loops, solved here by Newton's method, follow a displaced base as the engine says."""
    robot, p = robot_of(machine), MACHINES[machine].points[1]
    q, leg, along = robot.parameters, int(place[-1]) - 1, np.eye(3)["xyz".index(direction)]
    fault = Fault("mount", (place,), direction, {"compliance": 1e-8})
    rows = assembled(robot.mechanism_name, q, p, [fault]).rows
    motion = rows.platform[:, rows.names.index("mount")]
    h = 1e-4
    ahead, behind = (_closed(robot.mechanism_name, q, p, leg, sign * h * along) for sign in (1, -1))
    assert np.allclose((ahead - behind)[:3] / (2 * h), motion, rtol=0, atol=1e-5)
    assert np.abs(motion).max() > 0.05


def _closed(mechanism: str, q: Any, p: np.ndarray, leg: int, shift: np.ndarray) -> np.ndarray:
    """Return the pose at which the links close if the base of a leg is displaced and all coordinates stay."""
    bases = _bases(mechanism, q, p)
    lengths = np.linalg.norm(_joints(q, p) - bases, axis=1)
    bases[leg] += shift
    pose = np.array(p, dtype=float)
    for _ in range(20):
        gaps = np.linalg.norm(_joints(q, pose) - bases, axis=1) - lengths
        slopes = np.empty((len(gaps), len(pose)))
        for i, unit in enumerate(np.eye(len(pose))):
            ends = [np.linalg.norm(_joints(q, pose + s * 1e-6 * unit) - bases, axis=1) for s in (1, -1)]
            slopes[:, i] = (ends[0] - ends[1]) / 2e-6
        pose -= np.linalg.solve(slopes, gaps)
    return pose


def _joints(q: Any, p: np.ndarray) -> np.ndarray:
    turned = Rotation.from_rotvec(p[3:]).as_matrix() if len(p) == 6 else np.eye(3)
    return np.asarray(p[:3] + q.joint @ turned.T)


def _bases(mechanism: str, q: Any, p: np.ndarray) -> np.ndarray:
    if mechanism == "hexapod":
        return np.array(q.base)
    if mechanism == "linear_delta":
        return np.asarray(q.origin + carriage_positions(q, p)[:, None] * q.direction)
    angle = arm_angles(q, p)[:, None]
    return np.asarray(
        q.origin + q.arm_length[:, None] * (np.cos(angle) * q.zero + np.sin(angle) * np.cross(q.axis, q.zero))
    )


def test_a_rail_that_yields_along_itself_changes_nothing() -> None:
    # the rails of the tower are vertical: belt and link move with the carriage, and nothing pulls at the rail
    fault = Fault("mount", ("carriage_1",), "z", {"compliance": 1e-6, "mass": 0.05})
    own = np.sqrt(1 / (1e-6 * 0.05)) / (2 * np.pi)
    assert agree(frequencies("tower", fault), np.sort([*frequencies("tower"), own]))


@pytest.mark.parametrize(
    ("machine", "place", "direction"),
    [
        ("asymmetric", "platform", "y"),
        ("asymmetric", "link_1", "x"),
        ("tower", "carriage_2", ""),
        ("rotary_delta", "motor_2", ""),
        ("hexapod", "rod_6", "z"),
        ("hexaglide", "platform", "x"),
        ("cartesian", "beam", ""),
    ],
)
def test_a_resonator_of_high_frequency_is_a_mass_at_its_place(
    machine: str, place: str, direction: str
) -> None:
    robot, p = _robot(machine)
    rotates = "motor" in place
    size = 1e-3 if rotates else 0.02
    stiff = Fault(
        "resonator", (place,), direction, {"inertia" if rotates else "mass": size, "frequency": 1e5}
    )
    machine_with = assembled(robot.mechanism_name, robot.parameters, p, [stiff])
    lumped = assembled(robot.mechanism_name, robot.parameters, p)
    body = lumped.places[place]
    if body.point is None:
        lumped.rows.inertia(body.rows[""], size)
    else:
        lumped.lump(size, body.point)
    bare = modes_of(robot.mechanism_name, robot.parameters, p).frequencies
    found, exact = machine_with.modes().frequencies[:-1], lumped.modes().frequencies
    assert agree(found, exact, 1e-5)
    assert not agree(exact, bare, 1e-4)


def test_a_resonator_on_a_bed_is_a_chain_of_three_masses() -> None:
    robot, p = _robot("bed_slinger")
    q, m, f = robot.parameters, 0.05, 210.0
    rod = q.belt_width[1] * q.belt_specific_stiffness[1]
    belt = rod / (q.axis_lengths[1, 0] + p[1]) + rod / (q.axis_lengths[1, 1] - p[1])
    rotor, k = (q.motor_inertia[1] + q.pulley_inertia[1]) / q.pulley_radius[1] ** 2, m * (2 * np.pi * f) ** 2
    K = np.array([[belt, -belt, 0], [-belt, belt + k, -k], [0, -k, k]])
    M = np.diag([rotor, q.bed_mass, m])
    exact = np.sqrt(np.sort(np.linalg.eigvals(np.linalg.solve(M, K)).real)[1:]) / (2 * np.pi)
    fault = Fault("resonator", ("bed",), "", {"mass": m, "frequency": f})
    found = modes_of("bed_slinger", q, p, [fault]).frequencies
    assert all(np.abs(found / one - 1).min() < 1e-9 for one in exact)


@pytest.mark.parametrize("machine", ["cartesian", "bed_slinger"])
def test_each_belt_of_a_printer_has_one_mode(machine: str) -> None:
    robot, p = _robot(machine)
    q = robot.parameters
    masses = [q.toolhead_mass, q.bed_mass if machine == "bed_slinger" else q.toolhead_mass + q.beam_mass]
    exact = []
    for i, mass in enumerate(masses):
        rod = q.belt_width[i] * q.belt_specific_stiffness[i]
        belt = rod / (q.axis_lengths[i, 0] + p[i]) + rod / (q.axis_lengths[i, 1] - p[i])
        rotor = q.motor_inertia[i] + q.pulley_inertia[i]
        exact.append(np.sqrt(belt * (1 / mass + q.pulley_radius[i] ** 2 / rotor)) / (2 * np.pi))
    found = modes_of(machine, q, p)
    assert found.rigid == 2
    assert np.allclose(found.frequencies[2:], sorted(exact), rtol=1e-12)


def _robot(machine: str) -> tuple[Any, np.ndarray]:
    if machine in MACHINES:
        return robot_of(machine), MACHINES[machine].points[1]
    file = {"cartesian": "cartesian-printer.toml", "bed_slinger": "bed-slinger.toml"}[machine]
    return read_robot(ROBOTS / file), np.array([0.07, 0.16])


def test_the_places_of_a_spring_have_no_order() -> None:
    assert same_term("spring:link_1/link_2.x", "spring:link_2/link_1.x")
    assert not same_term("spring:link_1/link_2.x", "spring:link_1/link_2.y")
    assert same_term("parameter:axis.1.link.mass", "parameter:axis.1.link.mass")
    assert not same_term("mass:link_1", "spring:link_1")
    assert Fault("spring", ("platform",), "rx").term == "spring:platform.rx"
    assert Fault("spring", ("pulley_2_1", "pulley_2_2")).term == "spring:pulley_2_1/pulley_2_2"
