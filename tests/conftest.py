"""Tests marked `compiler` need a C compiler; where there is none they are skipped.  `.ci/run` requires one."""

from __future__ import annotations

import pytest

from pkmodes.compiled import build


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup(item: pytest.Item) -> None:
    if item.get_closest_marker("compiler") and not build.compiler():
        pytest.skip("needs a C compiler: install gcc or clang")
