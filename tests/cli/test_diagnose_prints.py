"""What ``pkmodes diagnose`` prints; the numbers of both back ends are compared in test_cli_diagnose.py."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest

from helpers.commands.printed_tables import printed_table
from helpers.diagnoses.diagnose_command import (
    PUBLISHED,
    UNEQUAL,
    WIND_UP,
    call,
    csv_of,
    edited,
    files,
    measured,
    rows_of,
)
from helpers.pages.page_reading import read
from helpers.runs.processes import printed_by_a_process, without_progress


def test_the_table_of_a_cause_has_the_numbers_of_the_json(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Errors have three digits, standard deviations two, and values the last digit of theirs."""
    robot = (
        PUBLISHED + '\n[effects.belt_end_compliance]\ncompliance = { value = "1e-9 m/N", sigma = "20 %" }\n'
    )
    monkeypatch.setenv("COLUMNS", "110")  # so that the names of the values stand beside them
    inputs, out = files(tmp_path, robot, measured(effects=WIND_UP)), tmp_path / "result.json"
    options = ("--candidates", "gearbox_compliance,payload", "--holdout", "P3", "--json", out)
    code, text, said = call(*inputs, *options)
    assert (code, without_progress(said)) == (0, "")
    found, lines = json.loads(out.read_text(encoding="utf-8")), text.splitlines()
    assert max(map(len, lines)) <= 110
    assert "\u2026" not in text
    assert lines[0] == "linear-delta-2022: effect_found"
    assert lines[1].startswith("  the residual of the declared model is not noise (p < 1e-6); ")
    assert "18 measured modes fitted, motors free" in lines
    assert any(line.startswith("Held out of every choice and fit: P3. ") for line in lines)
    cause = re.search(r"^  gearbox_compliance\.compliance = \((\S+) \+- (\S+)\)e-4 rad/\(N\*m\)$", text, re.M)
    assert cause is not None
    compliance = found["effects"][0]["parameters"]["compliance"]
    assert 4e-4 < compliance["value"] < 6e-4
    assert [*map(float, cause.groups())] == [
        pytest.approx(1e4 * compliance[key], abs=0.0051) for key in ("value", "sigma")
    ]
    stages = {
        "before": "before: as declared",
        "refit": "refit of the uncertain values only",
        "after": "after: with the cause",
    }
    rows = printed_table(text, "model", "rms [%]", "held out [%]", "chi2 per dof")
    for (model, *cells), (stage, name) in zip(rows, stages.items(), strict=True):
        assert model.startswith(name)
        error = found["error"][stage]
        expected = (100 * error["rms_relative"], 100 * error["held_out_rms_relative"], error["chi2_per_dof"])
        assert [*map(float, cells)] == [pytest.approx(one, rel=5e-3) for one in expected]
    *rows, of_cause = printed_table(text, "value", "before", "after", "sigma of fit", "unit")
    refitted = found["refitted"]
    assert [row[0] for row in rows] == [path.removeprefix("effects.") for path in refitted]
    assert [*refitted][-1] == "effects.belt_end_compliance.compliance"
    (start,) = (i for i, line in enumerate(lines) if line.startswith("value "))
    for column in ("before", "after"):  # right ends of the numbers
        end = lines[start].index(column) + len(column)
        assert all(line[end - 1] != " " and line[end] == " " for line in lines[start + 1 : start + 6])
    for (_, before, after, of_fit, unit), value in zip(rows, refitted.values(), strict=True):
        shown = re.fullmatch(r"\(?(\S+) \+- ([^ )]+)\)?(e\S+)?", after)
        assert shown is not None
        number, sigma, exponent = shown.groups(default="")
        assert (float(before), unit) == (value["before"], value["unit"])
        assert float(number + exponent) == pytest.approx(value["after"], abs=0.05 * value["saved_sigma"])
        assert float(sigma + exponent) == pytest.approx(value["saved_sigma"], rel=0.05)
        assert float(of_fit) == pytest.approx(value["sigma"], rel=0.05)
    value = f"({cause[1]} +- {cause[2]})e-4"
    assert of_cause == ["gearbox_compliance.compliance", "0", value, of_cause[3], "rad/(N*m)"]
    assert float(of_cause[3]) == pytest.approx(compliance["sigma"], rel=0.05)
    assert any(line.startswith("stability: the same cause with ") for line in lines)


@pytest.mark.usefixtures("no_drawing")
def test_the_table_of_two_causes_and_of_causes_that_look_alike(tmp_path: Path) -> None:
    both = {**WIND_UP, "belt_mass.linear_density": 0.1}
    inputs = files(tmp_path, PUBLISHED, measured(poses=5, effects=both))
    out = call(*inputs, "--candidates", "belt_mass,gearbox_compliance").out
    assert out.count("\ncause: ") == 2
    assert "\nafter: with the causes " in out
    alike = {"gearbox_compliance.compliance": 1.5e-4}
    inputs = files(tmp_path, PUBLISHED, measured(poses=6, effects=alike, shapes=()))
    options = ("--candidates", "gearbox_compliance,clamp_compliance,belt_end_compliance")
    targets = {"--save-robot": tmp_path / "saved.toml", "--json": tmp_path / "result.json"}
    page = tmp_path / "page.html"
    written = [part for pair in targets.items() for part in pair]
    out = call(*inputs, *options, *written, "--report", page).out
    found = json.loads(targets["--json"].read_text(encoding="utf-8"))
    (effect,) = found["effects"]
    assert len(effect["class"]) == 3
    assert effect["plausible"] == dict.fromkeys(effect["class"], True)
    name, *others = effect["class"]
    # No headline names one of them as the cause.
    parts = {
        "gearbox_compliance": "gearboxes",
        "clamp_compliance": "clamps",
        "belt_end_compliance": "belt ends",
    }
    shared = (
        f"a compliance in series with the belt ({', '.join(parts[member] for member in effect['class'])})"
    )
    assert found["reason"].endswith(f"; the cause is narrowed to three: {shared}")
    assert f" cause: one of three (p < 1e-6): {shared} {name}." in " ".join(out.split())
    summary = read(page.read_text(encoding="utf-8")).by_id("summary")
    assert summary.all("h2")[0].text.startswith(f"Cause narrowed to three: {shared}; with sigma")
    titles = [title.text.split(":")[0] for title in summary.all("dt")]
    assert "inspect" in titles  # what to do comes first
    tiles = titles[titles.index("either") :]
    assert tiles[:4] == [
        "either",
        "or",
        "or",
        "rms difference as declared [%]",
    ]
    assert (
        f"it has {name}; the data cannot tell it from {' or '.join(others)}: to save that instead, add --candidates"
        f" {others[0]}" in " ".join(out.split())
    )
    start = out.index("  these data cannot distinguish it from\n")
    for name in effect["class"][1:]:
        assert re.search(rf"^    {name}\.compliance = \(\S+ \+- \S+\)e-\d+ \S+$", out[start:], re.M)


@pytest.mark.usefixtures("no_drawing")
def test_belts_are_printed_relative_to_their_mean_where_their_common_stiffness_is_uncertain(
    tmp_path: Path,
) -> None:
    """One belt is 10 % too soft and one 5 % too stiff; what is printed are the ratios to their mean."""
    robot = edited(PUBLISHED, ('"2.42e6 N/m", sigma = "2 %"', '"2.42e6 N/m", sigma = "6 %"'))
    inputs = files(tmp_path, robot, measured(poses=5, effects=UNEQUAL))
    found, page = tmp_path / "result.json", tmp_path / "page.html"
    options = ("--candidates", "axis_belt_stiffness,payload", "--json", found, "--report", page)
    out = call(*inputs, *options).out
    start = out.index("  relative to their mean:\n")
    printed = re.findall(r"^    axis_belt_stiffness\.factor_(\d) = (\S+) \+- (\S+)$", out[start:], re.M)
    truth = 1.0 + np.array([UNEQUAL[f"axis_belt_stiffness.factor_{j}"] for j in (1, 2, 3)])
    truth = truth / truth.mean() - 1.0
    assert [number for number, _, _ in printed] == ["1", "2", "3"]
    for (_, value, sigma), right in zip(printed, truth, strict=True):
        assert abs(float(value) - right) < 4 * float(sigma)
        assert float(sigma) < 0.003
    each = re.search(r"^  with their mean, which is less certain:\n    (.*)$", out[start:], re.M)
    assert each is not None
    assert all(float(sigma) > 0.04 for sigma in re.findall(r"\+- (\S+?)(?:,|$)", each[1]))
    assert max(map(len, out.partition("\nwrote ")[0].splitlines())) <= 80
    (effect,) = json.loads(found.read_text())["effects"]
    assert [f"factor_{number}" for number, _, _ in printed] == list(effect["relative"])
    C = np.array(effect["covariance"])
    sigmas = [one["sigma"] for one in effect["parameters"].values()]
    np.testing.assert_allclose(np.sqrt(np.diag(C)), sigmas, rtol=1e-12)
    shown = page.read_text(encoding="utf-8")
    assert "factor_1 relative to the mean" in shown
    assert 'data-at="/effects/0/relative/factor_1/value"' in shown


def test_no_pose_is_held_out_on_request(tmp_path: Path) -> None:
    answer = call(*files(tmp_path), "--candidates", "payload", "--holdout", "none")
    assert "24 measured modes fitted, motors free\n" in answer.out
    assert "held out" not in answer.out.lower()


@pytest.mark.parametrize(
    "environment",
    [{"COLUMNS": "40"}, {"NO_COLOR": "1", "FORCE_COLOR": "1"}, {"PYTHONIOENCODING": "ascii"}],
)
def test_every_terminal_gets_whole_numbers(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, environment: dict[str, str]
) -> None:
    modes = csv_of([{**row, "pose": row["pose"].replace("P1", "Größe")} for row in rows_of(measured())])
    given = [*files(tmp_path, PUBLISHED, modes), "--candidates", "payload", "--holdout", "Größe"]
    if "PYTHONIOENCODING" in environment:  # Python reads it where it starts
        out, err = printed_by_a_process(["diagnose", *given], environment)
    else:
        for name, value in environment.items():
            monkeypatch.setenv(name, value)
        code, out, err = call(*given)
        assert code == 0
    assert re.search(r"\x1b\[[0-9;]*[34][0-7]", out + err) is None  # no colours
    if "FORCE_COLOR" not in environment:  # which would show the progress too
        assert without_progress(err) == ""
    assert "\u2026" not in out
    rows = printed_table(out, "value", "before", "after", "sigma of fit", "unit")
    assert len(rows) == 3
    (cells,) = ("  ".join(row) for row in rows if row[0] == "motor.inertia")
    assert re.fullmatch(r"motor\.inertia  1\.7e-5  \(1\.\d+ \+- 0\.\d+\)e-5  \d\.\de-8  kg\*m\^2", cells)
    assert "18 measured modes fitted, motors free\n" in out
    label = "Gr\\xf6\\xdfe" if "PYTHONIOENCODING" in environment else "Größe"
    assert f"Held out of every choice and fit: {label}." in " ".join(out.split())
    if "COLUMNS" in environment:
        text = [line for line in out.splitlines() if "  " not in line.strip()]
        assert max(map(len, text)) <= 40
