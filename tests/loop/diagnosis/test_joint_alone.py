"""Which one: of a cause with a value for each of several equal parts, the one part that would do alone is named."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

import numpy as np
import pytest

import pkmodes
from pkmodes import updating
from pkmodes.loop.diagnosis import Candidate, Diagnosis, MatrixStructure, Measurements, Parameter, diagnose
from pkmodes.loop.diagnosis.problem import Joint
from pkmodes.loop.diagnosis.verdict import joint_alone
from pkmodes.loop.updating.candidates import suspects
from pkmodes.pages.report.action import recommended_action
from pkmodes.pages.report.diagnosis import verdict_headline
from pkmodes.pages.report.report_context import ReportContext
from pkmodes.pages.view import typical_pose
from studies import clear_cases
from studies.clear_cases import ClearCase
from studies.specimens import ROBOTS, Specimen, measurements_of, robot_of

#: The masses on the upper storey, by setup [kg], and the stiffness that the storeys share [N/m].
LOADS = {"empty": 0.0, "2 kg": 2.0, "4 kg": 4.0, "8 kg": 8.0, "12 kg": 12.0, "16 kg": 16.0}
SHARED = 4e5
STOREYS = ("change 1", "change 2", "change 3")
JOINTS = tuple(Joint(name, f"storey {k}", "stiffness", f"parameter:{k}") for k, name in enumerate(STOREYS, 1))


def chain(values: Mapping[str, float], setup: str) -> tuple[np.ndarray, np.ndarray]:
    """Return M and K of three storeys with the stiffnesses k (1 + a)."""
    k1, k2, k3 = (values["k"] * (1.0 + values[name]) for name in STOREYS)
    M = np.diag([20.0, 20.0, 20.0 + LOADS[setup]])
    return M, np.array([[k1 + k2, -k2, 0.0], [-k2, k2 + k3, -k3], [0.0, -k3, k3]])


def diagnosed(
    matrices: Callable[[Mapping[str, float], str], tuple[np.ndarray, np.ndarray]],
    changes: tuple[float, float, float],
    joints: tuple[Joint, ...] = JOINTS,
    sigma: float = 1e-3,
) -> Diagnosis:
    """Diagnose a structure of which each storey may have a stiffness of its own."""
    true = {"k": 1.01 * SHARED, **dict(zip(STOREYS, changes, strict=True))}
    rng, pose, frequencies, channels = np.random.default_rng(3), list[str](), list[float](), list[str]()
    for setup in LOADS:
        M, K = matrices(true, setup)
        own = np.sqrt(np.sort(np.linalg.eigvals(np.linalg.solve(M, K)).real)) / (2.0 * np.pi)
        channels = [f"floor {k}" for k in range(1, len(own) + 1)]
        pose += [setup] * len(own)
        frequencies += (own * (1.0 + sigma * rng.standard_normal(len(own)))).tolist()
    f = np.array(frequencies)
    parameters = [
        Parameter("k", SHARED, "N/m", sigma=0.02 * SHARED),
        *(Parameter(name, 0.0, lower=-1.0) for name in STOREYS),
    ]
    unequal = Candidate("unequal", STOREYS, "the storeys are not equally stiff", joints=joints)
    structure = MatrixStructure(parameters, [unequal], matrices, channels=channels, setups=list(LOADS))
    return diagnose(structure, Measurements.from_rows(pose, f, sigma * f), holdout=["4 kg"])


def storeys(changes: tuple[float, float, float], joints: tuple[Joint, ...] = JOINTS) -> Diagnosis:
    return diagnosed(chain, changes, joints)


def test_one_soft_storey_is_named_with_its_change() -> None:
    found = storeys((0.0, -0.25, 0.0))
    assert "explanation: storey 2 is 25 % softer than the others (unequal)" in found.reason
    assert verdict_headline(found) == "Cause found: storey 2 is 25 % softer than the others"
    (effect,) = found.effects
    assert effect.alone is not None
    assert abs(effect.alone.change + 0.25) < 3.0 * effect.alone.sigma < 0.02
    inspect = dict(recommended_action(found, ReportContext("", None, None, (), None)).entries)["inspect"]
    assert inspect[0].text == "Storey 2, which is 25 % softer than the others."
    (cause,) = found.as_json()["effects"]  # type: ignore[misc]
    assert cause["term"] == "parameter:2"
    assert cause["term_change"] == {"value": effect.alone.change, "sigma": effect.alone.sigma, "unit": "1"}
    assert len(cause["parameters"]) == 3


def test_a_stiff_storey_is_called_stiffer() -> None:
    found = storeys((0.0, 0.0, 0.3))
    (effect,) = found.effects
    assert effect.alone is not None
    assert abs(effect.alone.change - 0.3) < 3.0 * effect.alone.sigma < 0.02
    assert effect.alone.sentence in found.reason
    assert effect.alone.sentence.endswith(" % stiffer than the others")


def test_several_unequal_storeys_are_not_called_one() -> None:
    found = storeys((0.2, -0.2, 0.0))
    assert verdict_headline(found) == "Cause found: the storeys are not equally stiff"
    assert found.effects[0].alone is None
    (cause,) = found.as_json()["effects"]  # type: ignore[misc]
    assert (cause["term"], cause["term_change"]) == (None, None)


def test_a_storey_that_leaves_a_little_for_another_is_not_named() -> None:
    """Alone it leaves nothing but noise, but by the criterion the data ask for the other one, too."""
    assert verdict_headline(storeys((0.0, -0.25, 0.02))) == "Cause found: the storeys are not equally stiff"


def test_a_cause_without_joints_names_none() -> None:
    assert storeys((0.0, -0.25, 0.0), joints=()).effects[0].alone is None


def test_a_storey_that_does_not_predict_the_held_out_setups_is_not_named(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(joint_alone, "p_of_held_out", lambda *_: 1e-6)
    found = storeys((0.0, -0.25, 0.0))
    assert found.verdict == "effect_found"
    assert found.effects[0].alone is None


def test_two_columns_that_hardly_differ_are_not_told_apart() -> None:
    """Two columns stand below the first floor; the true one, the first, fits a little worse alone than the second."""

    def columns(values: Mapping[str, float], setup: str) -> tuple[np.ndarray, np.ndarray]:
        k1, k2, k3 = (values["k"] * (1.0 + values[name]) for name in STOREYS)
        M = np.diag([20.0, 20.0 + LOADS[setup]])
        return M, np.array([[k1 + k2 + k3, -k3], [-k3, k3 + 1e-3 * k2]])

    found = diagnosed(columns, (-0.3, 0.0, 0.0), sigma=3e-4)
    assert found.verdict == "effect_found"
    assert not found.alone


# Robots ---------------------------------------------------------------------------------------------------------


def test_a_soft_leg_of_a_hexapod_is_named() -> None:
    robot = robot_of("hexapod")
    case = ClearCase("one effect", 1, "hexapod", ("axis_leg_stiffness",), (9.0, 14.0), seed=2, drives="held")
    truth = Specimen("hexapod", {"axis_leg_stiffness.factor_3": -0.25}, drives="held")
    _, text = clear_cases.found(case, truth)
    found = updating.diagnose(robot, measurements_of(text, robot))
    (effect,) = found.effects
    assert effect.alone is not None
    assert effect.alone.joint.term == "parameter:axis.3.leg.stiffness"
    assert abs(effect.alone.change + 0.25) < 3.0 * effect.alone.sigma
    percent = round(-100.0 * effect.alone.change)
    assert verdict_headline(found) == f"Cause found: leg 3 is {percent} % softer than the others"


#: Robot files, by mechanism.
FILES = {
    "linear_delta": "linear-delta-2022",
    "rotary_delta": "clavel-delta",
    "corexy": "corexy-printer",
    "cartesian": "cartesian-printer",
    "bed_slinger": "bed-slinger",
    "hexapod": "hexapod",
    "hexaglide": "hexaglide",
}


@pytest.mark.parametrize("name", FILES)
def test_a_joint_is_the_declared_value_that_its_factor_changes(name: str) -> None:
    """10 % by the factor of an effect, or by the declared value of that joint: the same frequencies."""
    robot = pkmodes.read_robot(ROBOTS / f"{FILES[name]}.toml")
    assert robot.mechanism_name == name
    candidates = [one for one in suspects(_without_sigmas(robot))[1] if one.joints]
    assert candidates, "no cause has a value for each joint"
    pose = typical_pose(pkmodes.Model(robot))
    for joint in candidates[0].joints:
        path = joint.term.removeprefix("parameter:")
        words, number = joint.words.split()
        assert f".{number}.{words}." in f".{path}."
        value = robot.quantities[path.partition(".")[2].partition(".")[2]].value
        declared = pkmodes.Model(robot.with_values({path: {"value": 1.1 * value, "sigma": None}}))
        by_factor = pkmodes.Model(robot.with_values({joint.parameter: 0.1}))
        np.testing.assert_allclose(
            declared.modes(pose).frequencies, by_factor.modes(pose).frequencies, rtol=1e-9, atol=1e-3
        )


def _without_sigmas(robot: pkmodes.Robot) -> pkmodes.Robot:
    quantities = {path: replace(one, sigma=None) for path, one in robot.quantities.items()}
    return replace(robot, quantities=quantities)
