"""The three models of a mechanism: without effects, with all effects, and for one robot with some effects."""

from __future__ import annotations

from collections.abc import Callable, Set

from sympy import Add, Integer, Symbol, default_sort_key, diff

from pkmodes_derive.assembly import chapters
from pkmodes_derive.assembly.condensed import Condensed
from pkmodes_derive.assembly.derivatives import derivatives
from pkmodes_derive.assembly.derived import (
    Derived,
    derive,
    drive_words,
    flattened,
    units_of_mass,
    units_of_stiffness,
)
from pkmodes_derive.assembly.dissipation import dissipation, loss_of_joints
from pkmodes_derive.assembly.kinematics import Kinematics
from pkmodes_derive.functions import FieldGroup, Function, Model, Output, Relation
from pkmodes_derive.machine import Machine
from pkmodes_derive.sample_robot import normalised_sample
from pkmodes_description import Description, Drawing, Named, Term

Relations = Callable[[Machine, Kinematics], tuple[Relation, ...]]


def parameters(machine: Machine) -> FieldGroup:
    """Return the parameters as arrays."""
    return FieldGroup("Parameters", "parameters", tuple(machine.tables.fields))


def base(machine: Machine, relations: Relations | None = None) -> Model:
    """Return the model without effects; `relations` gives further results for the documentation."""
    derived = derive(machine)
    c = Condensed(derived)
    v = machine.vocabulary
    return Model(
        mechanism=machine.name,
        coordinates=tuple((q.name, v[q].unit) for q in machine.coordinates),
        vocabulary=v,
        groups=(parameters(machine),),
        functions=chapters.chapters(c),
        relations=relations(machine, derived.kin) if relations else (),
        rigid_modes=c.rigid_modes,
        conditions=machine.margins,
    )


def describe(
    machine: Machine, rigid_modes: int | None, drawing: Drawing, terms: tuple[Term, ...] = ()
) -> Description:
    """Return what the runtime needs to know about a mechanism; `machine` has every effect that applies."""
    v = machine.vocabulary
    coordinates = tuple(Named(q.name, v[q].unit, v[q].description) for q in machine.coordinates)
    pose = tuple(
        Named(axis, v[q].unit, _component(machine, axis))
        for axis, q in zip(machine.components, machine.pose, strict=True)
    )
    return Description(
        name=machine.name,
        title=machine.title,
        pose=pose,
        pose_is=machine.pose_is,
        coordinates=coordinates,
        independent=tuple(q.name for q in machine.independent),
        independent_are=machine.independent_are,
        directions=machine.directions,
        drives=tuple(
            Named(str(j), v[drive.torque].unit, _driven(v[drive.torque].description))
            for j, drive in enumerate(machine.drives, start=1)
        ),
        rigid_modes=rigid_modes or 0,
        tables=machine.tables.described(),
        parameter_groups=machine.parameter_groups,
        margins=machine.margins,
        requirements=machine.requirements,
        effects_in_order=tuple(effect.data() for effect in machine.effects),
        scales=machine.scales,
        difference_pairs=tuple(machine.differences.items()),
        sample=normalised_sample(machine),
        drawing=drawing,
        rotations=machine.rotations,
        terms=terms,
        moving_bodies=machine.moving_bodies,
    )


def _component(machine: Machine, axis: str) -> str:
    """Return what a component of the pose is."""
    if len(set(machine.moving_bodies)) > 1 and axis in machine.directions:
        body = machine.moving_bodies[machine.directions.index(axis)]
        return f"{axis} of the {body} in the base frame"
    if axis in machine.directions:
        return f"{axis} of the {machine.pose_is}"
    if len(machine.rotations) == 1:
        return f"rotation of the platform about {axis[1:]}"
    return f"component {axis[1:]} of the platform's rotation vector"


def _driven(description: str) -> str:
    """Return the part that a static load acts on, from the description of the load."""
    for words in ("static torque on ", "static force on ", "the "):
        description = description.removeprefix(words)
    return description


def extended(machine: Machine) -> Model:
    """Return the model with every effect: extended M and K, and their derivatives with respect to every parameter.

    The base model is the leading block: released coordinates are relative, so locking one deletes its row
    and column.  M and K are for free joints; the caller, who knows which joints are released, adds their
    stiffnesses 1/c to the diagonal of K.
    """
    d, v = derive(machine), machine.vocabulary
    functions, constants = derivatives(d)
    return Model(
        mechanism=machine.name,
        coordinates=tuple((q.name, v[q].unit) for q in machine.all_coordinates),
        vocabulary=v,
        groups=(
            FieldGroup("Parameters", "parameters", tuple(machine.tables.fields), declared=False),
            FieldGroup("Effects", "effects", machine.effect_fields, null=0.0),
        ),
        functions=(
            _matrices(d),
            _motion(d),
            _motors(d),
            _joints(d),
            dissipation(d),
            loss_of_joints(d),
            _static_equilibrium(d),
            *_requirement_functions(machine),
            *functions,
        ),
        constants=tuple(constants),
    )


def _matrices(d: Derived) -> Function:
    n = len(d.machine.rates)
    shape, K = (n, n), units_of_stiffness(d.machine)
    return Function(
        "extended_matrices",
        "Mass and stiffness matrices in the base and all released coordinates, with free joints.",
        "equations 24 to 48 with the effects' energies; K = K_el + K_g plus the joint stiffnesses",
        (d.pose,),
        (
            Output(
                "M",
                shape,
                flattened(d.M),
                units_of_mass(d.machine),
                "mass matrix; its leading block is that of the base model",
            ),
            Output("K_el", shape, flattened(d.K_el), K, "elastic stiffness with free joints"),
            Output("K_g", shape, flattened(d.K_g), K, "Hessian of the gravitational potential energy"),
        ),
        d.kin.definitions,
    )


def _motion(d: Derived) -> Function:
    """Return the function for the absolute motion of the platform."""
    rows = d.platform_motion(d.machine.rates)
    shape = (len(rows), len(d.machine.rates))
    return Function(
        "extended_platform_motion",
        "Jacobian of the absolute motion of the platform centre.",
        "equation 15, with the contributions of released joints and the frame",
        (d.pose,),
        (Output("J_p", shape, flattened(rows), "1, m", "dp_i/dq_k, base frame"),),
        d.kin.definitions,
    )


def _motors(d: Derived) -> Function:
    """Return the function for the angles of the motors."""
    machine = d.machine
    angles = [
        Add(*(driven * machine.rotation(rotor) for rotor, driven in drive.rotors), drive.wound)
        for drive in machine.drives
    ]
    rows = [tuple(diff(angle, small) for small in machine.small) for angle in angles]
    return Function(
        "motor_motion",
        "Jacobian of the angles of the motors, seen at the rotors that they drive.",
        "the drives that the mechanism declares; a gearbox winds up by psi_j on its output side",
        (),
        (Output("J_m", (len(rows), len(machine.small)), flattened(rows), "1", "d(motor angle)/dq_k"),),
        {},
        in_c=False,
    )


def _joints(d: Derived) -> Function:
    positions = [c.position for c in d.machine.released]
    stiffness = [diff(energy, q, q) for energy, q in zip(d.energies.V_r, positions, strict=True)]
    # Compliances in series add up, so the derivatives with respect to all of them are equal.
    one_compliance = [min(c.free_symbols, key=default_sort_key, default=None) for c in d.machine.compliances]
    rates = [Integer(0) if c is None else diff(k, c) for k, c in zip(stiffness, one_compliance, strict=True)]
    n = len(positions)
    return Function(
        "joint_stiffness",
        "Stiffnesses of the released joints, to be added to the diagonal of K.",
        "energy q^2 / (2 c) of each joint",
        (),
        (
            Output(
                "kappa", (n,), tuple(stiffness), "N/m, N m", "stiffness of each released coordinate, in order"
            ),
            Output("kappa_c", (n,), tuple(rates), "N^2/m^2, N^2 m^2", "derivatives d(kappa)/d(compliance)"),
        ),
        {},
        "Infinite for zero compliance (a locked joint).",
    )


def _requirement_functions(machine: Machine) -> list[Function]:
    """Return the conditions of effects on their parameters."""
    symbols = {field.name: field.symbols[0] for field in machine.effect_fields}
    conditions = []
    for effect in machine.effects:
        if effect.needs is not None:
            margin = effect.needs.of({p.name: symbols[f"{effect.name}_{p.name}"] for p in effect.parameters})
            output = Output("margin", (1,), (margin,), effect.needs.unit, "positive for physical parameters")
            summary = f"Condition on the parameters of the effect {effect.name}."
            conditions.append(
                Function(
                    f"{effect.name}_margin", summary, "the effect's definition", (), (output,), {}, in_c=False
                )
            )
    return conditions


def _static_equilibrium(d: Derived) -> Function:
    """Return the function for the static equilibrium (equation 44)."""
    torques, rotations = d.equilibrium.torques, d.equilibrium.rotations
    words = drive_words(d.machine)
    return Function(
        "extended_static_equilibrium",
        f"Drive {words.loads} and {words.motions} that hold the pose, with the weights and stiffness changes of "
        "effects.",
        "equation 44; springs added by effects are relaxed at the pose, and released joints are locked",
        (d.pose,),
        (
            Output("tau_st", (len(torques),), torques, words.load_unit, words.described),
            Output(
                "theta_st",
                (len(rotations),),
                rotations,
                words.motion_unit,
                f"{words.motions} relative to the unstrained transmissions",
            ),
        ),
        d.kin.definitions,
    )


def single(machine: Machine, zeros: Set[tuple[str, int]]) -> Model:
    """Return the model of one robot with effects: the functions of the base model in its coordinates, and some more.

    Coordinates without inertia are condensed exactly, so the matrices define an eigenproblem.

    Parameters
    ----------
    machine : Machine
        With the active effects.
    zeros : set of (field, index)
        Parameters that are zero for this robot.
    """
    c, v = Condensed(derive(machine), zero_symbols(machine, zeros)), machine.vocabulary
    names = tuple(q.name for q in machine.all_coordinates)
    constant = (
        "All coordinates, including those without inertia, in the order of `condensation`.",
        "ALL_COORDINATES",
        names,
    )
    return Model(
        mechanism=machine.name,
        coordinates=tuple((q.name, v[q].unit) for q in c.coordinates),
        vocabulary=v,
        groups=(parameters(machine), FieldGroup("Effects", "effects", machine.effect_fields, null=0.0)),
        functions=(*chapters.chapters(c), _platform_motion(c), *(_uncondensed(c) if c.massless else ())),
        rigid_modes=c.rigid_modes,
        conditions=c.machine.margins,
        constants=(constant,) if c.massless else (),
        notes=_notes(c),
    )


def zero_symbols(machine: Machine, zeros: Set[tuple[str, int]]) -> frozenset[Symbol]:
    """Return the symbols of parameters that are zero for a robot, by field and index."""
    fields = (*machine.tables.fields, *machine.effect_fields)
    return frozenset(s for field in fields for i, s in enumerate(field.symbols) if (field.name, i) in zeros)


def _notes(c: Condensed) -> tuple[str, ...]:
    """Return notes on how the effects change the use of the code."""
    active = ", ".join(f"{effect.name} ({effect.sentence})" for effect in c.machine.effects)
    notes = [
        f"Active effects: {active}.  The coordinates they add are relative and zero at the pose.  "
        f"`platform_jacobian` is with respect to the {c.machine.independent_are} only, `platform_motion` with "
        "respect to every coordinate."
    ]
    if c.massless:
        names = ", ".join(q.name for q in c.massless)
        every = ", ".join(q.name for q in c.machine.all_coordinates)
        notes.append(
            f"Coordinates without inertia: {names}.  They follow the others statically and add no mode, so all "
            "functions use only the coordinates above; M is positive definite, and K is condensed exactly."
        )
        notes.append(
            f"For all {len(every.split(', '))} coordinates ({every}), `uncondensed_matrices` returns M and K; this M "
            "has zero rows, which eigensolvers reject.  Multiply a mode shape by `condensation` to extend it to all "
            "coordinates."
        )
    return tuple(notes)


def _platform_motion(c: Condensed) -> Function:
    """Return the function for the absolute motion of the platform, which no massless coordinate moves."""
    rows = c.derived.platform_motion(c.rates)
    return c.function(
        "platform_motion",
        "Jacobian of the absolute motion of the platform centre.",
        "equation 15, with the contributions of released joints and the frame",
        [c.pose],
        Output("J_p", (len(rows), c.n), flattened(rows), "1, m", "dp_i/dq_k, base frame"),
    )


def _uncondensed(c: Condensed) -> list[Function]:
    """Return the functions for the matrices in all coordinates and for the condensation."""
    n = len(c.machine.all_coordinates)
    return [
        c.function(
            "uncondensed_matrices",
            "Mass and stiffness matrices in all coordinates; M has zero rows and is singular.",
            "equation 48, with the effects' energies",
            [c.pose],
            Output("M", (n, n), flattened(c.M_all), units_of_mass(c.machine), "mass matrix"),
            Output("K", (n, n), flattened(c.K_all), units_of_stiffness(c.machine), "stiffness matrix"),
        ),
        c.function(
            "condensation",
            "Map from the coordinates with inertia to all coordinates.",
            "K_rr x_r + K_rq x_q = 0 for the coordinates r without inertia",
            [c.pose],
            Output(
                "T",
                (n, c.n),
                flattened(c.condensation),
                "1, m, 1/m",
                "all coordinates are T times those with inertia; T^T K T condenses the uncondensed K",
            ),
        ),
    ]
