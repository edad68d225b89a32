"""Progress of long computations, for the user who waits: silent unless a listener is set."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar

_listener: ContextVar[Callable[[str], None] | None] = ContextVar("progress", default=None)


def report_progress(text: str) -> None:
    """Report what is being done from now on, such as "picture 2 of 7: frequencies"."""
    listener = _listener.get()
    if listener is not None:
        listener(text)


@contextmanager
def reporting_to(listener: Callable[[str], None]) -> Iterator[None]:
    """Pass every report made inside the block to a listener."""
    token = _listener.set(listener)
    try:
        yield
    finally:
        _listener.reset(token)
