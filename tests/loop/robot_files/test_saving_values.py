"""The corrected robot: values are changed in their own units and notation, and the rest of the file is unchanged."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from helpers.robots.corrected_files import changed_lines, correct, reread, with_joints
from helpers.robots.robot_text import edited, published
from pkmodes.loop.robot_files.saving import Correction


def test_only_the_line_of_the_value_changes(tmp_path: Path) -> None:
    after = correct(
        tmp_path, published(), platform__mass=Correction(1.4912345678901, 0.0123456, "was 1.5 kg: refitted")
    )
    assert changed_lines(published(), after) == (
        ['mass = "1.5 kg"                     # m_p, after equation 24\n'],
        [
            'mass = { value = "1.491234568 kg", sigma = "0.0124 kg" }                     '
            "# m_p, after equation 24; was 1.5 kg: refitted\n"
        ],
    )
    quantity = reread(tmp_path, after).quantities["platform.mass"]
    assert quantity.value == pytest.approx(1.4912345678901, rel=1e-9)
    assert quantity.sigma == 0.0124


def test_no_correction_changes_nothing(tmp_path: Path) -> None:
    for text in (
        published(),
        published().replace("\n", "\r\n"),
        "\ufeff" + published(),
        published().rstrip(),
    ):
        assert correct(tmp_path, text) == text


@pytest.mark.parametrize(
    ("path", "old", "value", "new"),
    [
        ("platform.mass", '"1.5 kg"', 1.25, '"1.25 kg"'),
        ("link.length", '"400 mm"', 0.40123, '"401.23 mm"'),
        ("link.mass", '"0.7 kg"', 0.0, '"0 kg"'),
        ("carriage.mass", '"1 kg"', 1.125, '"1.125 kg"'),
        ("carriage.length", '"0 mm"', 0.05, '"50 mm"'),
        ("belt.specific_stiffness", '"2.42e6 N/m"', 2.5e6, '"2500000 N/m"'),
        ("belt.width", '"15 mm"', 1 / 70, '"14.28571429 mm"'),
        ("pulley.radius", '"35 mm"', 0.0351, '"35.1 mm"'),
        ("pulley.inertia", '"130e-6 kg*m^2"', 1.3e-5, '"1.3e-05 kg*m^2"'),
        ("motor.inertia", '"0.017e-3 kg*m^2"', 2e-5, '"2e-05 kg*m^2"'),
        ("motor.gear_ratio", "gear_ratio = 10", 10.5, "gear_ratio = 10.5"),
        ("gravity.z", '"-9.81 m/s^2"', -9.80665, '"-9.80665 m/s^2"'),
        ("axis.1.limits.min", '["0 m", "1.2 m"]', -0.01, '["-0.01 m", "1.2 m"]'),
        ("axis.1.limits.max", '["0 m", "1.2 m"]', 1.3, '["0 m", "1.3 m"]'),
        ("axis.2.origin.y", '"-200 mm"', -0.201, '"-201 mm"'),
        ("axis.1.origin.x", '["0 mm", "0 mm", "0 mm"]', 0.001, '["1 mm", "0 mm", "0 mm"]'),
    ],
)
def test_every_kind_of_value_keeps_its_unit(
    tmp_path: Path, path: str, old: str, value: float, new: str
) -> None:
    after = correct(tmp_path, published(), **{path.replace(".", "__"): Correction(value)})
    assert after == edited(old, new)
    assert reread(tmp_path, after).quantities[path].value == pytest.approx(value, rel=1e-9)


@pytest.mark.parametrize(
    ("old", "value", "sigma", "new"),
    [
        ("0.4", 0.41, None, "0.41"),
        ("1", 0.5, None, "0.5"),
        ("0.4", 0.41, 0.002, "{ value = 0.41, sigma = 0.002 }"),
        ("'40 cm'", 0.41, 0.002, "{ value = '41 cm', sigma = '0.2 cm' }"),
        ('"""400mm"""', 0.41, None, '"410mm"'),
        ('" +400  mm "', 0.41, None, '"410  mm "'),
        ('"400e3 \u00b5m"', 0.41, None, '"410000 \u00b5m"'),
        ('{ value = "400 mm" }', 0.41, None, '{ value = "410 mm" }'),
        ('{ value = "400 mm" }', 0.41, 0.0, '{ value = "410 mm", sigma = "0 mm"}'),
        (
            '{value="400 mm",  sigma = "2 %"}',
            0.41,
            0.001234,
            '{value="410 mm",  sigma = "1.24 mm"}',
        ),
        ('{sigma = "0.2 cm", value = 0.4}', 0.41, 0.001, "{sigma = 0.001, value = 0.41}"),
        ('{ value = "400 mm", sigma = "1 cm" }', 0.41, None, '{ value = "410 mm", sigma = "1 cm" }'),
        # Below 10,000 a deviation has no power of ten.
        ('"400e3 \u00b5m"', 0.41, 0.00213, '{ value = "410000 \u00b5m", sigma = "2130 \u00b5m" }'),
        ('"400e3 \u00b5m"', 0.41, 0.0213, '{ value = "410000 \u00b5m", sigma = "2.13e+04 \u00b5m" }'),
        # A deviation of 2 % stays 8 mm when it is not corrected itself.
        ('{ value = "400 mm", sigma = "2 %" }', 0.41, None, '{ value = "410 mm", sigma = "8 mm" }'),
    ],
)
def test_a_value_keeps_its_notation(
    tmp_path: Path, old: str, value: float, sigma: float | None, new: str
) -> None:
    text = edited('"400 mm"', old)
    assert correct(tmp_path, text, link__length=Correction(value, sigma)) == edited('"400 mm"', new)


def test_a_percentage_gets_an_absolute_deviation(tmp_path: Path) -> None:
    text = published() + '\n[effects.axis_belt_stiffness]\nfactor_2 = "-5 %"\n'
    after = correct(tmp_path, text, effects__axis_belt_stiffness__factor_2=Correction(-0.04, 0.002))
    assert after.endswith("factor_2 = { value = -0.04, sigma = 0.002 }\n")
    assert reread(tmp_path, after).quantities["effects.axis_belt_stiffness.factor_2"].sigma == 0.002


def test_the_span_moves_both_ends_of_every_axis(tmp_path: Path) -> None:
    text = edited('limits = ["0 m", "1.2 m"]', 'limits = [{ value = "100 mm", sigma = 0 }, 1.2]')
    after = correct(tmp_path, text, axis__span=Correction(1.1014, 0.000412, "was 1.1 m"))
    assert changed_lines(text, after)[1] == [
        'limits = [{ value = "99.3 mm", sigma = 0 }, 1.2007]  # was 1.1 m; sigma of axis.span 0.000412 m\n',
        *2 * ['limits = ["-0.0007 m", "1.2007 m"]  # was 1.1 m; sigma of axis.span 0.000412 m\n'],
    ]
    limits = reread(tmp_path, after).parameters.limits
    np.testing.assert_allclose(limits[:, 1] - limits[:, 0], [1.1014, 1.2014, 1.2014], rtol=1e-10)
    again = correct(tmp_path, after, axis__span=Correction(1.1))
    np.testing.assert_allclose(
        reread(tmp_path, again).parameters.limits, [[0.1, 1.2], [0, 1.2], [0, 1.2]], atol=0
    )


def test_the_joint_radius_changes_along_the_joints(tmp_path: Path) -> None:
    text = with_joints()
    after = correct(tmp_path, text, axis__joint_radius=Correction(0.055, 0.001, "fitted"))
    assert changed_lines(text, after)[1] == [
        f"joint = {joint}  # fitted; sigma of axis.joint_radius 0.001 m\n"
        for joint in ('["33 mm", "44 mm", 0]', "[0.0, 0.065, 0]", '["-3.3 cm", "0 mm", "-4.4 cm"]')
    ]
    joint = reread(tmp_path, after).parameters.joint
    np.testing.assert_allclose(np.linalg.norm(joint, axis=1), [0.055, 0.065, 0.055], rtol=1e-11)


UNITS = {"m": 1.0, "mm": 1e-3, "inch": 0.0254, None: 1.0}


@settings(max_examples=40)
@given(st.floats(1e-6, 1e3), st.none() | st.floats(1e-9, 1e3), st.sampled_from(list(UNITS)))
def test_any_value_reads_back(tmp_path: Path, value: float, sigma: float | None, unit: str | None) -> None:
    text = edited('"400 mm"', "0.4" if unit is None else f'"{0.4 / UNITS[unit]} {unit}"')
    quantity = reread(tmp_path, correct(tmp_path, text, link__length=Correction(value, sigma))).quantities[
        "link.length"
    ]
    assert quantity.value == pytest.approx(value, rel=1e-9)
    # Rounded up to three digits, by no more than one in a hundred.
    assert (
        quantity.sigma is None if sigma is None else sigma * (1 - 1e-12) <= quantity.sigma <= 1.0101 * sigma
    )
