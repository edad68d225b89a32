"""Suites of the diagnosis for the rotary delta and the CoreXY: define the cases, run them and tabulate the outcomes.

    python -m studies.mechanism_suites --seed 20261212 --out docs/results/mechanisms        # `make suites`
    python -m studies.mechanism_suites --sizes            # recomputes the sizes in `mechanism_sizes`

`robots/clavel-delta.toml` and `robots/corexy-printer.toml` are measured at 10 to 12 poses, with 0.2 % noise and all
modes up to 1.25 times the highest of the declared model: a CoreXY has two vibration modes per pose, a rotary delta
three.  Shapes are measured with 2 % noise, at `theta_1..3` and `p_x..z` of the rotary delta and at `x y` and `p_x
p_y` of the CoreXY, except in every fifth case.  The true values of the uncertain parameters are drawn from their
priors.  Every second case is *realistic*: 15 % of its modes are missed.  Motors are free, held, or held at every
second pose (mixed); causes at the motors, which held motors do not show, are left out there.  The rigs are MuJoCo for
the rotary delta, with loops closed by hand where its links yield or its frame rocks, and the formulas of the contract
for the CoreXY.  `mechanism_cases` has how cases are measured and judged; the requirements are those of the linear
delta's suites (`requirements`).

`link.length` is wrong here by so much that arms exceed their limits at some poses: the diagnosis says that it cannot
follow the value there.  Values of a single axis or belt (`axis.2.*`, `belt_path.2.*`), where the file gives one for
all, are often pointed at in the reason and not claimed.
"""

from __future__ import annotations

import argparse
import itertools
import sys
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pprint import pformat

from pkmodes.core.mechanism.registry import mechanism
from pkmodes.loop.sensitivity.paths import resolve
from pkmodes.loop.updating.candidates import PREFIX
from studies.mechanism_cases import MechanismCase, MechanismOutcome, run
from studies.mechanism_sizes import SIZES
from studies.motors import DRIVES, OTHER_DRIVES, shows, words
from studies.requirements import CLEAR, Row, basic, covered, errors, headed, line, wrong
from studies.sizes import TYING, UNEQUAL
from studies.specimens import (
    KINDS,
    Specimen,
    effects_of,
    robot_of,
    with_effect,
    with_outside,
    with_wrong,
)
from studies.strengths import enclosed, signal
from studies.suite import Suite
from studies.tables import Table, Tables, confusion, grouped, in_words, stacked

#: Number of complete models; every second case of a suite is realistic, every fifth has no shapes.
NOTHING_MISSING = 40
#: Signals of the three sizes of an effect and, in turn, of wrong values; signals of causes outside the catalogue.
TARGETS, OUTSIDE_TARGETS = (8.0, 14.0, 25.0), (20.0, 50.0)
#: The effect with a factor for a single reducer or belt.
ONE = {"rotary_delta": "axis_reducer_stiffness", "corexy": "axis_belt_stiffness"}
#: Declared values that are wrong, by changes of alternating sign; the last ones for a single axis or belt.
WRONG = {
    "rotary_delta": (
        *("arm.length", "arm.inertia", "link.length", "link.mass", "motor.inertia", "motor.gear_ratio"),
        *("axis.joint_radius", "axis.1.origin.z", "axis.2.arm.length", "axis.2.motor.inertia"),
    ),
    "corexy": (
        *("belt.width", "pulley.radius", "pulley.inertia", "motor.inertia", "motor.gear_ratio"),
        *("belt_path.1.lengths.1", "belt_path.1.lengths.2", "belt_path.2.lengths.1"),
        *("belt_path.2.pulley.radius", "belt_path.2.motor.inertia"),
    ),
}
#: Largest factor by which a declared value is wrong; beyond it the file would describe another machine.
MOST = 2.5
#: Causes outside the catalogue.  `one_link` and `one_gearbox` are compliances of single joints, which a diagnosis
#: examines but never claims.
OUTSIDE = {
    "rotary_delta": (
        *("tuned_absorber", "directional_cable", "one_servo", "arm_hose", "one_link", "rocking_frame"),
    ),
    "corexy": (
        *("tuned_absorber", "directional_cable", "one_servo", "one_gearbox", "one_run", "racking_gantry"),
    ),
}
#: An added mode is visible even if nothing else is: masses of absorbers [kg], and compliances of frames [m/N,
#: rad/(N m)] that give modes at 200 to 35 Hz.
ADDING = {
    "rotary_delta": {
        "tuned_absorber": [0.01, 0.03],
        "frame_compliance": [6e-8, 1.4e-7, 4e-7],
        "rocking_frame": [1e-7, 5e-7],
    },
    "corexy": {
        "tuned_absorber": [0.02, 0.06],
        "frame_compliance": [3e-8, 6e-8, 1.5e-7],
        "racking_gantry": [4e-5, 1e-4],
    },
}
#: Starting values of the search for a size, in SI units.
STARTS = {
    "compliance": 1e-11,
    "link_compliance": 1e-10,
    "gearbox_compliance": 1e-6,
    "one_gearbox": 1e-6,
    "one_link": 1e-9,
    "one_run": 1e-9,
    "rocking_frame": 1e-9,
    "one_servo": 1e-4,
    "servo_stiffness": 1e-4,
}
SIZED = ("one effect", "wrong parameter", "outside the catalogue")
SUITES = ("nothing missing", *SIZED, "wrong drives")
#: Files that say that motors were free where they were held, or the reverse.
WRONG_DRIVES = 8
SEEN = "1 and 20261205"


# Cases -------------------------------------------------------------------------------------------------------


def cases() -> Iterator[MechanismCase]:
    """Yield all cases, for motors free, held and mixed."""
    every = list(_with_free_motors())
    for drives in DRIVES:
        for case in every:
            if shows(drives, (*case.names, case.kind)):
                yield replace(case, specimen=replace(case.specimen, drives=drives))


def _with_free_motors() -> Iterator[MechanismCase]:
    for name in KINDS:
        yield from (
            _case("nothing missing", n, Specimen(name), (), "nothing") for n in range(NOTHING_MISSING)
        )
        for suite in SIZED:
            places = [(kind, s) for kind, sizes in SIZES[name][suite].items() for s in sizes]
            for n, (kind, size) in enumerate(places):
                specimen = _specimen(name, suite, kind, size)
                yield _case(suite, n, specimen, _truths(name, suite, kind), kind)
        for n in range(WRONG_DRIVES):
            case = _case("wrong drives", n, Specimen(name), (), "free for held, or held for free")
            yield replace(case, edit=OTHER_DRIVES)


def _case(suite: str, n: int, specimen: Specimen, names: tuple[str, ...], kind: str) -> MechanismCase:
    return MechanismCase(
        suite, n, specimen, names, kind, shapes=n % 5 != 4, realistic=n % 2 == 1, poses=10 + n % 3
    )


def _truths(name: str, suite: str, kind: str) -> tuple[str, ...]:
    if suite == "one effect":
        return (ONE[name] if kind == "one alone" else kind,)
    return (f"{PREFIX}{kind}",) if suite == "wrong parameter" else ()


def _specimen(name: str, suite: str, kind: str, size: float) -> Specimen:
    """Return a robot with one cause of the given size (for a wrong value, the change)."""
    if suite == "wrong parameter":
        return with_wrong(name, kind, size)
    if suite == "outside the catalogue":
        return with_outside(name, kind, size)
    alone = kind == "one alone"
    return with_effect(name, ONE[name] if alone else kind, size, (-1.0, 0.0, 0.0) if alone else UNEQUAL)


# Sizes -------------------------------------------------------------------------------------------------------


def sizes() -> dict[str, dict[str, dict[str, list[float]]]]:
    """Find the sizes of all causes from their predicted signals."""
    sizes_of: dict[str, dict[str, dict[str, list[float]]]] = {}
    for name in KINDS:
        suites = sizes_of[name] = {suite: {} for suite in SIZED}
        for kind in (*effects_of(name), "one alone"):
            given = ADDING[name].get(kind)
            suites["one effect"][kind] = given or [_size(name, "one effect", kind, t) for t in TARGETS]
        for place, path in enumerate(WRONG[name]):
            sign = -1.0 if place % 2 else 1.0
            found_size = _size(name, "wrong parameter", path, TARGETS[place % 3], sign)
            suites["wrong parameter"][path] = [found_size]
        for kind in OUTSIDE[name]:
            given = ADDING[name].get(kind)
            suites["outside the catalogue"][kind] = given or [
                _size(name, "outside the catalogue", kind, t) for t in OUTSIDE_TARGETS
            ]
    return sizes_of


def _size(name: str, suite: str, kind: str, target: float, sign: float = 1.0) -> float:
    """Find the size at which the signal, which grows with the size, reaches a target."""
    most = float("inf")
    start = STARTS.get(kind, 1e-4)
    if suite == "wrong parameter":
        declared = abs(resolve(robot_of(name), kind).value) or 0.1
        most, start = declared * (MOST - 1.0 if sign > 0.0 else 1.0 - 1.0 / MOST), 1e-4 * declared
    elif suite == "one effect" and kind != "one alone":
        parameter = mechanism(name).effects[kind].parameters[0].name
        start = STARTS.get(kind, STARTS.get(parameter, 1e-10 if parameter == "inertia" else 1e-4))

    def measured(size: float) -> float:
        specimen = _specimen(name, suite, kind, sign * size)
        return signal(specimen, KINDS[name].points, tied=kind not in TYING)

    _, found = enclosed(measured, target, start, factor=4.0, within=1.05, most=most)
    size = float(f"{sign * found:.3g}")
    reached = f"{size:g} for {target:g}" if found < most else f"only {measured(found):.3g}"
    print(f"{name} {kind}: {reached} sigma", file=sys.stderr, flush=True)
    return size


# Running -----------------------------------------------------------------------------------------------------


class Mechanisms(Suite[MechanismCase, MechanismOutcome]):
    """The suites of the rotary delta and of the CoreXY."""

    description = "Measure the diagnosis of the rotary delta and the CoreXY."
    run, failed = staticmethod(run), MechanismOutcome

    def options(self, parser: argparse.ArgumentParser) -> None:
        parser.add_argument(
            "--sizes", action="store_true", help="find the sizes of the causes and print them"
        )

    def instead(self, arguments: argparse.Namespace) -> bool:
        if arguments.sizes:
            print(pformat(sizes(), width=110, sort_dicts=False))
        return bool(arguments.sizes)

    def cases(self, arguments: argparse.Namespace) -> Iterator[MechanismCase]:
        return (replace(case, seed=arguments.seed) for case in cases())

    def line(self, outcome: MechanismOutcome) -> str:
        case = f"{outcome.case.label}{_real(outcome)} ({outcome.case.kind}), {outcome.signal:.3g}"
        return f"{case}: {outcome.state} {in_words(outcome)} [{outcome.seconds:.1f} s] {outcome.reason}"

    def facts(self, outcomes: Sequence[MechanismOutcome]) -> dict[str, object]:
        return {"developed with the seeds": SEEN}

    def tables(self, outcomes: Sequence[MechanismOutcome]) -> Tables:
        clear = [o for o in outcomes if o.case.names and o.signal > CLEAR]
        complete = [o for o in outcomes if o.case.suite == "nothing missing"]
        outside = [o for o in outcomes if o.case.specimen.outside and o.state == "adequate"]
        return {
            "requirements": headed(
                itertools.chain.from_iterable(
                    _requirements(name, drives, [o for o in outcomes if _of(o) == (name, drives)])
                    for name in KINDS
                    for drives in DRIVES
                )
            ),
            "outcomes": stacked(
                "by",
                {
                    "suite": confusion(grouped(outcomes, _suite)),
                    "cause": confusion(
                        grouped((o for o in outcomes if o.case.suite != "nothing missing"), _cause)
                    ),
                },
            ),
            "cases": stacked(
                "list",
                {
                    "confident and wrong": _listed([o for o in outcomes if o.state in ("wrong", "failed")]),
                    "nothing missing, but not adequate": _listed(
                        [o for o in complete if o.state == "abstained"]
                    ),
                    "clear causes that were not named": _listed(
                        [o for o in clear if o.state not in ("named", "wrong")]
                    ),
                    "causes outside the catalogue that were missed": _listed(outside),
                },
            ),
        }


def _of(o: MechanismOutcome) -> tuple[str, str]:
    return o.case.specimen.machine, o.case.specimen.drives


# Tables ------------------------------------------------------------------------------------------------------


def _requirements(name: str, drives: str, outcomes: Sequence[MechanismOutcome]) -> Iterator[Row]:
    if not outcomes:
        return
    for suite in SUITES:
        group = [o for o in outcomes if o.case.suite == suite]
        title = f"{name}, {suite}{words(drives)}"
        if suite == "wrong drives":
            yield line(title, "noted >= 90 %", sum(o.noted for o in group), len(group), least=0.90)
        else:
            yield from basic(suite, title, group)
    every = f"{name}, all{words(drives)}"
    yield wrong(every, outcomes)
    yield covered(every, errors(outcomes))


def _suite(o: MechanismOutcome) -> str:
    return f"{o.case.specimen.machine}, {o.case.suite}{_real(o)}{words(o.case.specimen.drives)}"


def _cause(o: MechanismOutcome) -> str:
    return f"{o.case.specimen.machine}, {o.case.suite}: {o.case.kind}"


def _real(o: MechanismOutcome) -> str:
    return ", realistic" if o.case.realistic else ""


def _listed(outcomes: Sequence[MechanismOutcome]) -> Table:
    rows = [
        (
            f"{o.case.label}{_real(o)}{'' if o.case.shapes else ', no shapes'}",
            *(o.case.kind, f"{o.signal:.3g}", o.verdict or o.state, in_words(o)),
        )
        for o in outcomes
    ]
    return Table.of(("case", "truth", "signal", "verdict", "classes"), rows)


main = Mechanisms().main

if __name__ == "__main__":
    main()
