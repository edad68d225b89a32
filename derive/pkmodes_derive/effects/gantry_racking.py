"""Gantry racking: the beam of a gantry turns about the vertical through its middle, and takes along what it carries.

The head at x is displaced by psi (x - x_c) along y, to first order in the angle psi.  The coordinate is psi_b, b for
beam: gearboxes have psi with a number.
"""

from collections.abc import Mapping, Sequence

from sympy import Expr, Rational, Symbol

from pkmodes_derive.effect import Coordinate, Effect, EffectParameter, Positive, Released
from pkmodes_derive.machine import Machine
from pkmodes_derive.parts import Beam


def beams(machine: Machine) -> list[Beam]:
    """Return the beam whose load moves freely with it: closed loops would hold the load."""
    return [machine.beam] if machine.beam is not None and not machine.links else []


def apply(machine: Machine, parameters: Mapping[str, Symbol], released: Sequence[Coordinate]) -> None:
    """Turn the beam and all that lies on it, and add the beam's rotational inertia."""
    (coordinate,), (beam,) = released, beams(machine)
    beam.released.append(coordinate)
    beam.middle = parameters["center"]
    what = "distance of what slides along the beam from the beam's middle"
    beam.lever = machine.define(machine.vocabulary.declare("b", "m", what, "b"), beam.along - beam.middle)

    def moved(position: Sequence[Expr]) -> tuple[Expr, ...]:
        on_beam = any(machine.chain.derivative(component, beam.across) != 0 for component in position)
        return beam.turned(position) if on_beam else tuple(position)

    machine.platform = moved(machine.platform)
    for body in machine.points:
        if body is not beam.body:
            body.position = moved(body.position)
    machine.draw.move(moved)
    machine.add_kinetic(Rational(1, 2) * parameters["inertia"] * coordinate.rate**2)


EFFECT = Effect(
    name="gantry_racking",
    sentence="the beam of the gantry racks on its guides",
    parts=beams,
    parameters=(
        EffectParameter(
            "compliance", "rad/(N m)", "compliance of the beam's guides in rotation", "c_B", "c_B"
        ),
        EffectParameter(
            "inertia", "kg m^2", "moment of inertia of the beam about its middle", "J_B", "J_B", fitted=False
        ),
        EffectParameter("center", "m", "position of the beam's middle along it", "x_B", "x_B", None, False),
    ),
    apply=apply,
    released=Released("psi_b", "rad", "rotation of the beam about the vertical", r"\psi_b", order=5),
    needs=Positive(
        lambda parameters: parameters["inertia"],
        "inertia",
        "expected the beam's moment of inertia about its middle above 0, found {value}",
        "declare inertia in the table of the beam; that of a uniform beam is mass * length^2 / 12",
        "kg m^2",
    ),
)
