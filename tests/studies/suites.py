"""Suites that measure the diagnosis: cases on the virtual test rig.

The physics of the rig is MuJoCo's and shares no code with the model.  The sizes of the causes are in `sizes`.  The
first six suites keep the random draws with which they were first published: every mode is found, except in a few
special cases.  The suites called "realistic" have the same causes, with a laboratory drawn for each case; the others
are in `hard_suites`.
"""

from __future__ import annotations

import functools
import itertools
from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any

from pkmodes.loop.updating.candidates import PREFIX
from pkmodes_rig import SENSORS
from studies import hard_suites
from studies.cases import ROBOT_NAMES, Case
from studies.sizes import EFFECT_SIZES, OUTSIDE_SIZES, PAIR_SIZES, TARGETS, WRONG_SIZES
from studies.specimens import Specimen, with_effect, with_outside, with_wrong
from studies.strengths import CATALOGUE, PLANS, outside_causes, pairs

#: Number of complete models: 5 % of them are ten.
NOTHING_MISSING = 210
#: One case in this many has no shapes.
WITHOUT_SHAPES = 5
#: One case in this many has a realistic version.
EVERY = {
    "nothing missing": 2,
    "one effect": 3,
    "wrong parameter": 1,
    "two effects": 1,
    "outside the catalogue": 2,
}

#: Errors of the experimenter in the special cases: common error, drift, and fraction of missed modes.
COMMON, DRIFT, MISSING = 0.004, 0.001, 0.15


def nothing_missing() -> Iterator[Case]:
    """Yield complete models."""
    for n in range(NOTHING_MISSING):
        yield _case("nothing missing", n, Specimen(ROBOT_NAMES[n % 3]), n // 3, kind="nothing")


def one_effect() -> Iterator[Case]:
    """Yield every effect on every robot in three sizes."""
    places = itertools.product(enumerate(CATALOGUE), enumerate(ROBOT_NAMES), range(len(TARGETS)))
    for n, ((e, effect), (r, robot), s) in enumerate(places):
        truth = with_effect(robot, effect, EFFECT_SIZES[robot][effect][s])
        yield _case("one effect", n, truth, e + r + s, (effect,), effect)


def wrong_parameter() -> Iterator[Case]:
    """Yield wrong declared values."""
    places = [(path, robot) for robot in ROBOT_NAMES for path in WRONG_SIZES[robot]]
    for n, (path, robot) in enumerate(places):
        name = f"{PREFIX}{path}"
        truth = with_wrong(robot, path, WRONG_SIZES[robot][path])
        yield _case("wrong parameter", n, truth, n, (name,), name)


def two_effects() -> Iterator[Case]:
    """Yield pairs of effects."""
    for n, ((robot, plan, names, _), sizes) in enumerate(zip(pairs(), PAIR_SIZES, strict=True)):
        values: dict[str, float] = {}
        for effect, size in zip(names, sizes, strict=True):
            values |= with_effect(robot, effect, size).effects
        yield _case("two effects", n, Specimen(robot, values), PLANS.index(plan), names, " + ".join(names))


def outside() -> Iterator[Case]:
    """Yield causes outside the catalogue."""
    for n, ((kind, robot, plan, _), size) in enumerate(zip(outside_causes(), OUTSIDE_SIZES, strict=True)):
        truth = with_outside(robot, kind, size)
        yield _case("outside the catalogue", n, truth, PLANS.index(plan), kind=kind)


def special() -> Iterator[Case]:
    """Yield errors of experimenters and borderline cases of the catalogue, which are reported separately."""
    variants: list[tuple[str, int, int, dict[str, object]]] = [
        # kind, cases without a cause, cases with one plain effect, changes of the case
        ("sigma stated as half", 6, 3, {"options": {"sigma_scale": 0.5}}),
        ("sigma stated as double", 3, 3, {"options": {"sigma_scale": 2.0}}),
        ("error common to a pose", 6, 3, {"options": {"common": COMMON}}),
        ("frequencies drift", 3, 0, {"options": {"drift": DRIFT}}),
        ("modes not found", 3, 6, {"options": {"missing": MISSING}}),
        ("one gross outlier", 6, 3, {"edit": "outlier"}),
        ("modes numbered anew", 0, 3, {"edit": "numbers"}),
        ("half of the shapes blank", 0, 6, {"edit": "blanks"}),
        ("no shapes", 0, 6, {"shapes": ()}),
    ]
    plain = ("gearbox_compliance", "belt_mass", "axis_belt_stiffness", "clamp_compliance", "link_compliance")
    n = 0
    for kind, without, with_one, changes in variants:
        for k in range(without + with_one):
            robot, effect = ROBOT_NAMES[k % 3], plain[k % len(plain)]
            truth = Specimen(robot)
            names: tuple[str, ...] = ()
            if k >= without:
                truth, names = with_effect(robot, effect, EFFECT_SIZES[robot][effect][-1]), (effect,)
            changed: dict[str, Any] = {"shapes": SENSORS, **changes}
            yield replace(_case("special", n, truth, k, names, kind), **changed)
            n += 1
    for robot in ROBOT_NAMES:  # in the catalogue's terms, both a payload and lighter carriages
        names = "payload", f"{PREFIX}carriage.mass"
        yield replace(_case("special", n, with_outside(robot, "rod_taper", 0.9), n, names, "rods tapered"))
        n += 1


def realistic(suite: str) -> Iterator[Case]:
    """Yield cases of a suite again, with realistic measurements."""
    for n, case in enumerate(PLAIN[suite]()):
        # Of the single effects, take one size per robot, varying with the robot and the effect.
        place = n // 9 + n // 3 if suite == "one effect" else 0
        if n % EVERY[suite] == place % EVERY[suite]:
            yield replace(case, suite=f"{suite}, realistic", realistic=True)


PLAIN: dict[str, Callable[[], Iterator[Case]]] = {
    "nothing missing": nothing_missing,
    "one effect": one_effect,
    "wrong parameter": wrong_parameter,
    "two effects": two_effects,
    "outside the catalogue": outside,
}

SUITES: dict[str, Callable[[], Iterator[Case]]] = {
    **PLAIN,
    "special": special,
    **{f"{suite}, realistic": functools.partial(realistic, suite) for suite in PLAIN},
    **hard_suites.SUITES,
}


def _case(
    suite: str, number: int, truth: Specimen, plan: int, names: tuple[str, ...] = (), kind: str = ""
) -> Case:
    shapes = () if number % WITHOUT_SHAPES == WITHOUT_SHAPES - 1 else SENSORS
    return Case(suite, number, PLANS[plan % len(PLANS)], truth, names, kind, shapes)
