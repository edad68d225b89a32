"""The published robot, of which most maps are."""

from __future__ import annotations

import pytest

import pkmodes
from helpers.robots.robot_text import PUBLISHED


@pytest.fixture(scope="session")
def model() -> pkmodes.Model:
    return pkmodes.load(PUBLISHED)
