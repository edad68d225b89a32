"""Entry point of the command line: ``pkmodes`` and ``python -m pkmodes``.

Loading NumPy and the other dependencies takes a moment, and an interrupt during it must not print a traceback: until
everything is loaded there is nothing to clean up, so the process just ends.
"""

from __future__ import annotations

import os
import signal
import sys

from pkmodes.interrupts import INTERRUPTED, exit_interrupted, interrupts_this_process


def main() -> None:
    """Run the command line and exit; a user's mistake is one line on stderr, never a traceback."""
    ours = interrupts_this_process()
    if ours:
        signal.signal(signal.SIGINT, exit_interrupted)
    from pkmodes.cli import run
    from pkmodes.cli.libraries import quiet_libraries

    if ours:
        signal.signal(signal.SIGINT, signal.default_int_handler)
    quiet_libraries()
    code = run()
    if ours:  # the work is done: only the interpreter's shutdown remains
        signal.signal(signal.SIGINT, exit_interrupted)
    if code == INTERRUPTED:
        # If the interrupt came while a library was compiling code, Python would end with the signal instead.
        os._exit(code)
    sys.exit(code)


if __name__ == "__main__":
    main()
