r"""The linear delta: three carriages on rails in any position, parallelogram linkages, timing belts.

Carriage j is at :math:`e_j = o_j + x_j n_j`, the platform joint at :math:`c_j = p + b_j`, and the linkage between
them, :math:`s_j = c_j - e_j`, keeps its length (equations 1 to 3 of the paper).  Each carriage is pulled by a belt
over two pulleys, one of which is driven by a motor (equations 28 to 41).
"""

from __future__ import annotations

from sympy import Rational, Symbol, sqrt

from pkmodes_derive.description import Margin, ParameterGroup, Requirement, Scale
from pkmodes_derive.functions import Output
from pkmodes_derive.machine import Extra, Machine
from pkmodes_derive.mechanisms.linear_delta.euler_route import relations
from pkmodes_derive.mechanisms.linear_delta.picture import Axis, draw
from pkmodes_derive.mechanisms.linear_delta.sample import SAMPLE
from pkmodes_derive.parts import Clamp, PointMass, Rod, Run
from pkmodes_derive.trilateration import spheres
from pkmodes_derive.vectors import dot
from pkmodes_derive.vocabulary import AXES

__all__ = ["DIRECTIONS", "TITLE", "declare", "relations"]

TITLE = "three carriages on rails, parallelogram linkages, timing belts"
DIRECTIONS = AXES
J = range(3)
HALF = Rational(1, 2)


def declare(m: Machine) -> None:
    """Declare the linear delta."""
    v = m.vocabulary
    v.letters["k"] = "pulley k, or carriage k of a derivative"

    # The robot file -----------------------------------------------------------------------------------------
    m_p = m.tables.single("platform", "the moving platform").quantity(
        "mass", "m_p", "mass", "platform mass", above=0.0
    )[0]
    m.add_gravity()
    axis = m.tables.repeated("axis", 3, "one axis: a rail with its belt and pulleys")
    o = axis.vector("origin", "o", "point of rail {j} where x_{j} = 0", "o_{j}")
    n = axis.direction("direction", "n", "unit vector along rail {j}", "n_{j}")
    b = axis.vector("joint", "b", "platform joint {j} relative to the platform centre", "b_{j}")
    link = axis.shared("link", "one distal linkage: both rods of the parallelogram together")
    l_d = link.quantity("length", "l_d", "length", "length of linkage {j}", latex="l_{{d,{j}}}", above=0.0)
    m_d = link.quantity(
        "mass", "m_d", "mass", "mass of linkage {j}, both rods together", latex="m_{{d,{j}}}", at_least=0.0
    )
    carriage = axis.shared("carriage", "one carriage")
    m_t = carriage.quantity("mass", "m_t", "mass", "mass of carriage {j}", latex="m_{{t,{j}}}", at_least=0.0)
    l_t = carriage.quantity(
        "length", "l_t", "length", "length of carriage {j} along its rail", latex="l_{{t,{j}}}", at_least=0.0
    )
    belt = axis.shared("belt", "one timing belt")
    k_sp = belt.quantity(
        "specific_stiffness",
        "k_sp",
        "specific stiffness",
        "specific stiffness of belt {j}: k = w_b k_sp / free length",
        latex="k_{{sp,{j}}}",
        above=0.0,
    )
    w_b = belt.quantity("width", "w_b", "length", "width of belt {j}", latex="w_{{b,{j}}}", above=0.0)
    pulley = axis.shared("pulley", "each of the two pulleys of an axis")
    R_p = pulley.quantity(
        "radius", "R_p", "length", "radius of the pulleys of axis {j}", latex="R_{{p,{j}}}", above=0.0
    )
    I_p = pulley.quantity(
        "inertia",
        "I_p",
        "moment of inertia",
        "moment of inertia of each pulley of axis {j}",
        latex="I_{{p,{j}}}",
        above=0.0,
    )
    motor = axis.shared("motor", "motor and gearbox of an axis")
    I_m = motor.quantity(
        "inertia",
        "I_m",
        "moment of inertia",
        "moment of inertia of motor {j} at the motor shaft",
        latex="I_{{m,{j}}}",
        at_least=0.0,
    )
    i_g = motor.quantity(
        "gear_ratio",
        "i_g",
        "number",
        "gear ratio of axis {j}, motor over driven pulley",
        latex="i_{{g,{j}}}",
        field="gear_ratio",
        above=0.0,
    )
    driven = axis.one_of(
        "driven_pulley",
        "drive",
        "d",
        (1, 2),
        "the pulley that the motor drives",
        "1 if the motor drives pulley {k} of axis {j}, else 0",
        "d_{{{j},{k}}}",
    )
    x_min, x_max = axis.pair(
        "limits",
        ("x_min", "lower end of axis {j}, at pulley 2", r"\min(x_{j})"),
        ("x_max", "upper end of axis {j}, at pulley 1", r"\max(x_{j})"),
        "length",
        "min(x_{j}), max(x_{j}): pulley 2 is at min, pulley 1 at max",
    )
    sigma = axis.choice(
        "branch",
        "sigma",
        (1, -1),
        "branch of axis {j}: +1 if the carriage is ahead of the platform joint along the rail, -1 if behind",
        r"\sigma_{j}",
    )
    m.add_frame()

    # Pose and coordinates (equations 29 and 32) --------------------------------------------------------------
    p = m.platform_pose("p", "platform centre in the base frame", "p")
    m.generalised(
        [("x_{j}", "m", "position of carriage {j} along its rail", "{{x}}_{j}", {"j": j + 1}) for j in J],
        [
            (
                "theta_{j}_{k}",
                "rad",
                "rotation of pulley {k} of axis {j}",
                r"{{\vartheta}}_{{{j},{k}}}",
                {"j": j + 1, "k": k},
            )
            for k in (1, 2)
            for j in J
        ],
    )
    x, theta = m.coordinates[:3], (m.coordinates[3:6], m.coordinates[6:9])
    m.moves_platform(x, "x", "carriage positions")

    # Closures (equations 1 to 3) -----------------------------------------------------------------------------
    r = m.vectors("r", "m", "platform joint {j} relative to the origin of rail {j}", "r_{j}")
    s = m.vectors("s", "m", "linkage vector {j}, from carriage to platform joint", "s_{j}")
    for j in J:
        m.define_all(r[j], (p[i] + b[j][i] - o[j][i] for i in range(3)))
    for j in J:
        m.define_all(s[j], (r[j][i] - x[j] * n[j][i] for i in range(3)))
        m.unit_vector(n[j])
        m.link(s[j], l_d[j], x[j])
    m.differences["origin"] = "joint"  # o_j occurs only in r_j

    # Inverse kinematics: rail j meets the sphere of radius l_d around platform joint j (section 2.2, after figure 4)
    along = m.each("a", "m", "coordinate of platform joint {j} along rail {j}", "a_{j}")
    across = m.vectors("w", "m", "vector from rail {j} to platform joint {j}, perpendicular to it", "w_{j}")
    distance2 = m.each("w2", "m^2", "squared distance of platform joint {j} from rail {j}", r"|w_{j}|^2")
    for j in J:
        m.inverse[along[j]] = dot(n[j], r[j])
        m.inverse.update(zip(across[j], (r[j][i] - along[j] * n[j][i] for i in range(3)), strict=True))
        m.inverse[distance2[j]] = dot(across[j], across[j])
        m.inverse[x[j]] = along[j] + sigma[j] * sqrt(l_d[j] ** 2 - distance2[j])

    # Bodies (equations 24 and 26) ----------------------------------------------------------------------------
    m.platform = p
    m.points.append(PointMass(m_p, p))
    for j in J:
        e = tuple(o[j][i] + x[j] * n[j][i] for i in range(3))
        c = tuple(p[i] + b[j][i] for i in range(3))
        m.points.append(PointMass(m_t[j], e))
        m.rods.append(Rod(m_d[j], (e, c)))

    # Belts, pulleys and motors (equations 28 to 30 and 34 to 41) ---------------------------------------------
    moment = "moment of inertia of pulley {k} of axis {j}, including the motor if it is driven"
    torque = m.each("tau_st", "N m", "static torque on the driven pulley of axis {j}", r"\tau_{{st,{j}}}")
    drawn = []
    for j in J:
        rotors = [
            m.rotor(
                theta[k][j],
                I_p[j],
                v.declare("I_{j}_{k}", "kg m^2", moment, "I_{{p,{j},{k}}}", j=j + 1, k=k + 1),
            )
            for k in (0, 1)
        ]
        m.rail(x[j])
        m.drive(list(zip(rotors, driven[j], strict=True)), i_g[j] ** 2 * I_m[j], torque[j])
        clamp = Clamp()
        carriage_end = ({x[j]: 1}, clamp)
        rim_1, rim_2 = (({theta[k][j]: R_p[j]}, None) for k in (0, 1))
        room = HALF * l_t[j]
        free = (x_max[j] - x_min[j], x[j] - x_min[j] - room, x_max[j] - x[j] - room)
        ends = ((rim_2, rim_1), (carriage_end, rim_2), (rim_1, carriage_end))
        runs = [
            Run(*_span(m, j + 1, k), length, pair)
            for k, (length, pair) in enumerate(zip(free, ends, strict=True), 1)
        ]
        m.belt(w_b[j] * k_sp[j], runs, clamp)
        for k in (0, 1):  # with rigid belts
            m.follows[theta[k][j]] = x[j] / R_p[j]
        turned = (theta[0][j], theta[1][j])
        at = (x_max[j], x_min[j])
        drawn.append(Axis(o[j], n[j], x[j], at, R_p[j], turned, b[j], l_d[j], l_t[j], runs, clamp))
    draw(m, drawn)

    # Conditions on a pose and on a robot ---------------------------------------------------------------------
    m.extras += [
        Extra(
            "reach_margin",
            "Distance by which each platform joint could be farther from its rail.",
            "closure of equation 2; a pose is reachable if every margin is at least zero",
            (
                Output(
                    "margin",
                    (3,),
                    tuple(l_d[j] - sqrt(distance2[j]) for j in J),
                    "m",
                    "link length minus distance of the platform joint from its rail, for each axis",
                ),
            ),
        ),
        Extra(
            "travel_margin",
            "Sum of the lengths of the two belt spans at each carriage, the same at every pose.",
            "sum of equations 36 and 37",
            (
                Output(
                    "margin",
                    (3,),
                    tuple(x_max[j] - x_min[j] - l_t[j] for j in J),
                    "m",
                    "max - min - l_t for each axis; positive for a robot that can move",
                ),
            ),
            arguments=(),
            definitions={},
        ),
        spheres(m, [tuple(o[j][i] + x[j] * n[j][i] - b[j][i] for i in range(3)) for j in J], l_d),
    ]
    m.parameter_groups = (
        ParameterGroup(
            "axis.span", "span", "limits", "m", "max - min of every axis, with both ends moved evenly"
        ),
        ParameterGroup(
            "axis.joint_radius", "radius", "joint", "m", "distance of the platform joints from the centre"
        ),
    )
    m.scales = tuple(Scale(x[j].name, "pulley_radius", (j,), "R_p") for j in J)
    m.margins = _margins()
    m.requirements = (
        Requirement(
            "travel_margin",
            "above_zero",
            tuple(f"axis.{j + 1}.limits" for j in J),
            "expected a carriage shorter than the travel, found a length of {carriage.length}",
            "check the limits and carriage.length",
            "m",
        ),
    )
    m.sample = SAMPLE


def _span(m: Machine, j: int, s: int) -> tuple[Symbol, Symbol]:
    """Declare the names of the free length and the stiffness of a belt span."""
    of = "span {s} of belt {j} (1 between the pulleys, 2 from carriage to pulley 2, 3 from carriage to pulley 1)"
    declare = m.vocabulary.declare
    return (
        declare("l_f_{j}_{s}", "m", f"free length of {of}", "l_{{f,{j},{s}}}", j=j, s=s),
        declare("k_{j}_{s}", "N/m", f"stiffness of {of}", "k_{{{j},{s}}}", j=j, s=s),
    )


def _margins() -> tuple[Margin, ...]:
    three = ("1", "2", "3")
    return (
        Margin(
            "reachable",
            "reach_margin",
            0,
            "at_least_zero",
            "the pose is out of reach: a link is too short",
            "the pose is out of reach: link {0} is {missing} too short",
            "choose a pose closer to the rails",
            (three,),
        ),
        Margin(
            "singular",
            "jacobian_condition",
            1,
            "at_most_limit",
            "the pose is singular",
            "the pose is singular: the condition number of D_l is {value}",
            "choose a pose farther from the singularity",
            unit="1",
        ),
        Margin(
            "limits",
            "belt_spans",
            0,
            "above_zero",
            "a carriage is beyond its limits: a belt span would not have a positive length",
            "carriage {0} is beyond its limits: the belt span {1} would be {short}",
            "choose a pose within the travel of the carriages, or check limits and carriage length",
            (
                three,
                (
                    "between its pulleys",
                    "between its carriage and pulley 2",
                    "between its carriage and pulley 1",
                ),
            ),
        ),
    )
