"""Messages of libraries on stderr, which are suppressed: none of them helps the user of a command."""

from __future__ import annotations

import logging
import sys
import warnings


def quiet_libraries() -> None:
    """Keep warnings of NumPy and SciPy and messages of Matplotlib from the user.

    The command itself reports what matters to a result.  ``-W`` and ``PYTHONWARNINGS`` take precedence.
    """
    if sys.warnoptions:
        return
    warnings.simplefilter("ignore")
    logging.getLogger("matplotlib").setLevel(logging.CRITICAL)  # its cache, fonts and the user's matplotlibrc
