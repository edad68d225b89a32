"""A generated module with one result spoilt, to see that checks find it."""

from __future__ import annotations

from pkmodes_generated import linear_delta


class Broken:
    """A generated module with one result replaced."""

    def __init__(self, name: str, factor: float) -> None:
        self.name, self.factor = name, factor

    def __getattr__(self, name: str) -> object:
        function = getattr(linear_delta, name)
        if name != self.name:
            return function

        def scaled(*arguments: object) -> object:
            result = function(*arguments)
            return (
                tuple(self.factor * r for r in result) if isinstance(result, tuple) else self.factor * result
            )

        return scaled
