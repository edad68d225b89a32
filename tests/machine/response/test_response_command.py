"""``pkmodes response``, damping in ``pkmodes modes`` and ``compare``: what they print and write, what they refuse."""

from __future__ import annotations

import csv
import json
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest
from scipy.io import loadmat
from scipy.signal import find_peaks

import pkmodes
from helpers.commands.answers import printed
from helpers.commands.printed_tables import printed_table
from helpers.robots.robot_text import PUBLISHED, published
from pkmodes.cli import run

POSE, POINT = ("--pose", "0.6,0.05,-0.245"), [0.6, 0.05, -0.245]
DAMPING = """
[damping]
ratio = "2 %"

[effects.belt_loss]
loss_factor = 0.02

[effects.rail_friction]
viscous = "20 N*s/m"
"""
COLUMNS = ("largest", "at [Hz]", "phase [deg]")
HELD = ("--drives", "held", "--inputs", "motor_1,force_x", "--outputs", "p_x,nozzle=1:1:0,x_2")


def assert_largest(cells: Sequence[str], f: np.ndarray, values: np.ndarray) -> None:
    """The cells of a channel are its largest magnitude, in four digits, and its frequency and phase there."""
    peak = np.abs(values).argmax()
    size, at, phase = map(float, cells)
    assert size == pytest.approx(abs(values[peak]), rel=5.1e-4)
    assert at == pytest.approx(f[peak], abs=5.1e-4)
    assert phase == pytest.approx(np.degrees(np.angle(values[peak])), abs=0.51)


@pytest.fixture
def robot(tmp_path: Path) -> str:
    path = tmp_path / "robot.toml"
    path.write_text(published() + DAMPING, encoding="utf-8")
    return str(path)


def test_the_table_and_the_model_are_those_of_python(
    robot: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out, mat = tmp_path / "r.csv", tmp_path / "r.mat"
    arguments = ("response", robot, *POSE, *HELD, "--frequencies", "5:200:40", "--log", "--modes", "3")
    assert (
        run([*arguments, "--out", str(out), "--state-space", str(mat), "--json", str(tmp_path / "r.json")])
        == 0
    )
    printed = capsys.readouterr().out
    model, pose = pkmodes.load(robot), [0.6, 0.05, -0.245]
    outputs = ["p_x", {"nozzle": [1.0, 1.0, 0.0]}, "x_2"]
    f = np.geomspace(5, 200, 40)
    found = model.frf(pose, f, ["motor_1", "force_x"], outputs, drives="held")
    lines = out.read_text(encoding="utf-8").splitlines()
    comments = [line for line in lines if line.startswith("#")]
    assert "# pose: [0.6, 0.05, -0.245] m" in comments
    assert "# drives: held" in comments
    assert "# unit: nozzle/motor_1 = m/rad" in comments
    rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    assert len(rows) == 40
    for k, row in enumerate(rows):
        assert float(row["frequency"]) == f[k]
        for o, output in enumerate(found.outputs):
            for i, into in enumerate(found.inputs):
                value = complex(float(row[f"re:{output}/{into}"]), float(row[f"im:{output}/{into}"]))
                assert value == found.values[k, o, i]
    document = json.loads((tmp_path / "r.json").read_text(encoding="utf-8"))
    np.testing.assert_array_equal(
        np.array(document["real"]) + 1j * np.array(document["imaginary"]), found.values
    )
    system = model.state_space(pose, ["motor_1", "force_x"], outputs, drives="held", modes=3)
    np.testing.assert_array_equal(loadmat(mat)["A"], system.A)
    peak = np.abs(found.values[:, 0, 1]).max()
    line = next(line for line in printed.splitlines() if line.startswith("p_x/force_x"))
    assert f"{peak:.4g}" in line
    assert "motors held" in printed


def test_what_symmetry_keeps_at_rest_has_no_largest_response(
    robot: str, capsys: pytest.CaptureFixture[str]
) -> None:
    """On the plane of symmetry a force in it moves nothing across it; what is computed there is rounding."""
    given = [
        "--pose",
        "0.6,0,-0.245",
        "--inputs",
        "force_x",
        "--outputs",
        "p_x,p_y",
        "--frequencies",
        "1:99:50",
    ]
    assert run(["response", robot, *given]) == 0
    out = capsys.readouterr().out
    found = pkmodes.load(robot).frf([0.6, 0.0, -0.245], np.linspace(1, 99, 50), ["force_x"], ["p_x", "p_y"])
    magnitudes = np.abs(found.values[:, :, 0])
    assert 0.0 < magnitudes[:, 1].max() < 1e-10 * magnitudes[:, 0].max()
    assert magnitudes[:, 0].argmax() == 0, "free motors: the machine moves as a rigid body at low frequencies"
    peaks, _ = find_peaks(magnitudes[:, 0])
    rows = {line.split()[0]: line.split()[1:] for line in out.splitlines() if line.startswith("p_")}
    assert rows.keys() == {"p_x/force_x"}
    assert rows["p_x/force_x"][0] == "m/N"
    first, largest = (float(rows["p_x/force_x"][column]) for column in (1, 2))
    assert first == pytest.approx(magnitudes[0, 0], rel=5.1e-4)
    assert largest == pytest.approx(magnitudes[peaks, 0].max(), rel=5.1e-4)
    assert "No response in p_y/force_x." in out


@pytest.mark.parametrize(
    ("arguments", "what"),
    [
        (("--inputs", "motor_1", "--outputs", "p_x", "--frequencies", "1:9:9"), "motors are free"),
        (("--inputs", "torque_1", "--outputs", "p_w", "--frequencies", "1:9:9"), '"p_w"'),
        (("--inputs", "torque_1", "--outputs", "tip=a:b", "--frequencies", "1:9:9"), "direction"),
        (("--inputs", "torque_1", "--outputs", "tip=0:0:0", "--frequencies", "1:9:9"), "not all of them 0"),
        (("--inputs", "torque_1", "--outputs", "p_x", "--frequencies", "1:9"), "start:stop:count"),
        (("--inputs", "torque_1", "--outputs", "p_x", "--frequencies", "9:1:5"), "ends below its start"),
        (("--inputs", "torque_1", "--outputs", "p_x", "--frequencies", "0:9:9"), "rigid modes"),
        (("--inputs", "torque_1", "--outputs", "p_x", "--frequencies", "0:9:9", "--log"), "0 Hz"),
        (
            ("--inputs", "torque_1", "--outputs", "p_x", "--frequencies", "1:9:9", "--modes", "3"),
            "--state-space",
        ),
        (("--inputs", "torque_1", "--outputs", "p_x", "--frequencies", "1:9:9", "--out", "a.txt"), ".csv"),
    ],
)
def test_mistakes_are_named(
    arguments: tuple[str, ...], what: str, robot: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["response", robot, *POSE, *arguments]) == 2
    error = capsys.readouterr().err
    assert error.startswith("error: ")
    assert what in error
    assert "Traceback" not in error


def test_modes_show_damping_and_poles(robot: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["modes", robot, *POSE, "--json", "-"]) == 0
    document = json.loads(capsys.readouterr().out)
    model = pkmodes.load(robot)
    modes = model.modes([0.6, 0.05, -0.245])
    assert document["damping_ratios"][:3] == [None] * 3
    assert document["damping_ratios"][3:] == modes.damping_ratios[3:].tolist()
    poles = model.poles([0.6, 0.05, -0.245])
    assert document["poles"] == [[s.real, s.imag] for s in poles]
    assert document["notes"] == []
    assert run(["modes", robot, *POSE]) == 0
    row = next(line for line in capsys.readouterr().out.splitlines() if line.startswith("damping [%]"))
    assert row.split()[2:] == [f"{100 * ratio:.3f}" for ratio in modes.damping_ratios[3:]]
    assert run(["modes", str(PUBLISHED), *POSE]) == 0
    assert "damping" not in capsys.readouterr().out


def test_strong_friction_is_noted(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "robot.toml"
    text = published() + '\n[effects.rail_friction]\nviscous = "2000 N*s/m"\n'
    path.write_text(text, encoding="utf-8")
    assert run(["modes", str(path), *POSE, "--drives", "held"]) == 0
    assert "use the poles" in capsys.readouterr().out


def test_compare_shows_measured_damping_beside_that_of_the_model(
    robot: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    model = pkmodes.load(robot)
    poses = {"A": [0.6, 0.05, -0.245], "B": [0.5, 0.0, -0.25]}
    rows = ["pose,x,y,z,frequency,sigma,damping,sigma_damping,drives"]
    expected = []
    for label, drives in (("A", "held"), ("B", "free")):
        modes = model.modes(poses[label], drives=drives)
        for i in range(modes.rigid_modes, modes.rigid_modes + 3):
            damping = "" if i == modes.rigid_modes else "0.03"
            values = (*poses[label], modes.frequencies[i], 0.1)
            rows.append(f"{label},{','.join(map(str, values))},{damping},,{drives}")
            expected.append((damping, modes.damping_ratios[i]))
    file = tmp_path / "modes.csv"
    file.write_text("\n".join(rows) + "\n", encoding="utf-8")
    assert run(["compare", robot, str(file), "--json", "-"]) == 0
    for row, (damping, ratio) in zip(json.loads(capsys.readouterr().out)["rows"], expected, strict=True):
        assert row.get("damping") == (0.03 if damping else None)
        if damping:
            assert row["sigma_damping"] == pytest.approx(0.3 * 0.03)
            assert row["predicted_damping"] == pytest.approx(ratio, rel=1e-12)
        else:
            assert not {"sigma_damping", "predicted_damping"} & row.keys()
    assert run(["compare", robot, str(file)]) == 0
    out = capsys.readouterr().out
    assert "damping ratios are medians" in out
    of_modes = printed_table(
        out, "mode", *["median [%]", "rms [%]", "[%]", "[sigma]", "line", "measured [%]", "model [%]"]
    )
    medians = [f"{100 * np.median([ratio for _, ratio in expected[k::3]]):.3g}" for k in (1, 2)]
    assert [cells[-2:] for cells in of_modes] == [["-", "-"], *(["3", median] for median in medians)]
    titles = "line,mode,f [Hz],sigma [Hz],f [Hz],diff. [%],diff. [sigma],measured [%],sigma [%],model [%]"
    rows = printed_table(printed("compare", robot, file, "--all"), "pose", "motors", *titles.split(","))
    assert {cells[2]: cells[-3:] for cells in rows} == {
        str(line): ["3", "0.9", f"{100 * ratio:.3g}"] if damping else ["-", "-", "-"]
        for line, (damping, ratio) in enumerate(expected, start=2)
    }


def test_long_names_of_outputs_do_not_widen_the_table(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    name = "nozzle_of_the_second_tool_beside_the_first"
    channels = ("--drives", "held", "--inputs", "force_x", "--outputs", f"{name}=1:1:0")
    out = printed("response", PUBLISHED, *POSE, *channels, "--frequencies", "5:60:12")
    assert max(map(len, out.splitlines())) <= 80
    ((label, unit, first, *largest),) = printed_table(out, "channel", "unit", "first", *COLUMNS)
    assert (label, unit) == (f"{name}/force_x", "m/N")
    f, output = np.linspace(5, 60, 12), {name: [1.0, 1.0, 0.0]}
    values = pkmodes.load(PUBLISHED).frf(POINT, f, ["force_x"], [output], drives="held").values[:, 0, 0]
    assert float(first) == pytest.approx(abs(values[0]), rel=5.1e-4)
    assert_largest(largest, f, values)


def test_one_frequency_has_magnitude_and_phase(robot: str) -> None:
    out = printed("response", robot, *POSE, *HELD, "--frequencies", "37")
    found = pkmodes.load(robot).frf(
        POINT, [37.0], ["motor_1", "force_x"], ["p_x", {"nozzle": [1.0, 1.0, 0.0]}, "x_2"], drives="held"
    )
    assert "Magnitude and phase at 37 Hz, for exp(+i omega t)." in out
    assert out.startswith("linear-delta-2022, motors held: At 37 Hz p_x responds most to motor_1\n")
    assert "  frequency: 37 Hz\n" in out
    rows = printed_table(out, "channel", "unit", "magnitude", "phase [deg]")
    assert len(rows) == 6
    for name, _, size, phase in rows:
        output, _, into = name.partition("/")
        place = found.outputs.index(output), found.inputs.index(into)
        assert_largest([size, "37", phase], np.array([37.0]), found.values[:, *place])


def test_measured_responses_stand_beside_those_of_the_model(robot: str, tmp_path: Path) -> None:
    """Measured is the machine as it is, at fewer frequencies; modelled is one with softer belts."""
    text = Path(robot).read_text(encoding="utf-8")
    softer, table = tmp_path / "softer.toml", tmp_path / "measured.csv"
    softer.write_text(text.replace("2.42e6", "2.178e6"), encoding="utf-8")
    given = (*POSE, "--drives", "held", "--inputs", "force_x", "--outputs")
    printed("response", robot, *given, "p_x", "--frequencies", "10:60:26", "--out", table)
    more = ("--frequencies", "5:80:76", "--measured", table, "--report", tmp_path / "page.html")
    out = printed("response", softer, *given, "p_x,p_z", *more)
    rows = {name: cells for name, *cells in printed_table(out, "channel", "first", *COLUMNS, *COLUMNS)}
    assert [*rows] == ["p_x/force_x", "p_z/force_x"]
    assert "  of the channels measured: 1\n" in out
    f, of = np.linspace(5, 80, 76), (["force_x"], ["p_x", "p_z"])
    found = pkmodes.load(softer).frf(POINT, f, *of, drives="held").values[:, :, 0]
    for cells, values in zip(rows.values(), found.T, strict=True):
        assert float(cells[0]) == pytest.approx(abs(values[0]), rel=5.1e-4)
        assert_largest(cells[1:4], f, values)
    f = np.linspace(10, 60, 26)
    assert_largest(
        rows["p_x/force_x"][4:], f, pkmodes.load(robot).frf(POINT, f, *of, drives="held").values[:, 0, 0]
    )
    assert rows["p_z/force_x"][4:] == ["-", "-", "-"]
