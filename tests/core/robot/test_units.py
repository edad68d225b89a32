"""Quantities with units: exact decimal conversion, and errors that say what was expected and found."""

from __future__ import annotations

import math
import os
import re
import subprocess
import sys
from decimal import Decimal
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from pkmodes.core.robot import units
from pkmodes.core.robot.units import DIMENSIONS, QuantityError, parse

ROOT = Path(__file__).parents[3]
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
    ("0.05 kHz", "frequency", 50.0),
    ("100 rad/s", "frequency", 15.915494309189533577),
    ("600 rpm", "frequency", 10.0),
    ("90 deg/s", "frequency", 0.25),
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
    ("10 N*m", "specific stiffness", "which is a torque"),
    ("10 Nm", "specific stiffness", 'unit "Nm" is N*m, a torque'),
    ("10 mm", "number", "does not belong there"),
    ("1 m + 1 m", "length", "is not a unit"),
    ("2 m^99999999", "length", "is not a unit"),
    ("1 mm*10**10**10", "length", "is not a unit"),
    ("1 __import__('os')", "length", "is not a unit"),
    ("4,5 mm", "length", "which has a decimal comma"),
    ("4.5,6,7 mm", "length", "is not a unit"),
    ("1 " + "m" * 55, "length", "is unknown"),
    ("1 kgm/Nmm/kgm/Nmm/ozin", "length", "whose unit"),
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


#: What people write, with what it is to be written as: the SI brochure and the catalogues of motors and gears are the
#: source of the values in the tests below, not pint.
WRITTEN_OTHERWISE = [
    ("300 gr", "mass", 'write "300 g"'),
    ("300 grains", "mass", 'write "300 g"'),
    ("0.3 kgr", "mass", 'write "0.3 kg"'),
    ("300 Gr", "mass", 'write "300 g"'),
    ("300 gm", "mass", 'write "300 g"'),
    ("1.5 Kg", "mass", 'write "1.5 kg"'),
    ("1.5 KG", "mass", 'write "1.5 kg"'),
    ("2 tons", "mass", 'write "2 t"'),
    ("2 mt", "mass", 'write "2 t"'),
    ("9 gr/m", "linear density", 'write "9 g/m"'),
    ("0.4 mt", "length", 'write "0.4 m"'),
    ("400 MM", "length", 'write "400 mm"'),
    ("400 Mm", "length", 'write "400 mm"'),
    ("400 mm.", "length", 'write "400 mm"'),
    ("12 mil", "length", 'write "12 thou"'),
    ("30 grad", "angle", 'write "30 deg"'),
    ("30 Deg", "angle", 'write "30 deg"'),
    ("500 Nm", "torsional stiffness", 'write "500 N*m"'),
    ("500 Nm/rad", "torsional stiffness", 'write "500 N*m/rad"'),
    ("500 N.m/rad", "torsional stiffness", 'write "500 N*m/rad"'),
    ("5 kNm/rad", "torsional stiffness", 'write "5 kN*m/rad"'),
    ("5 Nmm/arcmin", "torsional stiffness", 'write "5 N*mm/arcmin"'),
    ("1e-4 rad/Nm", "torsional compliance", 'write "1e-4 rad/(N*m)"'),
    ("1e-4 rad/N*m", "torsional compliance", 'write "1e-4 rad/(N*m)"'),
    ("20 Ns/m", "viscous friction", 'write "20 N*s/m"'),
    ("20 N/m/s", "viscous friction", 'write "20 N/(m/s)"'),
    ("1e-3 Nms/rad", "torsional viscous friction", 'write "1e-3 N*m*s/rad"'),
    ("54 gcm2", "moment of inertia", 'write "54 g*cm^2"'),
    ("1e-5 kgm^2", "moment of inertia", 'write "1e-5 kg*m^2"'),
    ("1e-5 kg-m²", "moment of inertia", 'write "1e-5 kg*m^2"'),
    ("1 N/M", "stiffness", 'write "1 N/m"'),
    ("1 N/Mm", "stiffness", 'write "1 N/mm"'),
    ("1 kg/mm", "stiffness", 'write "1 kgf/mm"'),
    ("1 N·mm⁻¹", "stiffness", 'write "1 N*mm^-1"'),
    ("5 kg", "force", 'write "5 kgf"'),
    ("9.81 m/s2", "acceleration", 'write "9.81 m/s^2"'),
    ("-1 g", "acceleration", 'write "-1 gravity"'),
    ("2 percent", "number", 'write "2 %"'),
    ("10:1", "number", 'write "10"'),
    ("60 S", "time", 'write "60 s"'),
    ("1,5 kg", "mass", 'write "1.5 kg"'),
    ("-0,5e-3 m", "length", 'write "-0.5e-3 m"'),
    ("0,25 kg", "mass", 'write "0.25 kg"'),
    ("0,125 kg", "mass", 'write "0.125 kg"'),
    ("2,5 %", "number", 'write "2.5 %"'),
    ("1.234,5 mm", "length", 'write "1234.5 mm"'),
    ("1,234.5 mm", "length", 'write "1234.5 mm"'),
    ("1,234 mm", "length", 'write "1.234 mm" or "1234 mm"'),
    ("1.234.567 um", "length", 'write "1234567 um"'),
    ("1 234,5 mm", "length", 'write "1234.5 mm"'),
    ("1'234.5 mm", "length", 'write "1234.5 mm"'),
    ("1\u00a0234 mm", "length", 'write "1234 mm"'),
    ("\u22129.81 m/s^2", "acceleration", 'write "-9.81 m/s^2"'),
    ("1,5 Kg", "mass", 'write "1.5 kg"'),
    ("1,5", "mass", "write the number as 1.5, with a unit of a mass"),
]


def test_what_people_write_otherwise_is_answered_with_what_to_write(subtests: pytest.Subtests) -> None:
    for text, dimension, remedy in WRITTEN_OTHERWISE:
        with subtests.test(text=text):
            with pytest.raises(QuantityError) as error:
                parse(text, dimension)
            assert error.value.remedy == remedy
            for answer in re.findall(r'"(.*?)"', remedy):
                assert math.isfinite(parse(answer, dimension))


@pytest.mark.parametrize(
    ("text", "dimension", "value"),
    [
        ("300 g", "mass", 0.3),
        ("2 t", "mass", 2000.0),
        ("500 N*m/rad", "torsional stiffness", 500.0),
        ("5 N*mm/arcmin", "torsional stiffness", 5e-3 * 10800 / math.pi),
        ("1e-4 rad/(N*m)", "torsional compliance", 1e-4),
        ("20 N/(m/s)", "viscous friction", 20.0),
        ("54 g*cm^2", "moment of inertia", 54e-7),
        ("1 kgf/mm", "stiffness", 9806.65),
        ("-1 gravity", "acceleration", -9.80665),
        ("12 thou", "length", 12 * 25.4e-6),
    ],
)
def test_the_answers_have_the_values_that_were_meant(text: str, dimension: str, value: float) -> None:
    assert parse(text, dimension) == pytest.approx(value, rel=1e-15)


@given(st.decimals(min_value=-1000, max_value=1000, places=4), st.sampled_from(["'", " ", ".", "\u202f"]))
def test_a_number_in_another_notation_is_answered_with_itself(number: Decimal, groups: str) -> None:
    there = f"{number:,}".replace(",", "@").replace(".", ",").replace("@", groups)
    with pytest.raises(QuantityError) as error:
        parse(f"{there} mm", "length")
    (answer,) = re.findall(r'"(.*?)"', error.value.remedy)
    assert parse(answer, "length") == float(number.scaleb(-3))


@given(st.floats(min_value=1e-9, max_value=1e9), st.sampled_from(["length", "mass", "specific stiffness"]))
def test_si_units_are_read_back_to_the_last_digit(value: float, dimension: str) -> None:
    assert parse(f"{value!r} {DIMENSIONS[dimension][0]}", dimension) == value


@given(st.text(max_size=80), st.sampled_from(sorted(DIMENSIONS)))
def test_any_text_is_a_finite_number_or_a_clear_error(text: str, dimension: str) -> None:
    try:
        assert math.isfinite(parse(text, dimension))
    except QuantityError as error:
        assert str(error).startswith(("expected a ", "expected an "))


@given(
    st.sampled_from(
        [(si_unit, unit) for si_unit, factors in units.COMMON_FACTORS.items() for unit in factors]
    ),
    st.decimals(-100_000, 100_000, places=6),
)
def test_common_units_have_the_same_bits_as_by_pint(names: tuple[str, str], number: Decimal) -> None:
    si_unit, unit = names
    found = units._convert(number, unit, si_unit)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(units, "COMMON_FACTORS", {})
        assert found == units._convert(number, unit, si_unit)


def test_the_first_frequency_of_a_process_needs_no_pint() -> None:
    code = "import sys, pkmodes; model = pkmodes.load('robots/linear-delta-2022.toml')"
    code += "; model.frequencies([0.6, 0.0, -0.245]); print('pint' in sys.modules)"
    path = os.pathsep.join(str(ROOT / part) for part in ("src", "generated"))
    run = subprocess.run(
        [sys.executable, "-c", code],
        env={**os.environ, "PYTHONPATH": path},
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=True,
    )
    assert run.stdout == "False\n"
