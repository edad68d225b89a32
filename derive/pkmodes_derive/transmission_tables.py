"""Tables of transmissions that several mechanisms have: timing belts, pulleys, motors."""

from __future__ import annotations

from pkmodes_derive.tables import Repeated, Symbols


def timing_belt(table: Repeated) -> tuple[Symbols, Symbols]:
    """Declare ``belt``, shared by the entries of a table: specific stiffness [N/m] and width [m]."""
    belt = table.shared("belt", "one timing belt")
    k_sp = belt.quantity(
        "specific_stiffness",
        "k_sp",
        "specific stiffness",
        "specific stiffness of belt {j}: k = w_b k_sp / free length",
        latex="k_{{sp,{j}}}",
        above=0.0,
    )
    return k_sp, belt.quantity("width", "w_b", "length", "width of belt {j}", latex="w_{{b,{j}}}", above=0.0)


def pulley(table: Repeated, what: str, radius: str, inertia: str) -> tuple[Symbols, Symbols]:
    """Declare ``pulley`` likewise, with descriptions: radius [m] and moment of inertia [kg m^2]."""
    table_of_pulley = table.shared("pulley", what)
    R_p = table_of_pulley.quantity("radius", "R_p", "length", radius, latex="R_{{p,{j}}}", above=0.0)
    return R_p, table_of_pulley.quantity(
        "inertia", "I_p", "moment of inertia", inertia, latex="I_{{p,{j}}}", above=0.0
    )


def geared_motor(
    table: Repeated, what: str, inertia: str, ratio: str, *, alone: bool = False
) -> tuple[Symbols, Symbols]:
    """Declare ``motor`` likewise, with descriptions: moment of inertia at its shaft [kg m^2] and gear ratio.

    A motor that is `alone` on its rotor must have inertia; a pulley beside it has some of its own.
    """
    motor = table.shared("motor", what)
    I_m = motor.quantity(
        "inertia",
        "I_m",
        "moment of inertia",
        inertia,
        latex="I_{{m,{j}}}",
        at_least=None if alone else 0.0,
        above=0.0 if alone else None,
    )
    return I_m, motor.quantity(
        "gear_ratio", "i_g", "number", ratio, latex="i_{{g,{j}}}", field="gear_ratio", above=0.0
    )
