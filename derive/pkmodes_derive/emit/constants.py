"""Constants in the code of a model, the same in every language: identity, dimensions, statuses and limits."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from pkmodes_derive.emit.provenance import Provenance
from pkmodes_derive.functions import Argument, Model
from pkmodes_description import Margin

#: Largest condition number of a regular pose, as `pkmodes.core.mechanism.poses.MAX_CONDITION`; single precision has
#: fewer digits to lose.
MAX_CONDITION, MAX_CONDITION_SINGLE = 1e6, 1e3
#: Meaning of the status of a pose with a component that is NaN or infinite.
NOT_FINITE = "the pose is not finite"


@dataclass(frozen=True)
class Constant:
    """A constant.

    Attributes
    ----------
    name : str
        In capitals.
    single : float, optional
        Its value in single precision, if that differs.
    """

    name: str
    value: str | int | float
    comment: str
    single: float | None = None


def constants(model: Model, provenance: Provenance) -> list[Constant]:
    """Return the constants of a model that has conditions on the pose."""
    identity, kind = provenance.identity, "mechanism" if provenance.parametric else "robot"
    result = [
        Constant("NAME", identity.name, f"name of the {kind}"),
        Constant("VERSION", identity.version, "version of the generator"),
        Constant("HASH", identity.digest, "SHA-256 of the C source, first digits: other code has another"),
        Constant("POSE", len(pose(model).symbols), "components of a pose"),
        Constant("COORDINATES", len(model.coordinates), "coordinates, and modes"),
    ]
    if model.rigid_modes is not None:
        result.append(Constant("RIGID_MODES", model.rigid_modes, "rigid-body modes, the first ones"))
    if model.held is not None and model.held.functions:
        result.append(
            Constant("HELD_MODES", len(model.held.coordinates), f"modes with the motors {model.held.motors}")
        )
    if any(margin.rule == "at_most_limit" for margin in model.conditions):
        largest = "largest condition number of a regular pose"
        result.append(Constant("MAX_CONDITION", MAX_CONDITION, largest, MAX_CONDITION_SINGLE))
    result.append(
        Constant(
            "UNSOLVED", -1, "status: the eigenproblem has no solution, or rounding leaves it too few digits"
        )
    )
    result.append(Constant("NOT_FINITE", 1, f"status: {NOT_FINITE}"))
    for number, margin in enumerate(model.conditions, start=2):
        result.append(Constant(status_name(model.conditions, number), number, f"status: {margin.meaning}"))
    for limit in identity.limits:
        comment = f"[{limit.unit}] {limit.path} of the robot file: {limit.description}"
        result.append(Constant(limit.name, limit.value, comment))
    return result


def status_name(conditions: Sequence[Margin], number: int) -> str:
    """Return the name of a status; of several conditions with one code, the later ones are numbered."""
    code = conditions[number - 2].code
    earlier = sum(margin.code == code for margin in conditions[: number - 2])
    return f"BEYOND_{code}{earlier + 1 if earlier else ''}".upper()


def pose(model: Model) -> Argument:
    """Return the argument that is the pose."""
    (function,) = (f for f in model.functions if f.name == "modal_matrices")
    return function.arguments[0]
