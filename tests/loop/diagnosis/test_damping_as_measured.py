"""Damping as laboratories measure it: ratios that scatter by mode, optimistic errors, a shape of another mode."""

from __future__ import annotations

import json
import re
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from helpers.diagnoses import damped_cases
from helpers.diagnoses.damped_cases import bare, columns, made, of_frequencies, strange
from helpers.diagnoses.diagnose_command import call
from helpers.pages.page_reading import read
from pkmodes import read_robot, updating
from pkmodes.cli.compare import show_comparison as print_comparison
from pkmodes.cli.diagnosis_tables import show_diagnosis as print_diagnosis
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.measured.writing import as_csv
from pkmodes.pages.report import report
from studies.specimens import robot_of

MACHINES = ["published", "rotary_delta", "corexy"]
#: Candidates that keep a diagnosis short.
FEW = ["payload", "belt_loss", "reducer_loss", "rail_friction", "drive_friction", "parameter:damping.ratio"]
#: Factors of the modes, with a standard deviation of their logarithm of 0.2.
BY_MODE = np.exp(0.2 * np.array([1.2, -0.8, 0.3, -1.4, 0.9, -0.2]))
RATIO = 0.01


def scattered(machine: str) -> dict[str, np.ndarray]:
    """Rows of a machine with a ratio of 1 % in the mean, of which each mode has its own part at all poses."""
    rows = columns({"ratio": RATIO}, machine=machine)
    number = np.concatenate([np.arange(n) for n in np.unique(rows["pose"], return_counts=True)[1]])
    return {**rows, "damping": rows["damping"] * BY_MODE[number]}


def of_losses(machine: str) -> list[str]:
    robot = robot_of(machine).with_values({"damping.ratio": RATIO})
    effects = robot.mechanism.effects
    return [name for name in FEW if name in effects or name.startswith("parameter:") or name == "payload"]


@pytest.mark.parametrize("stated", [False, True])
@pytest.mark.parametrize("machine", MACHINES)
def test_ratios_that_scatter_by_mode_are_those_of_the_declared_model(machine: str, stated: bool) -> None:
    """Whether errors are blank, 30 %, or those of repeats alone, 5 %."""
    robot, rows = robot_of(machine).with_values({"damping.ratio": RATIO}), scattered(machine)
    candidates = [name for name in of_losses(machine) if name != "parameter:damping.ratio"]
    found = updating.diagnose(robot, made(rows, machine=machine, stated=stated), candidates=candidates)
    without = updating.diagnose(robot, made(bare(rows), machine=machine), candidates=["payload"])
    assert found.verdict == without.verdict == "adequate", found.reason
    assert of_frequencies(found) == of_frequencies(without)
    assert found.damping.verdict == "adequate", found.damping.reason
    assert not found.damping.effects
    if stated:
        used = np.array([row.damping_used for row in found.rows])
        away = np.log(rows["damping"][used] / RATIO)
        assert found.damping.scatter == pytest.approx(np.sqrt(np.mean(away**2) - 0.05**2), rel=0.05)
        assert "as repeated tests do" in found.damping.reason


@pytest.mark.parametrize(("factor", "verdict"), [(1.2, "adequate"), (1.7, "effect_found")])
def test_a_declared_ratio_is_wrong_only_where_repeated_tests_differ_less(factor: float, verdict: str) -> None:
    robot = robot_of("published").with_values({"damping.ratio": RATIO})
    data = made(columns({"ratio": factor * RATIO}, drives="held"))
    found = updating.diagnose(robot, data, candidates=FEW).damping
    assert found.verdict == verdict, found.reason
    assert f"{100.0 * factor * RATIO:.1f}" in found.reason or verdict == "effect_found"


@cache
def damped() -> tuple[Any, Diagnosis]:
    """Rails that dissipate, with stated errors of a tenth of a per cent of the ratio."""
    rows = columns({"rails": 50.0})
    data = made(rows, sigma=1e-3 * rows["damping"])
    return data, updating.diagnose(robot_of("published"), data, candidates=FEW[:-1])


def test_the_sigma_with_which_a_ratio_was_compared_is_given() -> None:
    """At least the floor of 10 % and 0.0001 of any test, whatever the file states."""
    _, found = damped()
    assert found.damping.verdict == "effect_found"
    resolved = [row for row in found.rows if row.damping > 1e-3]
    assert len(resolved) > 10
    parts = [row.sigma_damping_used / row.damping for row in resolved]
    least = [np.hypot(0.1, np.hypot(1e-3, 1e-4 / row.damping)) for row in resolved]
    assert (np.array(parts) >= (1.0 - 1e-9) * np.array(least)).all()
    assert np.min(np.array(parts) / least) == pytest.approx(1.0, abs=0.01)
    assert found.rows[0].sigma_damping == pytest.approx(1e-3 * found.rows[0].damping)
    content = json.loads(json.dumps(found.as_json()))
    assert content["rows"][0]["sigma_damping_used"] == found.rows[0].sigma_damping_used


def test_a_loss_has_one_p_value_and_the_reason_has_none() -> None:
    data, found = damped()
    assert not re.search(r"\bp\b", found.damping.reason)
    robot = read_robot(Path(__file__).parents[3] / "robots" / "linear-delta-2022.toml")
    page = read(report(found, robot=robot, data=data)).by_id("damping").text
    assert len(re.findall(r"\bp\b", page)) == 1
    assert "p-value" in page


def test_the_terminal_prints_it_beside_the_verdict(capsys: pytest.CaptureFixture[str]) -> None:
    _, found = damped()
    print_diagnosis(robot_of("published"), found)
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].endswith(": adequate")
    heading = lines.index("damping: effect_found")
    (cause,) = (i for i, text in enumerate(lines) if text.startswith("cause: "))
    assert cause > heading
    assert "rail_friction" in lines[cause]
    used = [row.sigma_damping_used / row.damping for row in found.rows if row.damping_used]
    (count,) = (text for text in lines if "ratios fitted" in text)
    assert count.startswith(
        f"{len(used)} ratios fitted with a sigma of {100.0 * np.median(used):.0f} % (median)"
    )


def with_another_shape(share: float) -> tuple[Measurements, int]:
    """Rails that dissipate, and a row whose shape is in this share that of another mode of its pose."""
    rows = columns({"rails": 50.0})
    modes = damped_cases._true("published", "free", ())
    names = ("x_1", "x_2", "x_3", "p_x", "p_y", "p_z")
    some = [slice(at.rigid, at.rigid + damped_cases.MODES) for at in modes]
    shapes = {
        name: np.concatenate([at.shapes[name][s] for at, s in zip(modes, some, strict=True)])
        for name in names
    }
    row, other = 30, 33  # of the same pose
    damping = rows["damping"].copy()
    damping[row] *= 1.2  # not an outlier among the others
    for shape in shapes.values():
        shape[row] += share * (shape[other] - shape[row])
    return made({**rows, "damping": damping}, shapes=shapes), row


@pytest.mark.parametrize(
    ("share", "remark"),
    [
        (0.85, "the shape is not that of its mode (MAC {:.2f})"),
        (1.0, "the mode has no partner: the shape is not that of the nearest one (MAC {:.2f})"),
    ],
)
def test_a_ratio_of_another_shape_is_no_evidence(share: float, remark: str) -> None:
    data, row = with_another_shape(share)
    found = updating.diagnose(robot_of("published"), data, candidates=FEW[:-1])
    mac = found.rows[row].mac if share < 1.0 else found.rows[row].nearest_mac
    assert mac is not None
    assert mac < 0.7
    assert found.rows[row].damping_used is False
    assert found.rows[row].damping_remark == remark.format(mac)
    assert (found.rows[row].damping_before is None) == (share == 1.0)
    (note,) = (note for note in found.damping.notes if "MAC" in note)
    assert note.startswith(f"the damping of line {found.rows[row].line} is not used")
    assert [cause.name for cause in found.damping.effects] == ["rail_friction"]


def test_a_comparison_remarks_a_ratio_of_another_shape(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    data, row = with_another_shape(0.85)
    robot = robot_of("published")
    compared = updating.compare(robot, data)
    assert [i for i, one in enumerate(compared.rows) if one.shape_differs] == [row]
    monkeypatch.setenv("COLUMNS", "160")
    print_comparison(robot, data, compared, len(compared.rows))
    (line,) = (text for text in capsys.readouterr().out.splitlines() if "another shape" in text)
    assert line.split()[1] == str(compared.rows[row].line)
    assert line.endswith(f" {compared.rows[row].mac:.3f}  damping of another shape")


def test_unexplained_damping_refuses_no_correction(tmp_path: Path) -> None:
    """Neither the exit code, nor the saved robot: it is that without the damping, byte for byte."""
    robot = Path(__file__).parents[3] / "robots" / "linear-delta-2022.toml"
    rows, texts = columns({"ratio": RATIO}, effects={"payload.mass": 1.0}), []
    for name, given in {"with": strange(rows), "without": bare(rows)}.items():
        (tmp_path / f"{name}.csv").write_text(as_csv(made(given)), encoding="utf-8")
        saved = tmp_path / f"{name}.toml"
        options = ("--candidates", "payload,rail_friction" if name == "with" else "payload", "--json", "-")
        options += ("--save-robot", str(saved), "--fail-on", "unexplained")
        answer = call(robot, tmp_path / f"{name}.csv", *options)
        assert answer.code == 0, answer.err
        assert answer.json["verdict"] == "effect_found"
        assert answer.json["damping"]["verdict"] == ("unexplained" if name == "with" else "not_measured")
        texts.append(saved.read_text(encoding="utf-8"))
    assert texts[0] == texts[1]
