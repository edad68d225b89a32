"""The functions of a robot's module that need more than its formulas: status, natural frequencies and modes."""

from __future__ import annotations

import json
from importlib.resources import files

from pkmodes_derive.emit.constants import NOT_FINITE, Constant, constants, pose
from pkmodes_derive.emit.provenance import Provenance
from pkmodes_derive.emit.templating import render
from pkmodes_derive.functions import Model, Output

#: Comparison and bound of a margin, by its rule.
RULES = {
    "at_least_zero": "np.greater_equal, 0.0",
    "above_zero": "np.greater, 0.0",
    "at_most_limit": "np.less_equal, MAX_CONDITION",
}
#: Constants of C only: lengths of arrays, in Python the names of their entries; and a status, here an exception.
C_ONLY = {"POSE", "COORDINATES", "RIGID_MODES", "HELD_MODES", "UNSOLVED"}
FUNCTIONS = ("status", "natural_frequencies", "modes")


def own_constants(model: Model, provenance: Provenance) -> list[Constant]:
    """Return the constants of the module besides those of any model."""
    return [constant for constant in constants(model, provenance) if constant.name not in C_ONLY]


def source(model: Model) -> str:
    """Return the functions, and those that they call."""
    by_name = {function.name: function for function in model.functions}
    argument = pose(model)
    meanings = ["", NOT_FINITE, *(margin.meaning for margin in model.conditions)]
    copied = files(__package__).joinpath("eigen.py").read_text(encoding="utf-8")
    return render(
        __package__,
        "modes.py.j2",
        helpers=copied.partition("import numpy as np\n")[2].strip("\n"),
        statuses=[json.dumps(text, ensure_ascii=False) for text in meanings],
        components=[symbol.name for symbol in argument.symbols],
        count=len(argument.symbols),
        unit=argument.unit,
        description=f"{argument.description[0].upper()}{argument.description[1:]}.",
        n=len(model.coordinates),
        vibration="0" if model.rigid_modes is None else "RIGID_MODES",
        margins=[
            f"({_call(margin.function, margin.output, by_name[margin.function].outputs)}, {RULES[margin.rule]}),"
            for margin in model.conditions
        ],
    )


def _call(function: str, number: int, outputs: tuple[Output, ...]) -> str:
    return f"{function}(p)" + (f"[{number}]" if len(outputs) > 1 else "")
