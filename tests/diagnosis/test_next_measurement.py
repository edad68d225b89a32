"""What is proposed to be measured next: with which motors, what could hide it, and why nothing is."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest

from helpers.diagnoses.frame_diagnoses import checked
from helpers.robots.small_structures import SIGMA, LogLinear, of_signatures, with_changes
from pkmodes.diagnosis import Diagnosis, Measurements

#: Modes of each of three setups; causes a and b differ by two standard deviations there, and n moves nothing.
MODES = 4
PLACES = np.eye(3)


class Elsewhere(LogLinear):
    """A structure whose motors are held, and what it answers where it is measured next."""

    drives = "held"
    places: np.ndarray | None = PLACES
    free: float = 1.0
    absorbed: float = 0.0

    def subset(self, setups: Sequence[int]) -> Elsewhere:
        return self

    def elsewhere(self, count: int) -> tuple[np.ndarray, LogLinear] | None:
        return None if self.places is None else (self.places, self.there(1.0))

    def with_other_drives(self, setups: Sequence[int]) -> LogLinear:
        return self.there(self.free) if self.free else self

    def there(self, times: float) -> Elsewhere:
        """At the second setup the third mode moves three times as much with a as with b, and perhaps with n."""
        G = self.G.copy()
        G[1, 2] = SIGMA * np.array([3.0 * times, times, self.absorbed if times != 1.0 else 0.0])
        other = Elsewhere(self.base, G, self.parameters, self.candidates)
        other.free, other.absorbed = self.free, self.absorbed
        return other


def structure() -> tuple[Elsewhere, Measurements]:
    u = np.full((3, MODES), 12**-0.5)
    v = u * np.where(np.indices(u.shape).sum(axis=0) % 2, 1.0, -1.0)
    signatures = {"a": u + v / 12.0, "b": u - v / 12.0, "n": 0.0 * u}
    model = of_signatures(signatures, 3, MODES, known={"n": {"sigma": 1.0}})
    data = with_changes(model, 12.0 * u + 0.3 * v)
    return Elsewhere(model.base, model.G, model.parameters, model.candidates), data


def diagnosed(**given: object) -> Diagnosis:
    model, data = structure()
    for name, value in given.items():
        setattr(model, name, value)
    found = checked(model, data)
    assert found.effects[0].members == ("a", "b")
    return found


@pytest.mark.parametrize(("free", "drives"), [(2.0, "free"), (1.2, "held"), (0.5, "held")])
def test_other_motors_are_proposed_where_they_separate_far_better(free: float, drives: str) -> None:
    found = diagnosed(free=free)
    proposed = found.next_measurement
    assert proposed is not None
    assert (proposed.pose, proposed.drives, proposed.caveat) == ((0.0, 1.0, 0.0), drives, "")
    a, b = (found.effects[0].alternatives[name][0].value for name in "ab")
    times = free if drives == "free" else 1.0
    assert proposed.sigmas == pytest.approx(abs(3.0 * a - b) * times, rel=0.01)
    content = found.as_json()
    assert content["next_measurement"]["drives"] == drives
    assert content["next_measurement_reason"] is None


def test_an_uncertain_value_that_could_hide_the_difference_is_named() -> None:
    found = diagnosed(free=2.0, absorbed=500.0)
    proposed = found.next_measurement
    assert proposed is not None
    assert (proposed.drives, proposed.hidden_by) == ("free", "n")
    assert "n could make up for most of that within its sigma" in proposed.caveat
    assert found.as_json()["next_measurement"]["hidden_by"] == "n"


def test_it_is_said_why_nothing_is_proposed() -> None:
    unknown = diagnosed(places=None)
    assert unknown.next_measurement is None
    assert unknown.next_measurement_reason == "it is not known where else the structure could be measured"
    nowhere = diagnosed(places=np.empty((0, 3)))
    assert nowhere.next_measurement_reason == "there are no other setups"

    class Alike(Elsewhere):
        def there(self, times: float) -> Elsewhere:
            return self

    model, data = structure()
    alike = checked(Alike(model.base, model.G, model.parameters, model.candidates), data)
    reason = alike.next_measurement_reason
    assert alike.next_measurement is None
    assert reason.startswith(
        "none of 3 other setups separates the remaining explanations by 2 standard deviations or more, with motors "
        "free or held: a and b differ by "
    )
    a, b = (alike.effects[0].alternatives[name][0].value for name in "ab")
    apart = np.linalg.norm((model.G[:, :, 0] * a - model.G[:, :, 1] * b) / SIGMA, axis=1).max()
    assert float(reason.removesuffix(" at most").split()[-1]) == pytest.approx(apart, rel=0.05)
    assert alike.as_json()["next_measurement_reason"] == reason


def test_without_explanations_to_separate_the_verdict_says_so() -> None:
    model, data = structure()
    alone = checked(LogLinear(model.base, model.G, model.parameters, model.candidates[:1]), data)
    assert alone.verdict == "effect_found"
    assert "from every other candidate" in alone.next_measurement_reason
    nothing = checked(model, with_changes(model, np.zeros(3 * MODES)))
    assert nothing.verdict == "adequate"
    assert "the residual is noise" in nothing.next_measurement_reason
