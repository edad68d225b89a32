"""``pkmodes map``: the modes over the workspace, and over ranges of parameters, in a file."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import click

from pkmodes.api import load
from pkmodes.cli.delivery import deliver
from pkmodes.cli.option_table import OptionTable, entry, option
from pkmodes.cli.options import PATH, drives_option, forwarded_mechanism_option, robot_argument
from pkmodes.cli.poses import grid_option, parse_path_option, path_option, poses_option, selected_poses
from pkmodes.cli.progress import duration
from pkmodes.cli.reporting import report_file
from pkmodes.cli.settings import parse_settings_option, settings_option
from pkmodes.core.support.progress import report_progress


@dataclass(frozen=True)
class MapOptions(OptionTable):
    """Arguments and options of the command; those marked `passed` are arguments of `pkmodes.Model.map`."""

    robot: Path = entry(robot_argument, reads="robot file")
    grid: str | None = entry(grid_option)
    poses: Path | None = entry(poses_option, reads="")
    path: str | None = entry(path_option)
    settings: tuple[str, ...] = entry(
        settings_option(
            "Sweep a parameter, such as platform.mass=1:2:5 or platform.mass=1.5; repeat for several "
            "parameters, all of whose combinations are evaluated."
        )
    )
    samples: int | None = option(
        "--samples",
        metavar="N",
        type=click.IntRange(1),
        passed=True,
        help="Evaluate N robots: values with a standard deviation are drawn from normal distributions with the "
        "correlations of the robot file.",
    )
    seed: int = option(
        "--seed",
        metavar="N",
        type=click.IntRange(0),
        default=0,
        show_default=True,
        passed=True,
        help="Seed of the random draws of --samples.",
    )
    shapes: bool = option("--shapes", is_flag=True, passed=True, help="Keep mode shapes too.")
    tracked: bool = option(
        "--tracked", is_flag=True, passed=True, help="Number modes by their shapes instead of by rank."
    )
    out: Path | None = option(
        "--out",
        metavar="FILE",
        type=PATH,
        passed=True,
        writes="the map",
        checked_when_written=True,
        help="File to write: .nc (NetCDF), .zarr, or a table in .csv or .parquet.  The same command continues an "
        "interrupted map.",
    )
    overwrite: bool = option("--overwrite", is_flag=True, passed=True, help="Replace an existing file.")
    threads: int | None = option(
        "--threads",
        metavar="N",
        type=click.IntRange(1),
        passed=True,
        help="Number of threads; by default one per core.",
    )
    scheduler: str | None = option(
        "--scheduler",
        metavar="ADDRESS",
        passed=True,
        help="Address of a Dask scheduler whose workers evaluate the map.",
    )
    drives: str = entry(drives_option, passed=True)
    mechanism: Path | None = entry(forwarded_mechanism_option)


@click.command(
    "map",
    epilog="\b\nExample:\n  pkmodes map robots/linear-delta-2022.toml \\\n    --grid "
    "x=0.3:0.8:51,y=-0.1:0.1:41,z=-0.245 --out map.nc",
)
@MapOptions.add_to
def map_(options: MapOptions) -> None:
    """Compute the modes over the workspace, print their ranges, and write them to a file."""
    options.check_files()
    sources, out = options.sources(), options.out
    model = load(options.robot)
    with options.name_in_errors(sweep="--set"), _explain_interrupt(out):
        path = None if options.path is None else parse_path_option(model.mechanism, options.path)
        if path is not None and (options.grid is not None or options.poses is not None):
            raise click.UsageError("--path excludes --grid and --poses", click.get_current_context())
        dataset = model.map(
            selected_poses(model, options.grid, options.poses) if path is None else path.poses,
            sweep=parse_settings_option(model, options.settings),
            progress=_progress_reporter(),
            **options.call_arguments(),
        )
    from pkmodes.machine.maps.spread import typical_spread
    from pkmodes.machine.maps.summary import summary_of

    sigmas = typical_spread(model.robot, dataset, model.max_condition)
    content = summary_of(dataset, None if out is None else str(out), sigmas).as_json()

    def page() -> str:
        from pkmodes.pages.report.map import cursor_pose, map_report
        from pkmodes.pages.report.map_planes import section_of
        from pkmodes.pages.report.model_view import view_of

        section = section_of(model, dataset)
        start = cursor_pose(model, dataset, section.plane)
        view = view_of(model, start=start, drives=content["drives"])
        return map_report(model, dataset, content, sources, view, section, path)

    def show() -> None:
        from pkmodes.cli.terminal import Terminal
        from pkmodes.pages.report.map_summary import range_table, summary_of_map

        terminal = Terminal()
        terminal.result(summary_of_map(model, content, path), range_table(model, content))
        if content["file"]:
            terminal.line()
            terminal.heading(f"wrote {content['file']}")

    remedy_when_written = (
        "" if out is None else "the map is written; for its report run the command again with --overwrite"
    )
    with _explain_interrupt(out, remedy_when_written):
        deliver(options.json_file, content, show, report_file(options.report_to, page))


@contextmanager
def _explain_interrupt(out: Path | None, remedy_when_written: str = "") -> Iterator[None]:
    """After an interrupt, report what to do: whether the same command continues."""
    try:
        yield
    except KeyboardInterrupt:
        from pkmodes.machine.maps.storage import PARTIAL_SUFFIX

        can_continue = out is not None and out.with_name(out.name + PARTIAL_SUFFIX).exists()
        remedy = (
            "the same command continues where it stopped"
            if can_continue
            else remedy_when_written or "run it again"
        )
        raise click.Abort(remedy) from None


def _progress_reporter() -> Callable[[int, int], None]:
    """Return a function that reports the number of poses done, and the time that the others will take."""
    counts: list[tuple[float, int]] = []

    def report(done: int, total: int) -> None:
        counts.append((time.monotonic(), done))
        (start_time, start_count), (now, _) = counts[0], counts[-1]
        rate = (done - start_count) / (now - start_time) if now > start_time else 0.0
        remaining = f", about {duration((total - done) / rate)} left" if 0 < done < total and rate else ""
        report_progress(f"{done:,} of {total:,} poses{remaining}")

    return report
