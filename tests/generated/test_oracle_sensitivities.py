"""Sensitivities of the rotary delta and the CoreXY at a fixed pose, against differences of the oracle in 60 digits.

With respect to every parameter that the generated module lists, with all effects and with none.  The arms follow a
change of geometry through the oracle's own closure, so their contribution is part of the test.
"""

from __future__ import annotations

import inspect
from functools import cache

import numpy as np
import pytest

from helpers.references.coordinate_blocks import kinds, worst
from helpers.references.high_precision_mechanisms import STEP, HighPrecision, exact_values, shifted
from helpers.robots.sample_mechanisms import NAMES, ORACLES, effects, extended, sample

#: A generated derivative has some hundred terms and needs one more solution than M and K with the matrix of the
#: loops, whose condition number is 7 to 11 here.  Relative to the largest entry of a block of coordinates.
#: Measured over two robots of each kind: at most 4.5e-15.
ROUNDING = 3e-14
SEED = 2
CHOICES = [(name, label) for name in NAMES for label in ("", "nothing")]


def listed(name: str) -> list[tuple]:
    generated = extended(name)
    return [*generated.VALUE_SENSITIVITIES, *generated.GEOMETRY_SENSITIVITIES]


@cache
def found(name: str, label: str) -> list[tuple[np.ndarray, np.ndarray]]:
    """Return the generated derivatives of M and K by every listed parameter, as whole matrices."""
    robot, generated, chosen = sample(name, SEED), extended(name), effects(name, (label,))
    by_value = generated.value_sensitivities(robot.pose, robot.parameters, chosen)
    known = {"p": robot.pose, "parameters": robot.parameters, "effects": chosen}
    taken = inspect.signature(generated.geometry_sensitivities).parameters  # without geometry, no effects
    by_geometry = generated.geometry_sensitivities(**{argument: known[argument] for argument in taken})
    result = []
    for entries, parameters in (
        (by_value, generated.VALUE_SENSITIVITIES),
        (by_geometry, generated.GEOMETRY_SENSITIVITIES),
    ):
        unread = [list(values) for values in entries]
        for _, _, *places in parameters:
            matrices = np.zeros((2, *[len(generated.COORDINATES)] * 2))
            for matrix, values, where in zip(matrices, unread, places, strict=True):
                assert all(row <= column for row, column in where)
                assert len(set(where)) == len(where)
                for row, column in where:
                    matrix[row, column] = matrix[column, row] = values.pop(0)
            result.append(tuple(matrices))
        assert unread == [[], []]
    return result


def matrices(it: HighPrecision) -> tuple[np.ndarray, np.ndarray]:
    return it.mass_matrix(), it.elastic_hessian() + it.gravity_hessian()


def expected(name: str, label: str, field: str, index: tuple[int, ...]) -> list[np.ndarray]:
    """Return central differences of the oracle, exact to some 20 digits."""
    robot = sample(name, SEED)
    values, active = (exact_values(group._asdict()) for group in (robot.parameters, effects(name, (label,))))
    sides = []
    for step in (STEP, -STEP):
        moved = [
            shifted(group, field, index, step) if field in group else group for group in (values, active)
        ]
        sides.append(matrices(ORACLES[name](*moved, robot.pose)))
    return [((ahead - behind) / (2 * STEP)).astype(float) for ahead, behind in zip(*sides, strict=True)]


@pytest.mark.parametrize(("name", "label"), CHOICES)
def test_every_number_of_the_parameters_is_listed_once(name: str, label: str) -> None:
    """All parameters except directions and branches, which are not fitted, joint compliances, and origins (below)."""
    robot, chosen = sample(name, SEED), effects(name, (label,))
    numbers = {(f, i) for f, v in robot.parameters._asdict().items() for i in np.ndindex(np.shape(v))}
    numbers |= {(field, ()) for field in chosen._fields}
    left = {f for f, _ in numbers - {tuple(entry[:2]) for entry in listed(name)}}
    assert (
        left
        == {
            "rotary_delta": {"origin", "axis", "zero", "branch"}
            | {"link_compliance_compliance", "frame_compliance_compliance"}
            | {f"frame_compliance_compliance_{i}" for i in "xyz"},
            "corexy": {"belt_path_direction"}
            | {f"{joint}_compliance_compliance" for joint in ("gearbox", "clamp", "frame")}
            | {"frame_compliance_compliance_x", "frame_compliance_compliance_y"}
            | {"gantry_racking_compliance"},
        }[name]
    )
    assert len(listed(name)) == len({tuple(entry[:2]) for entry in listed(name)})


@pytest.mark.parametrize(("name", "label"), CHOICES)
def test_derivatives_agree_with_differences_of_the_oracle(
    subtests: pytest.Subtests, name: str, label: str
) -> None:
    blocks = kinds(extended(name).COORDINATES)
    for (field, index, *_), derivatives in zip(listed(name), found(name, label), strict=True):
        with subtests.test((field, index)):
            for one, other in zip(derivatives, expected(name, label, field, index), strict=True):
                assert worst(one, other, blocks) < ROUNDING


def test_an_origin_counts_as_its_joint_with_opposite_sign(subtests: pytest.Subtests) -> None:
    name, label = "rotary_delta", ""
    blocks = kinds(extended(name).COORDINATES)
    for (field, index, *_), derivatives in zip(listed(name), found(name, label), strict=True):
        if field == "joint":
            with subtests.test(index=index):
                for one, other in zip(derivatives, expected(name, label, "origin", index), strict=True):
                    assert worst(-one, other, blocks) < ROUNDING
