"""The map of a robot: plan, evaluation, dataset, file."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import ExitStack
from dataclasses import dataclass
from math import prod
from os import PathLike
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

import pkmodes
from pkmodes.backends import checked_threads, chosen
from pkmodes.errors import PkmodesError
from pkmodes.evaluation import evaluation
from pkmodes.maps.dataset import dataset_of, imported
from pkmodes.maps.evaluating import Layout, Task, layout_of, tails
from pkmodes.maps.files import Target
from pkmodes.maps.places import Grid, Places, places_of
from pkmodes.maps.running import run
from pkmodes.maps.storage import SUFFIX, InMemory, OnDisk, locked
from pkmodes.maps.tracking import Tracked, track
from pkmodes.maps.variants import SAMPLE, Variants, variants_of
from pkmodes.maps.workspace import bounds_of, reachable
from pkmodes.robot.text import text_of

if TYPE_CHECKING:
    import xarray

    from pkmodes.model import Model

Array = NDArray[Any]
#: Rows of a task: large enough that starting it costs nothing, small enough for progress and memory.
ROWS = 16_384
Progress = Callable[[int, int], None]


@dataclass(frozen=True, eq=False)
class Plan:
    """What a map computes.

    Attributes
    ----------
    model : Model
    places : Grid or Poses
    variants : Variants
    layout : Layout
    """

    model: Model
    places: Places
    variants: Variants
    layout: Layout

    @property
    def poses(self) -> int:
        """Number of poses of each robot."""
        return prod(self.places.shape)

    @property
    def rows(self) -> int:
        """Number of poses of all robots."""
        return len(self.variants.robots) * self.poses

    @property
    def number(self) -> int:
        """Number of tasks."""
        return -(-self.rows // ROWS)

    def rows_of(self, number: int) -> slice:
        """Return the rows of a task."""
        return slice(number * ROWS, min((number + 1) * ROWS, self.rows))

    def task(self, number: int) -> Task:
        """Return a task."""
        rows, size, pieces = self.rows_of(number), self.poses, []
        for robot in range(rows.start // size, -(-rows.stop // size)):
            first, last = max(rows.start - robot * size, 0), min(rows.stop - robot * size, size)
            pieces.append((self.variants.robots[robot], self.model.max_condition, first, last))
        return Task(tuple(pieces), self.places, self.layout)

    @property
    def record(self) -> dict[str, Any]:
        """What determines the result, as JSON can hold it: an interrupted map is continued only with the same."""
        places = self.places
        table = {name: v.tolist() for name, v in places.axes.items()} if isinstance(places, Grid) else None
        return {
            "version": pkmodes.__version__,
            "robot": text_of(self.model.robot),
            "largest condition number": self.model.max_condition,
            "grid": table,
            "poses": None if isinstance(places, Grid) else places.table.tolist(),
            "sweep": {path: values.tolist() for path, values in self.variants.swept.items()},
            "samples": {path: values.tolist() for path, values in self.variants.drawn.items()},
            "shapes": self.layout.shapes,
            "back end": self.layout.backend,
            "rows of a task": ROWS,
        }


def map_of(
    model: Model,
    grid: Any,
    *,
    sweep: Mapping[str, Any] | None,
    samples: int | None,
    seed: int,
    shapes: bool,
    tracked: bool,
    out: str | PathLike[str] | None,
    overwrite: bool,
    scheduler: str | None,
    threads: int | None,
    backend: str,
    progress: Progress | None,
) -> xarray.Dataset:
    """Compute a map; see `pkmodes.Model.map`."""
    imported()
    target = None if out is None else Target.checked(out, overwrite)
    number = checked_threads(threads)
    variants = variants_of(model.robot, sweep, samples, seed)
    places = reachable(model) if grid is None else places_of(model.kind, grid)
    layout = layout_of(variants.robots, shapes or tracked, chosen(backend))
    plan = Plan(model, places, variants, layout)
    if tracked:
        _check_trackable(plan)
    sizes = tails(model.robot, layout)
    with ExitStack() as stack:
        if target is None:
            store: InMemory | OnDisk = InMemory(plan.rows, plan.number, sizes)
        else:
            folder = target.path.with_name(target.path.name + SUFFIX)
            stack.enter_context(locked(folder))
            store = OnDisk(folder, plan.record, plan.rows, plan.number, sizes)
        _fill(plan, store, number, scheduler, progress)
        if isinstance(store, OnDisk) and not (store.arrays["code"] == 0).any():
            store.remove()
        _check_inside(plan, store.arrays["code"] if store.arrays else None)
        found = track_plan(plan, store.arrays) if tracked else None
        dataset = dataset_of(model.robot, places, variants, layout, store.arrays, found)
        if target is None:
            return dataset
        target.write(dataset)
        kept: xarray.Dataset | None = dataset.load() if target.is_table else None
        del dataset
        if isinstance(store, OnDisk):
            store.remove()
        return target.opened() if kept is None else kept


def _fill(
    plan: Plan, store: InMemory | OnDisk, threads: int, scheduler: str | None, progress: Progress | None
) -> None:
    """Compute the tasks that are not done."""
    done = int(sum(plan.rows_of(i).stop - plan.rows_of(i).start for i in np.flatnonzero(store.done).tolist()))

    def tasks() -> Iterator[tuple[int, Task]]:
        for number in np.flatnonzero(~store.done).tolist():
            yield number, plan.task(number)

    def put(number: int, values: Mapping[str, Array]) -> None:
        nonlocal done
        rows = plan.rows_of(number)
        for name, array in store.arrays.items():
            array[rows] = values[name]
        store.done[number] = True
        done += rows.stop - rows.start
        if progress is not None:
            progress(done, plan.rows)

    if progress is not None:
        progress(done, plan.rows)
    if not store.done.all():
        run(tasks(), put, threads, scheduler)


def _check_inside(plan: Plan, codes: Array | None) -> None:
    """Refuse a map without a single pose that can be evaluated."""
    if codes is not None and (codes == 0).any():
        return
    model, size = plan.model, plan.poses
    some = plan.places.points(np.unique(np.linspace(0, size - 1, min(size, 1000)).astype(int)))
    sentence = str(model.check(some).sentences[0]).partition(";")[0] if len(some) else ""
    what = f"none of the {plan.rows:,} poses of the map can be evaluated; the first: {sentence}"
    raise PkmodesError(what, "grid" if isinstance(plan.places, Grid) else "poses", bounds_of(model, some))


def _check_trackable(plan: Plan) -> None:
    counts = {(found.coordinates, found.rigid_modes) for found in map(evaluation, plan.variants.robots)}
    if len(counts) > 1:
        what = "modes cannot be tracked across robots with different coordinates"
        raise PkmodesError(what, "tracked", "sweep an effect from a value above zero, or leave out tracked")


def track_plan(plan: Plan, arrays: Mapping[str, Array]) -> Tracked:
    """Track the modes of a map; samples are compared with the first one."""
    robots, size = plan.variants.robots, plan.poses

    def masses(rows: NDArray[np.intp]) -> Array:
        found: Array | None = None
        for robot in np.unique(rows // size):
            mine = rows // size == robot
            at = evaluation(robots[robot])
            M = at.free_part(at.all_coordinates(plan.places.points(rows[mine] % size))[0])
            found = np.empty((len(rows), *M.shape[1:])) if found is None else found
            found[mine] = M
        assert found is not None
        return found

    dims = (*plan.variants.dims, *plan.places.dims)
    shape = (*plan.variants.shape, *plan.places.shape)
    return track(arrays, shape, tuple(name != SAMPLE for name in dims), masses)
