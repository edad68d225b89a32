"""Generated products of robots with and without effects, compiled in both precisions."""

from __future__ import annotations

import ctypes
import importlib.util
import subprocess
from functools import cached_property
from pathlib import Path
from types import ModuleType

import numpy as np

import pkmodes
from pkmodes_rig.robots import with_free_motors
from helpers.generated.compiled import COMPILER, FLAGS
from pkmodes.codegen.generation import generate

ROBOTS = Path(__file__).parents[3] / "robots"
LINEAR_BOX = ([0.0, -0.3, -0.45], [1.2, 0.3, 0.0])
COREXY_BOX = ([-0.05, -0.05], [0.35, 0.35])
#: Robot file, effects, and a box of poses that is larger than the workspace.
CASES = {
    "linear_delta": ("linear-delta-2022.toml", "", LINEAR_BOX),
    "rotary_delta": ("clavel-delta.toml", "", ([-0.5, -0.5, -0.9], [0.5, 0.5, -0.3])),
    "corexy": ("corexy-printer.toml", "", COREXY_BOX),
    "clamps": (
        "linear-delta-2022.toml",
        '\n[effects.clamp_compliance]\ncompliance = "1e-7 m/N"\n'
        '[effects.gearbox_compliance]\ncompliance = "1e-3 rad/(N*m)"\n',
        LINEAR_BOX,
    ),
    "held": (
        "corexy-printer.toml",
        '\n[effects.servo_stiffness]\nstiffness = "20 N*m/rad"\n'
        '[effects.frame_compliance]\ncompliance = "2e-6 m/N"\n',
        COREXY_BOX,
    ),
}
#: No conversion between the precisions that is not written.
STRICT = ["-Wconversion", "-Wdouble-promotion", "-Wfloat-conversion"]


class Library:
    """The C functions of a robot, compiled in one precision with warnings as errors."""

    @staticmethod
    def _place(source: Path, single: bool) -> Path:
        return source.with_name(f"{source.stem}{'_f' if single else ''}.so")

    @classmethod
    def build(cls, source: Path, single: bool) -> None:
        define = ["-DPKMODES_FLOAT"] if single else []
        library = cls._place(source, single)
        subprocess.run(
            [str(COMPILER), *FLAGS, *STRICT, *define, str(source), "-o", str(library), "-lm"], check=True
        )

    def __init__(self, source: Path, single: bool) -> None:
        self.m = int(source.with_suffix(".h").read_text("utf-8").split("_COORDINATES ")[1].split("\n")[0])
        self.type, suffix = (np.float32, "_f") if single else (np.float64, "")
        code = ctypes.CDLL(str(self._place(source, single)))
        self._status, self._frequencies, self._modes = (
            getattr(code, f"{source.stem}_{name}{suffix}")
            for name in ("status", "natural_frequencies", "modes")
        )

    def status(self, poses: np.ndarray) -> np.ndarray:
        given = np.ascontiguousarray(poses, self.type)
        return np.array([self._status(ctypes.c_void_p(p.ctypes.data)) for p in given])

    def modes(self, p: np.ndarray) -> tuple[int, np.ndarray, np.ndarray, np.ndarray]:
        """Status, frequencies with shapes, shapes, and frequencies alone; poisoned before."""
        f, alone = np.full((2, self.m), 1e9, self.type)
        phi = np.full((self.m, self.m), 1e9, self.type)
        p = np.array(p, self.type)
        p_, f_, alone_, phi_ = (ctypes.c_void_p(a.ctypes.data) for a in (p, f, alone, phi))
        status = self._modes(p_, f_, phi_)
        assert self._frequencies(p_, alone_) == status
        return status, f, phi, alone


class Robot:
    """A robot file, and what `generate` wrote for it and the compiler made of that."""

    @staticmethod
    def write(folder: Path, case: str) -> None:
        """Write the file, generate, and compile."""
        name, effects, _ = CASES[case]
        file = folder / name
        file.write_text(with_free_motors(ROBOTS / name) + effects, encoding="utf-8")
        written = [path.name for path in generate(file, folder / "out")]
        (folder / "written.txt").write_text("\n".join(written), encoding="utf-8")
        source = folder / "out" / f"{file.stem.replace('-', '_')}.c"
        for single in (False, True) if COMPILER else ():
            Library.build(source, single)

    def __init__(self, folder: Path, case: str) -> None:
        file, effects, self.box = CASES[case]
        self.file = folder / file
        self.model = pkmodes.load(self.file)
        self.out = folder / "out"
        self.written = (folder / "written.txt").read_text(encoding="utf-8").splitlines()
        self.name = self.file.stem.replace("-", "_")
        self.effects = bool(effects)

    def text(self, file: str) -> str:
        return (self.out / file).read_text(encoding="utf-8")

    @property
    def header(self) -> str:
        return self.text(f"{self.name}.h")

    @cached_property
    def double(self) -> Library:
        return Library(self.out / f"{self.name}.c", False)

    @cached_property
    def single(self) -> Library:
        return Library(self.out / f"{self.name}.c", True)

    @cached_property
    def module(self) -> ModuleType:
        return imported(self.out / f"{self.name}.py")

    def poses(self, count: int) -> np.ndarray:
        return np.random.default_rng(1).uniform(*self.box, (count, len(self.box[0])))

    def valid(self, count: int) -> np.ndarray:
        poses = self.poses(2000)
        return poses[self.model.check(poses).codes == 0][:count]


def imported(file: Path) -> ModuleType:
    specification = importlib.util.spec_from_file_location(file.stem, file)
    assert specification is not None
    assert specification.loader is not None
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module
