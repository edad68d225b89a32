"""``pkmodes map``: the modes over the workspace, and over ranges of parameters, in a file."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from pkmodes.api import load
from pkmodes.cli.delivery import deliver
from pkmodes.cli.options import (
    FILE,
    drives_option,
    json_option,
    mechanism_option,
    named_as_options,
    report_option,
    robot_argument,
)
from pkmodes.cli.poses import grid_option, places_given, poses_option
from pkmodes.cli.progress import duration
from pkmodes.cli.reporting import report_file, sources_of
from pkmodes.cli.settings import settings_given, settings_option
from pkmodes.cli.targets import Target, check_targets, report_target
from pkmodes.core.support.progress import say

if TYPE_CHECKING:
    from xarray import Dataset

    from pkmodes.core.model import Model
    from pkmodes.pages.report.sources import Source


#: Arguments of `pkmodes.Model.map` that have the names of their options.
ARGUMENTS = ("out", "samples", "tracked", "seed", "threads", "grid", "poses")


@click.command(
    "map",
    epilog="\b\nExample:\n  pkmodes map robots/linear-delta-2022.toml \\\n"
    "    --grid x=0.3:0.8:51,y=-0.1:0.1:41,z=-0.245 --out map.nc",
)
@robot_argument
@grid_option
@poses_option
@settings_option(
    "Sweep a parameter, such as platform.mass=1:2:5 or platform.mass=1.5; repeat it for several, all of whose "
    "combinations are evaluated."
)
@click.option(
    "--samples",
    metavar="N",
    type=click.IntRange(1),
    help="Evaluate N robots whose values with a standard deviation are drawn from normal distributions, with the "
    "correlations of the robot file.",
)
@click.option(
    "--seed", metavar="N", type=click.IntRange(0), default=0, show_default=True, help="Of the draws."
)
@click.option("--shapes", is_flag=True, help="Keep mode shapes too.")
@click.option("--tracked", is_flag=True, help="Number modes by their shapes instead of by rank.")
@click.option(
    "--out",
    metavar="FILE",
    type=FILE,
    help="File to write: .nc (NetCDF), .zarr, or a table in .csv or .parquet.  After an interruption the same "
    "command continues.",
)
@click.option("--overwrite", is_flag=True, help="Replace an existing file.")
@click.option("--threads", metavar="N", type=click.IntRange(1), help="By default one per core.")
@click.option("--scheduler", metavar="ADDRESS", help="A Dask scheduler whose workers evaluate the map.")
@drives_option
@mechanism_option
@report_option
@json_option
def map_(
    robot: Path,
    grid: str | None,
    poses: Path | None,
    settings: tuple[str, ...],
    samples: int | None,
    seed: int,
    shapes: bool,
    tracked: bool,
    out: Path | None,
    overwrite: bool,
    threads: int | None,
    scheduler: str | None,
    drives: str,
    report_to: Path | None,
    json_file: str | None,
) -> None:
    """Compute the modes over the workspace, print their ranges, and write them to a file."""
    map_target = Target("--out", out, "the map", anywhere=True)
    check_targets(json_file, [robot, poses], map_target, report_target(report_to))
    sources = sources_of(report_to, {"robot file": robot})
    model = load(robot)
    with named_as_options(*ARGUMENTS, sweep="--set"), _continued(out):
        dataset = model.map(
            places_given(model, grid, poses),
            sweep=settings_given(model, settings),
            samples=samples,
            seed=seed,
            shapes=shapes,
            tracked=tracked,
            out=out,
            overwrite=overwrite,
            scheduler=scheduler,
            threads=threads,
            drives=drives,
            progress=_counted(),
        )
    from pkmodes.machine.maps.summary import summary_of

    file = None if out is None else str(out)
    content = summary_of(dataset, file).as_json()
    report = report_file(report_to, lambda: _page(model, dataset, content, sources))
    complete = (
        "" if out is None else "the map is written; for its report run the command again with --overwrite"
    )
    with _continued(out, complete):
        deliver(json_file, content, lambda: _print(model, content), report)


def _page(model: Model, dataset: Dataset, content: dict[str, Any], sources: Sequence[Source]) -> str:
    from pkmodes.pages.report.map import map_report, middle_of
    from pkmodes.pages.report.model_view import view_of

    view = view_of(model, start=middle_of(model, dataset), drives=content["drives"])
    return map_report(model, dataset, content, sources, view)


@contextmanager
def _continued(out: Path | None, complete: str = "") -> Iterator[None]:
    """Report how an interrupted map continues."""
    try:
        yield
    except KeyboardInterrupt:
        from pkmodes.machine.maps.storage import SUFFIX

        kept = out is not None and out.with_name(out.name + SUFFIX).exists()
        again = "the same command continues where it stopped" if kept else complete or "run it again"
        raise click.Abort(again) from None


def _counted() -> Callable[[int, int], None]:
    """Return a function that reports how many poses are done, and how long the others will take."""
    begin: list[tuple[float, int]] = []

    def told(done: int, total: int) -> None:
        begin.append((time.monotonic(), done))
        (first, before), (now, _) = begin[0], begin[-1]
        rate = (done - before) / (now - first) if now > first else 0.0
        remaining = f", about {duration((total - done) / rate)} left" if 0 < done < total and rate else ""
        say(f"{done:,} of {total:,} poses{remaining}")

    return told


def _print(model: Model, content: dict[str, Any]) -> None:
    """Print the summary of a map of a robot, from `pkmodes.machine.maps.summary.summary_of`."""
    from pkmodes.cli.terminal import Terminal
    from pkmodes.pages.report.map_summary import ranges, summary_of_map

    terminal, head = Terminal(), summary_of_map(model, content)
    terminal.summary(head)
    terminal.show(ranges(model, content))
    terminal.notes(head)
    if content["file"]:
        terminal.line()
        terminal.heading(f"wrote {content['file']}")
