"""Names of kinds of shapers and of products, and what they stand for."""

from __future__ import annotations

from pkmodes.core.base.arguments import alternatives
from pkmodes.core.base.errors import PkmodesError, nearest_name, shown
from pkmodes_description.shapers import SHAPERS, Kind

PRODUCT = "*"
#: Names of the kinds of shapers for a single mode.
KINDS = tuple(SHAPERS)


def factors(kind: str) -> tuple[Kind, ...]:
    """Return the factors of a product such as "zv*zv*ei", or the one kind.

    Raises PkmodesError if a factor is not a kind of shaper (the message suggests the nearest).
    """
    names = factor_names(kind)
    for name in names:
        if not isinstance(name, str) or name not in SHAPERS:
            of = f" in {shown(kind)}" if len(names) > 1 else ""
            problem = (
                f"expected {alternatives(KINDS)}, or a product such as zv{PRODUCT}zv, found {shown(name)}{of}"
            )
            raise PkmodesError(problem, "kind", nearest_name(name, KINDS))
    return tuple(SHAPERS[name] for name in names)


def plain(kind: str) -> str:
    """Return the name of a kind without blanks."""
    return PRODUCT.join(factor_names(kind)) if isinstance(kind, str) else kind


def factor_names(kind: str) -> tuple[str, ...]:
    """Return the names of the factors of a product, or the one name."""
    return tuple(name.strip() for name in kind.split(PRODUCT)) if isinstance(kind, str) else (kind,)
