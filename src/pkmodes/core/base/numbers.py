"""Numbers as people read them: values with their standard deviations, and p-values.

A standard deviation has two significant digits, and its value is rounded to the same place: digits below that mean
nothing, and a single digit would round 0.15 to 0.2 (JCGM 100:2008, 7.2.6).  A value whose fit is surer than its
standard deviation, which includes what was not observed, keeps the digits of the fit.  Both have the same power of
ten, which is left out between 0.01 and 10,000, and where all their digits can be read without it.  Programs read the
exact numbers in the JSON.

The text is ASCII, ``(1.92 +- 0.13)e-4``; `pkmodes.pages.plots.labels.typeset` sets it as in print.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from decimal import Decimal

#: Exponents of numbers that are written without a power of ten, unless too many of their zeros are not significant.
PLAIN = range(-3, 6)
#: Exponents of numbers that are always written without one: 2100, not 2.1e3.
ALWAYS_PLAIN = range(-2, 4)
#: Maximum number of zeros that are not significant, outside `ALWAYS_PLAIN`.
MOST_ZEROS = 1
#: Most decimals: a float does not hold more digits, even if its standard deviation requires them.
MOST_DECIMALS = 12
#: Frequencies [Hz] below the first and from the second on are formatted differently from those between.
SMALL_FREQUENCY, LARGE_FREQUENCY = 0.01, 1e5
#: Largest factor that is stated: a larger one is only called more than this.
MOST_TIMES = 1_000_000
#: Smallest p-value that is stated: smaller ones depend on tails of distributions that nobody has checked.
LEAST_P = 1e-6


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


def hertz(value: float) -> str:
    """Return a frequency [Hz] as headlines and tables show it alike.

    With three decimals; with two digits below 0.01 Hz; with a power of ten from 100 kHz.
    """
    if 0.0 < abs(value) < SMALL_FREQUENCY:
        return f"{value:.2g}"
    if abs(value) < LARGE_FREQUENCY:
        return f"{value:.3f}"
    digits, _, power = f"{value:.2e}".partition("e")
    return f"{digits}e{int(power)}"


def rounded(value: float, sigma: float, fit: float | None = None) -> Rounded:
    """Round a value by its standard deviation, which has two significant digits.

    - value, sigma: a standard deviation that is 0, not finite, or below the digits of the value rounds nothing
    - fit: a smaller standard deviation, whose digits the value keeps
    """
    if not (math.isfinite(value) and math.isfinite(sigma) and sigma > 0.0):
        return Rounded(plain(value), plain(sigma, 2))
    of_sigma = _exponent(sigma, 2) - 1  # the place of its last digit
    place = min(of_sigma, _exponent(fit, 2) - 1) if fit is not None and 0.0 < fit < sigma else of_sigma
    exponent = max(_exponent(value, _digits(value, place)), of_sigma + 1)
    shift = _shift(exponent, place)
    if shift - place > MOST_DECIMALS:
        return Rounded(plain(value, MOST_DECIMALS), plain(sigma, 2))
    texts = (
        f"{round(_scaled(number, shift), shift - last):.{max(shift - last, 0)}f}"
        for number, last in ((value, place), (sigma, of_sigma))
    )
    digits, spread = (unsigned(text) for text in texts)
    return Rounded(digits, spread, shift)


def plain(value: float, digits: int = 6) -> str:
    """Return a number with at most some significant digits, and a power of ten where it needs one: ``2.42e6``."""
    if not math.isfinite(value) or not value:
        return f"{value + 0.0:g}"
    exponent = _exponent(value, digits)
    shift = _shift(exponent, exponent - digits + 1)
    decimals = digits - 1 - exponent + shift
    text = f"{round(_scaled(value, shift), decimals):.{max(decimals, 0)}f}"
    text = text.rstrip("0").rstrip(".") if "." in text else text
    return f"{text}e{shift}" if shift else text


def times(factor: float) -> str:
    """Return a factor with two significant digits and never a power of ten: ``2.3 times``, ``4,500 times``.

    Beyond a million it is only said that it is more.
    """
    if factor > MOST_TIMES:
        return f"more than {MOST_TIMES:,} times"
    digits = float(f"{factor:.2g}")
    return f"{digits:,.0f} times" if digits >= 10.0 else f"{digits:g} times"


def signed(value: float, digits: int = 2) -> str:
    """Return a number as `plain` does, with the sign of a positive one."""
    return f"{'+' if value >= 0.0 else ''}{plain(value, digits)}"


def p_in_words(p_value: float) -> str:
    """Return a p-value as text: ``p = 0.0024``, ``p < 1e-6``."""
    return f"p {p_text(p_value)}" if p_value < LEAST_P else f"p = {p_text(p_value)}"


def p_text(p_value: float) -> str:
    """Return a p-value without its name: ``0.0024``, ``< 1e-6``."""
    return f"< {plain(LEAST_P)}" if p_value < LEAST_P else plain(p_value, 2)


def _shift(exponent: int, place: int) -> int:
    """Return the power of ten to write, from a number's exponent and the place of its last digit; 0 for none."""
    if exponent in ALWAYS_PLAIN or (exponent in PLAIN and place <= MOST_ZEROS):
        return 0
    return exponent


def _exponent(value: float, digits: int) -> int:
    """Return the power of ten of a number rounded to some significant digits; a very small one for 0."""
    return int(f"{value:.{max(digits, 1) - 1}e}".partition("e")[2]) if value else -(10**6)


def _digits(value: float, place: int) -> int:
    """Return the number of significant digits of a value down to a decimal place."""
    return math.floor(math.log10(abs(value))) - place + 1 if value else 1


def _scaled(value: float, shift: int) -> float:
    """Return a value divided by a power of ten, which may itself be out of the range of floats."""
    return float(Decimal(repr(float(value))).scaleb(-shift))


def unsigned(text: str) -> str:
    """Return the text of a number without the sign of a zero."""
    digits = text.partition("e")[0]
    zero = "0" in digits and not any(c in "123456789" for c in digits)
    return text.lstrip("+-") if zero else text
