"""Why a pose cannot be evaluated: codes and sentences, for each pose of a batch."""

from __future__ import annotations

import numpy as np
import pytest

import pkmodes
from pkmodes.core.base.errors import PoseError

pytestmark = pytest.mark.usefixtures("backend")

GOOD = [0.6, 0.03, -0.245]
BAD = {
    "finite": [np.nan, 0.0, -0.245],
    "reachable": [0.6, 0.0, 0.9],
    "singular": [0.6, 0.0, 0.0],
    "limits": [0.1, 0.0, -0.245],
}


def expected(p: np.ndarray) -> str:
    """The published robot by hand: rails along x at y = 0, -0.2, 0.2, links of 0.4 m, carriages from 0 to 1.2 m.

    The condition number of D_l is that of the links' components over the ones along the rail.
    """
    if not np.isfinite(p).all():
        return "finite"
    across = [np.hypot(p[1] - y, p[2]) for y in (0.0, -0.2, 0.2)]
    if max(across) > 0.4:
        return "reachable"
    along = np.array([1, -1, -1]) * np.sqrt(0.16 - np.square(across))
    links = np.array([[-a, p[1] - y, p[2]] for a, y in zip(along, (0.0, -0.2, 0.2), strict=True)])
    if not np.linalg.cond(links, "fro") < 1e6:
        return "singular"
    x = p[0] + along
    return "" if ((x > 0.0) & (x < 1.2)).all() else "limits"


def test_codes_are_those_of_the_geometry(model: pkmodes.Model) -> None:
    rng = np.random.default_rng(8)
    poses = np.concatenate([rng.uniform([-0.2, -0.4, -0.5], [1.4, 0.4, 0.5], (3000, 3)), list(BAD.values())])
    poses[:30, 2] = 0.0
    wanted = [expected(p) for p in poses]
    assert set(wanted) == {"", *BAD}  # every one of them occurs
    found = model.check(poses)
    assert found.reason.tolist() == wanted
    np.testing.assert_array_equal(found.valid, found.reason == "")
    assert [bool(sentence) for sentence in found.sentences] == (~found.valid).tolist()


@pytest.mark.parametrize("code", BAD)
def test_every_result_has_the_reason(model: pkmodes.Model, code: str) -> None:
    poses = [[GOOD, BAD[code]], [BAD[code], GOOD]]
    for found in (
        model.modes(poses, on_error="nan"),
        model.modes(poses, on_error="nan", fields=["frequencies"]),
        model.statics(poses, on_error="nan"),
        model.sensitivities(poses, ["platform.mass"], on_error="nan"),
        model.check(poses),
    ):
        assert found.reason.tolist() == [["", code], [code, ""]]
        assert found.valid.tolist() == [[True, False], [False, True]]
    one = model.modes(BAD[code], on_error="nan")
    assert one.reason == code
    assert isinstance(model.reasons[one.reason], str)
    assert model.modes(GOOD).reason == ""


@pytest.mark.parametrize("code", BAD)
def test_sentences_are_those_of_the_errors(model: pkmodes.Model, code: str) -> None:
    with pytest.raises(PoseError) as error:
        model.modes(BAD[code])
    sentence = f"{error.value.what}; {error.value.remedy}"
    assert model.check(BAD[code]).sentences == sentence
    assert model.check([GOOD, BAD[code]]).sentences.tolist() == ["", sentence]
    assert model.check(GOOD).sentences == ""


def test_codes_have_sentences_in_the_order_in_which_they_are_asked(model: pkmodes.Model) -> None:
    assert list(model.reasons) == ["finite", "reachable", "singular", "limits"]
    assert all(model.reasons.values())


def test_a_larger_condition_number_may_be_accepted(model: pkmodes.Model) -> None:
    close = [0.6, 0.0, -1e-6]
    assert model.check(close).reason == ""
    strict = pkmodes.Model(model.robot, max_condition=1e4)
    assert strict.check(close).reason == "singular"
    assert strict.check(GOOD).valid
    with pytest.raises(PoseError, match="singular"):
        strict.frequencies(close)


def test_a_check_counts_what_it_found(model: pkmodes.Model) -> None:
    found = model.check([GOOD, *BAD.values(), BAD["limits"]])
    assert repr(found) == "PoseCheck(1 of 6 valid, 1 finite, 1 reachable, 1 singular, 2 limits)"
