"""``pkmodes identify``: modes with standard deviations from the files of a measurement campaign."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from pkmodes.cli.delivery import ResultFile, deliver
from pkmodes.cli.options import PATH, json_option, mechanism_option, report_option
from pkmodes.cli.printing import echo
from pkmodes.cli.reporting import report_file, sources_of
from pkmodes.cli.targets import Target, check_targets, report_target
from pkmodes.core.base.drives import motors_text
from pkmodes.core.base.numbers import plain
from pkmodes.core.support.motors import motors_in_words

if TYPE_CHECKING:
    from pkmodes.modaltest.campaign.campaign import Campaign
    from pkmodes.modaltest.campaign.results import Identification


@click.command(epilog="\b\nExample:\n  pkmodes identify examples/campaign/campaign.toml --out modes.csv")
@click.argument("campaign", metavar="CAMPAIGN.toml", type=PATH)
@click.option(
    "--out",
    metavar="MODES.csv",
    type=PATH,
    required=True,
    help="Measurement file to write, for compare and diagnose; an existing file is replaced.",
)
@click.option(
    "--keep-going", is_flag=True, help="Leave out faulty files, and records of which no file remains."
)
@mechanism_option
@report_option
@json_option
def identify(
    campaign: Path, out: Path, keep_going: bool, report_to: Path | None, json_file: str | None
) -> None:
    """Identify modes from measured signals, or combine those that another program has identified.

    The campaign file states what was measured where, and with which sensors.  The result has a standard deviation for
    every frequency, damping ratio and shape.
    """
    targets = Target("--out", out, "the modes", (".csv",)), report_target(report_to)
    check_targets(json_file, [campaign], *targets)
    from pkmodes.loop.measured.writing import as_csv
    from pkmodes.modaltest.campaign.campaign import read_campaign
    from pkmodes.modaltest.campaign.identify import identify as identify_modes

    campaign_content = read_campaign(campaign)
    inputs = [
        file for record in campaign_content.records for files in record.setups.values() for file in files
    ]
    robot = None if campaign_content.model is None else Path(campaign_content.model.robot.source)
    check_targets(json_file, [campaign, *inputs, robot], *targets)
    sources = sources_of(report_to, {"campaign file": campaign, "robot file": robot})
    identification = identify_modes(campaign_content, keep_going=keep_going, inspect=report_to is not None)
    messages = [message for identified in identification.records for message in identified.messages]
    for message in (*messages, *identification.messages):
        echo(f"note: {message}", err=True)
    content = identification.as_json()
    csv_text = as_csv(
        identification.measurements, [f"modes identified by pkmodes identify from {campaign.name}"]
    )
    rows = len(identification.measurements.frequency)
    file = ResultFile(
        out, lambda: csv_text, lambda path: (f"wrote {path}: {rows} mode{'' if rows == 1 else 's'}",)
    )

    def page() -> str:
        from pkmodes.pages.report.identification import identification_report

        return identification_report(identification, campaign_content, content, sources)

    show = partial(_print, identification, campaign_content, content)
    try:
        deliver(json_file, content, show, file, report_file(report_to, page))
    finally:
        for identified in identification.records:
            for omission in identified.left_out:
                echo(f"left out: {omission.file}: {omission.reason}", err=True)
            if identified.is_left_out:
                echo(f"left out: {identified.record.pose}, none of whose files remains", err=True)


def _print(identification: Identification, campaign: Campaign, content: dict[str, Any]) -> None:
    """Print a table of each record, and the meaning of its columns."""
    from pkmodes.cli.terminal import Terminal
    from pkmodes.pages.report.identified_record import column_meanings, modes_table

    terminal = Terminal()
    for record_number, identified in enumerate(identification.records):
        drives, model = identified.record.drives, campaign.model
        state = motors_text([drives]) if model is None else motors_in_words(model.robot, drives)
        terminal.heading(f"{identified.record.pose}, {identified.record.kind}, {state}")
        found_modes = content["records"][record_number]["modes"]
        if found_modes:
            terminal.block(replace(modes_table(record_number, found_modes), caption=""))
        else:
            terminal.line("left out" if identified.is_left_out else "no mode was found")
        terminal.line()
    repeatability = f"{plain(100.0 * identification.repeatability, 2)} %"
    terminal.line(
        f"+-: one standard deviation; that of a frequency includes a repeatability of {repeatability}"
    )
    for text in column_meanings([mode for record in content["records"] for mode in record["modes"]]):
        terminal.line(text)
