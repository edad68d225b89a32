"""Measured responses from a campaign file: the functions of its files, under the names of the model."""

from __future__ import annotations

import shutil
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.pages.page_reading import read
from pkmodes.cli import run
from pkmodes.core.base.errors import PkmodesError
from pkmodes.machine.response.campaign_responses import campaign_response

ROOT = Path(__file__).parents[3]
ROBOT = ROOT / "robots/linear-delta-2022.toml"
POSE = [0.6, 0.05, -0.245]
F = np.arange(5.0, 80.0, 0.25)
HEAD = 'format = 1\nrobot = "robot.toml"\nband = ["6 Hz", "70 Hz"]\ndrives = "held"\n'
AT = 'at = { x = "600 mm", y = "50 mm", z = "-245 mm" }\n'
RECORD = f'[[record]]\npose = "P1"\n{AT}kind = "frf"\nfiles = ["a.csv"]\n'


def sensor(name: str, place: str) -> str:
    return f'[[sensor]]\nname = "{name}"\n{place}\nunit = "m/s^2"\n'


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """The model's own accelerances for a force against x, in the names of an analyser, one sensor upside down."""
    shutil.copy(ROBOT, tmp_path / "robot.toml")
    model = pkmodes.load(ROBOT).with_values({"damping.ratio": 0.02})
    found = model.frf(POSE, F, ["force_x"], ["p_x", "p_y"], drives="held", quantity="acceleration")
    columns = [F]
    for values, sign in ((found.values[:, 0, 0], -1.0), (found.values[:, 1, 0], 1.0)):
        columns += [-sign * values.real, -sign * values.imag]
    header = "frequency,re:a1/hammer,im:a1/hammer,re:a2/hammer,im:a2/hammer"
    np.savetxt(
        tmp_path / "a.csv", np.column_stack(columns), delimiter=",", header=header, comments="", fmt="%.17g"
    )
    return tmp_path


def campaign(folder: Path, force: str) -> Path:
    text = HEAD + sensor("a1", 'channel = "-p_x"') + sensor("a2", 'channel = "p_y"') + force + RECORD
    (folder / "c.toml").write_text(text, encoding="utf-8")
    return folder / "c.toml"


@pytest.mark.parametrize("quantity", ["acceleration", "velocity", "displacement"])
def test_its_names_signs_and_quantity_are_those_of_the_model(folder: Path, quantity: str) -> None:
    path = campaign(folder, '[[force]]\nname = "hammer"\nchannel = "-p_x"\n')
    measured = campaign_response(path, POSE, quantity)
    model = pkmodes.load(ROBOT).with_values({"damping.ratio": 0.02})
    expected = model.frf(POSE, F, ["force_x"], ["p_x", "p_y"], drives="held", quantity=quantity)
    assert set(measured.channels) == {"p_x/force_x", "p_y/force_x"}
    assert measured.notes == ()
    for k, name in enumerate(("p_x/force_x", "p_y/force_x")):
        inside = np.isin(F, measured.frequencies)
        np.testing.assert_allclose(measured.channels[name], expected.values[inside, k, 0], rtol=1e-9)


def test_a_force_without_a_place_is_the_only_input_and_that_is_said(folder: Path) -> None:
    path = campaign(folder, "")
    with pytest.raises(PkmodesError, match='does not say where the force "hammer" acts'):
        campaign_response(path, POSE, "acceleration", ["force_x", "force_y"])
    measured = campaign_response(path, POSE, "acceleration", ["force_x"])
    assert "it is taken as force_x at the platform's centre" in measured.notes[0]
    with pytest.raises(PkmodesError, match=r"found those at P1 \(0.6,0.05,-0.245\)"):
        campaign_response(path, [0.5, 0.0, -0.245], "acceleration", ["force_x"])


def test_the_page_draws_them_over_the_model(folder: Path) -> None:
    path = campaign(folder, '[[force]]\nname = "hammer"\nchannel = "-p_x"\n')
    page = folder / "page.html"
    command = ["response", str(ROBOT), "--pose", "0.6,0.05,-0.245", "--drives", "held", "--inputs", "force_x"]
    command += ["--outputs", "p_x,p_y", "--quantity", "acceleration", "--frequencies", "10:60:20"]
    assert run([*command, "--measured", str(path), "--report", str(page)]) == 0
    assert "Broad lines are measured" in read(page.read_text(encoding="utf-8")).by_id("responses").text


def test_an_oblique_force_is_no_input_of_the_command_and_the_error_names_the_page_that_draws_it(
    folder: Path,
) -> None:
    path = campaign(folder, '[[force]]\nname = "hammer"\ndirection = [0.6, 0.8, 0]\nfixed = true\n')
    with pytest.raises(PkmodesError, match=r'found "hammer" along several.*pkmodes diagnose with --campaign'):
        campaign_response(path, POSE, "acceleration", ["force_x"])
