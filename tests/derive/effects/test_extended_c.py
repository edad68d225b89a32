"""The generated C of the extended model returns the numbers of the NumPy module."""

from __future__ import annotations

import inspect
from pathlib import Path

import numpy as np
import pytest

from helpers.generated.compiled import build, call
from helpers.generated.emission import Emission
from helpers.robots.sample_robots import random_robot
from pkmodes_derive import mechanisms
from pkmodes_generated.linear_delta import extended

pytestmark = pytest.mark.compiler

NAME = "linear_delta_extended"


def test_extended_c_equals_numpy(tmp_path: Path, emission: Emission) -> None:
    library = build(tmp_path, NAME, emission.parametric("linear_delta"))
    rng = np.random.default_rng(31)
    derived = mechanisms.extended("linear_delta").functions
    functions = [f for f in derived if f.in_c]
    others = {f.name for f in derived} - {f.name for f in functions}
    # All but the derivatives, the condition checked on reading a robot file, which motor turns what, and dissipation.
    assert others == {
        *("value_sensitivities", "geometry_sensitivities", "belt_tension_stiffness_margin", "motor_motion"),
        *("extended_dissipation", "joint_loss"),
    }
    for _ in range(3):
        parameters, p = random_robot(rng)
        effects = extended.Effects(*(10.0 ** rng.uniform(-8, -1) for _ in extended.Effects._fields))
        for function in functions:
            taken = inspect.signature(getattr(extended, function.name)).parameters
            groups = [g for name, g in (("parameters", parameters), ("effects", effects)) if name in taken]
            inputs = [p] if function.arguments else []
            found = call(library, NAME, function, inputs, groups)
            expected = getattr(extended, function.name)(*inputs, *groups)
            for a, b in zip(found, expected if isinstance(expected, tuple) else (expected,), strict=True):
                # Same operations in the same order; the compiler may fuse a product and a sum.
                np.testing.assert_allclose(
                    a, b, rtol=1e-12, atol=1e-13 * np.abs(b).max(), err_msg=function.name
                )
