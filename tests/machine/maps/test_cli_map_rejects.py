"""Bad input of ``pkmodes map``: one clear line on stderr, exit code 2, and nothing written."""

from __future__ import annotations

from pathlib import Path

import pytest

from helpers.commands.answers import refused
from helpers.robots.robot_text import PUBLISHED, published

ROBOT = str(PUBLISHED)
GRID = "x=0.3:0.8:5,y=0,z=-0.245"


@pytest.mark.parametrize(
    ("grid", "said"),
    [
        ("x=5:6:3,y=0,z=-0.245", "none of the 3 poses of the map can be evaluated; the first: "),
        ("x=300:800:3,y=0,z=-245", "the numbers look like millimetres: write them with their unit"),
        ("x=0.8:0.3:5,y=0,z=-0.245", "the range is reversed: it ends below its start"),
        ("x=0.3:0.3:5,y=0,z=-0.245", "expected one value from 0.3 to 0.3, found 5"),
        ("x=0.3:0.8:0,y=0,z=-0.245", 'expected a count from 1 to 1,000,000, found "0"'),
        ("x=0.3:0.8:1,y=0,z=-0.245", "expected several values from 0.3 to 0.8, found 1"),
        ("x=0.3:0.8:-3,y=0,z=-0.245", "expected a count"),
        ("x=0.3:0.8:2.5,y=0,z=-0.245", "expected a count"),
        ("x=0.3:0.8:1e3,y=0,z=-0.245", "expected a count"),
        ("x=0.3:0.8,y=0,z=-0.245", "expected start:stop:count or one value"),
        ("x=a:b:3,y=0,z=-0.245", "--grid x=a:b:3"),
        ("x=0.3 kg:0.8:3,y=0,z=-0.245", "--grid x="),
        ("x=nan,y=0,z=-0.245", "expected a finite number"),
        ("x=0.3:inf:3,y=0,z=-0.245", "expected a finite number"),
        ("x=0.3:0.8:3,y=0", "the grid gives no values of z"),
        ("x=0.3:0.8:3", "the grid gives no values of y and z"),
        ("x=0.3,y=0,z=-0.245,w=1", 'expected x=..., y=..., z=..., found "w=1"'),
        ("x=0.3,x=0.4,y=0,z=-0.245", "x is given twice"),
        ("", "expected x=..."),
        ("x=0,3:0,8:5,y=0,z=-0,245", "decimals with a point"),
        ("x=300 MM:0.8:5,y=0,z=-0.245", 'write "300 mm"'),
        ("0.3,0,-0.245", "expected x=..."),
    ],
)
def test_grids(tmp_path: Path, grid: str, said: str) -> None:
    assert said in refused("map", ROBOT, "--grid", grid, "--out", str(tmp_path / "map.nc"))
    assert list(tmp_path.iterdir()) == []


def test_a_grid_wholly_outside_is_told_where_the_workspace_is() -> None:
    err = refused("map", ROBOT, "--grid", "x=5:6:3,y=0,z=-0.245")
    assert "the workspace lies within x from 0." in err


@pytest.mark.parametrize(
    ("setting", "said"),
    [
        ("platform.mas=1:2:3", 'unknown parameter path "platform.mas"'),
        ("platform.mass", 'expected PATH=VALUES, found "platform.mass"'),
        ("platform.mass=", "expected PATH=VALUES"),
        ("=1:2:3", "expected PATH=VALUES"),
        ("platform.mass=1,5kg", "write 1 kg,5 kg for two values, 1.5 kg for one"),
        ("platform.mass=0:1,5 kg:3", "write 1 kg,5 kg for two values, 1.5 kg for one"),
        ("platform.mass=300gr", 'write "300 g"'),
        ("platform.mass=2:1:3", "the range is reversed"),
        ("platform.mass=1 m:2 m:3", "--set platform.mass"),
        ("platform.mass=-1:1:3", "platform.mass"),
        ("platform.mass=1,1", "the value 1 is repeated"),
        ("axis.1.direction=1", "axis.1.direction"),
        ("gravity=1:2:3", "gravity"),
        ("effects.nonsense.size=1", "unknown parameter path"),
    ],
)
def test_settings(tmp_path: Path, setting: str, said: str) -> None:
    out = str(tmp_path / "map.nc")
    assert said in refused("map", ROBOT, "--grid", GRID, "--set", setting, "--out", out)
    assert list(tmp_path.iterdir()) == []


def test_a_path_set_twice() -> None:
    both = ["--set", "platform.mass=1", "--set", "platform.mass=2"]
    assert "platform.mass is given twice" in refused("map", ROBOT, "--grid", GRID, *both)


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (["--grid", GRID, "--poses", "poses.csv"], "--grid and --poses exclude each other"),
        (["--samples", "3", "--grid", GRID], "no value of the robot has a standard deviation"),
        (["--samples", "0"], "--samples"),
        (["--seed", "-1"], "--seed"),
        (["--threads", "0"], "--threads"),
        (["--grid", GRID, "--out", "map.txt"], "expected a name that ends in .nc, .zarr, .csv or .parquet"),
        (["--grid", GRID, "--out", "nowhere/map.nc"], "the folder nowhere does not exist"),
        (["--grid", GRID, "--out", "there.nc"], "the output exists"),
        (["--grid", GRID, "--json", "nowhere/a.json"], "the folder nowhere does not exist"),
        (
            ["--grid", GRID, "--out", "map.nc", "--json", "map.nc"],
            "the result and the map would be the same file",
        ),
        (
            ["--poses", "poses.csv", "--out", "poses.csv", "--overwrite"],
            "the map would replace its own input",
        ),
        (["--poses", "none.csv"], "none.csv"),
        (["--poses", "empty.csv"], "expected a header and rows, found none (empty.csv)"),
        (["--poses", "header.csv"], "expected a row for each pose, found only a header (header.csv)"),
        (["--poses", "text.csv"], 'expected a finite number, found "here" (text.csv: line 2, column x)'),
        (["--poses", "two.csv"], 'expected one column "z", found none (two.csv: line 1)'),
        (["--poses", "short.csv"], "expected 3 cells, found 2 (short.csv: line 2)"),
        (["--poses", "away.csv"], "none of the 1 poses of the map can be evaluated"),
        (["--poses", "mm.csv"], "(--poses); the numbers look like millimetres: write the unit in the header"),
        (["--scheduler", "tcp://127.0.0.1:9", "--grid", GRID], "cannot reach the scheduler"),
        (
            [
                "--grid",
                "x=0.6,y=0,z=-0.245",
                "--tracked",
                "--set",
                "effects.gearbox_compliance.compliance=0,1e-4",
            ],
            "modes cannot be tracked across robots with different coordinates (--tracked)",
        ),
    ],
)
def test_options(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    options: list[str],
    said: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("pkmodes.machine.maps.running.TIMEOUT", 1)
    files = {
        "there.nc": "mine",
        "poses.csv": "x,y,z\n0.6,0,-0.245\n",
        "empty.csv": "",
        "header.csv": "x,y,z\n",
        "text.csv": "x,y,z\nhere,0,0\n",
        "two.csv": "x,y\n0,0\n",
        "short.csv": "x,y,z\n0,0\n",
        "away.csv": "x,y,z\n5,0,0\n",
        "mm.csv": "x,y,z\n600,0,-245\n",
    }
    for name, text in files.items():
        (tmp_path / name).write_text(text)
    assert said in refused("map", ROBOT, *options)
    assert {one.name: one.read_text() for one in tmp_path.iterdir()} == files


def test_the_robot_file_is_never_replaced(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    for name in ("robot.toml", "robot.csv"):
        (tmp_path / name).write_text(published())
        refused("map", name, "--grid", GRID, "--out", name, "--overwrite")
        assert (tmp_path / name).read_text() == published()
    assert "would replace its own input" in refused(
        "map", "robot.toml", "--grid", GRID, "--json", "robot.toml"
    )


def test_bad_robots(tmp_path: Path) -> None:
    assert "nowhere.toml" in refused("map", str(tmp_path / "nowhere.toml"))
    (tmp_path / "short.toml").write_text(published().replace('"400 mm"', '"1 mm"'))
    err = refused("map", str(tmp_path / "short.toml"))
    assert "can be reached" in err
