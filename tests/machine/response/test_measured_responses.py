"""Measured responses over those of the model: what is read, drawn and refused."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import pkmodes
from pkmodes.cli import run
from pkmodes.core.base.errors import MeasurementError, PkmodesError
from pkmodes.machine.response.frequency_response import FrequencyResponse
from pkmodes.pages.figures import read_response, response_picture

ROOT = Path(__file__).parents[3]
ROBOT = ROOT / "robots/linear-delta-2022.toml"
POSE = [0.6, 0.05, -0.245]
HEADER = "frequency,re:p_x/force_x,im:p_x/force_x"


def response() -> FrequencyResponse:
    model = pkmodes.load(ROBOT).with_values({"damping.ratio": 0.02})
    return model.frf(POSE, np.linspace(5, 60, 56), ["force_x"], ["p_x", "p_y"], drives="held")


def test_what_is_written_is_read_back(tmp_path: Path) -> None:
    found = response()
    found.to_csv(tmp_path / "r.csv")
    read = read_response(tmp_path / "r.csv")
    np.testing.assert_array_equal(read.frequencies, found.frequencies)
    assert list(read.channels) == ["p_x/force_x", "p_y/force_x"]
    np.testing.assert_array_equal(read.channels["p_y/force_x"], found.values[:, 1, 0])


def test_measured_curves_lie_over_those_of_the_model(tmp_path: Path) -> None:
    found = response()
    table = tmp_path / "m.csv"
    table.write_text(
        "# hammer\nfreq,coh:p_y,re:p_y/force_x,im:p_y/force_x\n10,1,1e-6,2e-6\n20,1,3e-6,-1e-6\n"
    )
    picture = response_picture(found, read_response(table))
    assert "with measured responses" in picture.description
    panels = [axes for axes in picture.figure.axes if axes.get_title("left")]
    assert [axes.get_title("left") for axes in panels] == ["p_y/force_x", "p_x/force_x"]
    model, measured = panels[0].lines
    np.testing.assert_allclose(model.get_ydata(), np.abs(found.values[:, 1, 0]))
    np.testing.assert_allclose(measured.get_xdata(), [10.0, 20.0])
    np.testing.assert_allclose(measured.get_ydata(), np.hypot([1e-6, 3e-6], [2e-6, 1e-6]))
    assert len(panels[1].lines) == 1


def test_the_robot_before_a_correction_is_drawn_between_both(tmp_path: Path) -> None:
    found, declared = response(), pkmodes.load(ROBOT).with_values({"damping.ratio": 0.05})
    before = declared.frf(POSE, np.linspace(5, 60, 56), ["force_x"], ["p_x", "p_y"], drives="held")
    found.to_csv(tmp_path / "m.csv")
    picture = response_picture(found, read_response(tmp_path / "m.csv"), before=before)
    above = next(axes for axes in picture.figure.axes if axes.get_title("left") == "p_y/force_x")
    lines = {line.get_label(): np.asarray(line.get_ydata()) for line in above.lines}
    assert list(lines) == ["after", "before", "measured"]
    np.testing.assert_allclose(lines["before"], np.abs(before.values[:, 1, 0]))
    np.testing.assert_allclose(lines["after"], lines["measured"])
    assert lines["before"].max() < 0.5 * lines["after"].max()


def test_the_command_writes_a_picture(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    response().to_csv(tmp_path / "m.csv")
    arguments = [
        "response",
        str(ROBOT),
        "--pose",
        "0.6,0.05,-0.245",
        "--drives",
        "held",
        "--inputs",
        "force_x",
    ]
    arguments += ["--outputs", "p_x", "--frequencies", "5:60:40"]
    for suffix, begin in ((".svg", b"<?xml"), (".png", b"\x89PNG"), (".pdf", b"%PDF")):
        file = tmp_path / f"r{suffix}"
        assert run([*arguments, "--figure", str(file), "--measured", str(tmp_path / "m.csv")]) == 0
        assert file.read_bytes().startswith(begin)
    capsys.readouterr()
    for wrong, message in (
        (
            ["--measured", str(tmp_path / "m.csv")],
            "--measured is for the picture and the report, which are not written (--measured)",
        ),
        (
            ["--before", str(ROBOT)],
            "--before is for the picture and the report, which are not written (--before)",
        ),
        (
            ["--before", str(ROOT / "robots/corexy-printer.toml"), "--figure", str(tmp_path / "x.svg")],
            "expected a linear_delta like the robot that is drawn, found a corexy",
        ),
        (["--figure", str(tmp_path / "r.jpg")], "expected a name that ends in .svg or .png or .pdf"),
        (["--figure", str(tmp_path / "x.svg"), "--measured", str(tmp_path / "none.csv")], "none.csv"),
    ):
        assert run([*arguments, *wrong]) == 2
        assert message in " ".join(capsys.readouterr().err.split())
    assert not (tmp_path / "x.svg").exists()


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "found an empty file"),
        (HEADER, "rows, found"),
        (
            "g,re:a/b,im:a/b\n1,2,3\n2,2,3",
            'expected a column of times or frequencies, found "g", "re:a/b", "im:a/b"',
        ),
        ("frequency,re:a/b\n1,2\n2,2", 'expected one column "re:a/b" and one "im:a/b"'),
        ("frequency,x\n1,2\n2,2", "expected frequency response functions, found none"),
        (f"{HEADER}\n1,2,3\n2,2", "line 3"),
        (f"{HEADER}\n1,2,nan\n2,2,3", 'found "nan"'),
        (f"{HEADER}\n2,2,3\n1,2,3", "expected ascending values, found 1 after 2"),
    ],
)
def test_bad_tables_are_refused_with_file_and_line(text: str, message: str, tmp_path: Path) -> None:
    file = tmp_path / "m.csv"
    file.write_text(text, encoding="utf-8")
    with pytest.raises(MeasurementError) as error:
        read_response(file)
    assert message in str(error.value)
    assert "m.csv" in str(error.value)


def test_a_table_without_a_channel_of_the_response_is_refused(tmp_path: Path) -> None:
    file = tmp_path / "m.csv"
    file.write_text("frequency,re:p_z/force_x,im:p_z/force_x\n1,2,3\n2,2,3\n", encoding="utf-8")
    with pytest.raises(PkmodesError) as error:
        response_picture(response(), read_response(file))
    assert "expected a channel of p_x/force_x, p_y/force_x, found p_z/force_x" in str(error.value)


@pytest.mark.parametrize(
    ("line", "message"),
    [
        (
            "# unit: p_x/force_x = mm/N",
            'expected unit p_x/force_x m/N as in the model\'s response, found "mm/N"',
        ),
        ("# quantity: acceleration,,", "expected quantity displacement"),
        ("# Drives: free", 'expected drives held as in the model\'s response, found "free"'),
    ],
)
def test_a_table_that_says_that_it_is_of_something_else_is_refused(
    tmp_path: Path, line: str, message: str
) -> None:
    table = tmp_path / "m.csv"
    table.write_text(f"{line}\n{HEADER}\n10,1e-6,2e-6\n20,3e-6,-1e-6\n", encoding="utf-8")
    with pytest.raises(PkmodesError) as error:
        response_picture(response(), read_response(table))
    assert message in str(error.value)
    assert str(table) in str(error.value)


def test_labels_are_read_without_formulas_and_channels_without_response_are_named() -> None:
    """Figures parse no formulas: matplotlib's own labels of logarithmic axes would stand as they are."""
    model = pkmodes.load(ROBOT).with_values({"damping.ratio": 0.02})
    f = np.geomspace(5.0, 400.0, 300)
    found = model.frf([0.6, 0.0, -0.245], f, ["force_x"], ["p_x", "p_y"], drives="held")
    picture = response_picture(found)
    picture.figure.canvas.draw()
    texts = [
        t.get_text()
        for axes in picture.figure.axes
        for t in (*axes.get_xticklabels(which="both"), *axes.get_yticklabels(which="both"))
    ]
    assert not [text for text in texts if "$" in text]
    assert {"10", "100", "200"} <= set(texts)
    assert "10\u207b\u2075" in texts
    assert "No response in p_y/force_x." in picture.description
    assert picture.figure.axes[0].get_title("left") == "p_x/force_x"


@pytest.mark.filterwarnings("error")
def test_one_frequency_is_a_point() -> None:
    model = pkmodes.load(ROBOT).with_values({"damping.ratio": 0.02})
    picture = response_picture(model.frf(POSE, [30.0], ["force_x"], ["p_x"], drives="held"))
    assert picture.figure.axes[0].lines[0].get_marker() == "."
