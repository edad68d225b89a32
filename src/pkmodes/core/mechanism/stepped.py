"""Numbers of a robot with complex steps, which differentiate generated functions exactly to rounding."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

#: Step of complex-step differentiation, which has no cancellation.
STEP = 1e-30


def stepped(numbers: Any, names: Sequence[tuple[str, tuple[int, ...]]]) -> Any:
    """Return parameters or effects with a complex step in one number at a time, along a new first axis.

    - numbers: Parameters or Effects
    - names: field and index of each number; those of other fields have no step
    """
    copies = {}
    for k, (field, index) in enumerate(names):
        if field in numbers._fields:
            if field not in copies:
                value = np.asarray(getattr(numbers, field))
                element_shape = value.shape[value.ndim - len(index) :]
                batch = value.shape[: value.ndim - len(index)] or (1,)
                copies[field] = np.broadcast_to(value, (len(names), *batch, *element_shape)).astype(complex)
            place: Any = (k, ..., *index)
            copies[field][place] += STEP * 1j
    return numbers._replace(**copies)
