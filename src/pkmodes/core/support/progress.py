"""What a long computation is doing now, for whoever waits for it: silent unless someone listens."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar

_listener: ContextVar[Callable[[str], None] | None] = ContextVar("progress", default=None)


def say(text: str) -> None:
    """Say what is done from now on, such as "picture 2 of 7: frequencies"."""
    listener = _listener.get()
    if listener is not None:
        listener(text)


@contextmanager
def told(listener: Callable[[str], None]) -> Iterator[None]:
    """Pass on what is said inside the block."""
    token = _listener.set(listener)
    try:
        yield
    finally:
        _listener.reset(token)
