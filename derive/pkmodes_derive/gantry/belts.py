r"""Two belts, each with a motor pulley that divides it into run 1 and run 2.

A belt is fastened to what it moves at both ends.  When that moves by :math:`\delta s`, run 1 grows by
:math:`\delta s`, run 2 shrinks by the same amount, and the pulley pulls run 1 in by :math:`R\,\delta\vartheta_i`, so
the strains of both runs are equal and opposite.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from sympy import Add, Integer, Symbol

from pkmodes_derive.machine import Machine
from pkmodes_derive.parts import Clamp, Form, Run
from pkmodes_derive.tables import Repeated
from pkmodes_derive.transmission_tables import geared_motor, pulley, timing_belt

BELTS = range(2)
#: Meaning of the index letters.
LETTERS = {"j": "belt j", "s": "run s of a belt", "i": "component i = x, y"}


@dataclass(frozen=True)
class Belts:
    """Quantities of the robot file, one for each belt.

    Attributes
    ----------
    table : str
        The repeated table, with an entry for each belt.
    lengths : tuple of tuple of sympy.Symbol
        Free lengths of both runs with the machine at x = y = 0 [m].
    k_sp, w_b : tuple of sympy.Symbol
        Specific stiffness [N/m] and width [m].
    R_p, I_p : tuple of sympy.Symbol
        Radius [m] and moment of inertia [kg m^2] of the motor pulley.
    I_m, i_g : tuple of sympy.Symbol
        Moment of inertia of the motor at its shaft [kg m^2], and gear ratio, motor over pulley.
    """

    table: str
    lengths: tuple[tuple[Symbol, ...], ...]
    k_sp: tuple[Symbol, ...]
    w_b: tuple[Symbol, ...]
    R_p: tuple[Symbol, ...]
    I_p: tuple[Symbol, ...]
    I_m: tuple[Symbol, ...]
    i_g: tuple[Symbol, ...]


@dataclass(frozen=True)
class FastenedBelt:
    """A belt on the machine.

    Attributes
    ----------
    pull : Form
        Growth of run 1 per unit of each coordinate.
    radius : sympy.Symbol
        Radius of the motor pulley [m].
    turns : sympy.Symbol
        Rotation of the motor pulley [rad].
    runs : sequence of Run
        Run 1 and run 2.
    clamp : Clamp
        The clamp on what the belt moves.
    """

    pull: Form
    radius: Symbol
    turns: Symbol
    runs: Sequence[Run]
    clamp: Clamp


def declare(table: Repeated, lengths_are: str) -> Belts:
    """Declare the keys of the belts: lengths of their runs, and the shared tables belt, pulley and motor."""
    lengths = table.lengths("lengths", "l_0", 2, lengths_are, "l_{{0,{j},{k}}}")
    k_sp, w_b = timing_belt(table)
    R_p, I_p = pulley(
        table,
        "the motor pulley of a belt",
        "radius of motor pulley {j}",
        "moment of inertia of motor pulley {j}",
    )
    I_m, i_g = geared_motor(
        table,
        "the motor of a belt",
        "moment of inertia of motor {j} at its shaft",
        "gear ratio of motor {j}, motor over pulley",
    )
    return Belts(table.name, lengths, k_sp, w_b, R_p, I_p, I_m, i_g)


def fasten(m: Machine, belts: Belts, turns: Sequence[Symbol], pulls: Sequence[Form]) -> list[FastenedBelt]:
    """Add the belts with their motor pulleys and motors.

    Parameters
    ----------
    turns : sequence of sympy.Symbol
        Rotations of the motor pulleys, positive where the pulley pulls run 1 in [rad].
    pulls : sequence of Form
        Of each belt, the growth of run 1 per unit of each coordinate.
    """
    v, fastened = m.vocabulary, []
    torque = [
        v.declare("tau_st_{j}", "N m", "static torque on motor pulley {j}", r"\tau_{{st,{j}}}", j=i + 1)
        for i in BELTS
    ]
    for i in BELTS:
        moment = "moment of inertia of motor pulley {j}, including the motor"
        name = v.declare("I_{j}", "kg m^2", moment, "I_{j}", j=i + 1)
        words = f"the motor pulley of belt {i + 1}"
        rotor = m.rotor(turns[i], belts.I_p[i], name, f"pulley_{i + 1}", words)
        m.drive([(rotor, Integer(1))], belts.i_g[i] ** 2 * belts.I_m[i], torque[i])
        clamp = Clamp()
        rim = {turns[i]: -belts.R_p[i]}
        growth = Add(*(factor * q for q, factor in pulls[i].items()))
        runs = []
        for k, sign in enumerate((1, -1)):
            place = {"j": i + 1, "s": k + 1}
            l_f = v.declare(
                "l_f_{j}_{s}", "m", "free length of run {s} of belt {j}", "l_{{f,{j},{s}}}", **place
            )
            stiffness = v.declare(
                "k_{j}_{s}", "N/m", "stiffness of run {s} of belt {j}", "k_{{{j},{s}}}", **place
            )
            # Both runs leave the motor pulley to the same side: its bearing moves both their ends away from it.
            bearing = rotor.bearing if sign < 0 else rotor.bearing.reversed
            ends = (pulls[i], clamp), (rim, bearing)
            runs.append(Run(l_f, stiffness, belts.lengths[i][k] + sign * growth, ends))
        m.belt(belts.w_b[i] * belts.k_sp[i], runs, clamp)
        m.follows[turns[i]] = -growth / belts.R_p[i]
        fastened.append(FastenedBelt(pulls[i], belts.R_p[i], turns[i], runs, clamp))
    return fastened
