"""Build what a controller calls for other processors, and run it under emulation.

``python docs/studies/microcontroller/targets.py`` writes the table of docs/how-to/using-the-c-code.md.  It needs the
Debian packages gcc-arm-none-eabi, libnewlib-arm-none-eabi and qemu-system-arm.
"""

from __future__ import annotations

import subprocess
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import pkmodes
from pkmodes.codegen.generation import generate

ROOT = Path(__file__).parents[3]
HERE = Path(__file__).parent
PAGE = ROOT / "docs/how-to/using-the-c-code.md"
BEGIN, END = "<!-- begin: written by docs/studies/microcontroller/targets.py -->", "<!-- end -->"
#: Each robot with a box of poses.
ROBOTS = {
    "linear-delta-2022": ((0.3, -0.1, -0.25), (0.9, 0.1, -0.16)),
    "linear-delta-2022-identified": ((0.3, -0.1, -0.25), (0.9, 0.1, -0.16)),
    "clavel-delta": ((-0.3, -0.3, -0.7), (0.3, 0.3, -0.4)),
    "corexy-printer": ((0.02, 0.02), (0.28, 0.28)),
    "cartesian-printer": ((0.02, 0.02), (0.2, 0.2)),
    "bed-slinger": ((0.02, 0.02), (0.2, 0.2)),
    "hexapod": ((-0.02, -0.02, 0.24, -0.15, -0.15, -0.15), (0.02, 0.02, 0.26, 0.15, 0.15, 0.15)),
    "hexaglide": ((-0.05, -0.05, 0.2, -0.15, -0.15, -0.15), (0.05, 0.05, 0.3, 0.15, 0.15, 0.15)),
}
STRICT = ("-std=c99", "-Wall", "-Wextra", "-Wconversion", "-Wdouble-promotion", "-Werror")
#: A part of the C library that is linked only for arithmetic with double on a unit for float.
DOUBLE = ("__aeabi_d", "__aeabi_f2d", "__aeabi_i2d", "__aeabi_ui2d", "__aeabi_l2d")
CORTEX_M7 = (
    "arm-none-eabi-gcc",
    *("-mcpu=cortex-m7", "-mthumb", "-mfpu=fpv5-sp-d16", "-mfloat-abi=hard", "-Os"),
    *("-ffunction-sections", "-fdata-sections", "-DPKMODES_FLOAT"),
)
IMAGE = ("-nostartfiles", "-Wl,--gc-sections", f"-Wl,-T,{HERE / 'cortex_m7.ld'}")
EMULATED = (
    *("qemu-system-arm", "-M", "mps2-an500", "-display", "none", "-serial", "none", "-monitor", "none"),
    *("-chardev", "stdio,id=out", "-semihosting-config", "enable=on,chardev=out", "-kernel"),
)


@dataclass(frozen=True)
class Results:
    """What a program printed, for N poses and H modes.

    Attributes
    ----------
    status : ndarray of int, shape (N,)
    frequencies, damping_ratios, amplitudes : ndarray, shape (N, H)
        In Hz, 1 and s^2.
    command : ndarray, shape (N, d)
        Shaped commands.
    stack : tuple of int
        Most stack of `vibration` and of shaping, in bytes; measured on the microcontroller only.
    """

    status: np.ndarray
    frequencies: np.ndarray
    damping_ratios: np.ndarray
    amplitudes: np.ndarray
    command: np.ndarray
    stack: tuple[int, int]


@dataclass(frozen=True)
class Program:
    """The C of one robot and a program that calls it at poses.

    Attributes
    ----------
    folder : Path
        With the generated files and ``poses.h``.
    name : str
        Of the robot, as in C.
    poses : ndarray, shape (N, d)
        In single precision, so that all programs have the same ones.
    """

    folder: Path
    name: str
    poses: np.ndarray

    @classmethod
    def write(cls, robot_file: Path, box: Sequence[Sequence[float]], count: int, folder: Path) -> Program:
        """Generate the C of a robot, and write random poses of a box."""
        generate(robot_file, folder)
        (header,) = folder.glob("*.h")
        name, upper = header.stem, header.stem.upper()
        poses = np.random.default_rng(7).uniform(*box, (count, len(box[0]))).astype(np.float32)
        rows = ",\n".join("    {" + ", ".join(float(x).hex() for x in p) + "}" for p in poses)
        names = (
            "shaper",
            "shaped",
            "vibration",
            "shaper_design",
            "shaper_multiply",
            "shaped_rest",
            "shaped_command",
        )
        text = f'#include "{name}.h"\n'
        text += "".join(f"#define robot_{each} {name}_{each}\n" for each in names)
        text += f"enum {{ MODES = {upper}_HELD_MODES, POSES = {count}, FACTORS = MODES < 3 ? MODES : 3 }};\n"
        text += f"static const pkmodes_real poses[POSES][{upper}_POSE] = {{\n{rows}}};\n"
        (folder / "poses.h").write_text(text, encoding="utf-8")
        return cls(folder, name, poses)

    def built(self, command: Sequence[str], name: str, further: Sequence[str] = ()) -> Path:
        """Compile and link, warnings as errors."""
        image = self.folder / name
        files = [str(HERE / "target.c"), str(self.folder / f"{self.name}.c")]
        subprocess.run(
            [*command, *STRICT, f"-I{self.folder}", *files, *further, "-lm", "-o", str(image)], check=True
        )
        return image

    def run(self, command: Sequence[str], single: bool) -> Results:
        """Run a program and read what it printed."""
        printed = subprocess.run([*command], check=True, capture_output=True, text=True, timeout=60).stdout
        *rows, last = [[bytes.fromhex(part) for part in line.split()] for line in printed.splitlines()]
        real = np.float32 if single else np.float64
        status, *values = zip(*rows, strict=True)
        f, zeta, amplitudes, result = (
            np.array([np.frombuffer(b, real) for b in column]) for column in values
        )
        used = np.frombuffer(last[0], np.uint32)
        codes = np.array([int(np.frombuffer(b, np.int32)[0]) for b in status])
        return Results(codes, f, zeta, amplitudes, result, (int(used[0]), int(used[1])))


@dataclass(frozen=True)
class Firmware:
    """A robot on the microcontroller.

    Attributes
    ----------
    flash : int
        Bytes of all functions of the generated file that a tick needs, with what they need of the C library.
    double : tuple of str
        Functions for arithmetic with double that are linked.
    error : float
        Largest relative error of a frequency, against double precision in Python.
    results : Results
    """

    flash: int
    double: tuple[str, ...]
    error: float
    results: Results


def firmware(robot_file: Path, box: Sequence[Sequence[float]], folder: Path, count: int = 200) -> Firmware:
    """Build a robot for the microcontroller and run it under emulation."""
    program = Program.write(robot_file, box, count, folder)
    image = program.built(CORTEX_M7, "image.elf", IMAGE)
    results = program.run([*EMULATED, str(image)], single=True)
    model = pkmodes.load(robot_file)
    expected = model.modes(program.poses.astype(float), "nan", drives="held", backend="numpy")
    good = (results.status == 0) & expected.valid
    error = np.abs(results.frequencies[good] / expected.frequencies[good] - 1.0).max()
    return Firmware(
        _flash(image, folder),
        double_routines(image),
        float(error),
        results,
    )


def double_routines(image: Path) -> tuple[str, ...]:
    """Return the names of what an image has for arithmetic with double."""
    symbols = subprocess.run(["arm-none-eabi-nm", str(image)], check=True, capture_output=True, text=True)
    return tuple(sorted({name for name in symbols.stdout.split() if name.startswith(DOUBLE)}))


def _flash(image: Path, folder: Path) -> int:
    """Return the bytes of an image without the program around the functions and its poses."""
    around = folder / "target.o"
    subprocess.run(
        [*CORTEX_M7, *STRICT, f"-I{folder}", "-c", str(HERE / "target.c"), "-o", str(around)], check=True
    )
    printed = subprocess.run(
        ["arm-none-eabi-size", str(image), str(around)], check=True, capture_output=True, text=True
    ).stdout
    whole, rest = (sum(map(int, line.split()[:2])) for line in printed.splitlines()[1:])
    return whole - rest


def table(found: dict[str, Firmware]) -> str:
    """Return the table in Markdown."""
    lines = [
        "| robot | modes | flash | stack, `vibration` | stack, shaper | error of frequencies |",
        "| --- | ---: | ---: | ---: | ---: | ---: |",
    ]
    for name, of in found.items():
        modes = of.results.frequencies.shape[1]
        vibration, shaper = of.results.stack
        sizes = f"{of.flash / 1024:.1f} KiB | {vibration} B | {shaper} B"
        lines.append(f"| `{name}` | {modes} | {sizes} | {of.error:.1e} |")
    return "\n".join(lines)


def main() -> None:
    """Measure the robots and write the page."""
    found = {}
    for name, box in ROBOTS.items():
        with tempfile.TemporaryDirectory() as folder:
            found[name] = firmware(ROOT / "robots" / f"{name}.toml", box, Path(folder))
        if found[name].double:
            raise SystemExit(f"error: {name} uses {', '.join(found[name].double)}")
    before, rest = PAGE.read_text(encoding="utf-8").split(BEGIN)
    _, after = rest.split(END)
    PAGE.write_text(f"{before}{BEGIN}\n{table(found)}\n{END}{after}", encoding="utf-8")


if __name__ == "__main__":
    main()
