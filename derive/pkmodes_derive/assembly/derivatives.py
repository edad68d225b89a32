"""Derivatives of M and K with respect to every parameter: functions, and lists of the entries differentiated."""

from __future__ import annotations

from collections.abc import Sequence

from sympy import Expr, Symbol

from pkmodes_derive.assembly import sensitivity
from pkmodes_derive.assembly.derived import Derived, matrix_sum
from pkmodes_derive.assembly.sensitivity import Entries
from pkmodes_derive.functions import Function, Output


def derivatives(d: Derived) -> tuple[list[Function], list[tuple[str, str, tuple[object, ...]]]]:
    """Return the functions for the derivatives of M and K, and the lists of what they are derivatives of.

    Of a platform that turns only the lists are written: there would be tens of thousands of expressions, and the
    runtime differentiates `extended_matrices` by complex step, which is exact to rounding.
    """
    machine = d.machine
    field_and_index = {
        symbol: (field.name, index)
        for field in (*machine.tables.fields, *machine.effect_fields)
        for symbol, index in zip(field.symbols, field.indices, strict=True)
    }
    geometry_parameters = sensitivity.geometry(d)
    value_parameters = sensitivity.values(machine, geometry_parameters)
    coordinates_moved = machine.independent_are
    functions: list[Function] = []
    constants: list[tuple[str, str, tuple[object, ...]]] = []
    for name, title, source, parameters, remark, comment in (
        (
            "value_sensitivities",
            "Derivatives of M and K at a fixed pose with respect to parameters that move no coordinate.",
            "chain rule",
            value_parameters,
            "",
            "Parameters of the derivatives: field of Parameters or Effects, index in it, and (row, column) of the "
            "entries of M and of K, in the upper triangle, that depend on it.",
        ),
        (
            "geometry_sensitivities",
            f"Derivatives of M and K at a fixed pose with respect to parameters that move the {coordinates_moved}.",
            "implicit function theorem and chain rule",
            geometry_parameters,
            "".join(
                f"  Derivatives with respect to {field} are the negatives of those with respect to {other}."
                for field, other in machine.differences.items()
            ),
            "The same for `geometry_sensitivities`.",
        ),
    ):
        places: Sequence[tuple[Entries, Entries]]
        if machine.turning is None:
            function, places = _sensitivities(d, name, title, source, parameters, remark)
            functions.append(function)
        else:
            places = sensitivity.affected_entries(d, parameters)
            comment = comment.replace("`geometry_sensitivities`", "parameters that move coordinates")
        entries_of_parameters = tuple(
            (*field_and_index[theta], *entries) for theta, entries in zip(parameters, places, strict=True)
        )
        constants.append((comment, name.upper(), entries_of_parameters))
    return functions, constants


def _sensitivities(
    d: Derived, name: str, title: str, source: str, parameters: Sequence[Symbol], remark: str
) -> tuple[Function, tuple[tuple[Entries, Entries], ...]]:
    """Return the derivatives and, for each parameter, the entries of M and K that they belong to."""
    chain = sensitivity.PoseChain(d, parameters)
    dM, dK = (chain.derivatives(matrix) for matrix in (d.M, matrix_sum(d.K_el, d.K_g)))
    function = Function(
        name,
        title,
        source,
        (d.pose,),
        (
            _listed_output("M_theta", dM, "unit of M / unit of the parameter", "dM/dtheta"),
            _listed_output("K_theta", dK, "unit of K / unit of the parameter", "dK/dtheta"),
        ),
        chain.chain.definitions,
        f"Returns the upper-triangle entries listed in {name.upper()}; all others are zero.{remark}",
        in_c=False,
    )
    return function, tuple(zip(map(tuple, dM), map(tuple, dK), strict=True))


def _listed_output(
    name: str, derivatives: Sequence[dict[tuple[int, int], Expr]], unit: str, description: str
) -> Output:
    entries = tuple(entry for matrix in derivatives for entry in matrix.values())
    return Output(name, (len(entries),), entries, unit, description, listed=True)
