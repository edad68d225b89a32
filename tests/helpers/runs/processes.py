"""Processes that tests start, and what they print."""

from __future__ import annotations

import re
import signal


def interruptible() -> None:
    """Restore what Ctrl-C does, in a new process before its program starts (``preexec_fn``).

    Where a script runs the tests in the background, interrupts are ignored, and its processes inherit that.
    """
    signal.signal(signal.SIGINT, signal.SIG_DFL)


def without_progress(printed: str) -> str:
    """Leave out the lines of progress of a diagnosis, which appear where it takes long, on a busy machine."""
    return re.sub(r"(?m)^pkmodes diagnose: .*\n", "", printed)
