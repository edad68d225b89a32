"""Predicted signals of the causes in the suites, and the sizes chosen from them.

The predicted signal of a cause is the residual that remains when the declared model, its uncertain values refitted
within their priors, is fitted to the rig's modes without noise: the root of chi2, in standard deviations.  It is the
length of the cause's whitened signature after projecting out the uncertain values, without linearisation.  It
is computed at their declared values and at the poses that a diagnosis fits (two of twelve are held out).

    python -m studies.strengths          # recomputes the sizes and prints their tables, in seven minutes

Single effects and wrong values are sized at scattered poses, the others at their own.  Signals depend on the held-out
poses, so they are recomputed for each case of the suites.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from pkmodes.core.mechanism.registry import mechanism
from pkmodes.core.robot.robot import Robot
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Hypothesis
from pkmodes.loop.diagnosis.one_state import split_setups
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.sensitivity.paths import resolve
from pkmodes.loop.updating.measured_robot import MeasuredRobot
from pkmodes_rig import POSES, ROBOTS, Identified, drives_of, exact, identified, written
from studies.sizes import (
    ABSORBER,
    KINDS,
    OUTSIDE_TARGETS,
    PAIR_TARGETS,
    PAIRS,
    TARGETS,
    TYING,
    WRONG_SIZES,
    WRONG_TARGETS,
)
from studies.specimens import (
    MACHINES,
    MODES,
    SIGMA,
    Specimen,
    band,
    effects_of,
    measurements_of,
    robot_of,
    with_effect,
    with_outside,
    with_wrong,
)

#: Effects of the suites.
CATALOGUE = tuple(effects_of("linear_delta"))
PLANS = ("grid", "scattered", "line")
SEED = 20_221_107
#: Scatter of shapes that removes their weight.
NO_WEIGHT = 1e6


def signal(
    specimen: Specimen,
    points: Sequence[np.ndarray] | np.ndarray,
    *,
    holdout: Sequence[str] | None = None,
    tied: bool = True,
    beside: str | None = None,
    rows: Sequence[Identified] | None = None,
) -> float:
    """Compute the predicted signal of the causes in a specimen, in standard deviations.

    Parameters
    ----------
    specimen : Specimen
        With its uncertain values as declared.
    points : sequence of ndarray
        Poses; their labels are P1, P2 ...
    holdout : sequence of str, optional
        Labels of the poses that are not fitted.
    tied : bool
        Whether modes that the declared model has as rigid-body motions count.
    beside : str, optional
        An effect that is fitted too, to compute the signal beyond it.
    rows : sequence of Identified, optional
        Modes that were actually found, each with its standard deviation; the others are left out.  By default
        all that are sought, with `SIGMA`.
    """
    kind, robot = MACHINES[specimen.machine], robot_of(specimen.machine)
    modes, drift = specimen.modes(points), specimen.outside.get("thermal_drift", 0.0)
    if drift:
        modes = [replace(m, frequencies=m.frequencies * (1.0 + drift * i)) for i, m in enumerate(modes)]
    if rows is None:
        seen = modes if tied else [replace(m, rigid=kind.rigid) for m in modes]
        # All modes of a linear delta are sought by their number, those of the others in a band.
        sought: dict[str, Any] = {"modes": MODES, "shapes": kind.shapes, "shape_noise": 0.0}
        if specimen.machine not in ROBOTS:
            sought = {"band": band(specimen.machine)}
        rng = np.random.default_rng(0)
        rows = identified(seen, rng=rng, sigma=SIGMA, base_rigid=kind.rigid, **sought)
    text = written(
        exact(rows, modes, kind.shapes),
        list(points),
        kind.shapes,
        components=kind.components,
        drives=drives_of(modes),
    )
    data = measurements_of(text, robot)
    found = left_by_declared(robot, data, holdout, beside, specimen.effects)
    if found is None:
        raise ValueError(f"the declared model of {specimen.machine} cannot be evaluated")
    return found


def left_by_declared(
    robot: Robot,
    data: Measurements,
    holdout: Sequence[str] | None,
    beside: str | None = None,
    effects: Mapping[str, float] = {},
) -> float | None:
    """Return what the declared model leaves of the frequencies, in standard deviations; None if it has no fit.

    An effect may be fitted `beside` it, from the values in `effects`.
    """
    fitted, _ = split_setups(data, holdout)
    chosen = () if beside is None else (beside,)
    structure = MeasuredRobot.of(robot, data).structure(candidates=chosen).subset(fitted)
    # Shapes serve only to pair the modes; the signal is computed from the frequencies.
    fitter = Fitter(structure, data.at(fitted), shape_scatter=NO_WEIGHT)
    causes = tuple(candidate for candidate in structure.candidates if candidate.name == beside)
    begin = fitter.declared.copy()
    for i in (i for cause in causes for i in fitter.parameter_indices(cause)):
        begin[i] = effects[fitter.parameters[i].name.removeprefix("effects.")]
    fit = fitter.fit(Hypothesis(causes), begin)
    return None if fit is None else float(np.sqrt(fit.chi2))


def pairs() -> Iterator[tuple[str, str, tuple[str, str], tuple[float, float]]]:
    """Draw pairs of effects: robot and poses in turn, names, and the signal of each alone."""
    rng = np.random.default_rng([SEED, len(CATALOGUE)])
    low, high = np.log(PAIR_TARGETS)
    for n in range(PAIRS):
        first, second = rng.choice(list(CATALOGUE), 2, replace=False)
        a, b = np.exp(rng.uniform(low, high, 2))
        robot, plan = list(ROBOTS)[n % 3], PLANS[n // 3 % len(PLANS)]
        yield robot, plan, (str(first), str(second)), (float(a), float(b))


def outside_causes() -> Iterator[tuple[str, str, str, float]]:
    """Yield causes outside the catalogue: kind, robot, poses and signal; one robot of each kind has both signals."""
    plans = itertools.cycle(PLANS)
    for k, kind in enumerate(KINDS):
        for r, robot in enumerate(ROBOTS):
            for s in (0, 1) if (k + r) % 3 == 0 else ((k + r) % 2,):
                yield kind, robot, next(plans), OUTSIDE_TARGETS[s]


#: Starting values of the search for a size, in SI units: far below any result.
STARTS = {
    "stiffness": 1e-3,
    "compliance": 1e-11,
    "mass": 1e-5,
    "linear_density": 1e-6,
    "inertia": 1e-12,
    "directional_cable": 1.0,
    "hose": 1.0,
    "worn_belt": 1e-4,
    "bellows": 1.0,
    "rocking_frame": 1e-10,
    "one_gearbox": 1e-8,
    "pulley_mount": 1e-11,
    "one_servo": 1e-3,
    "one_span": 1e-11,
    "leaning_frame": 1e-11,
}
#: Poses at which the sizes of single effects and wrong values are chosen.
PLAN = "scattered"


def main() -> None:
    """Print the tables."""
    for robot in ROBOTS:
        print(f"{robot}: effects at {TARGETS} sigma")
        effects(robot)
        print(f"{robot}: wrong values at {WRONG_TARGETS} sigma in turn")
        wrong_values(robot)
    print(f"pairs of effects, each alone at {PAIR_TARGETS} sigma, drawn")
    two_effects()
    print("causes outside the catalogue")
    outside()


def effects(robot: str) -> None:
    """Print the sizes of the effects."""
    for effect in CATALOGUE:
        start = start_of(effect)
        sizes = [size_for(t, partial(with_effect, robot, effect), start) for t in TARGETS]
        print(f'        "{effect}": ({", ".join(f"{s:.3g}" for s in sizes)}),', flush=True)


def wrong_values(robot: str) -> None:
    """Print the changes of wrong declared values."""
    for place, path in enumerate(WRONG_SIZES[robot]):
        declared = resolve(robot_of(robot), path).value
        sign = -1.0 if declared and place % 2 else 1.0
        target = WRONG_TARGETS[place % len(WRONG_TARGETS)]
        start = 1e-4 * (declared or 1e-1)

        def wrong(size: float, path: str = path, sign: float = sign) -> Specimen:
            return with_wrong(robot, path, sign * size)

        change = size_for(target, wrong, start)
        print(f'        "{path}": {sign * change:.3g},', flush=True)


def outside() -> None:
    """Print the sizes of causes outside the catalogue."""
    for kind, robot, plan, target in outside_causes():
        if kind == "tuned_absorber":
            size = ABSORBER[target] * float(robot_of(robot).parameters.platform_mass)
            print(f"    {size:.3g},  # {kind}, {robot}, {plan}", flush=True)
        else:
            size = size_for(target, partial(with_outside, robot, kind), STARTS[kind], plan)
            print(f"    {size:.3g},  # {kind}, {robot}, {plan}: {target:g} sigma", flush=True)


def two_effects() -> None:
    """Print the sizes of the two effects of each pair."""
    for robot, plan, names, targets in pairs():
        sizes = [
            size_for(t, partial(with_effect, robot, effect), start_of(effect), plan)
            for effect, t in zip(names, targets, strict=True)
        ]
        print(f"    ({', '.join(f'{s:.4g}' for s in sizes)}),  # {' + '.join(names)}", flush=True)


def start_of(effect: str) -> float:
    """Return the starting value of the search for the size of an effect."""
    parameters = mechanism("linear_delta").effects[effect].parameters
    return STARTS.get(parameters[0].name, 1e-4)


def size_for(target: float, of: Callable[[float], Specimen], start: float, plan: str = PLAN) -> float:
    """Find the size at which the signal reaches a target, at one of the `PLANS`."""

    def measured(size: float) -> float:
        specimen = of(size)
        names = {name.split(".")[0] for name in (*specimen.effects, *specimen.outside)}
        return signal(specimen, POSES[specimen.machine][plan], tied=not names & set(TYING))

    low, high = enclosed(measured, target, start)
    return float(np.sqrt(low * high))


def enclosed(
    growing: Callable[[float], float],
    target: float,
    start: float,
    *,
    factor: float = 2.0,
    within: float = 1.02,
    most: float = float("inf"),
) -> tuple[float, float]:
    """Return two sizes between which something that grows with the size reaches a target.

    Parameters
    ----------
    growing : callable
    target, start : float
        The search begins at `start`, far below the result.
    factor, within : float
        By which sizes are increased first, and between the two sizes.
    most : float
        The largest size; if it does not reach the target, it is both sizes.
    """
    low, high = start, factor * start
    while high < most and growing(high) < target:
        low, high = high, factor * high
    if high >= most:
        high = most
        if growing(high) < target:
            return high, high
    while high / low > within:
        middle = float(np.sqrt(low * high))
        low, high = (middle, high) if growing(middle) < target else (low, middle)
    return low, high


if __name__ == "__main__":
    main()
