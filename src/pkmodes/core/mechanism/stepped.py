"""Numbers of a robot with complex steps, which differentiate generated functions exactly to rounding."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

#: Step of complex-step differentiation, which has no cancellation.
COMPLEX_STEP = 1e-30


def with_complex_steps(numbers: Any, slots: Sequence[tuple[str, tuple[int, ...]]]) -> Any:
    """Return parameters or effects with a complex step in one number at a time, along a new first axis.

    - numbers: Parameters or Effects
    - slots: field and index of each number; those of other fields have no step
    """
    copies = {}
    for k, (field, index) in enumerate(slots):
        if field in numbers._fields:
            if field not in copies:
                value = np.asarray(getattr(numbers, field))
                element_shape = value.shape[value.ndim - len(index) :]
                batch = value.shape[: value.ndim - len(index)] or (1,)
                copies[field] = np.broadcast_to(value, (len(slots), *batch, *element_shape)).astype(complex)
            element: Any = (k, ..., *index)
            copies[field][element] += COMPLEX_STEP * 1j
    return numbers._replace(**copies)
