"""Checks of a user's structure: parameters, candidates and their names."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from pkmodes.core.base.errors import PkmodesError, listed, shown
from pkmodes.diagnosis.problem import Candidate, Parameter


def check_names(kind: str, names: Sequence[str]) -> None:
    """Refuse repeated names."""
    for name in names:
        if names.count(name) > 1:
            raise PkmodesError(f"two {kind}s are called {shown(name)}", f"{kind}s", "rename one")


def check_callables(matrices: object, derivatives: object) -> None:
    """Refuse an argument that is not callable."""
    for name, given in (("matrices", matrices), ("derivatives", derivatives)):
        if not callable(given) and not (name == "derivatives" and given is None):
            what = f"expected a function, found {shown(given)}"
            raise PkmodesError(what, name, "give a function of the values by name and the label of a setup")


def check_parameter(p: Parameter) -> None:
    """Refuse a parameter with an invalid name, value, bound or standard deviation."""
    where = f"parameter {shown(p.name)}"
    if not isinstance(p.name, str):
        raise PkmodesError(f"expected a name, found {shown(p.name)}", "parameters", "give text")
    for number in (p.lower, p.value, p.upper, *([] if p.sigma is None else [p.sigma])):
        whole = isinstance(number, np.integer) or (type(number) is int and number.bit_length() < 1000)
        if not (whole or isinstance(number, float | np.floating)):
            raise PkmodesError(f"expected a number, found {shown(number)}", where, "give a number")
    if not p.lower < p.upper or not p.lower <= p.value <= p.upper or not np.isfinite(p.value):
        what = f"expected lower <= value <= upper, found {p.lower:g}, {p.value:g}, {p.upper:g}"
        raise PkmodesError(what, where, "widen the bounds or correct the value")
    if p.sigma is not None and not 0.0 <= p.sigma < np.inf:
        what = f"expected a standard deviation of at least 0, found {p.sigma:g}"
        raise PkmodesError(what, where, "leave it out if unknown")


def check_candidate(candidate: Candidate, parameters: Mapping[str, Parameter]) -> None:
    """Refuse a candidate whose parameters are missing, repeated, or have a sigma."""
    where = f"candidate {shown(candidate.name)}"
    if not isinstance(candidate.name, str):
        raise PkmodesError(f"expected a name, found {shown(candidate.name)}", "candidates", "give text")
    names = listed(candidate.parameters, "names of parameters", where, '"k"', str)
    if not names or len(set(names)) < len(names):
        raise PkmodesError(f"expected different parameters, found {list(names)}", where, "name each once")
    for name in names:
        if name not in parameters:
            what = f"its parameter {shown(name)} does not exist"
            raise PkmodesError(what, where, f"parameters are: {', '.join(parameters)}")
        sigma = parameters[name].sigma
        if sigma is not None:
            state = "refitted under every hypothesis" if sigma else "known exactly"
            what = f"its parameter {shown(name)} has a sigma: it is {state}"
            raise PkmodesError(what, where, "leave out the candidate, or the sigma")
