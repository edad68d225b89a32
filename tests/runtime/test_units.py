"""Quantities with units: exact decimal conversion, and errors that say what was expected and found."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from pkmodes.core.robot.units import DIMENSIONS, QuantityError, parse

CONVERSIONS = [
    ("400 mm", "length", 0.4),
    ("35 mm", "length", 0.035),
    ("0.017e-3 kg*m^2", "moment of inertia", 1.7e-05),
    ("130e-6 kg m²", "moment of inertia", 0.00013),
    ("1.3 kg cm**2", "moment of inertia", 0.00013),
    ("2.42e6 N/m", "specific stiffness", 2.42e6),
    ("2.42 kN/mm", "specific stiffness", 2.42e6),
    ("-9.81 m/s^2", "acceleration", -9.81),
    ("1500 g", "mass", 1.5),
    ("12 inch", "length", 0.3048),
    ("50 µm", "length", 5e-05),
    ("10", "number", 10.0),
    ("5 %", "number", 0.05),
    (".5m", "length", 0.5),
    ("-95 deg", "angle", math.radians(-95)),
    ("180 deg", "angle", math.pi),
    ("0.25 turn", "angle", math.pi / 2),
    ("10 mrad", "angle", 0.01),
    ("4000 N*m/rad", "torsional stiffness", 4000.0),
    ("1.5 kN", "force", 1500.0),
    ("2e-3 1/N", "reciprocal force", 0.002),
    ("2 1/kN", "reciprocal force", 0.002),
    ("+1.m", "length", 1.0),
]


def test_conversion_gives_the_nearest_double(subtests: pytest.Subtests) -> None:
    for text, dimension, value in CONVERSIONS:
        with subtests.test(text=text):
            assert parse(text, dimension) == value


WRONG = [
    ("400 kg", "length", "which is a mass"),
    ("400", "length", "which has no unit"),
    ("", "length", "does not begin with a number"),
    ("mm", "length", "does not begin with a number"),
    ("400 parsnip", "length", "is unknown"),
    ("nan m", "length", "does not begin with a number"),
    ("1e999 m", "length", "magnitude is not between"),
    ("1e99 km", "mass", "which is a length"),
    ("10 N*m", "specific stiffness", "which is a quantity of dimension"),
    ("10 mm", "number", "does not belong there"),
    ("1 m + 1 m", "length", "is not a unit"),
    ("2 m^99999999", "length", "is not a unit"),
    ("1 mm*10**10**10", "length", "is not a unit"),
    ("1 __import__('os')", "length", "is not a unit"),
    ("4,5 mm", "length", "is not a unit"),
    ("20 degC", "length", "which is a quantity of dimension"),
    ("1 " + "m" * 1000, "length", "longer than 60 characters"),
    ("35 mm*deg", "length", "does not belong there"),
    ("10 N*deg", "force", "does not belong there"),
    ("10 rad", "length", "which is an angle"),
    ("10 N", "length", "which is a force"),
    ("10 m", "angle", "which is a length"),
    ("5 %", "angle", "does not belong there"),
    ("10", "angle", "which has no unit"),
    ("10 deg", "number", "does not belong there"),
    ("10 ppm", "number", "does not belong there"),
    ("10 dB", "number", "unit"),
    ("2 % %", "number", "unit"),
    ("1e-99 m", "length", "magnitude is not between"),
]


def test_wrong_quantities_are_refused(subtests: pytest.Subtests) -> None:
    for text, dimension, found in WRONG:
        with subtests.test(text=text):
            with pytest.raises(QuantityError) as error:
                parse(text, dimension)
            assert str(error.value).startswith(
                (f"expected a {dimension} such", f"expected an {dimension} such")
            )
            assert found in str(error.value)
            assert len(str(error.value)) < 250


@given(st.floats(min_value=1e-9, max_value=1e9), st.sampled_from(["length", "mass", "specific stiffness"]))
def test_si_units_are_read_back_to_the_last_digit(value: float, dimension: str) -> None:
    assert parse(f"{value!r} {DIMENSIONS[dimension][0]}", dimension) == value


@given(st.text(max_size=80), st.sampled_from(sorted(DIMENSIONS)))
def test_any_text_is_a_finite_number_or_a_clear_error(text: str, dimension: str) -> None:
    try:
        assert math.isfinite(parse(text, dimension))
    except QuantityError as error:
        assert str(error).startswith(("expected a ", "expected an "))
