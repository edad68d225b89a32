"""The definition of a planar 3-RPR: three actuators between fixed pivots and a platform that turns in its plane."""

from __future__ import annotations

from sympy import sqrt

from pkmodes_derive.description import Margin
from pkmodes_derive.functions import Output
from pkmodes_derive.machine import Extra, Machine
from pkmodes_derive.parts import LegPart, Reducer
from pkmodes_derive.vectors import dot

TITLE = "three actuators that change their length, a platform that moves and turns in a plane"
DIRECTIONS = ("x", "y")
ROTATIONS = ("z",)
LEGS = range(3)


def declare(m: Machine) -> None:
    """Declare the 3-RPR."""
    table = m.tables.single("platform", "the platform")
    (m_p,) = table.quantity("mass", "m_p", "mass", "mass of the platform", above=0)
    c_p = table.vector_of(
        "center", "c_p", "length", "centre of mass in platform axes", "c_{{p,{i}}}", DIRECTIONS
    )
    I_p = table.quantity("inertia", "I_p", "moment of inertia", "inertia about its centre of mass", above=0)
    m.add_gravity()
    axis = m.tables.repeated("axis", 3, "one actuator")
    a = axis.vector("base", "a", "pivot {j}", "a_{j}", axes=DIRECTIONS)
    b = axis.vector("joint", "b", "platform joint {j}, platform axes", "b_{j}", axes=DIRECTIONS)
    low, high = axis.pair(
        "limits",
        ("l_min", "least length of {j}", r"\min l_{j}"),
        ("l_max", "greatest length of {j}", r"\max l_{j}"),
        "length",
        "least, greatest",
        above=0,
    )
    act, motor = axis.shared("actuator", "screw, housing and rod"), axis.shared("motor", "the motor")
    k_a = act.quantity(
        "stiffness", "k_a", "stiffness", "stiffness of screw {j}", latex="k_{{a,{j}}}", above=0
    )
    m_h = act.quantity("housing_mass", "m_h", "mass", "mass of housing {j}", latex="m_{{h,{j}}}", at_least=0)
    c_h = act.quantity(
        "housing_center", "c_h", "length", "its centre from the pivot {j}", latex="c_{{h,{j}}}", signed=True
    )
    I_h = act.quantity(
        "housing_inertia", "I_h", "moment of inertia", "about its centre {j}", latex="I_{{h,{j}}}", at_least=0
    )
    m_r = act.quantity("rod_mass", "m_r", "mass", "mass of rod {j}", latex="m_{{r,{j}}}", at_least=0)
    c_r = act.quantity(
        "rod_center", "c_r", "length", "its centre from the joint {j}", latex="c_{{r,{j}}}", signed=True
    )
    I_r = act.quantity(
        "rod_inertia", "I_r", "moment of inertia", "about its centre {j}", latex="I_{{r,{j}}}", at_least=0
    )
    I_m = motor.quantity(
        "inertia", "I_m", "moment of inertia", "inertia of motor {j}", latex="I_{{m,{j}}}", above=0
    )
    h = motor.quantity("travel", "h_m", "length", "travel per radian {j}", latex="h_{j}", above=0)
    m.add_frame()

    p = m.platform_pose("p", "platform's origin in the base frame", "p")
    m.generalised(
        [("l_{j}", "m", "length of actuator {j}", "{{l}}_{j}", {"j": j + 1}) for j in LEGS],
        [("s_{j}", "m", "length commanded by motor {j}", "{{s}}_{j}", {"j": j + 1}) for j in LEGS],
    )
    l, s = m.coordinates[:3], m.coordinates[3:]  # noqa: E741  # the symbol of a length
    m.moves_platform(l, "l", "actuator lengths")
    m.platform = (*p, 0)
    m.body(m_p, c_p, I_p)
    lever = m.vectors("B", "m", "joint {j} from the platform's origin, base frame", "B_{j}")
    d = m.vectors("d", "m", "actuator {j}, from pivot to joint", "d_{j}")
    force = m.each("f_st", "N", "static force on drive {j}", r"f_{{st,{j}}}")
    stiffness = m.each("k", "N/m", "stiffness of actuator {j}, with effects", "k_{j}")
    for j in LEGS:
        m.fixed_in_platform(lever[j], b[j])
        m.define_all(d[j], (p[i] + lever[j][i] - a[j][i] for i in range(2)))
        m.link(d[j], l[j], l[j], lever[j])
        m.inverse[l[j]] = sqrt(dot(d[j], d[j]))
        ends = (*a[j], 0), (p[0] + lever[j][0], p[1] + lever[j][1], 0)
        m.leg(
            m.links[j],
            ends,
            (LegPart(m_h[j], I_h[j], 0, c_h[j]), LegPart(m_r[j], I_r[j], 1, -c_r[j])),
            j=j + 1,
        )
        m.drive([(m.rotor(s[j], 0), 1)], I_m[j] / h[j] ** 2, force[j], winds_up=False)
        m.leg_springs.append(Reducer(stiffness[j], k_a[j], {l[j]: 1, s[j]: -1}))
        m.follows[s[j]] = l[j]
    travel = tuple(x for j in LEGS for x in (l[j] - low[j], high[j] - l[j]))
    m.extras.append(
        Extra(
            "travel_margin",
            "Distance from the limits.",
            "limits",
            (Output("margin", (3, 2), travel, "m", "0 or more"),),
        )
    )
    m.margins = (
        Margin(
            "singular",
            "jacobian_condition",
            1,
            "at_most_limit",
            "the pose is singular",
            "condition {value}",
            "turn the platform back",
            unit="1",
        ),
        Margin(
            "limits",
            "travel_margin",
            0,
            "at_least_zero",
            "an actuator is outside its limits",
            "actuator {0} misses the {1} by {missing}",
            "choose another pose",
            (("1", "2", "3"), ("least length", "greatest length")),
        ),
    )
    m.sample = {
        "platform_mass": 0.5,
        "platform_center": [0.01, -0.006],
        "platform_inertia": 9e-4,
        "gravity": [0.3, -9.7, 0.4],
        "base": [[-0.3, -0.2], [0.32, -0.19], [0.01, 0.34]],
        "joint": [[-0.05, -0.03], [0.06, -0.035], [0.004, 0.06]],
        "limits": [[0.1, 0.6], [0.11, 0.61], [0.12, 0.59]],
        "actuator_stiffness": [9e5, 1.1e6, 1e6],
        "actuator_housing_mass": [0.3, 0.35, 0.28],
        "actuator_housing_center": [0.07, 0.08, 0.06],
        "actuator_housing_inertia": [1e-3, 1.1e-3, 9e-4],
        "actuator_rod_mass": [0.1, 0.12, 0.09],
        "actuator_rod_center": [0.05, 0.06, 0.04],
        "actuator_rod_inertia": [2e-4, 3e-4, 2.5e-4],
        "motor_inertia": [1e-5, 1.2e-5, 9e-6],
        "motor_travel": [8e-4, 7e-4, 9e-4],
    }
