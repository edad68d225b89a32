"""The map of a robot: plan, evaluation, dataset, file."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from hashlib import sha256
from math import prod
from os import PathLike
from typing import TYPE_CHECKING, Any, NoReturn

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.base.version import VERSION
from pkmodes.core.model import Model
from pkmodes.core.robot.usable import USABLE
from pkmodes.core.solve.backends import AUTO, checked_threads, choose_backend
from pkmodes.core.system.evaluation import evaluation
from pkmodes.core.system.motors import solved_system
from pkmodes.machine.dataset.attributes import import_xarray
from pkmodes.machine.dataset.robot_text import robot_file_text
from pkmodes.machine.maps.dataset import dataset_of
from pkmodes.machine.maps.evaluating import MapLayout, Task, code_hash, field_layouts, layout_of
from pkmodes.machine.maps.map_file import MapFile
from pkmodes.machine.maps.poses import MapPoses, PoseGrid, checked_poses
from pkmodes.machine.maps.running import run_tasks
from pkmodes.machine.maps.storage import (
    PARTIAL_SUFFIX,
    Store,
    checksum_errors_explained,
    disk_store,
    folder_lock,
    memory_store,
)
from pkmodes.machine.maps.tracking import Tracked, track
from pkmodes.machine.maps.variants import SAMPLE, Variants, variants_of
from pkmodes.machine.maps.workspace import grid_over_workspace, workspace_remedy

if TYPE_CHECKING:
    import xarray


Array = NDArray[Any]
#: Rows of a task: enough to make its start-up cost negligible, few enough for progress reports and memory.
TASK_ROWS = 16_384
Progress = Callable[[int, int], None]


@dataclass(frozen=True, eq=False)
class MapPlan:
    """The poses, robots and fields of a map, divided into tasks."""

    model: Model
    map_poses: MapPoses
    variants: Variants
    layout: MapLayout

    @property
    def pose_count(self) -> int:
        """Number of poses of each robot."""
        return prod(self.map_poses.shape)

    @property
    def rows(self) -> int:
        """Number of poses of all robots."""
        return len(self.variants.robots) * self.pose_count

    @property
    def task_count(self) -> int:
        """Number of tasks."""
        return -(-self.rows // TASK_ROWS)

    def rows_of(self, number: int) -> slice:
        """Return the rows of a task."""
        return slice(number * TASK_ROWS, min((number + 1) * TASK_ROWS, self.rows))

    def task(self, number: int) -> Task:
        """Return a task."""
        rows, size, pieces = self.rows_of(number), self.pose_count, []
        for robot in range(rows.start // size, -(-rows.stop // size)):
            first, last = max(rows.start - robot * size, 0), min(rows.stop - robot * size, size)
            pieces.append((self.variants.robots[robot], self.map_poses.points(np.arange(first, last))))
        mechanism = self.model.mechanism
        common = code_hash(mechanism), self.model.max_condition, self.normal, self.layout
        return Task(tuple(pieces), *common, usable_only=self.usable_only)

    @property
    def usable_only(self) -> bool:
        """Whether poses beyond the usable limits of a robot are left out."""
        return isinstance(self.map_poses, PoseGrid) and self.map_poses.usable_only

    @property
    def normal(self) -> str | None:
        """Direction perpendicular to the plane of the grid."""
        return self.map_poses.normal(self.model.mechanism.directions)

    @property
    def fingerprint(self) -> dict[str, Any]:
        """What determines the result, as JSON data: an interrupted map is continued only if it is the same."""
        map_poses = self.map_poses
        table = (
            {name: v.tolist() for name, v in map_poses.axes.items()}
            if isinstance(map_poses, PoseGrid)
            else None
        )
        return {
            "version": VERSION,
            "mechanism": code_hash(self.model.mechanism),
            "robot": robot_file_text(self.model.robot),
            "largest condition number": self.model.max_condition,
            "grid": table,
            "poses": None
            if isinstance(map_poses, PoseGrid)
            else sha256(map_poses.table.tobytes()).hexdigest(),
            # Lists keep the order, on which that of the rows depends.
            "sweep": [[path, values.tolist()] for path, values in self.variants.swept.items()],
            "samples": [[path, values.tolist()] for path, values in self.variants.drawn.items()],
            "shapes": self.layout.shapes,
            "back end": self.layout.backend,
            "drives": self.layout.drives,
            "rows of a task": TASK_ROWS,
            **({"used": True} if self.usable_only else {}),
        }


def map_of(
    model: Model,
    grid: Any = None,
    *,
    sweep: Mapping[str, Any] | None = None,
    samples: int | None = None,
    seed: int = 0,
    shapes: bool = False,
    tracked: bool = False,
    out: str | PathLike[str] | None = None,
    overwrite: bool = False,
    scheduler: str | None = None,
    threads: int | None = None,
    backend: str = AUTO,
    drives: str | None = None,
    progress: Progress | None = None,
) -> xarray.Dataset:
    """Compute the modes over the workspace, and over ranges of parameters.

    Parameters
    ----------
    model : Model
        The evaluator of the robot.
    grid : mapping of str to array_like, or array_like of shape (N, d), optional
        Ascending values, or one number, for each component of the pose, in SI units; or poses one after the
        other.  By default a grid over the reachable workspace, within the usable limits of the robot.
    sweep : mapping of str to array_like, optional
        Values of parameters in SI units, by path; all combinations are evaluated.
    samples : int, optional
        Number of robots whose values with a standard deviation are drawn from normal distributions.
    seed : int
        Seed of the draws.
    shapes : bool
        Whether to keep mode shapes.
    tracked : bool
        Whether to number modes by their shapes instead of by rank, from the middle of the map outwards.
    out : path-like, optional
        File to write: ``.nc`` (NetCDF-4), ``.zarr``, or a table in ``.csv`` or ``.parquet``.  The map is computed
        in a folder next to it, ``<out>.partial``: after an interruption the same call continues there.
    overwrite : bool
        Whether an existing file may be replaced.
    scheduler : str, optional
        Address of a Dask scheduler whose workers evaluate the map.
    threads : int, optional
        Without a scheduler, by default one per core.
    backend : {"auto", "numpy", "compiled"}
        As for `modes`.
    drives : {"free", "held"}, optional
        As for `modes`.
    progress : callable, optional
        Called with the number of poses done and their total.

    Returns
    -------
    xarray.Dataset
        Described in docs/reference/map-dataset.md.  Where `out` is NetCDF or Zarr, its values are read from the file
        when they are needed.

    Raises
    ------
    PkmodesError
        If an argument is invalid, no pose can be evaluated, or the workers of a scheduler cannot finish.
    OutputError
        If the file exists or cannot be written, or an interrupted map there is another one or damaged.
    MissingExtraError
        If the libraries of the extra ``map`` are not installed.

    Examples
    --------
    >>> import numpy as np, pkmodes
    >>> model = pkmodes.load("robots/linear-delta-2022.toml")
    >>> dataset = model.map({"x": np.linspace(0.3, 0.8, 6), "y": 0.0, "z": -0.245})
    >>> dataset.frequency.sel(mode=1).squeeze().round(2).values
    array([46.34, 49.55, 54.23, 55.56, 50.33, 46.8 ])
    """
    import_xarray()
    file = None if out is None else MapFile.checked(out, overwrite)
    thread_count = checked_threads(threads)
    variants = variants_of(model.robot, sweep, samples, seed)
    poses = grid_over_workspace(model) if grid is None else checked_poses(model.mechanism, grid)
    layout = layout_of(
        variants.robots, shapes or tracked, choose_backend(backend), model.robot.resolve_drives(drives)
    )
    plan = MapPlan(model, poses, variants, layout)
    if tracked:
        systems = map(evaluation, variants.robots)
        sizes_of_systems = {
            (system.coordinates, solved_system(system, layout.drives).rigid_modes) for system in systems
        }
        if len(sizes_of_systems) > 1:
            problem = "modes cannot be tracked across robots with different coordinates"
            remedy = "sweep an effect from a value above zero, or leave out tracked"
            raise PkmodesError(problem, "tracked", remedy)
    sizes = field_layouts(model.robot, layout)

    def compute(store: Store) -> xarray.Dataset:
        _evaluate_missing_tasks(plan, store, thread_count, scheduler, progress)
        if not (store.codes() == 0).any():
            store.remove_files()
            _refuse_outside(plan)
        tracked_modes = track_plan(plan, store.arrays) if tracked else None
        saved_layout = layout if shapes else layout.without_shapes()
        return dataset_of(model.robot, poses, variants, saved_layout, store.arrays, tracked_modes)

    if file is None:
        try:
            store = memory_store(plan.rows, plan.task_count, sizes)
        except (MemoryError, ValueError):  # ValueError: more than an array can have
            problem = f"a map of {plan.rows:,} poses does not fit in memory"
            remedy = "write it to a file with out (--out), or make the grid coarser"
            raise PkmodesError(problem, "map", remedy) from None
        return compute(store)
    folder = file.path.with_name(file.path.name + PARTIAL_SUFFIX)
    with folder_lock(folder):
        store = disk_store(folder, plan.fingerprint, plan.rows, TASK_ROWS, sizes)
        with checksum_errors_explained(folder):
            dataset = compute(store)
            file.write(dataset, folder)
            table_dataset: xarray.Dataset | None = dataset.load() if file.is_table else None
        store.remove_files()
    return file.open_dataset() if table_dataset is None else table_dataset


def _evaluate_missing_tasks(
    plan: MapPlan, store: Store, threads: int, scheduler: str | None, progress: Progress | None
) -> None:
    """Evaluate and store the tasks that no earlier run has completed."""
    done_rows = sum(plan.rows_of(i).stop - plan.rows_of(i).start for i in np.flatnonzero(store.done).tolist())

    def tasks() -> Iterator[tuple[int, Task]]:
        for number in np.flatnonzero(~store.done).tolist():
            yield number, plan.task(number)

    def store_values(number: int, values: Mapping[str, Array]) -> None:
        store.write_rows(plan.rows_of(number), values)

    def finish(number: int) -> None:
        nonlocal done_rows
        done_rows += plan.rows_of(number).stop - plan.rows_of(number).start
        if progress is not None:
            progress(done_rows, plan.rows)

    if progress is not None:
        progress(done_rows, plan.rows)
    if not store.done.all():
        run_tasks(tasks(), store_values, finish, threads, scheduler)


def _refuse_outside(plan: MapPlan) -> NoReturn:
    """Refuse a map without a single pose that can be evaluated."""
    model, size = Model(plan.variants.robots[0], plan.model.max_condition), plan.pose_count
    sample = plan.map_poses.points(np.unique(np.linspace(0, size - 1, min(size, 1000)).astype(int)))
    sentence = str(model.check(sample).sentences[0]).partition(";")[0] if len(sample) else ""
    sentence = sentence or model.reasons[USABLE]  # it can be reached
    by_robots = " by any of its robots" if len(plan.variants.robots) > 1 else ""
    problem = f"none of the {plan.rows:,} poses of the map can be evaluated{by_robots}; the first: {sentence}"
    if isinstance(plan.map_poses, PoseGrid):
        where, remedy = "grid", 'write them with their unit, such as "300 mm:800 mm:51"'
    else:
        name = next((component.name for component in model.mechanism.pose if component.unit == "m"), "x")
        where, remedy = (
            "poses",
            f"write the unit in the header of the file, such as {name} [mm], or give metres",
        )
    raise PkmodesError(problem, where, workspace_remedy(model, sample, remedy))


def track_plan(plan: MapPlan, arrays: Mapping[str, Any]) -> Tracked:
    """Track the modes of a map; samples are compared with the first one."""
    robots, size = plan.variants.robots, plan.pose_count

    def masses(rows: NDArray[np.intp]) -> Array:
        matrices: Array | None = None
        for robot in np.unique(rows // size):
            selected = rows // size == robot
            system = evaluation(robots[robot])
            M = system.free_part(system.all_coordinates(plan.map_poses.points(rows[selected] % size))[0])
            matrices = np.empty((len(rows), *M.shape[1:])) if matrices is None else matrices
            matrices[selected] = M
        assert matrices is not None
        return matrices

    dims = (*plan.variants.dims, *plan.map_poses.dims)
    shape = (*plan.variants.shape, *plan.map_poses.shape)
    return track(arrays, shape, tuple(name != SAMPLE for name in dims), masses)
