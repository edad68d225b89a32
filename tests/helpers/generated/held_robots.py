"""Robots whose generated C is called as in use, motors held or on springs: files, products, and the functions."""

from __future__ import annotations

import ctypes
import re
import subprocess
from collections.abc import Sequence
from functools import cached_property
from pathlib import Path
from typing import NamedTuple

import numpy as np

import pkmodes
from helpers.generated.compiled import COMPILER, FLAGS
from helpers.generated.generated_robots import COREXY_BOX, LINEAR_BOX, ROBOTS, STRICT, imported
from pkmodes.codegen.generation import generate

BED_BOX = ([-0.05, -0.05], [0.3, 0.25])
ROTARY_BOX = ([-0.5, -0.5, -0.9], [0.5, 0.5, -0.3])
RATIO = '\n[damping]\nratio = "1.5 %"\n'
#: Everything that changes a linear delta, and everything that it dissipates with.
EVERYTHING = """
[effects.clamp_compliance]
compliance = "1e-7 m/N"
[effects.gearbox_compliance]
compliance = "1e-3 rad/(N*m)"
[effects.link_compliance]
compliance = "1e-7 m/N"
[effects.frame_compliance]
compliance = "1e-7 m/N"
[effects.payload]
mass = "0.3 kg"
[effects.gearbox_inertia]
inertia = "1e-5 kg*m^2"
[effects.cable_stiffness]
stiffness = "300 N/m"
[effects.belt_loss]
loss_factor = 0.02
[effects.rail_friction]
viscous = "20 N*s/m"
[effects.drive_friction]
viscous = "1e-3 N*m*s/rad"
"""
#: Robot file, what is added to it, changes of its lines, and a box of poses that is larger than the workspace.
CASES: dict[str, tuple[str, str, dict[str, str], tuple]] = {
    "published": ("linear-delta-2022.toml", "", {}, LINEAR_BOX),
    "identified": ("linear-delta-2022-identified.toml", RATIO, {}, LINEAR_BOX),
    "clavel": ("clavel-delta.toml", RATIO, {}, ROTARY_BOX),
    "printer": ("corexy-printer.toml", RATIO, {}, COREXY_BOX),
    "delta_with_everything": ("linear-delta-2022.toml", RATIO + EVERYTHING, {}, LINEAR_BOX),
    "clavel_with_links": (
        "clavel-delta.toml",
        '\n[effects.link_compliance]\ncompliance = "1e-6 m/N"\n[effects.reducer_loss]\nloss_factor = 0.03\n'
        '[effects.drive_friction]\nviscous = "2 N*m*s/rad"\n',
        {},
        ROTARY_BOX,
    ),
    # Motors that give way, and heavy belts, which give the clamps an inertia.
    "printer_with_belts": (
        "corexy-printer.toml",
        RATIO + '\n[effects.servo_stiffness]\nstiffness = "20 N*m/rad"\n'
        '[effects.gearbox_compliance]\ncompliance = "1e-2 rad/(N*m)"\n'
        '[effects.belt_mass]\nlinear_density = "10 g/m"\n[effects.belt_loss]\nloss_factor = 0.02\n'
        '[effects.clamp_compliance]\ncompliance = "1e-6 m/N"\n'
        '[effects.rail_friction]\nviscous = "5 N*s/m"\n',
        {},
        COREXY_BOX,
    ),
    "slinger_on_springs": (
        "bed-slinger.toml",
        RATIO + '\n[effects.servo_stiffness]\nstiffness = "18 N*m/rad"\n'
        '[effects.drive_friction]\nviscous = "1e-4 N*m*s/rad"\n',
        {},
        BED_BOX,
    ),
    "delta_on_springs": (
        "linear-delta-2022.toml",
        RATIO + '\n[effects.servo_stiffness]\nstiffness = "300 N*m/rad"\n'
        '[effects.drive_friction]\nviscous = "1e-3 N*m*s/rad"\n',
        {},
        LINEAR_BOX,
    ),
    # Without motor inertia the wind-up is condensed with free motors, and with held ones it moves the pulley: as
    # many modes either way.
    "printer_with_light_motors": (
        "corexy-printer.toml",
        RATIO + '\n[effects.gearbox_compliance]\ncompliance = "1e-2 rad/(N*m)"\n'
        "[effects.belt_loss]\nloss_factor = 0.02\n",
        {'"5.4e-6 kg*m^2"': '"0 kg*m^2"'},
        COREXY_BOX,
    ),
}


class Vibration(NamedTuple):
    """What `NAME_vibration` returns at one pose."""

    status: int
    frequencies: np.ndarray
    damping_ratios: np.ndarray
    amplitudes: np.ndarray


class HeldRobot:
    """A robot file, what `generate` wrote for it, and its C in both precisions."""

    @staticmethod
    def write(folder: Path, case: str) -> None:
        name, more, changes, _ = CASES[case]
        text = (ROBOTS / name).read_text(encoding="utf-8")
        for old, new in changes.items():
            assert text.count(old) == 1, old
            text = text.replace(old, new)
        (folder / name).write_text(text + more, encoding="utf-8")
        generate(folder / name, folder / "out")
        if COMPILER:
            for single in (False, True):
                source = folder / "out" / f"{Path(name).stem.replace('-', '_')}.c"
                build(source, library_of(source, single), single)

    def __init__(self, folder: Path, case: str) -> None:
        file, _, _, self.box = CASES[case]
        self.file, self.out = folder / file, folder / "out"
        self.model = pkmodes.load(self.file)
        self.name = self.file.stem.replace("-", "_")
        self.header = (self.out / f"{self.name}.h").read_text(encoding="utf-8")
        self.source = self.out / f"{self.name}.c"

    @property
    def drives(self) -> str:
        """What the motors do in use."""
        return "free" if "[effects.servo_stiffness]" in self.file.read_text(encoding="utf-8") else "held"

    @property
    def count(self) -> int:
        """Number of modes in use."""
        return int(re.findall(rf"#define {self.name.upper()}_HELD_MODES (\d+)\n", self.header)[0])

    @cached_property
    def _libraries(self) -> dict[bool, ctypes.CDLL]:
        return {single: ctypes.CDLL(str(library_of(self.source, single))) for single in (False, True)}

    def vibration(self, p: np.ndarray, single: bool = False) -> Vibration:
        """Call the C; the results are poisoned before."""
        function = getattr(self._libraries[single], f"{self.name}_vibration{'_f' if single else ''}")
        kind = np.float32 if single else np.float64
        pose, results = np.array(p, kind), np.full((3, self.count), 1e9, kind)
        status = function(*(ctypes.c_void_p(a.ctypes.data) for a in (pose, *results)))
        return Vibration(status, *results.astype(float))

    def poses(self, count: int) -> np.ndarray:
        return np.random.default_rng(3).uniform(*self.box, (count, len(self.box[0])))

    def condition_numbers(self, poses: np.ndarray) -> np.ndarray:
        """Of D_l; ones for a mechanism without closed loops."""
        module = imported(self.source.with_suffix(".py"))
        if not hasattr(module, "jacobian_condition"):
            return np.ones(len(poses))
        found: np.ndarray = module.jacobian_condition(poses)[1]
        return found

    def valid(self, count: int) -> np.ndarray:
        poses = self.poses(2000)
        return poses[self.model.check(poses).codes == 0][:count]


def library_of(source: Path, single: bool) -> Path:
    return source.with_name(f"{source.stem}{'_f' if single else ''}.so")


def build(
    source: Path, library: Path, single: bool, compiler: str = "", further: Sequence[str] = ()
) -> None:
    """Compile a source with warnings as errors."""
    define = ["-DPKMODES_FLOAT"] if single else []
    command = [compiler or str(COMPILER), *FLAGS, *STRICT, *further, *define]
    subprocess.run([*command, str(source), "-o", str(library), "-lm"], check=True)
