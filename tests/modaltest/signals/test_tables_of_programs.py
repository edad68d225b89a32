"""Tables as programs write them: preambles, rows of units, times of day, magnitudes and phases, few digits."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pkmodes.core.base.errors import MeasurementError
from pkmodes.modaltest.signals.functions import FunctionKind, SignalFile, SignalRequest
from pkmodes.modaltest.signals.reading import read_signals
from pkmodes.modaltest.signals.sampling import even_pieces, restore_even_times


def read(
    folder: Path,
    text: str,
    asked: SignalRequest = SignalRequest(),  # noqa: B008
    name: str = "table.csv",
) -> SignalFile:
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return read_signals(path, asked)


ACCELEROMETER = frozenset({"x", "y"})
LVM = (
    "LabVIEW Measurement\t\nWriter_Version\t2\nSeparator\tTab\nMulti_Headings\tNo\nX_Columns\tOne\n"
    "***End_of_Header***\t\n\t\nChannels\t2\t\t\nSamples\t2\t2\t\nDelta_X\t0.250000\t0.250000\t\n***End_of_Header***\t\t\n"
    "X_Value\tx\ty\tComment\n0.000000\t1.5\t2\n0.250000\t-2.5\t3\t\n"
)
#: Each holds x = 1.5, -2.5 and y = 2, 3 at 0 and 0.25 s.
SIGNALS = {
    "units in parentheses": '"Time (s)","x (m/s^2)","y (m/s^2)"\n0,1.5,2\n0.25,-2.5,3\n',
    "a unit after a low line": "Time_ms,x,y\n0,1.5,2\n250,-2.5,3\n",
    "t": "t [ms];x;y\n0;1,5;2\n250;-2,5;3\n",
    "timestamps since 1970": "timestamp,x,y\n1700000000.00,1.5,2\n1700000000.25,-2.5,3\n",
    "blanks": "  time    x  y\n 0.0  1.5  2\n 0.25  -2.5  3  \n",
    "blanks below a comment": "# logger 3\n# time x y\n0.0 1.5 2\n0.25 -2.5 3\n",
    "blanks and decimal commas": "time x y\n0,0 1,5 2\n0,25 -2,5 3\n",
    "a row of units": "Time;x;y\n[ms];[g];[-]\n0;1,5;2\n250;-2,5;3\n",
    "a row of units without brackets": "Time\tx\ty\ns\tg\tm/s²\n0\t1.5\t2\n0.25\t-2.5\t3\n",
    "dates": "time,x,y\n2026-02-28 23:59:59.900,1.5,2\n2026-03-01 00:00:00.150,-2.5,3\n",
    "dates with zones": "time,x,y\n2026-02-28T23:59:59.900+01:00,1.5,2\n2026-02-28T23:00:00.150Z,-2.5,3\n",
    "times of day over midnight": "clock;x;y\n23:59:59,900;1,5;2\n00:00:00,150;-2,5;3\n",
    "LabVIEW": LVM,
}


@pytest.mark.parametrize("form", SIGNALS)
def test_signals_as_programs_write_them(tmp_path: Path, form: str) -> None:
    found = {one.response: one for one in read(tmp_path, SIGNALS[form]).functions}
    assert found["x"].values.tolist() == [1.5, -2.5]
    assert found["y"].values.tolist() == [2.0, 3.0]
    np.testing.assert_allclose(found["x"].abscissa - found["x"].abscissa[0], [0.0, 0.25], atol=1e-12)
    of_x = {"units in parentheses": "m/s^2", "a row of units": "g0", "a row of units without brackets": "g0"}
    assert found["x"].unit == of_x.get(form)


def test_a_sensor_may_be_called_as_the_whole_cell(tmp_path: Path) -> None:
    text = '"Time (s)","Acceleration x (m/s^2)"\n0,1.5\n0.25,-2.5\n'
    for name in ("Acceleration x (m/s^2)", "Acceleration x"):
        (found,) = read(tmp_path, text, SignalRequest(sensors=frozenset({name}))).functions
        assert (found.response, found.unit) == (name, "m/s^2")
        assert found.abscissa.tolist() == [0.0, 0.25]


@pytest.mark.parametrize(("overflows", "said"), [(0, 0), (3, 1)])
def test_files_of_a_printers_firmware_state_their_rate(tmp_path: Path, overflows: int, said: int) -> None:
    text = f"Sample,x,y\n0,1.5,2\n1,-2.5,3\nRate 800, overflows {overflows}\n"
    found = read(tmp_path, text, SignalRequest(sensors=ACCELEROMETER))
    assert found.functions[0].abscissa.tolist() == [0.0, 1 / 800]
    assert len(found.messages) == said
    assert all(f"Rate 800, overflows {overflows}" in one for one in found.messages)
    own = read(tmp_path, text, SignalRequest(rate=400.0, sensors=ACCELEROMETER))
    assert own.functions[0].abscissa.tolist() == [0.0, 1 / 400], "the record prevails"
    assert any(
        "states a rate of 800 Hz; the rate given in the campaign's record, 400 Hz" in one
        for one in own.messages
    )
    with pytest.raises(
        MeasurementError, match='the text "Failed to collect data from accelerometer"'
    ) as error:
        read(
            tmp_path,
            "Sample,x,y\n0,1.5,2\nFailed to collect data from accelerometer\n",
            SignalRequest(rate=1.0),
        )
    assert error.value.where.endswith("table.csv: line 3")


def test_columns_may_be_named_from_outside(tmp_path: Path) -> None:
    named = SignalRequest(columns=("time [ms]", "x", "y"))
    for text in ("0\t1.5\t2\n250\t-2.5\t3\n", "0 1,5 2\n250 -2,5 3\n", "a,b,c\n0,1.5,2\n250,-2.5,3\n"):
        first, second = read(tmp_path, text, named).functions
        assert (first.response, second.response) == ("x", "y")
        assert (first.values.tolist(), first.abscissa.tolist()) == ([1.5, -2.5], [0.0, 0.25])
    with pytest.raises(MeasurementError, match="expected the names of 3 columns, found 2"):
        read(tmp_path, "0\t1.5\t2\n", SignalRequest(columns=("time", "x")))
    with pytest.raises(MeasurementError) as error:
        read(tmp_path, "0\t1.5\t2\n250\t-2.5\t3\n")
    assert 'columns = ["time", "acc_1"]' in error.value.remedy


H = np.array([2.0 + 1.0j, -0.5 - 3.0j, -1.0 + 0.25j])


def polar(head: str, magnitude: np.ndarray, phase: np.ndarray) -> str:
    rows = np.column_stack([[1.0, 2.0, 3.0], magnitude, phase])
    return head + "\n" + "\n".join(",".join(f"{one:.17g}" for one in row) for row in rows) + "\n"


DECIBELS = 20.0 * np.log10(np.abs(H))
POLAR = {
    "degrees by their size": ("frequency,mag:s1,phase:s1", np.abs(H), np.degrees(np.angle(H))),
    "radians by their size": ("frequency,mag:s1,phase:s1", np.abs(H), np.angle(H)),
    "radians as stated": ("frequency,mag:s1,phase:s1 [rad]", np.abs(H), np.angle(H) + 12 * np.pi),
    "decibels": ("Frequency (Hz),Mag_s1 (dB),Phase_s1 (deg)", DECIBELS, np.degrees(np.angle(H))),
    "words": ("Frequency (Hz),Magnitude s1,Phase s1 (rad)", np.abs(H), np.angle(H)),
}


@pytest.mark.parametrize("form", POLAR)
def test_magnitude_and_phase(tmp_path: Path, form: str) -> None:
    (found,) = read(tmp_path, polar(*POLAR[form]), SignalRequest(sensors=frozenset({"s1"}))).functions
    assert (found.kind, found.response) == (FunctionKind.FRF, "s1")
    np.testing.assert_allclose(found.values, H, rtol=1e-13)


def test_a_phase_that_may_be_either_is_refused(tmp_path: Path) -> None:
    text = polar("frequency,mag:s1,phase:s1", np.abs(H), np.array([0.0, 9.0, 20.0]))
    with pytest.raises(
        MeasurementError, match="expected the unit of the phase, found none, and phases up to 20"
    ):
        read(tmp_path, text)
    with pytest.raises(MeasurementError, match="expected a unit of angle"):
        read(tmp_path, text.replace("phase:s1", "phase:s1 [s]"))


def test_a_line_at_0_hertz_may_lack_its_value(tmp_path: Path) -> None:
    text = "frequency,re:s1,im:s1\n0,nan,nan\n1,2,3\n2,4,5\n"
    (found,) = read(tmp_path, text).functions
    assert found.abscissa.tolist() == [1.0, 2.0]
    assert found.values.tolist() == [2 + 3j, 4 + 5j]
    with pytest.raises(MeasurementError, match="line 3, column re:s1"):
        read(tmp_path, text.replace("1,2,3", "1,nan,3"))
    with pytest.raises(MeasurementError, match="line 4, column im:s1"):
        read(tmp_path, text.replace("2,4,5", "2,4,inf"))


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (("X_Columns\tOne", "X_Columns\tMulti"), "expected one column of times"),
        (("***End_of_Header***\t\t\nX_Value", "X_Value"), "expected a column of times or frequencies"),
        (("0.250000\t-2.5", "half\t-2.5"), "line 14"),
    ],
)
def test_faults_of_labview_files_are_said(tmp_path: Path, change: tuple[str, str], says: str) -> None:
    with pytest.raises(MeasurementError) as error:
        read(tmp_path, LVM.replace(*change), name="table.lvm")
    assert says in f"{error.value.what} {error.value.where}"


@pytest.mark.parametrize(
    ("rate", "digits", "repeat"),
    [(3200.0, 7, False), (3200.0, 6, True), (1344.0, 6, True), (100.0, 5, False)],
)
def test_times_printed_with_few_digits_are_even(rate: float, digits: int, repeat: bool) -> None:
    """Late times of a long record repeat where they are printed with six digits."""
    exact = 100.0 + np.arange(40_000) / rate
    printed = np.array([float(f"{one:.{digits - 1}e}") for one in exact])
    assert repeat == bool((np.diff(printed) == 0.0).any())
    pieces, messages = even_pieces(restore_even_times(printed), "record")
    assert (len(pieces), messages) == (1, ())
    assert pieces[0].step == pytest.approx(1 / rate, rel=1e-6)


def test_values_may_be_missing_outside_the_band(tmp_path: Path) -> None:
    text = "frequency [kHz];re:s1;im:s1\n0;nan;nan\n0,001;;3\n0,002;4;5\n0,003;6;7\n0,004;8;NaN\n"
    asked = SignalRequest(band=(2.0, 3.5))
    (found,) = read(tmp_path, text, asked).functions
    assert found.abscissa.tolist() == [2.0, 3.0]
    assert found.values.tolist() == [4 + 5j, 6 + 7j]
    with pytest.raises(MeasurementError, match="found nothing") as error:
        read(tmp_path, text.replace("0,003;6;7", "0,003;6;"), asked)
    assert error.value.where.endswith("line 5, column im:s1")


def test_a_carriage_return_inside_a_line_is_a_fault(tmp_path: Path) -> None:
    with pytest.raises(MeasurementError, match="a carriage return inside it") as error:
        read(tmp_path, "time,x,y\n0,1.5,2\n0.25,-2.5\r1,3\n")
    assert error.value.where.endswith("table.csv: line 3")


def test_uneven_times_stay_as_they_are() -> None:
    rng = np.random.default_rng(5)
    uneven = np.cumsum(rng.uniform(0.5, 1.5, 1000)) * 0.01
    assert restore_even_times(uneven) is uneven
    with_a_gap = np.concatenate([np.arange(500), np.arange(510, 1000)]) * 1e-3
    assert restore_even_times(with_a_gap) is with_a_gap


def test_many_gaps_are_said_in_one_sentence() -> None:
    time = np.delete(np.arange(4000), np.arange(100, 4000, 100)[:, None] + np.arange(8)) * 1e-3
    pieces, (message,) = even_pieces(time, "record")
    assert len(pieces) == 40
    assert message.startswith("record: 39 gaps of 8 ms, 7.8 % of the record, the first at 0.099 s")
