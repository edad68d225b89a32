"""From what sensors show to the components of a mode shape: least squares over all sensors."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from pkmodes.campaign.sensors import Place
from pkmodes.identification.estimates import turned_real

#: A component is undetermined if a motion that no sensor shows has more than this part in it.
HIDDEN = 1e-6


def by_channel(shape: Mapping[str, complex], places: Mapping[str, Place]) -> dict[str, complex]:
    """Return a shape by channel.

    Parameters
    ----------
    shape : mapping of str to complex
        By sensor.
    places : mapping of str to Place
        The sensors, by the same names; those without weights are in no shape.

    Returns
    -------
    dict of str to complex
        What the sensors determine; other channels are left out.
    """
    used = [name for name in shape if places[name].weights]
    order = dict.fromkeys(channel for name in used for channel in places[name].weights)
    found: dict[str, complex] = {}
    for names in _together(used, places):
        found |= _solved(names, shape, places)
    return {channel: found[channel] for channel in order if channel in found}


def _together(used: Sequence[str], places: Mapping[str, Place]) -> list[list[str]]:
    """Return the sensors in groups that have no channel in common: hundreds of them are mostly alone."""
    group_of: dict[str, list[str]] = {}
    for name in used:
        groups = {id(group_of[c]): group_of[c] for c in places[name].weights if c in group_of}
        merged = [*(one for group in groups.values() for one in group), name]
        for channel in {c for one in merged for c in places[one].weights}:
            group_of[channel] = merged
    return list({id(group): group for group in group_of.values()}.values())


def _solved(
    names: Sequence[str], shape: Mapping[str, complex], places: Mapping[str, Place]
) -> dict[str, complex]:
    """Return the channels that some sensors determine."""
    channels = list(dict.fromkeys(channel for name in names for channel in places[name].weights))
    A = np.array([[places[name].weights.get(channel, 0.0) for channel in channels] for name in names])
    values = np.array([shape[name] for name in names])
    U, s, Vh = np.linalg.svd(A)
    rank = int((s > HIDDEN * s[0]).sum())
    hidden = np.abs(Vh[rank:]).max(axis=0, initial=0.0) > HIDDEN
    found = Vh[:rank].T @ ((U[:, :rank].T @ values) / s[:rank])
    return {
        channel: complex(found[i])
        for i, channel in enumerate(channels)
        if not hidden[i] and np.isfinite(found[i])
    }


def turned_shape(shape: Mapping[str, complex]) -> dict[str, complex]:
    """Return a shape turned as real as possible, relative to its largest component: its real part is what counts."""
    if not shape:
        return {}
    turned = turned_real(np.array(list(shape.values())))
    return dict(zip(shape, turned.tolist(), strict=True))
