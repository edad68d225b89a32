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

With six closures this is written in blocks (`congruent`): the second derivatives of
:math:`L = V - \mu \cdot \Phi` with respect to q and s as if they were independent, projected by D,

.. math:: \frac{d^2 V}{dq^2} = L_{qq} + L_{qs} D + (L_{qs} D)^T + D^T L_{ss} D .

Where s has small rotations, :math:`L_{ss}` is that of the exponential chart at the pose (`with_small_rotations`,
`turning`).  K in the coordinates of the drives is the same in every chart.

No linear system is solved symbolically: the solutions are written with the adjugate, entry by entry, and its minors
are named in systems larger than three by three (`Solver`).  This needs no pivots, so a pose has no branches and poses
can be evaluated side by side.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

from sympy import Add, Expr, Integer, Matrix, Rational, Symbol, eye

from pkmodes_derive.chain import Chain
from pkmodes_derive.turning import Turning
from pkmodes_derive.vectors import axis, cross, dot
from pkmodes_derive.vocabulary import AXES, Vocabulary


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


@dataclass(frozen=True)
class SecondDerivatives:
    """Second derivatives of a function with respect to the independent and the dependent variables.

    Attributes
    ----------
    independent, mixed, dependent : sympy.Matrix
        L_qq (n by n), L_sq (d by n) and L_ss (d by d).
    """

    independent: Matrix
    mixed: Matrix
    dependent: Matrix


def second_derivatives(
    function: Expr, independent: Sequence[Symbol], dependent: Sequence[Symbol], partial: Chain
) -> SecondDerivatives:
    """Differentiate twice with the chain `partial`, in which dependent and independent variables are unrelated."""
    by_dependent = [partial.derivative(function, s) for s in dependent]
    by_independent = [partial.derivative(function, q) for q in independent]
    return SecondDerivatives(
        Matrix(
            [
                [partial.derivative(gradient_entry, q) for q in independent]
                for gradient_entry in by_independent
            ]
        ),
        Matrix(
            [[partial.derivative(gradient_entry, q) for q in independent] for gradient_entry in by_dependent]
        ),
        Matrix(
            [[partial.derivative(gradient_entry, s) for s in dependent] for gradient_entry in by_dependent]
        ),
    )


def with_small_rotations(
    second: SecondDerivatives,
    function: Expr,
    turning: Turning,
    partial: Chain,
    name: Callable[[int, int, Expr], Expr],
) -> SecondDerivatives:
    r"""Replace the block of the small rotations, the last dependent variables, by that of the exponential chart.

    With the gradients :math:`g_w = \partial L/\partial w` with respect to the vectors w fixed in the platform,

    .. math:: L_{ik} = \sum_w \left[\tfrac12 (w_i g_{w,k} + w_k g_{w,i}) - \delta_{ik}\, w \cdot g_w
              + (e_i \times w) \cdot \frac{\partial g_w}{\partial \varphi_k}\right].

    Parameters
    ----------
    name : callable
        ``name(v, i, expression)`` names component i of the gradient with respect to vector v.
    """
    axis_indices = [AXES.index(axis) for axis in turning.axes]
    first = second.dependent.shape[0] - len(axis_indices)
    matrix = second.dependent.copy()
    block = Matrix.zeros(3, 3)
    for v, vector in enumerate(turning.fixed):
        fixed_symbols = turning.symbols
        gradient = [
            partial.derivative(function, w, hold=fixed_symbols) if w.is_Symbol else Integer(0) for w in vector
        ]
        if not any(gradient):
            continue
        named = [name(v, i, entry) for i, entry in enumerate(gradient)]
        outer = Matrix(3, 3, lambda i, k, vector=vector, named=named: vector[i] * named[k])
        block += (outer + outer.T) * Rational(1, 2) - outer.trace() * eye(3)
        for k, small in zip(axis_indices, turning.small, strict=True):
            rates = [partial.derivative(entry, small) for entry in gradient]
            for i in axis_indices:
                block[i, k] += dot(cross(axis(AXES[i]), vector), rates)
    for a, i in enumerate(axis_indices):
        for b, k in enumerate(axis_indices):
            matrix[first + a, first + b] = block[i, k]
    return replace(second, dependent=matrix)


def congruent(
    second: SecondDerivatives, D: Matrix, name: Callable[[int, int, Expr], Expr]
) -> list[list[Expr]]:
    """Return L_qq + L_qs D + (L_qs D)^T + D^T L_ss D.

    Parameters
    ----------
    D : sympy.Matrix
        d by n.
    name : callable
        ``name(i, k, expression)`` names entry i, k of L_ss D + L_sq.
    """
    d, n = D.shape
    product = Matrix(
        d,
        n,
        lambda i, k: name(
            i, k, Add(second.mixed[i, k], *(second.dependent[i, m] * D[m, k] for m in range(d)))
        ),
    )
    upper = {
        (k, m): Add(
            second.independent[k, m],
            *(D[i, k] * product[i, m] + second.mixed[i, k] * D[i, m] for i in range(d)),
        )
        for k in range(n)
        for m in range(k, n)
    }
    return [[upper[min(k, m), max(k, m)] for m in range(n)] for k in range(n)]


class Solver:
    """Solver for linear systems with Phi_s, through its named adjugate and determinant.

    Parameters
    ----------
    matrix : sympy.Matrix
        Phi_s, square.
    chain : Chain
        Receives the definitions.
    components : sequence of str
        Names of the dependent coordinates; rotations, whose columns are in m^2, come last.
    rotations : int
        Number of these.
    """

    def __init__(
        self,
        matrix: Matrix,
        vocabulary: Vocabulary,
        chain: Chain,
        components: Sequence[str],
        rotations: int = 0,
    ) -> None:
        n = matrix.shape[0]
        self._matrix, self._vocabulary, self._chain = matrix, vocabulary, chain
        determinant_power = n + rotations
        self._rotations = rotations
        self._minors: dict[tuple[tuple[int, ...], tuple[int, ...]], Expr] = {}
        self.adjugate = Matrix.zeros(n, n)
        for j in range(n):
            for m, component in enumerate(components):
                unit_power = determinant_power - (2 if m >= n - rotations else 1)
                unit = "m" if unit_power == 1 else f"m^{unit_power}"
                name = vocabulary.declare(
                    "A_{i}_{j}", unit, "adjugate of D_l, entry {i}, {j}", "A_{{{i}{j}}}", i=component, j=j + 1
                )
                self.adjugate[m, j] = chain.define(name, self._cofactor(j, m))
        self.determinant = vocabulary.declare(
            "det_D_l", f"m^{determinant_power}", "determinant of D_l", r"\det D_l"
        )
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
        rows, columns = (tuple(i for i in range(n) if i != removed) for removed in (row, column))
        if n < 6:
            return (-1) ** (row + column) * self._minor(rows, columns)
        # Laplace's expansion by the rows above and below the middle, of which few minors are needed.
        upper_rows = tuple(i for i in rows if i < n // 2)
        lower_rows = tuple(i for i in rows if i >= n // 2)
        parts = []
        for chosen in combinations(range(n - 1), len(upper_rows)):
            remaining = tuple(i for i in range(n - 1) if i not in chosen)
            sign = (-1) ** (row + column + sum(chosen) - sum(range(len(upper_rows))))
            upper_minor = self._minor(upper_rows, tuple(columns[i] for i in chosen))
            parts.append(sign * upper_minor * self._minor(lower_rows, tuple(columns[i] for i in remaining)))
        return Add(*parts)

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
                labels = ("".join(str(i + 1) for i in indices) for indices in (rows, columns))
                index = dict(zip(("r", "c"), labels, strict=True))
                what = "minor of D_l, rows {r} and columns {c}"
                rotation_columns = sum(m >= self._matrix.shape[0] - self._rotations for m in columns)
                name = self._vocabulary.declare(
                    "minor_{r}_{c}", f"m^{len(rows) + rotation_columns}", what, "|D_l|_{{{r},{c}}}", **index
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
