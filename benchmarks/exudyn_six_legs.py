"""Frequencies of random hexapods and hexaglides by Exudyn: the table with which the tests compare.

    pip install exudyn==1.13.6
    export PYTHONPATH=src:generated:tests
    python benchmarks/exudyn_six_legs.py --count 3 --out tests/generated/exudyn_six_legs.json
    python benchmarks/exudyn_six_legs.py --count 200

Exudyn knows rigid bodies with redundant coordinates, joints as constraints, and springs; it linearises by differences
and projects onto the motions that the constraints allow.  The machines are without gravity: the derivatives of the
joints' reactions, which are part of its stiffness, are missing there.  Without --out, the table is compared with the
oracle in 60 digits, and nothing is written.
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import exudyn as exu
import numpy as np
from exudyn import itemInterface as items  # noqa: N813
from exudyn.utilities import RigidBodyInertia

from helpers.references.oracle_six_legged import modes, result
from helpers.robots.six_legged import LEGS, MACHINES, rotation
from pkmodes_rig.mujoco_six_legged import of

Machine = Mapping[str, Any]
AGREEMENT = 1e-7


class Multibody:
    """A machine of bodies, joints and springs, with free motors or held ones."""

    def __init__(self, machine: Machine, pose: Any, held: bool) -> None:
        self.machine, self.held = machine, held
        self.container = exu.SystemContainer()
        self.system = self.container.AddSystem()
        self.ground = self.system.CreateGround()
        self.fixed = self.system.AddMarker(
            items.MarkerNodeCoordinate(nodeNumber=self.system.AddNode(items.NodePointGround()), coordinate=0)
        )
        self.origin, self.R = np.array(pose[:3]), rotation(np.array(pose[3:]))
        self.ends = self.origin + np.array([axis["joint"] for axis in machine["axis"]]) @ self.R.T
        self.platform = self._platform()
        {"hexapod": self._hexapod, "hexaglide": self._hexaglide}[machine["mechanism"]]()
        self.system.Assemble()

    def eigenvalues(self) -> np.ndarray:
        found, _ = self.system.ComputeODE2Eigenvalues(useAbsoluteValues=False, singularValuesTolerance=1e-8)
        return np.sort(np.real(found))

    def _platform(self) -> Any:
        table = self.machine["platform"]
        xx, yy, zz = table["inertia"]
        xy, xz, yz = table.get("products", [0.0, 0.0, 0.0])
        tensor = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
        inertia = RigidBodyInertia(mass=table["mass"], inertiaTensor=tensor)  # about the centre of mass
        centre = self.origin + self.R @ table["center"]
        return self.system.CreateRigidBody(
            referencePosition=centre, referenceRotationMatrix=self.R, inertia=inertia
        )

    def _slender(self, mass: float, across: float, centre: np.ndarray, along: np.ndarray) -> Any:
        """A body whose x axis is `along`."""
        inertia = RigidBodyInertia(mass=mass, inertiaTensor=np.diag([1e-9 * across, across, across]))
        return self.system.CreateRigidBody(
            referencePosition=centre, referenceRotationMatrix=basis(along), inertia=inertia
        )

    def _joint(self, one: Any, other: Any, where: np.ndarray, along: np.ndarray, axes: list[int]) -> None:
        """Constrain some of three translations and three rotations, in axes of which the first is `along`."""
        self.system.CreateGenericJoint(
            itemNumbers=[one, other], position=where, rotationMatrixAxes=basis(along), constrainedAxes=axes
        )

    def _hexapod(self) -> None:
        for j in LEGS:
            base = np.array(self.machine["axis"][j]["base"])
            along = self.ends[j] - base
            along = along / np.linalg.norm(along)

            def value(key: str, j: int = j) -> float:
                return of(self.machine, j, "leg", key)

            leg = self._slender(
                value("base_mass"), value("base_inertia"), base + value("base_center") * along, along
            )
            rod = self._slender(
                value("rod_mass"), value("rod_inertia"), self.ends[j] - value("rod_center") * along, along
            )
            self._joint(self.ground, leg, base, along, [1, 1, 1, 1, 0, 0])
            self._joint(leg, rod, self.ends[j], along, [0, 1, 1, 1, 1, 1])
            self._joint(rod, self.platform, self.ends[j], along, [1, 1, 1, 0, 0, 0])
            driven = leg
            if not self.held:
                # a nut with the inertia of the motor slides along the leg; at the base joint nothing else moves it
                reflected = (
                    of(self.machine, j, "motor", "inertia") / of(self.machine, j, "motor", "travel") ** 2
                )
                driven = self._slender(reflected, 1e-15 * reflected, base, along)
                self._joint(leg, driven, base, along, [0, 1, 1, 1, 1, 1])
            markers = [
                self.system.AddMarker(items.MarkerBodyRigid(bodyNumber=body, localPosition=where))
                for body, where in (
                    (driven, [0, 0, 0]),
                    (rod, [value("rod_center"), 0, 0]),
                )
            ]
            shift = np.linalg.norm(self.ends[j] - base)
            if self.held:
                shift -= value("base_center")
            self.system.AddObject(
                items.LinearSpringDamper(
                    markerNumbers=markers, stiffness=value("stiffness"), axisMarker0=[1, 0, 0], offset=shift
                )
            )

    def _hexaglide(self) -> None:
        for j in LEGS:
            axis, length = self.machine["axis"][j], of(self.machine, j, "link", "length")
            direction = np.array(axis["direction"]) / np.linalg.norm(axis["direction"])
            r = self.ends[j] - axis["origin"]
            across = r - (r @ direction) * direction
            x = r @ direction + axis["branch"] * np.sqrt(length**2 - across @ across)
            start = axis["origin"] + x * direction
            carriage = self._coordinate()
            body = self.system.AddObject(
                items.Mass1D(
                    mass=of(self.machine, j, "carriage", "mass"),
                    nodeNumber=carriage,
                    referencePosition=start,
                    referenceRotation=basis(direction),
                )
            )
            along = (self.ends[j] - start) / length
            mass = of(self.machine, j, "link", "mass")
            rod = self._slender(mass, mass * length**2 / 12, start + along * length / 2, along)
            turned = exu.HT(rotation=basis(direction).T @ basis(along), translation=[0, 0, 0])
            first = self.system.AddMarker(items.MarkerBodyRigid(bodyNumber=body, localHT=turned))
            second = self.system.AddMarker(
                items.MarkerBodyRigid(bodyNumber=rod, localPosition=[-length / 2, 0, 0])
            )
            self.system.AddObject(
                items.GenericJoint(markerNumbers=[first, second], constrainedAxes=[1, 1, 1, 1, 0, 0])
            )
            self._joint(rod, self.platform, self.ends[j], along, [1, 1, 1, 0, 0, 0])
            self._belt(j, float(x), carriage)

    def _coordinate(self) -> Any:
        return self.system.AddNode(items.Node1D(referenceCoordinates=[0.0]))

    def _belt(self, j: int, x: float, carriage: Any) -> None:
        """Pulleys as masses on the belt, and its three spans."""
        R, half = of(self.machine, j, "pulley", "radius"), of(self.machine, j, "carriage", "length") / 2
        ends = {0: self.system.AddMarker(items.MarkerNodeCoordinate(nodeNumber=carriage, coordinate=0))}
        for k in (1, 2):
            inertia = of(self.machine, j, "pulley", "inertia")
            if self.machine["axis"][j]["driven_pulley"] == k:
                ratio = of(self.machine, j, "motor", "gear_ratio")
                inertia += ratio**2 * of(self.machine, j, "motor", "inertia")
                if self.held:
                    ends[k] = self.fixed
                    continue
            node = self._coordinate()
            self.system.AddObject(items.Mass1D(mass=inertia / R**2, nodeNumber=node))
            ends[k] = self.system.AddMarker(items.MarkerNodeCoordinate(nodeNumber=node, coordinate=0))
        low, high = self.machine["axis"][j]["limits"]
        unit = of(self.machine, j, "belt", "width") * of(self.machine, j, "belt", "specific_stiffness")
        for length, one, other in ((high - low, 1, 2), (x - low - half, 0, 2), (high - x - half, 0, 1)):
            self.system.AddObject(
                items.CoordinateSpringDamper(markerNumbers=[ends[one], ends[other]], stiffness=unit / length)
            )


def basis(along: np.ndarray) -> np.ndarray:
    """Rotation matrix whose first column is a unit vector."""
    other = np.eye(3)[np.argmin(np.abs(along))]
    second = np.cross(along, other)
    second /= np.linalg.norm(second)
    return np.stack([along, second, np.cross(along, second)], axis=1)


def row(name: str, seed: int) -> dict[str, Any]:
    machine, pose = MACHINES[name](seed)
    machine = {**machine, "gravity": [0.0, 0.0, 0.0]}
    free, held = (Multibody(machine, pose, held).eigenvalues() for held in (False, True))
    return {
        "machine": machine,
        "pose": list(pose),
        # of free motors the six rigid-body modes are zero, to rounding
        "free": (np.sqrt(free[6:]) / (2 * np.pi)).tolist(),
        "held": (np.sqrt(held) / (2 * np.pi)).tolist(),
    }


def worst(entry: Mapping[str, Any]) -> float:
    found = result(entry["machine"], entry["pose"])
    free = modes(found.M, found.K).frequencies[6:]
    held = modes(found.M, found.K, found.motors).frequencies
    return max(
        float(np.abs(np.array(entry[key]) / other - 1).max())
        for key, other in (("free", free), ("held", held))
    )


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--count", type=int, default=6, help="machines of each kind")
    parser.add_argument("--out", type=Path, help="the table to write")
    given = parser.parse_args()
    rows = []
    for name in MACHINES:
        some = [row(name, seed) for seed in range(given.count)]
        errors = [worst(entry) for entry in some]
        print(f"{name}: {given.count} machines, largest relative difference {max(errors):.1e}")
        if max(errors) > AGREEMENT:
            raise SystemExit(f"error: machine {int(np.argmax(errors))} exceeds {AGREEMENT:.0e}")
        rows += some
    if given.out:
        lines = ",\n".join(json.dumps(entry) for entry in rows)
        given.out.write_text(f"[\n{lines}\n]\n", encoding="utf-8")


if __name__ == "__main__":
    main()
