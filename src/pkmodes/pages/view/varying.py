"""The robot with other values at one pose: a grid of machines for sliders, with the declared one among them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from itertools import product

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.model import Model
from pkmodes.loop.sensitivity.paths import resolve
from pkmodes.pages.view.evaluating import scene_of
from pkmodes.pages.view.interpolation import interpolation_errors
from pkmodes.pages.view.pairing import paired_modes
from pkmodes.pages.view.scene import Scene
from pkmodes_description import Named

Array = NDArray[np.float64]
#: Most parameters varied at once, and most machines on a page.
PARAMETERS, MACHINES = 3, 600
#: Values of each parameter if no count is given, by the number of parameters.
COUNTS = {1: 21, 2: 9, 3: 5}


def varied(
    model: Model, pose: ArrayLike, values: Mapping[str, ArrayLike], *, drives: str | None = None
) -> Scene:
    """Return the scene of a page whose sliders change values of the robot at a pose.

    Parameters
    ----------
    model : Model
        The robot as declared.
    pose : array_like, shape (d,)
        In SI units.
    values : mapping of str to array_like
        Ascending values in SI units of up to three parameters or effect parameters, by path; all combinations are
        computed, and the declared value is added where it is not among them.
    drives : {"free", "held"}, optional
        As for `pkmodes.Model.modes`.

    Returns
    -------
    Scene
        With `varied`, `levels`, `places` and `declared`.

    Raises
    ------
    PkmodesError
        If a path is unknown, a robot file with such a value would be rejected, the pose is out of reach with all
        of its values, or there are too many.
    PoseError
        If the declared robot cannot be at the pose.
    """
    if not 1 <= len(values) <= PARAMETERS:
        problem = f"expected 1 to {PARAMETERS} parameters that vary, found {len(values)}"
        raise PkmodesError(problem, "values", "vary the others on another page")
    drives = model.robot.resolve_drives(drives)
    point = model.modes(pose, drives=drives).poses
    paths = [resolve(model.robot, path) for path in values]
    levels = tuple(
        np.unique(np.append(np.asarray(stated, dtype=float).ravel(), path.value))
        for path, stated in zip(paths, values.values(), strict=True)
    )
    count = int(np.prod([len(level) for level in levels]))
    if count > MACHINES:
        sizes = " x ".join(str(len(level)) for level in levels)
        problem = (
            f"expected at most {MACHINES} combinations of values, found {count} "
            f"({sizes}, declared values included)"
        )
        raise PkmodesError(problem, "values", "give smaller counts: the page interpolates between the values")

    def machine(combination: tuple[float, ...]) -> Model:
        changes = {
            path.path: value
            for path, value in zip(paths, combination, strict=True)
            if value != path.value  # a declared value stays exactly as it is
        }
        return model.with_values(changes) if changes else model

    for axis, level in enumerate(levels):  # an error of one value names it alone
        for end in (level[0], level[-1]):
            machine(tuple(end if k == axis else path.value for k, path in enumerate(paths)))
    combinations = list(product(*(level.tolist() for level in levels)))
    machines = [machine(combination) for combination in combinations]
    there = np.array([bool(variant.check(point).valid) for variant in machines])
    shape = tuple(len(level) for level in levels)
    for axis, path in enumerate(paths):
        reached = np.moveaxis(there.reshape(shape), axis, 0).reshape(shape[axis], -1).any(axis=1)
        if np.count_nonzero(reached) == 1 < shape[axis]:
            problem = f"the pose is out of reach with every value of {path.path} but the declared one"
            raise PkmodesError(problem, "values", "give values nearer to it, or another pose")
    places = np.where(there, np.cumsum(there) - 1, -1).reshape(shape)
    declared = int(
        places[tuple(int(np.flatnonzero(v == p.value)[0]) for p, v in zip(paths, levels, strict=True))]
    )
    kept = [variant for variant, valid in zip(machines, there, strict=True) if valid]
    shown = scene_of(kept, np.tile(point, (len(kept), 1)), declared, drives=drives)
    order = paired_modes(shown.shapes, _masses(shown, kept, point), places, shown.rigid_modes)
    rigid, modes = shown.rigid_modes, shown.frequencies.shape[1]

    def exact(middles: Array) -> Array:
        variants = [machine(tuple(row)) for row in middles.tolist()]
        spectra = [np.asarray(m.frequencies(point, on_error="nan", drives=drives)) for m in variants]
        return np.array([spectrum[rigid:modes] for spectrum in spectra])

    vibrations = shown.frequencies[:, rigid:]
    return replace(
        shown,
        robot=model.robot.name,
        varied=tuple(Named(path.path, path.unit, path.path) for path in paths),
        values=np.array(combinations)[there],
        levels=levels,
        places=places,
        declared=declared,
        order=order,
        deviations=interpolation_errors(vibrations, order[:, rigid:] - rigid, places, levels, exact),
        checked="half-way between them",
    )


def _masses(shown: Scene, machines: list[Model], point: Array) -> Array:
    """Return the mass matrices in the coordinates of the scene, zero at those that a machine locks."""
    size = len(shown.coordinates)
    masses = np.zeros((len(machines), size, size))
    for k, model in enumerate(machines):
        columns = [shown.coordinates.index(name) for name in model.coordinates]
        masses[k][np.ix_(columns, columns)] = model.matrices(point)[0]
    return masses
