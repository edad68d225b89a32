r"""Exact derivatives of M and K by every parameter, at a fixed platform pose.

With the pose held, a parameter moves the carriages by inverse kinematics, and with them the linkages, belts
and link forces.  Three quantities are given by the implicit function theorem once more, so that nothing has
to be differentiated through square roots and inverses: with theta a parameter,

.. math::
    \frac{dx_j}{d\theta} = \frac{\Phi_{j,\theta}}{(D_r)_{jj}}, \qquad
    D_l \frac{dD}{d\theta} = \frac{d(-\Phi_q)}{d\theta} - \frac{dD_l}{d\theta} D, \qquad
    D_l^T \frac{d\mu}{d\theta} = \frac{dV_p}{d\theta} - \frac{dD_l^T}{d\theta} \mu .

Everything else is the chain rule over named values.  Where the parameter moves no carriage, most of it is zero:
those parameters have a function of their own, which is several times shorter than that of the geometry.
"""

from __future__ import annotations

from collections.abc import Sequence

from sympy import Add, Expr, Symbol, diff

from pkmodes_derive import implicit
from pkmodes_derive.chain import Chain
from pkmodes_derive.linear_delta.energy import Energies
from pkmodes_derive.linear_delta.kinematics import Kinematics
from pkmodes_derive.linear_delta.machine import Machine
from pkmodes_derive.linear_delta.statics import Statics


def values(machine: Machine) -> tuple[Symbol, ...]:
    """Parameters by which M and K are differentiated and that move no carriage, in the order of the arrays.

    Directions, branches and driven pulleys are choices, not quantities.  The compliances of released joints are
    not in M and K but in the springs that are added to K.
    """
    sy = machine.sy
    by_axis = (
        sy.m_d,
        sy.m_t,
        sy.l_t,
        sy.k_sp,
        sy.w_b,
        sy.R_p,
        sy.I_p,
        sy.I_m,
        sy.i_g,
        sy.x_min,
        sy.x_max,
    )
    springs = set(machine.compliances)
    of_effects = (s for field in machine.fields for s in field.symbols if s not in springs)
    return (sy.m_p, *sy.g, *(s for group in by_axis for s in group), *of_effects)


def geometry(machine: Machine) -> tuple[Symbol, ...]:
    """Parameters that move the carriages.

    A rail's origin enters only through its difference from the platform joint, so its derivatives are those by
    the joint with opposite sign.
    """
    sy = machine.sy
    return (*(c for vector in sy.b for c in vector), *sy.l_d)


class PoseChain:
    """The chain rule at a fixed pose: definitions as they are evaluated, rules by the theorem above."""

    def __init__(
        self,
        machine: Machine,
        kinematics: Kinematics,
        energies: Energies,
        statics: Statics,
        parameters: Sequence[Symbol],
    ) -> None:
        self.parameters = tuple(parameters)
        self.machine, self.kinematics, self.energies, self.statics = machine, kinematics, energies, statics
        self.chain = Chain()
        for symbol, expression in kinematics.definitions.items():
            self.chain.define(symbol, expression)
        for theta in self.parameters:
            self._follow(theta)

    def derivatives(self, matrix: Sequence[Sequence[Expr]]) -> list[dict[tuple[int, int], Expr]]:
        """Derivatives of a symmetric matrix by every parameter: entries of its upper triangle that are not zero."""
        n = len(matrix)
        found = []
        for theta in self.parameters:
            upper = {
                (k, m): self.chain.derivative(matrix[k][m], theta) for k in range(n) for m in range(k, n)
            }
            found.append({place: entry for place, entry in upper.items() if entry != 0})
        return found

    def _follow(self, theta: Symbol) -> None:
        """State how carriages, Jacobian and link forces follow a parameter."""
        kin, chain, sy = self.kinematics, self.chain, self.machine.sy
        rates = [chain.derivative(phi, theta, hold=sy.x) for phi in kin.closures]
        for j, rate in enumerate(rates):
            if rate != 0:
                rate = rate.xreplace(kin.reference)
                chain.rule(sy.x[j], theta, self._name(sy.x[j], theta, rate / kin.D_r[j, j]))
        s_rate = [[self._name(s, theta, chain.derivative(s, theta)) for s in vector] for vector in kin.s]
        for k in range(len(kin.independent)):
            right = [
                chain.derivative(kin.right[j, k], theta)
                - Add(*(s_rate[j][m] * kin.D[m, k] for m in range(3)))
                for j in range(3)
            ]
            for m, solution in enumerate(implicit.solve_3x3(kin.adjugate, kin.determinant, right)):
                self._state(kin.D[m, k], theta, solution)
        mu = self.statics.force_densities
        gradient = [diff(self.energies.V_g, component) for component in sy.p]
        right = [
            chain.derivative(gradient[m], theta) - Add(*(s_rate[j][m] * mu[j] for j in range(3)))
            for m in range(3)
        ]
        for j, solution in enumerate(implicit.multipliers(kin.adjugate, kin.determinant, right)):
            self._state(mu[j], theta, solution)

    def _state(self, symbol: Symbol, theta: Symbol, derivative: Expr) -> None:
        # A rule of zero is stated as well: it keeps the chain from following the definition instead.
        self.chain.rule(symbol, theta, self._name(symbol, theta, derivative))

    def _name(self, symbol: Symbol, theta: Symbol, derivative: Expr) -> Expr:
        if derivative == 0:
            return derivative
        name = self.machine.sy.vocabulary.derivative(symbol, theta)
        return self.chain.define(name, derivative)
