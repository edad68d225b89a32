"""What the derivation emits for every mechanism, once for all tests of a run."""

from __future__ import annotations

from helpers.runs.shared import Shared
from pkmodes_derive import mechanisms
from pkmodes_derive.emit import latex, product

#: The real one: a test may put `Emission.parametric` in its place.
_parametric = product.parametric


class Emission:
    """Texts that every worker would otherwise emit again."""

    def __init__(self, shared: Shared) -> None:
        self._shared = shared

    def parametric(self, mechanism: str, definition: str = "") -> dict[str, str]:
        """Return the parametric model of a mechanism that comes with pkmodes: texts by file name."""
        assert not definition
        return self._shared.value(f"parametric_{mechanism}", lambda: _parametric(mechanism))

    def page(self, mechanism: str) -> str:
        """Return the page of its derivation."""
        return self._shared.value(f"page_{mechanism}", lambda: latex.page(mechanisms.base(mechanism)))
