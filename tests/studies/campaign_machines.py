"""Machines of the suite of campaigns: what they lack, how they dissipate, and how a laboratory measures them.

Everything is drawn from the seed and the number of the machine, before anything is measured.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from pkmodes_rig import ROBOTS as DELTAS
from pkmodes_rig import drawn_values
from pkmodes_rig.robots import with_effects, with_free_motors
from pkmodes_rig.signals.campaigns import Paper
from pkmodes_rig.signals.integration import responses
from pkmodes_rig.signals.modal_tests import STEP, Direction, Flaws, ModalTest
from pkmodes_rig.signals.sensors import Room, Sensor
from pkmodes_rig.signals.small_motion import Losses
from pkmodes_rig.signals.visits import Machine, Visit, Wander
from studies.mechanism_sizes import SIZES
from studies.motors import shows
from studies.sizes import EFFECT_SIZES, OUTSIDE_SIZES
from studies.specimens import KINDS, MACHINES, ROBOTS, SIX_LEGGED, Specimen, robot_of, with_effect
from studies.strengths import outside_causes

#: How many of sixty machines lack nothing, and how many something that the catalogue does not have.
COMPLETE, OUTSIDE = 5, 7
#: Every so many machines with rails have Coulomb friction on them.
RUBBING = 5
#: Coordinates along rails, and those on arms, with the distance at which a force acts on an arm [m].
RAILS = {"linear_delta": ("x_1", "x_2", "x_3"), "rotary_delta": (), "corexy": ("x", "y")}
ARMS = {"rotary_delta": ("theta_1", "theta_2", "theta_3")}
LEVER = 0.3
KINDS_OF_RECORD = ("frf", "impact", "ambient")
FORMATS = ("universal", "matlab", "universal")
#: Lowest end of a band [Hz], and highest one that the laboratory can measure.
LOWEST, HIGHEST = 8.0, 400.0


@dataclass(frozen=True)
class CampaignCase:
    """A machine of the suite.

    Attributes
    ----------
    seed, number, of : int
        Identify it: machine `number` of `of`.
    robot : str
        One of `specimens.MACHINES`.
    kind : str
        Of its records.
    held : bool
    cause : str
        An effect of the catalogue, a cause outside it, or "" for none.
    outside : bool
    """

    seed: int
    number: int
    of: int
    robot: str
    kind: str
    held: bool
    cause: str
    outside: bool

    @property
    def names(self) -> tuple[str, ...]:
        """Causes that should be named."""
        return () if self.outside or not self.cause else (self.cause,)

    @property
    def label(self) -> str:
        """Name for reports."""
        return f"{self.number + 1}: {self.robot}, motors {'held' if self.held else 'free'}, {self.kind}"


def cases(seed: int, of: int = 60) -> list[CampaignCase]:
    """Return the machines of a seed: robots and kinds in equal shares, in any combination."""
    rng = np.random.default_rng([seed, 1])
    names = [name for name in MACHINES if name not in SIX_LEGGED]
    robots = rng.permutation([names[i % len(names)] for i in range(of)])
    kinds = rng.permutation([KINDS_OF_RECORD[i % 3] for i in range(of)])
    held = rng.permutation([i % 2 == 0 for i in range(of)])
    complete, outside = (round(of * count / 60) for count in (COMPLETE, OUTSIDE))
    groups = rng.permutation([0] * complete + [1] * outside + [2] * (of - complete - outside))
    turns: dict[tuple[str, int], int] = {}
    found = []
    for n in range(of):
        robot, group = str(robots[n]), int(groups[n])
        causes = ([""], _outside(robot), _effects(robot))[group]
        drives = "held" if held[n] else "free"
        turn = turns.get((robot, group), int(rng.integers(len(causes))))
        while group and not shows(drives, (causes[turn % len(causes)],)):
            turn += 1
        turns[robot, group] = turn + 1
        cause = causes[turn % len(causes)]
        found.append(CampaignCase(seed, n, of, robot, str(kinds[n]), bool(held[n]), cause, group == 1))
    return found


def _effects(robot: str) -> list[str]:
    table = EFFECT_SIZES[robot] if robot in DELTAS else SIZES[robot]["one effect"]
    return [name for name in table if name != "one alone"]


def _outside(robot: str) -> list[str]:
    return list(_outside_sizes(robot))


def _outside_sizes(robot: str) -> dict[str, float]:
    if robot in SIZES:
        # A soft end of one run of a CoreXY is equivalent to another free length.
        table = SIZES[robot]["outside the catalogue"]
        return {name: sizes[-1] for name, sizes in table.items() if name != "one_run"}
    sizes: dict[str, float] = {}
    for (name, own, _, _), size in zip(outside_causes(), OUTSIDE_SIZES, strict=True):
        if own == robot:
            sizes[name] = max(size, sizes.get(name, 0.0))
    return sizes


@dataclass(frozen=True, eq=False)
class Bench:
    """A machine on the bench, and how it will be measured.

    Attributes
    ----------
    robot : str
        Text of the robot file.
    poses : ndarray, shape (N, d)
    unkind : tuple of str
        What goes wrong, in words.
    """

    machine: Machine
    robot: str
    poses: np.ndarray
    repeats: int
    wander: Wander
    test: ModalTest
    paper: Paper
    unkind: tuple[str, ...]


def bench(case: CampaignCase, rng: np.random.Generator) -> Bench:
    """Draw the machine of a case and its laboratory."""
    kind = MACHINES[case.robot]
    poses = kind.points[np.sort(rng.permutation(len(kind.points))[: rng.integers(4, 7)])]
    unkind: list[str] = []
    if rng.random() < 1 / 12:
        poses = poses[:3]
        unkind.append("few rows")
    machine = _machine(case, rng)
    still = machine.at(Visit(poses[0], np.zeros(_axes(case.robot)))).truth.natural
    band = _band(still, rng)
    sensors = _sensors(case, rng, unkind)
    test = _test(case, sensors, rng, len(poses), unkind)
    if case.number % RUBBING == 0 and RAILS[_mechanism(case.robot)]:
        machine = _rubbing(machine, case, poses[0], test, still[0], rng)
        unkind.append("Coulomb friction")
    wander = Wander(float(rng.uniform(0.001, 0.003)), 2e-4, float(rng.uniform(0.0, 0.002)))
    paper = Paper(
        band,
        kind.components,
        "held" if case.held else "free",
        tones=(50.0,) if rng.random() < 0.5 else (),
        format=str(rng.choice(FORMATS)) if case.kind == "ambient" else _format(rng),
        angles=frozenset(ARMS.get(_mechanism(case.robot), ())),
    )
    repeats = int(rng.choice([2, 3, 3, 4]))
    return Bench(machine, _text(case.robot), poses, repeats, wander, test, paper, tuple(unkind))


def _format(rng: np.random.Generator) -> str:
    return str(rng.choice([*FORMATS, "table"]))


def _mechanism(robot: str) -> str:
    return str(robot_of(robot).mechanism_name)


def _axes(robot: str) -> int:
    return 2 if _mechanism(robot) == "corexy" else 3


def _text(robot: str) -> str:
    return with_effects(robot, {}) if robot in DELTAS else with_free_motors(ROBOTS / KINDS[robot].file)


def _machine(case: CampaignCase, rng: np.random.Generator) -> Machine:
    """Draw the true values of a machine: the uncertain ones by their priors, the cause, and its losses."""
    declared, factor = robot_of(case.robot), float(np.exp(rng.uniform(0.0, np.log(2.5))))
    true = Specimen(case.robot, values=drawn_values(declared, rng)).built()
    effects, outside = dict(true.constants), dict[str, float]()
    if case.outside:
        outside[case.cause] = factor * _outside_sizes(case.robot)[case.cause]
    elif case.cause:
        effects |= _effect(case.robot, case.cause, factor)
    mass = _mass(true.parameters)
    viscous = float(rng.uniform(0.001, 0.004)) * 2.0 * np.pi * 60.0 * mass
    losses = Losses(
        float(rng.uniform(0.002, 0.006)),
        dict.fromkeys(RAILS[_mechanism(case.robot)], viscous),
        factor=float(rng.uniform(0.0, 0.01)),
    )
    return Machine(MACHINES[case.robot].rig, true.parameters, effects, outside, losses, case.held)


def _effect(robot: str, cause: str, factor: float) -> Mapping[str, float]:
    table = EFFECT_SIZES[robot] if robot in DELTAS else SIZES[robot]["one effect"]
    known = {name: v for name, v in robot_of(robot).constants.items() if name.startswith(f"{cause}.")}
    return {**known, **with_effect(robot, cause, factor * table[cause][-1]).effects}


def _mass(parameters: object) -> float:
    name = "platform_mass" if hasattr(parameters, "platform_mass") else "toolhead_mass"
    return float(getattr(parameters, name))


def _band(natural: np.ndarray, rng: np.random.Generator) -> tuple[float, float]:
    """Return the band that a laboratory chooses after a look at the spectrum; in one case of three it is narrow."""
    seen = natural[(natural > LOWEST) & (natural < HIGHEST / 1.3)]
    low = max(LOWEST, seen[0] * rng.uniform(0.5, 0.85))
    top = seen[-1] if rng.random() < 2 / 3 or len(seen) < 4 else seen[len(seen) // 2]
    return float(f"{low:.3g}"), float(f"{min(HIGHEST, top * rng.uniform(1.1, 1.4)):.3g}")


def _sensors(case: CampaignCase, rng: np.random.Generator, unkind: list[str]) -> tuple[Sensor, ...]:
    """Return the sensors: sensitivities off by 0.5 %, mounted askew by 1 %."""
    names = list(MACHINES[case.robot].shapes)
    if rng.random() < 1 / 6 and len(names) > 4:
        names = [names[i] for i in np.sort(rng.permutation(len(names))[:4])]
        unkind.append("four sensors")
    found = []
    for name in names:
        others = [other for other in MACHINES[case.robot].shapes if other.startswith("p_") and other != name]
        across = {other: 0.01 * rng.standard_normal() for other in others} if name.startswith("p_") else {}
        found.append(Sensor(name, 1.0 + 0.005 * rng.standard_normal(), across))
    if rng.random() < 1 / 12:
        wrong = int(rng.integers(len(found)))
        found[wrong] = replace(found[wrong], gain=1.1 * found[wrong].gain)
        unkind.append("a gain of 1.1")
    return tuple(found)


def _test(
    case: CampaignCase,
    sensors: tuple[Sensor, ...],
    rng: np.random.Generator,
    poses: int,
    unkind: list[str],
) -> ModalTest:
    mass, loud = _mass(robot_of(case.robot).parameters), float(np.exp(rng.uniform(-0.7, 0.7)))
    room = Room(
        10.0 ** rng.uniform(*((-7.0, -5.5) if case.kind == "ambient" else (-6.0, -4.5))),
        10.0 ** rng.uniform(-2.5, -1.3),
        10.0 ** rng.uniform(-2.5, -1.3),
        float(rng.uniform(40.0, 150.0)),
    )
    dead = None
    if rng.random() < 1 / 12:
        dead = int(rng.integers(len(sensors)))
        unkind.append("a dead channel")
    places = [(int(rng.integers(poses)), 0)]
    if case.kind == "impact":
        double = frozenset(places if rng.random() < 1 / 4 else ())
        clipped = frozenset({(int(rng.integers(poses)), 1)} if rng.random() < 1 / 6 else ())
        unkind += ["a double hit"] * bool(double) + ["an overload"] * bool(clipped)
        flaws = Flaws(double, clipped, dead)
        hits, seconds = int(rng.choice([1, 1, 3])), float(rng.choice([4.0, 6.0]))
        exciters: tuple[Direction, ...] = _exciters(case, rng)[:1]
        return ModalTest(
            "impact", sensors, room, exciters, 25.0 * mass * loud, seconds, hits=hits, flaws=flaws
        )
    if case.kind == "frf":
        exciters = _exciters(case, rng)[: int(rng.integers(1, 3))]
        return ModalTest(
            "frf", sensors, room, exciters, 1.3 * mass * loud, 8.0, averages=3, flaws=Flaws(dead=dead)
        )
    density = (0.02 * mass * loud) ** 2
    everywhere = tuple(_everywhere(case.robot))
    return ModalTest("ambient", sensors, room, everywhere, density, 40.0, flaws=Flaws(dead=dead))


def _everywhere(robot: str) -> list[Direction]:
    """Return all directions in which ambient forces act: on the platform, and on carriages or arms."""
    platform = [name for name in MACHINES[robot].shapes if name.startswith("p_")]
    on_arms: list[Direction] = [{name: LEVER} for name in ARMS.get(_mechanism(robot), ())]
    return [*({name: 1.0} for name in (*platform, *RAILS[_mechanism(robot)])), *on_arms]


def _exciters(case: CampaignCase, rng: np.random.Generator) -> tuple[Direction, Direction]:
    """Return where a hammer or shaker acts: the platform, mostly obliquely, and a carriage or an arm."""
    platform = [name for name in MACHINES[case.robot].shapes if name.startswith("p_")]
    along = rng.uniform(0.4, 1.0, len(platform)) * rng.choice([-1.0, 1.0], len(platform))
    if rng.random() < 1 / 4:
        along = np.eye(len(platform))[rng.integers(len(platform))]
    along = along / np.linalg.norm(along)
    oblique = {name: float(part) for name, part in zip(platform, along, strict=True)}
    return oblique, _everywhere(case.robot)[len(platform) + int(rng.integers(_axes(case.robot)))]


def _rubbing(
    machine: Machine,
    case: CampaignCase,
    pose: np.ndarray,
    test: ModalTest,
    lowest: float,
    rng: np.random.Generator,
) -> Machine:
    """Return a machine with Coulomb friction at the rails, of a size that does not lock them.

    Its mean loss equals that of viscous friction of a ratio of 0.1 to 0.3 % if the velocity is normally distributed
    (F = b sqrt(pi / 2) v_rms), with the velocities of ambient vibration or of a blow.
    """
    names = RAILS[_mechanism(case.robot)]
    small = machine.at(Visit(pose, np.zeros(_axes(case.robot))))
    count = round(4.0 / STEP)
    if test.kind == "impact":
        force = np.zeros(count)
        force[: round(2.5e-3 / STEP)] = test.size
    else:
        density = test.size if test.kind == "ambient" else test.size**2 / 415.0
        force = rng.standard_normal(count) * np.sqrt(density * 0.5 / STEP)
    into = np.array([sum(part * small.shapes[name] for name, part in test.exciters[0].items())])
    motion = responses(small, STEP, force[:, None], into, small.rows(names))
    speed = float(np.sqrt(np.mean(np.cumsum(motion, axis=0) ** 2)) * STEP)
    viscous = float(rng.uniform(0.001, 0.003)) * 2.0 * np.pi * lowest * 2.0 * _mass(machine.parameters)
    coulomb = dict.fromkeys(names, viscous * np.sqrt(np.pi / 2.0) * speed)
    return replace(machine, losses=replace(machine.losses, coulomb=coulomb))
