"""The functions that are emitted for the linear delta, each with its equation, one module a chapter.

Nothing is derived here: the derived quantities are collected, named and described.
"""

from __future__ import annotations

from pkmodes_derive.functions import FieldGroup, Function, Model
from pkmodes_derive.linear_delta import energy, kinematics, rotation, statics
from pkmodes_derive.linear_delta.catalogue import modal, motion, position, potential
from pkmodes_derive.linear_delta.catalogue.collected import Collected
from pkmodes_derive.linear_delta.description import describe
from pkmodes_derive.linear_delta.machine import Machine
from pkmodes_derive.linear_delta.symbols import Symbols


def derive() -> Model:
    """Derive the linear delta from its closures and energies.

    Returns
    -------
    Model
        Functions of the platform centre p (and of velocities or displacements where they need them), for a
        robot given by the parameter fields.
    """
    sy = Symbols()
    machine = Machine(sy)
    kin = kinematics.derive(machine)
    energies = energy.derive(machine, kin)
    collected = Collected(machine, kin, energies, statics.derive(machine, kin, energies))
    return Model(
        mechanism="linear_delta",
        coordinates=tuple((q.name, sy.vocabulary[q].unit) for q in sy.coordinates),
        vocabulary=sy.vocabulary,
        groups=(FieldGroup("Parameters", "parameters", sy.fields),),
        functions=(*chapters(collected), position.travel(sy)),
        relations=rotation.euler_relations(sy, kin),
        rigid_modes=collected.rigid_modes,
        description=describe(
            tuple((q.name, sy.vocabulary[q].unit, sy.vocabulary[q].description) for q in sy.coordinates),
            collected.rigid_modes,
        ),
    )


def chapters(collected: Collected) -> tuple[Function, ...]:
    """Every function of a model, with effects or without."""
    return (
        *position.position(collected),
        *motion.motion(collected),
        *potential.gravity(collected),
        *potential.belts(collected),
        *modal.modal(collected),
    )
