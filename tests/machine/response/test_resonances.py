"""The resonance that a response is said to have: a mode by hand, whichever frequencies were chosen, or none."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from pkmodes.cli import run
from pkmodes.machine.response.resonances import strongest_resonance

PRINTER = Path(__file__).parents[3] / "robots/bed-slinger.toml"
POSE = (0.05, 0.1)
#: Tool head and bed, each on the two runs of its own belt, motors held [Hz].
X, Y = (
    float(np.sqrt(6e-3 * 2.6e6 * (1.0 / (near + at) + 1.0 / (far - at)) / mass) / (2.0 * np.pi))
    for near, far, at, mass in ((0.06, 0.68, POSE[0], 0.5), (0.08, 0.66, POSE[1], 1.0))
)
NUMBERS = {"x": 2, "y": 1}
#: Of either frequency, relative: the square root of a stiffness known to 10 % over a mass known to 2 %.
SIGMA = 0.5 * float(np.hypot(0.1, 0.02))


def printed_frequency(frequency: float) -> str:
    return f"{frequency:.1f} +- {SIGMA * frequency:.1f} Hz (from the standard deviations in the robot file)"


def said(
    frequencies: str, *options: str, inputs: str = "force_x,force_y", outputs: str = "p_x,p_y"
) -> list[str]:
    pose = ",".join(map(str, POSE))
    return [
        *("response", str(PRINTER), "--pose", pose, "--inputs", inputs, "--outputs", outputs),
        *("--frequencies", frequencies, "--drives", "held", *options),
    ]


@pytest.mark.parametrize("count", [7, 8, 40, 401])
def test_it_does_not_depend_on_the_frequencies_chosen(
    count: int, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The softer axis, with the heavier mass, moves more per force near its mode than the other one."""
    file = tmp_path / "r.json"
    assert run(said(f"5:200:{count}", "--json", str(file))) == 0
    printed = " ".join(capsys.readouterr().out.split())
    assert X > Y
    assert f"p_y resonates most with force_y in mode 1, at {printed_frequency(Y)}" in printed
    resonance = json.loads(file.read_text(encoding="utf-8"))["resonance"]
    assert (resonance["output"], resonance["input"], resonance["mode"]) == ("p_y", "force_y", 1)
    assert resonance["frequency_hz"] == pytest.approx(Y, rel=1e-6)
    assert resonance["frequency_sigma_hz"] == pytest.approx(SIGMA * Y, rel=1e-6)


def test_a_mode_that_the_channel_does_not_show_is_none(capsys: pytest.CaptureFixture[str]) -> None:
    """Along x only the mode of the tool head shows, although that of the bed is within the frequencies, too."""
    assert run(said("5:200:40", inputs="force_x", outputs="p_x")) == 0
    printed = " ".join(capsys.readouterr().out.split())
    assert f"p_x resonates most with force_x in mode 2, at {printed_frequency(X)}" in printed
    between = 0.5 * (X + Y)
    assert run(said(f"5:{between}:40", inputs="force_x", outputs="p_x")) == 0
    printed = " ".join(capsys.readouterr().out.split())
    assert (
        f"No resonance from 5 to {between:g} Hz: p_x responds most to force_x at {between:.3f} Hz" in printed
    )


def test_where_the_response_begins_is_no_resonance(capsys: pytest.CaptureFixture[str]) -> None:
    """With free motors the machine moves as a rigid body at low frequencies, more than at any resonance."""
    arguments = said("1:400:50", inputs="force_x", outputs="p_x")
    arguments[arguments.index("held")] = "free"
    assert run(arguments) == 0
    printed = " ".join(capsys.readouterr().out.split())
    f = pkmodes.load(PRINTER).modes(list(POSE), drives="free").frequencies[2:]
    head = re.search(r"force_x in mode (\d), at ([\d.]+) \+- [\d.]+ Hz", printed)
    assert head is not None
    decimals = len(head[2].partition(".")[2])
    assert float(head[2]) == pytest.approx(f[int(head[1]) - 1], abs=0.501 * 10.0**-decimals)
    assert "at 1.000 Hz" not in printed.split("Displacement")[0]


@pytest.mark.parametrize("ratio", [0.002, 0.02])
def test_of_damped_modes_the_highest_peak_counts(ratio: float) -> None:
    """Of one mass on a spring with a force on it the peak is 1 / (2 zeta m omega^2), whatever the damping."""
    model = pkmodes.load(PRINTER).with_values({"damping.ratio": ratio})
    response = model.frf(
        POSE, np.linspace(5.0, 200.0, 30), ["force_x", "force_y"], ["p_x", "p_y"], drives="held"
    )
    for axis, f, mass in (("x", X, 0.5), ("y", Y, 1.0)):
        resonance = strongest_resonance(response, [f"p_{axis}/force_{axis}"])
        assert resonance is not None
        assert (resonance.mode, resonance.frequency) == (NUMBERS[axis], pytest.approx(f, rel=1e-6))
        expected = 1.0 / (2.0 * ratio * mass * (2.0 * np.pi * f) ** 2)
        assert resonance.magnitude == pytest.approx(expected, rel=1e-4)
