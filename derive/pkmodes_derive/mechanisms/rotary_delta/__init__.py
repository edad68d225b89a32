r"""The rotary delta (Clavel): three arms on elastic reducers, parallelogram linkages, a platform that translates.

Arm j turns by :math:`\theta_j` about :math:`a_j` through :math:`o_j`.  With :math:`z_j` its direction at zero and
:math:`y_j = a_j \times z_j`, its end is at :math:`e_j = o_j + L_j (\cos\theta_j\, z_j + \sin\theta_j\, y_j)`, and the
linkage to the platform joint, :math:`s_j = p + b_j - e_j`, keeps its length.  The reducer is a torsional spring
between the arm and the motor, whose angle divided by the gear ratio is :math:`\varphi_j`.
"""

from __future__ import annotations

from sympy import Expr, Rational, Symbol, atan2, cos, sin, sqrt

from pkmodes_derive.conditions import SINGULAR
from pkmodes_derive.description import Margin, ParameterGroup, Requirement
from pkmodes_derive.functions import Output
from pkmodes_derive.machine import Extra, Machine
from pkmodes_derive.mechanisms.rotary_delta.picture import Axis, draw
from pkmodes_derive.mechanisms.rotary_delta.sample import SAMPLE
from pkmodes_derive.parts import Arm, PointMass, Reducer, Rod, Seat
from pkmodes_derive.transmission_tables import geared_motor
from pkmodes_derive.trilateration import spheres
from pkmodes_derive.vectors import cross, dot
from pkmodes_derive.vocabulary import AXES

__all__ = ["DIRECTIONS", "TITLE", "declare"]

TITLE = "three arms on elastic reducers, parallelogram linkages"
DIRECTIONS = AXES
J = range(3)
#: Largest accepted |axis . zero|; the zero direction must be perpendicular to the axis.
PERPENDICULAR_TOLERANCE = Rational(1, 10**6)


def declare(m: Machine) -> None:
    """Declare the rotary delta."""
    v = m.vocabulary

    # The robot file -----------------------------------------------------------------------------------------
    m_p = m.tables.single("platform", "the moving platform").quantity(
        "mass", "m_p", "mass", "platform mass", above=0.0
    )[0]
    m.add_gravity()
    axis = m.tables.repeated("axis", 3, "one axis: an arm with its reducer and motor")
    o = axis.vector("origin", "o", "point of the axis of arm {j} where the arm starts", "o_{j}")
    a = axis.direction("axis", "a", "unit vector of rotation of arm {j}", "a_{j}")
    z = axis.direction("zero", "z", "direction of arm {j} at theta_{j} = 0", "z_{j}")
    b = axis.vector("joint", "b", "platform joint {j} relative to the platform centre", "b_{j}")
    arm = axis.shared("arm", "one proximal arm")
    L_a = arm.quantity(
        "length",
        "L_a",
        "length",
        "length of arm {j}, to the joint of the linkage",
        latex="L_{{a,{j}}}",
        above=0.0,
    )
    m_a = arm.quantity("mass", "m_a", "mass", "mass of arm {j}", latex="m_{{a,{j}}}", at_least=0.0)
    r_a = arm.quantity(
        "center",
        "r_a",
        "length",
        "distance of the centre of mass of arm {j} from its axis, along the arm",
        latex="r_{{a,{j}}}",
        signed=True,
    )
    I_a = arm.quantity(
        "inertia",
        "I_a",
        "moment of inertia",
        "moment of inertia of arm {j} about its axis",
        latex="I_{{a,{j}}}",
        above=0.0,
    )
    link = axis.shared("link", "one distal linkage: both rods of the parallelogram together")
    l_d = link.quantity("length", "l_d", "length", "length of linkage {j}", latex="l_{{d,{j}}}", above=0.0)
    m_d = link.quantity(
        "mass", "m_d", "mass", "mass of linkage {j}, both rods together", latex="m_{{d,{j}}}", at_least=0.0
    )
    reducer = axis.shared("reducer", "the reducer between motor and arm")
    k_r = reducer.quantity(
        "stiffness",
        "k_r",
        "torsional stiffness",
        "torsional stiffness of reducer {j}, seen at the arm",
        latex="k_{{r,{j}}}",
        above=0.0,
    )
    I_m, i_g = geared_motor(
        axis,
        "the motor of an axis",
        "moment of inertia of motor {j} at its shaft",
        "gear ratio of axis {j}, motor over arm",
        alone=True,
    )
    low, high = axis.pair(
        "limits",
        ("theta_min", "lower limit of theta_{j}", r"\min(\vartheta_{j})"),
        ("theta_max", "upper limit of theta_{j}", r"\max(\vartheta_{j})"),
        "angle",
        "min(theta_{j}), max(theta_{j})",
        at_least=-HALF_TURN,
        at_most=HALF_TURN,
    )
    sigma = axis.choice(
        "branch",
        "sigma",
        (1, -1),
        "branch of axis {j}: +1 or -1, the side to which the arm bends",
        r"\sigma_{j}",
    )
    m.add_frame()

    # Pose and coordinates -----------------------------------------------------------------------------------
    p = m.platform_pose("p", "platform centre in the base frame", "p")
    m.generalised(
        [("theta_{j}", "rad", "angle of arm {j}", r"{{\vartheta}}_{j}", {"j": j + 1}) for j in J],
        [
            (
                "phi_{j}",
                "rad",
                "angle of motor {j} divided by the gear ratio",
                r"{{\varphi}}_{j}",
                {"j": j + 1},
            )
            for j in J
        ],
    )
    theta, phi = m.coordinates[:3], m.coordinates[3:]
    m.moves_platform(theta, "theta", "arm angles")

    # Arms: direction and its derivative with respect to the angle, both unit vectors -----------------------------
    y = m.vectors("y", "1", "direction of arm {j} at theta_{j} = 90 deg: a_{j} times z_{j}", "y_{j}")
    c = m.each("c", "1", "cosine of theta_{j}", r"\cos\vartheta_{j}")
    s_ = m.each("sn", "1", "sine of theta_{j}", r"\sin\vartheta_{j}")
    d = m.vectors("d", "1", "direction of arm {j}", "d_{j}")
    t = m.vectors("t", "1", "direction in which the end of arm {j} moves", "t_{j}")
    e = []
    for j in J:
        m.define_all(y[j], cross(a[j], z[j]))
        m.define_all(d[j], (c[j] * z[j][i] + s_[j] * y[j][i] for i in range(3)))
        m.define_all(t[j], (c[j] * y[j][i] - s_[j] * z[j][i] for i in range(3)))
        for i in range(3):
            m.turns(d[j][i], theta[j], t[j][i])
            m.turns(t[j][i], theta[j], -d[j][i])
        m.turns(c[j], theta[j], -s_[j])
        m.turns(s_[j], theta[j], c[j])
        m.unit_vector(t[j])
        e.append(tuple(o[j][i] + L_a[j] * d[j][i] for i in range(3)))

    # Closures -----------------------------------------------------------------------------------------------
    r = m.vectors("r", "m", "platform joint {j} relative to the origin of arm {j}", "r_{j}")
    s = m.vectors("s", "m", "linkage vector {j}, from arm to platform joint", "s_{j}")
    for j in J:
        m.define_all(r[j], (p[i] + b[j][i] - o[j][i] for i in range(3)))
        m.define_all(s[j], (r[j][i] - L_a[j] * d[j][i] for i in range(3)))
        m.link(s[j], l_d[j], theta[j])
    m.differences["origin"] = "joint"  # o_j occurs only in r_j

    # Inverse kinematics: in the plane of the arm, d_j . r_j = C_j ----------------------------------------------
    A = m.each("A", "m", "component of r_{j} along z_{j}", "A_{j}")
    B = m.each("B", "m", "component of r_{j} along y_{j}", "B_{j}")
    C = m.each("C", "m", "component of r_{j} along the arm when the loop is closed", "C_{j}")
    rho2 = m.each("rho2", "m^2", "squared length of the part of r_{j} in the plane of the arm", r"\rho_{j}^2")
    across = m.each("S", "m", "component of r_{j} in that plane, perpendicular to the arm", "S_{j}")
    for j in J:
        m.inverse[A[j]] = dot(r[j], z[j])
        m.inverse[B[j]] = dot(r[j], y[j])
        m.inverse[rho2[j]] = A[j] ** 2 + B[j] ** 2
        m.inverse[C[j]] = (dot(r[j], r[j]) + L_a[j] ** 2 - l_d[j] ** 2) / (2 * L_a[j])
        m.inverse[across[j]] = sigma[j] * sqrt(rho2[j] - C[j] ** 2)
        # theta = atan2(B, A) + sigma acos(C / rho), through its cosine and sine: no other value needs the angle.
        m.inverse[c[j]] = (A[j] * C[j] - B[j] * across[j]) / rho2[j]
        m.inverse[s_[j]] = (B[j] * C[j] + A[j] * across[j]) / rho2[j]
        m.inverse[theta[j]] = atan2(s_[j], c[j])

    # Bodies ------------------------------------------------------------------------------------------------------
    m.platform = p
    m.points.append(PointMass(m_p, p, "platform", "the platform"))
    for j in J:
        c_j = tuple(p[i] + b[j][i] for i in range(3))
        m.rods.append(Rod(m_d[j], (e[j], c_j), f"link_{j + 1}"))
        centre = tuple(o[j][i] + r_a[j] * d[j][i] for i in range(3))
        m.arms.append(Arm(m_a[j], I_a[j], theta[j], centre, f"arm_{j + 1}"))
        m.seats.append(Seat(f"arm_{j + 1}", m.links[j], ends=[(m.rods[-1], 0)], arms=[m.arms[-1]]))

    # Reducers and motors --------------------------------------------------------------------------------------
    torque = m.each("tau_st", "N m", "static torque on motor {j}, seen at the arm", r"\tau_{{st,{j}}}")
    for j in J:
        inertia = v.declare(
            "I_{j}", "kg m^2", "moment of inertia of motor {j}, seen at the arm", "I_{j}", j=j + 1
        )
        rotor = m.rotor(phi[j], 0, inertia, f"motor_{j + 1}")
        m.drive([(rotor, 1)], i_g[j] ** 2 * I_m[j], torque[j], winds_up=False)
        stiffness = v.declare("k_{j}", "N m/rad", "stiffness of reducer {j}", "k_{j}", j=j + 1)
        m.reducers.append(Reducer(stiffness, k_r[j], {theta[j]: 1, phi[j]: -1}))
        m.follows[phi[j]] = theta[j]
    draw(m, [Axis(o[j], a[j], e[j], theta[j], phi[j], L_a[j], b[j], m.reducers[j]) for j in J])

    # Conditions on a pose and on a robot ---------------------------------------------------------------------
    sphere_centres = _sphere_centres(m, theta, z, y, o, b, L_a)
    m.extras += [
        _margin(
            "reach_margin",
            "Margins of the length of each linkage above its minimum and below its maximum.",
            "distance of the platform joint from the nearest and the farthest point of the arm's circle",
            tuple(entry for j in J for entry in _reach(r[j], rho2[j], L_a[j], l_d[j])),
            "m",
            (3, 2),
        ),
        _margin(
            "limit_margin",
            "Distance of each arm from its limits.",
            "both ends of the limits",
            tuple(entry for j in J for entry in (theta[j] - low[j], high[j] - theta[j])),
            "rad",
            (3, 2),
        ),
        Extra(
            "perpendicular_margin",
            "Margin for the zero direction of each arm to be perpendicular to its axis.",
            "|a_j . z_j| is at most 1e-6: (1e-6)^2 - (a_j . z_j)^2",
            (
                Output(
                    "margin",
                    (3,),
                    tuple(PERPENDICULAR_TOLERANCE**2 - dot(a[j], z[j]) ** 2 for j in J),
                    "1",
                    "at least zero for perpendicular directions",
                ),
            ),
            arguments=(),
            definitions={},
        ),
        Extra(
            "inertia_margin",
            "Moment of inertia of each arm minus that of a point mass at its centre of mass.",
            "the parallel axis theorem",
            (
                Output(
                    "margin",
                    (3,),
                    tuple(I_a[j] - m_a[j] * r_a[j] ** 2 for j in J),
                    "kg m^2",
                    "at least zero for a physical body",
                ),
            ),
            arguments=(),
            definitions={},
        ),
        spheres(m, sphere_centres, l_d),
    ]
    m.parameter_groups = (
        ParameterGroup(
            "axis.joint_radius", "radius", "joint", "m", "distance of the platform joints from the centre"
        ),
    )
    m.margins = _margins()
    m.requirements = _requirements()
    m.sample = SAMPLE


#: Half a turn [rad], rounded to double precision.
HALF_TURN = 3.141592653589793


def _reach(r: tuple[Symbol, ...], rho2: Symbol, arm: Symbol, link: Symbol) -> tuple[Expr, Expr]:
    """Return the margins of a linkage length above the distance of the nearest point and below the farthest."""
    squares, product = dot(r, r) + arm**2, 2 * arm * sqrt(rho2)
    return link - sqrt(squares - product), sqrt(squares + product) - link


def _sphere_centres(
    m: Machine,
    theta: tuple[Symbol, ...],
    z: tuple[tuple[Symbol, ...], ...],
    y: tuple[tuple[Symbol, ...], ...],
    o: tuple[tuple[Symbol, ...], ...],
    b: tuple[tuple[Symbol, ...], ...],
    L_a: tuple[Symbol, ...],
) -> list[tuple[object, ...]]:
    """Return the centres of the spheres that contain the platform centre, as functions of the angles."""
    definitions = m.chain.definitions
    return [
        tuple(
            o[j][i] + L_a[j] * (cos(theta[j]) * z[j][i] + sin(theta[j]) * definitions[y[j][i]]) - b[j][i]
            for i in range(3)
        )
        for j in J
    ]


def _margin(
    name: str,
    summary: str,
    source: str,
    entries: tuple[object, ...],
    unit: str,
    shape: tuple[int, ...] = (3,),
) -> Extra:
    what = "for each axis; at least zero if satisfied"
    return Extra(name, summary, source, (Output("margin", shape, entries, unit, what),))


def _margins() -> tuple[Margin, ...]:
    three = ("1", "2", "3")
    return (
        Margin(
            "reachable",
            "reach_margin",
            0,
            "at_least_zero",
            "the pose is out of reach: an arm and its link do not reach the platform",
            "the pose is out of reach: linkage {0} is {missing} {1}",
            "choose a pose that the arms and links can reach",
            (three, ("too short", "too long")),
        ),
        SINGULAR,
        Margin(
            "limits",
            "limit_margin",
            0,
            "at_least_zero",
            "an arm is beyond its limits",
            "arm {0} is beyond its {1} limit by {missing}",
            "choose a pose within the limits of the arms, or check limits and branch",
            (three, ("lower", "upper")),
            unit="rad",
        ),
    )


def _requirements() -> tuple[Requirement, ...]:
    return (
        Requirement(
            "perpendicular_margin",
            "at_least_zero",
            tuple(f"axis.{j + 1}.zero" for j in J),
            "expected a direction perpendicular to the axis, found one with |axis . zero| above 1e-6",
            "give the direction of the arm at theta = 0, perpendicular to axis",
            "1",
        ),
        Requirement(
            "inertia_margin",
            "at_least_zero",
            tuple(f"axis.{j + 1}.arm.inertia" for j in J),
            "expected at least mass * center^2, found an inertia {missing} smaller",
            "give the moment of inertia about the axis of rotation, not about the centre of mass",
            "kg m^2",
        ),
    )
