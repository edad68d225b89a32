r"""CoreXY: a tool head on a gantry, pulled by two crossed belts with stationary motors.

The gantry runs along y and carries the tool head along x.  From the tool head each belt goes to its motor pulley on
either side: run 1 grows by :math:`g_i \cdot (\delta x, \delta y)`, run 2 shrinks by the same amount, and the pulley
pulls run 1 in by :math:`R\,\delta\vartheta_i`, so the strains of both runs are equal and opposite.
"""

from __future__ import annotations

from sympy import Expr, Integer, Rational, Symbol

from pkmodes_derive.description import Margin, Requirement, Scale
from pkmodes_derive.functions import Output
from pkmodes_derive.machine import Extra, Machine
from pkmodes_derive.mechanisms.corexy.picture import Path, draw
from pkmodes_derive.mechanisms.corexy.sample import SAMPLE
from pkmodes_derive.parts import Clamp, PointMass, Run

__all__ = ["DIRECTIONS", "TITLE", "declare"]

TITLE = "tool head on a gantry, two crossed belts and motors"
DIRECTIONS = ("x", "y")
PATHS = range(2)
HALF = Rational(1, 2)


def declare(m: Machine) -> None:
    """Declare the CoreXY."""
    v = m.vocabulary
    v.letters |= {"j": "belt j", "s": "run s of a belt", "i": "component i = x, y"}

    # The robot file -----------------------------------------------------------------------------------------
    (m_h,) = m.tables.single("toolhead", "the tool head").quantity(
        "mass", "m_h", "mass", "mass of the tool head", above=0.0
    )
    (m_g,) = m.tables.single("gantry", "the beam with its rail, which moves along y only").quantity(
        "mass", "m_g", "mass", "mass of the gantry", at_least=0.0
    )
    m.add_gravity()
    path = m.tables.repeated("belt_path", 2, "one belt, from the tool head to its motor pulley and back")
    g = path.signs(
        "direction",
        "g",
        2,
        "run 1 of belt {j} grows (+1) or shrinks (-1) along component {k}",
        "g_{{{j},{k}}}",
    )
    length = path.lengths(
        "lengths",
        "l_0",
        2,
        "free length of run {k} of belt {j} with the tool head at x = y = 0",
        "l_{{0,{j},{k}}}",
    )
    belt = path.shared("belt", "one timing belt")
    k_sp = belt.quantity(
        "specific_stiffness",
        "k_sp",
        "specific stiffness",
        "specific stiffness of belt {j}: k = w_b k_sp / free length",
        latex="k_{{sp,{j}}}",
        above=0.0,
    )
    w_b = belt.quantity("width", "w_b", "length", "width of belt {j}", latex="w_{{b,{j}}}", above=0.0)
    pulley = path.shared("pulley", "the motor pulley of a belt")
    R_p = pulley.quantity(
        "radius", "R_p", "length", "radius of motor pulley {j}", latex="R_{{p,{j}}}", above=0.0
    )
    I_p = pulley.quantity(
        "inertia",
        "I_p",
        "moment of inertia",
        "moment of inertia of motor pulley {j}",
        latex="I_{{p,{j}}}",
        above=0.0,
    )
    motor = path.shared("motor", "the motor of a belt")
    I_m = motor.quantity(
        "inertia",
        "I_m",
        "moment of inertia",
        "moment of inertia of motor {j} at its shaft",
        latex="I_{{m,{j}}}",
        at_least=0.0,
    )
    i_g = motor.quantity(
        "gear_ratio",
        "i_g",
        "number",
        "gear ratio of motor {j}, motor over pulley",
        latex="i_{{g,{j}}}",
        field="gear_ratio",
        above=0.0,
    )
    low, high = m.tables.single("workspace", "travel of the tool head").ranges(
        ("x", "y"), "travel", "the travel along {i}", "{i}"
    )
    m.add_frame()

    # Coordinates; the first two are the pose -----------------------------------------------------------------
    m.generalised(
        [
            ("x", "m", "position of the tool head along x", "{x}", {}),
            ("y", "m", "position of the tool head and gantry along y", "{y}", {}),
        ],
        [
            ("theta_{j}", "rad", "rotation of motor pulley {j}", r"{{\vartheta}}_{j}", {"j": i + 1})
            for i in PATHS
        ],
    )
    x, y, *theta = m.coordinates
    m.independent_pose((x, y), "tool head in the base frame")
    m.moves_platform((x, y), "xy", "positions")

    # Bodies ------------------------------------------------------------------------------------------------------
    zero = Integer(0)
    m.platform = (x, y, zero)
    m.points.append(PointMass(m_h, m.platform))
    m.points.append(PointMass(m_g, (zero, y, zero)))
    m.rail(x)
    m.rail(y)

    # Belts, pulleys and motors --------------------------------------------------------------------------------
    torque = [
        v.declare("tau_st_{j}", "N m", "static torque on motor pulley {j}", r"\tau_{{st,{j}}}", j=i + 1)
        for i in PATHS
    ]
    drawn = []
    for i in PATHS:
        moment = "moment of inertia of motor pulley {j}, including the motor"
        rotor = m.rotor(theta[i], I_p[i], v.declare("I_{j}", "kg m^2", moment, "I_{j}", j=i + 1))
        m.drive([(rotor, Integer(1))], i_g[i] ** 2 * I_m[i], torque[i])
        clamp = Clamp()
        g_x, g_y = g[i]
        head, rim = ({x: g_x, y: g_y}, clamp), ({theta[i]: -R_p[i]}, None)
        pull = g_x * x + g_y * y
        runs = []
        for k, free in enumerate((length[i][0] + pull, length[i][1] - pull), start=1):
            place = {"j": i + 1, "s": k}
            l_f = v.declare(
                "l_f_{j}_{s}", "m", "free length of run {s} of belt {j}", "l_{{f,{j},{s}}}", **place
            )
            stiffness = v.declare(
                "k_{j}_{s}", "N/m", "stiffness of run {s} of belt {j}", "k_{{{j},{s}}}", **place
            )
            runs.append(Run(l_f, stiffness, free, (head, rim)))
        m.belt(w_b[i] * k_sp[i], runs, clamp)
        m.follows[theta[i]] = -pull / R_p[i]
        drawn.append(Path(g[i], R_p[i], theta[i], runs, clamp))
    draw(m, (low, high), drawn)

    # Conditions on a pose and on a robot ---------------------------------------------------------------------
    travel = tuple(margin for i, q in enumerate((x, y)) for margin in (q - low[i], high[i] - q))
    least = [
        length[i][k] + HALF * (side * _sum(g[i], low, high) - (high[0] - low[0]) - (high[1] - low[1]))
        for i in PATHS
        for k, side in enumerate((1, -1))
    ]
    crossed = (g[0][0] * g[1][1] - g[0][1] * g[1][0]) ** 2 - 1
    m.extras += [
        Extra(
            "travel_margin",
            "Distance of the tool head from the ends of its travel.",
            "both ends of the workspace",
            (
                Output(
                    "margin", (2, 2), travel, "m", "for x and y: above the lower end and below the upper end"
                ),
            ),
        ),
        Extra(
            "run_margin",
            "Shortest free length of each run in the whole workspace.",
            "the lengths are linear in x and y, so the shortest is at a corner",
            (Output("margin", (2, 2), tuple(least), "m", "for runs 1 and 2 of each belt; must be positive"),),
            arguments=(),
            definitions={},
        ),
        Extra(
            "crossing_margin",
            "Linear independence of the directions of the two belts.",
            "square of the determinant of the two directions, 0 or 4, minus 1",
            (Output("margin", (1,), (crossed,), "1", "positive for independent directions"),),
            arguments=(),
            definitions={},
        ),
    ]
    m.scales = tuple(Scale(q.name, "pulley_radius", (0,), "R_p") for q in (x, y))
    m.margins = (
        Margin(
            "limits",
            "travel_margin",
            0,
            "at_least_zero",
            "the tool head is beyond its travel",
            "the tool head is beyond the {1} end of its travel along {0} by {missing}",
            "choose a pose within the workspace, or check its limits",
            (("x", "y"), ("lower", "upper")),
        ),
    )
    m.requirements = (
        Requirement(
            "run_margin",
            "above_zero",
            tuple(f"belt_path.{i + 1}.lengths.{k}" for i in PATHS for k in (1, 2)),
            "expected a positive free length in the whole workspace, found a run that is {missing} too short",
            "check lengths, direction and workspace",
            "m",
        ),
        Requirement(
            "crossing_margin",
            "above_zero",
            ("belt_path.2.direction",),
            "expected independent directions of the two belts, found the same or opposite directions",
            "write, for example, [1, -1] and [-1, -1]",
            "1",
        ),
    )
    m.sample = SAMPLE


def _sum(direction: tuple[Symbol, ...], low: tuple[Symbol, ...], high: tuple[Symbol, ...]) -> Expr:
    """Return twice the pull at the centre of the workspace."""
    return direction[0] * (low[0] + high[0]) + direction[1] * (low[1] + high[1])
