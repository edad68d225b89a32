"""Files of effects of one's own: what is wrong in them is named with the line and what to do."""

from __future__ import annotations

import pytest

from pkmodes_derive import effect_file, mechanisms
from pkmodes_derive.definition import DefinitionError
from pkmodes_derive.terms import compliance
from pkmodes_derive.terms.enumeration import terms

HEAD = """from sympy import Rational, sqrt
from pkmodes_derive.effect import Effect, EffectParameter
from pkmodes_derive.terms import mass, mount, spring

def effect(apply, name="tube_stiffness"):
    parameters = (EffectParameter("stiffness", "N/m", "stiffness of the tube", "k_T", "k_T"),)
    return Effect(name, "a tube pulls", lambda machine: machine.directions, parameters, apply)

def applied(energy):
    def apply(machine, parameters, released):
        machine.add_elastic(energy(parameters["stiffness"], machine.delta_p[0]))
    return apply

"""
#: Text of the file's last line, and parts of the message.
WRONG = {
    "nothing": ("", ("EFFECT is missing", "own.py", "docs/how-to/adding-an-effect.md")),
    "something else": ("EFFECT = 3", ("EFFECT is not an Effect",)),
    "not Python": ("EFFECT = (", ("not valid Python", "own.py:14")),
    "an exception": ("EFFECT = 1 / 0", ("ZeroDivisionError", "own.py:14")),
    "a name of the catalogue": (
        'EFFECT = effect(applied(lambda k, x: k * x**2), "payload")',
        ('"payload" is an effect of the catalogue already', "another name"),
    ),
    "a place that is not there": ('EFFECT = mass("carriage_7")', ("acts on parts", "carriage_3")),
    "not null at 0": (
        "EFFECT = effect(applied(lambda k, x: (1 + k) * x**2))",
        ("changes the machine where its parameters are 0", "null at 0"),
    ),
    "without its parameter": (
        "EFFECT = effect(applied(lambda k, x: x**2))",
        ("changes the machine where its parameters are 0", "null at 0"),
    ),
    "no derivative at 0": (
        "EFFECT = effect(applied(lambda k, x: sqrt(k) * x**2))",
        ("has no derivative with respect to k_T at 0",),
    ),
    "divided by 0": (
        "EFFECT = effect(applied(lambda k, x: x**2 / k))",
        ("is not defined where its parameters are 0",),
    ),
}


@pytest.mark.parametrize("case", WRONG)
def test_a_file_with_a_mistake_is_refused(case: str) -> None:
    line, parts = WRONG[case]
    with pytest.raises(DefinitionError) as error:
        mechanisms.add_effects("linear_delta", [(HEAD + line + "\n", "own.py")])
    for part in parts:
        assert part in str(error.value)
    assert mechanisms.own_effects("linear_delta") == ()


def test_an_effect_of_ones_own_stands_among_those_of_the_catalogue() -> None:
    catalogue = mechanisms.effects("linear_delta")
    try:
        line = "EFFECT = effect(applied(lambda k, x: Rational(1, 2) * k * x**2))\n"
        mechanisms.add_effects("linear_delta", [(HEAD + line, "own.py")])
        names = [effect.name for effect in mechanisms.effects("linear_delta")]
        assert set(names) - {effect.name for effect in catalogue} == {"tube_stiffness"}
    finally:
        mechanisms.add_effects("linear_delta", [])
    assert mechanisms.effects("linear_delta") == catalogue


@pytest.mark.parametrize("name", ["linear_delta", "rotary_delta", "corexy", "cartesian", "bed_slinger"])
def test_every_term_may_be_an_effect_of_ones_own(name: str) -> None:
    bare = mechanisms.machine(name)
    released = [
        effect.released.name.format(i=place, j=place)
        for effect in mechanisms.effects(name)
        if effect.released is not None
        for place in effect.places
    ]
    effects = [*(term.effect for term in terms(bare)), *map(compliance, released)]
    assert len(effects) > 20
    for effect in effects:
        effect_file.check(effect, bare, mechanisms.machine(name, [effect]), "own.py")
