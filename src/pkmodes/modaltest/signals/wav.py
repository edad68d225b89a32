"""Sound files (.wav), as data loggers and audio interfaces write them: channels ``1``, ``2``, ... in their order.

Numbers are fractions of full scale, for which the file gives no unit.  The chunks of the file are checked before
SciPy reads it, which would allocate the sizes in a damaged header (Multimedia Programming Interface and Data
Specifications 1.0, IBM and Microsoft, 1991).
"""

from __future__ import annotations

import struct
import warnings
from os import fspath
from pathlib import Path
from typing import Any, BinaryIO, NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import MeasurementError, shown
from pkmodes.loop.measured.formats import Format
from pkmodes.modaltest.signals.checks import MIN_POINTS, check_finite
from pkmodes.modaltest.signals.functions import (
    FORCE,
    Array,
    Function,
    FunctionKind,
    SignalFile,
    SignalRequest,
)
from pkmodes.modaltest.signals.variables import MAX_VALUES, load_or_refuse

RIFF, WAVE = (b"RIFF", b"RIFX"), b"WAVE"
#: Bytes of the header of the file, of the header of a chunk, and of the number format.
HEADER_SIZE, CHUNK_HEADER_SIZE, FORMAT_SIZE = 12, 8, 16
#: Codes of number formats: integers, floating point, and either of them with more channels.
INTEGERS, FLOATING, EXTENDED = 1, 3, 0xFFFE
BITS = {INTEGERS: (8, 16, 24, 32), FLOATING: (32, 64), EXTENDED: (8, 16, 24, 32, 64)}
MAX_CHANNELS = 1024
INCOMPLETE = "open it in a sound editor and export it again, as WAV with 16, 24 or 32 bits (PCM)"


class _SampleFormat(NamedTuple):
    """The number format of a file: code, channels, sampling rate [Hz], bytes of a sample and bits."""

    code: int
    channels: int
    rate: int
    bytes_per_sample: int
    bits: int


def read_wav(path: Path, request: SignalRequest) -> SignalFile:
    """Read a sound file.

    Raises MeasurementError if it is damaged, compressed or incomplete.
    """
    source = fspath(path)
    with path.open("rb") as file:
        form = _check_chunks(file, path.stat().st_size, source)
    samples = load_or_refuse(lambda: _samples(path), source, "WAV")
    signals = dict(zip(map(str, range(1, form.channels + 1)), samples.T, strict=True))  # as stored
    own_names = request.own_names(signals, source)
    messages = [f"{source}: its numbers are parts of full scale: sizes are known but for a factor"]
    unclaimed = [
        name for name in signals if name not in (request.sensors or signals) and name not in own_names
    ]
    if request.force and FORCE not in own_names.values() and len(unclaimed) == 1:
        own_names[unclaimed[0]] = FORCE
        messages.append(
            f"{source}: channel {unclaimed[0]}, which belongs to no sensor, is taken as the force"
        )
    time = np.arange(len(samples)) / form.rate
    functions = []
    for name, stored in signals.items():
        new_name = own_names.get(name, name)
        if new_name and (new_name == FORCE or request.wants(new_name)):
            values = _relative_to_full_scale(stored)
            check_finite(values, f"{source}: channel {name}")
            functions.append(
                Function(FunctionKind.TIME, new_name, "", time, values, None, None, new_name == FORCE)
            )
    return SignalFile(source, tuple(functions), (), tuple(messages))


def _samples(path: Path) -> NDArray[Any]:
    """Return all samples as they are stored, (N, channels)."""
    from scipy.io import wavfile

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", wavfile.WavFileWarning)  # chunks that it does not know
        numbers: NDArray[Any] = wavfile.read(path)[1]
    return numbers.reshape(len(numbers), -1)


def _relative_to_full_scale(stored: NDArray[Any]) -> Array:
    """Return the samples of a channel relative to full scale; unsigned eight-bit samples are centred first."""
    values: Array = stored.astype(np.float64)
    if stored.dtype.kind != "f":
        size = 2.0 ** (8 * stored.dtype.itemsize - 1)  # SciPy puts 24 bits into the upper ones of 32
        values -= size if stored.dtype.kind == "u" else 0.0
        values /= size
    return values


def _check_chunks(file: BinaryIO, length: int, source: str) -> _SampleFormat:
    """Check all chunks of a file and return its number format.

    Raises MeasurementError if a chunk is longer than the file, or the numbers are in an unsupported format.
    """
    order = "<" if file.read(HEADER_SIZE).startswith(RIFF[0]) else ">"
    form, data, offset = None, list[int](), HEADER_SIZE
    while offset + CHUNK_HEADER_SIZE <= length:
        file.seek(offset)
        name, size = struct.unpack(f"{order}4sI", file.read(CHUNK_HEADER_SIZE))
        if size > length - offset - CHUNK_HEADER_SIZE:
            chunk_name = shown(name.decode("latin-1").strip())
            message = f"expected {size} bytes of the chunk {chunk_name}, "
            message += f"found {length - offset - CHUNK_HEADER_SIZE} to the end of the file"
            raise MeasurementError(message, source, INCOMPLETE)
        if name == b"fmt " and size >= FORMAT_SIZE:
            code, channels, rate, _, bytes_each, bits = struct.unpack(
                f"{order}HHIIHH", file.read(FORMAT_SIZE)
            )
            form = _SampleFormat(code, channels, rate, bytes_each, bits)
        elif name == b"data":
            data.append(size)
        offset += CHUNK_HEADER_SIZE + size + size % 2
    if form is None or len(data) != 1:
        message = "expected one chunk of samples and one with their format"
        raise MeasurementError(message, source, INCOMPLETE)
    bytes_per_sample, problem = form.bytes_per_sample, ""
    if form.bits not in BITS.get(form.code, ()):
        problem = f"expected plain numbers of 8 to 64 bits, found {form.bits} bits of type {form.code}"
    elif not 1 <= form.channels <= MAX_CHANNELS or bytes_per_sample != form.channels * form.bits // 8:
        counts = f"{form.channels} in {bytes_per_sample} bytes a sample"
        problem = f"expected 1 to {MAX_CHANNELS} channels, found {counts}"
    elif not form.rate:
        problem = "expected a sampling rate above 0, found 0"
    elif data[0] < MIN_POINTS * bytes_per_sample or data[0] % bytes_per_sample:
        problem = f"expected whole samples of {bytes_per_sample} bytes, at least {MIN_POINTS}, found {data[0]} bytes"
    elif (count := data[0] // bytes_per_sample * form.channels) > MAX_VALUES:
        problem = f"expected at most {MAX_VALUES:,} values, found {count:,}"
    if problem:
        raise MeasurementError(problem, source, INCOMPLETE)
    return form


def is_wav(head: bytes) -> bool:
    """Return whether a file is a sound file."""
    return head.startswith(RIFF) and head[8:HEADER_SIZE] == WAVE


WAV = Format("WAV", (".wav",), is_wav, read_wav)
