"""The kinds of records: how the modes of one file are found.

Another kind is an entry of `KINDS` and a function.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

from pkmodes.modaltest.campaign.ambient_records import ambient_modes
from pkmodes.modaltest.campaign.campaign import Campaign, Record
from pkmodes.modaltest.campaign.frequency_records import frf_modes, spectrum_modes
from pkmodes.modaltest.campaign.identified_modes import identified_modes
from pkmodes.modaltest.campaign.impact_records import impact_modes, roving_modes
from pkmodes.modaltest.campaign.mode_estimates import FileModes
from pkmodes.modaltest.campaign.roving import RovingPoint
from pkmodes.modaltest.campaign.roving_functions import roving_frf_modes


@dataclass(frozen=True)
class RecordKind:
    """A kind of record.

    - find_modes: the modes of a file of a setup, their shapes by sensor or, if `by_channel`, by channel.  Raises
      `MeasurementError` for a faulty file.
    - signals: whether its files have signals, to which a mode can be fitted
    - fit_roving: the modes of one file of each setup, fitted together, where a hammer roved in front of sensors that
      stayed.  Raises `MeasurementError` for a faulty file, and `SeparateFitError` if they cannot be fitted together.
    - forces: whether the forces of the campaign are in its files
    """

    find_modes: Callable[[Path, Record, str, Campaign], FileModes]
    by_channel: bool = False
    signals: bool = True
    fit_roving: Callable[[Mapping[str, RovingPoint], Record, Campaign], FileModes] | None = None
    forces: bool = False


KINDS = {
    "frf": RecordKind(frf_modes, fit_roving=roving_frf_modes, forces=True),
    "impact": RecordKind(impact_modes, fit_roving=roving_modes, forces=True),
    "ambient": RecordKind(ambient_modes),
    "spectrum": RecordKind(spectrum_modes),
    "modes": RecordKind(identified_modes, by_channel=True, signals=False),
}
