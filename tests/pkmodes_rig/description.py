"""The robots of the virtual test rig as MuJoCo bodies, joints and springs, with every effect built in.

No formula of the derived model is used, and no effect is an energy or a matrix: each effect is built from mechanical
parts.  A compliance is a joint with a spring, a mass is a body, a cable is a spring, and a rod that stretches is
three lumps of mass on a slide.  The tree of bodies determines which parts move together.

The rig also has causes outside the catalogue (`OUTSIDE`), to test the diagnosis of a robot that no hypothesis
describes.
"""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from pkmodes_generated.linear_delta import Parameters
from pkmodes_rig.mujoco_engine import _add as add
from pkmodes_rig.mujoco_engine import _mass as inertial
from pkmodes_rig.mujoco_engine import carriage_positions

AXES = range(3)

#: Parameters of the catalogue's effects with their null values.
EFFECTS: dict[str, float] = {
    "payload.mass": 0.0,
    "belt_mass.linear_density": 0.0,
    "gearbox_inertia.inertia": 0.0,
    "servo_stiffness.stiffness": 0.0,
    "belt_end_compliance.compliance": 0.0,
    "axis_belt_stiffness.factor_1": 0.0,
    "axis_belt_stiffness.factor_2": 0.0,
    "axis_belt_stiffness.factor_3": 0.0,
    "belt_tension_stiffness.coefficient": 0.0,
    "belt_tension_stiffness.tension": 0.0,
    "cable_stiffness.stiffness": 0.0,
    "gearbox_compliance.compliance": 0.0,
    "link_compliance.compliance": 0.0,
    "clamp_compliance.compliance": 0.0,
    "frame_compliance.compliance": 0.0,
    "frame_compliance.mass": 50.0,
}

#: Causes outside the catalogue.  The strength of each is the quantity in brackets.
OUTSIDE: dict[str, str] = {
    "tuned_absorber": "a [mass in kg] on the platform slides in one direction on a spring tuned to 60 Hz",
    "directional_cable": "a spring of [stiffness in N/m] holds the platform centre to ground in one direction only",
    "hose": "a spring of [stiffness in N/m] couples the carriages of axes 1 and 2",
    "worn_belt": "a patch of every belt, which moves with the belt, has a local compliance larger by [a factor - 1]",
    "bellows": "a spring of [stiffness in N/m] holds every carriage to its rail",
    "rocking_frame": "the frame also turns about a horizontal axis on a spring of [compliance in rad/(N m)]",
    "thermal_drift": "frequencies change by [relative change per pose] in the order of measurement",
    "rod_taper": "the relative mass per length of a rod changes linearly from 1 - [a] at the carriage to 1 + a",
    "one_gearbox": "only the gearbox of axis 2 winds up by [compliance in rad/(N m)]",
    "one_servo": "only the position loop of axis 2 holds its driven pulley like a spring of [stiffness in N m/rad]",
    "one_span": "the belt of axis 3 yields by [compliance in m/N] at a splice between its pulleys",
    "leaning_frame": "the frame moves in one oblique direction only, on a spring of [compliance in m/N]",
    "pulley_mount": "the bearing of every pulley 2 yields along the rail by [compliance in m/N]",
}

#: Directions in which the tuned absorber and the leaning frame slide and the cable pulls; none is in a plane of
#: symmetry of any robot.
ABSORBER_DIRECTION = np.array([2.0, 1.0, -2.0]) / 3
ABSORBER_FREQUENCY = 60.0
CABLE_DIRECTION = np.array([6.0, -3.0, 2.0]) / 7
LEANING_DIRECTION = np.array([2.0, -6.0, 3.0]) / 7
#: Inertia of the rocking frame [kg m^2], and depth of its axis below the middle of the rails [m].
ROCKING_INERTIA = 4.0
ROCKING_DEPTH = 0.4
#: Mass of the block that holds pulley 2, as a fraction of the carriage mass.
BLOCK = 0.2
#: Centre and half width of the worn patch of a belt, as fractions of the travel, from the clamp towards pulley 1.
PATCH_CENTRE, PATCH_WIDTH = 0.4, 0.15
#: Lumps at the ends and middle of a uniform bar, exact for a velocity that is linear along it (Simpson's rule).
LUMPS = np.array([1.0, 4.0, 1.0]) / 6

SPAN_NODES, SPAN_WEIGHTS = np.polynomial.legendre.leggauss(80)


@dataclass
class Description:
    """A robot for the engine.

    Attributes
    ----------
    xml : str
        MJCF, assembled at the pose with every joint at zero.
    coordinates : dict of str to str
        Joint of each generalised coordinate, in order.
    motors : dict of str to str
        Joint of the motor that turns the rotor of a coordinate.
    points : list of str
        Bodies that are point masses, without rotational inertia.
    massless : list of str
        Bodies without mass.
    ties : list of str
        Tendons of constant length: gears, and the middles of the rods.
    belt_lumps : dict of str to float
        Masses of lumps of belt by the tendons whose lengths are their displacements [kg].
    """

    xml: str = ""
    coordinates: dict[str, str] = field(default_factory=dict)
    motors: dict[str, str] = field(default_factory=dict)
    points: list[str] = field(default_factory=list)
    massless: list[str] = field(default_factory=list)
    ties: list[str] = field(default_factory=list)
    belt_lumps: dict[str, float] = field(default_factory=dict)


def describe(
    parameters: Parameters, p: np.ndarray, effects: Mapping[str, float], outside: Mapping[str, float]
) -> Description:
    """Describe a robot at pose `p` with these effects."""
    unknown = [*(effects.keys() - EFFECTS.keys()), *(outside.keys() - OUTSIDE.keys())]
    if unknown:
        raise ValueError(f"unknown effects or causes: {', '.join(sorted(unknown))}")
    settings = {**EFFECTS, **dict.fromkeys(OUTSIDE, 0.0), **effects, **outside}
    return _Builder(parameters, np.asarray(p, dtype=float), settings).description


class _Builder:
    """Assembles the parts; the coordinates are in the order of docs/model.md."""

    def __init__(self, parameters: Parameters, p: np.ndarray, settings: Mapping[str, float]) -> None:
        self.parameters, self.p, self.s = parameters, p, settings
        self.x = carriage_positions(parameters, p)
        self.description = Description()
        root = ET.Element("mujoco")
        add(root, "compiler", angle="radian", boundmass=0.0, boundinertia=0.0, balanceinertia="false")
        add(
            root, "option", gravity=np.zeros(3)
        )  # the rig adds gravity itself, from the accelerations of the bodies
        self.world = ET.SubElement(root, "worldbody")
        self.tendons = ET.SubElement(root, "tendon")
        self.platform = self._platform()
        frame = self._frame()
        for j in AXES:
            self._carriage(frame, j)
        for j in AXES:
            self._transmission(j)
        self._cables()
        self.description.coordinates = self._coordinates()
        self.description.xml = ET.tostring(root, encoding="unicode")

    # Parts -------------------------------------------------------------------------------------------------

    def _platform(self) -> ET.Element:
        """Add the platform, which translates relative to ground and does not rotate."""
        platform = self._point(self.world, "platform", self.parameters.platform_mass, pos=self.p)
        for name, axis in zip("xyz", np.eye(3), strict=True):
            # The isotropic cable, relaxed at the pose.
            self._slide(platform, f"platform_{name}", axis, stiffness=self.s["cable_stiffness.stiffness"])
        if self.s["payload.mass"]:
            self._point(platform, "payload", self.s["payload.mass"])
        mass = self.s["tuned_absorber"]
        if mass:
            absorber = self._point(platform, "absorber", mass)
            stiffness = mass * (2 * np.pi * ABSORBER_FREQUENCY) ** 2
            self._slide(absorber, "absorber", ABSORBER_DIRECTION, stiffness=stiffness)
        return platform

    def _frame(self) -> ET.Element:
        """Add the body that carries the rails, or return the ground if nothing moves it."""
        translation, rotation = self.s["frame_compliance.compliance"], self.s["rocking_frame"]
        leaning = self.s["leaning_frame"]
        if not translation and not rotation and not leaning:
            return self.world
        middles = np.mean(self.parameters.limits, axis=1)[:, None] * self.parameters.direction
        weight = np.linalg.norm(self.parameters.gravity)
        down = self.parameters.gravity / weight if weight else np.array([0.0, 0.0, -1.0])
        self.frame_origin = np.mean(self.parameters.origin + middles, axis=0) + ROCKING_DEPTH * down
        frame = add(self.world, "body", name="frame", pos=self.frame_origin)
        inertial(frame, self.s["frame_compliance.mass"], np.full(3, ROCKING_INERTIA))
        if translation:
            for name, axis in zip("xyz", np.eye(3), strict=True):
                self._slide(frame, f"u_{name}", axis, stiffness=1 / translation)
        if leaning:
            self._slide(frame, "lean", LEANING_DIRECTION, stiffness=1 / leaning)
        if rotation:
            # Through the frame's centre of mass, so its weight has no effect.
            across = np.eye(3)[np.argmin(np.abs(down))]
            axis = np.cross(down, across)
            add(frame, "joint", name="rock", type="hinge", axis=axis, stiffness=1 / rotation)
        return frame

    def _carriage(self, frame: ET.Element, j: int) -> None:
        """Add carriage, belt clamp and rod of axis j to the frame; the rod is pinned to the platform."""
        direction, length = self.parameters.direction[j], float(self.parameters.link_length[j])
        end = self.parameters.origin[j] + self.x[j] * direction
        place = end if frame is self.world else end - self.frame_origin
        carriage = self._point(frame, f"carriage_{j}", self.parameters.carriage_mass[j], pos=place)
        self._slide(carriage, f"carriage_{j}", direction, stiffness=self.s["bellows"])
        if self.s["clamp_compliance.compliance"]:
            clamp = self._point(carriage, f"clamp_{j}", 0.0)  # a child, so relative to the carriage
            self._slide(clamp, f"clamp_{j}", direction, stiffness=1 / self.s["clamp_compliance.compliance"])

        lumps = self.parameters.link_mass[j] * LUMPS * (1 + self.s["rod_taper"] * np.array([-1, 0, 1]))
        to_joint = self.p + self.parameters.joint[j] - end
        rod = self._point(carriage, f"rod_{j}", lumps[0], zaxis=to_joint)
        add(rod, "joint", name=f"ball_{j}", type="ball")
        middle = self._point(rod, f"rod_middle_{j}", lumps[1], pos=np.array([0, 0, length / 2]))
        far = self._point(rod, f"rod_far_{j}", lumps[2], pos=np.array([0, 0, length]))
        compliance = self.s["link_compliance.compliance"]
        if compliance:
            along = np.array([0.0, 0.0, 1.0])
            self._slide(middle, f"middle_{j}", along)
            self._slide(far, f"delta_{j}", along, stiffness=1 / compliance)
            self._tie(f"middle_{j}", {f"middle_{j}": 2.0, f"delta_{j}": -1.0})  # half the elongation
        add(far, "site", name=f"rod_end_{j}")
        add(self.platform, "site", name=f"platform_joint_{j}", pos=self.parameters.joint[j])

    def _transmission(self, j: int) -> None:
        """Add pulleys, gearbox, motor and belt of axis j.

        Pulleys and motor rotate relative to the frame, and their masses count as part of the frame's: here they are
        at the origin of the ground and only rotate.  The compliant block of pulley 2 is modelled in the same way.
        """
        for k in (1, 2):
            pulley = f"pulley_{j}_{k}"
            body = self._wheel(self.world, pulley, self.parameters.pulley_inertia[j])
            driven = bool(self.parameters.drive[j, k - 1])
            own = self.s["one_servo"] if driven and j == 1 else 0.0
            self._hinge(body, pulley, stiffness=own)
            if driven:
                self.description.motors[f"theta_{j + 1}_{k}"] = f"motor_{j}"
                if self.s["gearbox_inertia.inertia"]:
                    self._wheel(body, f"gear_{j}", self.s["gearbox_inertia.inertia"])
                self._motor(j, body, pulley)
        if self.s["pulley_mount"]:
            block = self._point(self.world, f"mount_{j}", BLOCK * self.parameters.carriage_mass[j])
            direction = self.parameters.direction[j]
            self._slide(block, f"mount_{j}", direction, stiffness=1 / self.s["pulley_mount"])
        self._belt(j)

    def _motor(self, j: int, body: ET.Element, pulley: str) -> None:
        ratio = float(self.parameters.gear_ratio[j])
        rotor = self._wheel(self.world, f"motor_{j}", self.parameters.motor_inertia[j])
        self._hinge(rotor, f"motor_{j}", stiffness=self.s["servo_stiffness.stiffness"] / ratio**2)
        follows = {f"motor_{j}": 1.0, pulley: -ratio}
        compliance = self._wind_up(j)
        if compliance:
            # The output shaft rotates relative to the pulley; only the motor behind the gear has inertia.
            shaft = self._point(body, f"shaft_{j}", 0.0)
            self._hinge(shaft, f"psi_{j}", stiffness=1 / compliance)
            follows[f"psi_{j}"] = -ratio
        self._tie(f"gear_{j}", follows)

    def _wind_up(self, j: int) -> float:
        return self.s["gearbox_compliance.compliance"] + (self.s["one_gearbox"] if j == 1 else 0.0)

    def _belt(self, j: int) -> None:
        """Add three spans: pulley to pulley, carriage to pulley 2, carriage to pulley 1."""
        (low, high), half = self.parameters.limits[j], self.parameters.carriage_length[j] / 2
        radius = float(self.parameters.pulley_radius[j])
        rim_1, rim_2 = {f"pulley_{j}_1": radius}, {f"pulley_{j}_2": radius}
        clamp = {f"carriage_{j}": 1.0}
        if self.s["clamp_compliance.compliance"]:
            clamp[f"clamp_{j}"] = 1.0
        yields = (
            {f"mount_{j}": -1.0} if self.s["pulley_mount"] else {}
        )  # pulley 2 towards pulley 1 slackens it
        lengths = high - low, self.x[j] - low - half, high - self.x[j] - half
        if min(lengths) <= 0:
            raise ValueError(f"carriage {j + 1} is beyond its limits")
        # Along the belt from the clamp: to pulley 1, back to pulley 2, and to the clamp again.
        wrap = np.pi * radius
        starts = lengths[2] + wrap, lengths[2] + lengths[0] + 2 * wrap, 0.0
        pulls: tuple[tuple[dict[str, float], dict[str, float], dict[str, float]], ...]
        pulls = ((rim_2, rim_1, yields), (clamp, rim_2, yields), (rim_1, clamp, {}))
        for k, (length, start, (ahead, behind, mount)) in enumerate(zip(lengths, starts, pulls, strict=True)):
            elongation = _sum({**ahead, **mount}, behind, 1.0, -1.0)
            splice = self.s["one_span"] if (j, k) == (2, 0) else 0.0
            self._tendon(f"span_{j}_{k}", elongation, 1 / (self._span_compliance(j, start, length) + splice))
            density = self.s["belt_mass.linear_density"]
            if density:
                for i, (along, part) in enumerate(zip((0.0, 0.5, 1.0), LUMPS, strict=True)):
                    name = f"lump_{j}_{k}_{i}"
                    self._tendon(name, _sum(ahead, behind, 1 - along, along))
                    self.description.belt_lumps[name] = part * density * length

    def _span_compliance(self, j: int, start: float, length: float) -> float:
        """Compute the compliance of a span: the sum over its pieces and its ends."""
        specific = self.parameters.belt_specific_stiffness[j] * (
            1 + self.s[f"axis_belt_stiffness.factor_{j + 1}"]
        )
        specific *= (
            1 + self.s["belt_tension_stiffness.coefficient"] * self.s["belt_tension_stiffness.tension"]
        )
        travel = self.parameters.limits[j, 1] - self.parameters.limits[j, 0]
        place = start + length / 2 * (1 + SPAN_NODES)
        worn = np.exp(-(((place / travel - PATCH_CENTRE) / PATCH_WIDTH) ** 2))
        pieces = SPAN_WEIGHTS / 2 * (1 + self.s["worn_belt"] * worn)
        whole = length / (self.parameters.belt_width[j] * specific)
        return float(whole * pieces.sum() + self.s["belt_end_compliance.compliance"])

    def _cables(self) -> None:
        if self.s["directional_cable"]:
            pull = {f"platform_{name}": c for name, c in zip("xyz", CABLE_DIRECTION, strict=True)}
            self._tendon("directional_cable", pull, self.s["directional_cable"])
        if self.s["hose"]:
            self._tendon("hose", {"carriage_0": 1.0, "carriage_1": -1.0}, self.s["hose"])

    def _coordinates(self) -> dict[str, str]:
        every = {f"x_{j + 1}": f"carriage_{j}" for j in AXES}
        every |= {f"theta_{j + 1}_{k}": f"pulley_{j}_{k}" for k in (1, 2) for j in AXES}
        every |= {f"psi_{j + 1}": f"psi_{j}" for j in AXES}
        every |= {f"delta_{j + 1}": f"delta_{j}" for j in AXES}
        every |= {f"eps_{j + 1}": f"clamp_{j}" for j in AXES}
        every |= {name: name for name in ("u_x", "u_y", "u_z", "lean", "absorber", "rock")}
        every |= {f"mount_{j + 1}": f"mount_{j}" for j in AXES}
        joints = {joint.get("name") for joint in self.world.iter("joint")}
        return {name: joint for name, joint in every.items() if joint in joints}

    # Elements ----------------------------------------------------------------------------------------------

    def _point(self, parent: ET.Element, name: str, mass: float, **place: object) -> ET.Element:
        """Add a body without rotational inertia: a lump, or a body that does not rotate."""
        body = add(parent, "body", name=name, **place)
        inertial(body, float(mass) or 1.0, np.full(3, 1.0))  # the engine's compiler requires both
        self.description.points.append(name)
        if not mass:
            self.description.massless.append(name)
        return body

    def _wheel(self, parent: ET.Element, name: str, inertia: float) -> ET.Element:
        body = add(parent, "body", name=name)
        inertial(body, 1.0, np.full(3, float(inertia)))
        return body

    def _slide(self, body: ET.Element, name: str, axis: np.ndarray, stiffness: float = 0.0) -> None:
        add(body, "joint", name=name, type="slide", axis=axis, stiffness=stiffness)

    def _hinge(self, body: ET.Element, name: str, stiffness: float = 0.0) -> None:
        add(body, "joint", name=name, type="hinge", axis=np.array([0.0, 0.0, 1.0]), stiffness=stiffness)

    def _tie(self, name: str, coefficients: Mapping[str, float]) -> None:
        self._tendon(f"tie_{name}", coefficients)
        self.description.ties.append(f"tie_{name}")

    def _tendon(self, name: str, coefficients: Mapping[str, float], stiffness: float = 0.0) -> None:
        tendon = add(self.tendons, "fixed", name=name, stiffness=stiffness, springlength=0.0)
        for joint, coefficient in coefficients.items():
            add(tendon, "joint", joint=joint, coef=coefficient)


def _sum(a: Mapping[str, float], b: Mapping[str, float], of_a: float, of_b: float) -> dict[str, float]:
    return {name: of_a * a.get(name, 0.0) + of_b * b.get(name, 0.0) for name in {**a, **b}}
