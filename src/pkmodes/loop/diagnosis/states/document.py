"""The JSON of what changed: that of a diagnosis, with the states.

Members of lists have further keys: for a type checker these are other lists than those of a diagnosis.
"""

from __future__ import annotations

from typing import Annotated

from msgspec import Meta, field

from pkmodes.core.support.documents import Number, Size
from pkmodes.loop.diagnosis.verdict.document import (
    BeyondDocument,
    CauseDocument,
    DiagnoseDocument,
    TermClassDocument,
    TermDocument,
)
from pkmodes.loop.diagnosis.verdict.rows import Row

InState = Annotated[str, Meta(description="The state to which it applies.")]


class ChangedCause(CauseDocument, frozen=True, kw_only=True):
    """What changed in a state."""

    state: InState


class ChangedTerm(TermDocument, frozen=True, kw_only=True):
    """A change at one place, or one of the catalogue that does as well."""

    state: InState


class ChangedTermClass(TermClassDocument, frozen=True, kw_only=True):
    """Changes beyond the catalogue that these data cannot tell apart."""

    members: Annotated[  # type: ignore[assignment]
        list[ChangedTerm],
        Meta(description="The best first, those with plausible values before others.", min_length=1),
    ]


class ChangedBeyond(BeyondDocument, frozen=True, kw_only=True):
    """What one thing at one place would explain that the catalogue does not."""

    classes: Annotated[  # type: ignore[assignment]
        list[ChangedTermClass],
        Meta(description="The changes that remain, the best first; empty if the status is none."),
    ]


class ChangedRow(Row, frozen=True, kw_only=True, omit_defaults=True):
    """A measured mode of a later state, its predictions, and the same mode in the trusted state."""

    trusted: Annotated[
        Size | None,
        Meta(description="Its frequency in the trusted state at the same pose [Hz]; null where it has none."),
    ] = field(name="trusted_hz")
    trusted_line: Annotated[
        Number | None, Meta(description="Its line in the file of the trusted state; null where it has none.")
    ]


class ChangedState(DiagnoseDocument, frozen=True, kw_only=True):
    """What changed from a trusted state to another one."""

    states: Annotated[list[str], Meta(description="The states, the trusted one first.", min_length=2)]
    changed: Annotated[
        bool | None, Meta(description="Whether anything changed; null where the data do not tell.")
    ]
    model_error: Annotated[
        Size,
        Meta(
            description="Root mean square of the relative error of the model in the trusted state, which is "
            "subtracted from the others."
        ),
    ]
    effects: Annotated[  # type: ignore[assignment]
        list[ChangedCause], Meta(description="What changed; empty unless the verdict is effect_found.")
    ]
    beyond: Annotated[
        ChangedBeyond | None,
        Meta(
            description="One thing at one place, beyond the catalogue, on which the verdict does not depend; null "
            "where it was not tried."
        ),
    ]
    rows: Annotated[  # type: ignore[assignment]
        list[ChangedRow],
        Meta(description="One for each measured mode of the later states, in the order of their files."),
    ]


class ChangedDocument(ChangedState, frozen=True, kw_only=True):
    """What changed since a trusted state."""

    by_state: Annotated[
        dict[str, ChangedState],
        Meta(description="What changed in each of several later states; empty for a single one."),
    ]
