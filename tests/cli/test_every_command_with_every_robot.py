"""Every command with every robot file of the repository, with all that a file may add to it at once.

Each robot gets every effect that applies to its mechanism, a damping ratio, standard deviations, limits of use and
the fields of reports, written as ``diagnose --save-robot`` writes what it found.
"""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.robots.damped_robots import DAMPING, EFFECTS
from helpers.robots.one_of_each import POSES
from pkmodes.cli import run
from pkmodes.loop.robot_files.saving import Correction, corrected_text
from pkmodes.machine.maps import workspace
from pkmodes.pages.figures import files
from pkmodes.pages.report import blocks
from pkmodes.pages.report import map as report_of_maps
from pkmodes.pages.view import poses as viewed

ROOT = Path(__file__).parents[2]
#: Examples that came later: they are last, so that the others keep what their motors do here.
LATER = ("loose_rail", "changed_printer")
ROBOTS = sorted(
    [*ROOT.glob("robots/*.toml"), *ROOT.glob("examples/*/robot.toml")],
    key=lambda path: (path.parent.name in LATER, path),
)
#: Poses of robots that do not reach that of their mechanism.
OTHER_POSES = {"changed_printer": np.array([0.03, -0.02, 0.297])}
NAMES = [str(path.relative_to(ROOT)) for path in ROBOTS]
VALUES = {
    **EFFECTS["everything"],
    **DAMPING,
    "belt_mass.linear_density": 0.03,
    "servo_stiffness.stiffness": 40.0,
    "axis_leg_stiffness.factor_3": -0.2,
    "gantry_racking.compliance": 1e-4,
    "gantry_racking.inertia": 0.02,
}
SVG = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 2 1"></svg>'
FIELDS = {"customer": "Example Works", "machine": "cell 7", "serial": "00123", "operator": "A. Berg"}


@pytest.fixture(autouse=True)
def _drawn_only(monkeypatch: pytest.MonkeyPatch) -> None:
    """Figures are drawn but not laid out, which takes nine tenths of the time; those of a map are `figures`.

    The viewer has few poses: with every effect NumPy solves each.  Few are drawn to find the workspace, too.
    """
    monkeypatch.setattr(workspace, "DRAWS_PER_ROUND", 20_000)
    few = {count: grid._replace(levels=2) for count, grid in viewed.GRIDS.items()}
    monkeypatch.setattr(viewed, "GRIDS", few)
    monkeypatch.setattr(viewed, "GRID_BEYOND_THREE", viewed.GRID_BEYOND_THREE._replace(levels=2))
    monkeypatch.setattr(blocks, "inline_svg", lambda *_, **__: SVG)
    monkeypatch.setattr(blocks, "inline_narrow_svg", lambda *_, **__: "")
    monkeypatch.setattr(files, "image_bytes", lambda *_, **__: b"drawn")
    monkeypatch.setattr(report_of_maps, "pictures", lambda *_, **__: iter(()))


def with_everything(path: Path, folder: Path, *, tied: bool) -> Path:
    """Write the robot with everything; `tied`: also with what ties it to ground, so that it has no rigid modes."""
    robot = pkmodes.read_robot(path)
    catalogue = robot.mechanism.effects
    parameters = {
        f"{effect.name}.{p.name}": effect for effect in catalogue.values() for p in effect.parameters
    }
    assert catalogue.keys() <= {value.partition(".")[0] for value in VALUES}
    added = {
        f"effects.{name}": Correction(value, 0.05 * abs(value))
        for name, value in VALUES.items()
        if name in parameters and (tied or not parameters[name].grounds)
    }
    added = {name: value for name, value in added.items() if name not in robot.quantities}
    text = corrected_text(path, {**added, "damping.ratio": Correction(0.02, 0.01)})
    component = robot.mechanism.pose[0].name
    text += f"\n[usable]\n{component} = [-10.0, 10.0]\n\n[report]\n"
    text += "".join(f'{key} = "{value}"\n' for key, value in FIELDS.items())
    written = folder / "robot.toml"
    written.write_text(text, encoding="utf-8")
    return written


def places(path: Path, mechanism: str) -> tuple[str, str]:
    """A pose, and a grid of four poses around it, as options."""
    pose = OTHER_POSES.get(path.parent.name, POSES[mechanism])
    names = ("x", "y", "z", "rx", "ry", "rz")[: len(pose)]
    ends = [
        f"{n}={v:g}:{v + 0.01:g}:2" if n in "xy" else f"{n}={v:g}" for n, v in zip(names, pose, strict=True)
    ]
    return ",".join(f"{v:g}" for v in pose), ",".join(ends)


def done(arguments: list[str], capsys: pytest.CaptureFixture[str]) -> str:
    """Run a command to its end, and return what it printed."""
    code = run(arguments)
    printed = capsys.readouterr()
    assert code == 0, (arguments, printed.err)
    assert not printed.err or printed.err.startswith("note: "), printed.err
    return printed.out


#: Every robot with free or held motors in turn: each mechanism is driven both ways by each command.
CASES = [
    pytest.param(path, drives, id=f"{name}-{drives}")
    for number, (path, name) in enumerate(zip(ROBOTS, NAMES, strict=True))
    for drives in (("free", "held") if "clavel" in name else (("free", "held")[number % 2],))
]


@pytest.mark.parametrize(("path", "drives"), CASES)
def test_every_command_takes_a_robot_with_everything(
    path: Path, drives: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    robot = with_everything(path, tmp_path, tied=drives == "held")
    declared = pkmodes.read_robot(robot)
    assert declared.damping_ratio == 0.02
    pose, grid = places(path, declared.mechanism_name)
    given, json_file, page = [str(robot)], tmp_path / "result.json", tmp_path / "page.html"
    other = tmp_path / "other.toml"
    other.write_text(corrected_text(robot, {"damping.ratio": Correction(0.03, 0.01)}), encoding="utf-8")
    motors = ["--drives", drives]
    first = {"free": "torque_1", "held": "motor_1"}[drives]
    result = ["--json", str(json_file)]
    report = [*result, "--report", str(page)]
    pages = {
        "sensitivities": [*given, "--pose", pose, *motors, *report],
        "map": [*given, "--grid", grid, *motors, *report],
        "response": [*given, "--pose", pose, "--inputs", first, "--outputs", "p_x", *motors, *report]
        + ["--frequencies", "1:200:20"],
        "compare": [*given, str(other), "--grid", grid, *motors, *report],
        **({"shaper": [*given, "--grid", grid, "--shapers", "zv,mzv", *report]} if drives == "held" else {}),
        "show": [*given, "--pose", pose, *motors, *result, "--out", str(page)],
    }
    for command, arguments in pages.items():
        printed = done([command, *arguments], capsys)
        shown = page.read_text(encoding="utf-8")
        if "effects.servo_stiffness.stiffness" in declared.quantities:  # the machine is switched on
            assert "motors free" not in printed + shown, command
        assert all(value in shown for value in FIELDS.values()), command
        page.unlink()
    done(["modes", *given, "--pose", pose, *motors, *result], capsys)
    modes = json.loads(json_file.read_text(encoding="utf-8"))
    ratios = np.array(modes["damping_ratios"][modes["rigid_modes"] :], dtype=float)
    assert (ratios >= 0.02).all()  # those of the effects are added to it
    assert "damping.ratio" not in done(["sensitivities", *given, "--pose", pose, "--all", *motors], capsys)
    out = tmp_path / "figures"
    done(["figures", *given, "--grid", grid, "--out", str(out), *motors, *result], capsys)
    assert {one.name for one in out.iterdir()} == set(json.loads(json_file.read_text("utf-8"))["files"])


def test_a_map_is_swept_over_a_damping_ratio(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """No frequency depends on it, and that is no mistake."""
    robot = with_everything(ROOT / "robots" / "corexy-printer.toml", tmp_path, tied=False)
    page = tmp_path / "page.html"
    sweep = ["--set", "damping.ratio=0.01:0.03:2", "--grid", "x=0.1,y=0.05"]
    printed = done(["map", str(robot), *sweep, "--report", str(page)], capsys)
    assert "damping.ratio 0.01 to 0.03" in printed
    assert "damping.ratio" in page.read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("path", "remedy"),
    [
        ("damping.ratio", "choose a quantity that changes masses or stiffnesses"),
        ("belt.width", 'did you mean "belt_path.2.belt.width"?'),
    ],
)
def test_a_quantity_on_which_no_mode_depends_is_no_unknown_path(
    path: str, remedy: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A damping ratio, and a shared value that every axis overrides."""
    text = (ROOT / "robots" / "corexy-printer.toml").read_text(encoding="utf-8")
    text = text.replace("lengths = ", 'belt.width = "6 mm"\nlengths = ') + '\n[damping]\nratio = "2 %"\n'
    robot, page = tmp_path / "robot.toml", tmp_path / "page.html"
    robot.write_text(text, encoding="utf-8")
    given = [str(robot), "--pose", "0.1,0.05"]
    done(["sensitivities", *given, "--report", str(page)], capsys)
    assert path not in page.read_text(encoding="utf-8").replace(f"belt_path.1.{path}", "")
    for command in (
        ["sensitivities", *given, "--parameters", path],
        ["show", *given, "--vary", f"{path}=0:0.01"],
    ):
        assert run(command) == 2
        assert capsys.readouterr().err == (
            f"error: no frequency and no mode shape depends on {path} ({robot}); {remedy}\n"
        )
