"""Coriolis and centrifugal forces of a platform that turns: `lagrangian.velocity_forces_of_twist` with names."""

from __future__ import annotations

from sympy import Add, Expr, Symbol

from pkmodes_derive import lagrangian
from pkmodes_derive.assembly.condensed import Condensed
from pkmodes_derive.turning import Turning
from pkmodes_derive.vectors import cross


def forces_of_twist(c: Condensed, turning: Turning, velocities: tuple[Symbol, ...]) -> list[Expr]:
    """Return the velocity forces of a platform that turns."""
    m, kin = c.machine, c.kin
    twist = (*m.v_p, *turning.rates)
    moving = kin.chain.copy(rules=False)
    for q, rate in zip(m.independent, velocities, strict=True):
        moving.rule(q, lagrangian.TIME, rate)
    for symbol, (q, derivative) in m.turned.items():
        moving.rule(symbol, q, derivative)
        moving.rule(symbol, lagrangian.TIME, derivative * m.velocities[m.coordinates.index(q)])
    for i, (t, row) in enumerate(zip(twist, c.energies.D_p_dot, strict=True)):
        what = "acceleration of the platform at constant rates of the coordinates, component {i}"
        unit = "m/s^2" if i < len(m.directions) else "rad/s^2"
        bias = m.vocabulary.declare("a_p_{i}", unit, what, "a_{{p,{i}}}", i=m.components[i])
        kin.chain.define(bias, Add(*(d * rate for d, rate in zip(row, velocities, strict=True))))
        moving.rule(t, lagrangian.TIME, bias)
    for p, t in zip(m.dependent, m.v_p, strict=False):
        moving.rule(p, lagrangian.TIME, t)
    for vector in turning.fixed:
        rate_of_vector = cross(turning.spatial(turning.rates), vector)
        for component, rate in zip(vector, rate_of_vector, strict=True):
            if component.is_Symbol:
                moving.rule(component, lagrangian.TIME, rate)

    def named(what: str, i: int, value: Expr) -> Expr:
        unit = "kg m/s" if what == "momentum" else "N"
        if i >= len(m.directions):
            unit = "kg m^2/s" if what == "momentum" else "N m"
        symbol, stem = ("pi", r"\pi") if what == "momentum" else ("z", "z")
        name = m.vocabulary.declare(
            f"{symbol}_{{i}}",
            unit,
            f"{what} of the moving bodies, component {{i}}",
            f"{stem}_{{i}}",
            i=m.components[i],
        )
        moving.define(name, value)
        return kin.chain.define(name, value)

    h = lagrangian.velocity_forces_of_twist(
        c.moving_energy, m.independent, velocities, twist, m.dependent, kin.D_p, turning, moving, named
    )
    c.definitions = kin.definitions
    return h
