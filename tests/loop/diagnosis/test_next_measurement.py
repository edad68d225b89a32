"""What is proposed to be measured next: where, with which motors, what could hide it, and why nothing is."""

from __future__ import annotations

from collections.abc import Collection, Sequence

import numpy as np
import pytest

import pkmodes
from helpers.diagnoses.frame_diagnoses import checked
from helpers.robots.one_of_each import EVERY, POSES, ROBOTS
from helpers.robots.small_structures import SIGMA, LogLinear, errors, of_signatures, with_changes
from pkmodes.loop.diagnosis import Diagnosis, Measurements
from pkmodes.loop.updating.load_cases import LoadCase, LoadCases
from pkmodes.loop.updating.robot_structure import RobotStructure

#: Modes of each of three setups; causes a and b differ by two standard deviations there, and n moves nothing.
MODES = 4
PLACES = np.eye(3)


class Elsewhere(LogLinear):
    """A structure whose motors are held, and what it answers where it is measured next."""

    drives = "held"
    places: np.ndarray | None = PLACES
    gives_way: bool = False
    held: float = 1.0
    free: float = 1.0
    absorbed: tuple[float, float] = (0.0, 0.0)

    def subset(self, setups: Sequence[int]) -> Elsewhere:
        return self

    def elsewhere(self, count: int) -> tuple[np.ndarray, LogLinear] | None:
        return None if self.places is None else (self.places, self.there(self.held, self.absorbed[0]))

    def with_other_drives(self, setups: Sequence[int]) -> LogLinear:
        return self.there(self.free, self.absorbed[1])

    def may_be_held(self, causes: Collection[str]) -> bool:
        return not self.gives_way

    def there(self, times: float, absorbed: float) -> Elsewhere:
        """Only the third mode of the second setup moves much: three times as much with a as with b, and with n."""
        G = 0.1 * self.G
        G[1, 2] = SIGMA * np.array([3.0 * times, times, absorbed])
        other = Elsewhere(self.base, G, self.parameters, self.candidates)
        other.drives, other.free, other.absorbed = self.drives, self.free, self.absorbed
        return other


def structure() -> tuple[Elsewhere, Measurements]:
    u = np.full((3, MODES), 12**-0.5)
    v = u * np.where(np.indices(u.shape).sum(axis=0) % 2, 1.0, -1.0)
    signatures = {"a": u + v / 12.0, "b": u - v / 12.0, "n": 0.0 * u}
    model = of_signatures(signatures, 3, MODES, known={"n": {"sigma": 1.0}})
    beside = errors(3 * MODES, np.array([u.ravel(), v.ravel()]))
    data = with_changes(model, 12.0 * u + 0.3 * v + beside.reshape(u.shape))
    return Elsewhere(model.base, model.G, model.parameters, model.candidates), data


def diagnosed(**given: object) -> Diagnosis:
    model, data = structure()
    for name, value in given.items():
        setattr(model, name, value)
    found = checked(model, data)
    assert found.effects[0].members == ("a", "b")
    return found


def apart(found: Diagnosis, there: Elsewhere, setup: int) -> float:
    """How far a and b are apart at a setup, in standard deviations of a frequency."""
    a, b = (found.effects[0].alternatives[name][0].value for name in "ab")
    return float(np.linalg.norm(there.G[setup, :, 0] * a - there.G[setup, :, 1] * b)) / SIGMA


@pytest.mark.parametrize(
    ("held", "free", "drives"),
    [
        (0.09, 0.35, "free"),  # free motors tell far more
        (0.09, 0.1, "held"),  # hardly more: not worth the work
        (0.35, 2.0, "held"),  # held motors tell everything
    ],
)
def test_other_motors_are_proposed_where_they_tell_far_more(held: float, free: float, drives: str) -> None:
    found = diagnosed(held=held, free=free)
    proposed = found.next_measurement
    assert proposed is not None
    assert (proposed.pose, proposed.drives, proposed.caveat) == ((0.0, 1.0, 0.0), drives, "")
    assert proposed.separates == ("a", "b")
    there = structure()[0].there(free if drives == "free" else held, 0.0)
    assert proposed.sigmas == pytest.approx(apart(found, there, 1), rel=1e-3)
    content = found.as_json()
    assert content["next_measurement"]["drives"] == drives
    assert content["next_measurement_reason"] is None


@pytest.mark.parametrize(("drives", "other"), [("free", "held"), ("held", "free")])
def test_motors_that_give_way_are_not_to_be_held(drives: str, other: str) -> None:
    """But motors that were held in the measurements may be free, however they are held."""
    both = {"drives": drives, "held": 0.09, "free": 0.35}
    assert (proposed := diagnosed(**both).next_measurement) is not None
    assert proposed.drives == other
    assert proposed.motors == ("motor shafts clamped" if other == "held" else "motors free")
    assert (proposed := diagnosed(**both, gives_way=True).next_measurement) is not None
    assert proposed.drives == "free"
    reason = diagnosed(drives=drives, held=0.03, free=0.03, gives_way=True).next_measurement_reason
    assert ("clamped" in reason) == (drives == "held")


@pytest.mark.parametrize("name", EVERY.values())
def test_motors_give_way_as_declared_or_claimed_and_are_held_where_some_were(name: str) -> None:
    off = pkmodes.read_robot(ROBOTS / name)
    on = off.with_values({"effects.servo_stiffness.stiffness": 15.0})
    pose = POSES[off.mechanism_name]

    def asked(robot: pkmodes.Robot, causes: set[str], *drives: str) -> bool:
        cases = tuple(LoadCase(robot, drives=one) for one in drives)
        loads = LoadCases((), cases, np.arange(len(drives)))
        points = np.tile(pose, (len(drives), 1))
        return RobotStructure(robot, points, (), (), {}, loads, ()).may_be_held(causes)

    assert asked(off, set(), "free")
    assert asked(off, {"payload", "cable_stiffness", "spring:platform"}, "free")
    assert not asked(off, {"servo_stiffness"}, "free")
    assert not asked(on, set(), "free")
    assert asked(on, set(), "free", "held")
    assert asked(off, {"servo_stiffness"}, "held")


def test_a_difference_that_an_uncertain_value_hides_is_not_measured_but_another_one() -> None:
    # With free motors the difference is far larger, and n hides it.
    found = diagnosed(held=0.09, free=0.35, absorbed=(0.0, 500.0)).next_measurement
    assert found is not None
    assert (found.drives, found.hidden_by) == ("held", "")


def test_an_uncertain_value_that_could_hide_the_difference_is_named() -> None:
    found = diagnosed(held=0.03, free=0.35, absorbed=(0.0, 500.0))  # held motors tell nothing
    proposed = found.next_measurement
    assert proposed is not None
    assert (proposed.drives, proposed.hidden_by) == ("free", "n")
    assert proposed.sigmas == pytest.approx(apart(found, structure()[0].there(0.35, 500.0), 1), rel=1e-3)
    assert "n could make up for most of that within its sigma" in proposed.caveat
    assert found.as_json()["next_measurement"]["hidden_by"] == "n"


def test_it_is_said_why_nothing_is_proposed() -> None:
    unknown = diagnosed(places=None)
    assert unknown.next_measurement is None
    assert unknown.next_measurement_reason == "it is not known where else the structure could be measured"
    nowhere = diagnosed(places=np.empty((0, 3)))
    assert nowhere.next_measurement_reason == "there are no other setups"
    alike = diagnosed(held=0.03, free=0.03)
    reason = alike.next_measurement_reason
    assert alike.next_measurement is None
    assert reason.startswith(
        "none of 3 other setups separates the remaining explanations by 2 standard deviations or more, with motors "
        "free or their shafts clamped: a and b differ by "
    )
    there = structure()[0].there(0.03, 0.0)
    most = max(apart(alike, there, setup) for setup in range(3))
    assert float(reason.removesuffix(" standard deviations").split()[-1]) == pytest.approx(most, rel=0.05)
    assert alike.as_json()["next_measurement_reason"] == reason


def test_without_explanations_to_separate_the_verdict_says_so() -> None:
    model, data = structure()
    alone = checked(LogLinear(model.base, model.G, model.parameters, model.candidates[:1]), data)
    assert alone.verdict == "effect_found"
    assert "from every other candidate" in alone.next_measurement_reason
    nothing = checked(model, with_changes(model, np.zeros(3 * MODES)))
    assert nothing.verdict == "adequate"
    assert "the residual is noise" in nothing.next_measurement_reason


def test_the_pose_that_separates_all_explanations_is_proposed_and_not_that_where_two_differ_most() -> None:
    # At the first place a differs from b and c by 15 standard deviations, at the second each from each by three or
    # more: nearly ln 3, not ln 3 - 2/3 ln 2.
    u = np.full((3, MODES), 12**-0.5)
    model = of_signatures(dict.fromkeys("abc", u), 3, MODES)
    data = with_changes(model, 12.0 * u)
    places = model.G[:2].copy()
    places[0, 1] = SIGMA * np.array([9.0, 1.0, 1.0])
    places[1, 1] = SIGMA * np.array([1.0, 1.5, 2.0])

    class Movable(LogLinear):
        def elsewhere(self, count: int) -> tuple[np.ndarray, LogLinear]:
            there = LogLinear(self.base[:2], places, self.parameters, self.candidates)
            return np.array([[1.0, 0.0, 0.0], [2.0, 0.0, 0.0]]), there

        def subset(self, setups: Sequence[int]) -> LogLinear:
            return self

    found = checked(Movable(model.base, model.G, model.parameters, model.candidates), data)
    assert found.effects[0].members == ("a", "b", "c")
    assert found.next_measurement is not None
    assert found.next_measurement.pose == (2.0, 0.0, 0.0)
    assert found.next_measurement.separates == ("a", "c")
