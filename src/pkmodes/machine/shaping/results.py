"""What a comparison of shapers says: each candidate, the recommended one, and the schedule over settings."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.attached import Attached
from pkmodes.machine.shaping.firmware import NAMES, change, command
from pkmodes.machine.shaping.ringing import Ringing
from pkmodes.machine.shaping.settings import Setting, append_unit
from pkmodes.machine.shaping.shapers import Shaper

Array = NDArray[np.float64]
#: A fixed shaper is good enough if it leaves at most this share of the vibration at the worst pose.
LEFT = 0.1


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
        Of the design [Hz], one for each factor; empty if it follows the pose.
    damping_ratio : float
        Of the design; NaN if it follows the pose.
    shaper : Shaper
        Impulses (n,), or (N, n) if it follows the pose.
    left : Amplitude
        Relative to no shaper: the root mean square and the largest value over those without a shaper.
    left_at : ndarray, shape (N,)
        The same at each pose, relative to no shaper there.
    """

    kind: str
    follows_pose: bool
    frequencies: tuple[float, ...]
    damping_ratio: float
    shaper: Shaper
    left: Amplitude
    left_at: Array

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


@dataclass(frozen=True)
class Choice:
    """Shapers for a machine, and the one that is recommended.

    Attributes
    ----------
    ringing : Ringing
        Of the machine.
    unshaped : Amplitude
        In s^2: m of platform vibration for a step of 1 m/s^2.
    candidates : tuple of Candidate
        The fixed ones, then those that follow the pose, if modes are known between poses.
    recommended : int
        Index of a fixed one.
    notes : tuple of str
    left : float
        Share of the vibration at the worst pose that is good enough.
    length : float or None
        Longest duration allowed [s].
    firmware : str or None
        The version of a firmware that has the recommended one, and whose impulses all have; None for any.
    schedule : Schedule or None
        Fixed shapers for one setting each; None without several settings.
    """

    ringing: Ringing
    unshaped: Amplitude
    candidates: tuple[Candidate, ...]
    recommended: int
    notes: tuple[str, ...]
    left: float = LEFT
    length: float | None = None
    firmware: str | None = None
    schedule: Schedule | None = None

    _repr_html_ = Attached("pkmodes.pages.report.notebook:of_shapers")


@dataclass(frozen=True)
class Step:
    """The shaper of one setting.

    Attributes
    ----------
    setting : Setting
    choice : Choice
        Of fixed shapers, over the poses at this setting and relative to it without a shaper.
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
        return self.choice.candidates[self.choice.recommended]

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
        In the order of the settings.
    parameter : str or None
        Path of the parameter that varies; None if several do.
    left : Amplitude
        What the shapers leave at their own settings, relative to no shaper over all settings: as for the fixed
        shapers of the `Choice`.
    """

    steps: tuple[Step, ...]
    parameter: str | None
    left: Amplitude

    def lines(self) -> dict[str, str | None]:
        """Return the commands for the current version of each firmware; see `commands`."""
        return {name: self.commands(name) for name in NAMES}

    def commands(self, version: str) -> str | None:
        """Return the commands for a version of a firmware, each after a comment that says where it belongs.

        None where the version lacks one of the shapers.

        Parameters
        ----------
        version : str
            Such as ``"klipper"`` or ``"klipper-2025-08"``.
        """
        lines = []
        for step in self.steps:
            text = change(version, *step.best.design)
            if text is None:
                return None
            where = str(step.setting)
            if self.parameter is not None and step.serves is not None:
                low, high = (f"{value:.4g}" for value in step.serves)
                served = append_unit(f"{low} to {high}", step.setting.units[self.parameter])
                where = f"{self.parameter} {served}"
            if step.heights is not None:
                where = f"from the layer at {1e3 * step.heights[0]:.1f} mm on: {where}"
            lines += [f"; {where}", text]
        return "\n".join(lines)


def command_of(candidate: Candidate) -> dict[str, str | None]:
    """Return the commands that set a fixed shaper between two moves, by firmware."""
    return command(*candidate.design)
