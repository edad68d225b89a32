"""A line on the terminal with what a command is doing, and for how long; erased before anything is printed.

There is none where stderr is no terminal, so that nothing of it reaches a file or a pipe.
"""

from __future__ import annotations

import os
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from typing import TextIO

from pkmodes.core.base.errors import printable
from pkmodes.core.support.progress import reporting_to

#: Seconds before a command shows its progress, and between two updates of the line.
FIRST_DELAY, UPDATE_INTERVAL = 0.3, 0.2
#: Columns of a terminal that does not report them.
DEFAULT_COLUMNS = 80


def duration(seconds: float) -> str:
    """Return a time in words: 12 s, 3 min 20 s, 2 h 5 min."""
    minutes, seconds_past = divmod(round(seconds), 60)
    hours, minutes_past = divmod(minutes, 60)
    if hours:
        return f"{hours} h {minutes_past} min"
    return f"{minutes} min {seconds_past} s" if minutes else f"{seconds_past} s"


class ProgressLine:
    """A line on a terminal, rewritten by a thread so that its seconds count while the command computes.

    - stream: the terminal
    - text: the first activity
    """

    def __init__(self, stream: TextIO, text: str) -> None:
        self._stream, self._text, self._shown_length = stream, text, 0
        self._start_time = time.monotonic()
        self._lock, self._ended = threading.Lock(), threading.Event()
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def say(self, text: str) -> None:
        """Show another activity from now on."""
        self._text = printable(text)

    def clear(self) -> None:
        """Erase the line, so that something can be printed; it is written again at the next update."""
        with self._lock:
            self._write("")

    def end(self) -> None:
        """Erase the line for good."""
        self._ended.set()
        self._thread.join()
        self.clear()

    def _run(self) -> None:
        wait = FIRST_DELAY
        while not self._ended.wait(wait):
            with self._lock:
                self._write(f"{self._text} ... {duration(time.monotonic() - self._start_time)}")
            wait = UPDATE_INTERVAL

    def _write(self, line: str) -> None:
        columns = DEFAULT_COLUMNS
        with suppress(OSError, ValueError):
            columns = os.get_terminal_size(self._stream.fileno()).columns or DEFAULT_COLUMNS
        line = line[: columns - 1]
        if line or self._shown_length:
            with suppress(OSError, ValueError):  # the terminal is gone
                self._stream.write("\r" + line.ljust(self._shown_length) + ("" if line else "\r"))
                self._stream.flush()
        self._shown_length = len(line)


_current: ProgressLine | None = None


def on_terminal() -> bool:
    """Return whether progress is shown."""
    return sys.stderr is not None and sys.stderr.isatty()


@contextmanager
def progress_line(text: str) -> Iterator[None]:
    """If stderr is a terminal, show what `core.support.progress.report_progress` reports inside the block."""
    global _current
    if not on_terminal():
        yield
        return
    line = _current = ProgressLine(sys.stderr, text)
    try:
        with reporting_to(line.say):
            yield
    finally:
        end_progress()


def clear_progress() -> None:
    """Erase the line before something else is printed."""
    if _current is not None:
        _current.clear()


def end_progress() -> None:
    """Erase the line for good: results follow."""
    global _current
    if _current is not None:
        _current.end()
        _current = None
