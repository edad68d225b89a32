"""Settings: combinations of values of parameters at which a machine is used, such as its payloads."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import product
from math import prod
from typing import Any

import numpy as np

from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.model import Model
from pkmodes.core.robot.declaration import changeable_units
from pkmodes.core.support.axes import swept_values

#: Maximum number of settings: each needs its own shaper design.
MAX_SETTINGS = 200


@dataclass(frozen=True)
class Setting:
    """Values of parameters at which a machine is used, such as a payload.

    Attributes
    ----------
    values : mapping of str to float
        Values in SI units, keyed by parameter path.
    units : mapping of str to str
        SI units by path.
    """

    values: Mapping[str, float]
    units: Mapping[str, str]

    def __str__(self) -> str:
        return ", ".join(f"{path} {self.value_text(path)}" for path in self.values)

    def value_text(self, path: str) -> str:
        """Return a value with its unit."""
        return append_unit(f"{self.values[path]:.4g}", self.units[path])


def append_unit(text: str, unit: str) -> str:
    """Return numbers with an SI unit; ratios have none."""
    return text if unit == "1" else f"{text} {unit}"


def setting_combinations(model: Model, swept: Mapping[str, Any]) -> tuple[Setting, ...]:
    """Return all combinations; values ascend, and the last parameter varies fastest.

    Raises PkmodesError if `swept` does not map paths to values, or there are too many combinations.
    """
    values = {path: np.sort(axis) for path, axis in swept_values(swept, "settings").items()}
    count = prod(map(len, values.values()))
    if count > MAX_SETTINGS:
        problem = f"expected at most {MAX_SETTINGS} settings, found {count:,}"
        raise PkmodesError(problem, "settings", "give fewer values: shapers differ little between neighbours")
    units = changeable_units(model.robot)
    return tuple(
        Setting(
            dict(zip(values, map(float, combination), strict=True)),
            {path: units.get(path, "") for path in values},
        )
        for combination in product(*values.values())
    )
