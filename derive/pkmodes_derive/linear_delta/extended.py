"""The linear delta with effects: extended M and K, and their derivatives by every parameter.

The base model is the leading block: released coordinates are relative, so locking one is deleting its row
and column.  M and K are those of free joints; the stiffness 1/c of each released joint is added to the
diagonal of K by whoever knows which joints are released.
"""

from __future__ import annotations

from collections.abc import Sequence

from sympy import Expr, Integer, Symbol, diff

from pkmodes_derive import lagrangian
from pkmodes_derive.effect import Effect
from pkmodes_derive.functions import Argument, FieldGroup, Function, Model, Output
from pkmodes_derive.linear_delta import energy, kinematics, sensitivity, statics
from pkmodes_derive.linear_delta.machine import Machine
from pkmodes_derive.linear_delta.symbols import Symbols

Places = tuple[tuple[int, int], ...]

UNITS_M, UNITS_K = "kg, kg m, kg m^2", "N/m, N, N m"


def derive(effects: Sequence[Effect]) -> Model:
    """Derive the extended model for the given effects."""
    extended = _Extended(effects)
    machine, sy = extended.machine, extended.machine.sy
    place = {
        symbol: (field.name, index)
        for field in (*sy.fields, *machine.fields)
        for symbol, index in zip(field.symbols, field.indices, strict=True)
    }
    of_values, of_geometry = sensitivity.values(machine), sensitivity.geometry(machine)
    values, places = extended.sensitivities(
        "value_sensitivities",
        "Derivatives of M and K by every parameter that moves no carriage, at a fixed platform pose.",
        "chain rule",
        of_values,
        "",
    )
    geometry, places_of_geometry = extended.sensitivities(
        "geometry_sensitivities",
        "Derivatives of M and K by the platform joints and link lengths, at a fixed platform pose.",
        "implicit function theorem and chain rule; the carriages follow the parameter",
        of_geometry,
        "; by a rail's origin, the opposite of those by its joint",
    )
    return Model(
        mechanism="linear_delta",
        coordinates=tuple(
            (q.name, sy.vocabulary[q].unit)
            for q in (*sy.coordinates, *(c.position for c in machine.released))
        ),
        vocabulary=sy.vocabulary,
        groups=(
            FieldGroup("Parameters", "parameters", sy.fields, declared=False),
            FieldGroup("Effects", "effects", machine.fields, null=0.0),
        ),
        functions=(
            extended.matrices(),
            extended.platform_motion(),
            extended.joints(),
            extended.static_equilibrium(),
            values,
            geometry,
        ),
        constants=(
            (
                "The effects: name, sentence, whether it ties the platform to ground, released coordinates, and "
                "parameters as (name, unit, description, exclusive lower bound, whether it can be fitted).",
                "EFFECTS",
                tuple(_described(effect) for effect in effects),
            ),
            (
                "By which parameters the derivatives are taken: field of Parameters or Effects, index in it, and the "
                "(row, column) of the entries of M and of K that depend on it, in the upper triangle.",
                "VALUE_SENSITIVITIES",
                tuple((*place[theta], *entries) for theta, entries in zip(of_values, places, strict=True)),
            ),
            (
                "The same for the geometry, which moves the carriages.",
                "GEOMETRY_SENSITIVITIES",
                tuple(
                    (*place[theta], *entries)
                    for theta, entries in zip(of_geometry, places_of_geometry, strict=True)
                ),
            ),
        ),
    )


def _described(effect: Effect) -> tuple[object, ...]:
    parameters = tuple((p.name, p.unit, p.description, p.greater_than, p.fitted) for p in effect.parameters)
    return (effect.name, effect.sentence, effect.grounds, effect.coordinates, parameters)


class _Extended:
    """The extended matrices, and the functions that give them."""

    def __init__(self, effects: Sequence[Effect]) -> None:
        self.machine = machine = Machine(Symbols(), effects)
        self.kin = kin = kinematics.derive(machine)
        self.energies = energies = energy.derive(machine, kin)
        self.equilibrium = equilibrium = statics.derive(machine, kin, energies)
        sy = machine.sy
        self.pose = (Argument("p", sy.p, "m", "platform centre in the base frame"),)
        rates = (*sy.velocities, *(c.rate for c in machine.released))
        small = (*sy.displacements, *(c.position for c in machine.released))
        self.n = len(rates)
        self.M = lagrangian.mass_matrix(energies.T_ss + energies.T_t, rates, kin.chain)
        # Displacements are small: Jacobian and belt stiffnesses are those of the reference configuration.
        constant = (*kin.D, *(k for axis in machine.k for k in axis))
        self.K_el = kin.chain.hessian(energies.V_el, small, hold=constant)
        self.K_g = self._place(equilibrium.gravity_hessian)
        self.J_p = [[kin.chain.derivative(component, rate) for rate in rates] for component in machine.v_p]

    def _place(self, block: Sequence[Sequence[Expr]]) -> list[list[Expr]]:
        """Put a matrix in the coordinates of the closures into the matrix in all coordinates."""
        order = [c.position for c in self.machine.released]
        base = len(self.machine.sy.coordinates)
        index = [k if k < 3 else base + order.index(q) for k, q in enumerate(self.kin.independent)]
        placed = [[Integer(0)] * self.n for _ in range(self.n)]
        for row, k in enumerate(index):
            for column, m in enumerate(index):
                placed[k][m] = block[row][column]
        return placed

    def matrices(self) -> Function:
        shape = (self.n, self.n)
        return Function(
            "extended_matrices",
            "Mass and stiffness matrices in the base and all released coordinates, joints free.",
            "equations 24 to 48 with the effects' energies; K = K_el + K_g and the joints' stiffnesses",
            self.pose,
            (
                Output(
                    "M", shape, _flat(self.M), UNITS_M, "mass matrix; the base model's is the leading block"
                ),
                Output("K_el", shape, _flat(self.K_el), UNITS_K, "elastic stiffness, released joints free"),
                Output(
                    "K_g", shape, _flat(self.K_g), UNITS_K, "Hessian of the gravitational potential energy"
                ),
            ),
            self.kin.definitions,
        )

    def joints(self) -> Function:
        positions = [c.position for c in self.machine.released]
        stiffness = [diff(energy_, q, q) for energy_, q in zip(self.energies.V_r, positions, strict=True)]
        rates = [diff(k, c) for k, c in zip(stiffness, self.machine.compliances, strict=True)]
        n = len(positions)
        return Function(
            "joint_stiffness",
            "Stiffnesses of the released joints, to be added to the diagonal of K.",
            "energy q^2 / (2 c) of each joint",
            (),
            (
                Output(
                    "kappa", (n,), tuple(stiffness), "N/m, N m", "in the order of the released coordinates"
                ),
                Output("kappa_c", (n,), tuple(rates), "N^2/m^2, N^2 m^2", "derivatives by the compliances"),
            ),
            {},
            "Infinite for a compliance of zero: a locked joint.",
        )

    def platform_motion(self) -> Function:
        """The absolute motion of the platform."""
        entries = _flat(self.J_p)
        return Function(
            "extended_platform_motion",
            "Absolute motion of the platform centre by the coordinates.",
            "equation 15, with what released joints and the frame add",
            self.pose,
            (Output("J_p", (3, self.n), entries, "1, m", "dp_i/dq_k, base frame"),),
            self.kin.definitions,
        )

    def static_equilibrium(self) -> Function:
        """Equation 44."""
        return Function(
            "extended_static_equilibrium",
            "Torques and pulley rotations that hold the pose, the effects' weights and belts included.",
            "equation 44; springs that effects add are relaxed at the pose, and the released joints hold",
            self.pose,
            (
                Output("tau_st", (3,), self.equilibrium.torques, "N m", "torques on the driven pulleys"),
                Output(
                    "theta_st", (6,), self.equilibrium.rotations, "rad", "rotations from the unstrained belts"
                ),
            ),
            self.kin.definitions,
        )

    def sensitivities(
        self, name: str, title: str, source: str, parameters: Sequence[Symbol], also: str
    ) -> tuple[Function, tuple[tuple[Places, Places], ...]]:
        """The derivatives, and for each parameter which entries of M and of K they are."""
        chain = sensitivity.PoseChain(self.machine, self.kin, self.energies, self.equilibrium, parameters)
        K = [[a + b for a, b in zip(*rows, strict=True)] for rows in zip(self.K_el, self.K_g, strict=True)]
        dM, dK = (chain.derivatives(matrix) for matrix in (self.M, K))
        function = Function(
            name,
            title,
            source,
            self.pose,
            (
                _listed("M_theta", dM, "unit of M by that of the parameter", "dM/dtheta"),
                _listed("K_theta", dK, "unit of K by that of the parameter", "dK/dtheta"),
            ),
            chain.chain.definitions,
            f"The entries of the upper triangles that {name.upper()} lists, all others being zero{also}.",
            in_c=False,
        )
        return function, tuple(zip(map(tuple, dM), map(tuple, dK), strict=True))


def _listed(
    name: str, derivatives: Sequence[dict[tuple[int, int], Expr]], unit: str, description: str
) -> Output:
    entries = tuple(entry for matrix in derivatives for entry in matrix.values())
    return Output(name, (len(entries),), entries, unit, description, listed=True)


def _flat(rows: object) -> tuple[Expr, ...]:
    return tuple(entry for row in rows for entry in row)
