"""Writes a campaign on the rig as the folder that a laboratory hands over, and keeps the truth beside it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from pkmodes_rig.signals.files import FORMATS
from pkmodes_rig.signals.modal_tests import RATE, ModalTest, Recorded, recorded
from pkmodes_rig.signals.small_motion import SmallMotion
from pkmodes_rig.signals.visits import Machine, Visit, Wander

CAMPAIGN, ROBOT = "campaign.toml", "robot.toml"


@dataclass(frozen=True)
class Paper:
    """What the campaign file says, beside sensors and records.

    Attributes
    ----------
    band : tuple of two floats
        [Hz].
    components : tuple of str
        Of a pose.
    drives : str
    repeatability : str
    tones : tuple of float
        Stated ones [Hz].
    format : str
        One of `FORMATS`.
    angles : frozenset of str
        Channels in rad.
    averages_stated : bool
    force : tuple of float
        Direction in which the first force acts on the platform; none if it is not stated.
    """

    band: tuple[float, float]
    components: tuple[str, ...]
    drives: str
    repeatability: str = "0.2 %"
    tones: tuple[float, ...] = ()
    format: str = "universal"
    angles: frozenset[str] = frozenset()
    averages_stated: bool = True
    force: tuple[float, ...] = ()


@dataclass(frozen=True, eq=False)
class Made:
    """A campaign with its truth.

    Attributes
    ----------
    poses : ndarray, shape (N, d)
        As the campaign file states them.
    nominal : list of SmallMotion
        The machine at each of these poses, belts and reducers as they are on average.
    machines : mapping of (int, int) to SmallMotion
        As it was in each record and repeat.
    files : mapping of (int, int) to Recorded
    """

    poses: np.ndarray
    nominal: list[SmallMotion]
    machines: Mapping[tuple[int, int], SmallMotion]
    files: Mapping[tuple[int, int], Recorded]


def make(
    folder: Path,
    machine: Machine,
    robot: str,
    poses: np.ndarray,
    repeats: int,
    wander: Wander,
    tests: Sequence[ModalTest],
    paper: Paper,
    rng: np.random.Generator,
) -> Made:
    """Measure a machine and write the folder of the campaign.

    Parameters
    ----------
    folder : Path
        Must exist.
    machine : Machine
    robot : str
        Text of the robot file, which declares what the laboratory knows of it.
    poses : ndarray, shape (N, d)
        [m].
    repeats : int
        Files at each pose.
    wander, paper
        How the machine varies, and what the campaign file says.
    tests : sequence of ModalTest
        How it is measured at each pose; all with the same sensors.
    rng : numpy.random.Generator
    """
    visits = wander.visits(machine, poses, repeats, rng)
    machines = {(i, k): machine.at(one) for i, each in enumerate(visits) for k, one in enumerate(each)}
    files: dict[tuple[int, int], Recorded] = {}
    for test in dict.fromkeys(tests):
        own = {place: one for place, one in machines.items() if tests[place[0]] is test}
        files |= recorded(test, own, rng)
    style = FORMATS[paper.format]
    for (i, k), one in files.items():
        path = folder / _name(i, k, style.suffix)
        if one.functions is not None:
            style.write_functions(path, one.functions)
        elif one.motion is not None:
            style.write_times(path, 1.0 / RATE, one.force, one.motion)
    (folder / ROBOT).write_text(robot, encoding="utf-8")
    (folder / CAMPAIGN).write_text(_text(poses, repeats, tests, paper), encoding="utf-8")
    still = np.zeros_like(visits[0][0].stiffer)
    nominal = [machine.at(Visit(pose, still)) for pose in poses]
    return Made(poses, nominal, machines, files)


def _name(record: int, repeat: int, suffix: str) -> str:
    return f"p{record + 1}_{repeat + 1}{suffix}"


def _text(poses: np.ndarray, repeats: int, tests: Sequence[ModalTest], paper: Paper) -> str:
    """Return the text of the campaign file."""
    style = FORMATS[paper.format]
    lines = [
        "format = 1",
        f'robot = "{ROBOT}"',
        f'band = ["{paper.band[0]:.6g} Hz", "{paper.band[1]:.6g} Hz"]',
        f'drives = "{paper.drives}"',
        f'repeatability = "{paper.repeatability}"',
    ]
    if paper.tones:
        tones = ", ".join(f'"{tone:g} Hz"' for tone in paper.tones)
        lines.append(f"tones = [{tones}]")
    for i, sensor in enumerate(tests[0].sensors):
        unit = "rad/s^2" if sensor.channel in paper.angles else "m/s^2"
        lines += ["", "[[sensor]]", f'name = "{style.sensor(i)}"', f'channel = "{sensor.channel}"']
        lines.append(f'unit = "{unit}"')
    if paper.force:
        lines += [
            "",
            "[[force]]",
            f'name = "{style.force(0)}"',
            f"direction = {list(paper.force)}",
            "fixed = true",
        ]
    for i, (pose, test) in enumerate(zip(poses, tests, strict=True)):
        files = ", ".join(f'"{_name(i, k, style.suffix)}"' for k in range(repeats))
        lines += ["", "[[record]]", f'pose = "P{i + 1}"', f"at = {_at(paper.components, pose)}"]
        lines += [f'kind = "{test.kind}"', f"files = [{files}]"]
        if test.kind == "frf" and paper.averages_stated:
            lines.append(f"averages = {test.averages}")
        if test.kind == "impact" and test.hits > 1:
            lines.append(f"hits = {test.hits}")
    return "\n".join(lines) + "\n"


def _at(components: Sequence[str], pose: np.ndarray) -> str:
    parts = (f'{name} = "{1e3 * value:.6g} mm"' for name, value in zip(components, pose, strict=True))
    return f"{{ {', '.join(parts)} }}"
