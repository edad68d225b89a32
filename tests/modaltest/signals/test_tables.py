"""Tables in text: separators, headers, units, what columns are, and where a bad cell is."""

from __future__ import annotations

import time
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pkmodes.core.base.errors import MeasurementError
from pkmodes.modaltest.signals.functions import FunctionKind, SignalFile, SignalRequest
from pkmodes.modaltest.signals.reading import read_signals


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "table.csv"


def read(path: Path, text: str | bytes, asked: SignalRequest = SignalRequest()) -> SignalFile:  # noqa: B008
    path.write_bytes(text.encode() if isinstance(text, str) else text)
    return read_signals(path, asked)


SIGNALS = {
    "commas": "time,acc_1,force\n0.0,1.5,2\n0.25,-2.5,3\n",
    "semicolons and decimal commas": "time;acc_1;force\n0,0;1,5;2\n0,25;-2,5;3\n",
    "semicolons and decimal points": "time;acc_1;force\n0.0;1.5;2\n0.25;-2.5;3\n",
    "tabs and decimal commas": "time\tacc_1\tforce\n0,0\t1,5\t2\n0,25\t-2,5\t3\n",
    "a header after #": "#time,acc_1,force\n0.0,1.5,2\n0.25,-2.5,3\n",
    "comments and blank lines": "# hand\n\n# time, acc_1 , force\n## rig 3\n0,1.5,2\n# here\n\n.25,-2.5,3\n\n",
    "line ends of Windows": "time,acc_1,force\r\n0.0,1.5,2\r\n0.25,-2.5,3\r\n",
    "line ends of the old Macintosh": "time,acc_1,force\r0.0,1.5,2\r0.25,-2.5,3",
    "a byte order mark": "\ufefftime,acc_1,force\n0.0,1.5,2\n0.25,-2.5,3",
    "quotes": '"time","acc_1","force"\n"0.0","1.5","2"\n0.25,-2.5,3\n',
    "lines left empty by a spreadsheet": "time,acc_1,force\n0.0,1.5,2\n0.25,-2.5,3\n,,\n,,\n",
    "exponents": "time,acc_1,force\n0,15e-1,2E0\n2.5e-1,-2.5,+3\n",
    "another order": "force,time,acc_1\n2,0.0,1.5\n3,0.25,-2.5\n",
    "a last empty column": "time;acc_1;force;\n0,0;1,5;2;\n0,25;-2,5;3;\n",
}


@pytest.mark.parametrize("form", SIGNALS)
def test_signals_in_every_form_of_table(path: Path, form: str) -> None:
    found = {function.response: function for function in read(path, SIGNALS[form]).functions}
    assert set(found) == {"acc_1", "force"}
    assert found["acc_1"].values.tolist() == [1.5, -2.5]
    assert found["force"].values.tolist() == [2.0, 3.0]
    assert [found["acc_1"].force, found["force"].force] == [False, True]
    assert found["acc_1"].abscissa.tolist() == [0.0, 0.25]
    assert found["acc_1"].kind is FunctionKind.TIME


def test_units_in_brackets(path: Path) -> None:
    text = "time [ms],acc_1 [g],acc_2 [mm/s²],x [wrong unit],force [N]\n0,1,2,3,4\n5,1,2,3,4\n"
    found = read(path, text).functions
    assert [one.unit for one in found] == ["g0", "mm/s^2", None, "N"]
    assert found[0].abscissa.tolist() == [0.0, 0.005]


def test_a_rate_stands_in_for_times(path: Path) -> None:
    found = read(path, "#acc_1,acc_2\n1,2\n3,4\n5,6\n", SignalRequest(rate=4.0)).functions
    assert found[1].abscissa.tolist() == [0.0, 0.25, 0.5]
    assert found[1].values.tolist() == [2.0, 4.0, 6.0]
    with pytest.raises(MeasurementError, match="rate"):
        read(path, "acc_1,acc_2\n1,2\n3,4\n")


def test_columns_nobody_wants_may_hold_anything(path: Path) -> None:
    text = "time,label,acc_1,acc_2\n0,first,1,\n1,second,2,nan\n"
    (found,) = read(path, text, SignalRequest(sensors=frozenset({"acc_1"}))).functions
    assert found.values.tolist() == [1.0, 2.0]


def test_raw_accelerometer_data_of_klipper(path: Path) -> None:
    text = (
        "#time,accel_x,accel_y,accel_z\n2712.154836,312.4,-180.1,9806.65\n2712.155148,300.0,-190.5,9810.0\n"
    )
    found = read(path, text).functions
    assert [one.response for one in found] == ["accel_x", "accel_y", "accel_z"]
    assert found[0].abscissa.tolist() == [2712.154836, 2712.155148]
    assert found[1].values.tolist() == [-180.1, -190.5]


def test_spectra_of_klipper(path: Path) -> None:
    text = "freq,psd_x,psd_y,psd_z,psd_xyz,mzv(59.0),ei(70.8)\n"
    text += "0.8,1e-1,2e-1,3e-1,6e-1,0.99,0.99\n1.6,1,2,3,6,0.9,0.9\n"
    found = read(path, text).functions
    assert [(one.kind, one.response) for one in found] == [(FunctionKind.SPECTRUM, name) for name in "xyz"]
    assert found[2].values.tolist() == [0.3, 3.0]
    assert found[0].abscissa.tolist() == [0.8, 1.6]
    for name in ("y", "psd_y"):
        (one,) = read(path, text, SignalRequest(sensors=frozenset({name}))).functions
        assert (one.response, one.values.tolist()) == ("y", [0.2, 2.0])
    (one,) = read(path, "frequency [kHz],acc_1\n0.01,1\n0.02,2\n").functions
    assert (one.kind, one.response, one.abscissa.tolist()) == (FunctionKind.SPECTRUM, "acc_1", [10.0, 20.0])


@pytest.mark.parametrize(
    ("values", "line", "found", "remedy"),
    [
        ("98.5 0.9 90", 3, "98.5", "divide it by 100 if it is in per cent"),
        ("0.5 90 100.00", 4, "90", "divide it by 100 if it is in per cent"),
        ("0.5 1.001 0.9", 4, "1.001", "export the coherence again"),
        ("0.5 0.9 -0.01", 5, "-0.01", "export the coherence again"),
        ("0.5 0.9 4000", 5, "4000", "export the coherence again"),
    ],
)
def test_a_coherence_outside_0_to_1_is_refused(
    path: Path, values: str, line: int, found: str, remedy: str
) -> None:
    rows = "".join(f"{k + 1},1,2,{value}\n" for k, value in enumerate(values.split()))
    with pytest.raises(MeasurementError) as error:
        read(path, f"# lab\nfrequency,re:a/h,im:a/h,coh:a/h\n{rows}")
    assert error.value.what == f"expected a coherence from 0 to 1, found {found}"
    assert error.value.where == f"{path}: line {line}, column coh:a/h"
    assert error.value.remedy == remedy


def test_a_coherence_that_is_rounded_is_read(path: Path) -> None:
    functions = read(path, "frequency,re:a,im:a,coh:a\n1,1,2,1.0000001\n2,1,2,-1e-7\n").functions
    assert functions[1].kind is FunctionKind.COHERENCE


def test_frequency_responses_and_coherences(path: Path) -> None:
    text = "frequency,re:a/h1 [m/s^2/N],im:a/h1,coh:a/h1,re:12:+X,im:12:+X,coh:12:+X,x\n"
    text += "1,1,2,0.5,3,4,1,0\n2,5,6,1,7,8,1,0\n"
    found = read(path, text).functions
    assert [(one.kind, one.response, one.reference) for one in found] == [
        (FunctionKind.FRF, "a", "h1"),
        (FunctionKind.COHERENCE, "a", "h1"),
        (FunctionKind.FRF, "12:+X", ""),
        (FunctionKind.COHERENCE, "12:+X", ""),
    ]
    assert found[0].values.tolist() == [1 + 2j, 5 + 6j]
    assert (found[0].unit, found[0].reference_unit) == ("m/s^2", "N")
    assert found[1].values.tolist() == [0.5, 1.0]
    assert found[2].values.tolist() == [3 + 4j, 7 + 8j]


def test_a_table_of_pkmodes_response(path: Path) -> None:
    text = (
        "# robot: delta\n# pose: x = 0.1, y = 0\n# drives: held\n# quantity: acceleration\n"
        "# unit: p_x/force_x = m/s^2/N\n# unit: p_y/force_x = m/s^2/N\n"
        "frequency,re:p_x/force_x,im:p_x/force_x,re:p_y/force_x,im:p_y/force_x\n"
        "1.0,0.5,-0.25,1e-05,2.0\n2.0,0.75,-0.5,0.0,1.0\n"
    )
    found = read(path, text)
    assert [(one.response, one.reference) for one in found.functions] == [
        ("p_x", "force_x"),
        ("p_y", "force_x"),
    ]
    assert (found.functions[1].unit, found.functions[1].reference_unit) == ("m/s^2", "N")
    assert found.functions[1].values.tolist() == [1e-5 + 2j, 1j]
    assert found.messages == ()


def test_stated_losses_are_said(path: Path) -> None:
    text = (
        "## logger 3, dropped: 0, overflows: 0\n#time,a\n0,1\n## dropped 12 samples after 0.5 s\n1,2\n"
        "## no samples lost\n## FIFO overflow\n2,3\n"
    )
    found = read(path, text)
    assert [one.rpartition("states: ")[2] for one in found.messages] == [
        "dropped 12 samples after 0.5 s",
        "FIFO overflow",
    ]
    assert found.functions[0].values.tolist() == [1.0, 2.0, 3.0]


FAULTS = {
    "a word": ("time,a\n0,1\n# comment\n1,x\n", "finite number", "line 4, column a"),
    "an empty cell": ("time,a\n0,1\n1,\n", "nothing", "line 3, column a"),
    "nan": ("time,a\n0,1\n1,nan\n", "nan", "line 3, column a"),
    "too large": ("time,a\n0,1\n1,1e999\n", "1e999", "line 3, column a"),
    "an underscore": ("time,a\n0,1\n1,1_0\n", "1_0", "line 3, column a"),
    "a short row": ("time,a,b\n0,1,2\n1,2\n2,3,4\n", "expected 3 cells, found 2", "line 3"),
    "a long and a short row": ("time,a,b\n0,1,2,3\n1,2\n", "expected 3 cells, found 4", "line 2"),
    "decimal commas between commas": ("time,a\n0,0,1,5\n1,0,2,5\n", "expected 2 cells, found 4", "line 2"),
    "falling times": ("time,a\n0,1\n\n2,1\n1,1\n", "ascending", "line 5, column time"),
    "repeated times": ("time,a\n0,1\n0,1\n", "ascending", "line 3, column time"),
    "one row": ("time,a\n0,1\n", "at least 2 rows", ""),
    "no rows": ("time,a\n", "only a header", ""),
    "no header": ("0,1\n1,2\n", "names of the columns", "line 1"),
    "two abscissas": ("time,frequency,a\n0,1,2\n1,2,3\n", "found 2", "line 1"),
    "a repeated column": ("time,a,a\n0,1,2\n1,2,3\n", "repeated", "column 3"),
    "no imaginary part": ("freq,re:a\n0,1\n1,2\n", "im:a", "line 1"),
    "a length of time": ("time [m],a\n0,1\n1,2\n", "unit of time", "time"),
    "a damaged archive": (b"PK\x03\x04abc", "cannot read the archive", ""),
    "UTF-16": ("time,a\n0,1\n1,2\n".encode("utf-16"), "binary", ""),
}


def test_faults_are_refused_with_line_and_column(subtests: pytest.Subtests, path: Path) -> None:
    for fault in FAULTS:
        with subtests.test(fault=fault):
            text, what, place = FAULTS[fault]
            with pytest.raises(MeasurementError) as caught:
                read(path, text)
            assert what in caught.value.what
            assert str(path) in caught.value.where
            assert place in caught.value.where


@given(
    values=st.lists(st.floats(-1e12, 1e12), min_size=2, max_size=20),
    form=st.sampled_from([(",", "."), (";", "."), (";", ","), ("\t", ","), ("\t", ".")]),
)
@settings(max_examples=60, deadline=None)
def test_numbers_survive_every_form(
    values: list[float], form: tuple[str, str], tmp_path_factory: pytest.TempPathFactory
) -> None:
    separator, point = form
    rows = [f"{i}{separator}{value!r}".replace(".", point) for i, value in enumerate(values)]
    path = tmp_path_factory.getbasetemp() / "form.csv"
    (found,) = read(path, "\n".join([f"time{separator}a", *rows])).functions
    assert found.values.tolist() == values


def test_a_large_table_takes_seconds(path: Path) -> None:
    row = "{:.6f},312.401,-180.125,9806.650\n"
    text = "#time,accel_x,accel_y,accel_z\n" + "".join(row.format(i / 3200) for i in range(200_000))
    path.write_text(text)
    start = time.perf_counter()
    found = read_signals(path).functions
    assert time.perf_counter() - start < 4.0
    assert found[2].values.size == 200_000
