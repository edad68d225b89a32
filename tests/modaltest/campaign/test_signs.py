"""Directions against the positive one: signs of channels, and of degrees of freedom in universal files."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from modaltest.campaign.structures import HEAD, identify, record, refused
from modaltest.campaign.test_universal_quotients import STEP, accelerances, has_the_modes_of_the_frame
from modaltest.signals.universal import frf58

#: Nodes of the floors, and the direction in which each was hit or measured.
DIRECTIONS = {1: -3, 2: 3, 3: -3}
NAMES = {1: "1:-Z", 2: "2:+Z", 3: "3:-Z"}
SENSOR = '[[sensor]]\nname = "3:-Z"\nchannel = "-floor_3"\n'


def forces(*signs: str) -> str:
    return "".join(
        f'[[force]]\nname = "{NAMES[k]}"\nchannel = "{sign}floor_{k}"\n'
        for k, sign in enumerate(signs, start=1)
    )


@pytest.fixture
def roving(tmp_path: Path) -> Path:
    """One sensor and three hammer points, along and against Z: what a file has then is the product of both signs."""
    H = accelerances()
    parts = [
        frf58(-H[:, k - 1] if d > 0 else H[:, k - 1], STEP, response=(3, -3), reference=(k, d))
        for k, d in DIRECTIONS.items()
    ]
    parts += [
        frf58(np.full(len(H), 0.9), STEP, response=(3, -3), reference=(k, d), function=6)
        for k, d in DIRECTIONS.items()
    ]
    (tmp_path / "r.uff").write_bytes(b"".join(parts))
    return tmp_path


def test_a_sign_before_the_channel_of_a_roving_hammer(roving: Path) -> None:
    campaign = HEAD + SENSOR + forces("-", "", "-") + record("frf", "r.uff")
    has_the_modes_of_the_frame(identify(roving, campaign).file)


def test_signs_of_the_file_are_taken_if_asked(roving: Path) -> None:
    campaign = 'signs = "file"\n' + HEAD + SENSOR.replace("-floor", "floor") + forces("", "", "")
    has_the_modes_of_the_frame(identify(roving, campaign + record("frf", "r.uff") + "averages = 10\n").file)
    wrong = campaign.replace('"file"', '"files"') + record("frf", "r.uff")
    assert 'expected "file", found' in refused(roving, wrong)


@pytest.mark.parametrize("signs", [("-", "", "-"), None])
def test_signs_of_sensors(tmp_path: Path, signs: tuple[str, ...] | None) -> None:
    H = accelerances()
    parts = [
        frf58(-H[:, k - 1] if d < 0 else H[:, k - 1], STEP, response=(k, d), reference=(3, 3))
        for k, d in DIRECTIONS.items()
    ]
    (tmp_path / "r.uff").write_bytes(b"".join(parts))
    head = HEAD if signs else 'signs = "file"\n' + HEAD
    sensors = forces(*(signs or ("", "", ""))).replace("[[force]]", "[[sensor]]")
    has_the_modes_of_the_frame(identify(tmp_path, head + sensors + record("frf", "r.uff")).file)


def test_references_that_no_force_names_are_said(roving: Path) -> None:
    said = identify(roving, HEAD + SENSOR + record("frf", "r.uff")).remarks
    assert (
        "no [[force]] names the references 1:-Z, 2:+Z, 3:-Z: their shapes have the places of the sensors only"
        in said
    )
    some = HEAD + SENSOR + forces("-", "") + record("frf", "r.uff")
    assert "left out, as no [[force]] names them: the references 3:-Z" in identify(roving, some).remarks
