"""Input shapers for controllers: the table of kinds that the runtime has, too, and commands that pass a shaper.

They are a part of each robot's source: so a controller has one header and one precision, and two robots do not clash
in one program.
"""

from __future__ import annotations

from sympy import Float, Symbol, pi

from pkmodes_derive.emit.c99.printer import expression
from pkmodes_derive.emit.templating import render
from pkmodes_description.shapers import SHAPERS

#: What a controller calls.
FUNCTIONS = ("shaper_design", "shaper_multiply", "shaped_rest", "shaped_command")


def declarations(name: str, components: int) -> str:
    """Return the part of the header, for poses of some components."""
    text: str = render(__package__, "shaper.h.j2", **_values(name, components))
    return text.rstrip("\n")


def source(name: str, components: int) -> str:
    """Return the functions, for poses of some components."""
    zeta, root, periods, f = (Symbol(symbol) for symbol in ("zeta", "root", "periods", "f"))
    return render(
        __package__,
        "shaper.c.j2",
        decay=f"{expression(-2 * pi * zeta / root)}*periods",
        delay=expression(periods / (f * root)),
        **_values(name, components),
    )


def _values(name: str, components: int) -> dict[str, object]:
    kinds = [
        {
            "name": kind,
            "macro": kind.upper(),
            "step": expression(Float(step)),
            "weights": [expression(Float(weight)) for weight in weights],
        }
        for kind, (step, weights) in SHAPERS.items()
    ]
    return {
        "name": name,
        "d": components,
        "upper": name.upper(),
        "kinds": kinds,
        "most": max(len(kind.weights) for kind in SHAPERS.values()),
    }
