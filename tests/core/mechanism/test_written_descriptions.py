"""Descriptions as JSON: what is read is written again to the byte, and what is no description is refused."""

from __future__ import annotations

import json
from importlib.resources import files
from typing import Any

import msgspec
import numpy as np
import pytest

from pkmodes.core.mechanism import registry
from pkmodes_description import Description, DescriptionError, decode, encode

MECHANISMS = registry.supplied_names()


def text_of(name: str) -> str:
    return files(f"pkmodes_generated.{name}").joinpath("description.json").read_text(encoding="utf-8")


def with_sample(**values: Any) -> Description:
    return msgspec.structs.replace(decode(text_of("corexy").encode()), sample=values)


@pytest.mark.parametrize("name", MECHANISMS)
def test_a_description_is_written_as_it_was_read(name: str) -> None:
    text = text_of(name)
    assert encode(decode(text.encode())) == text
    titled = json.loads(text) | {"title": "\u043f\u0440\u0438\u0432\u043e\u0434"}
    assert '"title": "\u043f\u0440\u0438\u0432\u043e\u0434"' in encode(decode(json.dumps(titled).encode()))


def test_numbers_of_other_libraries_are_written_as_numbers() -> None:
    written = json.loads(encode(with_sample(one=np.float64(0.1), several=[np.float64(2.5), 3.0])))
    assert written["sample"] == {"one": 0.1, "several": [2.5, 3.0]}


@pytest.mark.parametrize("value", [object(), 1j, np.zeros(2)])
def test_what_is_no_number_is_not_written(value: object) -> None:
    with pytest.raises((NotImplementedError, TypeError)):
        encode(with_sample(one=value))


@pytest.mark.parametrize("text", [b"", b"{", b"null", b"[" * 100_000, b"\xff"])
def test_what_is_no_description_is_refused(text: bytes) -> None:
    with pytest.raises(DescriptionError) as error:
        decode(text)
    assert str(error.value)
