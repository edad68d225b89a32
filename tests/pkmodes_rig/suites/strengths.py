"""Predicted signals of the causes in the suites, and the sizes chosen from them.

The predicted signal of a cause is the residual that remains when the declared model, its uncertain values refitted
within their priors, is fitted to the rig's modes without noise: the root of chi2, in standard deviations.  It is the
length of the cause's whitened signature after projecting out the uncertain values, without linearisation.  It
is computed at their declared values and at the poses that a diagnosis fits (two of twelve are held out).

    python -m pkmodes_rig.suites.strengths          # recomputes the sizes and prints their tables, in seven minutes

Single effects and wrong values are sized at scattered poses, the others at their own.  Signals depend on the held-out
poses, so they are recomputed for each case of the suites.
"""

from __future__ import annotations

import itertools
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path

import numpy as np

from pkmodes.core.mechanism.registry import mechanism
from pkmodes.core.robot.robot import Robot
from pkmodes.diagnosis.diagnose import split
from pkmodes.diagnosis.fit.fitter import Fitter
from pkmodes.diagnosis.fit.hypothesis import Hypothesis
from pkmodes.measured.measurements import Measurements
from pkmodes.measured.reading import read_measurements
from pkmodes.sensitivity.paths import moved, resolve
from pkmodes.updating.measured_robot import MeasuredRobot
from pkmodes.updating.robot_structure import channels as channels_of
from pkmodes_rig import (
    BASE_RIGID,
    POSES,
    ROBOTS,
    SENSORS,
    Identified,
    TrueModes,
    drives_of,
    exact,
    held_at,
    measure_modes,
    read,
    true_modes,
    written,
)
from pkmodes_rig.suites.sizes import (
    ABSORBER,
    KINDS,
    OUTSIDE_TARGETS,
    PAIR_TARGETS,
    PAIRS,
    TARGETS,
    TYING,
    UNEQUAL,
    WRONG_SIZES,
    WRONG_TARGETS,
)

#: Effects of the suites, without those that only dissipate, and without that of belt tension, which does nothing
#: where no tension is declared.
CATALOGUE = {
    name: effect
    for name, effect in mechanism("linear_delta").conservative_effects.items()
    if name != "belt_tension_stiffness"
}

#: Standard deviation of ln f, and the number of modes sought beyond the first three.
SIGMA, MODES = 0.002, 6
PLANS = ("grid", "scattered", "line")
SEED = 20_221_107
SHAPES = SENSORS
CHANNELS = channels_of(mechanism("linear_delta"))


@dataclass(frozen=True)
class Truth:
    """True state of a robot on the rig.

    Attributes
    ----------
    robot : str
        Name of the declared robot.
    effects : mapping
        Parameters of the catalogue's effects in SI units, by ``"<effect>.<parameter>"``.
    values : mapping
        True values in SI units, by dotted path, where they are not the declared ones.
    outside : mapping
        Sizes of causes outside the catalogue.
    drives : str
        What the motors do in the test: ``free``, ``held``, or ``mixed``, see `pkmodes_rig.held_at`.
    """

    robot: str
    effects: Mapping[str, float] = field(default_factory=dict)
    values: Mapping[str, float] = field(default_factory=dict)
    outside: Mapping[str, float] = field(default_factory=dict)
    drives: str = "free"

    def built(self) -> Robot:
        """Return the robot with its true values."""
        declared = read(self.robot)
        paths = [(resolve(declared, path), value) for path, value in self.values.items()]
        return moved(declared, [(path, value - path.value) for path, value in paths])

    def modes(self, points: Sequence[np.ndarray]) -> list[TrueModes]:
        """Return the true modes at some poses."""
        robot = self.built()
        effects = {**robot.constants, **self.effects}
        held = held_at(self.drives, len(points))
        return [
            true_modes(robot.parameters, p, effects, self.outside, held=h)
            for p, h in zip(points, held, strict=True)
        ]


#: Scatter of shapes that removes their weight.
NO_WEIGHT = 1e6


def measurements(text: str, channels: Sequence[str] = tuple(CHANNELS)) -> Measurements:
    """Read the text of a CSV file."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "modes.csv"
        path.write_text(text, encoding="utf-8")
        return read_measurements(path, channels)


def signal(
    truth: Truth,
    plan: str,
    *,
    holdout: Sequence[str] | None = None,
    tied: bool = True,
    beside: str | None = None,
    rows: Sequence[Identified] | None = None,
) -> float:
    """Compute the predicted signal of the causes in a truth, in standard deviations.

    Parameters
    ----------
    truth : Truth
        With its uncertain values as declared.
    plan : str
        Poses; their labels are P1, P2 ...
    holdout : sequence of str, optional
        Labels of the poses that are not fitted.
    tied : bool
        Whether modes that the declared model has as rigid-body motions count.
    beside : str, optional
        An effect that is fitted too, to compute the signal beyond it.
    rows : sequence of Identified, optional
        Modes that were actually found, each with its standard deviation; the others are left out.  By default
        all of the first six, with `SIGMA`.
    """
    robot, points = read(truth.robot), POSES[truth.robot][plan]
    modes = truth.modes(points)
    if not tied:
        modes = [replace(m, rigid=BASE_RIGID) for m in modes]
    drift = truth.outside.get("thermal_drift", 0.0)
    if rows is None:
        text = _without_noise(modes, points, drift)
    else:
        text = written(exact(rows, modes, SHAPES), points, SHAPES, drives=drives_of(modes))
    data = measurements(text)
    fitted, _ = split(data, holdout)
    structure = MeasuredRobot.of(robot, data).structure().subset(fitted)
    # Shapes serve only to pair the modes; the signal is computed from the frequencies.
    fitter = Fitter(structure, data.at(fitted), scatter=NO_WEIGHT)
    causes = tuple(candidate for candidate in structure.candidates if candidate.name == beside)
    begin = fitter.declared.copy()
    for i in (i for cause in causes for i in fitter.indices(cause)):
        begin[i] = truth.effects[fitter.parameters[i].name.removeprefix("effects.")]
    fit = fitter.fit(Hypothesis(causes), begin)
    if fit is None:
        raise ValueError(f"the declared model of {truth.robot} cannot be evaluated")
    return float(np.sqrt(fit.chi2))


def _without_noise(modes: Sequence[TrueModes], points: Sequence[np.ndarray], drift: float) -> str:
    """Return the file of all modes measured without error, with the usual standard deviations stated."""
    small = SIGMA * 1e-6
    return measure_modes(
        modes,
        points,
        rng=np.random.default_rng(0),
        sigma=small,
        sigma_scale=SIGMA / small,
        modes=MODES,
        shapes=SHAPES,
        shape_noise=0.0,
        drift=drift,
    )


def with_effect(robot: str, effect: str, size: float) -> Truth:
    """Return a robot with one effect of the catalogue."""
    names = [p.name for p in CATALOGUE[effect].parameters if p.fitted]
    sizes = [size * part for part in UNEQUAL] if len(names) > 1 else [size]
    return Truth(robot, {f"{effect}.{name}": s for name, s in zip(names, sizes, strict=True)})


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


def with_wrong(robot: str, path: str, change: float) -> Truth:
    """Return a robot with one wrong declared value, by this change in SI units."""
    return Truth(robot, values={path: resolve(read(robot), path).value + change})


def with_outside(robot: str, kind: str, size: float) -> Truth:
    """Return a robot with one cause outside the catalogue."""
    return Truth(robot, outside={kind: size})


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
        declared = resolve(read(robot), path).value
        sign = -1.0 if declared and place % 2 else 1.0
        target = WRONG_TARGETS[place % len(WRONG_TARGETS)]
        start = 1e-4 * (declared or 1e-1)

        def wrong(size: float, path: str = path, sign: float = sign) -> Truth:
            return with_wrong(robot, path, sign * size)

        change = size_for(target, wrong, start)
        print(f'        "{path}": {sign * change:.3g},', flush=True)


def outside() -> None:
    """Print the sizes of causes outside the catalogue."""
    for kind, robot, plan, target in outside_causes():
        if kind == "tuned_absorber":
            size = ABSORBER[target] * float(read(robot).parameters.platform_mass)
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
    return STARTS.get(CATALOGUE[effect].parameters[0].name, 1e-4)


def size_for(target: float, truth: Callable[[float], Truth], start: float, plan: str = PLAN) -> float:
    """Find the size at which the signal, which grows with the size, reaches a target."""

    def measured(size: float) -> float:
        case = truth(size)
        names = {name.split(".")[0] for name in (*case.effects, *case.outside)}
        return signal(case, plan, tied=not names & set(TYING))

    low, high = start, 2.0 * start
    while measured(high) < target:
        low, high = high, 2.0 * high
    while high / low > 1.02:
        middle = float(np.sqrt(low * high))
        low, high = (middle, high) if measured(middle) < target else (low, middle)
    return float(np.sqrt(low * high))


if __name__ == "__main__":
    main()
