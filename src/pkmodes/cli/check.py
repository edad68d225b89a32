"""``pkmodes check``: check that generated code is up to date and agrees with finite differences."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from pkmodes.base.errors import PkmodesError
from pkmodes.cli.output import check_target, deliver, json_option, to_file, write_json

if TYPE_CHECKING:
    from pkmodes.codegen.checking.report import Report


@click.command(
    epilog="\b\nExamples:\n  pkmodes check\n  pkmodes check build/linear-delta-2022\n"
    "  pkmodes check robots/linear-delta-2022.toml"
)
@click.argument("targets", metavar="[DIR or ROBOT.toml ...]", nargs=-1, type=click.Path(path_type=Path))
@click.option(
    "--mechanism",
    metavar="FOLDER",
    type=click.Path(path_type=Path),
    help="A mechanism of your own: the folder that generate --mechanism FILE.py wrote.",
)
@json_option
def check(targets: tuple[Path, ...], mechanism: Path | None, json_file: str | None) -> int:
    """Check that generated code is up to date and agrees with finite differences.

    A folder written by `pkmodes generate` is compared with a fresh derivation from its robot file.  The model of a
    robot file is derived and checked in memory.  Without a target, the models that come with pkmodes are checked.
    The exit code is 1 if a check fails: the output names the file or field that changed, and shows the difference
    and the command that fixes it.  Other files in the folder are ignored.

    A folder that was copied without its robot file is checked against the values recorded in its manifest.  The
    output says that the robot file was not checked, and the exit code is 0 if everything else is correct.

    A mechanism of your own is derived from the definition stored with its code, which is executed.
    """
    from pkmodes.codegen.checking import products
    from pkmodes.mechanism.registry import add_folder, supplied

    check_target(json_file, *targets)
    if mechanism is not None:
        add_folder(mechanism)
        targets = targets or (mechanism,)
    reports: list[Report] = [] if targets else [products.check_committed(name) for name in supplied()]
    for target in targets:
        if target.is_dir():
            reports.append(products.check_folder(target))
        elif target.is_file():
            reports.append(products.check_robot(target))
        else:
            raise PkmodesError(
                "no such file or folder", str(target), "give a generated folder or a robot file"
            )
    content = {"holds": all(r.holds for r in reports), "targets": [_as_json(r) for r in reports]}
    with deliver(to_file(json_file, content)):
        if json_file == "-":
            write_json(json_file, content)
        else:
            for report in reports:
                _print(report)
    return 0 if all(report.holds for report in reports) else 1


def _as_json(report: Report) -> dict[str, Any]:
    return {
        "target": report.target,
        "holds": report.holds,
        "findings": [
            {"cause": f.cause, "subject": f.subject, "message": f.message, "diff": f.diff}
            for f in report.findings
        ],
        "consistency": [
            {"name": c.name, "error": c.error, "bound": c.bound, "holds": c.holds} for c in report.checks
        ],
        "unchecked": list(report.unchecked),
        "mend": report.mend or None,
    }


def _print(report: Report) -> None:
    for finding in report.findings:
        click.echo(f"{report.target}: {finding.message}")
        if finding.diff:
            click.echo(finding.diff)
    failed = [c for c in report.checks if not c.holds]
    for one in failed:
        click.echo(
            f"{report.target}: {one.name}: relative error {one.error:.1e}, expected at most {one.bound:.0e}"
        )
    if report.checks and not failed:
        worst = max(report.checks, key=lambda c: c.error / c.bound)
        click.echo(
            f"{report.target}: {len(report.checks)} relations agree with finite differences "
            f"(closest to its bound: {worst.name}, {worst.error:.1e} of {worst.bound:.0e})"
        )
    for sentence in report.unchecked:
        click.echo(f"{report.target}: not checked: {sentence}")
    if report.mend:
        click.echo(f"fix with: {report.mend}")
    elif report.holds and report.unchecked:
        click.echo(f"{report.target}: as generated, and current except for what was not checked")
    elif report.holds:
        click.echo(f"{report.target}: current")
