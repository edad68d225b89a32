"""A class is named as what it is, never by one member, and says which of its values are plausible."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from helpers.robots.small_structures import SIGMA, each, of_signatures, with_changes
from pkmodes.core.mechanism import registry
from pkmodes.loop.diagnosis import Candidate, Diagnosis, Parameter, diagnose
from pkmodes.loop.diagnosis.verdict import naming
from pkmodes.loop.diagnosis.verdict.findings import Finding, Member
from pkmodes.loop.diagnosis.verdict.possible import describe_member, split_possible
from pkmodes.loop.updating.kinds import KINDS, with_kinds

SERIES = "a compliance in series with the belt"
ABOUT = {
    "clamp": Member("clamp", "the belt clamps are compliant", SERIES, "clamps"),
    "gearbox": Member("gearbox", "the gearboxes wind up", SERIES, "gearboxes"),
    "ends": Member("ends", "the belt ends are compliant", SERIES, "belt ends"),
    "offset": Member("offset", "all poses are shifted along z"),
    "span": Member("span", "the declared span is wrong", implausible="0.665 to 0.735 m is plausible"),
}


def of(*names: str) -> Finding:
    first = ABOUT[names[0]].sentence
    return Finding(names[0], names, (), {}, 0.0, first, about={name: ABOUT[name] for name in names})


@pytest.mark.parametrize(
    ("effects", "expected"),
    [
        ((of("clamp"),), "found: the belt clamps are compliant"),
        ((of("clamp", "gearbox", "ends"),), f"narrowed to three: {SERIES} (clamps, gearboxes, belt ends)"),
        (
            (of("clamp", "offset", "gearbox", "ends"),),
            f"narrowed to four: {SERIES} (clamps, gearboxes, belt ends), or all poses are shifted along z",
        ),
        # Nothing is shared: each stands for itself.
        (
            (of("gearbox", "span"),),
            "narrowed to two: the gearboxes wind up, or implausibly, the declared span is wrong",
        ),
        (
            (of("offset"), of("clamp", "ends")),
            f"found: all poses are shifted along z, and one of two: {SERIES} (clamps, belt ends)",
        ),
    ],
)
def test_a_class_is_named_by_what_its_members_share_or_by_all_of_them(
    effects: tuple[Finding, ...], expected: str
) -> None:
    assert naming.found_in_words(effects) == expected


def test_a_headline_counts_what_does_not_fit_and_names_no_member_as_the_cause() -> None:
    effect = of("offset", "gearbox", "span")
    assert naming.found_in_words([effect], 40) == (
        "narrowed to three: all poses are shifted along z, or two others, listed below"
    )
    assert naming.found_in_words([effect], 60).endswith(
        "or the gearboxes wind up, or one other, listed below"
    )


def test_a_name_stands_for_a_candidate_without_a_sentence() -> None:
    assert (
        naming.explanation_in_words([Finding("brace", ("brace",), (), {}, 0.0, "")]) == "explanation: brace"
    )
    two = Finding("brace", ("brace", "strut"), (), {}, 0.0, "")
    assert naming.explanation_in_words([two]) == "the cause is narrowed to two: brace, or strut"


def test_every_candidate_with_a_kind_is_one_of_some_mechanism() -> None:
    known = {f"measurement:offset.{axis}" for axis in "xyz"}
    for name in registry.supplied_names():
        described = registry.mechanism(name)
        known |= {name for effect in described.effects.values() for name in effect.forms}
        known |= {f"parameter:{table.name}.{key.name}" for table in described.tables for key in table.keys}
    assert {name for parts in KINDS.values() for name in parts} <= known


def test_the_value_of_one_axis_shares_the_kind_of_all() -> None:
    candidates = [
        Candidate(name, (name,))
        for name in ("parameter:belt.width", "parameter:axis.2.belt.width", "payloads", "payload")
    ]
    of_all, of_one, other, payload = with_kinds(candidates, registry.mechanism("corexy"))
    assert of_all.kind == of_one.kind != ""
    assert (of_all.part, of_one.part) == ("width", "width of axis 2")
    assert (other.kind, other.part) == ("", "")
    assert payload.kind == "another mass at the tool head"


def two_alike(usual: tuple[float, float] | None) -> Diagnosis:
    """The diagnosis of a change that two candidates explain alike, one with the value 0.06, one with -0.06."""
    rng = np.random.default_rng(5)
    along, other = rng.standard_normal((2, 6, 4)) / SIGMA
    roles = {name: {"sentence": f"{name} is wrong"} for name in ("a", "b", "other")}
    model = of_signatures(
        {"a": along, "b": -along, "other": other}, 6, 4, roles=roles, known={"b": {"usual": usual}}
    )
    return diagnose(model, with_changes(model, 0.06 * along + rng.standard_normal((6, 4))), holdout=())


def test_the_json_says_of_each_member_whether_its_value_is_plausible() -> None:
    found = two_alike((-0.01, 0.01))
    (effect,) = found.effects
    assert set(effect.members) == {"a", "b"}
    content: Any = found.as_json()
    assert content["effects"][0]["plausible"] == {"a": True, "b": False}
    assert content["reason"].endswith(
        "the cause is narrowed to two: a is wrong, or implausibly, b is wrong"
    ) or content["reason"].endswith("the cause is narrowed to two: implausibly, b is wrong, or a is wrong")
    assert "(implausible: -0.01 to 0.01 is plausible)" in str(found)


def test_plausible_values_change_no_verdict() -> None:
    marked, free = two_alike((-0.01, 0.01)), two_alike(None)
    assert [one.members for one in marked.effects] == [one.members for one in free.effects]
    assert [one.p_value for one in marked.effects] == [one.p_value for one in free.effects]
    assert all(free.effects[0].plausible.values())


@pytest.mark.parametrize(("usual", "leads"), [(None, "b"), ((-0.01, 0.01), "a")])
def test_an_implausible_member_does_not_lead_though_it_fits_a_little_better(
    usual: tuple[float, float] | None, leads: str
) -> None:
    rng = np.random.default_rng(5)
    along, aside, other = rng.standard_normal((3, 6, 4)) / SIGMA
    roles = {name: {"sentence": f"{name} is wrong"} for name in ("a", "b", "other")}
    signatures = {"a": along + 0.01 * aside, "b": -along, "other": other}
    model = of_signatures(signatures, 6, 4, roles=roles, known={"b": {"usual": usual}})
    found = diagnose(model, with_changes(model, 0.06 * along + rng.standard_normal((6, 4))), holdout=())
    (effect,) = found.effects
    assert effect.members == (leads, "b" if leads == "a" else "a")
    assert found.corrected[-1].name == leads
    assert ("narrowed to two: a is wrong, or implausibly, b is wrong" in found.reason) == (leads == "a")


def fits(*values: float) -> tuple[Any, list[Any]]:
    """Fits whose last causes have these values each, and what knows their parameters."""
    parameters = [Parameter(f"p{i}", 0.0, "m") for i in range(len(values))]
    causes = each(p.name for p in parameters)
    fitter = SimpleNamespace(parameters=parameters, parameter_indices=lambda cause: [int(cause.name[1:])])
    return fitter, [SimpleNamespace(causes=[cause], values=np.array(values)) for cause in causes]


def test_a_member_whose_value_is_beyond_its_range_leaves_the_class_and_is_named() -> None:
    fitter, group = fits(0.5, 3.0, -0.2)
    kept, left = split_possible(fitter, group, {0: 1.0, 1: 2.0, 2: 0.2})
    assert [fit.causes[-1].name for fit in kept] == ["p0", "p2"]
    assert left == [
        "p1 = 3 m would explain the measurements as well, but is left out of the class: at most 2 m from 0 m is "
        "plausible"
    ]


def test_a_class_does_not_become_empty_and_what_stays_is_marked() -> None:
    fitter, group = fits(3.0)
    assert split_possible(fitter, group, {0: 2.0}) == (group, [])
    assert describe_member(fitter, group[0], {0: 2.0}).implausible
    assert not describe_member(fitter, group[0], {0: 4.0}).implausible
