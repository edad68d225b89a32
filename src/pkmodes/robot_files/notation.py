"""The notation of a quantity in a robot file, so that a corrected value is written in the same way."""

from __future__ import annotations

import re
from dataclasses import dataclass

from tomlkit.items import String

from pkmodes.core.robot.units import NUMBER, QuantityError, dimension_of, parse

SIGMA_DIGITS = 3


@dataclass(frozen=True)
class Notation:
    """A notation for values of one dimension.

    Attributes
    ----------
    scale : float
        The written unit in SI units.
    before, after : str
        Text around the number: quotes and the unit.
    """

    scale: float = 1.0
    before: str = ""
    after: str = ""

    @classmethod
    def of(cls, item: object, unit: str) -> Notation:
        """Return the notation of a value of a TOML document whose SI unit is `unit`."""
        if not isinstance(item, String) or (match := NUMBER.fullmatch(item)) is None:
            return cls()  # a bare number
        dimension = dimension_of(unit)
        try:
            scale = parse(f"1 {match[2]}", dimension) if match[2] else 1.0
        except QuantityError:  # one unit alone is out of range
            return cls.si(unit)
        quote = "'" if item.as_string().startswith("'") else '"'
        return cls(scale, quote, re.sub(r"[\r\n]+", " ", item[match.end(1) :]) + quote)

    @classmethod
    def si(cls, unit: str) -> Notation:
        """Return the notation for a value that is new in the document."""
        return cls() if unit == "1" else cls(1.0, '"', f' {unit.replace(" ", "*")}"')

    def number(self, value: float, digits: int) -> str:
        """Format a value as TOML."""
        return f"{self.before}{value / self.scale + 0.0:.{digits}g}{self.after}"  # + 0.0: no minus zero

    def sigma(self, value: float) -> str:
        """Format an absolute standard deviation as TOML; a percentage would be read as relative."""
        notation = Notation() if "%" in self.after else self
        return notation.number(value, SIGMA_DIGITS)

    def quantity(self, value: float, sigma: float | None, digits: int) -> str:
        """Format a value as TOML, with its standard deviation if it has one."""
        number = self.number(value, digits)
        return number if sigma is None else f"{{ value = {number}, sigma = {self.sigma(sigma)} }}"
