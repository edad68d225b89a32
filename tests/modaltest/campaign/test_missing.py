"""Sensors, degrees of freedom and references of a campaign that files lack: refused, or said."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from scipy.io import savemat

from modaltest.campaign.structures import CHANNELS, HEAD, Frame, identify, record, refused, sensors, write_frf
from modaltest.campaign.test_impact_campaigns import STEP, write_blows
from modaltest.campaign.test_universal_quotients import STEP as LINE
from modaltest.campaign.test_universal_quotients import accelerances
from modaltest.signals.universal import dataset58b, frf58, packed
from pkmodes.loop.measured.reading import read_modes

F = np.arange(10.0, 220.0, 0.25)
FREQUENCIES = Frame.build().modes()[0]
ALL = sensors("m/s^2", "m/s^2", "m/s^2")
#: A sensor of the third floor, as universal files name it.
THIRD = '[[sensor]]\nname = "3:+Z"\nchannel = "floor_3"\n'


def write(path: Path, kind: str, *floors: int, seed: int = 1) -> None:
    """Write functions by a force on the third floor: a table, a MATLAB file, or a universal file; or modes."""
    H = {f"a{k}": Frame.build().accelerances(F)[:, k - 1, 2] for k in floors}
    rng = np.random.default_rng(seed)
    if kind == "table":
        write_frf(path, F, H, 0.01, rng)
    elif kind == "array":
        noisy = {name: h * (1.0 + 0.001 * rng.normal(size=len(F))) for name, h in H.items()}
        savemat(path, {"frequency": F, **noisy})
    else:
        of_floors = accelerances()
        parts = [frf58(of_floors[:, k - 1], LINE, response=(k, 3), reference=(3, 3)) for k in floors]
        path.write_bytes(b"".join(parts))


MISTAKES = {"table": ("a1", "b1"), "array": ("a2", "mast"), "universal": ("2:+Z", "2:+X")}


@pytest.mark.parametrize("kind", MISTAKES)
def test_a_sensor_that_is_in_no_file_is_refused_with_what_they_have(tmp_path: Path, kind: str) -> None:
    right, wrong = MISTAKES[kind]
    for pose in ("p", "q"):
        write(tmp_path / f"{pose}.{'mat' if kind == 'array' else 'x'}", kind, 1, 2, 3)
    known = ALL if kind != "universal" else "".join(THIRD.replace("3", str(k)) for k in (1, 2, 3))
    files = [f"{pose}.{'mat' if kind == 'array' else 'x'}" for pose in "pq"]
    text = HEAD + known + record("frf", files[0]) + record("frf", files[1], pose="P2")
    assert "none of its files" not in identify(tmp_path, text).remarks
    names = ", ".join(f'"{k}:+Z"' if kind == "universal" else f'"a{k}"' for k in (1, 2, 3))
    number = right.strip("a:+Z")
    said = refused(tmp_path, text.replace(f'name = "{right}"', f'name = "{wrong}"'))
    assert (
        f'expected the sensor "{wrong}" in a file, found {names} in those of P1 (c.toml: sensor.{number}.name)'
        in said
    )


def test_what_only_some_files_lack_is_said_and_blank(tmp_path: Path) -> None:
    write(tmp_path / "p0.x", "table", 1, 2, 3)
    write(tmp_path / "p1.x", "table", 1, 3, seed=2)
    write(tmp_path / "q.x", "table", 1, 3, seed=3)
    found = identify(tmp_path, HEAD + ALL + record("frf", "p0.x", "p1.x") + record("frf", "q.x", pose="P2"))
    first, second = (one["messages"] for one in found.document["records"])
    assert first == ['p1.x: it lacks the sensor "a2", which its repeats have']
    assert 'P2: none of its files has the sensor "a2" of the campaign' in second
    shapes = read_modes(found.file, CHANNELS).shapes
    assert np.isfinite(shapes[:3]).all()
    assert np.isnan(shapes[3:, 1]).all()
    assert np.isfinite(shapes[3:, [0, 2]]).all()


def test_a_file_left_out_may_have_what_the_others_lack(tmp_path: Path) -> None:
    write(tmp_path / "p.x", "table", 1, 3)
    (tmp_path / "q.x").write_text("nothing")
    text = HEAD + ALL + record("frf", "p.x") + record("frf", "q.x", pose="P2")
    found = identify(tmp_path, text, "--keep-going")
    assert 'P1: none of its files has the sensor "a2" of the campaign' in found.remarks


def test_a_spectrum_and_modes_of_another_program_have_the_sensors_of_the_campaign(tmp_path: Path) -> None:
    power = np.abs(Frame.build().accelerances(np.arange(5.0, 250.0, 1.0))[:, 2, 2]) ** 2
    np.savetxt(
        tmp_path / "k.csv",
        np.column_stack([np.arange(5.0, 250.0, 1.0), power]),
        delimiter=",",
        header="freq,psd_x",
        comments="",
    )
    x, y = (f'[[sensor]]\nname = "{name}"\nchannel = "none"\n' for name in "xy")
    identify(tmp_path, HEAD + x + record("spectrum", "k.csv"))
    said = refused(tmp_path, HEAD + x + y + record("spectrum", "k.csv"))
    assert 'expected the sensor "y" in a file, found "x" in those of P1' in said
    (tmp_path / "m.csv").write_text("frequency,sigma\n50,0.1\n")
    assert identify(tmp_path, HEAD + ALL + record("modes", "m.csv")).record[
        "modes"
    ]  # a table needs no sensors


def forces(*numbers: int) -> str:
    return "".join(f'[[force]]\nname = "{k}:+Z"\nchannel = "floor_{min(k, 3)}"\n' for k in numbers)


def setups(kind: str) -> str:
    files = ", ".join(f'"at {k}" = {json.dumps([f"{kind}{k}.uff"])}' for k in (1, 2, 3))
    return f'[[record]]\npose = "P1"\nkind = "{kind}"\nfiles = {{ {files} }}\n'


@pytest.fixture
def roved(tmp_path: Path) -> Path:
    """A sensor on the third floor, and a hammer on each floor in turn: in time, and as functions."""
    rng = np.random.default_rng(31)
    for k in (1, 2, 3):
        write_blows(tmp_path / "b.csv", rng, floor=k - 1)
        _, force, _, _, a3 = np.loadtxt(tmp_path / "b.csv", delimiter=",", skiprows=1).T
        blow = [
            dataset58b(packed(one, "d"), ordinate=4, count=len(one), step=STEP, response=dof, quantity=of)
            for one, dof, of in ((force, (k, 3), (13, "N")), (a3, (3, 3), (12, "m/s^2")))
        ]
        (tmp_path / f"impact{k}.uff").write_bytes(b"".join(blow))
        H = accelerances()[:, k - 1]
        (tmp_path / f"frf{k}.uff").write_bytes(frf58(H, LINE, response=(3, 3), reference=(k, 3)))
    return tmp_path


@pytest.mark.parametrize("kind", ["impact", "frf"])
def test_forces_and_references_of_a_roving_hammer(roved: Path, kind: str) -> None:
    """Each file has one of them: that is no lack; but the campaign names all, and no other."""
    all_named = identify(roved, HEAD + THIRD + forces(1, 2, 3) + setups(kind))
    assert "[[force]]" not in all_named.remarks
    assert "none of its files" not in all_named.remarks
    said = refused(roved, HEAD + THIRD + forces(1, 2, 3, 7) + setups(kind))
    assert (
        'expected the force "7:+Z" in a file, found "1:+Z", "2:+Z", "3:+Z" in those of P1 (c.toml: force.4.name)'
        in said
    )
    said = identify(roved, HEAD + THIRD + setups(kind)).remarks
    assert "P1: no [[force]] names the references 1:+Z, 2:+Z, 3:+Z" in said
