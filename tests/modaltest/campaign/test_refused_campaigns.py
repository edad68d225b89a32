"""Mistakes in campaign files and their tables: each error names the file, the place and what to do."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from pkmodes.cli import run
from pkmodes.core.base.errors import MeasurementError
from pkmodes.modaltest.campaign.campaign import read_campaign

ROOT = Path(__file__).parents[3]
ROBOT = ROOT / "robots/linear-delta-2022.toml"
HEAD = f'format = 1\nrobot = "{ROBOT}"\nband = ["10 Hz", "400 Hz"]\n'
AT = '{ x = "600 mm", y = "0 mm", z = "-245 mm" }'
RECORD = f'[[record]]\npose = "P1"\nat = {AT}\nkind = "modes"\nfiles = ["p1.csv"]\n'
SENSOR = '[[sensor]]\nname = "a"\nchannel = "p_x"\nunit = "m/s^2"\n'


MISTAKES = [
    ("format = 2\n", "expected 1, found 2 (c.toml: format)"),
    ("not toml", "not valid TOML"),
    (HEAD + 'bnd = "x"\n' + RECORD, 'unknown key "bnd" (c.toml); did you mean "band"?'),
    (HEAD, 'expected the key "record", found none (c.toml)'),
    (HEAD.replace('"400 Hz"', '"4 m"') + RECORD, '"m" is not a unit of frequency (c.toml: band)'),
    (
        HEAD.replace('"400 Hz"', '"400"') + RECORD,
        'expected a frequency with its unit, found "400" (c.toml: band)',
    ),
    (
        HEAD.replace('"400 Hz"', '"4 Hz"') + RECORD,
        "expected the lower frequency first, found 10 Hz, 4 Hz",
    ),
    (HEAD.replace(', "400 Hz"', "") + RECORD, "expected two frequencies, found 1 (c.toml: band)"),
    (HEAD + 'repeatability = "2"\n' + RECORD, "expected a share of at least 0 and below 100 %"),
    (
        HEAD + RECORD.replace('"-245 mm"', '"-245"'),
        'found "-245", which has no unit (c.toml: record.1.at.z)',
    ),
    (HEAD + RECORD.replace("-245 mm", "-245,5 mm"), '(c.toml: record.1.at.z); write "-245.5 mm"'),
    (HEAD + RECORD.replace("-245 mm", "-0.2 mt"), '(c.toml: record.1.at.z); write "-0.2 m"'),
    (HEAD.replace("400 Hz", "400,5 Hz") + RECORD, '(c.toml: band); write "400.5 Hz"'),
    (HEAD.replace("400 Hz", "400 hz") + RECORD, 'unit "hz" is unknown (c.toml: band); write "400 Hz"'),
    (HEAD + RECORD + SENSOR.replace("m/s^2", "ms-2"), '(c.toml: sensor.1.unit); write "m*s^-2"'),
    (
        HEAD + RECORD + SENSOR.replace("m/s^2", "V") + 'sensitivity = "10,2 mV/g"\n',
        '(c.toml: sensor.1.sensitivity); write "10.2 mV/g"',
    ),
    (HEAD + RECORD.replace(', z = "-245 mm"', ""), "expected x, y, z, found no z (c.toml: record.1.at)"),
    (HEAD + RECORD.replace("z =", "w ="), 'unknown component "w" (c.toml: record.1.at)'),
    (HEAD + RECORD.replace("-245 mm", "-2 m"), "(c.toml: record.1.at)"),
    (
        HEAD + RECORD.replace('"P1"', '"P\\u001b[2J1"'),
        r'expected a label, found "P\x1b[2J1" (c.toml: record.1.pose)',
    ),
    (HEAD + RECORD.replace('"P1"', '"P\\n1"'), r'found "P\n1" (c.toml: record.1.pose)'),
    (HEAD + RECORD + RECORD.replace('"P1"', '" P1 "'), 'the label "P1" is also that of record 1'),
    (HEAD + RECORD + RECORD, 'the label "P1" is also that of record 1 (c.toml: record.2.pose)'),
    (HEAD + RECORD.replace('["p1.csv"]', "[]"), "expected files, found none (c.toml: record.1.files)"),
    (
        HEAD + RECORD.replace('["p1.csv"]', '{ x = ["a"], y = ["a"] }'),
        'the file "a" is given twice (c.toml: record.1.files)',
    ),
    (HEAD + RECORD + "hits = 0\n", "expected at least 1, found 0 (c.toml: record.1.hits)"),
    (HEAD + RECORD + 'exponential = "-1 s"\n', "expected a time above 0"),
    (HEAD + RECORD + 'set = { "effects.paylod.mass" = "1 kg" }\n', "did you mean"),
    (HEAD + RECORD + 'set = { "effects.payload.mass" = "1 m" }\n', "which is a length"),
    (HEAD + RECORD + 'set = { "effects.payload.mass" = "-2 kg" }\n', "(c.toml: record.1.set)"),
    (HEAD + RECORD + 'drives = "on"\n', 'expected "free" or "held", found'),
    (HEAD + RECORD.replace('"P1"', '"#P1"'), "expected a label that does not begin with #"),
    (HEAD + RECORD.replace('["p1.csv"]', "3"), "expected a table or a list, found an integer"),
    (HEAD + RECORD + SENSOR.replace("m/s^2", "100 mV/g"), "and this as sensitivity"),
    (HEAD + RECORD + SENSOR.replace("p_x", "p_q"), 'unknown channel "p_q" (c.toml: sensor.1.channel)'),
    (
        HEAD + RECORD + SENSOR.replace('channel = "p_x"\n', ""),
        "expected either a channel or a direction, found neither",
    ),
    (HEAD + RECORD + SENSOR + SENSOR, 'the name "a" occurs twice in one setup (c.toml: sensor.2.name)'),
    (HEAD + RECORD + SENSOR.replace("m/s^2", "kg"), "expected the unit of a motion"),
    (
        HEAD + RECORD + SENSOR.replace("m/s^2", "rad/s^2"),
        "p_x cannot have an angular motion (c.toml: sensor.1.unit)",
    ),
    (HEAD + RECORD + SENSOR.replace("p_x", "theta_1_1"), "theta_1_1 cannot have a linear motion"),
    (HEAD + RECORD + SENSOR.replace("m/s^2", "V"), "expected a sensitivity beside volts"),
    (HEAD + RECORD + SENSOR + 'setup = "x"\n', 'no record has the setup "x" (c.toml: sensor.1.setup)'),
    (
        HEAD + RECORD + SENSOR.replace('channel = "p_x"', "direction = [0, 0, 0]"),
        "expected a direction along x, y, z, found [0.0, 0.0, 0.0]",
    ),
    (HEAD + RECORD + SENSOR + 'at = ["0 mm", "4 mm"]\n', "z of the platform, found 2 (c.toml: sensor.1.at)"),
    (HEAD + RECORD + SENSOR + 'at = ["0 mm", "4 mm", "1 kg"]\n', "(c.toml: sensor.1.at)"),
    (HEAD + RECORD + SENSOR + 'at = ["0 mm", "4 mm", 0]\n', "has no unit (c.toml: sensor.1.at)"),
    (
        HEAD + RECORD + SENSOR.replace("p_x", "x_1") + 'at = ["0 mm", "4 mm", "0 mm"]\n',
        'the channel "x_1" is not a motion of a platform, and has no place on one (c.toml: sensor.1.at)',
    ),
    (
        HEAD + RECORD + SENSOR.replace("p_x", "none") + 'at = ["0 mm", "4 mm", "0 mm"]\n',
        'the channel "none" is not a motion of a platform',
    ),
    (
        HEAD + RECORD + SENSOR.replace('channel = "p_x"', 'at = ["0 mm", "4 mm", "0 mm"]'),
        "expected either a channel or a direction, found neither (c.toml: sensor.1)",
    ),
    (
        HEAD + RECORD + '[[force]]\nname = "f"\nchannel = "theta_1_1"\nat = ["0 mm", "4 mm", "0 mm"]\n',
        "has no place on one (c.toml: force.1.at)",
    ),
    (HEAD + RECORD + '[[edit]]\npose = "P2"\n', 'no record has the label "P2" (c.toml: edit.1.pose)'),
    (HEAD.replace("robot", "channels", 1).replace(f'"{ROBOT}"', '["a"]') + RECORD, "has no positions"),
    (
        HEAD.replace(f'robot = "{ROBOT}"', 'channels = ["a", "a"]') + RECORD,
        '"a" is given twice (c.toml: channels)',
    ),
    (HEAD + 'channels = ["a"]\n' + RECORD, "expected either a robot or channels, found both"),
]


def test_the_place_of_a_mistake_is_named(
    subtests: pytest.Subtests, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for text, message in MISTAKES:
        with subtests.test(text=text):
            monkeypatch.chdir(tmp_path)
            Path("c.toml").write_text(text, encoding="utf-8")
            with pytest.raises(MeasurementError) as error:
                read_campaign("c.toml")
            assert message in str(error.value)
            assert "c.toml" in str(error.value)


def test_a_place_on_a_platform_that_translates_changes_nothing(tmp_path: Path) -> None:
    blow = '[[force]]\nname = "f"\ndirection = [0.6, 0.8, 0]\n'
    texts = [HEAD + RECORD + SENSOR + at + blow + at for at in ("", 'at = ["0 mm", "40 mm", "-5 mm"]\n')]
    (tmp_path / "c.toml").write_text(texts[0], encoding="utf-8")
    (tmp_path / "d.toml").write_text(texts[1], encoding="utf-8")
    plain, placed = (read_campaign(tmp_path / name) for name in ("c.toml", "d.toml"))
    assert (plain.sensors, plain.forces) == (placed.sensors, placed.forces)


FAULTY_TABLES = [
    ("", "", "(p1.csv)"),
    ("frequency\n", "", "expected a header and rows, found none (p1.csv)"),
    ("f0\n50\n", "", "expected a column of frequencies, found none (p1.csv: line 1)"),
    (
        "frequency\nfifty\n",
        "",
        'expected a finite number, found "fifty" (p1.csv: line 2, column frequency)',
    ),
    ("frequency,damping\n50\n", "", "expected 2 cells, found 1 (p1.csv: line 2)"),
    ("frequency,damping\n50,2\n", "", "expected a damping ratio of at least 0 and below 1"),
    (
        "frequency,sigma\n50,0\n",
        "",
        "expected a standard deviation above 0 (p1.csv: line 2, column sigma)",
    ),
    ("frequency [m]\n50\n", "", "is not a unit of frequency (p1.csv: line 1, column 1)"),
    ("frequency,shape:x_9\n50,1\n", "", 'unknown channel "x_9" (p1.csv: line 1, column 2); did you mean'),
    ("frequency\n-50\n", "", "expected a frequency above 0"),
    ("pose,frequency\nP2,50\n", "", 'expected rows of the pose "P1", found P2'),
    ("frequency\n50\n", 'columns = { frequency = "f0" }\n', 'expected the column "f0", found none'),
    (
        "frequency\n50\n",
        'columns = { frequenzy = "frequency" }\n',
        'unknown column "frequenzy" in columns',
    ),
    ("frequency,re:a,im:a\n50,1,2\n", "", 'the kind of this record is "frf"'),
    (
        "frequency,shape:x_1,shape:x_2\n50,0,0\n",
        "",
        "expected a mode shape, found components up to 0 (p1.csv: line 2)",
    ),
    ("frequency\n50\n", 'columns = { frequency = "f0", damping = "f0" }\n', "name the same column"),
    ("frequency\n5\n", "", "expected modes, found none in any record"),
    ("frequency\n" + "50\n" * 201, "", "expected modes, found 201 within 1 % from 50 Hz (p1.csv)"),
    (
        "frequency\n50\n",
        '[[edit]]\npose = "P1"\nstrike = ["60 Hz"]\n',
        "no mode of P1 lies within 1 % of 60 Hz",
    ),
    ("frequency\n50\n", '[[edit]]\npose = "P1"\nadd = ["60 Hz"]\n', "no mode can be added at 60 Hz"),
]


def test_a_faulty_table_writes_nothing(
    subtests: pytest.Subtests,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    for table, more, message in FAULTY_TABLES:
        with subtests.test(f"{table}, {more}"):
            monkeypatch.chdir(tmp_path)
            Path("p1.csv").write_text(table, encoding="utf-8")
            Path("c.toml").write_text(HEAD + RECORD + more, encoding="utf-8")
            assert run(["identify", "c.toml", "--out", "modes.csv", "--json", "modes.json"]) == 2
            assert message in " ".join(capsys.readouterr().err.split())
            assert not Path("modes.csv").exists()
            assert not Path("modes.json").exists()


def test_faulty_files_are_left_out_if_asked(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("p1.csv").write_text("frequency\n50\n", encoding="utf-8")
    Path("p2.csv").write_text("frequency\nfifty\n", encoding="utf-8")
    second = RECORD.replace("P1", "P2").replace("p1.csv", "p2.csv")
    Path("c.toml").write_text(
        HEAD + RECORD.replace('["p1.csv"]', '["p1.csv", "p2.csv"]') + second, encoding="utf-8"
    )
    assert run(["identify", "c.toml", "--out", "modes.csv", "--json", "-"]) == 2
    assert not Path("modes.csv").exists()
    capsys.readouterr()
    assert run(["identify", "c.toml", "--out", "modes.csv", "--keep-going"]) == 0
    said = " ".join(capsys.readouterr().err.split())
    assert "left out: p2.csv: expected a finite number" in said
    rows = [line for line in Path("modes.csv").read_text().splitlines() if not line.startswith("#")]
    assert [row.split(",")[0] for row in rows] == ["pose", "P1"]
    Path("p1.csv").write_text("frequency\nfifty\n", encoding="utf-8")
    assert run(["identify", "c.toml", "--out", "none.csv", "--keep-going"]) == 2
    assert not Path("none.csv").exists()
    said = " ".join(capsys.readouterr().err.split())
    assert "expected modes, found none: 3 files were left out, first p1.csv: expected a finite number" in said


@pytest.mark.parametrize("options", [["--out", "p1.csv"], ["--out", "m.csv", "--json", "./p1.csv"]])
def test_no_result_replaces_what_was_measured(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, options: list[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("p1.csv").write_text("frequency\n50\n", encoding="utf-8")
    Path("c.toml").write_text(HEAD + RECORD, encoding="utf-8")
    assert run(["identify", "c.toml", *options]) == 2
    assert Path("p1.csv").read_text(encoding="utf-8") == "frequency\n50\n"
    assert not Path("m.csv").exists()


def test_a_mode_without_any_standard_deviation_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("p1.csv").write_text("frequency\n50\n", encoding="utf-8")
    Path("c.toml").write_text(HEAD + 'repeatability = "0 %"\n' + RECORD, encoding="utf-8")
    assert run(["identify", "c.toml", "--out", "m.csv"]) == 2
    assert "a mode of P1 has no standard deviation (c.toml: record.1)" in capsys.readouterr().err


def test_a_campaign_that_is_no_regular_file_is_refused(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["identify", "/dev/zero", "--out", "m.csv"]) == 2
    assert "it is not a regular file (/dev/zero)" in capsys.readouterr().err


def test_what_was_left_out_is_named_at_the_end_and_in_the_json(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Every file with its reason, also where a record has no other; what is asked of its modes is then of none."""
    monkeypatch.chdir(tmp_path)
    for name, text in (("p1", "50"), ("p2", "fifty"), ("p3", "-1"), ("p4", "60")):
        Path(f"{name}.csv").write_text(f"frequency\n{text}\n", encoding="utf-8")
    two = RECORD.replace('["p1.csv"]', '["p1.csv", "p2.csv"]')
    lost = RECORD.replace("P1", "P2").replace("p1.csv", "p3.csv")
    last = RECORD.replace("P1", "P3").replace("p1.csv", "p4.csv")
    strike = '[[edit]]\npose = "P2"\nstrike = ["50 Hz"]\n'
    Path("c.toml").write_text(HEAD + two + lost + last + strike, encoding="utf-8")
    arguments = ["identify", "c.toml", "--out", "modes.csv", "--keep-going", "--report", "r.html"]
    assert run([*arguments, "--json", "-"]) == 0
    printed = capsys.readouterr()
    records = json.loads(printed.out)["records"]
    assert [record["pose"] for record in records] == ["P1", "P2", "P3"]
    assert [[one["file"] for one in record["left_out"]] for record in records] == [["p2.csv"], ["p3.csv"], []]
    assert [len(record["modes"]) for record in records] == [1, 0, 1]
    for record, reason in zip(
        records, ("expected a finite number", "expected a frequency above 0"), strict=False
    ):
        assert reason in record["left_out"][0]["reason"]
    ends = [line[:34] for line in printed.err.splitlines()[-3:]]
    assert ends == [
        "left out: p2.csv: expected a finit",
        "left out: p3.csv: expected a frequ",
        "left out: P2, none of whose files ",
    ]
    assert run(arguments) == 0
    assert "P2, modes, motors free\nleft out\n" in capsys.readouterr().out
    assert "No file could be used at" in Path("r.html").read_text(encoding="utf-8")
