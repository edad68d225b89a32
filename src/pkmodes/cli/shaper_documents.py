"""What ``pkmodes shaper --json`` writes: for a robot, and for measured modes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Self

import msgspec
from msgspec import Meta

from pkmodes.core.base.drives import Drives
from pkmodes.core.base.numbers import plain
from pkmodes.core.support.documents import Count, Document, Number, Size
from pkmodes.machine.shaping.measured_modes import LeftOfModes
from pkmodes.machine.shaping.version_lines import VersionLines

if TYPE_CHECKING:
    from pkmodes.machine.shaping.measured_spectrum import MeasuredSpectrum
    from pkmodes.machine.shaping.results import Choice


#: Settings of an operating point.
SettingsOf = Annotated[
    dict[str, float],
    Meta(description="Values of --set there, by path, in SI units; present only with --set."),
]
#: Lines by version of the firmware, beside those for the current versions.
VersionsOf = Annotated[
    list[VersionLines],
    Meta(
        description="The same with the versions for which they are, and those for others where they differ."
    ),
]


class UnshapedDocument(Document, frozen=True, omit_defaults=True):
    """Vibration of the platform without a shaper, for a step of its acceleration by 1 m/s^2."""

    rms: Annotated[Size, Meta(description="Root mean square over the poses [s^2].")]
    worst: Annotated[Size, Meta(description="Largest value [s^2].")]
    pose: Annotated[list[float], Meta(description="Where it is largest, in SI units.")]
    settings: SettingsOf = msgspec.field(name="set", default_factory=dict)


class LeftDocument(Document, frozen=True, omit_defaults=True):
    """Vibration that a shaper leaves, relative to none."""

    rms: Annotated[Size, Meta(description="Root mean square over that without a shaper.")]
    worst: Annotated[Size, Meta(description="Largest value over the largest without a shaper.")]
    pose: Annotated[list[float], Meta(description="Where most is left, in SI units.")]
    rms_uncertain: Annotated[
        Size | None,
        Meta(
            description="rms with frequencies spread by the standard deviations of the robot file; null without any."
        ),
    ]
    settings: SettingsOf = msgspec.field(name="set", default_factory=dict)


class LeftAtPoseDocument(Document, frozen=True, omit_defaults=True):
    """Vibration that a shaper leaves at each pose, relative to none at the same pose and setting."""

    rms: Annotated[Size, Meta(description="Root mean square over the poses.")]
    worst: Annotated[Size, Meta(description="Largest value.")]
    pose: Annotated[list[float], Meta(description="Where it is largest, in SI units.")]
    rms_uncertain: Annotated[
        Size | None,
        Meta(
            description="rms with frequencies spread by the standard deviations of the robot file; null without any."
        ),
    ]
    settings: SettingsOf = msgspec.field(name="set", default_factory=dict)


#: What Klipper suggests as its ``max_accel``.
MaxAcceleration = Annotated[
    Size | None,
    Meta(
        description="Largest acceleration at which corners are smoothed by no more than 0.12 mm, as Klipper suggests "
        "its max_accel [m/s^2]; null if it follows the pose."
    ),
]


class CandidateDocument(Document, frozen=True):
    """A shaper."""

    kind: Annotated[str, Meta(description="Such as zv, or zv*zv for two modes.")]
    follows_pose: Annotated[bool, Meta(description="Whether it is designed anew for the modes of each pose.")]
    frequencies_hz: Annotated[
        list[float] | None,
        Meta(
            description="Of the design, one for each factor [Hz]; null if it follows the pose, as the next three."
        ),
    ]
    damping_ratios: Annotated[list[float] | None, Meta(description="Of the design, likewise.")]
    amplitudes: Annotated[list[float] | None, Meta(description="Of the impulses; their sum is 1.")]
    delays_s: Annotated[list[float] | None, Meta(description="Of the impulses [s].")]
    duration_s: Annotated[Size, Meta(description="Delay of the last impulse [s]; the longest of all poses.")]
    max_acceleration: MaxAcceleration
    left: Annotated[LeftDocument, Meta(description="Vibration that it leaves.")]
    left_at_pose: Annotated[
        LeftAtPoseDocument, Meta(description="The same at each pose, relative to none at this pose.")
    ]


class StepDocument(Document, frozen=True, kw_only=True):
    """The shaper for one setting of a schedule."""

    settings: Annotated[dict[str, float], Meta(description="Values of --set, by path, in SI units.")] = (
        msgspec.field(name="set", default_factory=dict)
    )
    serves: Annotated[
        list[float] | None,
        Meta(
            description="Values of the parameter between which it serves [SI]: halfway to its neighbours; null where "
            "several parameters vary."
        ),
    ]
    heights_m: Annotated[
        list[float] | None,
        Meta(description="Heights of the print between which it serves [m]; null without --height."),
    ]
    poses: Annotated[Count, Meta(description="Number of poses that count at this setting.")]
    kind: Annotated[str, Meta(description="Such as zv, or zv*zv for two modes.")]
    frequencies_hz: Annotated[list[float], Meta(description="Of the design, one for each factor [Hz].")]
    damping_ratios: Annotated[list[float], Meta(description="Of the design, likewise.")]
    amplitudes: Annotated[list[float], Meta(description="Of the impulses; their sum is 1.")]
    delays_s: Annotated[list[float], Meta(description="Of the impulses [s].")]
    duration_s: Annotated[Size, Meta(description="Delay of the last impulse [s].")]
    rounding_s2: Annotated[
        Size,
        Meta(
            description="Distance of the shaped path from the command for each m/s^2 of acceleration [s^2]: half "
            "the variance of the impulses in time."
        ),
    ]
    left: Annotated[
        LeftDocument, Meta(description="Vibration that it leaves, relative to none at this setting.")
    ]
    left_at_ends: Annotated[
        Size | None,
        Meta(
            description="Largest value halfway to its neighbours, over the largest without a shaper there; null "
            "where several parameters vary."
        ),
    ]
    left_by_fixed: Annotated[
        Size,
        Meta(
            description="Largest value that the recommended shaper for all settings leaves at this one, over the "
            "largest without a shaper here."
        ),
    ]
    firmware: Annotated[
        dict[str, str | None],
        Meta(
            description="Commands for klipper, marlin and reprapfirmware during a print; null where it has no such "
            "shaper."
        ),
    ]


class ScheduleDocument(Document, frozen=True):
    """Fixed shapers for one setting each."""

    units: Annotated[dict[str, str], Meta(description="SI units of the parameters of --set, by path.")]
    left: Annotated[
        LeftDocument,
        Meta(
            description="Vibration that the schedule leaves over all settings, as for the shapers for all of them."
        ),
    ]
    left_at_pose: Annotated[
        LeftAtPoseDocument, Meta(description="The same at each pose and setting, relative to none there.")
    ]
    steps: Annotated[list[StepDocument], Meta(description="In the order of the settings.")]
    firmware: Annotated[
        dict[str, str | None],
        Meta(
            description="Commands of all steps, each after a comment that says where it belongs; null where the "
            "firmware lacks one of the shapers."
        ),
    ]
    firmware_versions: VersionsOf


class AxisDocument(Document, frozen=True):
    """Fixed shapers for one of several independent axes, and for the modes that it excites."""

    axis: Annotated[str, Meta(description="Name of the axis.")]
    modes: Annotated[Count, Meta(description="Number of modes that count, at most at a pose.")]
    unshaped: Annotated[UnshapedDocument, Meta(description="Without a shaper, for a step along this axis.")]
    shapers: Annotated[list[CandidateDocument], Meta(description="The best one of each kind.")]
    recommended: Annotated[Count, Meta(description="Index of the recommended one.")]
    schedule: Annotated[
        ScheduleDocument | None,
        Meta(
            description="The shaper of each setting; null where no frequency of the axis changes with --set."
        ),
    ]


class SpectrumDocument(Document, frozen=True):
    """A measured spectrum, over which shapers are drawn."""

    file: Annotated[str, Meta(description="The file, as given.")]
    peak_hz: Annotated[
        Size, Meta(description="Its highest line, from half the lowest mode to 1.4 times the highest [Hz].")
    ]
    at_mode: Annotated[bool, Meta(description="Whether one of the modes is there, within a line or 2 %.")]
    left: Annotated[
        Size,
        Meta(
            description="What the recommended shaper leaves of a mode there with the damping ratio of its design; of "
            "several axes, the one that leaves most."
        ),
    ]

    @classmethod
    def with_notes(cls, spectrum: MeasuredSpectrum | None, choice: Choice) -> tuple[Self | None, list[str]]:
        """Return the document of a spectrum, and notes on it; None and no notes without a spectrum."""
        if spectrum is None:
            return None, []
        from pkmodes.machine.shaping.residual_vibration import residual

        peak, at_mode = spectrum.highest_peak(choice.ringing.frequencies)
        recommended = [part.best for part in choice.parts.values()]
        share = max(float(residual(best.shaper, peak, best.damping_ratio)) for best in recommended)
        missing = (
            f"the highest peak of the spectrum, at {peak:.4g} Hz, is at none of the modes: a mode may be missing "
            f"or wrong; the recommended shaper leaves {plain(100.0 * share, 2)} % of a mode there"
        )
        return cls(file=spectrum.source, peak_hz=peak, at_mode=at_mode, left=share), [] if at_mode else [
            missing
        ]


class ShaperDocument(Document, frozen=True):
    """Shapers for the modes of a machine in use, compared over poses."""

    robot: Annotated[str, Meta(description="Name of the robot.")]
    drives: Drives
    poses: Annotated[Count, Meta(description="Number of poses that count, at all settings together.")]
    modes: Annotated[Count, Meta(description="Number of modes that count, the lowest.")]
    unshaped: Annotated[UnshapedDocument, Meta(description="Without a shaper.")]
    shapers: Annotated[
        list[CandidateDocument],
        Meta(description="The best fixed one of each kind, then those that follow the pose."),
    ]
    recommended: Annotated[
        Count, Meta(description="Index of the recommended one, which is fixed, and for all axes together.")
    ]
    axes: Annotated[
        list[AxisDocument],
        Meta(description="The shapers of each axis; empty unless the axes are independent."),
    ]
    spectrum: SpectrumDocument | None
    firmware: Annotated[
        dict[str, str | None],
        Meta(
            description="Lines for the current klipper, marlin and reprapfirmware, of each axis where the axes are "
            "independent; null where it has no such shaper."
        ),
    ]
    firmware_versions: VersionsOf
    schedule: Annotated[
        ScheduleDocument | None,
        Meta(description="The shaper of each setting; null unless --set gives several values."),
    ]
    notes: Annotated[list[str], Meta(description="What the reader should know.")]


class MeasuredCandidateDocument(Document, frozen=True):
    """A shaper for measured modes."""

    kind: Annotated[str, Meta(description="Such as zv, or zv*zv for two modes.")]
    frequencies_hz: Annotated[list[float], Meta(description="Of the design, one for each factor [Hz].")]
    damping_ratios: Annotated[list[float], Meta(description="Of the design, likewise.")]
    amplitudes: Annotated[list[float], Meta(description="Of the impulses; their sum is 1.")]
    delays_s: Annotated[list[float], Meta(description="Of the impulses [s].")]
    duration_s: Annotated[Size, Meta(description="Delay of the last impulse [s].")]
    max_acceleration: MaxAcceleration
    rounding_s2: Annotated[
        Size,
        Meta(
            description="Distance of the shaped path from the command for each m/s^2 of acceleration [s^2]: half "
            "the variance of the impulses in time."
        ),
    ]
    left: Annotated[LeftOfModes, Meta(description="Vibration that it leaves.")]


class MeasuredModeDocument(Document, frozen=True):
    """A measured mode, and what the recommended shaper leaves of it."""

    pose: Annotated[str, Meta(description="Label of its pose.")]
    line: Annotated[Number, Meta(description="Line of the file.")]
    frequency_hz: Annotated[Size, Meta(description="As measured [Hz].")]
    sigma_hz: Annotated[Size, Meta(description="Its standard deviation [Hz].")]
    damping_ratio: Annotated[
        Size | None, Meta(description="As measured, or as --damping gives it; null where unknown.")
    ]
    left: Annotated[Size, Meta(description="Left of it as measured, relative to no shaper.")]
    left_uncertain: Annotated[
        Size,
        Meta(description="At most, anywhere within two standard deviations of frequency and damping ratio."),
    ]


class MeasuredShaperDocument(Document, frozen=True):
    """Fixed shapers for measured modes, each of which counts in full."""

    measured: Annotated[str, Meta(description="The measurement file, as given.")]
    drives: Annotated[Drives, Meta(description="What the motors did at the poses that count.")]
    poses: Annotated[Count, Meta(description="Number of poses that count.")]
    modes: Annotated[Count, Meta(description="Number of modes that count, at all poses together.")]
    shapers: Annotated[list[MeasuredCandidateDocument], Meta(description="The best one of each kind.")]
    recommended: Annotated[Count, Meta(description="Index of the recommended one.")]
    measured_modes: Annotated[list[MeasuredModeDocument], Meta(description="In the order of the file.")]
    spectrum: SpectrumDocument | None
    firmware: Annotated[
        dict[str, str | None],
        Meta(
            description="Lines for the current klipper, marlin and reprapfirmware; null where it has no such shaper."
        ),
    ]
    firmware_versions: VersionsOf
    notes: Annotated[list[str], Meta(description="What the reader should know.")]
