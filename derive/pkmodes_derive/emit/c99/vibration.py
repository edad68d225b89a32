"""The modes of a robot in use, for controllers: frequencies, damping ratios and what they move, on a function."""

from __future__ import annotations

from sympy import Float

from pkmodes_derive.emit.c99.printer import expression
from pkmodes_derive.emit.templating import render
from pkmodes_derive.functions import HeldMotors

#: What a controller calls.
FUNCTIONS = ("vibration",)


def source(held: HeldMotors, name: str, arguments: str, argument_names: list[str]) -> str:
    """Return the function of a robot that has modes of vibration in use.

    Parameters
    ----------
    arguments : str
        Declared arguments of a function of the pose.
    argument_names : list of str
        Their names.
    """
    (function,) = held.functions
    outputs = function.outputs
    return render(
        __package__,
        "vibration.c.j2",
        name=name,
        upper=name.upper(),
        n=len(held.coordinates),
        directions=next(output.shape[0] for output in outputs if output.name == "J_p"),
        dissipates=held.dissipates,
        ratio=expression(Float(held.ratio)),
        arguments=arguments,
        passed=", ".join(argument_names),
        declared=", ".join(o.name + "".join(f"[{n}]" for n in o.shape) for o in outputs),
        call=f"{name}_{function.name}({', '.join([*argument_names, *(o.name for o in outputs)])})",
    )
