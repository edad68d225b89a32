"""The libraries that the tests of the compiled evaluator load are built once, in a folder of the run."""

from __future__ import annotations

import pytest

from pkmodes.compiled import build


@pytest.fixture(scope="session", autouse=True)
def _compiler() -> None:
    assert build.compiler(), "the tests of the compiled evaluator need a C compiler: install gcc or clang"
