"""The files of ``pkmodes figures``: complete, the same at every run, with units on every axis."""

from __future__ import annotations

import json
import re
from importlib import import_module
from io import BytesIO
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import pkmodes
from pkmodes.cli import run
from pkmodes.pages.figures.files import write_pictures
from pkmodes.pages.figures.pictures import PICTURES, pictures

NAMES = ["workspace", "frequencies", "directions", "components", "influence", "dominant", "mac"]
#: What only this figure says.
SAYS = {
    "workspace": "condition number [1]",
    "frequencies": "f [Hz]",
    "components": "mass-normalised motion",
    "influence": "d ln f / d ln p, median over the plane [1]",
    "dominant": "largest |d ln f / d ln p| of",
    "mac": "smallest MAC with a neighbouring pose [1]",
}
#: A small plane of each robot.
PLANES = {
    "linear-delta-2022": "x=0.25:0.9:14,y=-0.1:0.1:9,z=-0.245",
    "clavel-delta": "x=-0.4:0.4:9,y=-0.4:0.4:9,z=-0.6",
    "corexy-printer": "x=0.01:0.29:8,y=0.01:0.29:8",
}


#: What the printer's figures say instead of a picture.
SAME = {"workspace": "The condition number of the platform Jacobian is 1 at every pose."}


@pytest.mark.parametrize("robot", PLANES)
def test_every_robot_has_its_figures(robot: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder, json_file = tmp_path / "new" / "figures", tmp_path / "figures.json"
    arguments = ["--out", str(folder), "--grid", PLANES[robot], "--json", str(json_file)]
    assert run(["figures", f"robots/{robot}.toml", *arguments]) == 0
    printed, notes = capsys.readouterr()
    said = dict(re.findall(r"^note: (\w+) is not drawn: (.*)$", notes, re.M))
    files = [f"{name}.svg" for name in NAMES if name not in said]
    assert sorted(path.name for path in folder.iterdir()) == sorted(files)
    assert printed.split() == [str(folder / file) for file in files]
    found = json.loads(json_file.read_text())
    assert (found["files"], said.keys()) == (files, found["same_everywhere"].keys())
    # The printer's condition number is the same everywhere.
    assert bool(said) == (robot == "corexy-printer")
    assert not said or SAME.items() <= found["same_everywhere"].items()
    state = f"{robot}, motors {pkmodes.read_robot(f'robots/{robot}.toml').drives}"
    for name in [name for name in NAMES if name not in said]:
        text = (folder / f"{name}.svg").read_text(encoding="utf-8")
        words = " ".join(re.findall(r"<text[^>]*>([^<]*)</text>", text))
        assert state in words, name
        assert state in text.partition("<g id=")[0], name  # its metadata
        if name != "influence":
            assert "x [mm]" in words, name
            assert "y [mm]" in words, name
        if name not in ("workspace",):
            assert "mode 1" in words, name
        assert [one for one, said in SAYS.items() if said in words] == [name] * (name in SAYS), name
    words = (folder / "frequencies.svg").read_text(encoding="utf-8")
    modes = len(pkmodes.load(f"robots/{robot}.toml").coordinates) - (2 if robot == "corexy-printer" else 3)
    assert words.count("f [Hz]") >= modes


def test_a_picture_that_is_no_longer_drawn_does_not_stay_from_an_earlier_run(tmp_path: Path) -> None:
    """In its place a sentence is printed; a file that is something else stays."""
    model = pkmodes.load("robots/corexy-printer.toml")
    grid = {"x": np.linspace(0.01, 0.29, 6), "y": np.linspace(0.01, 0.29, 6)}
    (tmp_path / "workspace.svg").write_text("<svg>Working plane and condition number</svg>")
    (tmp_path / "dominant.pdf").write_text("mine")
    names = [path.name for path in write_pictures(model, tmp_path, grid)]
    assert "workspace.svg" not in names
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted([*names, "dominant.pdf"])


def test_a_notebook_shows_the_sentence_for_what_is_the_same_everywhere() -> None:
    grid = {"x": np.linspace(0.01, 0.29, 6), "y": np.linspace(0.01, 0.29, 6)}
    first = next(pictures(pkmodes.load("robots/corexy-printer.toml"), grid))
    assert first.instead == SAME["workspace"]
    shown = first._repr_html_()
    assert f"<p>{first.instead}</p>" in shown
    assert "<svg" not in shown


def written(folder: Path, *formats: str) -> dict[str, bytes]:
    """Write the figures of the rotary delta with held motors; return what is in the files."""
    grid = {"x": np.linspace(-0.4, 0.4, 6), "y": np.linspace(-0.4, 0.4, 6), "z": -0.6}
    model = pkmodes.load("robots/clavel-delta.toml")
    return {
        path.name: path.read_bytes() for path in write_pictures(model, folder, grid, formats, drives="held")
    }


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    return written(tmp_path_factory.mktemp("figures"), "svg", "png", "pdf")


def test_figures_are_the_same_at_every_run(
    files: dict[str, bytes], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As SVG all of them; as PNG and PDF, which could have the time in their metadata, the first."""
    again = written(tmp_path, "svg")
    monkeypatch.setattr(import_module("pkmodes.pages.figures.pictures"), "PICTURES", PICTURES[:1])
    again |= written(tmp_path, "svg", "png", "pdf")
    assert (len(files), len(again)) == (3 * len(NAMES), len(NAMES) + 2)
    for name, content in again.items():
        assert content == files[name], name
    assert min(map(len, files.values())) > 1_500


def test_a_file_says_what_it_shows_below_everything_and_in_its_metadata(files: dict[str, bytes]) -> None:
    """The line stands below the legend, which follows the edge of the figure."""
    about = "clavel-delta, motors held, z = \N{MINUS SIGN}600 mm"
    for name, content in files.items():
        if name.endswith(".svg"):
            placed = [
                (float(y), text)
                for y, text in re.findall(
                    r"<text[^>]*?(?:y=\"|translate\([-\d.]+ )([-\d.]+)[^>]*>([^<]+)</text>",
                    content.decode("utf-8"),
                )
            ]
            assert max(placed)[1] == about, name
        elif name.endswith(".png"):
            with Image.open(BytesIO(content)) as image:
                assert about in image.info["Description"]
                assert image.info["Title"]
        else:
            assert b"/Subject" in content


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (
            ["--grid", "x=0.3:0.8:5,y=0,z=-0.245"],
            "found z: 1, y: 1, x: 5 (--grid); give several values for two of x, y, z",
        ),
        (
            ["--grid", "x=3:8:5,y=-0.1:0.1:5,z=-0.245"],
            "m too short (--grid); the workspace lies within x from 0.0",
        ),
        (["--grid", "x=300:800:5,y=-0.1:0.1:5,z=-0.245"], "the numbers look like millimetres"),
        (["--grid", "x=0.8:0.3:5,y=-0.1:0.1:5,z=-0.245"], "the range is reversed"),
        (["--grid", "x=0.3:0.8:5,y=-0.1:0.1:5"], "the grid gives no values of z"),
        (["--format", "gif"], "'gif' is not one of 'svg', 'png', 'pdf'"),
    ],
)
def test_bad_input_is_one_line_and_writes_nothing(
    options: list[str], message: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = tmp_path / "figures"
    assert run(["figures", "robots/linear-delta-2022.toml", "--out", str(folder), *options]) == 2
    err = capsys.readouterr().err
    assert message in err
    assert err.startswith("error: ")
    assert err.count("\n") == 1
    assert not folder.exists()


def test_a_file_in_place_of_the_folder_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    place = tmp_path / "figures"
    place.write_text("mine")
    assert run(["figures", "robots/linear-delta-2022.toml", "--out", str(place)]) == 2
    assert "expected the name of a folder" in capsys.readouterr().err
    assert place.read_text() == "mine"
