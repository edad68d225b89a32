"""``pkmodes compare``: prediction and measurement, for scripts and for people."""

from __future__ import annotations

import json
import re
from functools import cache
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.commands import answers
from helpers.commands.answers import Answer
from helpers.commands.printed_tables import printed_table
from helpers.diagnoses.diagnose_command import HEADER, csv_of, rows_of, write
from helpers.robots.robot_text import PUBLISHED
from helpers.runs.processes import printed_by_a_process
from pkmodes_rig.measurements import measure
from pkmodes_rig.robots import POSES, ROBOTS, read

#: For tests of numbers; what is printed and refused does not depend on the back end.
both_back_ends = pytest.mark.usefixtures("backend")

ROW = "A,0.6,0,-0.245,55.5,0.1"


def call(*arguments: object) -> Answer:
    return answers.answer("compare", *arguments)


def table(found: Answer, *others: str) -> list[list[str]]:
    """Return the cells of all measured modes, whose table also has other columns."""
    own, behind = [title for title in others if title == "own"], [title for title in others if title != "own"]
    model = ("f [Hz]", "diff. [%]", "diff. [sigma]")
    return printed_table(found.out, "pose", "line", *own, "mode", "f [Hz]", "sigma [Hz]", *model, *behind)


@cache
def measured(poses: int = 3, shapes: bool = True, servo: float = 0.0) -> str:
    """Measurements of the published robot on the virtual rig."""
    return measure(
        read("published").parameters,
        POSES["published"]["scattered"][:poses],
        effects={"servo_stiffness.stiffness": servo} if servo else {},
        rng=np.random.default_rng(3),
        shapes=("x_1", "x_2", "x_3", "p_x", "p_y", "p_z") if shapes else (),
    )


@both_back_ends
def test_json_holds_the_result_and_every_row(tmp_path: Path) -> None:
    modes = write(tmp_path, measured())
    answer = call(PUBLISHED, modes, "--json", "-")
    assert (answer.code, answer.err) == (0, "")
    found = answer.json
    assert (found["robot"], found["unpaired"]) == ("linear-delta-2022", 0)
    assert len(found["rows"]) == 18
    model = pkmodes.load(PUBLISHED)
    differences, sigmas = [], []
    for row, given in zip(found["rows"], rows_of(measured()), strict=True):
        assert (row["pose"], row["mode"]) == (given["pose"], given["mode"])
        assert row["measured"] == float(given["frequency"])
        assert row["sigma"] == float(given["sigma"])
        point = [float(given[name]) for name in "xyz"]
        assert row["predicted"] == pytest.approx(model.modes(point).frequencies[row["partner"] - 1], rel=1e-9)
        assert row["residual"] == pytest.approx(row["predicted"] / row["measured"] - 1.0)
        assert row["sigmas"] == pytest.approx(row["residual"] * row["measured"] / row["sigma"], rel=0.01)
        assert 0.98 < row["mac"] <= 1.0
        differences.append(row["residual"])
        sigmas.append(row["sigmas"])
    assert [row["line"] for row in found["rows"]] == list(range(3, 21))
    assert found["rms_relative"] == pytest.approx(np.sqrt(np.mean(np.square(differences))))
    assert found["chi2_per_dof"] == pytest.approx(np.mean(np.square(sigmas)))
    assert 0.01 < found["p_value"] < 1.0
    out = tmp_path / "out.json"
    assert call(PUBLISHED, modes, "--json", out).code == 0
    assert json.loads(out.read_text(encoding="utf-8")) == found


def test_the_table_has_a_line_for_each_mode_counted_as_modes_does(tmp_path: Path) -> None:
    answer = call(PUBLISHED, write(tmp_path, measured()), "--all")
    assert (answer.code, answer.err) == (0, "")
    lines = answer.out.splitlines()
    assert lines[0].startswith("linear-delta-2022, motors free: The differences are ")
    assert "  measured modes: 18" in lines
    assert max(map(len, lines)) <= 80
    found = call(PUBLISHED, tmp_path / "modes.csv", "--json", "-").json
    # Rounded to three decimals, three digits and two digits.
    facts = dict(line.strip().split(": ") for line in lines if re.match(r"  \S.*: \S+$", line))
    assert float(facts["rms difference [%]"]) == pytest.approx(100 * found["rms_relative"], abs=5.1e-4)
    assert float(facts["chi2 per degree of freedom of the 18 paired modes"]) == pytest.approx(
        found["chi2_per_dof"], rel=5e-3
    )
    assert float(facts["p-value"]) == pytest.approx(found["p_value"], rel=0.05)
    cells, given = table(answer, "own", "MAC"), rows_of(measured())
    assert len(cells) == 18
    order = sorted(dict.fromkeys(row["pose"] for row in given))
    by_line = {row["line"]: row for row in found["rows"]}
    model = pkmodes.load(PUBLISHED)
    for i, (pose, line, own, mode, frequency, sigma, predicted, difference, sigmas, mac) in enumerate(cells):
        row = given[int(line) - 3]
        assert pose == row["pose"] == order[i // 6]
        assert (row["mode"], int(mode)) == (own, i % 6 + 1)
        assert frequency == f"{float(row['frequency']):.3f}"
        assert sigma == f"{float(row['sigma']):.3f}"
        frequencies = model.modes([float(row[name]) for name in "xyz"]).frequencies
        assert float(predicted) == pytest.approx(frequencies[3 + i % 6], abs=5e-4)
        assert float(difference) == pytest.approx(100 * (float(predicted) / float(frequency) - 1), abs=0.006)
        assert float(sigmas) == pytest.approx(by_line[int(line)]["sigmas"], abs=0.051)
        assert float(mac) == pytest.approx(by_line[int(line)]["mac"], abs=5.1e-4)


def test_a_summary_by_mode_and_the_five_worst_rows_come_first(tmp_path: Path) -> None:
    modes = write(tmp_path, measured())
    rows = call(PUBLISHED, modes, "--json", "-").json["rows"]
    answer = call(PUBLISHED, modes)
    assert max(map(len, answer.out.splitlines())) <= 80
    # The number measured is the same for every mode: a sentence says it.
    assert "In every row: times measured 3." in answer.out
    summary = printed_table(answer.out, "mode", "median [%]", "rms [%]", "[%]", "[sigma]", "line")
    assert [cells[0] for cells in summary] == list("123456")
    for number, median, rms, largest, sigmas, line in summary:
        differences = {r["line"]: 100 * r["residual"] for r in rows if r["partner"] == int(number) + 3}
        assert len(differences) == 3
        assert float(median) == pytest.approx(np.median(list(differences.values())), abs=0.0051)
        assert float(rms) == pytest.approx(
            np.sqrt(np.mean(np.square(list(differences.values())))), abs=0.0051
        )
        worst = max(differences, key=lambda key: abs(differences[key]))
        assert int(line) == worst
        assert float(largest) == pytest.approx(differences[worst], abs=0.0051)
        (row,) = [r for r in rows if r["line"] == worst]
        assert float(sigmas) == pytest.approx(row["sigmas"], abs=0.051)
    expected = sorted(rows, key=lambda r: -abs(r["sigmas"]))[:5]
    assert [int(cells[1]) for cells in table(answer, "own", "MAC")] == [r["line"] for r in expected]
    assert "--all prints every row." in answer.out
    whole = call(PUBLISHED, modes, "--all").out
    assert whole.startswith(answer.out.partition("\nMeasured modes and the model")[0])
    assert "--all prints every row." not in whole


@both_back_ends
def test_an_uncertain_position_widens_every_error(tmp_path: Path) -> None:
    """By the slope of each mode along x, here from differences of the model; the modes of a pose share an error."""
    rows, sigma_x = rows_of(measured()), 0.002
    uncertain = [{**row, "sigma_x": str(sigma_x)} for row in rows]
    plain = call(PUBLISHED, write(tmp_path, csv_of(rows)), "--json", "-").json
    found = call(PUBLISHED, write(tmp_path, csv_of(uncertain)), "--json", "-").json
    model, chi2 = pkmodes.load(PUBLISHED), 0.0
    for label in dict.fromkeys(row["pose"] for row in rows):
        slopes, errors, left = [], [], []
        for row, before in zip(found["rows"], plain["rows"], strict=True):
            if row["pose"] != label:
                continue
            point = [float(rows[row["line"] - 2][name]) for name in "xyz"]
            ahead, behind = (
                np.log(model.modes([point[0] + step, *point[1:]]).frequencies[row["partner"] - 1])
                for step in (1e-6, -1e-6)
            )
            slopes.append((ahead - behind) / 2e-6)
            errors.append(row["sigma"] / row["measured"])
            left.append(before["sigmas"] * errors[-1])
            wider = np.hypot(errors[-1], slopes[-1] * sigma_x)
            assert row["sigmas"] == pytest.approx(left[-1] / wider, rel=1e-5)
            assert row["residual"] == before["residual"]
        V = np.diag(np.square(errors)) + sigma_x**2 * np.outer(slopes, slopes)
        chi2 += np.array(left) @ np.linalg.solve(V, left)
    assert found["chi2_per_dof"] == pytest.approx(chi2 / len(rows), rel=1e-5)
    assert found["chi2_per_dof"] < plain["chi2_per_dof"]


def test_only_what_was_measured_has_a_column(tmp_path: Path) -> None:
    text = csv_of([{k: v for k, v in row.items() if k != "mode"} for row in rows_of(measured(shapes=False))])
    answer = call(PUBLISHED, write(tmp_path, text), "--all")
    assert "own:" not in answer.out
    assert len(table(answer)) == 18  # with no other column


@both_back_ends
def test_modes_that_were_rigid_have_no_partner_until_something_ties_the_platform(tmp_path: Path) -> None:
    modes = write(tmp_path, measured(servo=300.0))
    found = call(PUBLISHED, modes, "--json", "-").json
    assert len(found["rows"]) == 27
    assert found["unpaired"] >= 9
    for row in found["rows"]:
        assert (row["predicted"] is None) == (row["partner"] is None) == (row["sigmas"] is None)
    assert found["p_value"] == pytest.approx(0.0, abs=1e-300)
    answer = call(PUBLISHED, modes, "--all")
    assert "  measured modes: 27\n" in answer.out
    assert f"  unmatched: {found['unpaired']}\n" in answer.out
    assert "  p-value: < 1e-6\n" in answer.out
    assert [cells[3] for cells in table(answer, "own", "MAC", "remark")].count("none") == found["unpaired"]
    tied = PUBLISHED.read_text(encoding="utf-8") + '\n[effects.servo_stiffness]\nstiffness = "300 N*m/rad"\n'
    answer = call(write(tmp_path, tied, "tied.toml"), modes, "--all")
    assert [cells[3] for cells in table(answer, "own", "MAC")] == 3 * list("123456789")
    assert answer.out.startswith("linear-delta-2022, motors on their servo stiffness: ")


@both_back_ends
def test_nothing_that_has_a_partner_is_no_perfect_model(tmp_path: Path) -> None:
    rows = [f"P{i},0.6,{i / 100},-0.24,{5000 + i},1" for i in range(4)]
    modes = write(tmp_path, "\n".join([HEADER, *rows]))
    found = call(PUBLISHED, modes, "--json", "-").json
    assert found["unpaired"] == 4
    assert found["rms_relative"] is found["chi2_per_dof"] is found["p_value"] is None
    answer = call(PUBLISHED, modes)
    assert answer.code == 0
    assert answer.out.startswith("linear-delta-2022, motors free: No measured mode has a partner\n")
    cells = printed_table(answer.out, "pose", "line", "f [Hz]", "sigma [Hz]")
    assert cells == [[f"P{i}", str(2 + i), f"{5000 + i}.000", "1.000"] for i in range(4)]
    assert "In every row: mode none" in answer.out
    assert "rms" not in answer.out


def test_frequencies_in_another_unit_are_named_below_the_table(tmp_path: Path) -> None:
    rows = [
        {**row, **{name: f"{1e-3 * float(row[name]):.9g}" for name in ("frequency", "sigma")}}
        for row in rows_of(measured())
    ]
    modes = write(tmp_path, csv_of(rows))
    answer = call(PUBLISHED, modes)
    assert answer.code == 0
    assert "the frequencies fit the declared model as kHz (" in answer.out
    assert "write frequency [kHz], and sigma in its own unit" in " ".join(answer.out.split())
    assert "fit the declared model as" not in call(PUBLISHED, write(tmp_path, measured())).out


def test_labels_of_every_kind_are_shown_as_they_are(tmp_path: Path) -> None:
    labels = {"P1": 'a, "b" [/red] :car:', "P2": "Größe_模式", "P3": "[bold]" + 70 * "long "}
    rows = [{**row, "pose": labels[row["pose"]].strip()} for row in rows_of(measured())]
    answer = call(PUBLISHED, write(tmp_path, csv_of(rows)), "--all")
    assert answer.code == 0
    assert all(" ".join(label.split()) in " ".join(answer.out.split()) for label in labels.values())
    assert "\u2026" not in answer.out
    windows = "\ufeff# from the lab\r\n" + csv_of(rows)
    plain = call(PUBLISHED, write(tmp_path, measured()), "--json", "-").json
    other = call(PUBLISHED, write(tmp_path, windows), "--json", "-").json
    for before, after in zip(plain["rows"], other["rows"], strict=True):
        assert after == {**before, "pose": labels[before["pose"]].strip()}


def test_small_numbers_are_not_shown_as_zero(tmp_path: Path) -> None:
    answer = call(PUBLISHED, write(tmp_path, f"{HEADER}\nA,0.6,0,-0.245,55.5,0.00002\n"))
    (cells,) = table(answer)
    assert cells[4] == "2e-05"
    assert "  measured modes: 1\n" in answer.out


def test_a_thousand_rows_come_in_the_order_in_which_people_count(tmp_path: Path) -> None:
    rows = [
        {**row, "pose": f"{row['pose']}/{k}", "frequency": f"{float(row['frequency']) * (1 + 1e-5 * k):.9g}"}
        for k in range(60)
        for row in rows_of(measured(shapes=False))
    ]
    answer = call(PUBLISHED, write(tmp_path, csv_of(rows)), "--all")
    assert answer.code == 0
    cells = table(answer, "own")
    assert len(cells) == len(rows) == 1080
    poses = sorted({row["pose"] for row in rows}, key=lambda label: [int(n) for n in label[1:].split("/")])
    assert poses[1:3] == ["P1/1", "P1/2"]
    assert [pose for pose, *_ in cells[::6]] == poses


@both_back_ends
def test_a_robot_whose_axes_override_what_they_share(tmp_path: Path) -> None:
    text = re.sub(r"(branch = -?1\n)", r'\1\n[axis.belt]\nwidth = "15 mm"\n', ROBOTS["published"])
    modes = write(tmp_path, measured())
    plain = call(PUBLISHED, modes, "--json", "-").json
    for shared in ('"20 mm"', '{ value = "20 mm", sigma = "1 %" }'):
        robot = write(tmp_path, text.replace('width = "15 mm" ', f"width = {shared} ", 1), "robot.toml")
        assert call(robot, modes, "--json", "-").json == plain


@pytest.mark.parametrize(
    ("text", "parts"),
    [
        (f"{HEADER}\n{ROW}\nfar,9,9,9,50,0.1\n", ['pose "far" at [9, 9, 9] m', "line 3, columns x, y and z"]),
        (f"{HEADER}\n{ROW}\n{ROW}\n", ["the row repeats line 2"]),
        (None, ["no such file"]),
    ],
)
def test_measurements_that_are_refused(tmp_path: Path, text: str | None, parts: list[str]) -> None:
    modes, out = tmp_path / "modes.csv", write(tmp_path, "before", "out")
    if text is not None:
        write(tmp_path, text)
    answer = call(PUBLISHED, modes, "--json", out)
    assert (answer.code, answer.out) == (2, "")
    assert answer.err.startswith("error: ")
    assert answer.err.count("\n") == 1
    assert re.search(r" \([^;]*modes\.csv[^;]*\); \S", answer.err)
    assert all(part in answer.err for part in parts)
    assert out.read_text() == "before"


def test_arguments_that_are_refused(tmp_path: Path) -> None:
    modes = write(tmp_path, measured())
    for arguments, part in {
        (modes, modes, "--poses", modes): "--poses does not apply to two measurement files",
        (modes, PUBLISHED): "the robot file comes first: pkmodes compare ",
        (PUBLISHED,): "missing argument 'MODES.csv|ROBOT.toml' (pkmodes compare)",
        (PUBLISHED, modes, modes): "unexpected extra argument",
        (PUBLISHED, modes, "--json", modes): "would replace its own input",
        # Of two mistakes, that of --json is told first.
        (PUBLISHED, modes, "--json", modes, "--report", "absent/x.html"): "would replace its own input",
        (PUBLISHED, modes, "--json", tmp_path): "expected a file, found a folder",
        (
            PUBLISHED,
            modes,
            "--json",
            tmp_path / "absent" / "x",
        ): f"the folder {tmp_path / 'absent'} does not exist (",
        (PUBLISHED, modes, "--candidates", "payload"): "no such option",
    }.items():
        answer = call(*arguments)
        assert (answer.code, answer.out) == (2, "")
        assert answer.err.startswith("error: ")
        assert part in answer.err
    assert modes.read_text() == measured()


@pytest.mark.parametrize("environment", [{"COLUMNS": "60"}, {"PYTHONIOENCODING": "ascii"}])
def test_every_terminal_gets_whole_numbers(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, environment: dict[str, str]
) -> None:
    text = csv_of([{**row, "pose": row["pose"].replace("P1", "Größe")} for row in rows_of(measured())])
    given = [PUBLISHED, write(tmp_path, text), "--all"]
    if "PYTHONIOENCODING" in environment:  # Python reads it where it starts
        out, err = printed_by_a_process(["compare", *given], environment)
    else:
        monkeypatch.setenv("COLUMNS", environment["COLUMNS"])
        code, out, err = call(*given)
        assert code == 0
    assert err == ""
    label = "Gr\\xf6\\xdfe" if "PYTHONIOENCODING" in environment else "Größe"
    assert label in out
    answer = Answer(0, out.replace(label, "Größe"), err)
    numbers = r"[1-6] \d+\.\d{3} 0\.\d{3} \d+\.\d{3} [+-]\d\.\d\d [+-]\d\.\d [01]\.\d{3}"
    rows = [" ".join(cells[3:]) for cells in table(answer, "own", "MAC")]
    assert len(rows) == 18
    assert all(re.fullmatch(numbers, row) for row in rows)
    assert "\u2026" not in out


def test_settings_damping_motors_and_long_labels_do_not_widen_it(tmp_path: Path) -> None:
    """With every column that there can be: each number is still there, on lines of at most 80 characters."""
    setting = "set:effects.belt_tension_stiffness.tension"
    rows = []
    for i, row in enumerate(rows_of(measured())):
        held = row["pose"] == "P2"
        rows.append(
            {
                **row,
                "pose": {"P1": "corner at the window", "P2": "centre, second day", "P3": "far"}[row["pose"]],
                "mode": f"bending {i + 1}",
                "damping": "0.0123",
                "sigma_damping": "0.0004",
                "drives": "held" if held else "free",
                setting: {"P1": "250", "P2": "300", "P3": "350"}[row["pose"]],
            }
        )
    for arguments in ((), ("--all",)):
        answer = call(PUBLISHED, write(tmp_path, csv_of(rows)), *arguments)
        assert (answer.code, answer.err) == (0, "")
        assert max(map(len, answer.out.splitlines())) <= 80
    assert "\u2026" not in answer.out
    measured_damping, model_damping = ("measured [%]", "sigma [%]"), ("model [%]",)
    titles = ("pose", "motors", "line", "own", "mode", "f [Hz]", "sigma [Hz]", "f [Hz]")
    titles += ("diff. [%]", "diff. [sigma]", *measured_damping, *model_damping, "MAC", "remark", "set")
    cells = printed_table(answer.out, *titles)
    assert len(cells) == len(rows)
    for found in (dict(zip(titles[:5], one, strict=False)) | {"rest": one[5:]} for one in cells):
        row = rows[int(found["line"]) - 2]
        assert (found["pose"], found["motors"], found["own"]) == (row["pose"], row["drives"], row["mode"])
        assert found["rest"][:2] == [f"{float(row[name]):.3f}" for name in ("frequency", "sigma")]
        # In per cent; the declared model has no damping, and an unmatched mode no model.
        assert found["rest"][5:8] == ["1.23", "0.04", "-" if found["mode"] == "none" else "0"]
        assert found["rest"][-1] == f"effects.belt_tension_stiffness.tension = {row[setting]} N"


def test_paired_modes_are_shown_and_many_unmatched_ones_are_listed(tmp_path: Path) -> None:
    unmatched = [f"A,0.6,0,-0.245,{5000 + i},0.1" for i in range(10)]
    modes = write(tmp_path, "\n".join([HEADER, *unmatched, ROW]))
    answer = call(PUBLISHED, modes)
    (cells,) = table(answer)
    assert cells[:4] == ["A", "12", "1", "55.500"]
    listed = "; ".join(f"line {2 + i}, pose A, {5000 + i} Hz" for i in range(8))
    assert f"unmatched measured modes: {listed}; and 2 more" in " ".join(answer.out.split())
    assert "measurement errors; 10 measured modes without a partner" in " ".join(answer.out.split())
    everything = call(PUBLISHED, modes, "--all")
    assert "unmatched measured modes" not in everything.out
    assert [cells[-1] for cells in table(everything, "remark")] == ["", *10 * ["unmatched"]]
