"""Suites of difficult measurements: few rows, missed modes, decisive shapes, outliers, and mistakes.

`requirements` defines what they must show; it was fixed before any of them was run.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace

import numpy as np

from pkmodes_rig import ASKEW, MISTAKES, ORDERS, POSES, SENSORS, Laboratory, channels
from studies.buildings import Building
from studies.cases import ROBOT_NAMES, Case
from studies.judging import NOTED, POSITIONS
from studies.motors import OTHER_DRIVES
from studies.sizes import EFFECT_SIZES, OUTSIDE_SIZES
from studies.specimens import SIGMA, Specimen, robot_of, with_effect, with_outside
from studies.strengths import CATALOGUE, PLANS, SEED, outside_causes

#: Cases with few rows, and with outliers among few rows: robots, and as many buildings.
FEW_ROWS, OUTLIERS = 60, 30
#: Fewest and most rows in these cases.
FEW, FEWER = (2, 8), (2, 6)
#: Effects that add modes or make rigid ones measurable.
ADDING = ("cable_stiffness", "servo_stiffness", "frame_compliance")
#: Their sizes relative to the plain size: missed modes hide part of the signal.
LARGER = (1.0, 1.5, 2.5)
#: For decisive shapes: stated errors of the frequencies, uncertainty of the common stiffness, and cases of each.
STATED, PRIORS, EACH = (0.002, 0.005, 0.01), (0.05, 0.10, 0.15), 6
#: Mass on the roof in up to three setups [kg].
LOADS = (0.0, 5.0, 12.0)
#: Change of one storey, in either direction, and the shape error in these cases.
CHANGE, SHAPE_NOISE = (0.10, 0.30), (0.02, 0.05)
#: Cases of each mistake with a complete model, and with a plain effect.
WITHOUT, WITH_ONE = 3, 1
#: Channels beside wrong signed orders of the platform's sensor, and the shape errors; one specimen in so many has a
#: plain effect, and so many sensors are mounted askew.
BESIDE, SCATTERS = (SENSORS, SENSORS[1:], SENSORS[3:]), (0.02, 0.05)
WITH_EFFECT, ASKEW_CASES = 4, 6
#: Cases of files with the wrong word for the motors.
WRONG_DRIVES = 24
#: Near the axis of a tower printer, the platform's sensor alone cannot tell x and y, or their signs.
UNDECIDED = "signed order, undecided"
#: True over declared mass of the frame.
FRAME_MASS = 1.6


def few_rows() -> Iterator[Case]:
    """Yield robots and buildings with two to eight rows: no cause, one cause, or one outside the candidates."""
    rng = np.random.default_rng([SEED, 1])
    for n in range(2 * FEW_ROWS):
        drawn = _machine(rng, n) if n < FEW_ROWS else _building(rng, n)
        yield replace(_few(rng, "few rows", n, *drawn), rows=int(rng.integers(FEW[0], FEW[1] + 1)))


def modes_missed() -> Iterator[Case]:
    """Yield clearly visible single effects with missed modes, with extra cases of the effects that add modes."""
    plain = [(effect, robot, 1.0, e + r) for (e, effect), (r, robot) in _places(CATALOGUE)]
    more = [
        (effect, robot, larger, e + r + k)
        for (e, effect), (r, robot) in _places(ADDING)
        for k, larger in enumerate(LARGER, start=1)
    ]
    for n, (effect, robot, larger, plan) in enumerate([*plain, *more]):
        truth = with_effect(robot, effect, larger * EFFECT_SIZES[robot][effect][2])
        yield Case("modes missed", n, PLANS[plan % len(PLANS)], truth, (effect,), effect, realistic=True)


def shapes_decide() -> Iterator[Case]:
    """Yield four-storey frames with one changed storey: the frequencies would fit any storey, the shapes only one."""
    rng = np.random.default_rng([SEED, 3])
    for n, (stated, prior, _) in enumerate(itertools.product(STATED, PRIORS, range(EACH))):
        storey, size = int(rng.integers(1, 5)), rng.uniform(*CHANGE) * rng.choice([-1.0, 1.0])
        name = f"storey {storey}"
        truth = Building(4, prior, values={name: float(size)})
        laboratory = Laboratory(
            sigma=SIGMA,
            sigma_scale=stated / SIGMA,
            modes=(4, 4),
            shapes=channels(4),
            shape_noise=float(rng.uniform(*SHAPE_NOISE)),
            sigma_shape=str(rng.choice(["absent", "stated", "some"])),
        )
        plan = f"sigma {stated:.1%}, prior {prior:.0%}"
        yield Case("shapes decide", n, plan, truth, (name,), "one storey", laboratory=laboratory)


def outliers_among_few() -> Iterator[Case]:
    """Yield cases with two to six rows, one of them with a gross error."""
    rng = np.random.default_rng([SEED, 4])
    for n in range(2 * OUTLIERS):
        drawn = _machine(rng, n) if n < OUTLIERS else _building(rng, n)
        few = _few(rng, "outliers among few", n, *drawn)
        yield replace(few, rows=int(rng.integers(FEWER[0], FEWER[1] + 1)), edit="gross")


def units_and_wiring() -> Iterator[Case]:
    """Yield mistakes of the experimenter, with complete models and with some plain effects."""
    plain = ("gearbox_compliance", "belt_mass", "axis_belt_stiffness", "clamp_compliance", "link_compliance")
    careful = Laboratory(uneven=0.1, missing=0.05, modes=(5, 8), sigma_shape="stated")
    uneven = replace(careful, uneven=0.5)
    n = 0
    for m, mistake in enumerate(MISTAKES):
        for k in range(WITHOUT + WITH_ONE):
            robot, effect = ROBOT_NAMES[(k + m) % 3], plain[m % len(plain)]
            truth = Specimen(robot)
            names: tuple[str, ...] = ()
            if k >= WITHOUT:
                truth, names = with_effect(robot, effect, EFFECT_SIZES[robot][effect][2]), (effect,)
            names += {"poses too high": (POSITIONS[2],), "poses turned": (POSITIONS[3],)}.get(mistake, ())
            plan = PLANS[(k + m // 3) % len(PLANS)]
            laboratory = uneven if NOTED.get(mistake) == "unit" else careful
            yield Case(
                "units and wiring", n, plan, truth, names, mistake, laboratory=laboratory, mistake=mistake
            )
            n += 1
    for k, robot in enumerate(ROBOT_NAMES):
        frame = with_effect(robot, "frame_compliance", EFFECT_SIZES[robot]["frame_compliance"][2])
        mass = FRAME_MASS * robot_of(robot).constants["frame_compliance.mass"]
        truth = replace(frame, effects={**frame.effects, "frame_compliance.mass": mass})
        names = ("frame_compliance",)
        kind = "wrong frame.mass"
        yield Case("units and wiring", n, PLANS[k], truth, names, kind, laboratory=careful)
        n += 1
    yield from _mountings(n, plain)


def wrong_drives() -> Iterator[Case]:
    """Yield files that say that motors were free where they were held, or the reverse."""
    for n in range(WRONG_DRIVES):
        robot, effect = ROBOT_NAMES[n % 3], ("belt_mass", "payload", "link_compliance")[n % 3]
        truth = Specimen(robot)
        names: tuple[str, ...] = ()
        if n % 4 == 3:
            truth, names = with_effect(robot, effect, EFFECT_SIZES[robot][effect][2]), (effect,)
        yield Case(
            "wrong drives",
            n,
            PLANS[n // 3 % len(PLANS)],
            truth,
            names,
            "free for held, or held for free",
            realistic=True,
            edit=OTHER_DRIVES,
        )


def _mountings(n: int, plain: Sequence[str]) -> Iterator[Case]:
    """Yield all wrong signed orders of the platform's sensor, and sensors mounted askew.

    Two of five are on a tower printer with nearly equal modes.
    """
    middle, scattered = ("tower", "middle"), ("tower", "scattered")
    places = (middle, scattered, ("asymmetric", "grid"), middle, ("published", "line"))
    for k, mistake in enumerate([*ORDERS, *[ASKEW] * ASKEW_CASES]):
        robot, plan = places[k % len(places)]
        truth = Specimen(robot)
        names: tuple[str, ...] = ()
        if k % WITH_EFFECT == 0:
            effect = plain[k // WITH_EFFECT % len(plain)]
            truth, names = with_effect(robot, effect, EFFECT_SIZES[robot][effect][2]), (effect,)
        laboratory = Laboratory(
            uneven=0.1,
            missing=0.05,
            modes=(5, 8),
            shapes=BESIDE[k // 2 % len(BESIDE)],
            shape_noise=SCATTERS[k // 3 % len(SCATTERS)],
            sigma_shape=("stated", "absent")[k // 5 % 2],
        )
        kind = ASKEW if mistake == ASKEW else "signed order"
        if kind != ASKEW and plan == "middle" and len(laboratory.shapes) == len(BESIDE[-1]):
            kind = UNDECIDED
        yield Case(
            "units and wiring", n + k, plan, truth, names, kind, laboratory=laboratory, mistake=mistake
        )


SUITES: dict[str, Callable[[], Iterator[Case]]] = {
    "few rows": few_rows,
    "modes missed": modes_missed,
    "shapes decide": shapes_decide,
    "outliers among few": outliers_among_few,
    "units and wiring": units_and_wiring,
    "wrong drives": wrong_drives,
}


def _places(effects: Iterable[str]) -> Iterator[tuple[tuple[int, str], tuple[int, str]]]:
    return itertools.product(enumerate(effects), enumerate(ROBOT_NAMES))


def _machine(rng: np.random.Generator, n: int) -> tuple[Specimen, tuple[str, ...], str]:
    """Draw a robot: of five, one lacks nothing, one has a cause outside the catalogue, three have a plain effect."""
    robot = ROBOT_NAMES[n % 3]
    if n % 5 == 0:
        return Specimen(robot), (), "nothing"
    if n % 5 == 1:
        causes = [(s, size) for s, size in zip(outside_causes(), OUTSIDE_SIZES, strict=True) if s[1] == robot]
        (kind, *_), size = causes[int(rng.integers(len(causes)))]
        return with_outside(robot, kind, size), (), kind
    effect = str(rng.choice(list(CATALOGUE)))
    return with_effect(robot, effect, EFFECT_SIZES[robot][effect][2]), (effect,), effect


def _building(rng: np.random.Generator, n: int) -> tuple[Building, tuple[str, ...], str]:
    """Draw a building in the same way."""
    storeys = int(rng.integers(3, 6))
    floor = int(rng.integers(1, storeys + 1))
    loads = LOADS[: int(rng.integers(1, len(LOADS) + 1))]
    frame = Building(storeys, float(rng.choice(PRIORS)), float(rng.choice([0.0, 0.1])), loads)
    size = float(rng.uniform(*CHANGE))
    sign = float(rng.choice([-1.0, 1.0]))
    if n % 5 == 0:
        return frame, (), "nothing"
    if n % 5 == 1:
        outside = {"brace": 2e5 * size / CHANGE[1]} if n % 2 else {"absorber": 20.0 * size}
        return replace(frame, outside=outside), (), next(iter(outside))
    if n % 5 == 2:
        name = f"mass {floor}"
        return replace(frame, values={name: 20.0 * size}), (name,), "one mass"
    name = f"storey {floor}"
    return replace(frame, values={name: sign * size}), (name,), "one storey"


def _few(
    rng: np.random.Generator,
    suite: str,
    number: int,
    truth: Specimen | Building,
    names: tuple[str, ...],
    kind: str,
) -> Case:
    """Return a case at one to three poses of a robot, or in the setups of a building."""
    if isinstance(truth, Building):
        plan = f"prior {truth.prior:.0%}, setups {len(truth.loads)}"
        return Case(suite, number, plan, truth, names, kind, realistic=True)
    plan = PLANS[int(rng.integers(len(PLANS)))]
    all_poses = len(POSES[truth.machine][plan])
    poses = rng.choice(all_poses, int(rng.integers(1, 4)), replace=False)
    return Case(
        suite, number, plan, truth, names, kind, realistic=True, poses=tuple(int(i) for i in sorted(poses))
    )
