"""What changed between two campaigns of the virtual test rig: a few pairs, each of which shows a rule of changes.

How often an answer is right is measured by the whole suite, in docs/reference/results.md.
"""

from __future__ import annotations

import pytest

from studies.changed import pair
from studies.changed_judging import run

#: Pairs by seed, suite and number; what changed there, and why it was not named before.
NAMED = [
    pytest.param(7, "clear", 67, "mount:pulley_2", id="a_law_must_be_clearly_better"),
    pytest.param(6, "sigmas", 61, "mount:pulley_1", id="a_mount_whose_mass_is_0"),
    pytest.param(6, "clear", 61, "spring:platform.x", id="no_mode_shows_the_direction"),
    pytest.param(6, "clear", 72, "compliance:eps_2", id="a_frame_is_a_clamp_to_first_order_only"),
    pytest.param(7, "sigmas", 72, "mount:pulley_1", id="with_a_mass_better_than_terms_without"),
    pytest.param(
        20290103, "clear", 3, "parameter:axis.1.pulley.inertia", id="an_exchanged_part_acts_like_a_spring"
    ),
    pytest.param(6, "clear", 50, "frame_compliance.compliance_y", id="a_frame_whose_mass_is_a_default"),
]


@pytest.mark.parametrize(("seed", "suite", "number", "name"), NAMED)
def test_what_changed_is_named(seed: int, suite: str, number: int, name: str) -> None:
    outcome = run(pair(suite, number, seed))
    assert outcome.state == "named", outcome.reason
    (members,) = outcome.classes
    assert name in members


@pytest.mark.parametrize("number", [21, 23])
def test_what_the_trusted_state_leaves_unknown_is_no_change(number: int) -> None:
    """Hexapods of which two campaigns found half of the modes, each other ones, with shapes of unknown errors."""
    outcome = run(pair("unchanged", number, 20290103))
    assert (outcome.state, outcome.verdict) == ("unchanged", "adequate"), outcome.reason
