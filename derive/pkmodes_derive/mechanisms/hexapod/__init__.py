r"""The hexapod: six legs that change their length, universal joints at the base, a platform that moves and turns.

Leg j goes from the base joint a_j to the platform joint :math:`q_j = p + R b_j`; its length is the coordinate
:math:`l_j = |q_j - a_j|`, and the vector between the joints, :math:`d_j = q_j - a_j`, closes the loop.  A motor
commands the length s_j through an elastic transmission, such as a screw with its nut and bearings.
"""

from __future__ import annotations

from sympy import Integer, Symbol, sqrt

from pkmodes_derive.conditions import (
    SINGULAR,
    require_a_plane,
    require_different_legs,
    require_legs_that_do_not_cross,
    rotation_margin,
)
from pkmodes_derive.description import Margin
from pkmodes_derive.functions import Output
from pkmodes_derive.machine import Extra, Machine
from pkmodes_derive.mechanisms.hexapod.picture import draw
from pkmodes_derive.mechanisms.hexapod.sample import SAMPLE
from pkmodes_derive.parts import LegPart, Reducer, Seat
from pkmodes_derive.platform_table import platform_that_turns
from pkmodes_derive.tables import Declared
from pkmodes_derive.vectors import dot
from pkmodes_derive.vocabulary import AXES

__all__ = ["DIRECTIONS", "ROTATIONS", "TITLE", "declare"]

TITLE = "six legs that change their length, a platform with six degrees of freedom"
DIRECTIONS = ROTATIONS = AXES
J = range(6)


def declare(m: Machine) -> None:
    """Declare the hexapod."""
    v = m.vocabulary
    v.letters["j"] = "leg j"

    # The robot file -----------------------------------------------------------------------------------------
    platform = platform_that_turns(m)
    m.add_gravity()
    axis = m.tables.repeated("axis", 6, "one leg, from its base joint to its platform joint")
    a = axis.vector("base", "a", "base joint {j}", "a_{j}")
    b = axis.vector("joint", "b", "platform joint {j} from the platform's origin in platform axes", "b_{j}")
    l_min, l_max = axis.pair(
        "limits",
        ("l_min", "least length of leg {j}", r"\min(l_{j})"),
        ("l_max", "greatest length of leg {j}", r"\max(l_{j})"),
        "length",
        "min(l_{j}), max(l_{j})",
        above=0.0,
    )
    leg = axis.shared("leg", "one leg: transmission, the part at the base and the rod at the platform")
    k_l = leg.quantity(
        "stiffness",
        "k_l",
        "stiffness",
        "stiffness of the transmission of leg {j}",
        latex="k_{{l,{j}}}",
        above=0.0,
    )
    m_b, c_b, I_b = _leg_part(
        leg, "base", "b", "the part of leg {j} that turns about the base joint", "base joint"
    )
    m_r, c_r, I_r = _leg_part(
        leg, "rod", "r", "the part of leg {j} that ends in the platform joint", "platform joint"
    )
    motor = axis.shared("motor", "the motor of a leg")
    I_m = motor.quantity(
        "inertia",
        "I_m",
        "moment of inertia",
        "moment of inertia of motor {j}",
        latex="I_{{m,{j}}}",
        above=0.0,
    )
    h = motor.quantity(
        "travel",
        "h_m",
        "length",
        "change of the length of leg {j} per radian of its motor",
        latex="h_{j}",
        above=0.0,
    )
    m.add_frame()

    # Pose and coordinates -----------------------------------------------------------------------------------
    p = m.platform_pose("p", "platform's origin in the base frame", "p")
    m.generalised(
        [("l_{j}", "m", "length of leg {j}", "{{l}}_{j}", {"j": j + 1}) for j in J],
        [("s_{j}", "m", "length that motor {j} commands", "{{s}}_{j}", {"j": j + 1}) for j in J],
    )
    l, s = m.coordinates[:6], m.coordinates[6:]  # noqa: E741  # the symbol of a length
    m.moves_platform(l, "l", "leg lengths")

    # Closures: the distance of the joints of a leg is its length ---------------------------------------------
    lever = m.vectors("B", "m", "platform joint {j} from the platform's origin, base frame", "B_{j}")
    d = m.vectors("d", "m", "leg {j}, from base joint to platform joint", "d_{j}")
    for j in J:
        m.fixed_in_platform(lever[j], b[j])
        m.define_all(d[j], (p[i] + lever[j][i] - a[j][i] for i in range(3)))
        m.link(d[j], l[j], l[j], lever[j])
        m.inverse[l[j]] = sqrt(dot(d[j], d[j]))

    # Bodies ---------------------------------------------------------------------------------------------------
    m.platform = p
    m.body(platform.mass, platform.centre, platform.inertia, platform.products)
    for j in J:
        ends = a[j], tuple(p[i] + lever[j][i] for i in range(3))
        base = LegPart(m_b[j], I_b[j], 0, c_b[j], f"leg_{j + 1}", f"the base part of leg {j + 1}")
        rod = LegPart(m_r[j], I_r[j], 1, -c_r[j], f"rod_{j + 1}", f"the rod of leg {j + 1}")
        bodies = m.leg(m.links[j], ends, (base, rod), j=j + 1)
        m.seats.append(Seat(f"leg_{j + 1}", m.links[j], legs=[bodies]))

    # Transmissions --------------------------------------------------------------------------------------------
    force = m.each("f_st", "N", "static force on drive {j}", r"f_{{st,{j}}}")
    stiffness = m.each("k", "N/m", "stiffness of leg {j}, with effects", "k_{j}")
    for j in J:
        rotor = m.rotor(s[j], Integer(0), place=f"motor_{j + 1}")
        m.drive([(rotor, Integer(1))], I_m[j] / h[j] ** 2, force[j], winds_up=False)
        m.leg_springs.append(Reducer(stiffness[j], k_l[j], {l[j]: Integer(1), s[j]: Integer(-1)}))
        m.follows[s[j]] = l[j]
    draw(m, a, lever)

    # Conditions on a pose and on a robot --------------------------------------------------------------------
    travel = tuple(margin for j in J for margin in (l[j] - l_min[j], l_max[j] - l[j]))
    text = "for each leg: above the least and below the greatest length"
    m.extras.append(
        Extra(
            "travel_margin",
            "Distance of each leg's length from its limits.",
            "the limits of the robot file",
            (Output("margin", (6, 2), travel, "m", text),),
        )
    )
    rotation_margin(m)
    require_a_plane(m, "joint", b, "joints on the platform")
    require_a_plane(m, "base", a, "joints on the base")
    require_different_legs(
        m,
        b,
        "legs",
        lambda j, k: ([v - w for points in (a, b) for v, w in zip(points[j], points[k], strict=True)], ()),
        "check base and joint of both",
    )
    require_legs_that_do_not_cross(m, a, b, "check base and joint of both: joints may be exchanged")
    numbers = tuple(str(j + 1) for j in J)
    m.margins += (
        SINGULAR,
        Margin(
            "limits",
            "travel_margin",
            0,
            "at_least_zero",
            "a leg is outside its limits",
            "leg {0} is outside its limits: its length misses the {1} by {missing}",
            "choose another pose, or check base, joint and limits",
            (numbers, ("least length", "greatest length")),
        ),
    )
    m.sample = SAMPLE


def _leg_part(leg: Declared, key: str, index: str, what: str, joint: str) -> tuple[tuple[Symbol, ...], ...]:
    """Declare the mass of a part of a leg, its centre of mass along the leg, and its moment of inertia."""
    mass = leg.quantity(
        f"{key}_mass", f"m_{index}", "mass", f"mass of {what}", latex=f"m_{{{{{index},{{j}}}}}}", at_least=0.0
    )
    centre = leg.quantity(
        f"{key}_center",
        f"c_{index}",
        "length",
        f"centre of mass of {what}, from the {joint}",
        latex=f"c_{{{{{index},{{j}}}}}}",
        signed=True,
    )
    inertia = leg.quantity(
        f"{key}_inertia",
        f"I_{index}",
        "moment of inertia",
        f"moment of inertia of {what} about its centre of mass, perpendicular to the leg",
        latex=f"I_{{{{{index},{{j}}}}}}",
        at_least=0.0,
    )
    return mass, centre, inertia
