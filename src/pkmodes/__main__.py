"""Entry point of the command line: ``pkmodes`` and ``python -m pkmodes``.

Loading NumPy and the other dependencies takes a moment, and an interrupt during it must not print a traceback: until
everything is loaded there is nothing to clean up, so the process just ends.
"""

from __future__ import annotations

import os
import signal
import sys

INTERRUPTED = 130


def main() -> None:
    """Run the command line and exit; a user's mistake is one line on stderr, never a traceback."""
    ours = (
        signal.getsignal(signal.SIGINT) is signal.default_int_handler
    )  # a shell's background job ignores it
    if ours:
        signal.signal(signal.SIGINT, _leave)
    from pkmodes.cli import run

    if ours:
        signal.signal(signal.SIGINT, signal.default_int_handler)
    code = run()
    if ours:  # the work is done: only the interpreter's shutdown remains
        signal.signal(signal.SIGINT, _leave)
    if code == INTERRUPTED:
        # If the interrupt came while a library was compiling code, Python would end with the signal instead.
        os._exit(code)
    sys.exit(code)


def _leave(*_: object) -> None:
    try:
        newline = b"\n" if os.isatty(2) else b""  # after the terminal's ^C
        os.write(2, newline + b"error: interrupted (pkmodes); run it again\n")
    finally:
        os._exit(INTERRUPTED)


if __name__ == "__main__":
    main()
