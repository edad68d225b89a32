"""Numbers as people read them: a standard deviation has two digits, and its value ends at the same place."""

from __future__ import annotations

import re
from decimal import Decimal
from pathlib import Path

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

import pkmodes
from pkmodes.core.base.numbers import (
    format_factor,
    format_frequency,
    format_signed,
    p_in_words,
    plain,
    round_to_sigma,
)
from pkmodes.pages.plots.labels import typeset

#: What a rounded number with its standard deviation looks like.
FORM = re.compile(r"\((-?\d+(?:\.\d+)?) \+- (\d+(?:\.\d+)?)\)e(-?\d+)|(-?\d+(?:\.\d+)?) \+- (\d+(?:\.\d+)?)")
SIZES = st.floats(1e-30, 1e30)
#: Values with at most ten digits above the last one of the standard deviation.
RATIOS = st.floats(-1e8, 1e8)


def parts(text: str) -> tuple[str, str, int]:
    found = FORM.fullmatch(text)
    assert found, text
    value, sigma, power, own, its = found.groups()
    return (value, sigma, int(power)) if power else (own, its, 0)


@given(sigma=SIZES, ratio=RATIOS)
@example(sigma=0.0996, ratio=100.0)
@example(sigma=99.7, ratio=10.0)
@example(sigma=0.013, ratio=0.0)
@example(sigma=4.0, ratio=-1e-10)
def test_both_end_at_the_second_digit_of_the_standard_deviation(sigma: float, ratio: float) -> None:
    value = sigma * ratio
    digits, spread, power = parts(str(round_to_sigma(value, sigma)))
    exact, of_sigma = Decimal(value).scaleb(-power), Decimal(sigma).scaleb(-power)
    seen, its = Decimal(digits), Decimal(spread)
    assert abs(its - of_sigma) <= Decimal("0.0501") * of_sigma  # two digits: at most half of one in ten
    significant = spread.replace(".", "").lstrip("0")
    assert len(significant) == 2 or (
        len(significant) == 3 and significant.endswith("0") and "." not in spread
    )
    unit = Decimal(1).scaleb(its.adjusted() - 1)
    assert abs(seen - exact) <= Decimal("0.5000001") * unit
    assert seen % unit == 0
    assert seen.as_tuple().exponent == its.as_tuple().exponent
    assert digits.lstrip("-0.") or not digits.startswith("-")  # no minus zero
    if not power:
        assert len(digits.lstrip("-").partition(".")[0]) <= 6


@pytest.mark.parametrize(
    ("value", "sigma", "text", "print_"),
    [
        (1.9234e-4, 1.31e-5, "(1.92 +- 0.13)e-4", "(1.92 \u00b1 0.13)\u2009\u00d7\u200910\u207b\u2074"),
        (1.4969, 0.0132, "1.497 +- 0.013", "1.497 \u00b1 0.013"),
        (1.27396e6, 3.8e4, "(1.274 +- 0.038)e6", "(1.274 \u00b1 0.038)\u2009\u00d7\u200910\u2076"),
        (732.0, 214.0, "730 +- 210", "730 \u00b1 210"),
        (20900.0, 3400.0, "(2.09 +- 0.34)e4", "(2.09 \u00b1 0.34)\u2009\u00d7\u200910\u2074"),
        (-0.0512, 0.3, "-0.05 +- 0.30", "\u22120.05 \u00b1 0.30"),
        (0.0, 0.01, "0.000 +- 0.010", "0.000 \u00b1 0.010"),
        (5.0, 0.0, "5 +- 0", "5 \u00b1 0"),
    ],
)
def test_as_it_is_printed(value: float, sigma: float, text: str, print_: str) -> None:
    assert str(round_to_sigma(value, sigma)) == text
    assert typeset(text) == print_


@pytest.mark.parametrize(
    ("value", "sigma", "fit", "text"),
    [
        (-0.0811, 29.2, 0.098, "-0.081 +- 29"),  # never 0 +- 29
        (1.9234e-4, 8.3e-5, 1.31e-5, "(1.92 +- 0.83)e-4"),
        (21.99434, 0.1008, 0.0508, "21.994 +- 0.10"),
        (732.4, 214.0, 3.1, "732.4 +- 210"),
        (1.07021e-8, 2.3e-9, 1.437e-11, "(1.0702 +- 0.23)e-8"),
        (1.9234e-4, 1.31e-5, 8.3e-5, "(1.92 +- 0.13)e-4"),  # no larger one counts
    ],
)
def test_a_value_keeps_the_digits_of_its_fit(value: float, sigma: float, fit: float, text: str) -> None:
    assert str(round_to_sigma(value, sigma, fit)) == text


def test_columns_of_a_table_share_the_power_of_ten() -> None:
    assert round_to_sigma(1.9234e-4, 1.31e-5).columns == ("1.92e-4", "0.13e-4")
    assert round_to_sigma(29.97661, 0.0601).columns == ("29.977", "0.060")


@given(
    value=st.floats(allow_nan=False, allow_infinity=False, allow_subnormal=False), digits=st.integers(1, 12)
)
@example(value=-1.7976931348623157e308, digits=3)
def test_a_plain_number_is_right_to_its_digits_and_has_no_padding(value: float, digits: int) -> None:
    text = plain(value, digits)
    exact, seen = Decimal(value), Decimal(text)
    assert abs(seen - exact) <= Decimal("0.5000001") * Decimal(1).scaleb(exact.adjusted() - digits + 1)
    assert re.fullmatch(r"-?\d+(\.\d*[1-9])?(e-?[1-9]\d*)?", text)


def test_the_smallest_number_has_the_digits_that_it_has() -> None:
    assert plain(5e-324, 1) == plain(5e-324, 6) == "5e-324"


def test_infinities_keep_their_signs_and_zeros_have_none() -> None:
    assert [plain(value) for value in (float("inf"), float("-inf"), 0.0, -0.0)] == ["inf", "-inf", "0", "0"]
    assert str(round_to_sigma(float("-inf"), 1.0)) == "-inf +- 1"


def test_integers_and_large_values_are_readable() -> None:
    values = (15.0, 2.42e6, 1e6, 1.7e-5, 123456.0, 0.5, 730.4)
    assert [plain(value) for value in values[:-1]] == ["15", "2.42e6", "1e6", "1.7e-5", "123456", "0.5"]
    assert plain(values[-1], 2) == "730"
    assert plain(12345.0, 2) == "1.2e4"


@pytest.mark.parametrize(
    ("p", "text"),
    [
        (0.93, "p = 0.93"),
        (0.0024, "p = 0.0024"),
        (1.1e-6, "p = 1.1e-6"),
        (9e-7, "p < 1e-6"),
        (0.0, "p < 1e-6"),
    ],
)
def test_p_values_below_a_millionth_are_not_told_apart(p: float, text: str) -> None:
    assert p_in_words(p) == text


def test_frequencies_have_three_decimals_and_large_ones_a_power_of_ten() -> None:
    shown = {0.0: "0.000", 0.0042: "0.0042", 72.3514: "72.351", 99_999.9: "99999.900", 9041462019.1: "9.04e9"}
    assert {value: format_frequency(value) for value in shown} == shown
    assert format_frequency(-2e5) == "-2.00e5"


@pytest.mark.parametrize(
    ("factor", "words"),
    [
        (1.0 / 3.0, "0.33 times"),
        (2.345, "2.3 times"),
        (9.96, "10 times"),
        (99.6, "100 times"),
        (168.4, "170 times"),
        (4512.0, "4,500 times"),
        (987_654.0, "990,000 times"),
        (3e7, "more than 1,000,000 times"),
    ],
)
def test_a_factor_has_no_power_of_ten(factor: float, words: str) -> None:
    assert format_factor(factor) == words


def test_a_signed_number_has_its_sign() -> None:
    assert [format_signed(value) for value in (0.1234, 123.0, -123.0)] == ["+0.12", "+120", "-120"]


@pytest.mark.parametrize(
    ("value", "sigma", "text"),
    [
        (2100.4, 412.0, "2100 +- 410"),
        (9120.0, 3400.0, "9100 +- 3400"),
        (170.0, 2130.0, "200 +- 2100"),
        (0.0123, 0.0045, "0.0123 +- 0.0045"),
    ],
)
def test_numbers_between_a_hundredth_and_ten_thousand_have_no_power_of_ten(
    value: float, sigma: float, text: str
) -> None:
    assert str(round_to_sigma(value, sigma)) == text


@given(
    value=st.floats(0.01, 9_999.0, exclude_max=True),
    ratio=st.floats(1e-3, 1.0),
    digits=st.integers(1, 6),
)
@example(value=9_999.0, ratio=1.0, digits=4)
def test_no_number_in_that_range_has_one(value: float, ratio: float, digits: int) -> None:
    if float(f"{value:.{digits - 1}e}") < 1e4:
        assert "e" not in plain(value, digits)
    if value * ratio >= 0.01 and float(f"{value:.1e}") < 1e4:
        assert "e" not in str(round_to_sigma(value, value * ratio))


def test_no_text_rounds_a_number_to_a_power_of_ten() -> None:
    # ``f"{170.0:.2g}"`` is "1.7e+02"; what is compared or read again, and not written, is left out.
    folder = Path(pkmodes.__file__).parent
    rounding = re.compile(r"\{[^{}]*:\+?\.[1-3]g\}")
    lines = [
        (path.name, line.strip())
        for path in sorted(folder.rglob("*.py"))
        for line in path.read_text(encoding="utf-8").splitlines()
    ]
    assert len(lines) > 50_000
    assert [
        (name, line)
        for name, line in lines
        if rounding.search(line) and " == " not in line and "float(f" not in line and name != "numbers.py"
    ] == []
