"""Checks of a user's structure: parameters, candidates and their names, and the map to the measured channels."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from pkmodes.core.base.errors import PkmodesError, checked_list, shown
from pkmodes.loop.diagnosis.problem import Array, Candidate, Parameter

#: What to do about a map that is not a matrix of the right form.
REMEDY = "give each channel a row and each coordinate of the model a column"


def check_names(kind: str, names: Sequence[str]) -> None:
    """Refuse repeated names."""
    for name in names:
        if names.count(name) > 1:
            raise PkmodesError(f"two {kind}s are called {shown(name)}", f"{kind}s", "rename one")


def check_callables(matrices: object, derivatives: object) -> None:
    """Refuse an argument that is not callable."""
    for name, function in (("matrices", matrices), ("derivatives", derivatives)):
        if not callable(function) and not (name == "derivatives" and function is None):
            problem = f"expected a function, found {shown(function)}"
            raise PkmodesError(
                problem, name, "give a function of the values by name and the label of a setup"
            )


def check_parameter(p: Parameter) -> None:
    """Refuse a parameter with an invalid name, value, bound or standard deviation."""
    location = f"parameter {shown(p.name)}"
    if not isinstance(p.name, str):
        raise PkmodesError(f"expected a name, found {shown(p.name)}", "parameters", "give text")
    for number in (p.lower, p.value, p.upper, *([] if p.sigma is None else [p.sigma])):
        is_integer = isinstance(number, np.integer) or (type(number) is int and number.bit_length() < 1000)
        if not (is_integer or isinstance(number, float | np.floating)):
            raise PkmodesError(f"expected a number, found {shown(number)}", location, "give a number")
    if not p.lower < p.upper or not p.lower <= p.value <= p.upper or not np.isfinite(p.value):
        problem = f"expected lower <= value <= upper, found {p.lower:g}, {p.value:g}, {p.upper:g}"
        raise PkmodesError(problem, location, "widen the bounds or correct the value")
    if p.sigma is not None and not 0.0 <= p.sigma < np.inf:
        problem = f"expected a standard deviation of at least 0, found {p.sigma:g}"
        raise PkmodesError(problem, location, "leave it out if unknown")


def check_candidate(candidate: Candidate, parameters: Mapping[str, Parameter]) -> None:
    """Refuse a candidate whose parameters are missing, repeated, or have a sigma."""
    location = f"candidate {shown(candidate.name)}"
    if not isinstance(candidate.name, str):
        raise PkmodesError(f"expected a name, found {shown(candidate.name)}", "candidates", "give text")
    names = checked_list(candidate.parameters, "names of parameters", location, '"k"', str)
    if not names or len(set(names)) < len(names):
        raise PkmodesError(f"expected different parameters, found {list(names)}", location, "name each once")
    for name in names:
        if name not in parameters:
            problem = f"its parameter {shown(name)} does not exist"
            raise PkmodesError(problem, location, f"parameters are: {', '.join(parameters)}")
        sigma = parameters[name].sigma
        if sigma is not None:
            state = "refitted under every hypothesis" if sigma else "known exactly"
            problem = f"its parameter {shown(name)} has a sigma: it is {state}"
            raise PkmodesError(problem, location, "leave out the candidate, or the sigma")


def sensor_map(channels: Sequence[str], coordinates: Sequence[str] | None, sensors: Any) -> Array | None:
    """Return the matrix that maps the coordinates of a model to the channels.

    - coordinates: names of the n coordinates, if the channels are some of them
    - sensors: motion of each channel for unit motions of the coordinates, (C, n)

    Returns (C, n); None if the channels are all coordinates in order.
    Raises PkmodesError if both are given, a channel is not a coordinate, or the map is not a matrix of numbers.
    """
    if sensors is None:
        if coordinates is None or tuple(coordinates) == tuple(channels):
            return None
        for name in channels:
            if name not in coordinates:
                listed_names = ", ".join(coordinates[:20]) + (", ..." if len(coordinates) > 20 else "")
                problem = f"the channel {shown(name)} is not one of the {len(coordinates)} coordinates"
                raise PkmodesError(
                    problem, "channels", f"coordinates are: {listed_names}; for other places, use sensors="
                )
        index_of = {name: i for i, name in enumerate(coordinates)}
        columns = [index_of[name] for name in channels]
        return np.eye(len(coordinates))[columns]
    if coordinates is not None:
        problem = "expected sensors or coordinates, found both"
        raise PkmodesError(problem, "sensors", "leave out one of them")
    try:
        matrix = sensors.toarray() if hasattr(sensors, "toarray") else np.asarray(sensors)
    except (TypeError, ValueError) as error:
        raise PkmodesError(f"expected a matrix, found {shown(str(error))}", "sensors", REMEDY) from error
    if matrix.ndim != 2 or matrix.shape[0] != len(channels):
        problem = f"expected one row for each channel ({len(channels)}), found the shape {matrix.shape}"
        raise PkmodesError(problem, "sensors", REMEDY)
    if matrix.dtype.kind not in "biuf" or not np.isfinite(matrix).all():
        raise PkmodesError("expected finite real numbers", "sensors", REMEDY)
    mapping: Array = matrix.astype(float)
    empty = np.flatnonzero(~mapping.any(axis=1))
    if empty.size:
        problem = f"the channel {shown(channels[empty[0]])} measures nothing: its row is zero"
        raise PkmodesError(problem, "sensors", "remove it or correct its row")
    return mapping
