"""The CoreXY in 60 digits, from its contract (mechanisms.md): see `high_precision_mechanisms`.

Run 1 of belt i grows by g_i . (dx, dy) + eps_i at the tool head, its end at the pulley moves by -R dtheta_i; run 2
moves as much the other way.  Belts and pulleys turn and strain relative to the frame, everything else is carried.
The beam turns by psi_b about its middle: the head, at x + dx, is displaced by psi_b (x + dx - center) along y, and so
are the belts.
"""

from __future__ import annotations

from helpers.references.high_precision_mechanisms import (
    GAUSS,
    HighPrecision,
    Number,
    Particle,
    Turning,
    Values,
    Vector,
    dot,
    exact,
    minus,
    mp,
    plus,
)

BELTS = range(2)
COORDINATES = (
    *("x", "y", "theta_1", "theta_2"),
    *("psi_1", "psi_2", "eps_1", "eps_2", "u_x", "u_y", "psi_b"),
)
HEAD, THETA, PSI, EPS, FRAME = (slice(k, k + 2) for k in (0, 2, 4, 6, 8))
BEAM = 10


class CoreXY(HighPrecision):
    """A CoreXY of some parameters and effects (exact, by name) with its tool head at one pose."""

    coordinates, base, independent = COORDINATES, 4, 2

    def __init__(self, values: Values, effects: Values, pose: Vector) -> None:
        self.q, self.effects, self.pose = values, effects, exact(pose)

    def platform(self, q: Vector) -> Vector:
        return plus(plus(self.pose, self._head(q)), q[FRAME])

    def _head(self, q: Vector) -> Vector:
        """Displacement of the head from the pose, relative to the frame."""
        lever = self.pose[0] + q[0] - self.effects["gantry_racking_center"]
        return [q[0], q[1] + q[BEAM] * lever]

    def _gantry(self, q: Vector) -> Vector:
        """Somewhere on the beam: along x only the frame moves it."""
        return [q[FRAME][0], self.pose[1] + q[HEAD][1] + q[FRAME][1]]

    def free_lengths(self, i: int) -> tuple[Number, Number]:
        """Run 1 and run 2 of a belt at the pose."""
        grown = dot(self.q["belt_path_direction"][i], self.pose)
        first, second = self.q["belt_path_lengths"][i]
        return first + grown, second - grown

    def _ends(self, i: int, q: Vector) -> tuple[Number, Number]:
        """Displacement of run 1 at the tool head and at the pulley, in the direction in which it grows.

        Belts strain in small displacements: the lever is that of the pose.
        """
        lever = self.pose[0] - self.effects["gantry_racking_center"]
        head = dot(self.q["belt_path_direction"][i], [q[0], q[1] + q[BEAM] * lever]) + q[EPS][i]
        return head, -self.q["pulley_radius"][i] * q[THETA][i]

    def particles(self, q: Vector) -> list[Particle]:
        """Tool head with payload, gantry, frame; and three points along each run, relative to the frame."""
        head = self.q["toolhead_mass"] + self.effects["payload_mass"]
        found = [
            Particle(head, self.platform(q)),
            Particle(self.q["gantry_mass"], self._gantry(q)),
            Particle(self.effects["frame_compliance_mass"], q[FRAME]),
        ]
        for i in BELTS:
            at_head, at_pulley = self._ends(i, q)
            for length, sign in zip(self.free_lengths(i), (1, -1), strict=True):
                mass = self.effects["belt_mass_linear_density"] * length
                for fraction, share in GAUSS:
                    moved = sign * (at_head + fraction * (at_pulley - at_head))
                    found.append(Particle(share * mass, [moved]))
        return found

    def turning(self) -> list[Turning]:
        """Pulleys with gear boxes at theta_i, motors at theta_i + psi_i; and the beam."""
        found = [Turning(self.effects["gantry_racking_inertia"], {BEAM: 1})]
        for i in BELTS:
            pulley = self.q["pulley_inertia"][i] + self.effects["gearbox_inertia_inertia"]
            motor = self.q["gear_ratio"][i] ** 2 * self.q["motor_inertia"][i]
            found += [Turning(pulley, {2 + i: 1}), Turning(motor, {2 + i: 1, 4 + i: 1})]
        return found

    def weight(self, q: Vector) -> Number:
        """Tool head with payload and gantry, at height 0."""
        head = self.q["toolhead_mass"] + self.effects["payload_mass"]
        pull = self.q["gravity"][:2]
        return -head * dot(pull, self.platform(q)) - self.q["gantry_mass"] * dot(pull, self._gantry(q))

    def transmission(self, q: Vector) -> Number:
        """Four runs with the stiffness that they have at the pose."""
        tension = self.effects["belt_tension_stiffness_tension"]
        preload = 1 + self.effects["belt_tension_stiffness_coefficient"] * tension
        energy = mp.mpf(0)
        for i in BELTS:
            factor = 1 + self.effects[f"axis_belt_stiffness_factor_{i + 1}"]
            unit = self.q["belt_width"][i] * self.q["belt_specific_stiffness"][i] * factor * preload
            at_head, at_pulley = self._ends(i, q)
            for length in self.free_lengths(i):
                k = 1 / (length / unit + self.effects["belt_end_compliance_compliance"])
                energy += k / 2 * (at_head - at_pulley) ** 2
        return energy

    def other_springs(self, q: Vector) -> Number:
        """The cable from the tool head to ground, relaxed at the pose, and the position loops at the motors."""
        pulled = minus(self.platform(q), self.pose)
        energy = self.effects["cable_stiffness_stiffness"] / 2 * dot(pulled, pulled)
        servo = self.effects["servo_stiffness_stiffness"]
        motors = plus(q[THETA], q[PSI])
        return energy + servo / 2 * dot(motors, motors)
