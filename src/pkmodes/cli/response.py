"""``pkmodes response``: frequency response functions and a state space model at a pose."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import click
import numpy as np
from msgspec import Meta
from numpy.typing import NDArray

from pkmodes.api import load
from pkmodes.cli.delivery import ResultFile, deliver
from pkmodes.cli.options import (
    FILE,
    comma_list,
    drives_option,
    json_option,
    mechanism_option,
    named_as_options,
    report_option,
    robot_argument,
)
from pkmodes.cli.poses import pose_of, pose_option
from pkmodes.cli.reporting import report_file, sources_of
from pkmodes.cli.targets import Target, check_targets, report_target
from pkmodes.core.base.drives import Drives
from pkmodes.core.base.errors import PkmodesError, shown
from pkmodes.core.support.documents import Document
from pkmodes.core.support.progress import say
from pkmodes.machine.response.ports import QUANTITIES

if TYPE_CHECKING:
    from pkmodes.core.model import Model
    from pkmodes.machine.response.frequency_response import FrequencyResponse
    from pkmodes.machine.response.measured import MeasuredResponse


class ResponseDocument(Document, frozen=True):
    """The response of F frequencies at a pose, for exp(+i omega t)."""

    robot: Annotated[str, Meta(description="Name of the robot.")]
    pose: Annotated[list[float], Meta(description="The components of the mechanism's pose, in SI units.")]
    drives: Drives
    quantity: Annotated[str, Meta(description="Of every output: displacement, velocity or acceleration.")]
    inputs: Annotated[list[str], Meta(description="Names of the inputs.")]
    outputs: Annotated[list[str], Meta(description="Names of the outputs.")]
    units: Annotated[list[list[str]], Meta(description="Of each output (rows) per input (columns).")]
    frequencies_hz: Annotated[list[float], Meta(description="The F frequencies [Hz].")]
    real: Annotated[
        list[list[list[float]]], Meta(description="Real parts: for each frequency, outputs by inputs.")
    ]
    imaginary: Annotated[list[list[list[float]]], Meta(description="Imaginary parts, likewise.")]


@click.command(
    epilog="\b\nExample:\n  pkmodes response robots/linear-delta-2022.toml --pose 0.6,0,-0.245 \\\n"
    "    --drives held --inputs motor_1,force_x --outputs p_x,p_z \\\n    --frequencies 5:400:1000"
)
@robot_argument
@pose_option
@click.option(
    "--inputs",
    metavar="NAME,...",
    required=True,
    help="torque_1 of a free motor, the prescribed angle motor_1 of a held one, force_x on the platform, moment_x on "
    "one that turns.",
)
@click.option(
    "--outputs",
    metavar="NAME,...",
    required=True,
    help="p_x of the platform, r_x of one that turns, another direction of it such as nozzle=1:1:0, motor_1, or any "
    "coordinate.",
)
@click.option(
    "--frequencies",
    metavar="START:STOP:COUNT",
    required=True,
    help="In Hz, such as 1:400:1000, both ends included, or one value.",
)
@click.option("--log", is_flag=True, help="Space the frequencies by equal ratios.")
@click.option(
    "--quantity",
    type=click.Choice(QUANTITIES),
    default="displacement",
    show_default=True,
    help="What is asked of every output.",
)
@click.option(
    "--out",
    metavar="FILE.csv",
    type=FILE,
    help="Table to write: frequency, and the real and the imaginary part of each channel.",
)
@click.option(
    "--state-space",
    "model_file",
    metavar="FILE.mat",
    type=FILE,
    help="MATLAB file to write: A, B, C, D of the same inputs and outputs.",
)
@click.option(
    "--modes",
    metavar="N",
    type=int,
    help="Modes kept in the state space model; by default all.",
)
@click.option(
    "--figure",
    metavar="FILE.svg",
    type=FILE,
    help="Picture to write: magnitude and phase of each channel; .svg, .png or .pdf.",
)
@click.option(
    "--measured",
    metavar="FILE",
    type=FILE,
    help="Measured responses to draw over those of the model: a table like that of --out, a universal or a MATLAB "
    "file.",
)
@click.option(
    "--before",
    metavar="FILE.toml",
    type=FILE,
    help="Robot file of which the same is drawn dashed, such as the one that a diagnosis corrected.",
)
@drives_option
@mechanism_option
@report_option
@json_option
def response(
    robot: Path,
    pose: str,
    inputs: str,
    outputs: str,
    frequencies: str,
    log: bool,
    quantity: str,
    out: Path | None,
    model_file: Path | None,
    modes: int | None,
    figure: Path | None,
    measured: Path | None,
    before: Path | None,
    drives: str,
    report_to: Path | None,
    json_file: str | None,
) -> None:
    """Compute how the machine responds to its motors and to forces, as functions of frequency.

    Prints the largest response of each channel; --out writes all of it, --report a page with pictures.
    """
    targets = (
        Target("--out", out, "the table", (".csv",)),
        Target("--state-space", model_file, "the state space model", (".mat",)),
        Target("--figure", figure, "the picture", (".svg", ".png", ".pdf")),
        report_target(report_to),
    )
    check_targets(json_file, [robot, measured, before], *targets)
    frequency_values = _frequencies(frequencies, log)
    if modes is not None and model_file is None:
        problem = "--modes is for the state space model, which is not written"
        raise PkmodesError(problem, "--modes", "add --state-space FILE.mat, or leave --modes out")
    for option, file in (("--measured", measured), ("--before", before)):
        if file is not None and figure is None and report_to is None:
            problem = f"{option} is for the picture and the report, which are not written"
            raise PkmodesError(
                problem, option, f"add --report FILE.html or --figure FILE.svg, or leave {option} out"
            )
    inputs_read = {"robot file": robot, "robot file before": before, "measured responses": measured}
    sources = sources_of(report_to, inputs_read)
    model, model_before = load(robot), None if before is None else load(before)
    if before is not None and model_before is not None:
        _check_alike(model, model_before, before)
    point = pose_of(model, pose)
    into = comma_list(inputs, "--inputs", "--inputs torque_1,force_x")
    shown_by = [_output(name) for name in comma_list(outputs, "--outputs", "--outputs p_x,nozzle=1:1:0")]
    say("computing the responses")
    with named_as_options("inputs", "outputs", "frequencies", "quantity", "modes", "drives"):
        result = model.frf(point, frequency_values, into, shown_by, drives=drives, quantity=quantity)
        first = None
        if model_before is not None:
            first = model_before.frf(
                point, frequency_values, into, shown_by, drives=drives, quantity=quantity
            )
        system = None
        if model_file is not None:
            system = model.state_space(point, into, shown_by, drives=drives, modes=modes, quantity=quantity)
    document = ResponseDocument.of(
        result,
        robot=model.robot.name,
        pose=result.poses.tolist(),
        frequencies_hz=result.frequencies.tolist(),
        real=result.values.real.tolist(),
        imaginary=result.values.imag.tolist(),
    )
    over = _measured(measured)
    picture = b"" if figure is None else _picture(result, figure, over, first)
    files = [
        ResultFile(out, result.as_csv),
        ResultFile(figure, lambda: picture),
    ]
    if system is not None:
        files.append(ResultFile(model_file, system.as_mat))
    if report_to is not None:
        from pkmodes.pages.report.response import response_report

        say("drawing the report")
        page = response_report(model, result, over, sources, first)  # drawn before anything is written
        files.append(report_file(report_to, lambda: page))
    deliver(json_file, document.as_json(), lambda: _print(model, result, over), *files)


def _measured(file: Path | None) -> MeasuredResponse | None:
    from pkmodes.machine.response.measured import read_response

    return None if file is None else read_response(file)


def _check_alike(model: Model, before: Model, file: Path) -> None:
    """Refuse another robot of another mechanism."""
    ours, theirs = (compared.robot.mechanism_name for compared in (model, before))
    if ours != theirs:
        problem = f"expected a {ours} like the robot that is drawn, found a {theirs}"
        raise PkmodesError(
            problem, f"--before {file}", "give the file of the same machine before it was corrected"
        )


def _picture(
    result: FrequencyResponse,
    figure: Path,
    measured: MeasuredResponse | None,
    before: FrequencyResponse | None,
) -> bytes:
    """Return the picture as a file."""
    from pkmodes.pages.figures.files import rendered
    from pkmodes.pages.figures.response_picture import response_picture

    return rendered(response_picture(result, measured, before=before), figure.suffix[1:].lower())


def _output(name: str) -> str | Mapping[str, Sequence[float]]:
    """Read an output: a name, or a direction such as ``nozzle=1:1:0``."""
    label, equals, direction = name.partition("=")
    if not equals:
        return name
    try:
        return {label: [float(part) for part in direction.split(":")]}
    except ValueError:
        problem = f"expected the components of a direction, found {shown(direction)}"
        raise PkmodesError(problem, f"--outputs {label}", "for example: nozzle=1:1:0") from None


def _frequencies(text: str, log: bool) -> NDArray[np.float64]:
    """Read ``START:STOP:COUNT`` in Hz.

    Raises PkmodesError if it is not a range of frequencies, or not one that equal ratios divide.
    """
    from pkmodes.machine.maps.ranges import parse_range

    values = parse_range(text, "1", "--frequencies")
    first, last = float(values[0]), float(values[-1])
    if first < 0.0:
        problem = f"expected frequencies of at least 0 Hz, found {shown(text)}"
        raise PkmodesError(problem, "--frequencies", "for example: --frequencies 1:400:1000")
    if log and first == 0.0:
        raise PkmodesError(
            "equal ratios cannot begin at 0 Hz", "--log", "begin above 0 Hz, or leave --log out"
        )
    return np.geomspace(first, last, len(values)) if log else values


def _print(model: Model, result: FrequencyResponse, over: MeasuredResponse | None) -> None:
    from pkmodes.cli.terminal import Terminal
    from pkmodes.machine.response.drawn_channels import DrawnChannels
    from pkmodes.pages.report.response import largest, response_summary

    terminal, drawn = Terminal(), DrawnChannels.of(result, over)
    head = response_summary(model, result, drawn)
    terminal.summary(head)
    terminal.show(largest(drawn))
    terminal.notes(head)
