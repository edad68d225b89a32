"""Datasets 58 and 58b: every storage that the format has, checked against bytes written by hand."""

from __future__ import annotations

import re
import struct
from pathlib import Path

import numpy as np
import pytest

from modaltest.signals.universal import END, dataset, dataset58, dataset58b, header58, packed
from pkmodes.core.base.errors import MeasurementError
from pkmodes.modaltest.signals.functions import Function, FunctionKind, SignalRequest
from pkmodes.modaltest.signals.reading import read_signals

NUMBERS = [0.5, -1.25, 3.0, 0.125]
PAIRS = [1.0, 2.0, -3.0, 4.0, 0.5, -0.25, 7.0, 8.0]
COMPLEX = [1 + 2j, -3 + 4j, 0.5 - 0.25j, 7 + 8j]
FRF = {"function": 4, "abscissa": (18, "Hz"), "reference": (3, -2), "denominator": (13, "N")}


def only(path: Path, content: bytes) -> Function:
    path.write_bytes(content)
    (function,) = read_signals(path).functions
    return function


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "test.uff"


@pytest.mark.parametrize("ordinate", [2, 4])
def test_even_real_values_of_text(path: Path, ordinate: int) -> None:
    function = only(path, dataset58(NUMBERS, ordinate=ordinate, start=0.5))
    assert (function.kind, function.response, function.reference, function.unit, function.force) == (
        FunctionKind.TIME,
        "12:+X",
        "",
        "m/s^2",
        False,
    )
    np.testing.assert_allclose(function.abscissa, [0.5, 0.51, 0.52, 0.53], rtol=1e-15)
    assert function.values.tolist() == NUMBERS
    assert function.values.dtype == np.float64


def test_even_complex_values_of_text(path: Path) -> None:
    function = only(path, dataset58(PAIRS, ordinate=5, step=2.0, **FRF))
    assert (function.kind, function.response, function.reference) == (FunctionKind.FRF, "12:+X", "3:-Y")
    assert (function.unit, function.reference_unit) == ("m/s^2", "N")
    assert function.abscissa.tolist() == [0.0, 2.0, 4.0, 6.0]
    assert function.values.tolist() == COMPLEX
    assert function.values.dtype == np.complex128


def test_uneven_abscissas_of_text(path: Path) -> None:
    points = [0.0, 0.5, 0.25, -1.25, 1.0, 3.0, 1.5, 0.125]
    function = only(path, dataset58(points, spacing=0))
    assert function.abscissa.tolist() == [0.0, 0.25, 1.0, 1.5]
    assert function.values.tolist() == NUMBERS
    function = only(path, dataset58([1.0, 1.0, 2.0, 3.0, -3.0, 4.0], count=2, ordinate=5, spacing=0, **FRF))
    assert function.abscissa.tolist() == [1.0, 3.0]
    assert function.values.tolist() == COMPLEX[:2]


def test_numbers_whose_columns_touch_and_fortran_exponents(path: Path) -> None:
    line = b"-1.00000E+00-2.50000E-01 1.00000-100-1.5D+002\n"
    function = only(path, dataset(58, header58() + line))
    assert function.values.tolist() == [-1.0, -0.25, 1e-100, -150.0]


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize(("code", "ordinate"), [("f", 2), ("d", 4)])
@pytest.mark.parametrize("close", [b"\n    -1\n", b"    -1\n", b"\r\n    -1\r\n", b"    -1"])
def test_binary_real_values(path: Path, order: int, code: str, ordinate: int, close: bytes) -> None:
    content = dataset58b(packed(NUMBERS, code, order), order=order, ordinate=ordinate, close=close)
    function = only(path, content)
    assert function.values.tolist() == NUMBERS
    assert function.values.dtype == np.float64
    assert function.values.dtype.isnative


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize(("code", "ordinate"), [("f", 5), ("d", 6)])
def test_binary_complex_values(path: Path, order: int, code: str, ordinate: int) -> None:
    function = only(path, dataset58b(packed(PAIRS, code, order), order=order, ordinate=ordinate, **FRF))
    assert function.values.tolist() == COMPLEX
    assert function.values.dtype == np.complex128


@pytest.mark.parametrize("codes", ["ff", "fd", "dd"])
def test_binary_uneven_abscissas_of_either_precision(path: Path, codes: str) -> None:
    times = [0.0, 0.25, 1.0, 1.5]
    data = b"".join(
        struct.pack(f"<{codes[0]}", t) + struct.pack(f"<{codes[1]}", v)
        for t, v in zip(times, NUMBERS, strict=True)
    )
    function = only(path, dataset58b(data, ordinate=2 if codes == "ff" else 4, spacing=0))
    assert function.abscissa.tolist() == times
    assert function.values.tolist() == NUMBERS


@pytest.mark.parametrize("spacing", [0, 1])
def test_pyuff_declares_one_number_for_each_point(path: Path, spacing: int) -> None:
    """Its complex and uneven data are longer than it declares; the header and the closing line say how long."""
    numbers = PAIRS if spacing else [1.0, 1.0, 2.0, 3.0, -3.0, 4.0, 5.0, 0.5, -0.25, 7.0, 7.0, 8.0]
    content = dataset58b(packed(numbers, "d"), size=32, ordinate=6, spacing=spacing, **FRF)
    assert only(path, content).values.tolist() == COMPLEX
    with pytest.raises(MeasurementError, match="end of the file"):
        only(path, content[:-20])


def test_binary_data_that_contain_a_delimiter(path: Path) -> None:
    data = b"\n    -1\n    58\n\n    -1\n"
    data += bytes(24 - len(data))
    function = only(path, dataset58b(data, count=6))
    assert function.values.tolist() == [float(value) for value in struct.unpack("<6f", data)]


def test_a_header_line_that_is_a_delimiter(path: Path) -> None:
    content = dataset58(NUMBERS, ids=("    -1", "NONE", "    -1", "NONE", "NONE"))
    assert only(path, content).values.tolist() == NUMBERS


def test_datasets_of_text_and_bytes_in_one_file_with_others_skipped(path: Path) -> None:
    other = dataset(151, b"model\n        -1\nanything -1\n") + dataset(2420, b"\n") + b"\n"
    binary = dataset58b(packed(NUMBERS, "f"), response=(7, -6))
    skipped = binary.replace(b"    58b", b"  1858b")
    path.write_bytes(other + binary + other + dataset58(NUMBERS, response=(9, 0)) + skipped)
    found = read_signals(path)
    assert [function.response for function in found.functions] == ["7:-RZ", "9"]
    assert found.messages == ()


def test_only_wanted_sensors_and_forces_are_kept(path: Path) -> None:
    force = dataset58(NUMBERS, response=(1, 3), quantity=(13, "N"))
    path.write_bytes(force + dataset58(NUMBERS) + dataset58(NUMBERS, response=(12, 2)))
    found = read_signals(path, SignalRequest(sensors=frozenset({"12:+Y"}))).functions
    assert [(one.response, one.force, one.unit) for one in found] == [
        ("1:+Z", True, "N"),
        ("12:+Y", False, "m/s^2"),
    ]


@pytest.mark.parametrize(
    ("start", "step", "what"),
    [
        (3e7, 1e-9, "found 30000000 after 30000000"),
        (-1e20, 1.0, "found -1e+20 after -1e+20"),
        (1e308, 1e308, "inf"),
    ],
)
def test_an_even_abscissa_that_does_not_ascend_is_refused(
    path: Path, start: float, step: float, what: str
) -> None:
    path.write_bytes(dataset58(NUMBERS, start=start, step=step))
    with pytest.raises(MeasurementError, match=re.escape(what)) as error:
        read_signals(path)
    assert error.value.where.startswith(f"{path}: dataset 1")


@pytest.mark.parametrize("binary", [False, True])
def test_a_coherence_in_per_cent_is_refused(path: Path, binary: bool) -> None:
    lines = {"abscissa": (18, "Hz"), "step": 2.0, "function": 6, "reference": (3, 1)}
    numbers = [99.0, 0.5, 25.0, 100.0]
    written = dataset58b(packed(numbers, "f"), **lines) if binary else dataset58(numbers, **lines)
    path.write_bytes(dataset58([1.0, 0.5, 0.25, 1.0], **lines) + written)
    with pytest.raises(MeasurementError) as error:
        read_signals(path)
    assert error.value.what == "expected a coherence from 0 to 1, found 99 as value 1"
    assert error.value.where.startswith(f"{path}: dataset 2")
    assert error.value.remedy == "divide it by 100 if it is in per cent"


def test_spectra_and_coherences(path: Path) -> None:
    lines = {"abscissa": (18, "Hz"), "step": 1.0}
    psd = dataset58([1.0, 2.0, 3.0, 4.0], function=9, quantity=(12, "(m/s^2)^2/Hz"), **lines)
    auto = dataset58([1.0, 2.0, 3.0, 4.0], function=2, reference=(12, 1), **lines)
    cross = dataset58([3.0, 4.0, 0.0, -2.0], function=3, count=2, ordinate=5, reference=(3, 1), **lines)
    coherence = dataset58([1.0, 0.5, 0.25, 1.0], function=6, reference=(3, 1), **lines)
    force = dataset58([1.0, 2.0, 3.0, 4.0], function=2, quantity=(13, "N"), **lines)
    other = dataset58([1.0, 2.0, 3.0, 4.0], function=7, **lines)
    path.write_bytes(psd + auto + cross + coherence + force + other)
    found = read_signals(path)
    assert [one.kind for one in found.functions] == [FunctionKind.SPECTRUM] * 3 + [FunctionKind.COHERENCE]
    assert [one.reference for one in found.functions] == ["", "", "3:+X", "3:+X"]
    assert found.functions[2].values.tolist() == [5.0, 2.0]
    assert found.functions[3].values.tolist() == [1.0, 0.5, 0.25, 1.0]
    assert all(one.values.dtype == np.float64 for one in found.functions)
    assert ["force" in found.messages[0], "function type 7" in found.messages[1]] == [True, True]


def test_abscissas_in_other_units_become_seconds_and_hertz(path: Path) -> None:
    assert only(path, dataset58(NUMBERS, step=10.0, abscissa=(17, "ms"))).abscissa[-1] == pytest.approx(0.03)
    spectrum = only(path, dataset58(NUMBERS, function=9, step=60.0, abscissa=(18, "rpm")))
    np.testing.assert_allclose(spectrum.abscissa, [0.0, 1.0, 2.0, 3.0])


@pytest.mark.parametrize(
    ("label", "unit", "force"),
    [
        ("(m/s^2)/N", "m/s^2", "N"),
        ("m/s2/N", "m/s^2", "N"),
        ("(1/N)*(m/s²)", "m/s^2", "N"),
        ("g/N", "g0", "N"),
        ("g/lbf", "g0", "lbf"),
        ("mm/sec**2", "mm/s^2", None),
        ("V", "V", None),
        ("a label", None, None),
    ],
)
def test_labels_of_units(path: Path, label: str, unit: str | None, force: str | None) -> None:
    header = {**FRF, "denominator": (0, "NONE")}
    function = only(path, dataset58(PAIRS, ordinate=5, quantity=(12, label), **header))
    assert (function.unit, function.reference_unit) == (unit, force)


#: How many units of length and of force make 1 m and 1 N, as dataset 164 states them.
UNITS = {
    (1.0, 1.0): ("m/s^2", "N"),
    (3.28083989501312334, 0.224808943099710480): ("ft/s^2", "lbf"),
    (1000.0, 1000.0): ("mm/s^2", "mN"),
    (39.3700787401575, 0.224808943): ("inch/s^2", "lbf"),
    (1000.0, 1.0): ("mm/s^2", "N"),
    (17.0, 1.0): (None, "N"),
}


def units_of(length: float, force: float) -> bytes:
    """A dataset 164."""
    numbers = [f"{factor:25.17E}".replace("E", "D") for factor in (length, force)]
    return dataset(164, f"{9:10d}{'any':20}{2:10d}\n{''.join(numbers)}{1.0:25.17E}\n{0.0:25.17E}\n".encode())


@pytest.mark.parametrize("factors", UNITS)
def test_dataset_164_gives_the_units_of_functions_without_a_label(
    path: Path, factors: tuple[float, float]
) -> None:
    units = units_of(*factors)
    header = {**FRF, "denominator": (13, "NONE")}
    function = only(path, units + dataset58(PAIRS, ordinate=5, quantity=(12, "NONE"), **header))
    assert (function.unit, function.reference_unit) == UNITS[factors]
    function = only(path, units + dataset58(PAIRS, ordinate=5, quantity=(12, "g"), **FRF))
    assert (function.unit, function.reference_unit) == ("g0", "N")


def test_units_hold_for_functions_before_them(path: Path) -> None:
    header = {**FRF, "denominator": (13, "NONE"), "quantity": (12, "NONE")}
    function = dataset58(PAIRS, ordinate=5, **header)
    for content in (units_of(1e3, 1.0) + function, function + units_of(1e3, 1.0)):
        found = only(path, content)
        assert (found.unit, found.reference_unit, found.unit_assumed) == ("mm/s^2", "N", False)
    path.write_bytes(function + units_of(1e3, 1.0) + dataset58(NUMBERS) + units_of(1e3, 1.0))
    assert [one.unit for one in read_signals(path).functions] == ["mm/s^2", "m/s^2"]  # the second has a label


def test_two_systems_of_units_in_a_file_are_refused(path: Path) -> None:
    with pytest.raises(MeasurementError, match="expected one system of units, found mm and N after m and N"):
        only(path, units_of(1.0, 1.0) + dataset58(NUMBERS) + units_of(1e3, 1.0))


def test_functions_of_one_label_are_told_apart_by_their_number(path: Path) -> None:
    first, second = (dataset58b(packed([k, 2.0], "f"), count=2, response=(1, -3)) for k in (5.0, 7.0))
    other = dataset58b(packed([9.0, 2.0], "f"), count=2, response=(2, 3))
    path.write_bytes(first + other + second)

    def found(*names: str) -> list[tuple[str, float]]:
        asked = SignalRequest(sensors=frozenset(names) if names else None)
        return [(one.response, float(one.values[0].real)) for one in read_signals(path, asked).functions]

    assert found() == [("1:-Z", 5.0), ("2:+Z", 9.0), ("1:-Z#2", 7.0)]
    assert found("1:-Z#2") == [("1:-Z#2", 7.0)]
    assert found("1:-Z#1", "2:+Z") == [("1:-Z#1", 5.0), ("2:+Z", 9.0)]
    assert found("1:-Z", "1:-Z#2") == [("1:-Z", 5.0), ("1:-Z#2", 7.0)]
    assert found("1:-Z") == [("1:-Z", 5.0), ("1:-Z", 7.0)]  # which of them, only the campaign can say
    assert found("1:-Z#3") == []


def test_names_of_columns_are_refused_for_a_universal_file(path: Path) -> None:
    path.write_bytes(dataset58(NUMBERS))
    with pytest.raises(MeasurementError, match="found a universal file"):
        read_signals(path, SignalRequest(names={"force": "1:+Z"}))


@pytest.mark.parametrize(
    ("data_type", "direction", "unit"),
    [
        (8, 1, "m"),
        (11, 2, "m/s"),
        (12, 3, "m/s^2"),
        (12, 4, "rad/s^2"),
        (13, 1, "N"),
        (13, -5, "N*m"),
        (1, 1, None),
    ],
)
def test_data_types_give_si_units_where_there_is_no_label(
    path: Path, data_type: int, direction: int, unit: str | None
) -> None:
    function = only(path, dataset58(NUMBERS, response=(4, direction), quantity=(data_type, "NONE")))
    assert function.unit == unit
    assert function.force is (data_type == 13)


FAULTS = {
    "real values of a frequency response": (dataset58(NUMBERS, **FRF), "no phase"),
    "complex values in time": (dataset58(PAIRS, ordinate=5), "expected real values"),
    "one line": (dataset58(PAIRS[:2], ordinate=5, count=1, **FRF), "at least 2 points"),
    "one value too few": (dataset58(NUMBERS, count=5), "found 4"),
    "one value too many": (dataset58(NUMBERS, count=3), "found more"),
    "many more declared": (dataset58(NUMBERS, count=2**31), "to the end of the file"),
    "not a number": (dataset58([1.0, np.nan, 1.0, 1.0]), "found nan as value 2"),
    "infinite": (dataset58(NUMBERS).replace(b"5.00000E-01", b"5.0000E+999"), "finite"),
    "a letter": (dataset58(NUMBERS).replace(b"5.00000E-01", b"5.0000QE-01"), "expected numbers"),
    "falling times": (dataset58([0.0, 1.0, 0.0, 1.0], count=2, spacing=0), "ascending"),
    "no increment": (dataset58(NUMBERS, step=0.0), "increment"),
    "direction 7": (dataset58(NUMBERS, response=(1, 7)), "direction"),
    "not closed": (dataset58(NUMBERS)[: -len(END)], "end of the file"),
    "not closed before the next": (dataset58(NUMBERS)[: -len(END)] + dataset58(NUMBERS), "opens a dataset"),
    "text between datasets": (dataset58(NUMBERS) + b"text\n" + dataset58(NUMBERS), "opens a dataset"),
    "no number": (END + b"    xx\n" + END, "number of a dataset"),
    "binary: not a number": (dataset58b(packed([1.0, np.nan, 1.0, 1.0], "f")), "value 2"),
    "binary: too few bytes declared": (dataset58b(packed(NUMBERS, "f"), size=12), "16 bytes"),
    "binary: too many bytes declared": (dataset58b(packed(NUMBERS, "f"), size=24), "data"),
    "binary: more bytes than declared": (
        dataset58b(packed([*NUMBERS, 1.0], "f"), size=16),
        "after the declared",
    ),
    "binary: not closed": (dataset58b(packed(NUMBERS, "f"), close=b""), "closes"),
    "binary: numbers of another machine": (dataset58b(packed(NUMBERS, "f"), form=1), "IEEE"),
    "binary: falling times": (dataset58b(packed([0.0, 1.0, 0.0, 1.0], "f"), count=2, spacing=0), "ascending"),
    "binary: cut": (dataset58b(packed(NUMBERS, "f"))[:-20], "bytes of data"),
    "binary: byte order 3": (dataset58b(packed(NUMBERS, "f"), order=3), "byte order"),
}


def test_faults_are_refused_with_the_dataset(subtests: pytest.Subtests, path: Path) -> None:
    for fault in FAULTS:
        with subtests.test(fault=fault):
            content, what = FAULTS[fault]
            path.write_bytes(dataset(151, b"\n") + content)
            with pytest.raises(MeasurementError, match=what) as caught:
                read_signals(path)
            assert f"{path}: dataset " in caught.value.where
            assert caught.value.remedy


@pytest.mark.parametrize("gap", ["nan", "NaN", "-nan(ind)", "1.#QNAN", "inf", "-Infinity"])
def test_gaps_of_functions_of_frequency_outside_the_band_are_no_damage(path: Path, gap: str) -> None:
    text = dataset58([9.0, *PAIRS[1:]], ordinate=5, step=2.0, **FRF).replace(
        b"  9.00000E+00", f"{gap:>13}".encode()
    )
    path.write_bytes(text)
    (function,) = read_signals(path, SignalRequest(band=(1.0, 6.0))).functions
    assert np.isnan(function.values[0])
    assert function.values[1:].tolist() == COMPLEX[1:]
    with pytest.raises(MeasurementError, match=r"expected finite numbers, found .* as value 1"):
        read_signals(path, SignalRequest(band=(0.0, 6.0)))


def test_gaps_of_binary_functions_and_of_spectra(path: Path) -> None:
    lines = {"abscissa": (18, "Hz"), "step": 2.0}
    binary = dataset58b(packed([*PAIRS[:4], np.nan, np.inf, 7.0, 8.0], "d"), ordinate=6, step=2.0, **FRF)
    coherence = dataset58([1.0, 0.5, np.nan, 1.0], function=6, reference=(3, 1), **lines)
    path.write_bytes(binary + coherence + dataset58([1.0, 2.0, np.inf, 4.0], function=9, **lines))
    for band in ((0.0, 2.0), (6.0, 6.0)):
        for one in read_signals(path, SignalRequest(band=band)).functions:
            assert np.isnan(one.values).tolist() == [False, False, True, False]
    with pytest.raises(MeasurementError, match="as value 3"):
        read_signals(path, SignalRequest(band=(0.0, 4.0)))
    path.write_bytes(dataset58([1.0, np.nan, 1.0, 1.0]))  # in time, nothing is outside a band
    with pytest.raises(MeasurementError, match="as value 2"):
        read_signals(path, SignalRequest(band=(100.0, 200.0)))


def test_a_file_that_changes_after_reading_is_noticed(path: Path) -> None:
    function = only(path, dataset58b(packed(NUMBERS, "f")))
    path.write_bytes(path.read_bytes()[:-14])
    with pytest.raises(MeasurementError, match="changed"):
        _ = function.values
