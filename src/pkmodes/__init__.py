"""Vibration modes of parallel robots with compliant transmissions.

`load` reads a robot file and returns a `Model`, whose ``modes``, ``matrices`` and ``statics`` take one pose or
an array of poses.  docs/model.md defines the coordinates, signs and frames.
"""

from pkmodes.interrupts import exit_on_early_interrupt

exit_on_early_interrupt()  # before anything else is loaded

from lazy_loader import attach_stub  # noqa: E402

from pkmodes.core.base.version import VERSION  # noqa: E402
from pkmodes.names import install_room_finder  # noqa: E402

# A name is loaded when it is first used, from the module that __init__.pyi states: the command line has to start
# before NumPy is loaded, and modules that compare with measurements need SciPy, which takes even longer.
__version__ = VERSION
install_room_finder()
__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)
