"""``pkmodes identify`` on modes that another program has identified: repeats, setups, edits, rows."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from helpers.commands.answers import answer
from helpers.commands.printed_tables import printed_table
from helpers.pages.page_reading import read
from modaltest.campaign.structures import identify, refused
from pkmodes import updating
from pkmodes.loop.measured.reading import read_modes
from pkmodes.modaltest.campaign.averaging import mean_modes
from pkmodes.modaltest.campaign.mode_estimates import ModeEstimate

ROOT = Path(__file__).parents[3]
ROBOT = ROOT / "robots/linear-delta-2022.toml"
BEGIN = f"""
format = 1
robot = "{ROBOT}"
band = ["10 Hz", "400 Hz"]
"""
POSE = 'at = { x = "600 mm", y = "0 mm", z = { value = "-245 mm", sigma = "1 mm" } }'


def write(folder: Path, name: str, text: str) -> None:
    (folder / name).write_text(text, encoding="utf-8")


def test_a_table_becomes_rows_with_pose_band_drives_and_settings(tmp_path: Path) -> None:
    write(tmp_path, "p1.csv", "f0;D [%];shape:x_1;shape:x_2\n55,5;2;1;-0,5\n134,2;0;;\n")
    found = identify(
        tmp_path,
        f"""{BEGIN}
        drives = "held"
        [[record]]
        pose = "P1"
        {POSE}
        set = {{ "effects.payload.mass" = "0.2 kg" }}
        kind = "modes"
        files = ["p1.csv"]
        columns = {{ frequency = "f0", damping = "D" }}
        """,
    )
    data = updating.read(found.file, robot=None)
    np.testing.assert_allclose(data.frequency, [55.5, 134.2], rtol=1e-15)
    np.testing.assert_allclose(data.sigma, [0.002 * 55.5, 0.002 * 134.2], rtol=1e-12)  # the default alone
    np.testing.assert_allclose(data.numbers["damping"], [0.02, np.nan])  # 0 means unknown
    assert data.labels == ("P1",)
    np.testing.assert_allclose(data.points, [[0.6, 0.0, -0.245]], rtol=1e-15)
    np.testing.assert_allclose(data.point_sigma, [[0.0, 0.0, 0.001]], rtol=1e-15)
    assert data.drives == ("held",)
    assert data.band == (10.0, 400.0)
    assert data.settings == ("effects.payload.mass",)
    assert data.set_values[0, 0] == 0.2
    assert data.channels == ("x_1", "x_2")
    np.testing.assert_allclose(data.shapes[0], [1.0, -0.5])
    assert np.isnan(data.shapes[1]).all()
    record = found.record
    assert found.document["repeatability"] == 0.002
    assert any("repeatability alone" in message for message in record["messages"])
    assert record["modes"][0]["sigma_parts"] == {
        "scatter": 0.0,
        "fit": 0.0,
        "repeatability": pytest.approx(0.002 * 55.5),
    }
    assert (record["modes"][0]["found_in"], record["modes"][0]["edited"]) == (None, None)


def repeats(folder: Path, count: int, more: str = "") -> str:
    """Three modes in files of a scatter of 0.1 %, drawn from a fixed seed; the last one is missed in one file."""
    rng = np.random.default_rng(count)
    for i in range(count):
        rows = [
            f"{f * (1.0 + 1e-3 * e):.12g},{0.01 + 0.001 * e}"
            for f, e in zip((50.0, 50.6, 130.0), rng.normal(size=3), strict=True)
        ]
        write(folder, f"r{i}.csv", "frequency,damping\n" + "\n".join(rows[: 2 if i == 0 else 3]) + "\n")
    files = ", ".join(f'"r{i}.csv"' for i in range(count))
    record = f'[[record]]\npose = "P1"\n{POSE}\nkind = "modes"\nfiles = [{files}]\n'
    return f'{BEGIN}repeatability = "0.1 %"\n{more}\n{record}'


def test_repeats_are_averaged_and_their_scatter_enters_sigma(tmp_path: Path) -> None:
    found = identify(tmp_path, repeats(tmp_path, 40))
    tables = [np.loadtxt(tmp_path / f"r{i}.csv", delimiter=",", skiprows=1) for i in range(40)]
    modes = found.record["modes"]
    assert [mode["files"] for mode in modes] == [40, 40, 39]
    for k, mode in enumerate(modes):
        f = np.array([table[k, 0] for table in tables if len(table) > k])
        assert mode["frequency"] == pytest.approx(f.mean(), rel=1e-12)
        # Many repeats: their own scatter, drawn a little towards that of the others; Student's t is nearly normal.
        assert mode["sigma_parts"]["scatter"] == pytest.approx(f.std(ddof=1) / np.sqrt(len(f)), rel=0.1)
        parts = mode["sigma_parts"]
        total = np.sqrt(parts["scatter"] ** 2 + parts["fit"] ** 2 + parts["repeatability"] ** 2)
        assert mode["sigma"] == pytest.approx(total, rel=1e-12)
        assert parts["repeatability"] == pytest.approx(1e-3 * mode["frequency"], rel=1e-9)
    np.testing.assert_allclose(updating.read(found.file).sigma, [mode["sigma"] for mode in modes], rtol=1e-15)


def test_a_mode_in_few_of_the_repeats_is_left_out(tmp_path: Path) -> None:
    text = repeats(tmp_path, 5)
    write(tmp_path, "r4.csv", (tmp_path / "r4.csv").read_text() + "77.7,0.01\n")
    assert [round(mode["frequency"]) for mode in identify(tmp_path, text).record["modes"]] == [50, 51, 130]


def test_edits_strike_modes_out_and_say_so(tmp_path: Path) -> None:
    record = identify(tmp_path, repeats(tmp_path, 4, '[[edit]]\npose = "P1"\nstrike = ["130.9 Hz"]\n')).record
    assert [round(mode["frequency"]) for mode in record["modes"]] == [50, 51]
    assert record["struck"] == [pytest.approx(130.0, rel=2e-3)]


def test_modes_outside_the_band_are_left_out_and_named(tmp_path: Path) -> None:
    write(tmp_path, "p1.csv", "frequency\n5\n60\n500\n")
    text = f'{BEGIN}[[record]]\npose = "P1"\n{POSE}\nkind = "modes"\nfiles = ["p1.csv"]\n'
    found = identify(tmp_path, text)
    assert [mode["frequency"] for mode in found.record["modes"]] == [60.0]
    assert "outside the band, left out: 5, 500 Hz" in found.remarks


def test_a_record_without_modes_is_printed_beside_one_that_has_some(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write(tmp_path, "p1.csv", "frequency\n60\n130\n")
    write(tmp_path, "p2.csv", "frequency\n5\n500\n")
    records = (f'[[record]]\npose = "P{k}"\n{POSE}\nkind = "modes"\nfiles = ["p{k}.csv"]\n' for k in (1, 2))
    write(tmp_path, "c.toml", BEGIN + "".join(records))
    monkeypatch.chdir(tmp_path)
    code, out, err = answer("identify", "c.toml", "--out", "modes.csv", "--report", "page.html")
    assert code == 0
    assert "note: p2.csv: outside the band, left out: 5, 500 Hz\n" in err
    first, second, rest = out.split("\n\n", 2)
    assert first.startswith("P1, modes, motors free\n")
    # The default repeatability of 0.2 % is all that is known of their errors.
    assert printed_table(first, "mode", "f [Hz]") == [["1", "60.00 +- 0.12"], ["2", "130.00 +- 0.26"]]
    assert second == "P2, modes, motors free\nno mode was found"
    assert "wrote modes.csv: 2 modes\n" in rest
    assert updating.read(tmp_path / "modes.csv", robot=None).frequency.tolist() == [60.0, 130.0]
    page = read((tmp_path / "page.html").read_text(encoding="utf-8"))
    assert "No mode was found at P2" in " ".join(page.by_id("summary").text.split())
    assert "No mode was found." in page.by_id("record-2").text


def revisits(folder: Path, truth: float, labels: int) -> str:
    rng = np.random.default_rng(3)
    f = np.array([50.0, 80.0, 110.0, 150.0, 210.0])
    text = f'{BEGIN}repeatability = "revisits"\n'
    for k in range(labels):
        visit = f * np.exp(truth * rng.normal(size=f.size))
        for i in range(3):
            rows = visit * np.exp(1e-4 * rng.normal(size=f.size))
            write(
                folder, f"v{k}_{i}.csv", "frequency\n" + "\n".join(f"{value:.12g}" for value in rows) + "\n"
            )
        files = ", ".join(f'"v{k}_{i}.csv"' for i in range(3))
        text += f'[[record]]\npose = "V{k}"\n{POSE}\nkind = "modes"\nfiles = [{files}]\n'
    return text


def test_the_repeatability_is_that_of_poses_measured_twice(tmp_path: Path) -> None:
    document = identify(tmp_path, revisits(tmp_path, 2e-3, 6)).document
    assert document["repeatability"] == pytest.approx(2e-3, rel=0.4)  # 25 degrees of freedom


def test_revisits_need_three_modes(tmp_path: Path) -> None:
    said = refused(tmp_path, revisits(tmp_path, 2e-3, 1))
    assert 'at least 3 modes measured again for repeatability = "revisits", found 0' in said


@pytest.mark.parametrize("n", [2, 3, 5])
def test_two_sigma_cover_the_truth_with_few_repeats(tmp_path: Path, n: int) -> None:
    """Draws that share nothing with the estimate: of 600 modes, 95 % within the sampling error of that share."""
    rng = np.random.default_rng(20261124 + n)
    covered, ratio = [], []
    for _ in range(100):
        scatter = 1e-3 * np.exp(0.5 * rng.normal(size=6))  # modes differ in how well they repeat
        f = 50.0 * (1.0 + np.arange(6.0))
        draws = f * np.exp(scatter * rng.normal(size=(n, 6)))
        groups = [{i: ModeEstimate(float(draws[i, k])) for i in range(n)} for k in range(6)]
        for k, mean in enumerate(mean_modes(groups)):
            error = np.log(mean.frequency / f[k])
            covered.append(abs(error) <= 2.0 * mean.scatter)
            ratio.append((error**2, mean.scatter**2))
    assert 0.93 <= np.mean(covered) <= 0.98
    errors, sigmas = np.array(ratio).mean(axis=0)
    assert 0.6 <= np.sqrt(errors / sigmas) <= 1.5


def test_what_a_measurement_file_may_not_hold_is_left_out_and_said(tmp_path: Path) -> None:
    """Standard deviations as large as what they belong to: the file that is written can be read again."""
    write(
        tmp_path,
        "p1.csv",
        "frequency,sigma,damping,sigma_damping,shape:x_1,shape:x_2,sigma_shape\n"
        "50,0.1,0.02,0.001,1,0.5,1.3\n60,0.1,0.03,1.2,1,-0.5,0.05\n70,71,0.02,0.001,1,0.3,0.05\n",
    )
    found = identify(
        tmp_path, f'{BEGIN}\n[[record]]\npose = "P1"\n{POSE}\nkind = "modes"\nfiles = ["p1.csv"]\n'
    )
    data = updating.read(found.file, robot=None)
    np.testing.assert_allclose(data.frequency, [50.0, 60.0])
    np.testing.assert_allclose(data.shapes, [[np.nan, np.nan], [1.0, -0.5]])
    np.testing.assert_allclose(data.shape_sigma, [np.nan, 0.05])
    np.testing.assert_allclose(data.numbers["damping"], [0.02, np.nan])
    assert found.record["modes"][0]["complexity"] is None
    assert (
        "the mode at 50 Hz has no shape: its standard deviation is 1.3 of the largest component"
        in found.remarks
    )
    assert "the mode at 60 Hz has no damping ratio: its standard deviation is 1.2" in found.remarks
    assert "the mode at 70 Hz is left out: the standard deviation of its frequency is 71 Hz" in found.remarks


def test_columns_named_in_words_are_suggested_and_can_be_mapped(tmp_path: Path) -> None:
    """As the record should have it, in words that it can be written with: then with the units in these words."""
    (tmp_path / "m.csv").write_text(
        "Nr;Frequency in Hz;Damping ratio in %;Shape a\n1;50,5;1,2;0,5\n2;80;0,9;-1\n", encoding="utf-8"
    )
    head = 'format = 1\nchannels = ["a"]\nband = ["10 Hz", "300 Hz"]\n'
    record = '[[record]]\npose = "P1"\nkind = "modes"\nfiles = ["m.csv"]\n'
    columns = (
        'columns = { frequency = "Frequency in Hz", damping = "Damping ratio in %", "shape:a" = "Shape a" }'
    )
    assert columns in refused(tmp_path, head + record)
    data = read_modes(identify(tmp_path, f"{head}{record}{columns}\n").file, ("a",))
    assert data.frequency.tolist() == [50.5, 80.0]
    np.testing.assert_allclose(data.damping, [0.012, 0.009], rtol=1e-12)
    np.testing.assert_allclose(data.shapes[:, 0], [1.0, 1.0])  # of one component: any scale and sign
