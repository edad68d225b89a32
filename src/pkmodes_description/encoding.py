"""Descriptions as JSON; both directions follow from `structure`."""

from __future__ import annotations

import json

import msgspec

from pkmodes_description.references import problems
from pkmodes_description.structure import Description

FILE_NAME = "description.json"


class DescriptionError(ValueError):
    """A description that is not valid; the message says what was expected where."""


def encode(description: Description) -> str:
    """Return the description as JSON."""
    return json.dumps(msgspec.to_builtins(description, enc_hook=_plain), indent=1, ensure_ascii=False) + "\n"


def decode(text: bytes) -> Description:
    """Return the description in a JSON text.

    Raises
    ------
    DescriptionError
        If it is not JSON, a part is missing, unknown or of another type, or one refers to a part that is not there.
    """
    try:
        description = msgspec.json.decode(text, type=Description)
    except (msgspec.DecodeError, RecursionError) as error:
        raise DescriptionError(str(error)) from None
    for problem in problems(description):
        raise DescriptionError(problem)
    return description


def _plain(value: object) -> float:
    """Return a number of the sample robot that is a float of another library, such as NumPy."""
    if isinstance(value, float):
        return float(value)
    raise NotImplementedError(f"cannot write {type(value).__name__}")
