"""``pkmodes response``: frequency response functions and a state space model at a pose."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Self

import click
import numpy as np
from msgspec import Meta
from numpy.typing import NDArray

from pkmodes.api import load
from pkmodes.cli.delivery import ResultFile, deliver
from pkmodes.cli.option_table import OptionTable, entry, option
from pkmodes.cli.options import PATH, comma_list, drives_option, forwarded_mechanism_option, robot_argument
from pkmodes.cli.poses import parse_pose_option, pose_option
from pkmodes.cli.reporting import report_file
from pkmodes.core.base.drives import Drives
from pkmodes.core.base.errors import PkmodesError, shown
from pkmodes.core.support.documents import Count, Document, Size
from pkmodes.core.support.progress import report_progress
from pkmodes.machine.response.ports import QUANTITIES

if TYPE_CHECKING:
    from pkmodes.machine.response.resonances import Resonance


class ResonanceDocument(Document, frozen=True):
    """The strongest resonance of the channels with the unit of the first one, of measured ones if there are any."""

    output: Annotated[str, Meta(description="Name of the output.")]
    input: Annotated[str, Meta(description="Name of the input.")]
    mode: Annotated[Count, Meta(description="Number of the vibration mode by frequency, from 1 on.")]
    frequency_hz: Annotated[Size, Meta(description="Its undamped natural frequency [Hz].")]
    frequency_sigma_hz: Annotated[
        Size | None,
        Meta(
            description="Its standard deviation [Hz], from those in the robot file; null if there are none."
        ),
    ]

    @classmethod
    def of_resonance(cls, resonance: Resonance) -> Self:
        """Return the document of a resonance."""
        output, _, input_name = resonance.channel.partition("/")
        return cls(
            output=output,
            input=input_name,
            mode=resonance.mode,
            frequency_hz=resonance.frequency,
            frequency_sigma_hz=resonance.frequency_sigma,
        )


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
    resonance: Annotated[
        ResonanceDocument | None,
        Meta(description="The strongest resonance; null where no mode shows within the frequencies."),
    ]


@dataclass(frozen=True)
class ResponseOptions(OptionTable):
    """Arguments and options of the command; those marked `passed` are arguments of `pkmodes.Model.frf`."""

    robot: Path = entry(robot_argument, reads="robot file")
    pose: str = entry(pose_option)
    inputs: str = option(
        "--inputs",
        metavar="NAME,...",
        required=True,
        help="Inputs: torque_1 of a free motor, the prescribed angle motor_1 of a held motor, force_x on the "
        "platform, moment_x on a platform that turns.",
    )
    outputs: str = option(
        "--outputs",
        metavar="NAME,...",
        required=True,
        help="Outputs: p_x of the platform, r_x of a platform that turns, another direction of the platform such "
        "as nozzle=1:1:0, motor_1, or any coordinate.",
    )
    frequencies: str = option(
        "--frequencies",
        metavar="START:STOP:COUNT",
        required=True,
        help="Frequencies in Hz, such as 1:400:1000 with both ends included, or one value.",
    )
    log: bool = option("--log", is_flag=True, help="Space the frequencies logarithmically.")
    quantity: str = option(
        "--quantity",
        type=click.Choice(QUANTITIES),
        default="displacement",
        show_default=True,
        passed=True,
        help="Quantity of every output.",
    )
    out: Path | None = option(
        "--out",
        metavar="FILE.csv",
        type=PATH,
        writes="the table",
        endings=(".csv",),
        help="Table to write: frequency, and the real and the imaginary part of each channel.",
    )
    model_file: Path | None = option(
        "--state-space",
        "model_file",
        metavar="FILE.mat",
        type=PATH,
        writes="the state space model",
        endings=(".mat",),
        help="MATLAB file to write: A, B, C, D for the same inputs and outputs.",
    )
    modes: int | None = option(
        "--modes",
        metavar="N",
        type=int,
        needs=("model_file",),
        help="Modes kept in the state space model; by default all.",
    )
    figure: Path | None = option(
        "--figure",
        metavar="FILE.svg",
        type=PATH,
        writes="the picture",
        endings=(".svg", ".png", ".pdf"),
        help="Picture to write: magnitude and phase of each channel; .svg, .png or .pdf.",
    )
    measured: Path | None = option(
        "--measured",
        metavar="FILE",
        type=PATH,
        reads="measured responses",
        needs=("figure", "report_to"),
        help="Measured responses to draw over those of the model: a campaign file, which knows the names, a table "
        "like that of --out, a universal or a MATLAB file.",
    )
    before: Path | None = option(
        "--before",
        metavar="FILE.toml",
        type=PATH,
        reads="robot file before",
        needs=("figure", "report_to"),
        help="Robot file whose responses are drawn dashed, such as the one that a diagnosis corrected.",
    )
    drives: str = entry(drives_option, passed=True)
    mechanism: Path | None = entry(forwarded_mechanism_option)


@click.command(
    epilog="\b\nExample:\n  pkmodes response robots/linear-delta-2022.toml --pose 0.6,0,-0.245 \\\n    --drives "
    "held --inputs motor_1,force_x --outputs p_x,p_z \\\n    --frequencies 5:400:1000"
)
@ResponseOptions.add_to
def response(options: ResponseOptions) -> None:
    """Compute how the machine responds to its motors and to forces, as functions of frequency.

    Prints the largest response of each channel; --out writes the whole responses, --report a page with pictures.
    """
    from pkmodes.machine.response.drawn_channels import DrawnChannels
    from pkmodes.machine.response.resonances import strongest_drawn_resonance

    options.check_files()
    frequencies = _parse_frequencies(options.frequencies, options.log)
    options.check_needs()
    sources = options.sources()
    model, model_before = load(options.robot), None if options.before is None else load(options.before)
    if model_before is not None and model_before.robot.mechanism_name != model.robot.mechanism_name:
        expected = f"a {model.robot.mechanism_name} like the robot that is drawn"
        problem = f"expected {expected}, found a {model_before.robot.mechanism_name}"
        remedy = "give the file of the same machine before it was corrected"
        raise PkmodesError(problem, f"--before {options.before}", remedy)
    pose = parse_pose_option(model, options.pose)
    inputs = comma_list(options.inputs, "--inputs", "--inputs torque_1,force_x")
    output_names = comma_list(options.outputs, "--outputs", "--outputs p_x,nozzle=1:1:0")
    outputs, arguments = list(map(_parse_output, output_names)), options.call_arguments()
    report_progress("computing the responses")
    with options.name_in_errors():
        result = model.frf(pose, frequencies, inputs, outputs, **arguments)
        response_before = (
            None
            if model_before is None
            else model_before.frf(pose, frequencies, inputs, outputs, **arguments)
        )
        state_space_model = None
        if options.model_file is not None:
            state_space_model = model.state_space(pose, inputs, outputs, modes=options.modes, **arguments)
    measured = None
    if options.measured is not None:
        if options.measured.suffix.lower() == ".toml":
            from pkmodes.machine.response.campaign_responses import campaign_response

            measured = campaign_response(options.measured, pose, options.quantity, result.inputs)
        else:
            from pkmodes.machine.response.measured import read_response

            measured = read_response(options.measured)
    drawn_channels = DrawnChannels.of(result, measured)
    resonance = strongest_drawn_resonance(result, drawn_channels) if len(frequencies) > 1 else None
    document = ResponseDocument.of(
        result,
        robot=model.robot.name,
        pose=result.poses.tolist(),
        frequencies_hz=result.frequencies.tolist(),
        real=result.values.real.tolist(),
        imaginary=result.values.imag.tolist(),
        resonance=None if resonance is None else ResonanceDocument.of_resonance(resonance),
    )
    files = [ResultFile(options.out, result.as_csv)]
    if options.figure is not None:
        from pkmodes.pages.figures.files import image_bytes
        from pkmodes.pages.figures.response_picture import response_picture

        image_format = options.figure.suffix[1:].lower()
        picture = image_bytes(response_picture(result, measured, before=response_before), image_format)
        files.append(ResultFile(options.figure, lambda: picture))
    if state_space_model is not None:
        files.append(ResultFile(options.model_file, state_space_model.as_mat))
    if options.report_to is not None:
        from pkmodes.pages.report.response import response_report

        report_progress("drawing the report")
        page = response_report(
            model, result, measured, sources, response_before
        )  # drawn before anything is written
        files.append(report_file(options.report_to, lambda: page))

    def show() -> None:
        from pkmodes.cli.terminal import Terminal
        from pkmodes.pages.report.response import largest_responses_table, response_summary

        Terminal().result(
            response_summary(model, result, drawn_channels), largest_responses_table(drawn_channels)
        )

    deliver(options.json_file, document.as_json(), show, *files)


def _parse_output(name: str) -> str | Mapping[str, Sequence[float]]:
    """Read an output: a name, or a direction such as ``nozzle=1:1:0``."""
    label, equals, direction = name.partition("=")
    if not equals:
        return name
    try:
        return {label: [float(part) for part in direction.split(":")]}
    except ValueError:
        problem = f"expected the components of a direction, found {shown(direction)}"
        raise PkmodesError(problem, f"--outputs {label}", "for example: nozzle=1:1:0") from None


def _parse_frequencies(text: str, log: bool) -> NDArray[np.float64]:
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
            "logarithmic spacing cannot begin at 0 Hz", "--log", "begin above 0 Hz, or leave --log out"
        )
    return np.geomspace(first, last, len(values)) if log else values
