"""An interrupt while the command is starting: one line and exit code 130, no traceback."""

from __future__ import annotations

import os
import signal
import sys

INTERRUPTED = 130
#: Names of the program while the command starts: Python's own, until it has found the package that it has to run, and
#: that of the installed script.
STARTING = ("-m", "pkmodes")


def watch_the_start() -> None:
    """End the process on an interrupt, if it is one of the command that has only begun to load its modules."""
    program = sys.argv[0] if sys.argv else ""
    # A worker process has the arguments of the one that started it, but was not started with them.
    started = program in sys.orig_argv and os.path.basename(program) in STARTING  # noqa: PTH119 - loads nothing more
    if started and is_ours():
        signal.signal(signal.SIGINT, leave)


def is_ours() -> bool:
    """Return whether an interrupt is for this process: a shell's background job ignores it."""
    return signal.getsignal(signal.SIGINT) in (signal.default_int_handler, leave)


def leave(*_: object) -> None:
    """End the process at once: nothing has been begun that would have to be cleaned up."""
    try:
        newline = b"\n" if os.isatty(2) else b""  # after the terminal's ^C
        os.write(2, newline + b"error: interrupted (pkmodes); run it again\n")
    finally:
        os._exit(INTERRUPTED)
