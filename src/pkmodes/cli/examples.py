"""``pkmodes examples``: the robot files and examples that come with pkmodes, to begin without a checkout."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import click
from msgspec import Meta

from pkmodes.cli.delivery import deliver, files_to_write
from pkmodes.cli.options import PATH, json_option, overwrite_option
from pkmodes.cli.printing import echo
from pkmodes.cli.targets import check_targets
from pkmodes.core.support.documents import Document
from pkmodes.core.support.pasting import shell_path
from pkmodes.core.support.writing import write_files
from pkmodes.loop.robot_files.supplied import EXAMPLES, ROBOTS, supplied

EVERYTHING = "all"


class Example(Document, frozen=True):
    """An example."""

    name: Annotated[str, Meta(description="The name by which the command takes it.")]
    text: Annotated[str, Meta(description="What it is, a sentence.")]
    page: Annotated[str, Meta(description="The page of the documentation that follows it.")]
    command: Annotated[str, Meta(description="A first command, in the folder where it was written.")]
    places: Annotated[list[str], Meta(description="Its folders or files below that folder.")]


class ExamplesDocument(Document, frozen=True):
    """The examples, and which files were written."""

    examples: Annotated[list[Example], Meta(description="Those asked for; without a name all of them.")]
    out: Annotated[str | None, Meta(description="The folder, as given; null where nothing was asked for.")]
    written: Annotated[list[str], Meta(description="Names of the files written below it.")]
    unchanged: Annotated[list[str], Meta(description="Names of the files that were there already.")]


def _example(name: str, text: str, page: str, command: str, *places: str) -> Example:
    # Every example includes the robot files: pages and commands compare with them.
    folders = places or (f"{EXAMPLES}/{name}",)
    return Example(name, text, f"docs/{page}.md", command, [*dict.fromkeys((ROBOTS, *folders))])


#: The examples, in the order in which a user meets them.
CATALOGUE = (
    _example(
        "robots",
        "Robot files of every mechanism, the published linear delta among them.",
        "how-to/writing-a-robot-file",
        "pkmodes modes robots/linear-delta-2022.toml --pose 0.6,0,-0.245",
        ROBOTS,
    ),
    _example(
        "closed_loop",
        "A linear delta whose robot file lacks something, and 51 measured modes that show what.",
        "tutorial/tutorial",
        "pkmodes diagnose examples/closed_loop/robot.toml examples/closed_loop/measured.csv",
    ),
    _example(
        "loose_rail",
        "A linear delta with one thing at one place that no catalogue has: found, derived and added.",
        "how-to/an-effect-of-your-own",
        "pkmodes diagnose examples/loose_rail/robot.toml examples/loose_rail/measured.csv",
    ),
    _example(
        "campaign",
        "Signals of a hammer and a shaker, from which modes and then a cause are found.",
        "how-to/signals",
        "pkmodes identify examples/campaign/campaign.toml --out modes.csv",
    ),
    _example(
        "printer",
        "Spectra of a printer's accelerometer, and its robot file.",
        "how-to/printer-signals",
        "pkmodes identify examples/printer/campaign.toml --out modes.csv",
    ),
    _example(
        "tapped_printer",
        "Recordings of a printer with RepRapFirmware, one of whose belts is softer.",
        "tutorial/tapped-printer",
        "pkmodes identify examples/tapped_printer/campaign.toml --out modes.csv",
    ),
    _example(
        "roving_hammer",
        "Blows in time at six points of a linear delta, and its robot file.",
        "tutorial/roving-hammer",
        "pkmodes identify examples/roving_hammer/campaign.toml --out modes.csv",
    ),
    _example(
        "hexapod",
        "Frequency responses of a hexapod, one of whose legs is softer, and its robot file.",
        "tutorial/hexapod-campaign",
        "pkmodes identify examples/hexapod/campaign.toml --out modes.csv",
    ),
    _example(
        "changed_printer",
        "The modes of a delta printer before and after a winter, in which something changed.",
        "how-to/what-changed",
        "pkmodes changed examples/changed_printer/robot.toml examples/changed_printer/before.csv "
        "examples/changed_printer/after.csv",
    ),
    _example(
        "three_storeys",
        "A real structure in seventeen states, of Los Alamos: what its model lacks, and what changed.",
        "how-to/what-changed",
        "python examples/three_storeys/three_storeys.py",
    ),
    _example(
        "voron",
        "Published resonances of a real printer at several belt tensions.",
        "explanation/voron",
        "python examples/voron/voron.py",
    ),
    _example(
        "controller_1khz",
        "A loop in C whose input shaper follows the pose, and the machine behind it.",
        "how-to/using-the-c-code",
        "pkmodes generate robots/linear-delta-2022.toml --out build/delta",
    ),
    _example(
        "notebooks",
        "Two notebooks: from a robot file to modes and maps, and from measurements to the cause.",
        "how-to/python",
        f"jupyter lab {EXAMPLES}/notebooks",
        f"{EXAMPLES}/closed_loop",
        f"{EXAMPLES}/notebooks",
    ),
    _example(
        "lumped_structure",
        "A diagnosis of a structure that is not a robot, in Python.",
        "how-to/any-structure",
        "python examples/lumped_structure.py",
        f"{EXAMPLES}/lumped_structure.py",
    ),
)


@click.command(epilog="\b\nExample:\n  pkmodes examples closed_loop --out tutorial")
@click.argument(
    "name",
    metavar="[NAME]",
    required=False,
    type=click.Choice([*(example.name for example in CATALOGUE), EVERYTHING]),
)
@click.option(
    "--out",
    metavar="DIR",
    type=PATH,
    default=Path(),
    help="Folder in which robots/ and examples/NAME/ are written; by default the current one.",
)
@overwrite_option
@json_option
def examples(name: str | None, out: Path, overwrite: bool, json_file: str | None) -> None:
    """List the examples of the documentation, or write one of them, or all.

    Each example comes with the robot files, so that the commands of its page work in that folder as in a
    checkout.  Identical files are left as they are; files that differ are replaced only with --overwrite.
    """
    check_targets(json_file, [])
    chosen = [example for example in CATALOGUE if name in (example.name, EVERYTHING, None)]
    if name is None:

        def list_all() -> None:
            width = max(len(example.name) for example in chosen)
            for example in chosen:
                echo(f"{example.name:{width}}  {example.text}")
                echo(f"{'':{width}}  {example.page}")
            echo(
                "\npkmodes examples NAME writes one of them, with the robot files; pkmodes examples all "
                "writes everything."
            )

        deliver(json_file, ExamplesDocument(chosen, None, [], []).as_json(), list_all)
        return
    contents = supplied(*(path for example in chosen for path in example.places))
    new_files = files_to_write(out, contents, f"--out {out}", overwrite)
    write_files(out, new_files)
    unchanged = [file for file in contents if file not in new_files]

    def show() -> None:
        for file in new_files:
            echo(out / file)
        if unchanged:
            echo(f"files that were there already: {len(unchanged)}")
        folder_note = "" if out == Path() else f" in {shell_path(out)}"
        for example in chosen:
            echo(f"next{folder_note}: {example.command} ({example.page})")

    deliver(json_file, ExamplesDocument(chosen, str(out), list(new_files), unchanged).as_json(), show)
