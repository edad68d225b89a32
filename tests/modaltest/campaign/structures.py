"""A structure of masses and springs with known modes, files of its signals, and campaigns of them."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest
from scipy import signal

from helpers.commands.answers import answer

CHANNELS = ("floor_1", "floor_2", "floor_3")
HEAD = f'format = 1\nchannels = {json.dumps(CHANNELS)}\nband = ["20 Hz", "200 Hz"]\n'


def sensors(*units: str) -> str:
    """Return the sensors a1, a2, a3 of the floors, in these units."""
    return "".join(
        f'[[sensor]]\nname = "a{k}"\nchannel = "floor_{k}"\nunit = "{unit}"\n'
        for k, unit in enumerate(units, start=1)
    )


def record(kind: str, *files: str, pose: str = "P1") -> str:
    return f'[[record]]\npose = "{pose}"\nkind = "{kind}"\nfiles = {json.dumps(files)}\n'


class Identified(NamedTuple):
    """What ``pkmodes identify`` writes, its JSON and the file of modes, and what it remarks."""

    document: dict[str, Any]
    file: Path
    remarks: str

    @property
    def record(self) -> dict[str, Any]:
        """Return that of the first pose."""
        return self.document["records"][0]


MODES, DOCUMENT = "modes.csv", "modes.json"


def _answer(folder: Path, campaign: str, *options: str) -> tuple[int, str]:
    """Return the exit code, and what is said beside the result, on one line."""
    (folder / "c.toml").write_text(campaign, encoding="utf-8")
    (folder / MODES).unlink(missing_ok=True)
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        found = answer("identify", "c.toml", "--out", MODES, "--json", DOCUMENT, *options)
    return found.code, " ".join(found.err.split())


def identify(folder: Path, campaign: str, *options: str) -> Identified:
    """Identify the modes of a campaign, whose files are in the folder."""
    code, remarks = _answer(folder, campaign, *options)
    assert code == 0
    return Identified(json.loads((folder / DOCUMENT).read_text(encoding="utf-8")), folder / MODES, remarks)


def refused(folder: Path, campaign: str) -> str:
    """Return why a campaign cannot be identified; nothing is written."""
    code, error = _answer(folder, campaign)
    assert code == 2
    assert not (folder / MODES).exists()
    return error


@dataclass(frozen=True)
class Frame:
    """Three floors: modes and responses by NumPy alone."""

    M: np.ndarray
    K: np.ndarray
    ratios: np.ndarray

    @classmethod
    def build(cls, stiffer: float = 1.0) -> Frame:
        M = np.diag([4.0, 3.0, 2.0])
        k = stiffer * np.array([1.6e6, 1.1e6, 0.7e6])
        K = np.array([[k[0] + k[1], -k[1], 0.0], [-k[1], k[1] + k[2], -k[2]], [0.0, -k[2], k[2]]])
        return cls(M, K, np.array([0.012, 0.008, 0.02]))

    def modes(self, factor: float = 1.0) -> tuple[np.ndarray, np.ndarray]:
        """Frequencies [Hz], and shapes as columns, mass-normalised; for springs stiffer by a factor."""
        root = np.diag(np.diag(self.M) ** -0.5)
        values, vectors = np.linalg.eigh(factor * root @ self.K @ root)
        return np.sqrt(values) / (2.0 * np.pi), root @ vectors

    def accelerances(self, f: np.ndarray, factor: float = 1.0) -> np.ndarray:
        """Acceleration of every floor per force on every floor, (F, 3, 3): a linear system for each line."""
        natural, shapes = self.modes(factor)
        damping = self.M @ shapes @ np.diag(4.0 * np.pi * natural * self.ratios) @ shapes.T @ self.M
        omega = 2.0 * np.pi * f[:, None, None]
        dynamic = factor * self.K + 1j * omega * damping - omega**2 * self.M
        return -(omega**2) * np.linalg.inv(dynamic)


def write_frf(
    path: Path, f: np.ndarray, H: dict[str, np.ndarray], noise: float, rng: np.random.Generator
) -> None:
    """Write a table of functions with noise relative to the rms of each."""
    columns, names = [f], ["frequency"]
    for name, values in H.items():
        sigma = noise * np.sqrt(np.mean(np.abs(values) ** 2) / 2.0)
        noisy = values + sigma * (rng.normal(size=len(f)) + 1j * rng.normal(size=len(f)))
        columns += [noisy.real, noisy.imag]
        names += [f"re:{name}", f"im:{name}"]
    np.savetxt(path, np.stack(columns, axis=1), delimiter=",", header=",".join(names), comments="")


def accelerations(frame: Frame, step: float, force: np.ndarray, floor: int) -> np.ndarray:
    """Accelerations of every floor (N, 3) after a force on one, a straight line between samples: exact."""
    natural, shapes = frame.modes()
    omega, found = 2.0 * np.pi * natural, np.zeros((len(force), 3))
    for w, zeta, phi in zip(omega, frame.ratios, shapes.T, strict=True):
        A = np.array([[0.0, 1.0], [-(w**2), -2.0 * zeta * w]])
        B = np.array([[0.0], [phi[floor]]])
        C = np.array([[-(w**2), -2.0 * zeta * w]])
        system = signal.StateSpace(A, B, C, [[phi[floor]]])
        _, q, _ = signal.lsim(system, force, step * np.arange(len(force)))
        found += np.outer(q, phi)
    return found
