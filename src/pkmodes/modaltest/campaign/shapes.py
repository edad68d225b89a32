"""From sensor readings to the components of a mode shape: least squares over all sensors.

On a platform that turns, metres and radians are made comparable by the spread of the sensors over it: a rotation
counts as the displacement at that distance.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.support.ordering import joined
from pkmodes.modaltest.campaign.mounts import ROTATION, rms_distance
from pkmodes.modaltest.campaign.sensors import Transducer
from pkmodes.modaltest.identification.estimates import rotate_to_real

Array = NDArray[np.float64]
#: A component is undetermined if its share in a motion that no sensor measures exceeds this.
MAX_HIDDEN_SHARE = 1e-6
#: Reasons why a component is blank.
UNDETERMINED = (
    "the measurements on the platform do not determine {}: left blank; "
    "add a sensor at another place or in another direction"
)
UNCERTAIN = "the error of {} would be as large as the largest component: left blank"


@dataclass(frozen=True, eq=False)
class ChannelShape:
    """A shape by channel.

    - values: components that the sensors determine; other channels are left out
    - growth: ratio of the relative standard deviation of the least certain component to that of the sensors; 1 if no
      platform turns, as its components are then as certain as its sensors
    - blank, uncertain: components of a turning platform that its sensors do not determine, and those whose error is
      as large as the largest component
    """

    values: dict[str, complex]
    growth: float = 1.0
    blank: tuple[str, ...] = ()
    uncertain: tuple[str, ...] = ()


def combine_sensors(
    shape: Mapping[str, complex], sensors: Mapping[str, Transducer], sigma: float = np.nan
) -> ChannelShape:
    """Return a shape by channel.

    - shape: by sensor
    - sensors: the sensors, by the same names, at the pose of the shape; those without weights appear in no shape
    - sigma: standard deviation of each sensor's component, relative to the largest
    """
    used = [name for name in shape if sensors[name].weights]
    order = dict.fromkeys(channel for name in used for channel in sensors[name].weights)
    components: dict[str, complex] = {}
    gains: dict[str, float] = {}
    for names in _independent_groups(used, sensors):
        solved = _solve(names, shape, sensors)
        components |= solved[0]
        gains |= solved[1]
    values = {channel: components[channel] for channel in order if channel in components}
    platform_channels = {
        name for sensor in used if (mount := sensors[sensor].mount) for name in mount.platform.components
    }
    if not platform_channels:
        return ChannelShape(values)
    largest_reading, well_determined = _largest_component(shape), values
    error, size = sigma * largest_reading, _largest_component(values)
    # Components whose errors are as large as the largest of them are left out, the least certain first.
    while well_determined and error * (worst := max(gains[name] for name in well_determined)) >= size > 0.0:
        well_determined = {name: value for name, value in well_determined.items() if gains[name] < worst}
        size = _largest_component(well_determined)
    growth = max(gains[name] for name in well_determined) * largest_reading / size if size > 0.0 else 1.0
    undetermined = tuple(name for name in order if name in platform_channels - values.keys())
    return ChannelShape(
        well_determined, growth, undetermined, tuple(name for name in values if name not in well_determined)
    )


def _independent_groups(used: Sequence[str], sensors: Mapping[str, Transducer]) -> list[list[str]]:
    """Return the sensors in groups that share no channel: of hundreds of sensors, most are in a group of one."""
    group_of: dict[str, list[str]] = {}
    for name in used:
        groups = {id(group_of[c]): group_of[c] for c in sensors[name].weights if c in group_of}
        merged = [*(sensor for group in groups.values() for sensor in group), name]
        for channel in {c for sensor in merged for c in sensors[sensor].weights}:
            group_of[channel] = merged
    return list({id(group): group for group in group_of.values()}.values())


def _solve(
    names: Sequence[str], shape: Mapping[str, complex], sensors: Mapping[str, Transducer]
) -> tuple[dict[str, complex], dict[str, float]]:
    """Return the channels that sensors determine, and the rms error of each for an error of 1 at every sensor."""
    channels = list(dict.fromkeys(channel for name in names for channel in sensors[name].weights))
    A = np.array([[sensors[name].weights.get(channel, 0.0) for channel in channels] for name in names])
    values = np.array([shape[name] for name in names])
    rows, columns = np.ones(len(names)), np.ones(len(channels))
    if mounts := [mount for name in names if (mount := sensors[name].mount) is not None]:
        length = rms_distance(mounts)  # by which rotations of sensors and of channels become metres
        rows = np.array([length if mount.angular else 1.0 for mount in mounts])
        columns = np.array([length if channel.startswith(ROTATION) else 1.0 for channel in channels])
    U, s, Vh = np.linalg.svd(A * rows[:, None] / columns)
    rank = int((s > MAX_HIDDEN_SHARE * s[0]).sum())
    hidden = np.abs(Vh[rank:]).max(axis=0, initial=0.0) > MAX_HIDDEN_SHARE
    solution = Vh[:rank].T @ ((U[:, :rank].T @ (values * rows)) / s[:rank]) / columns
    gains = np.linalg.norm(Vh[:rank].T @ (U[:, :rank].T * rows / s[:rank, None]), axis=1) / columns
    determined = [i for i in range(len(channels)) if not hidden[i] and np.isfinite(solution[i])]
    return {channels[i]: complex(solution[i]) for i in determined}, {
        channels[i]: float(gains[i]) for i in determined
    }


def _largest_component(shape: Mapping[str, complex]) -> float:
    """Return the largest real part of a shape rotated to be as real as possible."""
    components = np.array(list(shape.values()))
    rotated_norm = np.linalg.norm(rotate_to_real(components)) if len(components) else 0.0
    return float(np.linalg.norm(components) / rotated_norm) if rotated_norm > 0.0 else 0.0


def blank_messages(where: str, sentence: str, modes: Sequence[tuple[float, Sequence[str]]]) -> list[str]:
    """Return messages about the components that are blank in modes, each given by its frequency [Hz]."""
    frequencies_of: dict[tuple[str, ...], list[str]] = {}
    for frequency, names in modes:
        frequencies_of.setdefault(tuple(names), []).append(f"{frequency:.4g}")
    messages = []
    for names, frequencies in frequencies_of.items():
        in_modes = (
            f" in the mode{'s' if len(frequencies) > 1 else ''} at {', '.join(frequencies)} Hz"
            if len(frequencies_of) > 1
            else ""
        )
        messages += [f"{where}: {sentence.format(joined(names, 'or') + in_modes)}"] if names else []
    return messages


def rotate_shape(shape: Mapping[str, complex]) -> dict[str, complex]:
    """Return a shape rotated to be as real as possible, relative to its largest component; its real part is used."""
    if not shape:
        return {}
    rotated = rotate_to_real(np.array(list(shape.values())))
    return dict(zip(shape, rotated.tolist(), strict=True))
