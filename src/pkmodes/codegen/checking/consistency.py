"""Consistency of generated code: every derivative is compared with differences of the function it differentiates.

The chain starts with the direct kinematics, which is checked by the closure equations: the inverse kinematics of its
result must return the coordinates.  Derivatives are computed in two ways: by complex step, which has no cancellation
and so a bound near rounding, and by central differences, which do not need an analytic function.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from importlib import import_module
from importlib.util import find_spec
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.codegen.checking.relations import Derivative, Relation, State, drawing_relations, relations
from pkmodes.core.mechanism.generated import Generated
from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.core.mechanism.regular import regular_poses
from pkmodes.core.support.progress import report_progress

Array = NDArray[np.float64]

#: Package of relations that hold for one mechanism only, in the module of its name.
MECHANISM_RELATIONS = "pkmodes.codegen.mechanisms"
#: Complex step: rounding only, some 1e-14 per unit of the condition number.
COMPLEX_STEP_BOUND = 1e-10
#: Fourth-order central differences: truncation grows with the fifth derivative and so with the condition number; at
#: most 4e-7 was measured for some hundred robots.
CENTRAL_BOUND = 1e-5


@dataclass(frozen=True)
class Check:
    """Result of one check: the largest error relative to the size of the quantity, and its bound."""

    name: str
    error: float
    bound: float

    @property
    def holds(self) -> bool:
        """Whether the error is within the bound; False for NaN."""
        return bool(self.error <= self.bound)


def check_consistency(
    generated: Generated,
    mechanism: Mechanism,
    parameters: Any,
    effects: bool = False,
    relations_at: Callable[[State], Iterator[Relation]] | None = None,
) -> list[Check]:
    """Check the derivatives of a generated model at a few poses.

    - generated: the functions
    - parameters: the robot's parameters, used to find poses
    - effects: whether the model has effects; some relations of the base model do not hold with effects
    - relations_at: yields the relations in a state; by default those of a model

    Returns one check for each relation and kind of difference; a single failed one if no regular pose is found.
    """
    report_progress("comparing derivatives with finite differences")
    poses = regular_poses(generated, mechanism, parameters)
    if not len(poses):
        return [Check("a regular pose within the limits", np.inf, 0.0)]
    checks = []
    differences: tuple[tuple[str, Derivative, float], ...] = (
        ("complex step", _complex_step, COMPLEX_STEP_BOUND),
        ("central differences", _central_differences, CENTRAL_BOUND),
    )
    with np.errstate(all="ignore"):  # a broken function may give NaN; it then fails the check
        for kind, derivative, bound in differences:
            errors: dict[str, float] = {}
            for p in poses:
                state = State(generated, mechanism, parameters, p, derivative, effects)
                try:
                    for name, value, expected, weight in (relations_at or _all_relations)(state):
                        errors[name] = max(errors.get(name, 0.0), _relative_error(value, expected, weight))
                except np.linalg.LinAlgError as error:  # from NaN or zeros in the stiffness
                    errors[f"the static equilibrium: {error}"] = np.inf
            checks += [Check(f"{name} ({kind})", error, bound) for name, error in errors.items()]
    return checks


def check_drawing(mechanism: Mechanism, parameters: object) -> list[Check]:
    """Check the motion of drawn points by differences of their positions, and the springs by the elastic Hessian."""
    return check_consistency(
        Generated(mechanism.model, parameters), mechanism, parameters, relations_at=drawing_relations
    )


def _relative_error(value: Array, expected: Array, weight: float) -> float:
    """Return the largest difference relative to the largest expected value, infinite where one is not a number."""
    if not (np.isfinite(value).all() and np.isfinite(expected).all()):
        return float(np.inf)
    scale = max(float(np.max(np.abs(expected), initial=0.0)), weight)
    difference = float(np.max(np.abs(value - expected), initial=0.0))
    return difference / scale if scale > 0.0 else 0.0


def _all_relations(state: State) -> Iterator[Relation]:
    """Yield the relations of every mechanism, and those of this mechanism only."""
    yield from relations(state)
    module_name = f"{MECHANISM_RELATIONS}.{state.mechanism.name}"
    if find_spec(module_name) is not None:
        yield from import_module(module_name).relations(state)


def _complex_step(function: Callable[[Array], Array], point: Array, step: float) -> Array:
    """Differentiate by complex step; the last axis of the result is that of the derivative."""
    h = 1e-30
    columns = [np.imag(function(point + 1j * h * e)) / h for e in np.eye(len(point))]
    return np.stack(columns, axis=-1)


def _central_differences(function: Callable[[Array], Array], point: Array, step: float) -> Array:
    """Differentiate by fourth-order central differences; the last axis of the result is that of the derivative."""
    columns = []
    for e in step * np.eye(len(point)):
        near = function(point + e) - function(point - e)
        far = function(point + 2 * e) - function(point - 2 * e)
        columns.append((8.0 * near - far) / (12.0 * step))
    return np.stack(columns, axis=-1)
