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
#: Maximum number of parameters varied at once, and of machines on a page.
MAX_PARAMETERS, MAX_MACHINES = 3, 600
#: Number of values of each parameter if no count is given, by the number of parameters.
DEFAULT_COUNTS = {1: 21, 2: 9, 3: 5}


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
    if not 1 <= len(values) <= MAX_PARAMETERS:
        problem = f"expected 1 to {MAX_PARAMETERS} parameters that vary, found {len(values)}"
        raise PkmodesError(problem, "values", "vary the others on another page")
    drives = model.robot.resolve_drives(drives)
    pose_array = model.modes(pose, drives=drives).poses
    paths = [resolve(model.robot, path) for path in values]
    levels = tuple(
        np.unique(np.append(np.asarray(path_values, dtype=float).ravel(), path.value))
        for path, path_values in zip(paths, values.values(), strict=True)
    )
    count = int(np.prod([len(level) for level in levels]))
    if count > MAX_MACHINES:
        sizes = " x ".join(str(len(level)) for level in levels)
        problem = (
            f"expected at most {MAX_MACHINES} combinations of values, found {count} "
            f"({sizes}, declared values included)"
        )
        raise PkmodesError(problem, "values", "give smaller counts: the page interpolates between the values")

    def machine_with(combination: tuple[float, ...]) -> Model:
        changes = {
            path.path: value
            for path, value in zip(paths, combination, strict=True)
            if value != path.value  # a declared value stays exactly as it is
        }
        return model.with_values(changes) if changes else model

    for axis, level in enumerate(levels):  # each value on its own first, so that an error names it alone
        for end in (level[0], level[-1]):
            machine_with(tuple(end if k == axis else path.value for k, path in enumerate(paths)))
    combinations = list(product(*(level.tolist() for level in levels)))
    machines = [machine_with(combination) for combination in combinations]
    is_reachable = np.array([bool(variant.check(pose_array).valid) for variant in machines])
    shape = tuple(len(level) for level in levels)
    for axis, path in enumerate(paths):
        has_reachable = np.moveaxis(is_reachable.reshape(shape), axis, 0).reshape(shape[axis], -1).any(axis=1)
        if np.count_nonzero(has_reachable) == 1 < shape[axis]:
            problem = f"the pose is out of reach with every value of {path.path} but the declared one"
            raise PkmodesError(problem, "values", "give values nearer to it, or another pose")
    places = np.where(is_reachable, np.cumsum(is_reachable) - 1, -1).reshape(shape)
    declared = int(
        places[tuple(int(np.flatnonzero(v == p.value)[0]) for p, v in zip(paths, levels, strict=True))]
    )
    reachable_machines = [variant for variant, valid in zip(machines, is_reachable, strict=True) if valid]
    machine_scene = scene_of(
        reachable_machines, np.tile(pose_array, (len(reachable_machines), 1)), declared, drives=drives
    )
    order = paired_modes(
        machine_scene.shapes,
        _masses(machine_scene, reachable_machines, pose_array),
        places,
        machine_scene.rigid_modes,
    )
    rigid, modes = machine_scene.rigid_modes, machine_scene.frequencies.shape[1]

    def exact_frequencies(value_rows: Array) -> Array:
        variants = [machine_with(tuple(row)) for row in value_rows.tolist()]
        frequency_rows = [
            np.asarray(m.frequencies(pose_array, on_error="nan", drives=drives)) for m in variants
        ]
        return np.array([frequencies[rigid:modes] for frequencies in frequency_rows])

    vibrations = machine_scene.frequencies[:, rigid:]
    return replace(
        machine_scene,
        robot=model.robot.name,
        varied=tuple(Named(path.path, path.unit, path.path) for path in paths),
        values=np.array(combinations)[is_reachable],
        levels=levels,
        places=places,
        declared=declared,
        order=order,
        deviations=interpolation_errors(
            vibrations, order[:, rigid:] - rigid, places, levels, exact_frequencies
        ),
        checked="half-way between them",
    )


def _masses(scene: Scene, machines: list[Model], pose: Array) -> Array:
    """Return the mass matrices in the coordinates of the scene, zero at those that a machine locks."""
    size = len(scene.coordinates)
    masses = np.zeros((len(machines), size, size))
    for k, model in enumerate(machines):
        columns = [scene.coordinates.index(name) for name in model.coordinates]
        masses[k][np.ix_(columns, columns)] = model.matrices(pose)[0]
    return masses
