"""An interrupt while the command is starting ends it with one line and exit code 130, without a traceback."""

from __future__ import annotations

import os
import signal
import sys

INTERRUPTED = 130
#: Names of the program while the command starts: ``-m`` until Python has found the package to run, and that of the
#: installed script.
PROGRAM_NAMES = ("-m", "pkmodes")


def exit_on_early_interrupt() -> None:
    """Let an interrupt end the process with a message if it is a command that has only begun to load its modules."""
    program = sys.argv[0] if sys.argv else ""
    # In a worker process `sys.argv` has the arguments of its parent, but not `sys.orig_argv`.
    is_command = program in sys.orig_argv and os.path.basename(program) in PROGRAM_NAMES  # noqa: PTH119 - loads nothing more
    if is_command and interrupts_this_process():
        signal.signal(signal.SIGINT, exit_interrupted)


def interrupts_this_process() -> bool:
    """Return whether an interrupt reaches this process: a background job of a shell ignores it."""
    return signal.getsignal(signal.SIGINT) in (signal.default_int_handler, exit_interrupted)


def exit_interrupted(*_: object) -> None:
    """End the process at once: there is nothing to clean up yet."""
    try:
        newline = b"\n" if os.isatty(2) else b""  # after the terminal's ^C
        os.write(2, newline + b"error: interrupted (pkmodes); run it again\n")
    finally:
        os._exit(INTERRUPTED)
