"""Long commands say what they do, on a terminal only, and erase it before they print."""

from __future__ import annotations

import io
import time
from contextlib import redirect_stderr
from pathlib import Path

import pytest

from pkmodes.cli import progress, run
from pkmodes.cli.progress import ProgressLine, duration
from pkmodes.core.support.progress import report_progress, reporting_to

ROOT = Path(__file__).resolve().parents[2]
PRINTER, DELTA = str(ROOT / "robots/corexy-printer.toml"), str(ROOT / "robots/linear-delta-2022.toml")
PLANE = "x=0.1:0.2:3,y=0.1:0.2:3"


class Terminal(io.StringIO):
    """Keeps what it receives."""

    def isatty(self) -> bool:
        return True


@pytest.fixture
def at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Progress is shown without delay."""
    monkeypatch.setattr(progress, "FIRST_DELAY", 0.0)
    monkeypatch.setattr(progress, "UPDATE_INTERVAL", 0.005)


def visible(received: str) -> list[str]:
    """Return the lines that a terminal shows in the end."""
    lines = []
    for text in received.split("\n"):
        line = ""
        for part in text.split("\r"):
            line = part + line[len(part) :]
        lines.append(line.rstrip())
    return lines


def drawn(*_: object, **__: object) -> bytes:
    """A picture that takes a moment."""
    time.sleep(0.05)
    return b"drawn"


@pytest.mark.usefixtures("at_once")
def test_figures_says_which_picture_it_draws_and_erases_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("pkmodes.pages.figures.files.image_bytes", drawn)
    with redirect_stderr(Terminal()) as terminal:
        assert (
            run(["figures", PRINTER, "--out", str(tmp_path / "out"), "--grid", PLANE, "--drives", "free"])
            == 0
        )
    printed, received = capsys.readouterr().out, terminal.getvalue()
    assert "loading ... " in received
    assert "of 7: " in received
    assert visible(received)[0].startswith("note: workspace is not drawn: ")
    assert not any(word in line for line in visible(received) for word in ("of 7: ", "loading"))
    assert max(map(len, visible(received))) <= 80
    left_out = [line for line in visible(received) if "is not drawn" in line]
    assert len(printed.splitlines()) == 7 - len(left_out)
    assert all(Path(line).exists() for line in printed.splitlines())


def test_nothing_of_it_reaches_a_pipe(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("pkmodes.pages.figures.files.image_bytes", drawn)
    assert run(["figures", PRINTER, "--out", str(tmp_path / "out"), "--grid", PLANE]) == 0
    notes = capsys.readouterr().err
    assert notes.startswith("note: workspace is not drawn: ")
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
            ["computing the modes of the machine in use", "shaper 1 of 4: zv", "shaper 4 of 4: mzv"],
        ),
        (["sensitivities", PRINTER, "--pose", "0.15,0.15"], ["differentiating the modes"]),
        (
            ["response", PRINTER, "--pose", "0.1,0.1", "--drives", "held", "--inputs", "force_x"]
            + ["--outputs", "p_x", "--frequencies", "5:60:12", "--report", "OUT.html"],
            ["computing the responses", "drawing the report", "drawing the report"],
        ),
        (
            ["identify", str(ROOT / "examples/printer/campaign.toml"), "--out", "OUT.csv"],
            ["record 1 of 3: front left", "record 2 of 3: centre", "record 3 of 3: rear right"],
        ),
    ],
)
@pytest.mark.usefixtures("no_drawing")
def test_each_long_command_says_what_it_does(
    arguments: list[str], expected: list[str], tmp_path: Path
) -> None:
    said: list[str] = []
    with reporting_to(said.append):
        assert run([argument.replace("OUT", str(tmp_path / "out")) for argument in arguments]) == 0
    assert [text for text in said if text in expected] == expected, said


def test_generating_and_checking_say_what_they_derive(tmp_path: Path) -> None:
    said: list[str] = []
    with reporting_to(said.append):
        assert run(["generate", PRINTER, "--out", str(tmp_path / "model")]) == 0
        assert run(["check", str(tmp_path / "model")]) == 0
    assert said[0] == "deriving the model"
    assert said[1] == f"{tmp_path / 'model'}, 1 of 1: deriving it again"
    assert "comparing derivatives with finite differences" in said


@pytest.mark.usefixtures("at_once")
def test_the_line_is_cut_to_the_terminal_and_shows_text_verbatim() -> None:
    terminal = Terminal()
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
    report_progress("nothing")
