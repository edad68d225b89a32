"""Names for the entries of symmetric matrices in the components of a platform's motion."""

from __future__ import annotations

from sympy import Matrix

from pkmodes_derive.machine import Machine


def named_block(
    machine: Machine, matrix: Matrix, symbol: str, units: tuple[str, str, str], description: str
) -> Matrix:
    """Return a symmetric matrix, d by d, whose entries are named in the chain of a machine.

    Parameters
    ----------
    symbol : str
        Of the matrix.
    units : tuple of str
        Of entries between displacements, between a displacement and a rotation, and between rotations.
    description : str
        Description with ``{i}`` and ``{a}`` for row and column.
    """
    names, first, named = machine.components, len(machine.directions), matrix.copy()
    for i, row in enumerate(names):
        for k, column in list(enumerate(names))[i:]:
            if matrix[i, k] != 0:
                unit = units[(i >= first) + (k >= first)]
                latex = f"({symbol})_{{{{{{i}}{{a}}}}}}"
                name = machine.vocabulary.declare(
                    f"{symbol}_{{i}}_{{a}}", unit, description, latex, i=row, a=column
                )
                named[i, k] = named[k, i] = machine.define(name, matrix[i, k])
    return named
