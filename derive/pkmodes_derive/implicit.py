r"""Closed loops by the implicit function theorem, to second order.

With independent coordinates q, dependent coordinates s(q) and closures :math:`\Phi(q, s) = 0`,

.. math:: \Phi_s D = -\Phi_q, \qquad D = \frac{ds}{dq},

and, differentiating once more along the solution,

.. math:: \Phi_s\, s_{kl} = -\left[\Phi_{qq} + \Phi_{qs} D + (\Phi_{qs} D)^T + D^T \Phi_{ss} D\right]_{kl}.

The bracket is the second total derivative of the closure with s_kl set to zero, that is with D held
constant; `second_order_forcing` computes it that way.  For the linear delta the first line is equation 15 of
the paper (Phi_s = D_l, -Phi_q = D_r) and the second gives the exact Hessian for which equation 49 is used.

The Hessian of a function V(q, s(q)) needs s_kl only in the product V_s . s_kl, so one adjoint solution
replaces all of them: with multipliers :math:`\Phi_s^T \mu = V_s` (the forces that the closures carry),

.. math:: \frac{d^2 V}{dq_k\, dq_l} = \frac{d^2}{dq_k\, dq_l} \left(V - \mu \cdot \Phi\right)
          \quad \text{with } D \text{ and } \mu \text{ held constant},

which is the Hessian of the Lagrangian on the tangent space of the constraints.

No linear system is solved symbolically: the solutions are written with the adjugate, entry by entry, and its minors
are named in systems larger than three by three (`Solver`).
"""

from __future__ import annotations

from collections.abc import Sequence

from sympy import Add, Expr, Integer, Matrix, Symbol

from pkmodes_derive.chain import Chain
from pkmodes_derive.vocabulary import Vocabulary


def first_order(
    closures: Sequence[Expr], independent: Sequence[Symbol], dependent: Sequence[Symbol], chain: Chain
) -> tuple[Matrix, Matrix]:
    """Return Phi_s and -Phi_q, the two sides of Phi_s D = -Phi_q.

    The dependent coordinates are held constant, so both are the partial derivatives that the theorem requires.
    """
    phi_s = Matrix([[chain.derivative(phi, s, hold=dependent) for s in dependent] for phi in closures])
    phi_q = Matrix([[chain.derivative(phi, q, hold=dependent) for q in independent] for phi in closures])
    return phi_s, -phi_q


def second_order_forcing(
    closures: Sequence[Expr], first: Symbol, second: Symbol, chain: Chain, jacobian: Sequence[Symbol]
) -> list[Expr]:
    """Return -[bracket]_kl of the module docstring, one entry for each closure.

    `chain` must hold the rules ds/dq = D; the entries of D, given as `jacobian`, are held constant.
    """
    return [
        -chain.derivative(chain.derivative(phi, first, hold=jacobian), second, hold=jacobian)
        for phi in closures
    ]


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


class Solver:
    """Solver for linear systems with Phi_s, through its named adjugate and determinant.

    Parameters
    ----------
    matrix : sympy.Matrix
        Phi_s, square.
    chain : Chain
        Receives the definitions.
    directions : sequence of str
        Directions of the dependent coordinates, used in names.
    """

    def __init__(
        self, matrix: Matrix, vocabulary: Vocabulary, chain: Chain, directions: Sequence[str]
    ) -> None:
        n = matrix.shape[0]
        self._matrix, self._vocabulary, self._chain = matrix, vocabulary, chain
        self._minors: dict[tuple[tuple[int, ...], tuple[int, ...]], Expr] = {}
        self.adjugate = Matrix.zeros(n, n)
        for j in range(n):
            for m, axis in enumerate(directions):
                unit = {2: "m", 3: "m^2"}.get(n, f"m^{n - 1}")
                name = vocabulary.declare(
                    "A_{i}_{j}", unit, "adjugate of D_l, entry {i}, {j}", "A_{{{i}{j}}}", i=axis, j=j + 1
                )
                self.adjugate[m, j] = chain.define(name, self._cofactor(j, m))
        self.determinant = vocabulary.declare("det_D_l", f"m^{n}", "determinant of D_l", r"\det D_l")
        chain.define(self.determinant, Add(*(matrix[0, m] * self.adjugate[m, 0] for m in range(n))))

    def solve(self, right_hand_side: Sequence[Expr]) -> list[Expr]:
        """Solve Phi_s y = b."""
        return solve(self.adjugate, self.determinant, right_hand_side)

    def multipliers(self, gradient: Sequence[Expr]) -> list[Expr]:
        """Return mu of Phi_s^T mu = V_s."""
        return solve(self.adjugate.T, self.determinant, gradient)

    def _cofactor(self, row: int, column: int) -> Expr:
        n = self._matrix.shape[0]
        if n == 3:
            return cofactor(self._matrix, row, column)
        rows, columns = (tuple(i for i in range(n) if i != gone) for gone in (row, column))
        return (-1) ** (row + column) * self._minor(rows, columns)

    def _minor(self, rows: tuple[int, ...], columns: tuple[int, ...]) -> Expr:
        """Return the determinant of a submatrix, expanded along its first row; shared minors are named."""
        if not rows:
            return Integer(1)
        if (rows, columns) not in self._minors:
            parts = (
                (-1) ** k * self._matrix[rows[0], m] * self._minor(rows[1:], columns[:k] + columns[k + 1 :])
                for k, m in enumerate(columns)
            )
            expression = Add(*parts)
            if 2 <= len(rows) < self._matrix.shape[0] - 1:
                places = ("".join(str(i + 1) for i in some) for some in (rows, columns))
                index = dict(zip(("r", "c"), places, strict=True))
                what = "minor of D_l, rows {r} and columns {c}"
                name = self._vocabulary.declare(
                    "minor_{r}_{c}", f"m^{len(rows)}", what, "|D_l|_{{{r},{c}}}", **index
                )
                expression = self._chain.define(name, expression)
            self._minors[rows, columns] = expression
        return self._minors[rows, columns]


def cofactor(matrix: Matrix, row: int, column: int) -> Expr:
    """Return a cofactor of a 3-by-3 matrix; the cyclic form includes the sign."""
    r1, r2 = (row + 1) % 3, (row + 2) % 3
    c1, c2 = (column + 1) % 3, (column + 2) % 3
    return matrix[r1, c1] * matrix[r2, c2] - matrix[r1, c2] * matrix[r2, c1]


def solve(adjugate: Matrix, determinant: Expr, right_hand_side: Sequence[Expr]) -> list[Expr]:
    """Solve a system whose adjugate and determinant are already named."""
    n = adjugate.shape[0]
    return [
        Add(*(adjugate[row, column] * right_hand_side[column] for column in range(n))) / determinant
        for row in range(n)
    ]
