"""Tables as loggers write them: other names, rates in comments, counted samples, separators at the end of rows."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pkmodes.core.base.errors import MeasurementError
from pkmodes.modaltest.signals.functions import FunctionKind, SignalFile, SignalRequest
from pkmodes.modaltest.signals.reading import read_signals


def read(folder: Path, text: str, asked: SignalRequest = SignalRequest()) -> SignalFile:  # noqa: B008
    path = folder / "table.csv"
    path.write_text(text, encoding="utf-8")
    return read_signals(path, asked)


X_AND_Y = SignalRequest(sensors=frozenset({"x", "y"}))
#: Each holds x = 1.5, -2.5, 4 and y = 2, 3, 5 at 0, 0.25 and 0.5 s.
ENDS = {
    "commas": "time,x,y\n0,1.5,2,\n0.25,-2.5,3,\n0.5,4,5,\n",
    "several": "time,x,y\r\n0,1.5,2,,,\r\n0.25,-2.5,3,,,\r\n0.5,4,5,,,\r\n",
    "semicolons, after the names too": "time;x;y;\n0;1,5;2;\n0,25;-2,5;3;\n0,5;4;5;\n",
    "after the names alone": "time;x;y;\n0;1,5;2\n0,25;-2,5;3\n0,5;4;5\n",
    "tabs": "time\tx\ty\n0\t1.5\t2\t\n0.25\t-2.5\t3\t\n0.5\t4\t5\t\n",
    "not all rows": "time,x,y\n0,1.5,2\n0.25,-2.5,3,\n0.5,4,5, \n",
    "names in a comment": "# time,x,y\n0,1.5,2,\n0.25,-2.5,3,\n0.5,4,5,\n",
    "a row of units": "time,x,y\ns,g,g,\n0,1.5,2,\n0.25,-2.5,3,\n0.5,4,5,\n",
}


@pytest.mark.parametrize("form", ENDS)
def test_separators_after_the_last_cell_of_rows(tmp_path: Path, form: str) -> None:
    x, y = read(tmp_path, ENDS[form], X_AND_Y).functions
    assert (x.response, y.response) == ("x", "y")
    assert x.abscissa.tolist() == [0.0, 0.25, 0.5]
    assert x.values.tolist() == [1.5, -2.5, 4.0]
    assert y.values.tolist() == [2.0, 3.0, 5.0]


def test_separators_after_rows_without_names(tmp_path: Path) -> None:
    x, _ = read(tmp_path, "0,1.5,2,\n0.25,-2.5,3,\n", SignalRequest(columns=("time", "x", "y"))).functions
    assert x.values.tolist() == [1.5, -2.5]


@pytest.mark.parametrize(
    ("rows", "message"),
    [
        ("0,1.5,2,\n0.25,,3,\n", "line 3, column x"),
        ("0,1.5,2,\n0.25,-2.5,,\n", "line 3, column y"),
        ("0,1.5,2,\n0.25,-2.5,\n", "line 3, column y"),
        ("0,1.5,2,\n0.25,-2.5,3,7,\n", "expected 3 cells, found 5"),
    ],
)
def test_a_missing_or_extra_value_stays_one(tmp_path: Path, rows: str, message: str) -> None:
    with pytest.raises(MeasurementError, match=message):
        read(tmp_path, f"time,x,y\n{rows}", X_AND_Y)


@pytest.mark.parametrize("force", ["Force [N]", "FORCE (N)", "Force in N"])
def test_names_in_capitals_or_not(tmp_path: Path, force: str) -> None:
    found = read(tmp_path, f"Time;X;{force}\n0;1,5;2\n0,25;-2,5;3\n", SignalRequest(sensors=frozenset({"x"})))
    x, hammer = found.functions
    assert (x.response, x.force, x.values.tolist()) == ("x", False, [1.5, -2.5])
    assert (hammer.response, hammer.force, hammer.unit) == ("force", True, "N")


def test_a_name_that_is_there_as_it_is_prevails(tmp_path: Path) -> None:
    text = "time,x,X,Force,force\n0,1,2,3,4\n1,5,6,7,9\n"
    found = {one.response: one.values.tolist() for one in read(tmp_path, text).functions}
    assert found == {"x": [1.0, 5.0], "X": [2.0, 6.0], "Force": [3.0, 7.0], "force": [4.0, 9.0]}
    (sensor,) = read(
        tmp_path, "time,Force\n0,1\n1,2\n", SignalRequest(sensors=frozenset({"Force"}))
    ).functions
    assert (sensor.response, sensor.force) == ("Force", False)


def test_functions_of_frequency_in_capitals(tmp_path: Path) -> None:
    text = "Freq,RE:Acc/1:+X,IM:Acc/1:+X,COH:Acc/1:+X\n1,1,2,1\n2,3,4,0.5\n"
    frf, coherence = read(tmp_path, text, SignalRequest(sensors=frozenset({"acc"}))).functions
    assert (frf.kind, frf.response, frf.reference) == (FunctionKind.FRF, "acc", "1:+X")
    assert frf.values.tolist() == [1 + 2j, 3 + 4j]
    assert coherence.kind is FunctionKind.COHERENCE


NAMED = "elapsed_ms,hammer [N],ch 3,force\n0,1,10,7\n250,2,20,8\n"


def test_the_record_may_say_what_columns_are_called(tmp_path: Path) -> None:
    names = {"time": "elapsed_ms", "force": "hammer", "x": "Ch 3"}
    x, force = sorted(
        read(tmp_path, NAMED, SignalRequest(sensors=frozenset({"x"}), names=names)).functions,
        key=lambda one: one.force,
    )
    assert (x.response, x.abscissa.tolist(), x.values.tolist()) == ("x", [0.0, 0.25], [10.0, 20.0])
    assert (force.response, force.unit, force.values.tolist()) == ("force", "N", [1.0, 2.0])


def test_the_names_found_are_in_the_errors(tmp_path: Path) -> None:
    with pytest.raises(MeasurementError) as error:
        read(tmp_path, NAMED, SignalRequest(names={"time": "elapsed_ms", "force": "hammmer"}))
    assert 'expected "hammmer", which the record names as its force, found "elapsed_ms"' in str(error.value)
    assert 'did you mean "hammer"?' in str(error.value)
    with pytest.raises(MeasurementError) as error:
        read(tmp_path, "elapsed,x\n0,1\n1,2\n")
    assert 'expected a column of times or frequencies, found "elapsed", "x"' in str(error.value)
    assert 'names = { time = "NAME" }' in str(error.value)


RATES = {
    "# Sample rate: 3200 Hz": 3200.0,
    "# rate 1344": 1344.0,
    "# Config: data_rate = 2000.0 Hz, filter = 488 Hz, acc_range = 4 g": 2000.0,
    "# sensor A; Rate: 3.2 kHz": 3200.0,
    "# Sampling frequency [Hz]: 1000": 1000.0,
    "# fs=512": 512.0,
    "# samplerate,1.6e3 samples/s": 1600.0,
    "# ODR 800 sps": 800.0,
    "# max. sample rate: 3200 Hz\n# sample rate: 400 Hz": 400.0,
    "# sample rate: 400 Hz\n# data rate = 0.4 kHz": 400.0,
}
COUNTED = "sample,x\n0,1.5\n1,-2.5\n2,4\n"


@pytest.mark.parametrize("comment", RATES)
def test_a_rate_in_the_comments_stands_in_for_times(tmp_path: Path, comment: str) -> None:
    found = read(
        tmp_path, f"# logger 3, 12 bit\n{comment}\n{COUNTED}", SignalRequest(sensors=frozenset({"x"}))
    )
    np.testing.assert_allclose(found.functions[0].abscissa, np.arange(3) / RATES[comment], rtol=1e-15)
    assert len(found.messages) == 1
    assert f"it has no times: its rate, {RATES[comment]:g} Hz, is that of its comment" in found.messages[0]


@pytest.mark.parametrize(
    "comment",
    [
        "# logger 3",
        "# baud rate: 115200",
        "# frame rate 30",
        "# sweep rate: 2 Hz/s",
        "# rate: 0.1 %",
        "# sample rate: 1,344 Hz",
        "# sample rate: 0.5 ms",
        "# maximum data rate 3200 Hz",
        "# separate 12",
    ],
)
def test_what_is_no_rate_is_not_guessed(tmp_path: Path, comment: str) -> None:
    with pytest.raises(MeasurementError, match="expected a column of times or frequencies"):
        read(tmp_path, f"{comment}\n{COUNTED}")


def test_rates_that_contradict_each_other_are_asked_for(tmp_path: Path) -> None:
    text = f"# sample rate: 3200 Hz\n# ODR = 3187.5 Hz\n{COUNTED}"
    with pytest.raises(MeasurementError, match=r"found 3200 Hz and 3187.5 Hz .*rate = \"3200 Hz\""):
        read(tmp_path, text)
    found = read(tmp_path, text, SignalRequest(3187.5))
    assert found.functions[-1].abscissa[1] == 1.0 / 3187.5
    assert (
        "the file states a rate of 3200 Hz; the rate given in the campaign's record, 3187.5 Hz, is used"
        in found.messages[0]
    )


def test_times_prevail_over_a_rate_in_the_comments(tmp_path: Path) -> None:
    for name in ("time", "t"):
        found = read(tmp_path, f"# sample rate: 3200 Hz\n{name},x\n0,1\n0.25,2\n0.5,3\n")
        assert found.functions[0].abscissa.tolist() == [0.0, 0.25, 0.5]
        assert not found.messages


def test_counted_samples_show_what_is_missing(tmp_path: Path) -> None:
    rows = "".join(f"{number},{number % 7}\n" for number in range(5, 45) if number not in (20, 21))
    found = read(tmp_path, f"# sample rate: 100 Hz\nCount,x\n{rows}", SignalRequest(sensors=frozenset({"x"})))
    expected = [(number - 5) / 100.0 for number in range(5, 45) if number not in (20, 21)]
    np.testing.assert_allclose(found.functions[0].abscissa, expected, rtol=1e-15)
    assert 'its column "Count" shows that 2 samples are missing' in found.messages[-1]


@pytest.mark.parametrize("counts", [range(0, 200, 5), [k % 16 for k in range(40)], [3] * 40])
def test_other_numbers_in_such_a_column_do_not_matter(tmp_path: Path, counts: list[int]) -> None:
    rows = "".join(f"{number},{k % 7}\n" for k, number in enumerate(counts))
    found = read(tmp_path, f"n,x\n{rows}", SignalRequest(100.0, frozenset({"x"})))
    np.testing.assert_allclose(found.functions[0].abscissa, np.arange(40) / 100.0, rtol=1e-15)


def test_times_that_count_samples_are_none_beside_a_rate(tmp_path: Path) -> None:
    text = "time,x\n0,1.5\n1,-2.5\n2,4\n"
    assert read(tmp_path, text).functions[0].abscissa.tolist() == [0.0, 1.0, 2.0]
    for asked, comment in ((SignalRequest(4.0), ""), (SignalRequest(), "# rate 4\n")):
        found = read(tmp_path, f"{comment}{text}", asked)
        assert found.functions[0].abscissa.tolist() == [0.0, 0.25, 0.5]
        assert 'its column "time" counts samples: the rate of 4 Hz' in found.messages[-1]


def test_lost_samples_that_a_comment_states_are_said(tmp_path: Path) -> None:
    found = read(tmp_path, f"# Integrity: True, Skipped samples: 12\n# fs 100 Hz\n{COUNTED}")
    assert "the file states: Integrity: True, Skipped samples: 12" in found.messages[-1]
    assert len(read(tmp_path, f"# Skipped samples: 0\n# fs 100 Hz\n{COUNTED}").messages) == 1
