"""What a comparison of shapers says: each candidate, the recommended one, and the schedule over settings."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.attached import Attached
from pkmodes.machine.shaping.firmware import (
    AXES,
    FIRMWARE_TITLES,
    VERSIONS,
    commands_by_firmware,
    configuration_lines,
    runtime_command,
)
from pkmodes.machine.shaping.ringing import Ringing
from pkmodes.machine.shaping.settings import Setting, append_unit
from pkmodes.machine.shaping.shapers import Shaper

Array = NDArray[np.float64]
#: Smoothing of corners to which Klipper limits the acceleration that it suggests [m], and its default speed at
#: corners of 90 degrees (square_corner_velocity) [m/s].
SMOOTHING, CORNER_SPEED = 0.12e-3, 5e-3
#: A fixed shaper is good enough if it leaves at most this share of the largest vibration without a shaper.
GOOD_ENOUGH_SHARE = 0.1


@dataclass(frozen=True)
class Amplitude:
    """Vibration over all poses, and over all settings if there are several.

    Attributes
    ----------
    rms, worst : float
        Root mean square and largest value.
    pose : ndarray, shape (d,)
        Where it is largest.
    rms_uncertain : float or None
        The root mean square with frequencies spread by the standard deviations of the robot file, where it has any.
    setting : Setting or None
        That where it is largest; None without settings.
    """

    rms: float
    worst: float
    pose: Array
    rms_uncertain: float | None = None
    setting: Setting | None = None


@dataclass(frozen=True)
class Candidate:
    """A shaper for all poses and settings, or one for each of them.

    Attributes
    ----------
    kind : str
    follows_pose : bool
        And the settings, if there are several.
    frequencies : tuple of float
        Design frequencies [Hz], one for each factor; empty if it follows the pose.
    damping_ratio : float
        Design damping ratio; NaN if it follows the pose.
    shaper : Shaper
        Impulses (n,), or (N, n) if it follows the pose.
    left : Amplitude
        Relative to no shaper: the root mean square and the largest value over those without a shaper.
    left_at : ndarray, shape (N,)
        The same at each pose, relative to no shaper there.
    left_at_pose : Amplitude
        Root mean square and largest value of ``left_at``: at each pose relative to no shaper at the same pose.
    """

    kind: str
    follows_pose: bool
    frequencies: tuple[float, ...]
    damping_ratio: float
    shaper: Shaper
    left: Amplitude
    left_at: Array
    left_at_pose: Amplitude

    @property
    def duration(self) -> float:
        """How much longer a command takes [s], at most."""
        return float(np.max(self.shaper.durations))

    @property
    def design(self) -> tuple[str, tuple[float, ...], float, Shaper]:
        """Kind, frequencies [Hz], damping ratio and impulses of a fixed one: what lines for firmware are made of."""
        return self.kind, self.frequencies, self.damping_ratio, self.shaper

    @property
    def rounding(self) -> float:
        """Distance of a path of constant acceleration from its command, for 1 m/s^2 [s^2]; fixed shapers only.

        The command is delayed by the mean of the impulses, and half their variance remains.
        """
        amplitudes, delays = self.shaper
        return float(
            0.5 * np.average((delays - np.average(delays, weights=amplitudes)) ** 2, weights=amplitudes)
        )

    @property
    def max_acceleration(self) -> float | None:
        """Largest acceleration that Klipper would suggest [m/s^2]; None if the shaper follows the pose.

        The one at which corners are smoothed by `SMOOTHING` (``find_shaper_max_accel`` of its shaper_calibrate.py):
        where a move turns back, the distance from the command is `rounding` times the acceleration; at a corner of
        90 degrees, passed at `CORNER_SPEED`, it is that of the impulses after their mean.  0 if a corner is smoothed
        more at this speed alone.
        """
        if self.follows_pose:
            return None
        amplitudes, delays = self.shaper
        later = np.maximum(delays - np.average(delays, weights=amplitudes), 0.0)
        at_speed, at_acceleration = np.average([later, 0.5 * later**2], axis=1, weights=amplitudes)
        corner = (SMOOTHING / np.sqrt(2.0) - CORNER_SPEED * at_speed) / at_acceleration
        return max(0.0, float(min(corner, SMOOTHING / self.rounding)))


def recommended_of(
    candidates: Sequence[Candidate],
    share: float,
    length: float | None,
    firmware: str | None,
    axes: str = AXES,
) -> tuple[int | None, bool]:
    """Return the index of the shortest fixed shaper that is good enough, or else of the best one.

    - share: share of the largest vibration that is good enough
    - length: longest duration allowed [s]
    - firmware: the version of a firmware that has it; None for any
    - axes: axes that the shaper is for

    Returns, in this order:
    - index: None if none lasts at most `length`, or the firmware has none
    - good: whether it is good enough
    """
    allowed = [
        i
        for i, candidate in enumerate(candidates)
        if not candidate.follows_pose
        and (length is None or candidate.duration <= length)
        and (firmware is None or configuration_lines(firmware, *candidate.design, axes) is not None)
    ]
    good = [i for i in allowed if candidates[i].left.worst <= share]
    if good:
        return min(good, key=lambda i: candidates[i].duration), True
    return min(allowed, key=lambda i: candidates[i].left.worst, default=None), False


@dataclass(frozen=True)
class Choice:
    """Shapers for a machine, and the one that is recommended.

    Attributes
    ----------
    ringing : Ringing
        Modes of the machine in use.
    unshaped : Amplitude
        Vibration without a shaper [s^2]: m of platform vibration for a step of 1 m/s^2.
    candidates : tuple of Candidate
        The fixed ones, then those that follow the pose, if modes are known between poses.
    recommended : int
        Index of a fixed one.
    notes : tuple of str
    left : float
        Share of the largest vibration without a shaper that is good enough.
    length : float or None
        Longest duration allowed [s].
    firmware : str or None
        The version of a firmware that has the recommended one, and whose impulses all have; None for any.
    schedule : Schedule or None
        Fixed shapers for one setting each; None without several settings.
    by_axis : mapping of str to Choice
        The choice for each axis by itself, where the axes are independent; else empty.
    """

    ringing: Ringing
    unshaped: Amplitude
    candidates: tuple[Candidate, ...]
    recommended: int
    notes: tuple[str, ...]
    left: float = GOOD_ENOUGH_SHARE
    length: float | None = None
    firmware: str | None = None
    schedule: Schedule | None = None
    by_axis: Mapping[str, Choice] = field(default_factory=dict)

    _repr_html_ = Attached("pkmodes.pages.report.notebook:shapers_html")

    @property
    def best(self) -> Candidate:
        """The recommended shaper."""
        return self.candidates[self.recommended]

    def best_in(self, version: str, axes: str = AXES, without: str = "") -> Candidate | None:
        """Return the recommended shaper, or the best one that a version of a firmware has; None if it has none.

        - version: such as ``"klipper"`` or ``"klipper-2025-08"``
        - axes: axes that the shaper is for
        - without: a kind that does not count
        """
        if self.best.kind != without and configuration_lines(version, *self.best.design, axes) is not None:
            return self.best
        candidates = [candidate for candidate in self.candidates if candidate.kind != without]
        index, _ = recommended_of(candidates, self.left, self.length, version, axes)
        return None if index is None else candidates[index]

    @property
    def parts(self) -> Mapping[str, Choice]:
        """The choices that count: by axis, or the choice for all axes under an empty name."""
        return self.by_axis or {"": self}


@dataclass(frozen=True)
class Step:
    """The shaper of one setting.

    Attributes
    ----------
    setting : Setting
    choice : Choice
        Choice of fixed shapers, over the poses at this setting and relative to it without a shaper.
    fixed : float
        What the recommended shaper for all settings leaves here: the largest value over the largest without a shaper
        at this setting.
    serves : tuple of float or None
        Values of the parameter between which it serves [SI]; None where several parameters vary.
    at_ends : float or None
        What it leaves halfway to the neighbouring settings: the largest value over the largest without a shaper
        there, of both ends the larger one.
    heights : tuple of float or None
        Layer heights between which it serves [m]; None where none were given.
    """

    setting: Setting
    choice: Choice
    fixed: float
    serves: tuple[float, float] | None = None
    at_ends: float | None = None
    heights: tuple[float, float] | None = None

    @property
    def best(self) -> Candidate:
        """The shaper that serves."""
        return self.choice.best

    @property
    def good(self) -> bool:
        """Whether it leaves no more than the allowed share."""
        return self.best.left.worst <= self.choice.left


@dataclass(frozen=True)
class Schedule:
    """Shapers for one setting each.

    Attributes
    ----------
    steps : tuple of Step
        Steps in the order of the settings.
    parameter : str or None
        Path of the parameter that varies; None if several do.
    left : Amplitude
        What the shapers leave at their own settings, relative to no shaper over all settings: as for the fixed
        shapers of the `Choice`.
    left_at_pose : Amplitude
        The same relative to no shaper at the same pose and setting.
    axis : str
        The axis that it is for; empty for all.
    """

    steps: tuple[Step, ...]
    parameter: str | None
    left: Amplitude
    left_at_pose: Amplitude
    axis: str = ""

    def lines(self) -> dict[str, str | None]:
        """Return the commands for the current version of each firmware; None where it lacks one of the shapers."""
        return {name: None if self.differs_in(name) else self.commands(name) for name in FIRMWARE_TITLES}

    def differs_in(self, version: str) -> bool:
        """Whether a version of a firmware lacks one of the shapers: as for `commands`."""
        shapers = self.shapers_in(version)
        return shapers is None or [shaper.kind for shaper in shapers] != [
            step.best.kind for step in self.steps
        ]

    def commands(self, version: str) -> str | None:
        """Return the commands for a version of a firmware, each after a comment that says where it belongs.

        A shaper that the version lacks is replaced by the best one that it has; None if it has none.

        Parameters
        ----------
        version : str
            Such as ``"klipper"`` or ``"klipper-2025-08"``.
        """
        lines, axes = [], self.axis or AXES
        shapers = self.shapers_in(version)
        if shapers is None:
            return None
        for step, shaper in zip(self.steps, shapers, strict=True):
            text = runtime_command(version, *shaper.design, axes) or ""
            where = str(step.setting)
            if self.parameter is not None and step.serves is not None:
                low, high = (f"{value:.4g}" for value in step.serves)
                served = append_unit(f"{low} to {high}", step.setting.units[self.parameter])
                where = f"{self.parameter} {served}"
            if step.heights is not None:
                where = f"from the layer at {1e3 * step.heights[0]:.1f} mm on: {where}"
            lines += [f"; {where}", text]
        return "\n".join(lines)

    def shapers_in(self, version: str) -> list[Candidate] | None:
        """Return the shaper of each step that a version of a firmware has; None if it has none for one of them.

        Parameters
        ----------
        version : str
            As for `commands`.
        """
        by_step = {str(i): step.choice for i, step in enumerate(self.steps)}
        shapers = shapers_in(version, dict.fromkeys(by_step, self.axis or AXES), by_step)
        return None if shapers is None else list(shapers.values())


def shapers_in(
    version: str, axes: Mapping[str, str], choices: Mapping[str, Choice]
) -> dict[str, Candidate] | None:
    """Return the best shapers of several choices that a version of a firmware has; None if it has none for one.

    Marlin has zv by M593, and others by fixed-time motion, which turns M593 off: it gets no mixture of both.

    - version: a key of `pkmodes.machine.shaping.firmware.VERSIONS`
    - axes: axes that the shaper of each choice is for
    - choices: under the same names
    """
    shapers = {name: choice.best_in(version, axes[name]) for name, choice in choices.items()}
    kinds = {shaper.kind for shaper in shapers.values() if shaper is not None}
    if VERSIONS[version].firmware == "marlin" and "zv" in kinds and len(kinds) > 1:
        shapers = {name: choice.best_in(version, axes[name], "zv") for name, choice in choices.items()}
    if any(shaper is None for shaper in shapers.values()):
        return None
    return {name: shaper for name, shaper in shapers.items() if shaper is not None}


def command_of(candidate: Candidate, axis: str = "") -> dict[str, str | None]:
    """Return the commands that set a fixed shaper between two moves, by firmware.

    - axis: axis that they are for; empty for all
    """
    return commands_by_firmware(*candidate.design, axis or AXES)
