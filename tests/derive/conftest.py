"""Robots whose generated products several modules test: generated and compiled once a run."""

from __future__ import annotations

import pytest

from helpers.generated.generated_robots import CASES, Robot
from helpers.runs.shared import Shared


@pytest.fixture(scope="session", params=CASES)
def robot(request: pytest.FixtureRequest, shared: Shared) -> Robot:
    """Tests only read its files."""
    case: str = request.param
    return Robot(shared.folder(f"robot_{case}", lambda folder: Robot.write(folder, case)), case)
