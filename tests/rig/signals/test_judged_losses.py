"""Losses that a diagnosis claims beside a cause are judged by those of the machine."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from pkmodes_rig.signals.small_motion import Losses
from studies import campaign_cases
from studies.campaign_machines import CampaignCase

CASE = CampaignCase(1, 0, 60, "published", "impact", True, "payload", False)
DISSIPATING = Losses(0.004, {"x_1": 2.0}, factor=0.01)
LOSSES = {"belt_loss", "reducer_loss", "rail_friction", "drive_friction", "parameter:damping.ratio"}
RUBBING = Losses(0.004, {"x_1": 2.0}, {"x_1": 0.1}, 0.01)


@pytest.mark.parametrize(
    ("classes", "losses", "state"),
    [
        ([("payload",)], DISSIPATING, "named"),
        ([("payload",), ("belt_loss", "parameter:damping.ratio")], DISSIPATING, "named"),
        ([("payload",), ("rail_friction",)], DISSIPATING, "named"),
        ([("payload",), ("rail_friction",)], RUBBING, "wrong"),
        ([("payload",), ("parameter:damping.ratio",)], RUBBING, "named"),
        ([("payload",), ("drive_friction",)], DISSIPATING, "wrong"),
        ([("payload",), ("belt_loss",)], Losses(0.004), "wrong"),
        ([("belt_mass",)], DISSIPATING, "wrong"),
        ([("parameter:damping.ratio",)], DISSIPATING, "adequate"),
        ([], DISSIPATING, "abstained"),
    ],
)
def test_claims(classes: list[tuple[str, ...]], losses: Losses, state: str) -> None:
    found = [SimpleNamespace(members=members) for members in classes]
    of_losses = [one for one in found if set(one.members) <= LOSSES]
    effects = tuple(one for one in found if one not in of_losses)
    verdict = "effect_found" if effects else "adequate" if of_losses else "unexplained"
    damping = SimpleNamespace(effects=tuple(of_losses))
    diagnosis: Any = SimpleNamespace(verdict=verdict, effects=effects, damping=damping)
    assert campaign_cases._state(CASE, losses, diagnosis) == state
