"""The shapers in the C of a robot: numbers of `pkmodes.machine.shaping`, and commands that pass them."""

from __future__ import annotations

import ctypes
import math
import re
import subprocess
from itertools import product
from typing import Any

import numpy as np
import pytest

from helpers.generated.compiled import COMPILER
from helpers.generated.held_robots import HeldRobot, build, library_of
from helpers.runs.shared import Shared
from pkmodes.machine.response.moves import shaped_command
from pkmodes.machine.shaping import KINDS, residual, shaper
from pkmodes.machine.shaping.kinds import factors
from pkmodes_description.shapers import SHAPERS

pytestmark = pytest.mark.compiler
MOST, TICKS, POSE, TICK = 64, 128, 2, 1e-3


class Shapers:
    """The functions of one robot in one precision."""

    def __init__(self, robot: HeldRobot, single: bool) -> None:
        self.real: Any = ctypes.c_float if single else ctypes.c_double
        real = self.real

        class Impulses(ctypes.Structure):
            _fields_ = (("count", ctypes.c_int), ("amplitude", real * MOST), ("delay", real * MOST))

        class Shaped(ctypes.Structure):
            _fields_ = (
                ("command", real * POSE),
                ("pending", real * POSE * TICKS),
                ("now", ctypes.c_int),
                ("count", ctypes.c_int),
                ("delay", real * MOST),
            )

        self.impulses, self.state = Impulses, Shaped()
        self._code = ctypes.CDLL(str(library_of(robot.source, single)))
        self._pattern = f"{robot.name}_{{}}{'_f' if single else ''}"

    def function(self, name: str) -> Any:
        return getattr(self._code, self._pattern.format(name))

    def design(self, kind: int, f: float, zeta: float, into: Any = None) -> tuple[int, Any]:
        found = into or self.impulses()
        given = ctypes.c_int(kind), self.real(f), self.real(zeta)
        return self.function("shaper_design")(*given, ctypes.byref(found)), found

    def product(self, kinds: str, f: np.ndarray, zeta: np.ndarray) -> Any:
        names = kinds.split("*")
        status, found = self.design(KINDS.index(names[0]), f[0], zeta[0])
        assert status == 0
        for name, *mode in zip(names[1:], f[1:], zeta[1:], strict=True):
            _, other = self.design(KINDS.index(name), *mode)
            assert self.multiply(found, other) == 0
        return found

    def multiply(self, found: Any, by: Any) -> int:
        status: int = self.function("shaper_multiply")(ctypes.byref(found), ctypes.byref(by))
        return status

    def rest(self, command: float) -> None:
        """One component rests at the command, the other one at twice as much."""
        self.function("shaped_rest")(ctypes.byref(self.state), (self.real * POSE)(command, 2.0 * command))

    def shaped(self, command: float, impulses: Any, status: int = 0, tick: float = TICK) -> float:
        result = (self.real * POSE)(math.pi, 2.0 * math.pi)
        given = ctypes.byref(self.state), ctypes.byref(impulses), self.real(tick)
        pose = (self.real * POSE)(command, 2.0 * command)
        assert self.function("shaped_command")(*given, pose, result) == status
        assert result[1] == 2.0 * result[0]
        return float(result[0])


def arrays(found: Any) -> tuple[np.ndarray, np.ndarray]:
    return np.array(found.amplitude[: found.count]), np.array(found.delay[: found.count])


@pytest.fixture(scope="module")
def robot(shared: Shared) -> HeldRobot:
    return HeldRobot(
        shared.folder("held_printer", lambda folder: HeldRobot.write(folder, "printer")), "printer"
    )


@pytest.fixture(scope="module")
def double(robot: HeldRobot) -> Shapers:
    return Shapers(robot, False)


@pytest.fixture(scope="module")
def single(robot: HeldRobot) -> Shapers:
    return Shapers(robot, True)


def test_the_header_has_the_kinds_of_the_runtime(robot: HeldRobot) -> None:
    upper = robot.name.upper()
    listed = re.findall(rf"#define {upper}_SHAPER_(\w+) (\d+)\n", robot.header)
    names = {name.lower(): int(value) for name, value in listed}
    limits = {"impulses": MOST, "ticks": TICKS, "kinds": len(KINDS)}
    assert names == {**{kind: i for i, kind in enumerate(KINDS)}, **limits}
    # One table: the derivation prints what the runtime designs with.
    assert {kind: factors(kind)[0] for kind in KINDS} == {kind: tuple(of) for kind, of in SHAPERS.items()}


@pytest.mark.parametrize("kind", KINDS)
def test_shapers_are_those_of_the_runtime(double: Shapers, single: Shapers, kind: str) -> None:
    for f, zeta in product((5.0, 31.7, 140.0), (0.0, 0.01, 0.1, 0.6)):
        expected = shaper(kind, f, zeta)
        for code, rounding in ((double, 4e-16), (single, 3e-6)):
            status, found = code.design(KINDS.index(kind), f, zeta)
            assert status == 0
            amplitudes, delays = arrays(found)
            np.testing.assert_allclose(amplitudes, expected.amplitudes, rtol=rounding)
            np.testing.assert_allclose(delays, expected.delays, rtol=rounding)


@pytest.mark.parametrize("kinds", ["zv*zv", "zv*zv*zv", "ei*mzv*zvd", "3hump_ei*zv", "zv*zv*zv*zv*zv*zv"])
def test_products_are_those_of_the_runtime(double: Shapers, single: Shapers, kinds: str) -> None:
    rng = np.random.default_rng(8)
    for _ in range(5):
        f, zeta = rng.uniform(10.0, 60.0, (2, len(kinds.split("*"))))
        zeta *= 1e-3
        expected = shaper(kinds, f, zeta)
        amplitudes, delays = arrays(double.product(kinds, f, zeta))
        np.testing.assert_allclose(delays, expected.delays, rtol=1e-15)
        np.testing.assert_allclose(amplitudes, expected.amplitudes, rtol=2e-15)
        found = single.product(kinds, f, zeta)
        np.testing.assert_allclose(found.delay[: found.count], expected.delays, rtol=1e-6)
        assert sum(found.amplitude[: found.count]) == pytest.approx(1.0, abs=1e-6)
        left = residual(expected._replace(amplitudes=amplitudes, delays=delays), f, zeta)
        assert (left < 0.06).all()


def test_equal_modes_keep_impulses_that_coincide(double: Shapers) -> None:
    """Multiplied by itself, too."""
    f, zeta = np.full(2, 40.0), np.full(2, 0.02)
    expected = shaper("zvd*zvd", f, zeta)
    _, found = double.design(KINDS.index("zvd"), 40.0, 0.02)
    assert double.multiply(found, found) == 0
    amplitudes, delays = arrays(found)
    np.testing.assert_allclose(amplitudes, expected.amplitudes, rtol=1e-15)
    np.testing.assert_allclose(delays, expected.delays, rtol=1e-15)


def test_a_product_with_too_many_impulses_is_refused(double: Shapers) -> None:
    found = double.product("3hump_ei*3hump_ei", np.array([20.0, 30.0]), np.zeros(2))
    _, other = double.design(KINDS.index("zvd"), 40.0, 0.0)
    before = arrays(found)
    assert double.multiply(found, other) == -1
    assert double.multiply(found, double.impulses()) == -1
    assert found.count == 25
    np.testing.assert_array_equal(arrays(found), before)


@pytest.mark.parametrize(
    ("kind", "f", "zeta"),
    [
        (-1, 50.0, 0.0),
        (len(KINDS), 50.0, 0.0),
        *((0, f, 0.01) for f in (0.0, -1.0, math.nan, math.inf)),
        *((0, 50.0, zeta) for zeta in (-0.01, 1.0, math.nan)),
        *((0, f, 0.01) for f in (1e-320, 5e-324)),  # delays beyond all numbers
    ],
)
def test_what_is_no_mode_leaves_the_shaper_as_it_was(
    double: Shapers, kind: int, f: float, zeta: float
) -> None:
    given = double.impulses(7)
    status, found = double.design(kind, f, zeta, given)
    assert status == -1
    assert found.count == 7


def test_a_command_that_is_linear_in_time_is_delayed(double: Shapers, single: Shapers) -> None:
    """Between the ticks, too."""
    for code, rounding in ((double, 1e-12), (single, 1e-6)):
        impulses = code.impulses(2)
        impulses.amplitude[:2], impulses.delay[:2] = [0.25, 0.75], [0.0, 0.01234]
        code.rest(0.0)
        for k in range(1, 400):
            found = code.shaped(k * TICK, impulses)
        assert found == pytest.approx(399 * TICK - 0.75 * 0.01234, abs=rounding)


def test_one_shaper_makes_the_command_of_the_runtime(double: Shapers, single: Shapers) -> None:
    rng = np.random.default_rng(5)
    time, command = TICK * np.arange(1000), np.cumsum(rng.normal(size=1000))
    command[-TICKS:] = command[-TICKS]
    f, zeta = np.array([27.7, 27.8, 42.3]), np.array([0.01, 0.02, 0.0])
    expected = shaped_command(time, command[:, None], shaper("zv*zv*zv", f, zeta))[:, 0]
    for code, rounding in ((double, 1e-13), (single, 1e-5)):
        impulses = code.product("zv*zv*zv", f, zeta)
        code.rest(command[0])
        found = [code.shaped(each, impulses) for each in command]
        np.testing.assert_allclose(found, expected, rtol=0, atol=rounding * np.abs(command).max())
        assert found[-1] == np.array(command[-1], code.real)  # exactly: nothing drifts


def test_shapers_that_follow_a_pose_make_the_command_of_the_runtime(double: Shapers) -> None:
    """Up to the order of impulses that pass one another."""
    time = TICK * np.arange(600)
    command = np.clip(time - 0.05, 0.0, 0.4)
    zeta = np.full(2, 0.01)
    for ratio in (1.4, np.linspace(1.2, 0.8, len(time))):
        f = np.linspace(30.0, 45.0, len(time))
        f = np.stack([f, ratio * f], axis=-1)
        expected = shaped_command(time, command[:, None], shaper("zv*zv", f, zeta))[:, 0]
        double.rest(command[0])
        designs = [double.product("zv*zv", each, zeta) for each in f]
        found = [double.shaped(*each) for each in zip(command, designs, strict=True)]
        np.testing.assert_allclose(found, expected, rtol=0, atol=1e-14 if isinstance(ratio, float) else 1e-7)
        assert found[-1] == command[-1]


def test_delays_may_shorten_faster_than_time_passes(double: Shapers) -> None:
    """Then parts arrive together; no part is lost."""
    impulses = double.impulses(1)
    impulses.amplitude[0] = 1.0
    double.rest(0.0)
    found = []
    for k, delay in enumerate((5.0, 5.0, 2.0, 2.0, 0.5, 0.0, 0.0), start=1):
        impulses.delay[0] = delay * TICK
        found.append(double.shaped(float(k), impulses))
    np.testing.assert_allclose(found, [0.0, 0.0, 0.0, 0.0, 1.0, 5.0, 7.0], rtol=0, atol=1e-9)


def test_delays_beyond_the_longest_are_shortened(double: Shapers) -> None:
    impulses = double.impulses(1)
    impulses.amplitude[0] = 1.0
    for delay in ((TICKS - 1) * TICK, TICKS * TICK, 1e9, math.inf, math.nan):
        impulses.delay[0] = delay
        double.rest(0.0)
        for k in range(1, 2 * TICKS):
            found = double.shaped(float(k), impulses, status=int(delay != (TICKS - 1) * TICK))
        assert found == 2 * TICKS - 1 - (TICKS - 1)


def test_a_command_that_only_rises_does_so_shaped_however_the_shaper_changes(double: Shapers) -> None:
    rng = np.random.default_rng(3)
    double.rest(1.0)
    found = []
    for k in range(2000):
        _, impulses = double.design(int(rng.integers(len(KINDS))), 10.0 ** rng.uniform(-1, 3), 0.01)
        command = 1.0 + min(max(k - 500, 0), 500) / 500.0
        too_long = impulses.delay[impulses.count - 1] > (TICKS - 1) * TICK
        found.append(double.shaped(command, impulses, status=int(too_long)))
    assert (np.diff(found) > -1e-12).all()
    assert set(found[:500]) == {1.0}
    assert set(found[1000 + TICKS :]) == {2.0}


def test_lengths_can_be_chosen(robot: HeldRobot, tmp_path: Any) -> None:
    upper = robot.name.upper()
    further = [f"-D{upper}_SHAPER_IMPULSES=8", f"-D{upper}_SHAPER_TICKS=1000"]
    build(robot.source, tmp_path / "own.so", False, further=further)


def test_a_wrong_tick_or_shaper_takes_nothing(double: Shapers) -> None:
    _, impulses = double.design(KINDS.index("zv"), 40.0, 0.0)
    double.rest(1.0)
    double.shaped(2.0, impulses)
    before = bytes(double.state)
    for tick in (0.0, -TICK, math.nan):
        assert double.shaped(3.0, impulses, status=-1, tick=tick) == math.pi
    for count in (-1, MOST + 1):
        assert double.shaped(3.0, double.impulses(count), status=-1) == math.pi
    assert bytes(double.state) == before
    assert double.shaped(3.0, double.impulses(0)) == 3.0 - 0.5  # what is underway arrives later


def test_single_precision_adds_no_more_than_rounding(single: Shapers) -> None:
    """A pose of about half a metre: parts that are summed first are rounded once."""
    impulses = single.product("zv*zv*zv", np.array([27.7, 33.1, 42.3]), np.zeros(3))
    amplitudes, delays = arrays(impulses)
    time = TICK * np.arange(800)
    command = (0.5 + 0.05 * (1.0 - np.cos(np.pi * np.clip(time / 0.5, 0.0, 1.0)))).astype(np.float32)
    single.rest(float(command[0]))
    found = np.array([single.shaped(float(each), impulses) for each in command])
    exact = command.astype(float)
    expected = sum(a * np.interp(time - d, time, exact) for a, d in zip(amplitudes, delays, strict=True))
    assert np.abs(found - expected).max() <= 1.5 * 2.0**-24  # half a unit in the last place, and a little
    assert (np.diff(found) >= 0.0).all()


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("#define {upper}_SHAPER_IMPULSES 4\n{include}", "SHAPER_IMPULSES: give 5 or more"),
        ("#define {upper}_SHAPER_TICKS 1\n{include}", "SHAPER_TICKS: give 2 or more"),
        ("{include}#define PKMODES_FLOAT\n{other}", "define PKMODES_FLOAT before the first header"),
        (
            "#define PKMODES_FLOAT\n{include}#undef PKMODES_FLOAT\n{other}",
            "for all headers of robots in a file",
        ),
    ],
)
def test_what_would_not_fit_together_does_not_compile(
    robot: HeldRobot, tmp_path: Any, text: str, said: str
) -> None:
    header = next(robot.source.parent.glob("*.h"))
    other = tmp_path / "other.h"  # that of another robot
    other.write_text(
        robot.header.replace(robot.name, "other").replace(robot.name.upper(), "OTHER"), encoding="utf-8"
    )
    parts = {
        "upper": robot.name.upper(),
        "include": f'#include "{header}"\n',
        "other": f'#include "{other}"\n',
    }
    file = tmp_path / "main.c"
    file.write_text(text.format(**parts) + "int main(void) { return 0; }\n", encoding="utf-8")
    done = subprocess.run(
        [COMPILER or "cc", "-std=c99", "-c", str(file), "-o", str(tmp_path / "main.o")],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode != 0
    assert said in done.stderr
