"""The catalogue of effects: every module in this folder defines one; there is no other list."""

from __future__ import annotations

from importlib import import_module
from pkgutil import iter_modules

from pkmodes_derive.effect import Effect


def catalogue() -> tuple[Effect, ...]:
    """Return every effect, those that release coordinates last and in the order of their coordinates.

    Raises
    ------
    ValueError
        If two effects have the same name, or a module is not named after its effect.
    """
    effects: dict[str, Effect] = {}
    for module in sorted(iter_modules(__path__), key=lambda item: item.name):
        effect: Effect = import_module(f"{__name__}.{module.name}").EFFECT
        if effect.name != module.name or effect.name in effects:
            raise ValueError(
                f"expected one effect per file, named after it, found {effect.name!r} in effects/{module.name}.py"
            )
        effects[effect.name] = effect
    return tuple(
        sorted(effects.values(), key=lambda effect: (effect.released is not None, effect.order, effect.name))
    )
