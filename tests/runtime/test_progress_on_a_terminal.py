"""Long commands say what they do, on a terminal only, and erase it before they print."""

from __future__ import annotations

import fcntl
import io
import os
import pty
import struct
import subprocess
import sys
import termios
import time
from pathlib import Path

import pytest

from pkmodes.cli import progress, run
from pkmodes.cli.progress import ProgressLine, duration
from pkmodes.support.progress import say, told

ROOT = Path(__file__).resolve().parents[2]
PRINTER, DELTA = str(ROOT / "robots/corexy-printer.toml"), str(ROOT / "robots/linear-delta-2022.toml")
PLANE = "x=0.1:0.2:3,y=0.1:0.2:3"


def on_terminal(*arguments: str, columns: int = 80) -> tuple[str, str]:
    """Run a command with stderr on a terminal; return its standard output, and what the terminal received."""
    ours, theirs = pty.openpty()
    fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
    path = os.pathsep.join(str(ROOT / part) for part in ("src", "generated", "derive"))
    with subprocess.Popen(
        [sys.executable, "-m", "pkmodes", *arguments],
        env={**os.environ, "PYTHONPATH": path},
        stdout=subprocess.PIPE,
        stderr=theirs,
    ) as process:
        os.close(theirs)
        received = b""
        try:
            while part := os.read(ours, 4096):
                received += part
        except OSError:  # the other end is closed
            pass
        assert process.stdout is not None
        printed = process.stdout.read().decode()
    os.close(ours)
    assert process.returncode == 0
    return printed, received.decode()


def visible(received: str) -> list[str]:
    """Return the lines that a terminal shows in the end."""
    lines = []
    for text in received.split("\n"):
        line = ""
        for part in text.split("\r"):
            line = part + line[len(part) :]
        lines.append(line.rstrip())
    return lines


def test_figures_says_which_picture_it_draws_and_erases_it(tmp_path: Path) -> None:
    printed, received = on_terminal("figures", PRINTER, "--out", str(tmp_path / "out"), "--grid", PLANE)
    assert "loading ... " in received
    assert "of 7: " in received
    assert visible(received)[0].startswith("note: workspace holds a sentence instead of a picture: ")
    assert not any(word in line for line in visible(received) for word in ("of 7: ", "loading"))
    assert max(map(len, visible(received))) <= 80
    assert len(printed.splitlines()) == 7
    assert all(Path(line).exists() for line in printed.splitlines())


def test_response_says_that_it_draws_its_report(tmp_path: Path) -> None:
    channels = ("--drives", "held", "--inputs", "force_x", "--outputs", "p_x", "--frequencies", "5:60:12")
    page = str(tmp_path / "page.html")
    _, received = on_terminal("response", PRINTER, "--pose", "0.1,0.1", *channels, "--report", page)
    assert "drawing the report ... " in received
    assert not any("drawing" in line for line in visible(received))


def test_nothing_of_it_reaches_a_pipe(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["figures", PRINTER, "--out", str(tmp_path / "out"), "--grid", PLANE]) == 0
    notes = capsys.readouterr().err
    assert notes.startswith("note: workspace holds a sentence instead of a picture: ")
    assert "\r" not in notes
    assert "\x1b" not in notes
    assert "of 7: " not in notes
    assert run(["map", PRINTER, "--grid", PLANE]) == 0
    assert capsys.readouterr().err == ""


@pytest.mark.parametrize(
    ("arguments", "expected"),
    [
        (
            ["figures", PRINTER, "--out", "OUT", "--grid", PLANE],
            ["computing the modes in the plane", "picture 1 of 7: workspace", "picture 7 of 7: mac"],
        ),
        (["map", PRINTER, "--grid", PLANE], ["0 of 9 poses", "9 of 9 poses"]),
        (
            ["map", PRINTER, "--grid", PLANE, "--report", "OUT.html"],
            ["drawing the report", "picture 2 of 7: frequencies"],
        ),
        (
            ["show", PRINTER, "--pose", "0.15,0.15", "--out", "OUT.html"],
            ["computing the modes over the workspace"],
        ),
        (
            ["shaper", PRINTER, "--grid", PLANE, "--shapers", "zv,mzv"],
            ["computing the modes of the held machine", "shaper 1 of 4: zv", "shaper 4 of 4: mzv"],
        ),
        (["sensitivities", PRINTER, "--pose", "0.15,0.15"], ["differentiating the modes"]),
        (
            ["identify", str(ROOT / "examples/campaign/campaign.toml"), "--out", "OUT.csv"],
            [f"record {number} of 6: P{number}" for number in range(1, 7)],
        ),
    ],
)
@pytest.mark.usefixtures("no_drawing")
def test_each_long_command_says_what_it_does(
    arguments: list[str], expected: list[str], tmp_path: Path
) -> None:
    said: list[str] = []
    with told(said.append):
        assert run([argument.replace("OUT", str(tmp_path / "out")) for argument in arguments]) == 0
    assert [text for text in said if text in expected] == expected, said


def test_generating_and_checking_say_what_they_derive(tmp_path: Path) -> None:
    said: list[str] = []
    with told(said.append):
        assert run(["generate", PRINTER, "--out", str(tmp_path / "model")]) == 0
        assert run(["check", str(tmp_path / "model")]) == 0
    assert said[0] == "deriving the model"
    assert said[1] == f"{tmp_path / 'model'}, 1 of 1: deriving it again"
    assert "comparing derivatives with finite differences" in said


def test_the_line_is_cut_to_the_terminal_and_shows_text_verbatim(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(progress, "DELAY", 0.0)
    monkeypatch.setattr(progress, "STEP", 0.005)
    terminal = io.StringIO()
    line = ProgressLine(terminal, "loading")
    line.say("record 1: [bold]" + "long " * 40 + "\x1b[2J")
    deadline = time.monotonic() + 10.0
    while "record 1: [bold]long" not in terminal.getvalue() and time.monotonic() < deadline:
        time.sleep(0.005)
    line.end()
    received = terminal.getvalue()
    assert "record 1: [bold]long" in received
    assert "\x1b" not in received
    assert max(len(part) for part in received.split("\r")) < 80
    assert visible(received) == [""]


def test_times_are_said_in_words() -> None:
    assert list(map(duration, (0.4, 59.4, 59.6, 200.0, 7500.0))) == [
        *("0 s", "59 s", "1 min 0 s", "3 min 20 s", "2 h 5 min")
    ]


def test_nobody_needs_to_listen() -> None:
    say("nothing")
