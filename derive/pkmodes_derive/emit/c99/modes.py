"""What a controller calls: the status of a pose, natural frequencies and modes, on top of the emitted functions."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from importlib.resources import files
from math import prod

from pkmodes_derive.description import Margin
from pkmodes_derive.emit.templating import render
from pkmodes_derive.functions import FieldGroup, Function, Model, Output

COMPARED = {"at_least_zero": ">= 0.0", "above_zero": "> 0.0"}
#: Largest condition number of a regular pose, as `pkmodes.poses.MAX_CONDITION`.
MAX_CONDITION = "1e6"


@dataclass(frozen=True)
class _Check:
    """One condition on a pose, as text."""

    declared: str
    call: str
    count: int
    result: str
    compared: str
    code: str


def definitions(model: Model, name: str) -> list[tuple[str, str, str]]:
    """Return name, value and comment of every macro."""
    upper = name.upper()
    found = [
        ("POSE", str(len(_pose(model))), "components of a pose"),
        ("COORDINATES", str(len(model.coordinates)), "coordinates, and modes"),
    ]
    if model.rigid_modes is not None:
        found.append(("RIGID_MODES", str(model.rigid_modes), "rigid-body modes, the first ones"))
    if any(margin.rule == "at_most_limit" for margin in model.conditions):
        found.append(("MAX_CONDITION", MAX_CONDITION, "largest condition number of a regular pose"))
    found.append(("UNSOLVED", "(-1)", "status: the eigenproblem has no solution"))
    found.append(("NOT_FINITE", "1", "status: the pose is not finite"))
    for number, margin in enumerate(model.conditions, start=2):
        found.append((_code(model.conditions, number), str(number), f"status: {margin.meaning}"))
    return [(f"{upper}_{key}", value, comment) for key, value, comment in found]


def source(model: Model, name: str, groups: Sequence[FieldGroup]) -> str:
    """Return the functions; `groups` are the parameters that every function of the pose takes."""
    upper, by_name = name.upper(), {function.name: function for function in model.functions}
    taken = ["p", *(group.argument for group in groups)]
    return render(
        __package__,
        "modes.c.j2",
        name=name,
        upper=upper,
        n=len(model.coordinates),
        arguments=arguments(model, groups),
        passed=", ".join(taken),
        solver=files(__package__).joinpath("eigen.c").read_text(encoding="utf-8").rstrip(),
        checks=[
            _check(
                margin, by_name[margin.function], f"{upper}_{_code(model.conditions, number)}", name, taken
            )
            for number, margin in enumerate(model.conditions, start=2)
        ],
    )


def arguments(model: Model, groups: Sequence[FieldGroup]) -> str:
    """Return the declared arguments of a function of the pose."""
    types = [f"const {model.mechanism}_{group.argument} *{group.argument}" for group in groups]
    return ", ".join([f"const double p[{len(_pose(model))}]", *types])


def _pose(model: Model) -> tuple[object, ...]:
    (function,) = (f for f in model.functions if f.name == "modal_matrices")
    return function.arguments[0].symbols


def _code(conditions: Sequence[Margin], number: int) -> str:
    """Name of a status; of several conditions with one code, the later ones are numbered."""
    code = conditions[number - 2].code
    before = sum(margin.code == code for margin in conditions[: number - 2])
    return f"BEYOND_{code}{before + 1 if before else ''}".upper()


def _check(margin: Margin, function: Function, code: str, name: str, taken: Sequence[str]) -> _Check:
    result = function.outputs[margin.output]
    passed = [*taken, *(_passed(output) for output in function.outputs)]
    return _Check(
        declared=", ".join(
            output.name + "".join(f"[{n}]" for n in output.shape) for output in function.outputs
        ),
        call=f"{name}_{function.name}({', '.join(passed)})",
        count=prod(result.shape),
        result=_passed(result),
        compared=COMPARED.get(margin.rule, f"<= {name.upper()}_MAX_CONDITION"),
        code=code,
    )


def _passed(output: Output) -> str:
    return output.name if output.shape else f"&{output.name}"
