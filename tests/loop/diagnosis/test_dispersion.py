"""A stiffness that changes with the frequency, as that of a rubber belt does, is not taken for a candidate."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

import numpy as np
import pytest

from pkmodes import updating
from pkmodes.loop.diagnosis import Candidate, Criteria, MatrixStructure, Measurements, Parameter
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Hypothesis
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.verdict.dispersion import dispersion
from pkmodes_rig import POSES, SENSORS, TrueModes, drawn_values, identified, written
from studies.specimens import Specimen, measurements, robot_of

LOADS = {"empty": 0.0, "2 kg": 2.0, "4 kg": 4.0, "8 kg": 8.0, "12 kg": 12.0, "16 kg": 16.0}
SHARED, SIGMA = 4e5, 1e-3
SOFTER = Candidate("softer", ("softer",))


def storeys(values: Mapping[str, float], setup: str) -> tuple[np.ndarray, np.ndarray]:
    k, k2 = values["k"], values["k"] * (1.0 - values["softer"])
    M = np.diag([20.0, 20.0, 20.0 + LOADS[setup]])
    return M, np.array([[k + k2, -k2, 0.0], [-k2, k2 + k, -k], [0.0, -k, k]])


def measured(law: Callable[[float], float], softer: float) -> Measurements:
    """Three modes of each setup; the stiffness of each is that at its own frequency."""
    rng, pose, frequencies = np.random.default_rng(1), list[str](), list[float]()
    for setup in LOADS:
        for mode in range(3):
            f = 20.0
            for _ in range(50):
                M, K = storeys({"k": SHARED * law(f), "softer": softer}, setup)
                eigenvalues = np.sort(np.linalg.eigvals(np.linalg.solve(M, K)).real)
                f = float(np.sqrt(eigenvalues[mode]) / (2.0 * np.pi))
            pose.append(setup)
            frequencies.append(f * (1.0 + SIGMA * rng.standard_normal()))
    f = np.array(frequencies)
    return Measurements.from_rows(pose, f, SIGMA * f)


@pytest.mark.parametrize(
    ("law", "softer", "better", "rises"),
    [
        (lambda f: (f / 25.0) ** 0.05, 0.0, True, True),
        (lambda f: (f / 25.0) ** -0.05, 0.0, True, False),
        (lambda f: 1.0 + 0.08 * (f / 40.0) ** 2, 0.0, True, True),
        (lambda f: 1.0, 0.2, False, None),
    ],
)
def test_it_explains_the_data_better_only_where_it_is_true(
    law: Callable[[float], float], softer: float, better: bool, rises: bool | None
) -> None:
    parameters = [Parameter("k", SHARED, "N/m", sigma=0.02 * SHARED), Parameter("softer", 0.0, upper=0.9)]
    structure = MatrixStructure(parameters, [SOFTER], storeys, channels=["x", "y", "z"], setups=list(LOADS))
    data = measured(law, softer)
    store = FitStore(Fitter(structure, data, Criteria()))
    final = store.fit(Hypothesis((SOFTER,)))
    assert final is not None
    found = dispersion(store, final)
    assert found is not None
    assert found.name == "k"
    assert (found.criterion < store.criterion(final) - 9.0) == better
    assert (found.criterion > store.criterion(final) + 9.0) != better
    if better:
        assert found.rises == rises


def test_without_a_declared_stiffness_there_is_none() -> None:
    parameters = [Parameter("k", SHARED, "1", sigma=0.02 * SHARED), Parameter("softer", 0.0, upper=0.9)]
    structure = MatrixStructure(parameters, [SOFTER], storeys, channels=["x", "y", "z"], setups=list(LOADS))
    store = FitStore(Fitter(structure, measured(lambda f: 1.0, 0.2), Criteria()))
    final = store.fit(Hypothesis((SOFTER,)))
    assert final is not None
    assert dispersion(store, final) is None


def dispersive(
    points: np.ndarray, law: Callable[[float], float], rng: np.random.Generator
) -> list[TrueModes]:
    """True modes of the published robot, whose belts change their stiffness by a factor 1 + law(f) at each mode."""
    changes, drawn = np.linspace(-0.25, 0.4, 6), drawn_values(robot_of("published"), rng)
    each = [
        Specimen("published", {f"axis_belt_stiffness.factor_{j}": a for j in (1, 2, 3)}, drawn).modes(points)
        for a in changes
    ]
    found = []
    for at in zip(*each, strict=True):
        f = at[2].frequencies.copy()
        for mode in range(at[2].rigid, len(f)):
            logs = np.log([one.frequencies[mode] for one in at])
            curve = np.polynomial.Polynomial.fit(changes, logs, 5)
            for _ in range(50):
                f[mode] = np.exp(curve(np.clip(law(f[mode]), changes[0], changes[-1])))
        found.append(replace(at[2], frequencies=f))
    return found


@pytest.mark.slow
def test_belts_that_stiffen_with_the_frequency_are_not_taken_for_a_pair_of_causes() -> None:
    # Two causes leave noise, the inertia of the pulleys and the length of the carriages; one value does it, too.
    rng, points = np.random.default_rng(0), np.array(POSES["published"]["scattered"])
    power = np.log(1.06) / np.log(137.0 / 52.0)
    modes = dispersive(points, lambda f: (f / np.sqrt(52.0 * 137.0)) ** power - 1.0, rng)
    rows = identified(modes, rng=rng, sigma=0.0015, modes=6, shapes=SENSORS, shape_noise=0.02)
    text = written(rows, list(points), SENSORS)
    found = updating.diagnose(robot_of("published"), measurements(text))
    assert (found.verdict, found.rule) == ("unexplained", "claims.dispersion")
    assert "a belt.specific_stiffness that rises with the frequency" in found.reason
