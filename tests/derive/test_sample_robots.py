"""Directions of a sample robot are read as those of a robot file: rounded ones are normalised, others refused."""

from __future__ import annotations

import copy

import numpy as np
import pytest

from pkmodes_derive import mechanisms
from pkmodes_derive.assembly import models
from pkmodes_derive.declaration_checks import check_declared
from pkmodes_derive.definition import DefinitionError
from pkmodes_derive.machine import Machine
from pkmodes_derive.sample_robot import normalised_sample, sampled_directions


def machine_with(scale: float) -> Machine:
    """A rotary delta whose third axis of rotation is longer or shorter in the sample robot."""
    machine = mechanisms.machine("rotary_delta")
    machine.sample = copy.deepcopy(dict(machine.sample))
    axis = machine.sample["axis"][2]  # type: ignore[index]
    axis[:] = [component * scale for component in axis]
    return machine


@pytest.mark.slow
def test_a_rounded_direction_is_normalised() -> None:
    expected = np.array(mechanisms.machine("rotary_delta").sample["axis"])
    for scale in (0.6, 1.0 + 1e-6, 1.9):
        machine = machine_with(scale)
        check_declared(machine)
        np.testing.assert_allclose(normalised_sample(machine)["axis"], expected, rtol=0, atol=3e-16)


def test_directions_within_rounding_are_kept_to_the_last_digit() -> None:
    for name in ("linear_delta", "rotary_delta", "hexaglide"):
        machine = mechanisms.machine(name)
        assert sampled_directions(machine)
        assert normalised_sample(machine) == machine.sample


@pytest.mark.parametrize(("scale", "length"), [(3.0, "3"), (0.0, "0"), (0.05, "0.05")])
def test_a_direction_of_another_length_is_refused(scale: float, length: str) -> None:
    with pytest.raises(DefinitionError) as error:
        check_declared(machine_with(scale))
    assert str(error.value) == (
        f"axis[2] is a direction: expected a unit vector, found one of length {length} (m.sample); "
        "divide it by its length; only rounded unit vectors are normalised"
    )


def test_the_description_has_the_normalised_sample() -> None:
    described = models.describe(machine_with(1.9), 3, None)  # type: ignore[arg-type]
    np.testing.assert_allclose(np.linalg.norm(described.sample["axis"], axis=1), 1.0, rtol=1e-15)


def test_a_declared_unit_vector_is_one() -> None:
    machine = mechanisms.machine("rotary_delta")
    origin = next(field for field in machine.tables.fields if field.name == "origin")
    machine.unit_vector(origin.symbols[3:6])
    with pytest.raises(DefinitionError) as error:
        check_declared(machine)
    length = np.linalg.norm(machine.sample["origin"][1])  # type: ignore[index]
    assert f"is no unit vector: its length in m.sample is {length:g} (m.unit_vector)" in str(error.value)


@pytest.mark.parametrize("name", mechanisms.names())
def test_the_supplied_mechanisms_pass_the_checks(name: str) -> None:
    check_declared(mechanisms.machine(name))
