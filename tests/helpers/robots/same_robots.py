"""Robots that are the same to the last digit: their parameters, quantities, effects and constants."""

from __future__ import annotations

import numpy as np

import pkmodes


def same_to_the_last_digit(found: pkmodes.Robot, expected: pkmodes.Robot) -> None:
    for name, a, b in zip(expected.parameters._fields, found.parameters, expected.parameters, strict=True):
        assert np.asarray(a).tobytes() == np.asarray(b).tobytes(), name
    assert dict(found.quantities) == dict(expected.quantities)
    assert list(found.quantities) == list(expected.quantities)
    assert dict(found.effects) == dict(expected.effects)
    assert dict(found.constants) == dict(expected.constants)
    assert found.declared == expected.declared
    assert found == expected
    assert hash(found) == hash(expected)
