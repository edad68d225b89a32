"""``pkmodes check``: check that generated code is up to date and agrees with finite differences."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import click
from msgspec import Meta

from pkmodes.cli.delivery import deliver
from pkmodes.cli.options import PATH, json_option, unregistered_mechanism_option
from pkmodes.cli.printing import echo
from pkmodes.cli.targets import check_targets
from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.support.documents import Document
from pkmodes.core.support.progress import report_progress

if TYPE_CHECKING:
    from pkmodes.codegen.checking.products import Report

Cause = Literal[
    "robot",
    "derivation",
    "sympy",
    "generator",
    "edited",
    "missing",
    "orphan",
    "manifest",
    "different",
]


class FindingDocument(Document, frozen=True):
    """A reason why a target is not up to date."""

    cause: Annotated[Cause, Meta(description="Kind of finding.")]
    subject: Annotated[str, Meta(description="The field or file.")]
    message: Annotated[str, Meta(description="One sentence.")]
    diff: Annotated[
        str,
        Meta(
            description="Unified diff from the file on disk to its expected contents, shortened; may be empty."
        ),
    ]


class RelationDocument(Document, frozen=True):
    """A generated derivative compared with finite differences."""

    name: Annotated[str, Meta(description="The relation, and the kind of finite difference.")]
    error: Annotated[
        float | None,
        Meta(description="Largest error relative to the size of the quantity; null where it is not finite."),
    ]
    bound: Annotated[float, Meta(description="Upper bound of the error.")]
    holds: Annotated[bool, Meta(description="Whether it is within the bound.")]


class TargetDocument(Document, frozen=True):
    """A checked target."""

    target: Annotated[str, Meta(description="The checked folder or robot file.")]
    holds: Annotated[
        bool, Meta(description="Whether it is up to date and consistent, as far as it could be checked.")
    ]
    findings: Annotated[list[FindingDocument], Meta(description="Why it is not up to date; empty if it is.")]
    consistency: Annotated[
        list[RelationDocument],
        Meta(
            description="Generated derivatives compared with finite differences; empty for a folder of the "
            "parametric model."
        ),
    ]
    unchecked: Annotated[
        list[str],
        Meta(description="What could not be checked, and the remedy, such as for a missing robot file."),
    ]
    mend: Annotated[
        str | None,
        Meta(description="Command that fixes the findings; null where there is none, or nothing to fix."),
    ]


class CheckDocument(Document, frozen=True):
    """The report on all targets."""

    holds: Annotated[
        bool,
        Meta(description="Whether everything that could be checked holds: exit code 0, otherwise 1."),
    ]
    targets: Annotated[list[TargetDocument], Meta(description="One for each target, in the order given.")]


@click.command(
    epilog="\b\nExamples:\n  pkmodes check\n  pkmodes check build/linear-delta-2022\n"
    "  pkmodes check robots/linear-delta-2022.toml"
)
@click.argument("targets", metavar="[DIR or ROBOT.toml ...]", nargs=-1, type=PATH)
@unregistered_mechanism_option
@click.option("--brief", is_flag=True, help="Print one line for each folder or robot file, for CI logs.")
@click.option("--diff", is_flag=True, help="Show the lines of the files that differ, after the reasons.")
@json_option
def check(
    targets: tuple[Path, ...], mechanism: Path | None, brief: bool, diff: bool, json_file: str | None
) -> int:
    """Check that generated code is up to date and agrees with finite differences.

    A folder written by `pkmodes generate` is compared with a fresh derivation from its robot file.  The model of a
    robot file is derived and checked in memory.  Without a target, the models that come with pkmodes are checked.
    The exit code is 1 if a check fails: the output names the file or field that changed, and the command that fixes
    it; with --diff, it shows the lines that differ.  Other files in the folder are ignored.

    A folder that was copied without its robot file is checked against the values recorded in its manifest.  The
    output says that the robot file was not checked, and the exit code is 0 if everything else is correct.

    A mechanism of your own is derived from the definition stored with its code, which is executed.
    """
    from pkmodes.codegen.checking import products
    from pkmodes.core.mechanism.registry import add_folder, supplied_names

    check_targets(json_file, targets)
    if mechanism is not None:
        add_folder(mechanism)
        targets = targets or (mechanism,)
    reports: list[Report] = []
    for number, name in enumerate(() if targets else supplied_names(), start=1):
        report_progress(f"{name}, {number} of {len(supplied_names())}: deriving it again")
        reports.append(products.check_committed(name))
    for number, target in enumerate(targets, start=1):
        report_progress(f"{target}, {number} of {len(targets)}: deriving it again")
        if target.is_dir():
            reports.append(products.check_folder(target))
        elif target.is_file():
            reports.append(products.check_robot(target))
        else:
            raise PkmodesError(
                "no such file or folder", str(target), "give a generated folder or a robot file"
            )
    holds = all(report.holds for report in reports)
    documents = [
        TargetDocument.of(
            report,
            findings=list(map(FindingDocument.of, report.findings)),
            consistency=list(map(RelationDocument.of, report.checks)),
            mend=report.fix_command or None,
        )
        for report in reports
    ]

    def show() -> None:
        for report in reports:
            for line in _brief_line(report) if brief else _detailed_lines(report, diff):
                echo(line)

    deliver(json_file, CheckDocument(holds=holds, targets=documents).as_json(), show)
    return 0 if holds else 1


def _brief_line(report: Report) -> Iterator[str]:
    """Yield one line: whether a target is current, or the first reason why not."""
    reasons = [*(finding.message for finding in report.findings), *_failed_relations(report)]
    if not reasons:
        yield f"{report.target}: {_verdict_if_holding(report)}"
        return
    suffix = f"; and {len(reasons) - 1} more" if len(reasons) > 1 else ""
    yield f"{report.target}: {reasons[0]}{suffix}"


def _failed_relations(report: Report) -> list[str]:
    """Return the derivatives that differ from finite differences, in words."""
    return [
        f"{check.name}: relative error {check.error:.1e}, expected at most {check.bound:.0e}"
        for check in report.checks
        if not check.holds
    ]


def _verdict_if_holding(report: Report) -> str:
    """Return the verdict on a target that passed all checks."""
    return "as generated, and current except for what was not checked" if report.unchecked else "current"


def _detailed_lines(report: Report, diff: bool) -> Iterator[str]:
    """Yield the reasons, what was not checked and the remedy, and after them the differences of the files."""
    diffs = [finding.diff for finding in report.findings if finding.diff]
    for finding in report.findings:
        yield f"{report.target}: {finding.message}"
    failed_relations = _failed_relations(report)
    for sentence in failed_relations:
        yield f"{report.target}: {sentence}"
    if report.checks and not failed_relations:
        worst = max(report.checks, key=lambda check: check.error / check.bound)
        yield (
            f"{report.target}: {len(report.checks)} relations agree with finite differences "
            f"(closest to its bound: {worst.name}, {worst.error:.1e} of {worst.bound:.0e})"
        )
    for sentence in report.unchecked:
        yield f"{report.target}: not checked: {sentence}"
    if diffs and not diff:
        yield "what differs, line by line: --diff"
    if report.fix_command:
        yield f"fix with: {report.fix_command}"
    elif report.holds:
        yield f"{report.target}: {_verdict_if_holding(report)}"
    for text in diffs if diff else ():
        yield from text.split("\n")
