"""Whole universal files: those of measuring systems, and damaged ones."""

from __future__ import annotations

import random
from collections.abc import Sequence
from itertools import product
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from modaltest.signals.universal import dataset, dataset58, dataset58b, packed
from pkmodes.core.base.errors import MeasurementError
from pkmodes.modaltest.campaign.campaign import read_campaign
from pkmodes.modaltest.campaign.identify import identify
from pkmodes.modaltest.signals.functions import FunctionKind
from pkmodes.modaltest.signals.reading import read_signals

#: From github.com/ladisk/pyuff at 44a12ca, with its licence.  The expected values are read off the files by eye.
DATA = Path(__file__).parent / "data"


def test_binary_double_precision() -> None:
    (sine,) = read_signals(DATA / "binary8byte.uff").functions
    assert (sine.kind, sine.response, sine.unit, sine.abscissa.size) == (FunctionKind.TIME, "1", "g0", 250)
    assert sine.abscissa[-1] == pytest.approx(2.49)
    # the file says: sine 5 Hz, sampled at 100 Hz; the time step of single precision adds up
    np.testing.assert_allclose(sine.values, np.sin(2 * np.pi * 5.0 * sine.abscissa), atol=1e-5)


def test_a_header_outside_ascii() -> None:
    (response,) = read_signals(DATA / "non_ascii_header.uff").functions
    assert (response.kind, response.unit, response.reference_unit) == (FunctionKind.FRF, "m/s^2", "N")
    np.testing.assert_allclose(response.abscissa, 0.195313 * np.arange(6), rtol=1e-12)
    assert response.values[0] == 0.407994
    assert response.values[-1] == 3.75037 + 2.93363j


def test_an_incomplete_last_line() -> None:
    (signal,) = read_signals(DATA / "time-history-not-all-columns-filled.uff").functions
    assert (signal.values.size, signal.values[0], signal.values[-1]) == (13, -3.81956, -5.84096)
    assert signal.unit == "m/s^2"
    assert signal.abscissa[-1] == pytest.approx(6e-4)


def test_uneven_lines_of_a_spectrum() -> None:
    (spectrum,) = read_signals(DATA / "sample_dataset58_psd.uff").functions
    assert (spectrum.kind, spectrum.unit, spectrum.abscissa.size) == (FunctionKind.SPECTRUM, "g0^2/Hz", 3201)
    assert spectrum.abscissa[:3].tolist() == [0.0, 1.0, 2.0]
    assert spectrum.values[:3].tolist() == [0.0, 1.255863e-06, 4.311770e-07]


def test_minus_one_inside_a_header(tmp_path: Path) -> None:
    """The sample declares more values than it has: it is refused, and read once it declares its 42."""
    content = (DATA / "dataset_milestone_in_header.uff").read_bytes()
    path = tmp_path / "corrected.uff"
    path.write_bytes(content)
    with pytest.raises(MeasurementError, match="2508876"):
        read_signals(path)
    path.write_bytes(content.replace(b"   2508876", b"        42"))
    (signal,) = read_signals(path).functions
    assert (signal.values.size, signal.values[0], signal.values[-1]) == (42, -6.73633e-3, 5.39653e-3)
    assert (signal.response, signal.unit, signal.abscissa[0]) == ("1:+X", "Pa", 1.11858e-5)


@pytest.mark.parametrize("name", ["heat_engine_housing.uff", "TestLab 161 164 18 15 82.uff"])
def test_files_of_geometry_hold_no_signals(name: str) -> None:
    found = read_signals(DATA / name)
    assert (found.functions, found.modes) == ((), ())
    results = [one for one in found.messages if "analysis type 1 at location 1 is not a mode" not in one]
    assert not results  # a file has results of statics
    assert any("holds nodes" in why for why in found.skipped)
    trace_lines = "dataset 82 holds trace lines, which are for drawing"
    assert (trace_lines in found.skipped) == name.startswith("TestLab")


def nodes(number: int, axes: dict[int, int]) -> bytes:
    """A dataset 15 or 2411 of nodes with the coordinate systems of their displacements."""
    place, end = "".join(f"{x:13.5e}" for x in (0.1, 0.2, 0.3)), "\n" if number == 2411 else ""
    lines = [f"{node:10d}{0:10d}{system:10d}{8:10d}{end}{place}\n" for node, system in axes.items()]
    return dataset(number, "".join(lines).encode())


@pytest.mark.parametrize("number", [15, 2411])
def test_axes_that_differ_from_node_to_node_are_said(tmp_path: Path, number: int) -> None:
    path = tmp_path / "m.unv"
    modes = mode_2414(2, 2, [0.0, 31.2, *[0.0] * 10], {1: [0.0, 0.0, 1.0], 2: [0.0, 0.0, -0.5]})
    path.write_bytes(nodes(number, {1: 1, 2: 5, 3: 7}) + modes)
    found = read_signals(path)
    assert [mode.frequency for mode in found.modes] == [31.2]
    (said,) = found.messages
    assert "coordinate system 1 at node 1, 5 at node 2: a direction" in said
    for same in (nodes(number, {1: 1, 2: 1, 3: 7}), dataset(number, b"   no node\n"), b""):
        path.write_bytes(same + modes + dataset(82, b"         1         2         8\nline\n"))
        assert not read_signals(path).messages


def test_a_file_of_geometry_alone_is_refused_as_that(tmp_path: Path) -> None:
    (tmp_path / "m.unv").write_bytes(nodes(2411, {1: 0}) + dataset(82, b"x\n") + dataset(1858, b"x\n"))
    (tmp_path / "c.toml").write_text(
        'format = 1\nchannels = ["a"]\nband = ["1 Hz", "9 Hz"]\n[[sensor]]\nname = "1:+Z"\nchannel = "a"\n'
        '[[record]]\npose = "P"\nkind = "modes"\nfiles = ["m.unv"]\n'
    )
    campaign = read_campaign(tmp_path / "c.toml")
    with pytest.raises(MeasurementError) as error:
        identify(campaign)
    assert "dataset 2411 holds nodes; dataset 82 holds trace lines, which are for drawing" in error.value.what
    assert "dataset 1858 holds what is not read" in error.value.what


def mode_2414(
    analysis: int, data_type: int, reals: Sequence[float], values: dict[int, Sequence[float]]
) -> bytes:
    """A dataset 2414 with three displacements at each node, laid out as the format says."""
    lines = [f"{1:10d}", "mode", f"{1:10d}", *["NONE"] * 5]
    lines.append("".join(f"{n:10d}" for n in (1, analysis, 2, 8, data_type, 3)))
    lines += ["".join(f"{n:10d}" for n in (0, 0, 0, 0, 0, 1, 0, 0)), f"{0:10d}{0:10d}"]
    for part in (reals[:6], reals[6:]):
        lines.append("".join(f"{x:13.5E}" for x in part))
    for node, numbers in values.items():
        lines += [f"{node:10d}", "".join(f"{x:13.5E}" for x in numbers)]
    return dataset(2414, "".join(f"{line}\n" for line in lines).encode())


def test_modes_of_dataset_2414(tmp_path: Path) -> None:
    """Time, frequency, eigenvalue, modal mass, viscous and hysteretic damping; the complex eigenvalue."""
    normal = mode_2414(2, 2, [0.0, 12.5, 6.2e3, 7.0, 0.013, 0.0, *[0.0] * 6], {4: [0.0, 0.5, -1.0]})
    structural = mode_2414(2, 4, [0.0, 40.0, 0.0, 1.0, 0.0, 0.05, *[0.0] * 6], {4: [1.0, 0.0, 0.0]})
    eigenvalue = -3.0 + 400.0j
    numbers = [0.0] * 6 + [eigenvalue.real, eigenvalue.imag, 1.0, 0.0, 0.0, 0.0]
    damped = mode_2414(3, 5, numbers, {9: [1.0, 2.0, 0.0, 0.0, -0.5, 0.25]})
    path = tmp_path / "m.unv"
    path.write_bytes(normal + structural + damped + mode_2414(5, 5, [0.0] * 12, {9: [0.0] * 6}))
    found = read_signals(path)
    assert [(one.frequency, one.damping) for one in found.modes[:2]] == [(12.5, 0.013), (40.0, 0.025)]
    assert found.modes[0].shape == {"4:+X": 0.0, "4:+Y": 0.5, "4:+Z": -1.0}
    assert found.modes[2].frequency == pytest.approx(abs(eigenvalue) / (2 * np.pi), rel=1e-12)
    assert found.modes[2].damping == pytest.approx(3.0 / abs(eigenvalue), rel=1e-12)
    assert found.modes[2].shape["9:+Z"] == -0.5 + 0.25j
    assert ["analysis type 5 at location 1 is not a mode" in one for one in found.messages] == [True]
    path.write_bytes(normal[:-20])
    with pytest.raises(MeasurementError, match="dataset 1 \\(2414\\)"):
        read_signals(path)


def test_real_and_complex_modes() -> None:
    modes = read_signals(DATA / "uff55_translation.uff").modes
    assert [(mode.frequency, mode.damping) for mode in modes[:2]] == [(10.0, None), (12.0, None)]
    assert modes[0].shape["4:+Z"] == 0.724863
    assert modes[1].shape["2:+X"] == -3.98226e-2
    assert len(modes[0].shape) == 12
    (mode,) = read_signals(DATA / "uff55 sample_test record10.uff").modes
    # eigenvalue -0.1111111 + 41.11111j
    assert mode.frequency == pytest.approx(abs(-0.1111111 + 41.11111j) / (2 * np.pi), rel=1e-12)
    assert mode.damping == pytest.approx(0.1111111 / abs(-0.1111111 + 41.11111j), rel=1e-12)
    assert mode.shape == {
        "111111:+X": 0,
        "111111:+Y": 0.1111111 + 0.09111111j,
        "111111:+Z": 0.007111111 + 0.004111111j,
        "60101:+X": 0,
        "60101:+Y": 0,
        "60101:+Z": -0.04111111 - 0.01111111j,
    }


def mode55(
    analysis: int, reals: list[float], values: list[float], characteristic: int, components: int
) -> bytes:
    kind = [1, analysis, characteristic, 8, 2 if analysis == 2 else 5, components]
    lines = ["NONE"] * 5 + ["".join(f"{one:10d}" for one in kind), f"{2:10d}{len(reals):10d}{1:10d}{3:10d}"]
    lines += ["".join(f"{one:13.5E}" for one in reals), f"{77:10d}"]
    lines += ["".join(f"{one:13.5E}" for one in values[i : i + 6]) for i in range(0, len(values), 6)]
    return dataset(55, "".join(f"{line}\n" for line in lines).encode())


def test_damping_and_rotations_of_modes(tmp_path: Path) -> None:
    path = tmp_path / "modes.uff"
    six = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]
    viscous = mode55(2, [40.0, 1.0, 0.02, 0.0], six, 3, 6)
    structural = mode55(2, [50.0, 1.0, 0.0, 0.06], six[:3], 2, 3)
    rigid = mode55(2, [0.0, 1.0, 0.0, 0.0], six[:3], 2, 3)
    forced = mode55(5, [50.0, 1.0, 0.0, 0.0], six[:3], 2, 3)
    second_order = mode55(7, [-3.0, 4.0, 0, 0, 0, 0], [*six, *six], 3, 6)
    path.write_bytes(viscous + structural + rigid + forced + second_order)
    found = read_signals(path)
    assert [mode.damping for mode in found.modes] == [0.02, 0.03, 0.6]
    assert found.modes[2].frequency == pytest.approx(5.0 / (2 * np.pi))
    assert found.modes[2].shape["77:+Z"] == 5 + 6j
    directions = ["+X", "+Y", "+Z", "+RX", "+RY", "+RZ"]
    assert found.modes[0].shape == {f"77:{one}": n for one, n in zip(directions, six, strict=True)}
    assert ["frequency 0" in found.messages[0], "analysis type 5" in found.messages[1]] == [True, True]


SETS = [
    dataset(151, b"NONE\n"),
    dataset58([0.5, 1.5, 2.5, 3.5], response=(1, 1)),
    dataset58b(packed([0.5, 1.5, 2.5, 3.5], "f"), response=(2, 1)),
    dataset58b(packed([0.5, 1.5, 2.5, 3.5], "d", 2), order=2, ordinate=4, response=(3, 1), close=b"    -1\n"),
    mode55(2, [40.0, 1.0, 0.02, 0.0], [1.0, 2.0, 3.0], 2, 3),
]


def test_a_file_cut_anywhere_is_refused_except_between_datasets(tmp_path: Path) -> None:
    path, whole = tmp_path / "cut.uff", b"".join(SETS)
    # Complete from the last character of a closing delimiter to the blanks of the next opening one.
    ends = np.cumsum([len(one) for one in SETS])
    complete = {int(end) - after for end in ends for after in range(-4, 2)}
    for size in range(len(whole)):
        path.write_bytes(whole[:size])
        if size in complete:
            found = read_signals(path)
            expected = sum(end - 1 <= size for end in ends[1:].tolist())
            assert len(found.functions) + len(found.modes) == expected
        else:
            with pytest.raises(MeasurementError):
                read_signals(path)


@given(place=st.integers(0, sum(map(len, SETS)) - 1), byte=st.integers(0, 255))
@settings(max_examples=150, deadline=None)
def test_a_changed_byte_never_loses_a_dataset(
    place: int, byte: int, tmp_path_factory: pytest.TempPathFactory
) -> None:
    content = bytearray(b"".join(SETS))
    content[place] = byte
    path = tmp_path_factory.getbasetemp() / "changed.uff"
    path.write_bytes(content)
    try:
        found = read_signals(path)
    except MeasurementError:
        return
    # A changed type or number of a dataset is another dataset: then it is skipped, which is said for type 58.
    assert len(found.functions) + len(found.modes) + len(found.messages) >= 3


def test_random_bytes_are_refused(tmp_path: Path) -> None:
    numbers = random.Random(0)
    for number in range(200):
        path = tmp_path / f"random{number % 4}{('.uff', '.mat', '.csv', '')[number % 4]}"
        path.write_bytes(numbers.randbytes(numbers.randrange(1, 4000)))
        with pytest.raises(MeasurementError):
            read_signals(path)


def test_files_without_content_are_refused(subtests: pytest.Subtests, tmp_path: Path) -> None:
    for suffix, content in product(
        [".uff", ".csv", ".mat", ".bin"], [b"", b"\n\n", b"    -1\n", b"    -1\n    -1\n", b"text"]
    ):
        with subtests.test(f"{suffix}, {content}"):
            path = tmp_path / f"empty{suffix}"
            path.write_bytes(content)
            with pytest.raises(MeasurementError, match=r"expected|cannot read") as caught:
                read_signals(path)
            assert str(path) in caught.value.where


def test_folders_and_missing_files_are_refused(tmp_path: Path) -> None:
    with pytest.raises(MeasurementError, match="a folder"):
        read_signals(tmp_path)
    with pytest.raises(MeasurementError, match="no such file"):
        read_signals(tmp_path / "missing.uff")
    with pytest.raises(MeasurementError, match="null"):
        read_signals("null\0.uff")


def test_a_universal_file_whose_beginning_is_lost_is_not_taken_for_a_table(tmp_path: Path) -> None:
    path = tmp_path / "lost.uff"
    path.write_bytes(SETS[1][10:] + SETS[1])
    with pytest.raises(MeasurementError, match="opens a dataset"):
        read_signals(path)
