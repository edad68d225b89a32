"""The registry of file formats: a format of tests is found by content or suffix, and read like CSV."""

from __future__ import annotations

import json
from os import PathLike, fspath
from pathlib import Path

import pytest

from helpers.diagnoses.measurement_files import CHANNELS, HEADER, ROW
from pkmodes import diagnosis, updating
from pkmodes.core.base.errors import MeasurementError
from pkmodes.loop.measured.csv_format import CSV
from pkmodes.loop.measured.formats import Format, Machine
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.measured.reading import FORMATS, format_of, read_measurements

RECORDS = json.dumps(
    {
        "pose": ["A", "A"],
        "frequency": [55.5, 60],
        "sigma": [0.05, 0.1],
        "points": [[0.6, 0, -0.245], [0.6, 0, -0.245]],
    }
)


def read_records(path: str | PathLike[str], machine: Machine) -> Measurements:
    """Read columns of measurements from a JSON object."""
    columns = json.loads(Path(path).read_text(encoding="utf-8"))
    for name in columns.get("shapes", {}):
        if name not in machine.channels:
            raise MeasurementError(f"{name} is not a coordinate", fspath(path), "correct the name")
    size = len(columns["points"][0])
    components = next(names for names in machine.components if len(names) == size)
    return Measurements.from_rows(**columns, components=components, source=fspath(path))


@pytest.fixture
def records(monkeypatch: pytest.MonkeyPatch) -> Format:
    made_up = Format("records", (".json",), lambda head: head.lstrip().startswith(b"{"), read_records)
    monkeypatch.setitem(FORMATS, made_up.name, made_up)
    return made_up


@pytest.mark.parametrize("name", ["modes.json", "modes.JSON", "modes.csv", "modes"])
def test_a_format_is_recognised_by_its_content(tmp_path: Path, records: Format, name: str) -> None:
    path = tmp_path / name
    path.write_text(RECORDS)
    assert format_of(path) is records
    data = read_measurements(path, CHANNELS)
    assert data.frequency.tolist() == [55.5, 60.0]
    assert data.source == str(path)
    assert updating.read(path).points.tolist() == [[0.6, 0.0, -0.245]]
    assert diagnosis.read_measurements(path, CHANNELS).labels == ("A",)
    path.write_text(f"# from a test\n\n{HEADER}\n{ROW}\n")
    assert format_of(path) is CSV


def test_a_reader_knows_the_machine(tmp_path: Path, records: Format) -> None:
    path = tmp_path / "modes.json"
    path.write_text(RECORDS.replace('"points"', '"shapes": {"y_9": [1, 1]}, "points"'))
    with pytest.raises(MeasurementError, match="y_9 is not a coordinate"):
        updating.read(path)


def test_a_file_of_no_known_content_is_taken_at_its_suffix(tmp_path: Path, records: Format) -> None:
    for name, expected in (
        ("modes.json", records),
        ("MODES.JSON", records),
        ("modes.csv", CSV),
        ("modes.txt", CSV),
        ("modes", CSV),
    ):
        path = tmp_path / name
        assert format_of(path) is expected
        path.write_bytes(b"\x00\xff neither")
        assert format_of(path) is expected
    assert format_of(tmp_path) is CSV
    assert format_of("null\0character.csv") is CSV


@pytest.mark.parametrize(
    ("name", "content", "expected"),
    [
        ("modes.unv", b"    -1\n    55\n", 'expected the names of the columns, found "-1"'),
        ("modes.xlsx", b"PK\x03\x04", "expected CSV text, found an Excel workbook or another archive"),
        ("modes.mat", b"\xfe\x00\xff", "expected UTF-8 text, found the byte 0xfe"),
        ("modes.json", b"", "expected a header and rows, found none"),
    ],
)
def test_a_file_of_an_unknown_format_is_read_as_csv(
    tmp_path: Path, name: str, content: bytes, expected: str
) -> None:
    path = tmp_path / name
    path.write_bytes(content)
    with pytest.raises(MeasurementError, match="expected") as error:
        updating.read(path)
    assert error.value.what == expected
    assert error.value.where.startswith(str(path))
