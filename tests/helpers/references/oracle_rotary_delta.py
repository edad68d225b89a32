"""The rotary delta in 60 digits, from its contract (mechanisms.md): see `high_precision_mechanisms`.

Positions: arm j ends at origin_j + L_a (cos theta z_j + sin theta a_j x z_j); the platform is where the distance of
each joint from the end of its arm is the length of the link, found by Newton's method.  Everything that a frame
carries moves with it by u.
"""

from __future__ import annotations

from functools import cache

from helpers.references.high_precision_mechanisms import (
    CONVERGED,
    GAUSS,
    HighPrecision,
    Number,
    Particle,
    Turning,
    Values,
    Vector,
    combine,
    cross,
    dot,
    exact,
    minus,
    mp,
    plus,
    solve_three,
)

AXES = range(3)
COORDINATES = (
    *("theta_1", "theta_2", "theta_3", "phi_1", "phi_2", "phi_3"),
    *("delta_1", "delta_2", "delta_3", "u_x", "u_y", "u_z"),
)
THETA, PHI, DELTA, FRAME = (slice(k, k + 3) for k in (0, 3, 6, 9))
GEOMETRY = ("origin", "axis", "zero", "joint", "arm_length", "link_length", "branch")


class Loops:
    """Positions relative to the frame, by arm angles and lengths of the links."""

    def __init__(self, geometry: tuple, pose: Vector) -> None:
        q = dict(zip(GEOMETRY, geometry, strict=True))
        self.origin, self.zero, self.joint = q["origin"], q["zero"], q["joint"]
        self.square = [cross(a, z) for a, z in zip(q["axis"], q["zero"], strict=True)]
        self.arm_length, self.link_length, self.branch = q["arm_length"], q["link_length"], q["branch"]
        self.pose, self._rays = pose, dict[tuple[int, Number], Vector]()
        self.theta = [self._closed(j) for j in AXES]
        self._found: dict[tuple, Vector] = {}

    def ray(self, j: int, theta: Number) -> Vector:
        """Direction of an arm; at each of its few angles it is asked for again and again."""
        if (j, theta) not in self._rays:
            c, s = mp.cos(theta), mp.sin(theta)
            self._rays[j, theta] = [c * z + s * u for z, u in zip(self.zero[j], self.square[j], strict=True)]
        return self._rays[j, theta]

    def arm(self, j: int, theta: Number, distance: Number) -> Vector:
        """Point of an arm at a distance from its axis."""
        return combine(self.origin[j], distance, self.ray(j, theta))

    def by_formula(self, j: int) -> Number:
        """Arm angle at the pose by the contract's formula."""
        r = [p + b - o for p, b, o in zip(self.pose, self.joint[j], self.origin[j], strict=True)]
        A, B = dot(r, self.zero[j]), dot(r, self.square[j])
        L, length = self.arm_length[j], self.link_length[j]
        C = (dot(r, r) + L**2 - length**2) / (2 * L)
        theta = mp.atan2(B, A) + self.branch[j] * mp.acos(C / mp.hypot(A, B))
        if theta > mp.pi:
            return theta - 2 * mp.pi
        return theta + 2 * mp.pi if theta <= -mp.pi else theta

    def _closed(self, j: int) -> Number:
        """The same from the closure: the formula takes axis and zero for exactly square, doubles are not."""
        theta = self.by_formula(j)
        joint = plus(self.pose, self.joint[j])
        for _ in range(30):
            link = minus(joint, self.arm(j, theta, self.arm_length[j]))
            ahead = self.ray(j, theta + mp.pi / 2)
            slope = -2 * self.arm_length[j] * dot(link, ahead)
            step = (dot(link, link) - self.link_length[j] ** 2) / slope
            theta -= step
            if abs(step) < CONVERGED:
                return theta
        raise ArithmeticError("Newton's method did not converge")

    def platform(self, turned: Vector, longer: Vector) -> Vector:
        """Platform centre when the arms have turned from the pose and the links are longer."""
        key = (*turned, *longer)
        if key not in self._found:
            self._found[key] = self._newton(turned, longer)
        return self._found[key]

    def _newton(self, turned: Vector, longer: Vector) -> Vector:
        ends = [self.arm(j, self.theta[j] + turned[j], self.arm_length[j]) for j in AXES]
        platform = self.pose
        for _ in range(30):
            links = [minus(plus(platform, self.joint[j]), ends[j]) for j in AXES]
            excess = [(dot(links[j], links[j]) - (self.link_length[j] + longer[j]) ** 2) / 2 for j in AXES]
            move = solve_three(links, excess)
            platform = minus(platform, move)
            if max(map(abs, move)) < CONVERGED:
                return platform
        raise ArithmeticError("Newton's method did not converge")


@cache
def loops(geometry: tuple, pose: tuple) -> Loops:
    """Shared by robots that differ in masses and springs only: solving the loops is what takes the time."""
    return Loops(geometry, pose)


class RotaryDelta(HighPrecision):
    """A rotary delta of some parameters and effects (exact, by name) at one pose of its platform."""

    coordinates, base, independent = COORDINATES, 6, 3

    def __init__(self, values: Values, effects: Values, pose: Vector) -> None:
        self.q, self.effects, self.pose = values, effects, exact(pose)
        self.loops = loops(tuple(values[name] for name in GEOMETRY), self.pose)

    def platform(self, q: Vector) -> Vector:
        return plus(self.loops.platform(q[THETA], q[DELTA]), q[FRAME])

    def _centre_of_arm(self, j: int, q: Vector) -> Vector:
        angle = self.loops.theta[j] + q[j]
        return plus(self.loops.arm(j, angle, self.q["arm_center"][j]), q[FRAME])

    def _ends_of_link(self, j: int, q: Vector) -> tuple[Vector, Vector]:
        arm = self.loops.arm(j, self.loops.theta[j] + q[j], self.loops.arm_length[j])
        return plus(arm, q[FRAME]), plus(self.platform(q), self.loops.joint[j])

    def particles(self, q: Vector) -> list[Particle]:
        """Platform with payload, arms, three points on each link, the frame.

        Of the platform and links nothing turns but the links, whose points follow their two ends.
        """
        found = [Particle(self.q["platform_mass"] + self.effects["payload_mass"], self.platform(q))]
        for j in AXES:
            found.append(Particle(self.q["arm_mass"][j], self._centre_of_arm(j, q)))
            first, last = self._ends_of_link(j, q)
            along = minus(last, first)
            for fraction, share in GAUSS:
                found.append(Particle(share * self.q["link_mass"][j], combine(first, fraction, along)))
        found.append(Particle(self.effects["frame_compliance_mass"], q[FRAME]))
        return found

    def turning(self) -> list[Turning]:
        """Arms about their centres of mass, and motors with gear boxes at phi_j."""
        q, found = self.q, []
        for j in AXES:
            about_centre = q["arm_inertia"][j] - q["arm_mass"][j] * q["arm_center"][j] ** 2
            motor = q["gear_ratio"][j] ** 2 * q["motor_inertia"][j] + self.effects["gearbox_inertia_inertia"]
            found += [Turning(about_centre, {j: 1}), Turning(motor, {3 + j: 1})]
        return found

    def weight(self, q: Vector) -> Number:
        """-g . (m r) of platform with payload, arms at their centres and links midway.

        Of the frame's own weight nothing is said, and it is linear in u: it would change no Hessian.
        """
        heavy = self.q["platform_mass"] + self.effects["payload_mass"]
        moment = [heavy * component for component in self.platform(q)]
        for j in AXES:
            first, last = self._ends_of_link(j, q)
            middle = combine(first, mp.mpf(1) / 2, minus(last, first))
            moment = combine(moment, self.q["link_mass"][j], middle)
            moment = combine(moment, self.q["arm_mass"][j], self._centre_of_arm(j, q))
        return -dot(self.q["gravity"], moment)

    def transmission(self, q: Vector) -> Number:
        energy = mp.mpf(0)
        for j in AXES:
            factor = 1 + self.effects[f"axis_reducer_stiffness_factor_{j + 1}"]
            energy += self.q["reducer_stiffness"][j] * factor / 2 * (q[j] - q[3 + j]) ** 2
        return energy

    def other_springs(self, q: Vector) -> Number:
        """The cable from the platform to ground, relaxed at the pose, and the position loops at the motors."""
        pulled = minus(self.platform(q), self.pose)
        energy = self.effects["cable_stiffness_stiffness"] / 2 * dot(pulled, pulled)
        servo = self.effects["servo_stiffness_stiffness"]
        return energy + servo / 2 * dot(q[PHI], q[PHI])
