"""examples/loose_rail: one thing at one place that no catalogue has is found, saved, derived and gone."""

from __future__ import annotations

import shlex
import tomllib
from pathlib import Path

import numpy as np
import pytest

from helpers.commands.own_folder import inside
from helpers.diagnoses import loose_rail_example
from helpers.pages.documentation import ROOT, blocks, same
from pkmodes.cli import run

ROBOT, MEASURED = (loose_rail_example.FOLDER / name for name in ("robot.toml", "measured.csv"))


def test_the_files_are_those_of_the_rig() -> None:
    assert ROBOT.read_text(encoding="utf-8") == loose_rail_example.robot_text()
    written = [
        line.split(",") for line in MEASURED.read_text(encoding="utf-8").splitlines() if line[0] == "P"
    ]
    again = [line.split(",") for line in loose_rail_example.measured_text().splitlines() if line[0] == "P"]
    assert [row[0] for row in written] == [row[0] for row in again]
    frequencies = np.array([[float(row[4]) for row in rows] for rows in (written, again)])
    np.testing.assert_allclose(frequencies[0], frequencies[1], rtol=1e-6)


@pytest.mark.slow
def test_the_page_leads_to_a_machine_that_lacks_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "examples").symlink_to(ROOT / "examples", target_is_directory=True)
    # A library for a machine of one's own takes a minute to build.
    monkeypatch.setenv("PKMODES_BACKEND", "numpy")
    with inside(tmp_path):
        follow(capsys)


def follow(capsys: pytest.CaptureFixture[str]) -> None:
    """Run the page, and change the effect afterwards."""
    printed = []
    for block in blocks("docs/how-to/an-effect-of-your-own.md"):
        if block.language == "sh":
            (words,) = (shlex.split(line) for line in block.text.replace("\\\n", " ").splitlines())
            assert run(words[1:]) == 0, capsys.readouterr().err
            printed.append(capsys.readouterr().out)
        elif block.language == "text":
            same(block.text, printed[-1], fit=True, shortened=True)
        elif block.language == "python":
            assert block.text.strip() in Path("loose_rail.py").read_text(encoding="utf-8")
    assert "worn-delta: unexplained" in printed[0]
    assert "after: with what was found beyond the catalogue" in printed[0]
    # The values in the terminal are those of the saved file, not of the fit without the effect.
    saved_mass = tomllib.loads(Path("worn-delta.toml").read_text(encoding="utf-8"))["platform"]["mass"][
        "value"
    ]
    (mass_line,) = (line for line in printed[0].splitlines() if line.startswith("platform.mass"))
    assert float(mass_line.split()[2]) == pytest.approx(float(saved_mass.split()[0]), abs=1e-4)
    with Path("worn-delta.toml").open("rb") as file:
        effect = tomllib.load(file)["effects"]["mount_carriage_2_y"]["compliance"]
    value, sigma = (float(effect[key].split()[0]) for key in ("value", "sigma"))
    assert abs(value - loose_rail_example.COMPLIANCE) < 3.0 * sigma
    assert "worn-delta: adequate" in printed[-1]
    folder = Path("worn-delta/linear_delta")
    assert run(["check", str(folder)]) == 0
    text = Path("loose_rail.py").read_text(encoding="utf-8")
    Path("loose_rail.py").write_text(text.replace('along="y"', 'along="z"'), encoding="utf-8")
    assert run(["check", str(folder)]) == 1
    assert "the effect changed: loose_rail.py differs" in capsys.readouterr().out


def test_without_a_class_nothing_is_written(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    target = tmp_path / "effect.py"
    loop = loose_rail_example.FOLDER.parent / "closed_loop"
    files = [str(loop / name) for name in ("robot.toml", "measured.csv")]
    words = ["diagnose", *files, "--candidates", "gearbox_compliance", "--save-effect", str(target)]
    assert run(words) == 2
    assert "there is nothing beyond the catalogue to write: terms were not tried" in capsys.readouterr().err
    assert not target.exists()
