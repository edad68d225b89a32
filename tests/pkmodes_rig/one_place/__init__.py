"""Machines with one fault at one place: a mass, a spring, a bearing that yields, a resonator, a value of one axis."""

from __future__ import annotations

from pkmodes_rig.one_place.faults import Fault
from pkmodes_rig.one_place.machines import Assembly, assembled, modes_of

__all__ = ["Assembly", "Fault", "assembled", "modes_of"]
