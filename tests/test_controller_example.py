"""The controller example: its shapers against closed forms, and its program."""

from __future__ import annotations

import ctypes
import math
import re
import subprocess
from pathlib import Path

import numpy as np
import pytest

from helpers.generated.compiled import COMPILER, FLAGS
from pkmodes.codegen.generation import generate

pytestmark = pytest.mark.compiler

ROOT = Path(__file__).parents[1]
EXAMPLE = ROOT / "examples/controller_1khz"
STRICT = [flag for flag in FLAGS if flag not in ("-shared", "-fPIC")] + ["-Wconversion", "-Wdouble-promotion"]
ZV, MZV = 1, 2
TICK = 1e-3


class Impulses(ctypes.Structure):
    _fields_ = (("count", ctypes.c_int), ("amplitude", ctypes.c_double * 3), ("delay", ctypes.c_double * 3))


class History(ctypes.Structure):
    _fields_ = (("command", ctypes.c_double * 128), ("newest", ctypes.c_int))


class Shaper:
    def __init__(self, library: ctypes.CDLL) -> None:
        self.code = library
        library.shaper_output.restype = ctypes.c_double
        self.history = History()

    def design(self, kind: int, frequency: float, damping: float) -> tuple[np.ndarray, np.ndarray]:
        found = Impulses()
        given = ctypes.c_int(kind), ctypes.c_double(frequency), ctypes.c_double(damping)
        assert self.code.shaper_design(*given, ctypes.byref(found)) == 0
        return np.array(found.amplitude[: found.count]), np.array(found.delay[: found.count])

    def rest(self, command: float) -> None:
        self.code.shaper_rest(ctypes.byref(self.history), ctypes.c_double(command))

    def output(self, command: float, amplitudes: np.ndarray, delays: np.ndarray) -> float:
        impulses = Impulses(len(delays))
        impulses.amplitude[: len(delays)], impulses.delay[: len(delays)] = amplitudes, delays
        self.code.shaper_append(ctypes.byref(self.history), ctypes.c_double(command))
        arguments = ctypes.byref(self.history), ctypes.byref(impulses), ctypes.c_double(TICK)
        return float(self.code.shaper_output(*arguments))


@pytest.fixture(scope="module")
def shaper(tmp_path_factory: pytest.TempPathFactory) -> Shaper:
    library = tmp_path_factory.mktemp("shaper") / "shaper.so"
    command = [str(COMPILER), *FLAGS, *STRICT, str(EXAMPLE / "shaper.c"), "-o", str(library), "-lm"]
    subprocess.run(command, check=True)
    return Shaper(ctypes.CDLL(str(library)))


def residual(amplitudes: np.ndarray, delays: np.ndarray, frequency: float, damping: float) -> float:
    """Vibration after the impulses, relative to that after one impulse: Singer and Seering 1990, equation 1."""
    omega = 2.0 * math.pi * frequency
    turned = 1j * omega * math.sqrt(1.0 - damping**2) + damping * omega
    return float(abs((amplitudes * np.exp(turned * delays)).sum()) * math.exp(-damping * omega * delays[-1]))


@pytest.mark.parametrize("damping", [0.0, 0.01, 0.1, 0.5])
@pytest.mark.parametrize("frequency", [20.0, 55.6])
@pytest.mark.parametrize("kind", [ZV, MZV])
def test_nothing_is_left_at_the_design_frequency(
    shaper: Shaper, kind: int, frequency: float, damping: float
) -> None:
    amplitudes, delays = shaper.design(kind, frequency, damping)
    assert amplitudes.sum() == pytest.approx(1.0, abs=1e-15)
    assert (amplitudes > 0.0).all()
    assert residual(amplitudes, delays, frequency, damping) < 1e-14


def test_amplitudes_and_delays_are_those_published(shaper: Shaper) -> None:
    """Without damping, for 50 Hz: halves, half a period apart, and the three impulses of MZV."""
    amplitudes, delays = shaper.design(ZV, 50.0, 0.0)
    np.testing.assert_allclose(amplitudes, [0.5, 0.5])
    np.testing.assert_allclose(delays, [0.0, 0.01])
    amplitudes, delays = shaper.design(MZV, 50.0, 0.0)
    np.testing.assert_allclose(amplitudes, [0.29289, 0.41421, 0.29289], atol=1e-5)
    np.testing.assert_allclose(delays, [0.0, 0.0075, 0.015])


def test_a_frequency_five_percent_off_leaves_less_with_mzv(shaper: Shaper) -> None:
    left = {kind: residual(*shaper.design(kind, 50.0, 0.0), 52.5, 0.0) for kind in (ZV, MZV)}
    assert left[ZV] == pytest.approx(math.sin(0.05 * math.pi / 2.0), rel=1e-6)  # |1 + exp(i pi 1.05)| / 2
    assert left[MZV] < left[ZV]


@pytest.mark.parametrize("frequency", [0.0, -1.0, math.nan, math.inf])
def test_no_impulses_for_numbers_that_are_no_frequency(shaper: Shaper, frequency: float) -> None:
    found = Impulses(7)
    given = ctypes.c_int(ZV), ctypes.c_double(frequency), ctypes.c_double(0.01)
    assert shaper.code.shaper_design(*given, ctypes.byref(found)) == -1
    assert found.count == 7


def test_the_output_is_the_delayed_command(shaper: Shaper) -> None:
    """Of a command that is linear in time, between the ticks, too."""
    shaper.rest(0.0)
    amplitudes, delays = np.array([0.25, 0.75]), np.array([0.0, 0.01234])
    for k in range(1, 400):
        found = shaper.output(k * TICK, amplitudes, delays)
    assert found == pytest.approx(399 * TICK - 0.75 * 0.01234, abs=1e-12)


def test_the_output_stays_within_the_commands_however_the_impulses_change(shaper: Shaper) -> None:
    rng = np.random.default_rng(3)
    shaper.rest(1.0)
    for k in range(2000):
        amplitudes, delays = shaper.design(int(rng.integers(1, 3)), 10.0 ** rng.uniform(-1, 3), 0.01)
        found = shaper.output(2.0 if k >= 1000 else 1.0, amplitudes, delays)
        assert 1.0 - 1e-12 <= found <= 2.0 + 1e-12
        if k < 1000 or k > 1000 + 128:
            assert found == pytest.approx(1.0 if k < 1000 else 2.0, abs=1e-12)


@pytest.mark.parametrize("precision", [[], ["-DPKMODES_FLOAT"]])
def test_the_program_shows_what_the_shapers_of_the_pose_gain(tmp_path: Path, precision: list[str]) -> None:
    generate(ROOT / "robots/linear-delta-2022.toml", tmp_path / "model")
    program, model = tmp_path / "loop", tmp_path / "model"
    files = [EXAMPLE / "main.c", EXAMPLE / "shaper.c", model / "linear_delta_2022.c"]
    command = [str(COMPILER), *STRICT, *precision, f"-I{model}", *map(str, files), "-o", str(program), "-lm"]
    subprocess.run(command, check=True)
    printed = subprocess.run([str(program), "200"], check=True, capture_output=True, text=True).stdout
    assert re.search(r"^\d{5} ticks; impulses kept at 0$", printed, flags=re.MULTILINE)
    left = {
        name.strip(): float(part)
        for name, part in re.findall(r"^(.{18}) +[\d.]+ +([\d.]+) ", printed, flags=re.MULTILINE)
    }
    assert left["none"] == 1.0
    assert left["ZV, of the pose"] < 0.02
    assert left["MZV, of the pose"] < 0.02
    assert left["ZV, of the pose"] < 0.25 * left["ZV, fixed"]
    assert left["MZV, of the pose"] < 0.5 * left["MZV, fixed"]
