"""One robot with effects: the functions of the base model, in its own coordinates, and a few that effects need.

Coordinates that have no inertia are condensed, exactly, so that the matrices are those of an eigenproblem.
"""

from __future__ import annotations

from collections.abc import Sequence, Set

from pkmodes_derive.effect import Effect
from pkmodes_derive.functions import FieldGroup, Function, Model, Output
from pkmodes_derive.linear_delta import energy, kinematics, statics
from pkmodes_derive.linear_delta.catalogue import chapters, position
from pkmodes_derive.linear_delta.catalogue.collected import Collected, flat
from pkmodes_derive.linear_delta.machine import Machine
from pkmodes_derive.linear_delta.symbols import Symbols

UNITS_K = "N/m, N, N m"


def derive_single(effects: Sequence[Effect], zeros: Set[tuple[str, int]]) -> Model:
    """Derive the model of one robot with effects.

    Parameters
    ----------
    effects : sequence of Effect
        Those that are active.
    zeros : set of (field, index)
        Parameters that are zero for this robot.
    """
    sy = Symbols()
    machine = Machine(sy, effects)
    kin = kinematics.derive(machine)
    energies = energy.derive(machine, kin)
    absent = {
        symbol
        for field in (*sy.fields, *machine.fields)
        for i, symbol in enumerate(field.symbols)
        if (field.name, i) in zeros
    }
    c = Collected(machine, kin, energies, statics.derive(machine, kin, energies), absent)
    every = tuple(q.name for q in c.all_coordinates)
    return Model(
        mechanism="linear_delta",
        coordinates=tuple((q.name, sy.vocabulary[q].unit) for q in c.coordinates),
        vocabulary=sy.vocabulary,
        groups=(
            FieldGroup("Parameters", "parameters", sy.fields),
            FieldGroup("Effects", "effects", machine.fields, null=0.0),
        ),
        functions=(
            *chapters(c),
            position.travel(sy),
            _platform_motion(c),
            *(_uncondensed(c) if c.massless else ()),
        ),
        rigid_modes=c.rigid_modes,
        constants=(
            (
                "All coordinates, those without inertia included, as `condensation` has them.",
                "ALL_COORDINATES",
                every,
            ),
        )
        if c.massless
        else (),
        notes=_notes(c),
    )


def _notes(c: Collected) -> tuple[str, ...]:
    """What the effects change in the use of the code."""
    active = "; ".join(f"{effect.name}: {effect.sentence}" for effect in c.machine.effects)
    notes = [
        f"With effects ({active}).  Coordinates that they add are relative and zero at the pose.  "
        "`platform_jacobian` is by the carriages alone, `platform_motion` by every coordinate above."
    ]
    if c.massless:
        names = ", ".join(q.name for q in c.massless)
        every = ", ".join(q.name for q in c.all_coordinates)
        notes.append(
            f"Without inertia: {names}.  They follow the others without delay and add no mode, so all functions "
            "have the coordinates above only; M is positive definite, and K is what is felt with the others in "
            "equilibrium (condensed exactly)."
        )
        notes.append(
            f"In all {len(every.split(', '))} coordinates ({every}): the matrices by `uncondensed_matrices`, M with "
            "rows of zeros, which no eigen-solver takes; a shape by `condensation` times the shape of the others."
        )
    return tuple(notes)


def _platform_motion(c: Collected) -> Function:
    """The absolute motion of the platform: what moves it has its mass, so no massless coordinate does."""
    entries = tuple(c.kin.chain.derivative(v, rate) for v in c.machine.v_p for rate in c.rates)
    return c.function(
        "platform_motion",
        "Absolute motion of the platform centre by the coordinates.",
        "equation 15, with what released joints and the frame add",
        [c.pose],
        Output("J_p", (3, c.n), entries, "1, m", "dp_i/dq_k, base frame"),
    )


def _uncondensed(c: Collected) -> list[Function]:
    """The matrices with every coordinate, and how those without inertia follow."""
    n = len(c.all_coordinates)
    return [
        c.function(
            "uncondensed_matrices",
            "Mass and stiffness matrices in all coordinates: M has rows of zeros, and no inverse.",
            "equation 48, with the effects' energies",
            [c.pose],
            Output("M", (n, n), flat(c.M_all), c.units_M, "mass matrix"),
            Output("K", (n, n), flat(c.K_all), UNITS_K, "stiffness matrix"),
        ),
        c.function(
            "condensation",
            "All coordinates by those with inertia.",
            "K_rr x_r + K_rq x_q = 0 for the coordinates r without inertia",
            [c.pose],
            Output(
                "T",
                (n, c.n),
                flat(c.condensation),
                "1, m, 1/m",
                "all coordinates are T times those with inertia; T^T K T of the uncondensed K is the condensed one",
            ),
        ),
    ]
