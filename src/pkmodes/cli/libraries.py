"""What libraries would say on stderr themselves: nothing of it tells a user of a command what to do."""

from __future__ import annotations

import logging
import sys
import warnings


def quiet_libraries() -> None:
    """Keep warnings of NumPy and SciPy and messages of Matplotlib from the user.

    Whatever matters to a result is said by the command, with its place.  ``-W`` and ``PYTHONWARNINGS`` prevail.
    """
    if sys.warnoptions:
        return
    warnings.simplefilter("ignore")
    logging.getLogger("matplotlib").setLevel(logging.CRITICAL)  # its cache, fonts and the user's matplotlibrc
