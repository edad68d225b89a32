"""`pkmodes.Model`: the core's model, to which the applications are attached as methods.

An application is a function whose first argument is a model of the core.  It is loaded when its method is first used:
asking for modes does not load maps.
"""

from __future__ import annotations

from os import PathLike
from typing import TYPE_CHECKING

from pkmodes.core import model
from pkmodes.core.base.attached import Attached
from pkmodes.core.robot.reading import read_robot

if TYPE_CHECKING:
    from pkmodes.loop.sensitivity.sensitivities import sensitivities_at
    from pkmodes.loop.sensitivity.spread import frequency_sigmas
    from pkmodes.machine.maps.mapping import map_of
    from pkmodes.machine.response.compliance import compliance
    from pkmodes.machine.response.frequency_response import frequency_response
    from pkmodes.machine.response.moves import simulate
    from pkmodes.machine.response.poles import poles_at
    from pkmodes.machine.response.state_space import state_space
    from pkmodes.machine.shaping.at_poses import shaper_at
    from pkmodes.machine.shaping.comparison import shapers_over

__all__ = ["Model", "load", "read_robot"]

#: Methods that are applications, and the path of the function of each.  `Model` declares the same for type checkers.
APPLICATIONS = {
    "sensitivities": "pkmodes.loop.sensitivity.sensitivities:sensitivities_at",
    "frequency_sigmas": "pkmodes.loop.sensitivity.spread:frequency_sigmas",
    "poles": "pkmodes.machine.response.poles:poles_at",
    "frf": "pkmodes.machine.response.frequency_response:frequency_response",
    "state_space": "pkmodes.machine.response.state_space:state_space",
    "compliance": "pkmodes.machine.response.compliance:compliance",
    "simulate": "pkmodes.machine.response.moves:simulate",
    "shaper": "pkmodes.machine.shaping.at_poses:shaper_at",
    "shapers": "pkmodes.machine.shaping.comparison:shapers_over",
    "map": "pkmodes.machine.maps.mapping:map_of",
}


class Model(model.Model):  # noqa: D101  # the docstring is inherited
    __doc__ = model.Model.__doc__

    if TYPE_CHECKING:
        sensitivities = sensitivities_at
        frequency_sigmas = frequency_sigmas
        poles = poles_at
        frf = frequency_response
        state_space = state_space
        compliance = compliance
        simulate = simulate
        shaper = shaper_at
        shapers = shapers_over
        map = map_of


for _name, _function_path in APPLICATIONS.items():
    setattr(Model, _name, Attached(_function_path))


def load(path: str | PathLike[str]) -> Model:
    """Read a robot file and return its evaluator.

    Parameters
    ----------
    path : path-like
        A robot file (docs/reference/robot-file.md).

    Returns
    -------
    Model
        The evaluator; ``Model.robot`` has the declared values.

    Raises
    ------
    RobotFileError
        If the file cannot be read or is invalid.

    Examples
    --------
    >>> model = load("robots/linear-delta-2022.toml")
    >>> model.modes([0.6, 0.0, -0.245]).frequencies.round(3)[3:]
    array([ 55.559,  60.316,  61.545, 130.801, 133.831, 134.257])
    """
    return Model(read_robot(path))
