"""Losses that a diagnosis claims beside a cause are judged by those of the machine."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from pkmodes_rig.signals.small_motion import Losses
from pkmodes_rig.suites import campaign_cases
from pkmodes_rig.suites.campaign_machines import CampaignCase

CASE = CampaignCase(1, 0, 60, "published", "impact", True, "payload", False)
DISSIPATING = Losses(0.004, {"x_1": 2.0}, factor=0.01)
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
def test_claims(
    monkeypatch: pytest.MonkeyPatch, classes: list[tuple[str, ...]], losses: Losses, state: str
) -> None:
    def replaced(given: Any, **changes: Any) -> Any:
        return SimpleNamespace(**{**vars(given), **changes})

    monkeypatch.setattr(campaign_cases, "replace", replaced)
    effects = tuple(SimpleNamespace(members=members) for members in classes)
    diagnosis: Any = SimpleNamespace(verdict="effect_found" if classes else "unexplained", effects=effects)
    assert campaign_cases._state(CASE, losses, diagnosis) == state
