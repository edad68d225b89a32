"""What a controller calls: the status of a pose, natural frequencies and modes, on top of the emitted functions."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from importlib.resources import files
from math import prod

from pkmodes_derive.emit.c99 import shaper, vibration
from pkmodes_derive.emit.constants import Constant, constants, pose, status_name
from pkmodes_derive.emit.provenance import Provenance
from pkmodes_derive.emit.templating import render
from pkmodes_derive.functions import FieldGroup, Function, Model, Output
from pkmodes_description import Margin

COMPARISONS = {"at_least_zero": ">= 0", "above_zero": "> 0"}
#: What a controller calls of every model.
FUNCTIONS = ("status", "natural_frequencies", "modes")


def functions(model: Model) -> tuple[str, ...]:
    """Return the names of what a controller calls, without the prefix."""
    if model.held is None:
        return FUNCTIONS
    return *FUNCTIONS, *(vibration.FUNCTIONS if model.held.functions else ()), *shaper.FUNCTIONS


@dataclass(frozen=True)
class _Check:
    """One condition on a pose, as text."""

    declared: str
    call: str
    count: int
    result: str
    compared: str
    code: str


def definitions(model: Model, provenance: Provenance) -> list[tuple[str, str, str, str]]:
    """Return name, comment, value, and value in single precision if it differs, of every macro."""
    upper = provenance.name.upper()
    return [
        (f"{upper}_{c.name}", c.comment, _value(c), "" if c.single is None else f"{c.single!r}f")
        for c in constants(model, provenance)
    ]


def _value(constant: Constant) -> str:
    """Return the value of a macro, which can stand in any expression and has the type of the model's numbers."""
    value = constant.value
    if isinstance(value, str):
        return f'"{value}"'
    if isinstance(value, float) and constant.single is None:
        return f"((pkmodes_real){value!r})"
    return f"({value!r})" if value < 0 else repr(value)


def source(model: Model, name: str, groups: Sequence[FieldGroup]) -> str:
    """Return the functions; `groups` are the parameters that every function of the pose takes."""
    upper, by_name = name.upper(), {function.name: function for function in model.functions}
    argument_names = ["p", *(group.argument for group in groups)]
    return render(
        __package__,
        "modes.c.j2",
        name=name,
        upper=upper,
        n=len(model.coordinates),
        vibration="0" if model.rigid_modes is None else f"{upper}_RIGID_MODES",
        arguments=arguments(model, groups),
        passed=", ".join(argument_names),
        parts=_robot_functions(model, name, groups, argument_names),
        solver=files(__package__).joinpath("eigen.c").read_text(encoding="utf-8").rstrip(),
        checks=[
            _check(
                margin,
                by_name[margin.function],
                f"{upper}_{status_name(model.conditions, number)}",
                name,
                argument_names,
            )
            for number, margin in enumerate(model.conditions, start=2)
        ],
    )


def _robot_functions(
    model: Model, name: str, groups: Sequence[FieldGroup], argument_names: list[str]
) -> list[str]:
    """Return the functions that only the model of a robot has."""
    if model.held is None:
        return []
    parts = [shaper.source(name, len(pose(model).symbols))]
    if model.held.functions:
        parts.insert(0, vibration.source(model.held, name, arguments(model, groups), argument_names))
    return [part.rstrip("\n") for part in parts]


def example(model: Model, name: str, groups: Sequence[FieldGroup]) -> list[str]:
    """Return lines of C that call the functions in order."""
    d, n = len(pose(model).symbols), len(model.coordinates)
    argument_list = ", ".join(["p", *(group.argument for group in groups)])
    return [
        f" *   pkmodes_real p[{d}] = {{...}}, f[{n}], phi[{n}][{n}], M[{n}][{n}], K[{n}][{n}];",
        f" *   if ({name}_status({argument_list}) == 0) {{",
        f" *       {name}_modal_matrices({argument_list}, M, K);",
        f" *       {name}_modes({argument_list}, f, phi);",
        " *   }",
    ]


def call_status_first(function: Function, model: Model, name: str) -> str:
    """Return what to call before a function of the pose: nothing for those on which the status rests."""
    status_functions = {"inverse_kinematics", *(margin.function for margin in model.conditions)}
    if (
        not model.conditions
        or function.name in status_functions
        or not any(a.name == "p" for a in function.arguments)
    ):
        return ""
    return f"Call `{name}_status` first: where it is not 0, the results are NaN or have no meaning."


def arguments(model: Model, groups: Sequence[FieldGroup]) -> str:
    """Return the declared arguments of a function of the pose."""
    types = [f"const {model.mechanism}_{group.argument} *{group.argument}" for group in groups]
    return ", ".join([f"const pkmodes_real p[{len(pose(model).symbols)}]", *types])


def _check(margin: Margin, function: Function, code: str, name: str, argument_names: Sequence[str]) -> _Check:
    result = function.outputs[margin.output]
    passed = [*argument_names, *(_passed_argument(output) for output in function.outputs)]
    return _Check(
        declared=", ".join(
            output.name + "".join(f"[{n}]" for n in output.shape) for output in function.outputs
        ),
        call=f"{name}_{function.name}({', '.join(passed)})",
        count=prod(result.shape),
        result=_passed_argument(result),
        compared=COMPARISONS.get(margin.rule, f"<= {name.upper()}_MAX_CONDITION"),
        code=code,
    )


def _passed_argument(output: Output) -> str:
    return output.name if output.shape else f"&{output.name}"
