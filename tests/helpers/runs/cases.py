"""Many cases in one test: all are tried, and those that are wrong are named together."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager

import pytest


@contextmanager
def every_case() -> Iterator[Callable[[object], AbstractContextManager[None]]]:
    """Give a context for each case, which takes its name and whose errors are kept until the end.

    ::

        with every_case() as tried:
            for value in VALUES:
                with tried(value):
                    assert value > 0
    """
    wrong: list[str] = []
    count = 0

    @contextmanager
    def tried(name: object) -> Iterator[None]:
        nonlocal count
        count += 1
        try:
            yield
        except (Exception, pytest.fail.Exception) as error:
            wrong.append(f"{name}: {error or repr(error)}")

    yield tried
    assert count, "no case was tried"
    assert not wrong, f"{len(wrong)} of {count} cases are wrong\n" + "\n".join(wrong)
