r"""Kinetic and potential energies of a machine's parts, as one would write them by hand.

Everything that the modal analysis needs follows from these expressions by differentiation:

* T_ss of the structure (equation 24): point masses; slender rods with end velocities v_e and v_c, each
  :math:`\tfrac{m}{6}(v_e \cdot v_e + v_e \cdot v_c + v_c \cdot v_c)`, translation and rotation together; arms;
  bodies that turn with the platform, :math:`\tfrac12 m v^2 + \tfrac12 \omega \cdot J \omega`; parts of legs, whose
  direction u turns with :math:`\dot u = (\dot s - u \dot l)/l`;
* T_t of rotors and motors (equations 28 to 30);
* V_g (equation 26 with the sign of a potential energy);
* V_el of belts and reducers about a reference configuration (equations 34 to 41).

Effects add energies, dissipate and release locked coordinates.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from sympy import Add, Expr, Integer, Rational, Symbol, collect, diff, expand

from pkmodes_derive.assembly.kinematics import Kinematics
from pkmodes_derive.machine import Machine
from pkmodes_derive.parts import Body, Leg
from pkmodes_derive.vectors import axis, cross, dot
from pkmodes_derive.vocabulary import AXES

HALF, SIXTH = Rational(1, 2), Rational(1, 6)
#: A velocity: pairs of a rate and the vector it multiplies.
Velocity = list[tuple[Expr, tuple[Expr, ...]]]
BASIS = tuple(tuple(Integer(i == k) for k in range(3)) for i in range(3))


@dataclass(frozen=True)
class Energies:
    """The energies [J] and the named values they use.

    Attributes
    ----------
    T_ss, T_t : sympy.Expr
        Kinetic energy of the structure and of the transmissions.
    V_g : sympy.Expr
        Gravitational potential energy.
    V_el : sympy.Expr
        Elastic potential energy of the transmissions and of springs that effects add, in small displacements from
        the reference configuration; without the springs of released coordinates.
    V_transmissions : sympy.Expr
        The part of V_el that static rotations strain.
    V_r : tuple of sympy.Expr
        Energy of the spring of each released coordinate.
    V_loss : sympy.Expr
        The part of V_el with the imaginary parts of the stiffnesses, to first order in the loss factors, in place of
        these.
    R : sympy.Expr
        Dissipation function [W]: half the power that viscous friction takes.
    D_p_dot : tuple of tuple
        Time derivative of the platform Jacobian (equation 17), index [direction][k-1].
    stiffnesses : tuple of sympy.Symbol
        Stiffnesses of belt runs and reducers in the reference configuration.
    """

    T_ss: Expr
    T_t: Expr
    V_g: Expr
    V_el: Expr
    V_transmissions: Expr
    V_r: tuple[Expr, ...]
    V_loss: Expr
    R: Expr
    D_p_dot: tuple[tuple[Expr, ...], ...]
    stiffnesses: tuple[Symbol, ...]


def derive(machine: Machine, kinematics: Kinematics) -> Energies:
    """Write the energies; named values are defined in the chain of `kinematics`."""
    inertias = _rotor_inertias(machine)
    stiffnesses = (*_define_belts(machine), *_define_transmissions(machine))
    _define_platform_motion(machine, kinematics)
    D_p_dot = _jacobian_rate(machine, kinematics)
    if machine.links:
        _differentiate_motion(machine, kinematics, D_p_dot)
    transmissions = _elastic_energy(machine)
    springs = zip(machine.released, machine.compliances, strict=True)
    return Energies(
        T_ss=_structure_energy(machine),
        T_t=_transmission_energy(machine, inertias),
        V_g=_gravity_potential(machine),
        V_el=Add(transmissions, *machine.elastic),
        V_transmissions=transmissions,
        V_r=tuple(HALF * q.position**2 / c for q, c in springs),
        V_loss=_loss_energy(machine),
        R=Add(*machine.dissipation),
        D_p_dot=D_p_dot,
        stiffnesses=stiffnesses,
    )


def _differentiate_motion(
    machine: Machine, kinematics: Kinematics, D_p_dot: Sequence[Sequence[Expr]]
) -> None:
    """Set d(v_p)/dq_k = sum_l P_kl qdot_l, which is column k of the time derivative of D_p (equation 49).

    For the angular velocity the columns differ by its cross product with that per unit of qdot_k (`turning`).
    """
    first = len(machine.directions)
    for k, q in enumerate(machine.independent):
        column = [row[k] for row in D_p_dot]
        for v, rate in zip(machine.v_p, column[:first], strict=True):
            kinematics.chain.rule(v, q, rate)
        if machine.turning is not None:
            rates = machine.turning.rates
            commutator = machine.turning.commutator(tuple(kinematics.D_p[first:, k]), rates)
            for w, rate, correction in zip(rates, column[first:], commutator, strict=True):
                kinematics.chain.rule(w, q, rate + correction)


def _define_platform_motion(machine: Machine, kinematics: Kinematics) -> None:
    """Define velocity and, if effects need it, small displacement of the platform: D times the coordinates."""
    indices = [machine.coordinates.index(q) for q in machine.independent]
    rates = [*(machine.velocities[i] for i in indices), *(c.rate for c in machine.moving)]
    small = [*(machine.displacements[i] for i in indices), *(c.position for c in machine.moving)]
    for i in range(len(machine.directions)):
        row, frame = kinematics.D[i, :], machine.frame[i]
        velocity = Add(*(d * rate for d, rate in zip(row, rates, strict=True)), *(c.rate for c in frame))
        machine.define(machine.v_p[i], velocity)
        if machine.delta_p:
            displaced = Add(*(d * q for d, q in zip(row, small, strict=True)), *(c.position for c in frame))
            machine.define(machine.delta_p[i], displaced)
    if machine.turning is not None:
        for i, w in enumerate(machine.turning.rates, start=len(machine.directions)):
            machine.define(w, Add(*(d * rate for d, rate in zip(kinematics.D[i, :], rates, strict=True))))


def velocity(machine: Machine, position: Sequence[Expr]) -> Velocity:
    """Return the absolute velocity of a body-fixed point."""
    lever = tuple(a - b for a, b in zip(position, machine.platform, strict=True))
    turning = machine.turning
    fixed = turning.symbols if turning is not None else set()
    if not any(component.free_symbols - fixed - _constant_symbols(machine) for component in lever):
        terms = [
            (v, BASIS[AXES.index(name)]) for v, name in zip(machine.v_p, machine.directions, strict=True)
        ]
        if turning is not None and any(lever):
            rotations = zip(turning.rates, turning.axes, strict=True)
            terms += [(w, cross(axis(name), lever)) for w, name in rotations]
        return terms
    terms = []
    released = (*machine.moving, *machine.swinging)
    at_pose = dict.fromkeys((c.position for c in released), Integer(0))
    rates = {q: machine.velocities[machine.coordinates.index(q)] for q in machine.independent}
    for q, rate in {**rates, **{c.position: c.rate for c in released}}.items():
        partial_velocity = tuple(
            machine.chain.derivative(component, q).xreplace(at_pose) for component in position
        )
        if any(partial_velocity):
            terms.append((rate, partial_velocity))
    frame = zip(machine.frame_rate, BASIS, strict=True)
    return [*terms, *((rate, partial_velocity) for rate, partial_velocity in frame if rate != 0)]


def _body_energy(machine: Machine, body: Body, w: Sequence[Symbol]) -> Expr:
    """Return the kinetic energy of a body with the angular velocity w of the platform."""
    v, axes = velocity(machine, body.centre), range(len(w))
    rotation = Add(*(w[i] * body.inertia[i][k] * w[k] for i in axes for k in axes))
    return HALF * body.mass * _product(machine, v, v) + HALF * rotation


def _leg_energy(machine: Machine, leg: Leg) -> Expr:
    """Return the kinetic energy of the bodies of a leg, from the velocity of its vector s and its rate l_dot.

    Its direction u = s/l turns with u_dot = (s_dot - u l_dot)/l, and u . s_dot = l_dot, so the square of u_dot is
    (s_dot . s_dot - l_dot^2) / l^2.
    """
    start, end = (velocity(machine, position) for position in leg.ends)
    relative = [*end, *((-rate, vector) for rate, vector in start)]
    l_dot = machine.velocities[machine.coordinates.index(leg.length)]
    T = HALF * leg.inertia * _product(machine, relative, relative)
    T += HALF * (leg.moving_mass - leg.inertia) * l_dot**2
    if start:
        direction = tuple(component / leg.length for component in leg.vector)
        rotation = [(rate * leg.moment / leg.length, vector) for rate, vector in relative]
        rotation.append((-l_dot * leg.moment / leg.length, direction))
        momentum = [(rate * leg.moving_mass, vector) for rate, vector in relative]
        T += HALF * leg.mass * _product(machine, start, start) + _product(
            machine, start, [*momentum, *rotation]
        )
    return T


def _constant_symbols(machine: Machine) -> set[Symbol]:
    """Return the symbols that no motion changes."""
    return {symbol for field in machine.tables.fields for symbol in field.symbols}


def _product(machine: Machine, a: Velocity, b: Velocity) -> Expr:
    """Return the scalar product of two velocities; the square of a unit vector is 1."""
    return Add(*(p * q * scalar(machine, u, w) for p, u in a for q, w in b))


def scalar(machine: Machine, u: tuple[Expr, ...], w: tuple[Expr, ...]) -> Expr:
    """Return the scalar product of two vectors; that of a unit vector with itself is 1."""
    if u == w and (u in machine.units or u in BASIS):
        return Integer(1)
    for unit in machine.units if u == w else ():  # a unit vector times a length
        factors = {component / e for component, e in zip(u, unit, strict=True) if e != 0 or component != 0}
        if len(factors) == 1 and not (factor := factors.pop()).free_symbols & set(unit):
            return factor**2
    return dot(u, w)


def _structure_energy(machine: Machine) -> Expr:
    T = Add(*machine.kinetic)
    for body in (*machine.points, *machine.loads):
        v = velocity(machine, body.position)
        T += HALF * body.mass * _product(machine, v, v)
    for rod in machine.rods:
        v_e, v_c = (velocity(machine, end) for end in rod.ends)
        pairs = ((v_e, v_e), (v_e, v_c), (v_c, v_c))
        T += SIXTH * rod.mass * Add(*(_product(machine, a, b) for a, b in pairs))
    for arm in machine.arms:
        rate = machine.velocities[machine.coordinates.index(arm.angle)]
        lever = tuple(machine.chain.derivative(component, arm.angle) for component in arm.centre)
        shift = tuple(a + b for a, b in zip(machine.frame_rate, arm.shift, strict=True))
        T += HALF * arm.inertia * rate**2 + arm.mass * (rate * dot(lever, shift) + HALF * dot(shift, shift))
    T += Add(*(_leg_energy(machine, leg) for leg in machine.legs))
    if machine.turning is not None:
        return T + Add(*(_body_energy(machine, body, machine.turning.rates) for body in machine.bodies))
    # One coefficient for each product of velocities: the apparent mass.
    v_p = machine.v_p
    return collect(expand(T), [c**2 for c in v_p] + list(v_p))


def _transmission_energy(machine: Machine, inertias: Sequence[Expr]) -> Expr:
    """Return the kinetic energy of rotors and motors; wind-up turns a motor further than its driven rotor."""
    T = Add(
        *(
            HALF * moment * machine.rotation_rate(rotor) ** 2
            for moment, rotor in zip(inertias, machine.rotors, strict=True)
        )
    )
    for drive in machine.drives:
        wound = drive.wound_rate
        for rotor, driven in drive.rotors:
            T += driven * drive.motor * (machine.rotation_rate(rotor) * wound + HALF * wound**2)
    return T


def _jacobian_rate(machine: Machine, kinematics: Kinematics) -> tuple[tuple[Expr, ...], ...]:
    """Return D_p_dot = D_l^-1 (D_r_dot - D_l_dot D_p), equation 17; the rows of D_l_dot are the rates of s_j."""
    n = len(machine.independent)
    if kinematics.solver is None:
        return tuple((Integer(0),) * n for _ in machine.directions)
    v, chain, q = machine.vocabulary, machine.chain, machine.independent
    q_dot = [machine.velocities[machine.coordinates.index(coordinate)] for coordinate in q]
    s_dot = []
    for j, link in enumerate(machine.links):
        what = "rate of change of linkage vector {j}"
        s_dot.append(machine.vector("s_dot_{j}", "m/s", what, r"\dot{{s}}_{j}", j=j + 1))
        for m in range(len(link.vector)):
            rates = (chain.derivative(link.vector[m], q[k]) * q_dot[k] for k in range(n))
            machine.define(s_dot[j][m], Add(*rates))
    units = machine.unit_by(q[0], "1/s", "m/s"), machine.unit_by(q[0], "1/(m s)", "1/s")
    names = tuple(
        tuple(
            v.declare(
                "D_p_dot_{i}_{k}",
                units[axis not in machine.directions],
                f"time derivative of dp_{{i}}/d{machine.stem}_{{k}}",
                r"(\dot{{D}}_p)_{{{i}{k}}}",
                i=axis,
                k=k + 1,
            )
            for k in range(n)
        )
        for axis in machine.components
    )
    D_l_dot = [[*s_dot[j], *_moment_rates(machine, kinematics, j, q_dot)] for j in range(len(s_dot))]
    for k in range(n):
        right = []
        for j, link in enumerate(machine.links):
            diagonal_entry = chain.definitions[kinematics.D_r[j, j]]
            rate = (
                _diagonal_rate(machine, diagonal_entry, link.vector, s_dot[j], q[j], q_dot[j])
                if j == k
                else 0
            )
            right.append(rate - dot(D_l_dot[j], tuple(kinematics.D_p[:, k])))
        for m, component in enumerate(kinematics.solver.solve(right)):
            machine.define(names[m][k], component)
    return names


def _moment_rates(
    machine: Machine, kinematics: Kinematics, j: int, q_dot: Sequence[Symbol]
) -> tuple[Symbol, ...]:
    """Name the time derivatives of the entries of D_l that belong to rotations."""
    names = []
    for m, name in enumerate(machine.components[len(machine.directions) :], start=len(machine.directions)):
        rates = (
            machine.chain.derivative(kinematics.D_l[j, m], q) * rate
            for q, rate in zip(machine.independent, q_dot, strict=True)
        )
        what = "rate of change of the moment of linkage vector {j}, component {i}"
        latex = r"(\dot{{D}}_l)_{{{j}{i}}}"
        rate = machine.vocabulary.declare("D_l_dot_{j}_{i}", "m^2/s", what, latex, j=j + 1, i=name)
        names.append(machine.define(rate, Add(*rates)))
    return tuple(names)


def _diagonal_rate(
    machine: Machine, entry: Expr, s: Sequence[Symbol], s_dot: Sequence[Symbol], q: Symbol, q_dot: Symbol
) -> Expr:
    """Return the time derivative of an entry of D_r from the rates of its link vector and its coordinate."""
    by_vector = Add(*(diff(entry, component) * rate for component, rate in zip(s, s_dot, strict=True)))
    return by_vector + machine.chain.derivative(entry, q, hold=s) * q_dot


def _gravity_potential(machine: Machine) -> Expr:
    """Return V_g = -g . sum m r; the weight of a rod acts midway (equations 4 and 26)."""
    frame = machine.frame_position
    bodies = [(body.mass, body.position) for body in (*machine.points, *machine.loads)]
    bodies += [(arm.mass, arm.centre) for arm in machine.arms]
    bodies += [(body.mass, body.centre) for body in machine.bodies]
    for rod in machine.rods:
        midway = tuple((a + b) * HALF for a, b in zip(*rod.ends, strict=True))
        bodies.append((rod.mass, midway))
    moment = [
        Add(
            *(mass * (position[m] + frame[m]) for mass, position in bodies),
            *(leg.mass * (leg.ends[0][m] + frame[m]) + leg.weight * leg.vector[m] for leg in machine.legs),
        )
        for m in range(3)
    ]
    return -dot(
        machine.gravity, tuple(collect(expand(component), list(machine.dependent)) for component in moment)
    )


def _rotor_inertias(machine: Machine) -> list[Expr]:
    """Return the moments of inertia of the rotors; motor and gearbox belong to the driven one (after equation 30)."""
    moments: list[Expr] = []
    for rotor in machine.rotors:
        moment = rotor.inertia
        for drive in machine.drives:
            moment += Add(
                *(driven * (drive.motor + drive.inertia) for r, driven in drive.rotors if r is rotor)
            )
        moments.append(moment if rotor.name is None else machine.define(rotor.name, moment))
    return moments


def _define_belts(machine: Machine) -> tuple[Symbol, ...]:
    """Define free lengths and stiffnesses of the spans (equations 34 to 37) in the reference configuration.

    Small displacements leave the stiffnesses constant (the paper, before equation 38): V_el is written in
    displacements, and derivatives with respect to displacements do not differentiate the stiffnesses.
    """
    for belt in machine.belts:
        modulus = belt.effective_modulus
        for run in belt.runs:
            machine.define(run.length, run.free_length)
            # 1/k = l/(w k_sp (1 + a)) + c, rearranged so that c = 0 is not a special case.
            machine.define(run.stiffness, modulus / (run.length + belt.compliance * modulus))
    return tuple(run.stiffness for belt in machine.belts for run in belt.runs)


def _define_transmissions(machine: Machine) -> tuple[Symbol, ...]:
    for spring in machine.transmissions:
        machine.define(spring.stiffness, spring.declared * (1 + spring.change))
    return tuple(spring.stiffness for spring in machine.transmissions)


def _loss_energy(machine: Machine) -> Expr:
    """Return the energy with imaginary stiffnesses: that of a span is eta k^2 l/(w k_sp), lossless in series."""
    V = []
    for belt in machine.belts:
        modulus = belt.effective_modulus
        for run in belt.runs:
            a, b = (machine.displacement(*end) for end in run.ends)
            V.append(HALF * belt.loss * run.stiffness**2 * run.length / modulus * (a - b) ** 2)
    for spring in machine.transmissions:
        V.append(HALF * spring.loss * spring.stiffness * machine.displacement(spring.twist) ** 2)
    return Add(*V)


def _elastic_energy(machine: Machine) -> Expr:
    """Return the elastic energy of belts (equation 38 with the sign of a potential energy), reducers and legs."""
    V = []
    for belt in machine.belts:
        for run in belt.runs:
            a, b = (machine.displacement(*end) for end in run.ends)
            V.append(HALF * run.stiffness * (a - b) ** 2)
    for spring in machine.transmissions:
        V.append(HALF * spring.stiffness * machine.displacement(spring.twist) ** 2)
    return Add(*V)
