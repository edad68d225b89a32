"""Sentences on any mechanism name what moves in this one."""

from __future__ import annotations

import pytest

from pkmodes.core.mechanism import registry

SENTENCES = {
    "corexy": "a cable or hose ties the tool head to ground",
    "cartesian": "a cable or hose ties the tool head to ground",
    "bed_slinger": "a cable or hose ties the tool head and the bed to ground",
    "linear_delta": "a cable or hose ties the platform to ground",
    "hexapod": "a cable or hose ties the platform to ground",
}


@pytest.mark.parametrize(("name", "sentence"), SENTENCES.items())
def test_a_cable_is_tied_to_what_moves(name: str, sentence: str) -> None:
    cable = registry.mechanism(name).effects["cable_stiffness"]
    assert cable.sentence == sentence
    (stiffness,) = cable.parameters
    bodies = sentence.removeprefix("a cable or hose ties ").removesuffix(" to ground")
    centre = "the platform centre" if bodies == "the platform" else f"the centre of {bodies}"
    assert stiffness.description == f"isotropic stiffness from {centre} to ground"


def test_no_effect_of_a_machine_with_a_tool_head_speaks_of_a_platform() -> None:
    for name in ("corexy", "cartesian", "bed_slinger"):
        for effect in registry.mechanism(name).effects.values():
            texts = [effect.sentence, *(parameter.description for parameter in effect.parameters)]
            assert not [text for text in texts if "platform" in text], (name, effect.name)
