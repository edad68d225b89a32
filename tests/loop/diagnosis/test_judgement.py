"""Which causes are claimed: remote causes, general forms, weak causes, and measurement errors beside causes.

Structures whose frequencies' logarithms are linear in the parameters, with data that are exact, so that every
chi-square is known: a cause of strength z gains z^2.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import pytest

from helpers.robots.small_structures import (
    SIGMA,
    LogLinear,
    directions,
    errors,
    of_signatures,
    with_changes,
)
from pkmodes.loop.diagnosis import Candidate, Diagnosis, Measurements, diagnose

SETUPS, MODES = 10, 5
#: The signatures of the causes.
DIRECTIONS = directions(SETUPS * MODES, 12)


def structure(signatures: Mapping[str, np.ndarray], **roles: dict[str, Any]) -> LogLinear:
    """One cause for each signature; some are remote, not nameable, or part of another."""
    return of_signatures(signatures, SETUPS, MODES, roles=roles)


def found(model: LogLinear, change: np.ndarray) -> Diagnosis:
    """The diagnosis of frequency changes in standard deviations, with errors as stated."""
    return diagnose(model, with_changes(model, change + errors(SETUPS * MODES, DIRECTIONS)), holdout=())


def names(diagnosis: Diagnosis) -> list[str]:
    return sorted(effect.name for effect in diagnosis.effects)


REMOTE = {"remote": True}
STRANGE = {"remote": True, "nameable": False}


def three(strength: Sequence[float] = (30.0, 40.0)) -> tuple[dict[str, np.ndarray], np.ndarray]:
    """Causes a and b, their combined effect, and a cause c with the same effect."""
    a, b = DIRECTIONS[:2]
    both = strength[0] * a + strength[1] * b
    return {"a": a, "b": b, "c": both / np.linalg.norm(both)}, both


def test_two_causes_are_claimed_where_nothing_explains_the_residual_alone() -> None:
    causes, both = three()
    del causes["c"]
    assert names(found(structure(causes), both)) == ["a", "b"]


@pytest.mark.parametrize("remote", [REMOTE, STRANGE])
def test_a_remote_cause_that_explains_the_residual_alone_is_named_before_two_are_claimed(
    remote: dict[str, bool],
) -> None:
    causes, both = three()
    diagnosis = found(structure(causes, c=remote), both)
    assert diagnosis.verdict == "unexplained"
    assert "but c would: look there" in diagnosis.reason
    assert ("candidates" in diagnosis.reason.split("look there")[1]) == ("nameable" not in remote)
    assert diagnosis.effects == diagnosis.survivors == ()


def test_a_remote_cause_among_the_plain_ones_is_claimed() -> None:
    causes, both = three()
    assert names(found(structure(causes), both)) == ["c"]


def test_a_nameable_remote_cause_that_looks_like_a_plain_one_is_listed_in_its_class() -> None:
    a, b = DIRECTIONS[:2]
    like_a = (a + 0.02 * b) / np.linalg.norm(a + 0.02 * b)
    # Nearer to the plain one, and nearer to the remote one.
    for change in (30.0 * a, 30.0 * like_a):
        diagnosis = found(structure({"a": a, "b": b, "like a": like_a}, **{"like a": REMOTE}), change)
        assert names(diagnosis) == ["a"]
        assert set(diagnosis.effects[0].members) == {"a", "like a"}
        # One that cannot be named is in no class.
        strange = found(structure({"a": a, "b": b, "like a": like_a}, **{"like a": STRANGE}), change)
        assert set(strange.effects[0].members) == {"a"}


def test_parts_that_cannot_be_told_apart_are_claimed_only_with_their_whole() -> None:
    a, b = DIRECTIONS[:2]
    signatures = {
        name: (a + k * b) / np.hypot(1.0, k) for name, k in (("x", 0.0), ("y", 0.02), ("whole", 0.01))
    }
    parts = {name: {"part_of": "whole"} for name in ("x", "y")}
    alone = {name: signatures[name] for name in parts}
    without = found(structure(alone, **parts), 30.0 * a)
    assert without.verdict == "ambiguous"
    assert {name for group in without.survivors for name in group} == {"x", "y"}
    # One part is a claim; so are causes that are no parts, and the whole with its parts.
    assert found(structure(alone, x=parts["x"]), 30.0 * a).verdict == "effect_found"
    assert found(structure(alone), 30.0 * a).verdict == "effect_found"
    assert set(found(structure(signatures, **parts), 30.0 * a).effects[0].members) == {"x", "y", "whole"}


def test_a_whole_and_a_part_of_it_are_not_claimed_together() -> None:
    a, b = DIRECTIONS[:2]
    change = 30.0 * a + 40.0 * b
    assert names(found(structure({"whole": a, "x": b}), change)) == ["whole", "x"]
    assert found(structure({"whole": a, "x": b}, x={"part_of": "whole"}), change).verdict == "unexplained"


def test_a_remote_cause_that_can_be_told_from_a_plain_one_and_fits_better_is_not_hidden_by_it() -> None:
    """z = 4.6 from the plain one's best fit: not enough for the gate, which asks for the sum of all squares."""
    a, b = DIRECTIONS[:2]
    across = 30.0 * (a + 0.2 * b) / np.linalg.norm(a + 0.2 * b)
    model = structure({"a": a, "c": across / 30.0, "b": DIRECTIONS[2]}, c=REMOTE)
    diagnosis = found(model, across)
    assert diagnosis.verdict in ("ambiguous", "unexplained")
    assert "c" in diagnosis.reason


def test_a_remote_cause_is_not_part_of_a_pair() -> None:
    a, b = DIRECTIONS[:2]
    diagnosis = found(structure({"a": a, "b": b}, b=REMOTE), 30.0 * a + 40.0 * b)
    assert diagnosis.verdict == "unexplained"
    assert "look there" not in diagnosis.reason


@pytest.mark.parametrize(("strength", "claimed"), [(3.6, False), (4.6, True)])
def test_what_may_be_chance_is_not_claimed(strength: float, claimed: bool) -> None:
    """Ten candidates of both signs: z = 3.6 comes by chance in 0.3 % of all cases, z = 4.6 in 0.004 %."""
    causes = {f"cause {i}": DIRECTIONS[i] for i in range(10)}
    diagnosis = found(structure(causes), strength * DIRECTIONS[4])
    if claimed:
        assert names(diagnosis) == ["cause 4"]
        assert diagnosis.effects[0].p_value == pytest.approx(10 * 4.2e-6, rel=0.1)
    else:
        assert diagnosis.verdict == "unexplained"
        assert "cause 4" in diagnosis.reason
        assert "p = 0.0032" in diagnosis.reason


def test_two_causes_with_an_outlier_are_not_claimed() -> None:
    a, b = DIRECTIONS[:2]
    change = 30.0 * a + 40.0 * b
    change[7] += 25.0
    assert found(structure({"a": a, "b": b}), change).verdict == "unexplained"
    # One of them with an outlier is claimed.
    change = 40.0 * b
    change[7] += 25.0
    diagnosis = found(structure({"a": a, "b": b}), change)
    assert names(diagnosis) == ["b"]
    assert len(diagnosis.outliers) == 1


def test_a_cause_that_explains_one_row_is_distinguished_from_an_outlier_only_by_other_rows() -> None:
    row = np.zeros(SETUPS * MODES)
    row[7] = 1.0
    for rest in (0.0, 0.02):
        cause = row + rest * DIRECTIONS[0] * (1.0 - row)
        cause /= np.linalg.norm(cause)
        diagnosis = found(structure({"a": cause, "b": DIRECTIONS[1]}), 20.0 * cause)
        assert diagnosis.verdict == "unexplained"
        assert "measurement errors would do so nearly as well" in diagnosis.reason
    clear = row + 0.2 * DIRECTIONS[0] * (1.0 - row)
    clear /= np.linalg.norm(clear)
    assert names(found(structure({"a": clear, "b": DIRECTIONS[1]}), 20.0 * clear)) == ["a"]


def test_many_pairs_that_look_alike_are_not_claimed() -> None:
    """Two causes with classes of three each are nine pairs."""
    a, b = DIRECTIONS[:2]
    causes = {f"{n}{i}": d + 0.01 * DIRECTIONS[2 + i] for n, d in (("a", a), ("b", b)) for i in range(3)}
    diagnosis = found(structure(causes), 30.0 * causes["a0"] + 40.0 * causes["b0"])
    assert diagnosis.verdict == "ambiguous"
    assert ("a0 + b0",) in diagnosis.survivors or ("b0 + a0",) in diagnosis.survivors
    assert len(diagnosis.survivors) > 4
    assert all(len(members) == 1 for members in diagnosis.survivors)
    two = {name: causes[name] for name in ("a0", "a1", "b0", "b1")}
    assert found(structure(two), 30.0 * two["a0"] + 40.0 * two["b0"]).verdict == "effect_found"


@pytest.mark.parametrize("pull", [0.0, 0.5])
def test_modes_that_a_cause_adds_between_measured_ones_must_be_measured(pull: float) -> None:
    """With the cause, a sixth mode above the five measured ones moves between the fourth and fifth."""
    a = DIRECTIONS[0]
    five = structure({"a": a})
    sixth = np.full((SETUPS, 1), five.base[0, -1] + 0.35)
    lowered = np.full((SETUPS, 1, 1), -pull / 30.0)
    model = LogLinear(
        np.hstack([five.base, sixth]),
        np.concatenate([five.G, lowered], axis=1),
        five.parameters,
        five.candidates,
    )
    diagnosis = diagnose(model, with_changes(five, 30.0 * a), holdout=())
    if pull:
        assert diagnosis.verdict == "unexplained"
        assert "were not measured" in diagnosis.reason
    else:
        assert names(diagnosis) == ["a"]


def test_modes_missed_with_and_without_a_cause_do_not_contradict_it() -> None:
    """One of five modes was not measured in every other setup, and the cause is still found."""
    a = DIRECTIONS[0]
    model = structure({"a": a, "b": DIRECTIONS[1]})
    logs = model.base + SIGMA * 30.0 * a.reshape(SETUPS, MODES)
    kept = [(i, k) for i in range(SETUPS) for k in range(MODES) if k != 2 or i % 2]
    f = np.exp([logs[i, k] for i, k in kept])
    data = Measurements.from_rows([f"P{i}" for i, _ in kept], f, SIGMA * f)
    assert names(diagnose(model, data, holdout=())) == ["a"]


def test_a_plain_cause_is_not_claimed_where_a_special_one_explains_far_more() -> None:
    """The plain cause leaves 5.7 standard deviations in one direction, too little for the gate to refuse it."""
    a, b = DIRECTIONS[:2]
    plain = np.sqrt(1 - (5.7 / 30) ** 2) * a + 5.7 / 30 * b
    diagnosis = found(structure({"plain": plain, "special": a}, special=STRANGE), 30.0 * a)
    assert diagnosis.verdict == "unexplained"
    assert "special would: look there" in diagnosis.reason


def test_two_outliers_along_a_cause_are_not_taken_for_it() -> None:
    rows = [7, 23]
    cause = 0.2 * DIRECTIONS[0]
    cause[rows] = 0.93 / np.sqrt(2)
    cause /= np.linalg.norm(cause)
    setups = 12  # two rows of sixty may be outliers
    signatures = {
        "a": np.append(cause, np.zeros(2 * MODES)),
        "b": np.append(DIRECTIONS[1], np.zeros(2 * MODES)),
    }
    model = of_signatures(signatures, setups, MODES)
    change = 0.9 * np.random.default_rng(5).standard_normal(setups * MODES)
    change[rows] += 12.0
    diagnosis = diagnose(model, with_changes(model, change), holdout=())
    assert diagnosis.verdict in ("adequate", "unexplained")


def test_a_cause_in_all_joints_is_not_claimed_where_one_joint_explains_as_much() -> None:
    """One of its own joints must be told from it by 5 standard deviations, any other joint by 3."""
    a, b, c, d = DIRECTIONS[:4]

    def together(apart: float, own: bool) -> Diagnosis:
        angle = np.arcsin(apart / 30.0)  # a fit of the one in place of the other leaves the square of this
        alone = np.cos(angle) * a + np.sin(angle) * b
        model = structure({"a": a, "c": c, "alone": alone, "d": d})
        model.candidates = (
            *model.candidates[:2],
            Candidate("one joint", ("alone",), **STRANGE),
            Candidate("each", ("alone", "d"), general_of="a" if own else "c"),
        )
        return found(model, 30.0 * a)

    for apart, own, claimed in (
        (4.0, False, True),
        (4.0, True, False),
        (6.0, True, True),
    ):
        diagnosis = together(apart, own)
        assert names(diagnosis) == (["a"] if claimed else [])
        if not claimed:
            assert "a would explain the residual, and so would one joint: look there" in diagnosis.reason
