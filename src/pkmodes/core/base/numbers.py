"""Numbers as people read them: values with their standard deviations, and p-values.

A standard deviation has two significant digits, and its value is rounded to the same place: digits below that mean
nothing, and a single digit would round 0.15 to 0.2 (JCGM 100:2008, 7.2.6).  If the fit alone has a smaller standard
deviation (the full one also covers what was not observed), the value keeps the digits of the fit.  Both have the
same power of ten, which is left out between 0.01 and 10,000, and where all their digits can be read without it.
Programs read the exact numbers in the JSON.

The text is ASCII, ``(1.92 +- 0.13)e-4``; `pkmodes.pages.plots.labels.typeset` sets it as in print.
"""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import dataclass
from decimal import Decimal

#: Exponents of numbers that are written without a power of ten, unless too many of their zeros are not significant.
PLAIN_EXPONENTS = range(-3, 6)
#: Exponents of numbers that are always written without one: 2100, not 2.1e3.
ALWAYS_PLAIN_EXPONENTS = range(-2, 4)
#: Maximum number of zeros that are not significant, outside `ALWAYS_PLAIN_EXPONENTS`.
MAX_INSIGNIFICANT_ZEROS = 1
#: Maximum number of decimals: a float does not hold more digits, even if its standard deviation requires them.
MAX_DECIMALS = 12
#: Frequencies [Hz] below the first and from the second on are formatted differently from those between.
SMALL_FREQUENCY, LARGE_FREQUENCY = 0.01, 1e5
#: Largest factor that is stated: a larger one is reported as more than this.
MAX_FACTOR = 1_000_000
#: Smallest p-value that is stated: smaller ones depend on tails of distributions that nobody has checked.
MIN_P_VALUE = 1e-6


@dataclass(frozen=True)
class Rounded:
    """A value and its standard deviation, rounded to the same place.

    - value, sigma: their digits
    - exponent: power of ten by which both are multiplied; 0 for none
    """

    value: str
    sigma: str
    exponent: int = 0

    @property
    def power(self) -> str:
        """The power of ten after the digits, such as ``e-4``; empty for none."""
        return f"e{self.exponent}" if self.exponent else ""

    @property
    def columns(self) -> tuple[str, str]:
        """The value and its standard deviation by themselves, for columns of a table."""
        return self.value + self.power, self.sigma + self.power

    def __str__(self) -> str:
        text = f"{self.value} +- {self.sigma}"
        return f"({text}){self.power}" if self.exponent else text


def number_or_none(number: float) -> float | None:
    """Return a number as JSON has it: None for NaN."""
    return float(number) if math.isfinite(number) else None


def format_frequency(value: float) -> str:
    """Return a frequency [Hz] as text, the same in headlines and tables.

    With three decimals; with two digits below 0.01 Hz; with a power of ten from 100 kHz.
    """
    if 0.0 < abs(value) < SMALL_FREQUENCY:
        return f"{value:.2g}"
    if abs(value) < LARGE_FREQUENCY:
        return f"{value:.3f}"
    digits, _, power = f"{value:.2e}".partition("e")
    return f"{digits}e{int(power)}"


def round_to_sigma(value: float, sigma: float, fit: float | None = None) -> Rounded:
    """Round a value by its standard deviation, which has two significant digits.

    - value, sigma: a standard deviation that is 0, not finite, or below the digits of the value rounds nothing
    - fit: a smaller standard deviation, whose digits the value keeps
    """
    if not (math.isfinite(value) and math.isfinite(sigma) and sigma > 0.0):
        return Rounded(plain(value), plain(sigma, 2))
    sigma_last_place = _exponent(sigma, 2) - 1  # the place of its last digit
    last_place = (
        min(sigma_last_place, _exponent(fit, 2) - 1)
        if fit is not None and 0.0 < fit < sigma
        else sigma_last_place
    )
    value_digits = math.floor(math.log10(abs(value))) - last_place + 1 if value else 1
    exponent = max(_exponent(value, value_digits), sigma_last_place + 1)
    power = _power_to_write(exponent, last_place)
    if power - last_place > MAX_DECIMALS:
        return Rounded(plain(value, MAX_DECIMALS), plain(sigma, 2))
    texts = (
        f"{round(_scaled(number, power), power - place):.{max(power - place, 0)}f}"
        for number, place in ((value, last_place), (sigma, sigma_last_place))
    )
    digits, sigma_digits = (without_zero_sign(text) for text in texts)
    return Rounded(digits, sigma_digits, power)


def range_text(values: Collection[float], form: str) -> str:
    """Return from where to where values go, such as "3 to 5"; a single number if both ends read alike.

    - form: format of each end
    """
    return " to ".join(dict.fromkeys(format(end + 0.0, form) for end in (min(values), max(values))))


def plain(value: float, digits: int = 6) -> str:
    """Return a number with at most some significant digits, and a power of ten where it needs one: ``2.42e6``."""
    if not math.isfinite(value) or not value:
        return f"{value + 0.0:g}"
    exponent = _exponent(value, digits)
    power = _power_to_write(exponent, exponent - digits + 1)
    decimals = digits - 1 - exponent + power
    text = f"{round(_scaled(value, power), decimals):.{max(decimals, 0)}f}"
    text = text.rstrip("0").rstrip(".") if "." in text else text
    return f"{text}e{power}" if power else text


def three_digits(value: float) -> str:
    """Return a number with three significant digits, zeros among them, or to the nearest unit: 5.30, 23615."""
    return f"{value:{'#.3g' if 0.0 < abs(value) < 99.95 else '.0f'}}"


def format_factor(factor: float) -> str:
    """Return a factor with two significant digits and never a power of ten: ``2.3 times``, ``4,500 times``.

    Beyond a million: ``more than 1,000,000 times``.
    """
    if factor > MAX_FACTOR:
        return f"more than {MAX_FACTOR:,} times"
    digits = float(f"{factor:.2g}")
    return f"{digits:,.0f} times" if digits >= 10.0 else f"{digits:g} times"


def format_signed(value: float, digits: int = 2) -> str:
    """Return a number as `plain` does, with the sign of a positive one."""
    return f"{'+' if value >= 0.0 else ''}{plain(value, digits)}"


def p_in_words(p_value: float) -> str:
    """Return a p-value as text: ``p = 0.0024``, ``p < 1e-6``."""
    return f"p {p_text(p_value)}" if p_value < MIN_P_VALUE else f"p = {p_text(p_value)}"


def p_text(p_value: float) -> str:
    """Return a p-value without its name: ``0.0024``, ``< 1e-6``."""
    return f"< {plain(MIN_P_VALUE)}" if p_value < MIN_P_VALUE else plain(p_value, 2)


def _power_to_write(exponent: int, last_place: int) -> int:
    """Return the power of ten to write, from a number's exponent and the place of its last digit; 0 for none."""
    if exponent in ALWAYS_PLAIN_EXPONENTS or (
        exponent in PLAIN_EXPONENTS and last_place <= MAX_INSIGNIFICANT_ZEROS
    ):
        return 0
    return exponent


def _exponent(value: float, digits: int) -> int:
    """Return the power of ten of a number rounded to some significant digits; a very small one for 0."""
    return int(f"{value:.{max(digits, 1) - 1}e}".partition("e")[2]) if value else -(10**6)


def _scaled(value: float, power: int) -> float:
    """Return a value divided by a power of ten, which may itself be out of the range of floats."""
    return float(Decimal(repr(float(value))).scaleb(-power))


def without_zero_sign(text: str) -> str:
    """Return the text of a number without the sign of a zero."""
    digits = text.partition("e")[0]
    is_zero = "0" in digits and not any(c in "123456789" for c in digits)
    return text.lstrip("+-") if is_zero else text
