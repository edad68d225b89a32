"""A diagnosis limits BLAS to one thread, and leaves the limit of the process as it was."""

from __future__ import annotations

from unittest.mock import MagicMock

import numpy as np
import pytest
from threadpoolctl import threadpool_info, threadpool_limits

from pkmodes import updating
from pkmodes.core.support.threads import one_blas_thread
from pkmodes.loop.updating import analyses


def threads() -> set[int]:
    np.linalg.eigh(np.eye(2))
    return {library["num_threads"] for library in threadpool_info() if library["user_api"] == "blas"}


def test_blas_has_one_thread_while_it_lasts() -> None:
    with threadpool_limits(limits=2, user_api="blas"):
        before = threads()
        with one_blas_thread():
            assert threads() == {1}
        assert threads() == before


@pytest.mark.parametrize("name", ["diagnose", "update"])
def test_the_fits_of_a_robot_are_limited(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    seen = []
    monkeypatch.setattr(analyses, "MeasuredRobot", MagicMock())

    def fit(*_: object, **__: object) -> MagicMock:
        seen.append(threads())
        return MagicMock(corrected=None)

    monkeypatch.setattr(analyses.diagnosis, name, fit)
    with threadpool_limits(limits=2, user_api="blas"):
        getattr(updating, name)(None, None)
    assert seen == [{1}]
