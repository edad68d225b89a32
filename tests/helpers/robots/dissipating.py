"""The effects that only dissipate, as a mechanism says: M, K and frequencies do not depend on them."""

from __future__ import annotations

from pkmodes.core.mechanism.registry import mechanism


def dissipating(name: str) -> tuple[str, ...]:
    """Names of those that apply to a mechanism, in the order of its catalogue."""
    of = mechanism(name)
    return tuple(effect for effect in of.effects if effect not in of.conservative_effects)
