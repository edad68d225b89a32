"""The page of a cause with a value for each joint: the one that would do alone comes first, and all are there."""

from __future__ import annotations

from dataclasses import replace

from helpers.pages.page_reading import read
from helpers.pages.report_examples import made_up
from pkmodes.loop.diagnosis.problem import Joint
from pkmodes.loop.diagnosis.verdict.findings import Finding, Member, Value
from pkmodes.loop.diagnosis.verdict.joints import JointAlone
from pkmodes.pages.report import report

NAME = "axis_leg_stiffness"
FACTORS = [f"effects.{NAME}.factor_{j}" for j in range(1, 7)]


def test_the_one_leg_is_the_only_size_in_the_head_and_every_factor_is_in_the_table() -> None:
    result, data = made_up(4, 3)
    values = tuple(
        Value(name, value, 0.003, "1")
        for name, value in zip(FACTORS, (0.0012, -0.0023, -0.2534, 0.0045, 0.0056, -0.0067), strict=True)
    )
    alone = JointAlone(
        Joint(FACTORS[2], "leg 3", "stiffness", "parameter:axis.3.leg.stiffness"),
        -0.2512,
        0.0011,
        5,
    )
    sentence = "leg 3 is 25 % softer than the others"
    assert alone.sentence == sentence
    effect = Finding(
        NAME,
        (NAME,),
        values,
        {NAME: values},
        1e-9,
        sentence,
        about={NAME: Member(NAME, sentence)},
        alone=alone,
    )
    named = replace(result, effects=(effect,), alone={NAME: alone}, probabilities=None)
    page = read(report(named, data=data, title="hexapod"))
    assert f"Cause found: {sentence}" in page.text
    tiles = [entry.text for entry in page.all("dt")]
    assert "leg 3 alone: change of its stiffness [%]" in tiles
    assert not [name for name in tiles if "factor_" in name]
    table = page.by_id("causes").text
    assert all(name in table for name in FACTORS)
    assert "Leg 3, which is 25 % softer than the others: nuts, bearings and joints" in page.text
    assert "parameter:axis.3.leg.stiffness" in page.text
