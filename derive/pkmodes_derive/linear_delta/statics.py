r"""Static equilibrium at a given platform pose: equation 44.

The carriages hold the pose, so their displacements are zero; the rotations of the six pulleys and the
torques on the three driven ones are unknown.  Axis by axis, with G_j the gradient of the gravitational
potential energy by x_j and E the gradient of the elastic one, linear in the rotations,

.. math:: G_j + E_{x_j} = 0, \qquad E_{\vartheta_{j,free}} = 0, \qquad \tau_j = E_{\vartheta_{j,driven}}.

The linkages carry the forces mu_j s_j that hold platform and linkages up, with D_l^T mu = dV_g/dp; they give
the gravity Hessian its geometric stiffness (`implicit.constrained_hessian`).
"""

from __future__ import annotations

from dataclasses import dataclass

from sympy import Add, Expr, Integer, Symbol, diff

from pkmodes_derive import implicit, lagrangian
from pkmodes_derive.linear_delta.energy import Energies
from pkmodes_derive.linear_delta.kinematics import Kinematics
from pkmodes_derive.linear_delta.machine import Machine
from pkmodes_derive.linear_delta.symbols import Symbols


@dataclass(frozen=True)
class Statics:
    """Named results of the equilibrium.

    Attributes
    ----------
    gravity_gradient : list
        dV_g/dx_j [N].
    gravity_hessian : list of lists
        d2V_g/dx_k dx_l [N/m].
    force_densities : tuple
        mu_j [N/m]: the force in linkage j is mu_j s_j.
    rotations : tuple
        Pulley rotations from the unstrained belts [rad], in the order of the coordinates theta.
    torques : tuple
        Torques on the driven pulleys [N m], positive with theta.
    """

    gravity_gradient: list[Expr]
    gravity_hessian: list[list[Expr]]
    force_densities: tuple[Symbol, ...]
    rotations: tuple[Symbol, ...]
    torques: tuple[Symbol, ...]


def derive(machine: Machine, kinematics: Kinematics, energies: Energies) -> Statics:
    """Solve equation 44 in closed form, axis by axis, and name the solution in the chain of `kinematics`."""
    sy, chain = machine.sy, kinematics.chain
    v = sy.vocabulary
    gravity = lagrangian.gradient(energies.V_g, sy.x, chain)
    mu = _force_densities(sy, kinematics, energies)
    hessian = implicit.constrained_hessian(
        energies.V_g, kinematics.closures, mu, kinematics.independent, tuple(kinematics.D), chain
    )
    # Carriages and released joints hold the pose.
    fixed = (*sy.displacements[:3], *(c.position for c in machine.released))
    carriages_fixed = dict.fromkeys(fixed, Integer(0))
    hessian = [[entry.xreplace(carriages_fixed) for entry in row] for row in hessian]
    # Springs that effects add are relaxed at the pose: only the belts are strained.
    elastic = [diff(energies.V_belts, q).xreplace(carriages_fixed) for q in sy.displacements]
    forces = v.per_axis("G", "N", "gradient of the gravitational potential energy by x_{j}", "G_{j}")
    torques = v.per_axis(
        "tau_st", "N m", "static torque on the driven pulley of axis {j}", r"\tau_{{st,{j}}}"
    )
    rotations: dict[Symbol, Symbol] = {}
    for j in range(3):
        chain.define(forces[j], gravity[j])
        unknown = (sy.displacements[3 + j], sy.displacements[6 + j])
        pulley_1, pulley_2 = elastic[3 + j], elastic[6 + j]
        drives_1, drives_2 = sy.drive[j]
        carriage = [diff(elastic[j], angle) for angle in unknown]
        # The pulley that is not driven carries no torque.
        free = [diff(drives_2 * pulley_1 + drives_1 * pulley_2, angle) for angle in unknown]
        determinant = v.declare(
            "det_{j}", "N^2 m", "determinant of the equilibrium of axis {j}", r"\Delta_{j}", j=j + 1
        )
        chain.define(determinant, carriage[0] * free[1] - carriage[1] * free[0])
        for k, value in enumerate((-forces[j] * free[1], forces[j] * free[0]), start=1):
            name = v.declare(
                "theta_{j}_{k}_st",
                "rad",
                "static rotation of pulley {k} of axis {j} from the unstrained belts",
                r"\vartheta_{{{j},{k},st}}",
                j=j + 1,
                k=k,
            )
            rotations[unknown[k - 1]] = chain.define(name, value / determinant)
        torque = Add(drives_1 * pulley_1, drives_2 * pulley_2)
        chain.define(torques[j], torque.xreplace(rotations))
    return Statics(gravity, hessian, mu, tuple(rotations[angle] for angle in sy.displacements[3:]), torques)


def _force_densities(sy: Symbols, kinematics: Kinematics, energies: Energies) -> tuple[Symbol, ...]:
    """Name mu of D_l^T mu = dV_g/dp, the carriages held."""
    names = sy.vocabulary.per_axis(
        "mu", "N/m", "static force in linkage {j} divided by its length, positive in compression", r"\mu_{j}"
    )
    chain = kinematics.chain
    gradient = [diff(energies.V_g, component) for component in sy.p]
    for name, value in zip(
        names, implicit.multipliers(kinematics.adjugate, kinematics.determinant, gradient), strict=True
    ):
        chain.define(name, value)
    return names
