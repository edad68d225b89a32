"""The functions that the compiled evaluator needs of a mechanism, combined from those of its two models."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace

from sympy import Expr, Integer, Symbol

from pkmodes_derive.functions import Function, Model, Output
from pkmodes_description import CHOICES, Description, Margin


def position(model: Model, description: Description) -> Function:
    """Independent coordinates and every margin of the mechanism, one after the other."""
    by_name = {f.name: f for f in model.functions}
    kinematics = by_name["inverse_kinematics"]
    margins = [_output(by_name, margin) for margin in description.margins]
    entries = tuple(entry for output in margins for entry in output.entries)
    sources = [kinematics, *(by_name[margin.function] for margin in description.margins)]
    (q,) = kinematics.outputs
    return Function(
        "position",
        f"{kinematics.summary.rstrip('.')}, and the margins of a pose.",
        "inverse_kinematics and " + ", ".join(dict.fromkeys(m.function for m in description.margins)),
        kinematics.arguments,
        (
            Output("q", q.shape, q.entries, q.unit, q.description),
            Output(
                "margin", (len(entries),), entries, "m, rad, 1", "in the order of LANES_RULES", listed=True
            ),
        ),
        _definitions(sources),
    )


def margins_of(model: Model, description: Description) -> list[tuple[int, str]]:
    """How many numbers each margin has, and its rule."""
    by_name = {f.name: f for f in model.functions}
    return [(len(_output(by_name, margin).entries), margin.rule) for margin in description.margins]


def base(model: Model, description: Description) -> Function:
    """M, K and the motion of the platform without effects."""
    by_name = {f.name: f for f in model.functions}
    matrices, jacobian = by_name["modal_matrices"], by_name["platform_jacobian"]
    M, K = matrices.outputs
    (D_p,) = jacobian.outputs
    names = [component.name for component in description.coordinates]
    width = D_p.shape[1]
    entries: list[Expr] = []
    for i in range(len(description.platform)):
        row = D_p.entries[i * width :][:width]
        entry_of = {
            names.index(name): value for name, value in zip(description.independent, row, strict=True)
        }
        entries += [entry_of.get(i, Integer(0)) for i in range(len(names))]
    motion = Output(
        "J_p",
        (len(description.platform), len(names)),
        tuple(entries),
        D_p.unit,
        "motion of the platform with respect to every coordinate",
    )
    return Function(
        "base",
        "Mass and stiffness matrices without effects, and the motion of the platform.",
        "modal_matrices and platform_jacobian",
        matrices.arguments,
        (M, K, motion),
        _definitions([matrices, jacobian]),
    )


def extended(model: Model) -> Function:
    """M, K and the motion of the platform with the coordinates of all released joints, joints free."""
    by_name = {f.name: f for f in model.functions}
    matrices, motion = by_name["extended_matrices"], by_name["extended_platform_motion"]
    M, K_el, K_g = matrices.outputs
    K = tuple(a + b for a, b in zip(K_el.entries, K_g.entries, strict=True))
    return Function(
        "extended",
        "Mass and stiffness matrices with all released joints free, and the motion of the platform.",
        "extended_matrices and extended_platform_motion",
        matrices.arguments,
        (M, Output("K", K_el.shape, K, K_el.unit, "K_el + K_g"), *motion.outputs),
        _definitions([matrices, motion]),
    )


def statics(model: Model) -> Function:
    """The platform Jacobian, what holds the pose, and the stiffness of the transmissions, without effects."""
    by_name = {f.name: f for f in model.functions}
    names = "platform_jacobian", "static_equilibrium", "elastic_hessian"
    used = [by_name[name] for name in names]
    return Function(
        "statics",
        "Platform Jacobian, static equilibrium and elastic stiffness without effects.",
        ", ".join(names),
        used[0].arguments,
        tuple(output for function in used for output in function.outputs),
        _definitions(used),
    )


def extended_statics(model: Model) -> Function:
    """What holds the pose, with effects."""
    by_name = {f.name: f for f in model.functions}
    return replace(by_name["extended_static_equilibrium"], name="extended_statics")


def coordinate_indices(description: Description) -> dict[str, list[int]]:
    """Which of the base coordinates are independent, and which are not, by the name of the list in C."""
    names = [component.name for component in description.coordinates]
    independent = [names.index(name) for name in description.independent]
    dependent = [i for i in range(len(names)) if i not in independent]
    return {"INDEPENDENT_INDICES": independent, "DEPENDENT_INDICES": dependent}


def choices(model: Model, description: Description) -> set[Symbol]:
    """Parameters that are not quantities, so that nothing is differentiated with respect to them."""
    fields = {key.field for table in description.tables for key in table.keys if key.kind in CHOICES}
    return {s for field in model.fields if field.name in fields for s in field.symbols}


def _output(by_name: Mapping[str, Function], margin: Margin) -> Output:
    return by_name[margin.function].outputs[margin.output]


def _definitions(functions: Iterable[Function]) -> dict[Symbol, Expr]:
    return {symbol: value for f in functions for symbol, value in f.definitions.items()}
