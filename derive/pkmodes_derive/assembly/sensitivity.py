r"""Exact derivatives of M and K with respect to every parameter, at a fixed pose.

With the pose held, a parameter moves the independent coordinates through the inverse kinematics, and with them links,
belts and link forces.  The implicit function theorem gives three of the derivatives, so nothing has to be
differentiated through square roots and inverses.  For a parameter theta,

.. math::
    \frac{dq_j}{d\theta} = \frac{\Phi_{j,\theta}}{(D_r)_{jj}}, \qquad
    D_l \frac{dD}{d\theta} = \frac{d(-\Phi_q)}{d\theta} - \frac{dD_l}{d\theta} D, \qquad
    D_l^T \frac{d\mu}{d\theta} = \frac{dV_p}{d\theta} - \frac{dD_l^T}{d\theta} \mu .

Everything else follows from the chain rule over named values.  For parameters that move no coordinate most terms are
zero: they have a separate function, several times shorter than the one for the geometry.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from sympy import Add, Expr, Symbol, diff

from pkmodes_derive.assembly.derived import Derived, matrix_sum
from pkmodes_derive.chain import Chain
from pkmodes_derive.machine import Machine
from pkmodes_description import CHOICES

#: Entries of a matrix, (row, column).
Entries = tuple[tuple[int, int], ...]


def values(machine: Machine, moving: Sequence[Symbol]) -> tuple[Symbol, ...]:
    """Return the parameters of M and K that move no coordinate, in the order of the arrays.

    Directions, branches and driven pulleys are choices, not quantities.  The compliances of released joints are
    not in M and K but in the springs that are added to K.
    """
    springs = {symbol for compliance in machine.compliances for symbol in compliance.free_symbols}
    of_effects = (s for field in machine.effect_fields for s in field.symbols if s not in springs)
    return (*(s for s in _quantities(machine) if s not in moving), *of_effects)


def geometry(derived: Derived) -> tuple[Symbol, ...]:
    """Return the parameters that move the independent coordinates.

    A quantity that enters only through its difference from another, such as a rail's origin from the platform joint,
    is left out: its derivatives are the negatives of the other's.
    """
    closures = {s for phi in derived.kin.closures for s in derived.kin.chain.expand(phi).free_symbols}
    return tuple(s for s in _quantities(derived.machine) if s in closures)


def _quantities(machine: Machine) -> list[Symbol]:
    choices = {key.field for table in machine.tables.described() for key in table.keys if key.kind in CHOICES}
    left_out = choices | set(machine.differences)
    return [s for field in machine.tables.fields if field.name not in left_out for s in field.symbols]


def affected_entries(derived: Derived, parameters: Sequence[Symbol]) -> list[tuple[Entries, Entries]]:
    """Return, for each parameter, the entries of M and of K in the upper triangle that it may change."""
    definitions = derived.kin.definitions
    inputs_of: dict[Symbol, frozenset[Symbol]] = {}
    for symbol, value in definitions.items():
        inputs_of[symbol] = _inputs(value, inputs_of)
    by_matrix = []
    for matrix in (derived.M, matrix_sum(derived.K_el, derived.K_g)):
        n = range(len(matrix))
        inputs = {(k, m): _inputs(matrix[k][m], inputs_of) for k in n for m in n if k <= m}
        by_matrix.append(
            [tuple(entry for entry, symbols in inputs.items() if theta in symbols) for theta in parameters]
        )
    of_M, of_K = by_matrix
    return list(zip(of_M, of_K, strict=True))


def _inputs(expression: Expr, inputs_of: Mapping[Symbol, frozenset[Symbol]]) -> frozenset[Symbol]:
    """Return the inputs that an expression depends on, from those of the values that it uses."""
    return frozenset().union(*(inputs_of.get(s, frozenset((s,))) for s in expression.free_symbols))


class PoseChain:
    """The chain rule at a fixed pose: definitions in evaluation order, rules from the theorem above."""

    def __init__(self, derived: Derived, parameters: Sequence[Symbol]) -> None:
        self.derived, self.parameters = derived, tuple(parameters)
        self.chain = Chain()
        for symbol, expression in derived.kin.definitions.items():
            self.chain.define(symbol, expression)
        for theta in self.parameters:
            self._set_rules(theta)

    def derivatives(self, matrix: Sequence[Sequence[Expr]]) -> list[dict[tuple[int, int], Expr]]:
        """Return the derivatives of a symmetric matrix by parameter: nonzero entries of the upper triangle."""
        n = len(matrix)
        by_parameter = []
        for theta in self.parameters:
            upper = {
                (k, m): self.chain.derivative(matrix[k][m], theta) for k in range(n) for m in range(k, n)
            }
            by_parameter.append({place: entry for place, entry in upper.items() if entry != 0})
        return by_parameter

    def _set_rules(self, theta: Symbol) -> None:
        """Set the derivatives of independent coordinates, Jacobian and link forces with respect to a parameter."""
        machine, kin, chain = self.derived.machine, self.derived.kin, self.chain
        if kin.solver is None:
            return
        independent = machine.independent
        constant = (*independent, *machine.turned)
        rates = [chain.derivative(phi, theta, hold=constant) for phi in kin.closures]
        for j, rate in enumerate(rates):
            if rate != 0:
                rate = rate.xreplace(kin.reference)
                rate_of_coordinate = self._name(independent[j], theta, rate / kin.D_r[j, j])
                chain.rule(independent[j], theta, rate_of_coordinate)
            else:
                rate_of_coordinate = rate
            for symbol, (q, derivative) in machine.turned.items():
                if q == independent[j]:  # the symbol is a function of this coordinate alone
                    chain.rule(symbol, theta, derivative * rate_of_coordinate)
        s = [link.vector for link in machine.links]
        s_rate = [[self._name(c, theta, chain.derivative(c, theta)) for c in vector] for vector in s]
        for k in range(len(kin.independent)):
            right = [
                chain.derivative(kin.right[j, k], theta)
                - Add(*(s_rate[j][m] * kin.D[m, k] for m in range(len(machine.dependent))))
                for j in range(len(s))
            ]
            for m, solution in enumerate(kin.solver.solve(right)):
                self._set_rule(kin.D[m, k], theta, solution)
        mu = self.derived.equilibrium.force_densities
        gradient = [diff(self.derived.energies.V_g, component) for component in machine.dependent]
        right = [
            chain.derivative(gradient[m], theta) - Add(*(s_rate[j][m] * mu[j] for j in range(len(s))))
            for m in range(len(gradient))
        ]
        for j, solution in enumerate(kin.solver.multipliers(right)):
            self._set_rule(mu[j], theta, solution)

    def _set_rule(self, symbol: Symbol, theta: Symbol, derivative: Expr) -> None:
        # A zero is set as well: without a rule the chain would differentiate the definition.
        self.chain.rule(symbol, theta, self._name(symbol, theta, derivative))

    def _name(self, symbol: Symbol, theta: Symbol, derivative: Expr) -> Expr:
        if derivative == 0:
            return derivative
        name = self.derived.machine.vocabulary.derivative(symbol, theta)
        return self.chain.define(name, derivative)
