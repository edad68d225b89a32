r"""Kinematics: closures and their derivatives to second order, by the implicit function theorem.

The vector s_j of a rigid link, from the joint of its independent coordinate to the platform joint, keeps its length:

.. math:: \Phi_j = \tfrac12 \left(s_j \cdot s_j - l_{d,j}^2\right) = 0.

The theorem gives the platform Jacobian D_p = D_l^{-1} D_r (equations 12 to 15) and the second derivatives of the
platform position, which replace the time derivative of D_p in equation 49.  Without links the independent coordinates
give the platform position directly.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from sympy import Add, Expr, Integer, Matrix, Rational, Symbol

from pkmodes_derive import implicit
from pkmodes_derive.chain import Chain
from pkmodes_derive.machine import Machine
from pkmodes_derive.vectors import dot
from pkmodes_derive.vocabulary import AXES

HALF = Rational(1, 2)


@dataclass(frozen=True)
class Kinematics:
    """The named results; entries are symbols defined in `chain`.

    Attributes
    ----------
    chain : Chain
        Definitions as functions of coordinates and platform, and the rules dp/dq = D, dD_p/dq = P.
    inverse : dict
        Definitions of the independent coordinates as functions of the pose.
    closures : list of sympy.Expr
        Phi_j, one for each dependent coordinate; empty without links.
    solver : implicit.Solver or None
        Solver for systems with D_l = Phi_s; None without links.
    D_l : sympy.Matrix
        Phi_s.
    D_r : sympy.Matrix
        -Phi_q for the machine's independent coordinates, diagonal: each link has its own coordinate.
    D_p : sympy.Matrix
        Platform Jacobian with respect to the machine's independent coordinates.
    U : tuple of sympy.Matrix
        U_j = ds_j/dq, the Jacobian of link vector j with respect to `independent`.
    P : tuple of sympy.Matrix
        Second derivatives of the platform position with respect to the machine's independent coordinates.
    independent : tuple of sympy.Symbol
        Coordinates that move the platform: the machine's, then any released ones on which positions depend.
    right : sympy.Matrix
        -Phi_q for all of `independent`; its first columns are D_r.
    D : sympy.Matrix
        dp/dq for all of `independent`; its first columns are D_p.
    reference : dict
        Values of released coordinates in the reference configuration.
    partial : Chain
        Definitions in which coordinates and platform are unrelated, for `implicit.second_derivatives`.
    """

    chain: Chain
    inverse: dict[Symbol, Expr]
    closures: list[Expr]
    solver: implicit.Solver | None
    D_l: Matrix
    D_r: Matrix
    D_p: Matrix
    U: tuple[Matrix, ...]
    P: tuple[Matrix, ...]
    independent: tuple[Symbol, ...]
    right: Matrix
    D: Matrix
    reference: dict[Symbol, Expr]
    partial: Chain

    @property
    def definitions(self) -> dict[Symbol, Expr]:
        """Definitions in evaluation order, with the pose as input."""
        chain, before_inverse = self.chain.definitions, {}

        def take(symbols: set[Symbol]) -> None:
            for symbol in chain:
                if symbol in symbols and symbol not in before_inverse:
                    take(chain[symbol].free_symbols)
                    before_inverse[symbol] = chain[symbol]

        take({s for expression in self.inverse.values() for s in expression.free_symbols})
        return {**before_inverse, **self.inverse, **chain}


def derive(machine: Machine) -> Kinematics:
    """Derive the kinematics; the derivative rules for the platform and D_p are added to the machine's chain."""
    chain, partial = machine.chain, machine.chain.copy()
    released_positions = tuple(c.position for c in machine.moving)
    independent = (*machine.independent, *released_positions)
    reference: dict[Symbol, Expr] = dict.fromkeys(released_positions, Integer(0))
    n = len(machine.independent)
    if not machine.links:
        D = Matrix([[chain.derivative(c, q) for q in independent] for c in _components(machine)])
        D = D.xreplace(reference)  # released coordinates are zero in the reference configuration
        empty = Matrix.zeros(0, n)
        no_second_derivatives = tuple(Matrix.zeros(n, n) for _ in machine.directions)
        inverse, D_p = machine.inverse, D[:, :n]
        return Kinematics(
            chain,
            inverse,
            [],
            None,
            empty,
            empty,
            D_p,
            (),
            no_second_derivatives,
            independent,
            empty,
            D,
            reference,
            partial,
        )
    closures = [
        _closure(link.vector, link.length, [c.position for c in link.elongation]) for link in machine.links
    ]
    D_l, right = implicit.first_order(closures, independent, machine.dependent, chain)
    if machine.turning is not None:
        _name_moments(machine, D_l)
    right = right.xreplace(reference)  # released coordinates are zero in the reference configuration
    D_r = _named_diagonal(machine, right, n)
    solver = implicit.Solver(D_l, machine.vocabulary, chain, machine.components, len(machine.rotations))
    D = _jacobian(machine, solver, right, independent)
    D_p = D[:, :n]
    U = tuple(_link_jacobian(machine, j, independent) for j in range(len(machine.links)))
    P = _second_derivatives(machine, closures, D_p, solver)
    if machine.yielding:  # the derivatives of link vectors are rules by now
        zeros = {c.position: Integer(0) for c in machine.yielding}
        for symbol in (s for link in machine.links for s in link.vector):
            chain.redefine(symbol, chain.definitions[symbol].xreplace(zeros))
    return Kinematics(
        chain,
        machine.inverse,
        closures,
        solver,
        D_l,
        D_r,
        D_p,
        U,
        P,
        independent,
        right,
        D,
        reference,
        partial,
    )


def _components(machine: Machine) -> tuple[Expr, ...]:
    """Return the platform position in the directions in which it moves."""
    return tuple(machine.platform[AXES.index(axis)] for axis in machine.directions)


def _closure(s: Sequence[Symbol], length: Expr, elongation: Sequence[Symbol]) -> Expr:
    return (dot(s, s) - Add(length, *elongation) ** 2) * HALF


def _named_diagonal(machine: Machine, right: Matrix, n: int) -> Matrix:
    """Return D_r with its diagonal named."""
    D_r = Matrix.zeros(len(machine.links), n)
    for j in range(n):
        name = machine.vocabulary.declare(
            "D_r_{j}",
            machine.unit_by(machine.independent[j], "m", "m^2"),
            "entry of D_r for axis {j}: component of linkage vector along the motion of its joint",
            "(D_r)_{{{j}{j}}}",
            j=j + 1,
        )
        right[j, j] = D_r[j, j] = machine.define(name, right[j, j])
    return D_r


def _name_moments(machine: Machine, D_l: Matrix) -> None:
    """Name the entries of D_l for rotations: moments of the linkage vectors about the platform's origin."""
    first = len(machine.directions)
    for j in range(len(machine.links)):
        for m, axis in enumerate(machine.components[first:], start=first):
            name = machine.vocabulary.declare(
                "D_l_{j}_{i}",
                "m^2",
                "moment of linkage vector {j} about the platform's origin, component {i}",
                "(D_l)_{{{j}{i}}}",
                j=j + 1,
                i=axis,
            )
            D_l[j, m] = machine.define(name, D_l[j, m])


def _jacobian(
    machine: Machine, solver: implicit.Solver, right: Matrix, independent: tuple[Symbol, ...]
) -> Matrix:
    v, n = machine.vocabulary, len(machine.independent)
    D = Matrix.zeros(len(machine.dependent), len(independent))
    columns = [solver.solve(tuple(right[:, k])) for k in range(len(independent))]
    for m, axis in enumerate(machine.components):
        turns = m >= len(machine.directions)
        for k, q in enumerate(independent):
            if k < n:
                what = f"platform Jacobian, dp_{{i}}/d{machine.stem}_{{k}}"
                unit = machine.unit_by(machine.independent[k], *(("1/m", "1") if turns else ("1", "m")))
                name = v.declare("D_p_{i}_{k}", unit, what, "(D_p)_{{{i}{k}}}", i=axis, k=k + 1)
            else:
                what = "platform Jacobian, dp_{i}/ddelta_{k}"
                unit = "1/m" if turns else "1"
                name = v.declare("D_delta_{i}_{k}", unit, what, r"(D_\delta)_{{{i}{k}}}", i=axis, k=k - n + 1)
            D[m, k] = machine.define(name, columns[k][m])
            machine.chain.rule(machine.dependent[m], q, name)
    if machine.turning is not None:
        for k, q in enumerate(independent):
            machine.turning.follow(q, tuple(D[len(machine.directions) :, k]))
    return D


def _link_jacobian(machine: Machine, j: int, independent: tuple[Symbol, ...]) -> Matrix:
    chain, s, n = machine.chain, machine.links[j].vector, len(machine.independent)
    U = Matrix.zeros(len(s), len(independent))
    for m, axis in enumerate(machine.directions):
        for k, q in enumerate(independent):
            U[m, k] = chain.derivative(s[m], q)
            if k < n:  # along an elongation the link vector moves with the platform: no new name
                name = machine.vocabulary.declare(
                    "U_{j}_{i}_{k}",
                    machine.unit_by(machine.independent[k], "1", "m"),
                    f"derivative of linkage vector {{j}}, component {{i}}, with respect to {machine.stem}_{{k}}",
                    "(U_{j})_{{{i}{k}}}",
                    j=j + 1,
                    i=axis,
                    k=k + 1,
                )
                U[m, k] = machine.define(name, U[m, k])
    for m in range(len(s)):
        for k, q in enumerate(independent):
            chain.rule(s[m], q, U[m, k])
    return U


def _second_derivatives(
    machine: Machine, closures: list[Expr], D_p: Matrix, solver: implicit.Solver
) -> tuple[Matrix, ...]:
    v, chain, q = machine.vocabulary, machine.chain, machine.independent
    n, stem = len(q), machine.stem
    by = f"with respect to {stem}_{{k}} and {stem}_{{l}}"
    P = tuple(Matrix.zeros(n, n) for _ in machine.dependent)
    for k in range(n):
        for m in range(k, n):
            forcing = implicit.second_order_forcing(closures, q[k], q[m], chain, jacobian=tuple(D_p))
            if machine.turning is not None:  # the second derivatives of the exponential chart are symmetric
                exchanged = implicit.second_order_forcing(closures, q[m], q[k], chain, jacobian=tuple(D_p))
                forcing = [(a + b) * HALF for a, b in zip(forcing, exchanged, strict=True)]
            names = []
            for j in range(len(closures)):
                what = f"right-hand side of closure {{j}}, differentiated {by}"
                place = {"j": j + 1, "k": k + 1, "l": m + 1}
                names.append(
                    v.declare(
                        "f_{j}_{k}{l}",
                        machine.unit_by(machine.independent[k], "1", "m^2"),
                        what,
                        "(f_{j})_{{{k}{l}}}",
                        **place,
                    )
                )
                machine.define(names[j], forcing[j])
            solution = solver.solve(names)
            for i, axis in enumerate(machine.components):
                what, place = f"second derivative of p_{{i}} {by}", {"k": k + 1, "l": m + 1}
                turns = i >= len(machine.directions)
                name = v.declare(
                    "P_{i}_{k}{l}",
                    machine.unit_by(machine.independent[k], *(("1/m^2", "1") if turns else ("1/m", "m"))),
                    what,
                    "(P_{i})_{{{k}{l}}}",
                    i=axis,
                    **place,
                )
                P[i][k, m] = P[i][m, k] = machine.define(name, solution[i])
                rates = _rates_of_jacobian_entries(machine, i, name, D_p[:, k], D_p[:, m])
                chain.rule(D_p[i, k], q[m], rates[0])
                if m != k:
                    chain.rule(D_p[i, m], q[k], rates[1])
    return P


def _rates_of_jacobian_entries(
    machine: Machine, i: int, name: Symbol, at_k: Matrix, at_m: Matrix
) -> tuple[Expr, Expr]:
    """Return d(D_ik)/dq_m and d(D_im)/dq_k: for angular velocities they differ by a commutator (`turning`)."""
    first = len(machine.directions)
    if machine.turning is None or i < first:
        return name, name
    half = HALF * machine.turning.commutator(tuple(at_m)[first:], tuple(at_k)[first:])[i - first]
    return name + half, name - half
