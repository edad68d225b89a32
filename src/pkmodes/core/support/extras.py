"""Libraries of the optional extras, which everything else works without."""

from __future__ import annotations

from importlib.util import find_spec

from pkmodes.core.base.errors import MissingExtraError


def require(features: str, extra: str, *libraries: str) -> None:
    """Check, before anything is computed, that libraries are installed.

    - features: what needs them, in the plural
    - extra: the extra that brings them
    - *libraries: names to import

    Raises MissingExtraError if one is not installed.
    """
    for library in libraries:
        if find_spec(library) is None:
            raise MissingExtraError(
                f"{library} is not installed; {features} need it",
                "optional dependency",
                f"install it with: pip install 'pkmodes[{extra}]'",
            )
