"""Sound files, written byte by byte: nothing here uses the code under test."""

from __future__ import annotations

import resource
import struct
from pathlib import Path

import numpy as np
import pytest

from pkmodes.core.base.errors import MeasurementError
from pkmodes.modaltest.signals.functions import SignalFile, SignalRequest
from pkmodes.modaltest.signals.reading import read_signals

#: Two channels of four samples, parts of full scale.
CHANNELS = np.array([[0.0, 0.5], [-0.5, 0.25], [0.75, -1.0], [-0.125, 0.0]])


def chunk(name: bytes, body: bytes, size: int | None = None) -> bytes:
    declared = len(body) if size is None else size
    return name + struct.pack("<I", declared) + body + b"\0" * (len(body) % 2)


def form(code: int = 1, channels: int = 2, rate: int = 4, each: int | None = None, bits: int = 16) -> bytes:
    """The chunk of the form; of more than two bytes a code by a GUID, as the extended form has it."""
    block = channels * bits // 8 if each is None else each
    return chunk(b"fmt ", struct.pack("<HHIIHH", code, channels, rate, rate * block, block, bits))


def wav(*chunks: bytes) -> bytes:
    body = b"WAVE" + b"".join(chunks)
    return b"RIFF" + struct.pack("<I", len(body)) + body


def packed(bits: int) -> bytes:
    """The samples as whole numbers; those of eight bits have their middle at 128."""
    numbers = (CHANNELS * 2.0 ** (bits - 1)).clip(max=2.0 ** (bits - 1) - 1).astype(np.int64).ravel()
    if bits == 8:
        return bytes((numbers + 128).astype(np.uint8))
    return b"".join(int(number).to_bytes(bits // 8, "little", signed=True) for number in numbers)


def read(folder: Path, content: bytes, asked: SignalRequest = SignalRequest()) -> SignalFile:  # noqa: B008
    path = folder / "hit.wav"
    path.write_bytes(content)
    return read_signals(path, asked)


FORMS = {
    "8 bits": wav(form(bits=8), chunk(b"data", packed(8))),
    "16 bits": wav(form(), chunk(b"data", packed(16))),
    "24 bits": wav(form(bits=24), chunk(b"data", packed(24))),
    "32 bits": wav(form(bits=32), chunk(b"data", packed(32))),
    "floating": wav(form(3, bits=32), chunk(b"data", CHANNELS.astype("<f4").tobytes())),
    "double": wav(form(3, bits=64), chunk(b"data", CHANNELS.tobytes())),
    "other chunks": wav(
        chunk(b"bext", b"odd"),
        form(),
        chunk(b"LIST", b"INFOx"),
        chunk(b"data", packed(16)),
        chunk(b"id3 ", b"1"),
    ),
}


@pytest.mark.parametrize("name", FORMS)
def test_channels_are_called_by_their_number_and_are_parts_of_full_scale(tmp_path: Path, name: str) -> None:
    found = read(tmp_path, FORMS[name])
    assert [(one.response, one.unit, one.force) for one in found.functions] == [
        ("1", None, False),
        ("2", None, False),
    ]
    for one, channel in zip(found.functions, CHANNELS.T, strict=True):
        assert one.values.tolist() == channel.tolist()
        assert one.abscissa.tolist() == [0.0, 0.25, 0.5, 0.75]
    assert "parts of full scale" in found.messages[0]


def test_a_single_channel(tmp_path: Path) -> None:
    (found,) = read(tmp_path, wav(form(channels=1), chunk(b"data", packed(16)))).functions
    assert found.values.tolist() == CHANNELS.ravel().tolist()


def test_the_channel_without_a_sensor_is_the_force_where_one_is_needed(tmp_path: Path) -> None:
    content = FORMS["16 bits"]
    found = read(tmp_path, content, SignalRequest(sensors=frozenset({"2"}), force=True))
    assert {one.response: one.force for one in found.functions} == {"force": True, "2": False}
    assert "channel 1, which belongs to no sensor, is taken as the force" in found.messages[-1]
    found = read(
        tmp_path, content, SignalRequest(sensors=frozenset({"a"}), names={"force": "2", "a": "1"}, force=True)
    )
    assert {one.response: one.values[0] for one in found.functions} == {"a": 0.0, "force": 0.5}
    assert len(found.messages) == 1
    (alone,) = read(tmp_path, content, SignalRequest(sensors=frozenset({"2"}))).functions
    assert not alone.force
    three = wav(
        form(channels=4, each=8), chunk(b"data", packed(16))
    )  # which of three is the force is not known
    assert [
        one.response
        for one in read(tmp_path, three, SignalRequest(sensors=frozenset({"2"}), force=True)).functions
    ] == ["2"]


HUGE = 0xFFFFFFF0
FAULTS = {
    "not closed": (
        wav(form(), chunk(b"data", packed(16), 0xFFFFFFFF)),
        "expected 4294967295 bytes of the chunk",
    ),
    "cut": (FORMS["16 bits"][:-6], "expected 16 bytes of the chunk"),
    "a second chunk of data": (
        wav(form(), chunk(b"data", packed(16)), chunk(b"data", b"", HUGE)),
        "bytes of the chunk",
    ),
    "a huge chunk before": (
        wav(chunk(b"LIST", b"", HUGE), form(), chunk(b"data", packed(16))),
        "of the chunk",
    ),
    "no samples": (wav(form(), chunk(b"data", b"")), "expected whole samples"),
    "half a sample": (wav(form(), chunk(b"data", packed(16)[:-2])), "expected whole samples of 4 bytes"),
    "no form": (wav(chunk(b"data", packed(16))), "one with their format"),
    "no data": (wav(form()), "expected one chunk of samples"),
    "a short form": (wav(chunk(b"fmt ", b"\1\0\2\0"), chunk(b"data", packed(16))), "one with their format"),
    "compressed": (wav(form(0x55), chunk(b"data", packed(16))), "found 16 bits of type 85"),
    "odd bits": (wav(form(bits=12, each=4), chunk(b"data", packed(16))), "found 12 bits of type 1"),
    "no channels": (wav(form(channels=0), chunk(b"data", packed(16))), "found 0 in 0 bytes"),
    "many channels": (
        wav(form(channels=65535, each=6), chunk(b"data", packed(16))),
        "found 65535 in 6 bytes",
    ),
    "no rate": (wav(form(rate=0), chunk(b"data", packed(16))), "expected a sampling rate above 0"),
    "no numbers": (
        wav(form(3, bits=64), chunk(b"data", np.full((4, 2), np.nan).tobytes())),
        "expected finite numbers",
    ),
    "nothing": (b"RIFF\4\0\0\0WAVE", "expected one chunk of samples"),
}


@pytest.mark.parametrize("name", FAULTS)
def test_damaged_files_are_refused(tmp_path: Path, name: str) -> None:
    content, message = FAULTS[name]
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    with pytest.raises(MeasurementError) as error:
        read(tmp_path, content)
    assert message in error.value.what
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 200_000  # [kB]


def test_any_other_damage_is_an_error_or_read(tmp_path: Path) -> None:
    """Every byte of the heads, replaced by others: never another exception."""
    whole = FORMS["16 bits"]
    for place in range(44):
        for value in (0, 1, 0x7F, 0xFF):
            damaged = whole[:place] + bytes([value]) + whole[place + 1 :]
            try:
                found = read(tmp_path, damaged)
            except MeasurementError:
                continue
            assert found.functions
