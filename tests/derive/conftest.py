"""Robots whose generated products several modules test: generated and compiled once."""

from __future__ import annotations

import pytest

from helpers.generated.generated_robots import CASES, Robot


@pytest.fixture(scope="session", params=CASES)
def robot(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Robot:
    return Robot(tmp_path_factory.mktemp(request.param), request.param)
