"""``pkmodes diagnose``: find what the model lacks from measured modes, and write a corrected robot file."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from pkmodes.cli.delivery import ResultFile, deliver
from pkmodes.cli.diagnosing import parse_verdicts, progress_lines, split_names
from pkmodes.cli.option_table import missing_file_error
from pkmodes.cli.options import (
    PATH,
    band_option,
    check_file_order,
    forwarded_mechanism_option,
    json_option,
    measured_drives_option,
    parse_band_option,
    rename_arguments_in_errors,
    report_option,
    robot_argument,
)
from pkmodes.cli.reporting import page_of, report_file, sources_of
from pkmodes.cli.targets import Target, check_targets, report_target
from pkmodes.core.base.numbers import plain
from pkmodes.core.robot.reading import read_robot
from pkmodes.core.support.ordering import listed
from pkmodes.core.support.pasting import shell_path

if TYPE_CHECKING:
    from pkmodes.core.robot.robot import Robot
    from pkmodes.loop.diagnosis import Diagnosis
    from pkmodes.loop.diagnosis.verdict.terms import TermClass


#: Maximum number of values named whose standard deviations are larger in a saved file than in the fit.
MAX_WIDENED_NAMED = 3


@click.command(
    epilog="\b\nExample:\n  pkmodes diagnose examples/closed_loop/robot.toml \\\n    "
    "examples/closed_loop/measured.csv \\\n    --candidates effects,parameter:axis.span --holdout P3,P7 "
    "\\\n    --save-robot corrected.toml"
)
@robot_argument
@click.argument("modes", metavar="MODES.csv", type=PATH)
@click.option(
    "--candidates",
    metavar="NAMES",
    help="Candidates, separated by commas: names of effects, parameter:PATH, measurement:WHAT, or the words "
    "effects, parameters and measurement; by default all.",
)
@click.option(
    "--holdout",
    metavar="POSES",
    help="Labels of poses to exclude from all fits, separated by commas (a label with a comma in double quotes), "
    "or the word none; by default one pose in six.",
)
@click.option(
    "--save-robot",
    "save_to",
    metavar="FILE.toml",
    type=PATH,
    help="Write the robot file with the causes found and the refitted values.",
)
@click.option(
    "--save-effect",
    "effect_to",
    metavar="FILE.py",
    type=PATH,
    help="Write what was found beyond the catalogue as an effect of your own, for generate --effect.",
)
@report_option
@click.option(
    "--campaign",
    metavar="FILE.toml",
    type=PATH,
    help="Campaign that the modes were identified from: the report shows its frequency responses over those of the "
    "robot before and after the correction.",
)
@click.option(
    "--no-beyond",
    "no_beyond",
    is_flag=True,
    help="Where the candidates do not explain the measurements, do not search beyond them for one thing at one "
    "place, such as a mass on one body.",
)
@click.option(
    "--fail-on",
    "fail_on",
    metavar="VERDICTS",
    help="Verdicts that give exit code 1, separated by commas, or the word any for all except adequate; by "
    "default no verdict.",
)
@click.option(
    "--prior",
    "priors",
    metavar="NAME=SIGMA",
    multiple=True,
    help="Standard deviation by which a candidate may plausibly differ from what is declared, such as "
    "measurement:offset.z=2mm; may be repeated, or given in the file.",
)
@click.option(
    "--usable",
    metavar="LIMIT",
    multiple=True,
    help="Limits of the poses at which the next measurement may be taken, as in [usable] of a robot file, such as "
    "z=40mm,300mm or radius=120mm; may be repeated, or given in the file.",
)
@band_option
@measured_drives_option
@forwarded_mechanism_option
@json_option
def diagnose(
    robot: Path,
    modes: Path,
    mechanism: Path | None,
    candidates: str | None,
    holdout: str | None,
    save_to: Path | None,
    effect_to: Path | None,
    report_to: Path | None,
    campaign: Path | None,
    no_beyond: bool,
    fail_on: str | None,
    priors: tuple[str, ...],
    usable: tuple[str, ...],
    band: str | None,
    drives: str | None,
    json_file: str | None,
) -> int:
    """Find what is missing from the model, and how much adding it improves the fit.

    The verdict is adequate, effect_found, ambiguous, unexplained or insufficient_data, with a reason.  The exit
    code is 0 for any verdict except those in --fail-on, which give 1, as does --save-robot where the verdict leaves
    nothing to save.  It is 2 for bad input.

    These verdicts concern frequencies and shapes.  Measured damping has a verdict of its own; losses that it shows
    are saved, too.
    """
    check_file_order(robot, modes, "pkmodes diagnose")
    save_target = Target("--save-robot", save_to, "the corrected robot")
    effect_target = Target("--save-effect", effect_to, "the effect")
    if campaign is not None and report_to is None:
        raise missing_file_error("--campaign", {"--report FILE.html": "the report"})
    inputs = [robot, modes, *([] if campaign is None else [campaign])]
    check_targets(json_file, inputs, save_target, effect_target, report_target(report_to))
    candidate_names = None if candidates is None else split_names(candidates, "--candidates")
    held_out = (
        None if holdout is None else [] if holdout.strip() == "none" else split_names(holdout, "--holdout")
    )
    failing_verdicts = frozenset() if fail_on is None else parse_verdicts(split_names(fail_on, "--fail-on"))
    from pkmodes.cli.diagnosis_tables import show_diagnosis
    from pkmodes.loop import updating  # SciPy is loaded only where it is used
    from pkmodes.loop.measured.statements import parse_prior, parse_usable
    from pkmodes.loop.updating.corrected_robot import corrected_robot
    from pkmodes.loop.updating.saved_term import effect_text, term_to_save

    prior_sigmas = dict(
        parse_prior(text, "--prior", "write --prior measurement:offset.z=2mm") for text in priors
    )
    usable_limits = dict(parse_usable(text, "--usable", "write --usable z=40mm,300mm") for text in usable)
    declared_robot = read_robot(robot)
    campaign_read = None
    if campaign is not None:
        from pkmodes.modaltest.campaign.campaign import read_campaign

        campaign_read = read_campaign(campaign)  # its mistakes are reported before anything is computed
    data = updating.read(
        modes,
        parse_band_option(band),
        declared_robot,
        drives=drives,
        priors=prior_sigmas,
        usable=usable_limits,
    )
    sources = sources_of(
        report_to, {"robot file": robot, "measurement file": modes, "campaign file": campaign}
    )
    options = rename_arguments_in_errors("candidates", "holdout", "usable", priors="--prior")
    with progress_lines("diagnose") as progress, options:
        result = updating.diagnose(
            declared_robot,
            data,
            candidates=candidate_names,
            holdout=held_out,
            progress=progress,
            terms=not no_beyond,
        )
    term = term_to_save(result)
    nothing_to_save = save_to is not None and not result.settled and term is None
    robot_file = ResultFile(
        None if nothing_to_save else save_to,
        lambda: corrected_robot(declared_robot, result),
        lambda file: (
            _saved_term_lines(file, effect_to, term)
            if term
            else _saved_robot_lines(file, mechanism, declared_robot, result)
        ),
    )
    if effect_to is not None:
        effect_text(result, "--save-effect")  # refused before anything is written
    effect_file = ResultFile(
        effect_to,
        lambda: effect_text(result, "--save-effect"),
        lambda file: [
            f"\nwrote {file}; next: pkmodes generate ROBOT.toml --effect {shell_path(file)} --out DIR"
        ],
    )
    report = report_file(report_to, lambda: page_of(result, declared_robot, data, sources, campaign_read))
    try:
        deliver(
            json_file,
            result.as_json(),
            lambda: show_diagnosis(declared_robot, result),
            robot_file,
            effect_file,
            report,
        )
    finally:  # also where another file cannot be written
        if nothing_to_save:
            reason = f"the verdict is {result.verdict}, which leaves nothing to correct"
            click.echo(f"pkmodes diagnose: {save_to} is not written: {reason}", err=True)
    return 1 if nothing_to_save or result.verdict in failing_verdicts else 0


def _saved_robot_lines(file: Path, mechanism: Path | None, robot: Robot, result: Diagnosis) -> list[str]:
    """Return the command that generates the code of a saved robot, and notes on its values."""
    from pkmodes.cli.terminal import Terminal
    from pkmodes.loop.diagnosis.verdict import naming
    from pkmodes.loop.updating.corrected_robot import widened_values

    sentences = [
        f"{naming.choice_in_words(effect)}: to save that instead, add --candidates {effect.members[1]}"
        for effect in result.every_cause
        if len(effect.members) > 1  # which these data cannot distinguish
    ]
    widened = sorted(widened_values(result), key=lambda value: -value.saved_sigma / max(value.sigma, 1e-300))
    widened_texts = [
        f"{value.name.removeprefix('effects.')} {plain(value.saved_sigma, 2)} instead of "
        f"{plain(value.sigma, 2)} {value.unit} ({value.unseen.candidate or value.unseen.default})"
        for value in widened
        if value.unseen is not None
    ]
    if widened_texts:
        sentences.append(
            "the sigmas in it allow for candidates that these data do not show: "
            + listed(widened_texts, MAX_WIDENED_NAMED, before_surplus=", and ")
        )
    # Constants of the causes that are known only from the load cases, such as a belt tension.
    load_paths = {path for row in result.rows for path in row.load}
    names = [effect.name.partition(".")[0] for effect in result.effects]
    for cause in [robot.mechanism.effects[name] for name in names if name in robot.mechanism.effects]:
        for constant in [f"{cause.name}.{p.name}" for p in cause.parameters if not p.fitted]:
            if f"effects.{constant}" in load_paths and constant not in robot.effects:
                sentences.append(
                    f"effects.{constant} is known from the measurements alone: add its value in operation to {file}"
                )
    option = f"--mechanism {shell_path(mechanism)} " if mechanism else ""
    command = (
        f"pkmodes generate {option}{shell_path(file)} --out DIR"  # not wrapped, so that it can be copied
    )
    lines = [line for text in sentences for line in Terminal().wrap(text)]
    return [f"\nwrote {file}; next: {command}", *lines]


def _saved_term_lines(file: Path, effect: Path | None, term: TermClass) -> list[str]:
    """Return the commands that read a saved robot with a term from beyond the catalogue."""
    from pkmodes.loop.updating.saved_term import is_declared

    if is_declared(term):
        return [f"\nwrote {file}; next: pkmodes generate {shell_path(file)} --out DIR"]
    argument = "FILE.py" if effect is None else shell_path(effect)
    lines = [f"\nwrote {file}; next: pkmodes generate {shell_path(file)} --effect {argument} --out DIR"]
    if effect is None:
        lines.append("FILE.py is the effect itself: write it with --save-effect FILE.py")
    return [*lines, "then give other commands --mechanism DIR/<mechanism>"]
