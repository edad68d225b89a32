"""Units as measuring systems write them, as text that pint can parse.

A file that states no units is in SI.  Dataset 164 of a universal file gives the number of its units of length and
force in one of SI (https://www.ceas3.uc.edu/sdrluff/files/164.asc: "to convert from universal file units to SI
divide by the appropriate factor"); the units of its functions then follow from their data types.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from decimal import Decimal

from pkmodes.core.robot.columns import frequency_factor
from pkmodes.core.robot.units import QuantityError, base_units

#: Labels of measuring systems that are not units.
NO_UNIT = frozenset({"", "none", "unknown", "eu", "-"})
#: Standard gravity, which files call g; no signal is a mass.
GRAVITY = re.compile(r"(?<![A-Za-z0-9_])(?:[gG]n?|g's)(?![A-Za-z0-9_])")
FORCES = r"N\*m|N|mN|kN|lbf|kgf|poundal|dyn"
#: Labels of a quotient, by numerator and denominator: a motion over a force, the inverse, a motion over another.
QUOTIENTS = (
    re.compile(rf"\(?1/(?P<below>{FORCES})\)?\*?\(?(?P<above>[^()]+)\)?"),
    re.compile(rf"\(?(?P<above>[^()]+?)\)?/\(?(?P<below>{FORCES})\)?"),
    re.compile(rf"\(?(?P<above>{FORCES})\)?/\(?(?P<below>[^()]+)\)?"),
    re.compile(r"\((?P<above>[^()]+)\)/\((?P<below>[^()]+)\)"),
    re.compile(r"(?P<above>[gG]n?)/(?P<below>[gG]n?)"),
)
LENGTHS = {1.0: "m", 1e3: "mm", 1e2: "cm", 1 / 0.3048: "ft", 1 / 0.0254: "inch"}
FORCES_BY_FACTOR = {
    1.0: "N",
    1e3: "mN",
    1e2: "cN",
    1 / 4.4482216152605: "lbf",
    1 / 9.80665: "kgf",
    1 / 0.138254954376: "poundal",
}


@dataclass(frozen=True)
class FileUnits:
    """Units of length and force of a universal file; None if they have no known name."""

    length: str | None = "m"
    force: str | None = "N"
    stated: bool = False

    @staticmethod
    def from_factors(length: float, force: float) -> FileUnits:
        """Return the units from their numbers in one metre and one newton."""
        return FileUnits(_name_of_factor(length, LENGTHS), _name_of_factor(force, FORCES_BY_FACTOR), True)

    def unit_of(self, data_type: int, rotation: bool) -> str | None:
        """Return the unit of a quantity without a label, by its specific data type in datasets 55 and 58."""
        length = "rad" if rotation else self.length
        if data_type in (9, 13):
            force = f"{self.force}*{self.length}" if rotation and self.length else self.force
            return None if self.force is None or (rotation and not self.length) else force
        derivative = {8: "", 11: "/s", 12: "/s^2"}.get(data_type)
        return None if derivative is None or length is None else f"{length}{derivative}"


def unit_text(label: str) -> str | None:
    """Return the unit in a label, such as ``m/s^2`` for ``m/s2``; None if it states no known unit."""
    text = label.strip().strip("[]").strip()
    if text.lower() in NO_UNIT:
        return None
    text = text.replace("**", "^").replace("²", "^2").replace("³", "^3").replace("·", "*")
    text = re.sub(r"(?<![A-Za-z])sec(?![A-Za-z])", "s", text)
    text = re.sub(r"(?<=[A-Za-z])(-?[1-4])(?![0-9])", r"^\1", text)
    text = GRAVITY.sub("g0", text)
    try:  # standard gravity by another name, since names of units here have no digits
        base_units(re.sub(r"\bg0\b", "m", text))
    except QuantityError:
        return None
    return text


def quotient_units(label: str) -> tuple[str | None, str | None]:
    """Return the units of numerator and denominator from the label of a frequency response.

    ``(m/s^2)/N`` and ``(1/N)*(m/s^2)`` have both, ``m/s^2`` only the first.
    """
    text = label.strip().strip("[]").replace(" ", "")
    for pattern in QUOTIENTS:
        if (match := pattern.fullmatch(text)) is not None:
            return unit_text(match["above"]), unit_text(match["below"])
    return unit_text(label), None


def seconds_in(label: str) -> float | None:
    """Return the factor from a unit of time to s; None if it is not one."""
    return _factor_to("second", label)


def radians_in(label: str) -> float | None:
    """Return the factor from a unit of angle to rad; None if it is not one."""
    return _factor_to("radian", label)


def hertz_in(label: str) -> float | None:
    """Return the factor from a unit of frequency to Hz; None if it is not one."""
    try:
        return float(frequency_factor(unit_text(label) or ""))
    except QuantityError:
        return None


def _factor_to(unit: str, label: str) -> float | None:
    """Return the factor from the unit in a label to a base unit; None if it is of another kind."""
    try:
        factor, powers = base_units(unit_text(label) or "")
    except QuantityError:
        return None
    return float(factor) if {name: Decimal(str(p)) for name, p in powers.items()} == {unit: 1} else None


def _name_of_factor(factor: float, names_by_factor: Mapping[float, str]) -> str | None:
    return next(
        (
            name
            for candidate, name in names_by_factor.items()
            if math.isclose(factor, candidate, rel_tol=1e-4)
        ),
        None,
    )
