r"""Closed loops by the implicit function theorem, to second order.

With independent coordinates q, dependent coordinates s(q) and closures :math:`\Phi(q, s) = 0`,

.. math:: \Phi_s D = -\Phi_q, \qquad D = \frac{ds}{dq},

and, differentiating once more along the solution,

.. math:: \Phi_s\, s_{kl} = -\left[\Phi_{qq} + \Phi_{qs} D + (\Phi_{qs} D)^T + D^T \Phi_{ss} D\right]_{kl}.

The bracket is the second total derivative of the closure with s_kl set to zero, that is with D held
constant; `second_order_forcing` computes it so.  For the linear delta the first line is equation 15 of the
paper (Phi_s = D_l, -Phi_q = D_r) and the second gives the exact Hessian that equation 49 is used for.

The Hessian of a function V(q, s(q)) needs s_kl only in the product V_s . s_kl, so one adjoint solution
replaces all of them: with multipliers :math:`\Phi_s^T \mu = V_s` (the forces that the closures carry),

.. math:: \frac{d^2 V}{dq_k\, dq_l} = \frac{d^2}{dq_k\, dq_l} \left(V - \mu \cdot \Phi\right)
          \quad \text{with } D \text{ and } \mu \text{ held constant},

which is the Hessian of the Lagrangian on the tangent space of the constraints.

Nothing is solved symbolically: the small linear systems are closed by their adjugate, entry by entry.
"""

from __future__ import annotations

from collections.abc import Sequence

from sympy import Add, Expr, Matrix, Symbol

from pkmodes_derive.chain import Chain


def first_order(
    closures: Sequence[Expr], independent: Sequence[Symbol], dependent: Sequence[Symbol], chain: Chain
) -> tuple[Matrix, Matrix]:
    """Return Phi_s and -Phi_q, the two sides of Phi_s D = -Phi_q.

    The dependent coordinates are held, so both are partial derivatives, as the theorem asks.
    """
    phi_s = Matrix([[chain.derivative(phi, s, hold=dependent) for s in dependent] for phi in closures])
    phi_q = Matrix([[chain.derivative(phi, q, hold=dependent) for q in independent] for phi in closures])
    return phi_s, -phi_q


def second_order_forcing(
    closures: Sequence[Expr], first: Symbol, second: Symbol, chain: Chain, jacobian: Sequence[Symbol]
) -> list[Expr]:
    """Return -[bracket]_kl of the module's docstring, one entry for each closure.

    `chain` must hold the rules ds/dq = D; the entries of D, given as `jacobian`, are held constant.
    """
    return [
        -chain.derivative(chain.derivative(phi, first, hold=jacobian), second, hold=jacobian)
        for phi in closures
    ]


def multipliers(adjugate: Matrix, determinant: Expr, gradient: Sequence[Expr]) -> list[Expr]:
    """Return mu of Phi_s^T mu = V_s for three closures; `adjugate` and `determinant` are those of Phi_s."""
    return solve_3x3(adjugate.T, determinant, gradient)


def constrained_hessian(
    potential: Expr,
    closures: Sequence[Expr],
    mu: Sequence[Symbol],
    independent: Sequence[Symbol],
    jacobian: Sequence[Symbol],
    chain: Chain,
) -> list[list[Expr]]:
    """Return d2V/dq2 along the constraints; `mu` names the multipliers, `jacobian` the entries of D."""
    lagrangian = potential - Add(*(m * phi for m, phi in zip(mu, closures, strict=True)))
    return chain.hessian(lagrangian, independent, hold=(*mu, *jacobian))


def cofactor(matrix: Matrix, row: int, column: int) -> Expr:
    """Cofactor of a 3-by-3 matrix: the cyclic form carries its own sign."""
    r1, r2 = (row + 1) % 3, (row + 2) % 3
    c1, c2 = (column + 1) % 3, (column + 2) % 3
    return matrix[r1, c1] * matrix[r2, c2] - matrix[r1, c2] * matrix[r2, c1]


def solve_3x3(adjugate: Matrix, determinant: Expr, right_hand_side: Sequence[Expr]) -> list[Expr]:
    """Solve a 3-by-3 system whose adjugate and determinant are already named."""
    return [
        Add(*(adjugate[row, column] * right_hand_side[column] for column in range(3))) / determinant
        for row in range(3)
    ]
