r"""Carriages on rails, each with a belt over two pulleys and a link to the platform.

Carriage j is at :math:`e_j = o_j + x_j n_j`, the platform joint at c_j, and the link between them,
:math:`s_j = c_j - e_j`, keeps its length (equations 1 to 3 of the paper).  Each carriage is pulled by a belt over two
pulleys, one of which is driven by a motor (equations 28 to 41).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from sympy import Rational, Symbol, sqrt

from pkmodes_derive.conditions import SINGULAR
from pkmodes_derive.description import Margin, ParameterGroup, Requirement, Scale
from pkmodes_derive.functions import Output
from pkmodes_derive.machine import Extra, Machine
from pkmodes_derive.parts import Clamp, PointMass, Rod, Run, Seat
from pkmodes_derive.rails.picture import Axis
from pkmodes_derive.transmission_tables import geared_motor, pulley, timing_belt
from pkmodes_derive.vectors import dot

HALF = Rational(1, 2)


@dataclass(frozen=True)
class Words:
    """Descriptions of a link between carriage and platform."""

    link: str
    length: str
    mass: str
    joint: str


@dataclass(frozen=True)
class Axes:
    """The quantities of the axes, with the paper's symbols: see `declare_axes`."""

    o: tuple[tuple[Symbol, ...], ...]
    n: tuple[tuple[Symbol, ...], ...]
    b: tuple[tuple[Symbol, ...], ...]
    l_d: tuple[Symbol, ...]
    m_d: tuple[Symbol, ...]
    m_t: tuple[Symbol, ...]
    l_t: tuple[Symbol, ...]
    k_sp: tuple[Symbol, ...]
    w_b: tuple[Symbol, ...]
    R_p: tuple[Symbol, ...]
    I_p: tuple[Symbol, ...]
    I_m: tuple[Symbol, ...]
    i_g: tuple[Symbol, ...]
    driven: tuple[tuple[Symbol, ...], ...]
    x_min: tuple[Symbol, ...]
    x_max: tuple[Symbol, ...]
    sigma: tuple[Symbol, ...]

    @property
    def indices(self) -> range:
        """Indices of the axes."""
        return range(len(self.n))


def declare_axes(m: Machine, count: int, words: Words) -> Axes:
    """Declare the tables of the axes."""
    m.vocabulary.letters["k"] = "pulley k, or carriage k of a derivative"
    axis = m.tables.repeated("axis", count, "one axis: a rail with its belt and pulleys")
    o = axis.vector("origin", "o", "point of rail {j} where x_{j} = 0", "o_{j}")
    n = axis.direction("direction", "n", "unit vector along rail {j}", "n_{j}")
    b = axis.vector("joint", "b", words.joint, "b_{j}")
    link = axis.shared("link", words.link)
    l_d = link.quantity("length", "l_d", "length", words.length, latex="l_{{d,{j}}}", above=0.0)
    m_d = link.quantity("mass", "m_d", "mass", words.mass, latex="m_{{d,{j}}}", at_least=0.0)
    carriage = axis.shared("carriage", "one carriage")
    m_t = carriage.quantity("mass", "m_t", "mass", "mass of carriage {j}", latex="m_{{t,{j}}}", at_least=0.0)
    l_t = carriage.quantity(
        "length", "l_t", "length", "length of carriage {j} along its rail", latex="l_{{t,{j}}}", at_least=0.0
    )
    k_sp, w_b = timing_belt(axis)
    R_p, I_p = pulley(
        axis,
        "each of the two pulleys of an axis",
        "radius of the pulleys of axis {j}",
        "moment of inertia of each pulley of axis {j}",
    )
    I_m, i_g = geared_motor(
        axis,
        "motor and gearbox of an axis",
        "moment of inertia of motor {j} at the motor shaft",
        "gear ratio of axis {j}, motor over driven pulley",
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
    return Axes(o, n, b, l_d, m_d, m_t, l_t, k_sp, w_b, R_p, I_p, I_m, i_g, driven, x_min, x_max, sigma)


def coordinates(m: Machine, count: int) -> tuple[tuple[Symbol, ...], tuple[tuple[Symbol, ...], ...]]:
    """Declare carriage positions and pulley rotations (equations 29 and 32): x_j, and theta_j_k as [k-1][j-1]."""
    indices = range(count)
    m.generalised(
        [
            ("x_{j}", "m", "position of carriage {j} along its rail", "{{x}}_{j}", {"j": j + 1})
            for j in indices
        ],
        [
            (
                "theta_{j}_{k}",
                "rad",
                "rotation of pulley {k} of axis {j}",
                r"{{\vartheta}}_{{{j},{k}}}",
                {"j": j + 1, "k": k},
            )
            for k in (1, 2)
            for j in indices
        ],
    )
    x = m.coordinates[:count]
    m.moves_platform(x, "x", "carriage positions")
    return x, (m.coordinates[count : 2 * count], m.coordinates[2 * count :])


def close(
    m: Machine, axes: Axes, x: Sequence[Symbol], p: Sequence[Symbol], lever: Sequence[Sequence[Symbol]]
) -> tuple[Symbol, ...]:
    """Close the loops (equations 1 to 3) and invert the kinematics; return the squared distances from the rails.

    Rail j meets the sphere of radius l_d around platform joint j (section 2.2 of the paper, after figure 4).
    """
    r = m.vectors("r", "m", "platform joint {j} relative to the origin of rail {j}", "r_{j}")
    s = m.vectors("s", "m", "linkage vector {j}, from carriage to platform joint", "s_{j}")
    for j in axes.indices:
        m.define_all(r[j], (p[i] + lever[j][i] - axes.o[j][i] for i in range(3)))
    for j in axes.indices:
        m.define_all(s[j], (r[j][i] - x[j] * axes.n[j][i] for i in range(3)))
        m.unit_vector(axes.n[j])
        m.link(s[j], axes.l_d[j], x[j], lever[j] if m.turning is not None else ())
    along = m.each("a", "m", "coordinate of platform joint {j} along rail {j}", "a_{j}")
    across = m.vectors("w", "m", "vector from rail {j} to platform joint {j}, perpendicular to it", "w_{j}")
    distance2 = m.each("w2", "m^2", "squared distance of platform joint {j} from rail {j}", r"|w_{j}|^2")
    for j in axes.indices:
        n = axes.n[j]
        m.inverse[along[j]] = dot(n, r[j])
        m.inverse.update(zip(across[j], (r[j][i] - along[j] * n[i] for i in range(3)), strict=True))
        m.inverse[distance2[j]] = dot(across[j], across[j])
        m.inverse[x[j]] = along[j] + axes.sigma[j] * sqrt(axes.l_d[j] ** 2 - distance2[j])
    return distance2


def bodies(
    m: Machine, axes: Axes, x: Sequence[Symbol], p: Sequence[Symbol], lever: Sequence[Sequence[Symbol]]
) -> None:
    """Add carriages and links (equations 24 and 26)."""
    for j in axes.indices:
        e = tuple(axes.o[j][i] + x[j] * axes.n[j][i] for i in range(3))
        c = tuple(p[i] + lever[j][i] for i in range(3))
        m.points.append(PointMass(axes.m_t[j], e, f"carriage_{j + 1}"))
        m.rods.append(Rod(axes.m_d[j], (e, c), f"link_{j + 1}"))
        m.seats.append(Seat(f"carriage_{j + 1}", m.links[j], points=[m.points[-1]], ends=[(m.rods[-1], 0)]))


def belts(
    m: Machine,
    axes: Axes,
    x: Sequence[Symbol],
    theta: Sequence[Sequence[Symbol]],
    lever: Sequence[Sequence[Symbol]],
) -> list[Axis]:
    """Add belts, pulleys and motors (equations 28 to 30 and 34 to 41), and return what is drawn of the axes."""
    v = m.vocabulary
    moment = "moment of inertia of pulley {k} of axis {j}, including the motor if it is driven"
    torque = m.each("tau_st", "N m", "static torque on the driven pulley of axis {j}", r"\tau_{{st,{j}}}")
    drawn_axes = []
    for j in axes.indices:
        rotors = [
            m.rotor(
                theta[k][j],
                axes.I_p[j],
                v.declare("I_{j}_{k}", "kg m^2", moment, "I_{{p,{j},{k}}}", j=j + 1, k=k + 1),
                f"pulley_{j + 1}_{k + 1}",
                f"pulley {k + 1} of axis {j + 1}",
                axes.n[j],
            )
            for k in (0, 1)
        ]
        m.rail(x[j])
        m.drive(list(zip(rotors, axes.driven[j], strict=True)), axes.i_g[j] ** 2 * axes.I_m[j], torque[j])
        clamp = Clamp()
        carriage_end = ({x[j]: 1}, clamp)
        rim_1, rim_2 = (({theta[k][j]: axes.R_p[j]}, rotors[k].bearing) for k in (0, 1))
        # Between the pulleys the belt goes back: a bearing that moves along the rail moves that end the other way.
        reversed_1, reversed_2 = ((form, bearing.reversed) for form, bearing in (rim_1, rim_2))
        half_carriage = HALF * axes.l_t[j]
        free_lengths = (
            axes.x_max[j] - axes.x_min[j],
            x[j] - axes.x_min[j] - half_carriage,
            axes.x_max[j] - x[j] - half_carriage,
        )
        ends = ((reversed_2, reversed_1), (carriage_end, rim_2), (rim_1, carriage_end))
        runs = [
            Run(*_span(m, j + 1, k), length, pair)
            for k, (length, pair) in enumerate(zip(free_lengths, ends, strict=True), 1)
        ]
        m.belt(axes.w_b[j] * axes.k_sp[j], runs, clamp)
        for k in (0, 1):  # with rigid belts
            m.follows[theta[k][j]] = x[j] / axes.R_p[j]
        rotations = (theta[0][j], theta[1][j])
        pulley_positions = (axes.x_max[j], axes.x_min[j])
        drawn_axes.append(
            Axis(
                axes.o[j],
                axes.n[j],
                x[j],
                pulley_positions,
                axes.R_p[j],
                rotations,
                lever[j],
                axes.l_d[j],
                axes.l_t[j],
                runs,
                clamp,
            )
        )
    return drawn_axes


def _span(m: Machine, j: int, s: int) -> tuple[Symbol, Symbol]:
    """Declare the names of the free length and the stiffness of a belt span."""
    span = "span {s} of belt {j} (1 between the pulleys, 2 from carriage to pulley 2, 3 from carriage to pulley 1)"
    declare = m.vocabulary.declare
    return (
        declare("l_f_{j}_{s}", "m", f"free length of {span}", "l_{{f,{j},{s}}}", j=j, s=s),
        declare("k_{j}_{s}", "N/m", f"stiffness of {span}", "k_{{{j},{s}}}", j=j, s=s),
    )


def conditions(m: Machine, axes: Axes, distance2: Sequence[Symbol], joint: str) -> None:
    """Declare the margins of a pose and the requirements of a robot; `joint` says what the joints' radius is."""
    x = m.independent
    m.extras += [
        Extra(
            "reach_margin",
            "Distance by which each platform joint could be farther from its rail.",
            "closure of equation 2; a pose is reachable if every margin is at least zero",
            (
                Output(
                    "margin",
                    (len(x),),
                    tuple(axes.l_d[j] - sqrt(distance2[j]) for j in axes.indices),
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
                    (len(x),),
                    tuple(axes.x_max[j] - axes.x_min[j] - axes.l_t[j] for j in axes.indices),
                    "m",
                    "max - min - l_t for each axis; positive for a robot that can move",
                ),
            ),
            arguments=(),
            definitions={},
        ),
    ]
    m.parameter_groups = (
        ParameterGroup(
            "axis.span", "span", "limits", "m", "max - min of every axis, with both ends moved evenly"
        ),
        ParameterGroup("axis.joint_radius", "radius", "joint", "m", joint),
    )
    m.scales = tuple(Scale(x[j].name, "pulley_radius", (j,), "R_p") for j in axes.indices)
    m.margins += _margins(len(x))
    m.requirements += (
        Requirement(
            "travel_margin",
            "above_zero",
            tuple(f"axis.{j + 1}.limits" for j in axes.indices),
            "expected a carriage shorter than the travel, found a length of {carriage.length}",
            "check the limits and carriage.length",
            "m",
        ),
    )


def _margins(count: int) -> tuple[Margin, ...]:
    numbers = tuple(str(j + 1) for j in range(count))
    return (
        Margin(
            "reachable",
            "reach_margin",
            0,
            "at_least_zero",
            "the pose is out of reach: a link is too short",
            "the pose is out of reach: link {0} is {missing} too short",
            "choose a pose closer to the rails",
            (numbers,),
        ),
        SINGULAR,
        Margin(
            "limits",
            "belt_spans",
            0,
            "above_zero",
            "a carriage is beyond its limits: a belt span would not have a positive length",
            "carriage {0} is beyond its limits: the belt span {1} would be {short}",
            "choose a pose within the travel of the carriages, or check limits and carriage length",
            (
                numbers,
                (
                    "between its pulleys",
                    "between its carriage and pulley 2",
                    "between its carriage and pulley 1",
                ),
            ),
        ),
    )
