"""What a corrected robot gets in addition: values of single axes, effects, and the mass of the frame."""

from __future__ import annotations

from pathlib import Path

import pytest

from helpers.robots.corrected_files import changed_lines, correct, reread
from helpers.robots.robot_text import edited, published
from pkmodes.core.base.errors import OutputError
from pkmodes.loop.robot_files.saving import Correction


def test_an_axis_gets_an_override_in_the_unit_of_what_it_shares(tmp_path: Path) -> None:
    for j, rest in ((1, "\n[[axis]]\n"), (2, "\n[[axis]]\n"), (3, "")):
        after = correct(
            tmp_path, published(), **{f"axis__{j}__belt__width": Correction(0.0251, 1e-4, "was 15 mm")}
        )
        lines = '\n[axis.belt]\nwidth = { value = "25.1 mm", sigma = "0.1 mm" }  # was 15 mm\n'
        assert after.count(lines + rest) == 1
        assert after.replace(lines, "", 1) == published()
        robot = reread(tmp_path, after)
        assert robot.quantities[f"axis.{j}.belt.width"].sigma == 1e-4
        assert robot.parameters.belt_width.tolist() == [0.0251 if i == j else 0.015 for i in (1, 2, 3)]


def test_what_stands_before_the_next_axis_stays_there(tmp_path: Path) -> None:
    head, first, second, third = published().split("[[axis]]\n")
    text = (
        f"{head}[[axis]]\n{first.rstrip()}\n# of the first\n\n# the second:\n\n[[axis]]\n{second.rstrip()}\n"
        f"  [axis.link] # its own\n  mass = 1 # m\n  # also of the second\n\n# the third:\n[[axis]]\n{third}"
    )
    after = correct(
        tmp_path,
        text,
        axis__1__belt__width=Correction(0.02),
        axis__2__belt__width=Correction(0.02),
        axis__2__link__length=Correction(0.3, None, "new"),
        axis__2__link__mass=Correction(2.0),
        axis__1__belt__specific_stiffness=Correction(3e6),
    )
    belt, stiffness = '\n[axis.belt]\nwidth = "20 mm"\n', 'specific_stiffness = "3000000 N/m"\n'
    assert "# of the first\n" + belt + stiffness + "\n# the second:\n\n[[axis]]\n" in after
    assert (
        '  [axis.link] # its own\n  mass = 2 # m\n  length = "300 mm"  # new\n  # also of the second\n'
        + belt
        + "\n# the third:\n[[axis]]\n"
        in after
    )
    removed, added = changed_lines(text, after)
    assert removed == ["  mass = 1 # m\n"]
    assert len(added) == 9


def test_an_existing_override_is_changed_and_the_shared_value_is_not(tmp_path: Path) -> None:
    text = published() + '\n[axis.belt]\nwidth = "25 mm" # mine\n'
    after = correct(tmp_path, text, axis__3__belt__width=Correction(0.026), belt__width=Correction(0.014))
    assert changed_lines(text, after) == (
        ['width = "15 mm"                     # w_b, section 2.1\n', 'width = "25 mm" # mine\n'],
        ['width = "14 mm"                     # w_b, section 2.1\n', 'width = "26 mm" # mine\n'],
    )


def test_effects_are_added_at_the_end(tmp_path: Path) -> None:
    after = correct(
        tmp_path,
        published(),
        effects__payload__mass=Correction(0.35, 0.01, "found by diagnosis"),
        effects__gearbox_compliance__compliance=Correction(2.1e-3),
        effects__axis_belt_stiffness__factor_3=Correction(-0.05, None, "weak belt"),
        effects__axis_belt_stiffness__factor_1=Correction(0.02, 0.001, "weak\n belt"),
    )
    assert after == published() + (
        '\n# found by diagnosis\n[effects.payload]\nmass = { value = "0.35 kg", sigma = "0.01 kg" }\n'
        '\n[effects.gearbox_compliance]\ncompliance = "0.0021 rad/(N*m)"\n'
        "\n# weak belt; weak belt\n[effects.axis_belt_stiffness]\nfactor_3 = -0.05\n"
        "factor_1 = { value = 0.02, sigma = 0.001 }\n"
    )
    assert reread(tmp_path, after).effects["axis_belt_stiffness.factor_2"] == 0.0
    # The file need not end with a newline.
    open_end = published().rstrip()
    after = correct(tmp_path, open_end, effects__payload__mass=Correction(0.35))
    assert after == open_end + '\n\n[effects.payload]\nmass = "0.35 kg"\n'


def test_an_effect_that_is_there_keeps_its_other_keys(tmp_path: Path) -> None:
    text = published() + (
        '\n[effects.frame_compliance]\ncompliance = 1e-8\nmass = "60 kg" # weighed\n'
        "\n[effects.payload]\nmass = 0 # none\n# end\n"
    )
    after = correct(
        tmp_path,
        text,
        effects__payload__mass=Correction(0.35, None, "was none"),
        effects__frame_compliance__compliance=Correction(2e-8),
    )
    assert changed_lines(text, after)[1] == ["compliance = 2e-08\n", "mass = 0.35 # none; was none\n"]
    text = published() + "\n[effects.axis_belt_stiffness]\nfactor_1 = 0.1 # a\n\n# end\n"
    after = correct(tmp_path, text, effects__axis_belt_stiffness__factor_2=Correction(0.2, None, "new"))
    assert after == text.replace("# a\n", "# a\nfactor_2 = 0.2  # new\n")


def test_the_mass_of_the_frame_is_added_where_it_is_declared(tmp_path: Path) -> None:
    after = correct(tmp_path, published(), frame__mass=Correction(61.5, 2.0, "was the default of 50 kg"))
    assert after == published() + (
        '\n# was the default of 50 kg\n[frame]\nmass = { value = "61.5 kg", sigma = "2 kg" }\n'
    )
    text = published() + '\n[effects.frame_compliance]\ncompliance = "1e-8 m/N"\n'
    assert reread(tmp_path, correct(tmp_path, text, frame__mass=Correction(61.5))).effects == {
        "frame_compliance.compliance": 1e-8,
        "frame_compliance.mass": 61.5,
    }
    empty = edited("[link]\n", "[frame]\n\n[link]\n")
    after = correct(tmp_path, empty, frame__mass=Correction(61.5))
    assert after == empty.replace("[frame]\n", '[frame]\nmass = "61.5 kg"\n')
    twice = text + 'mass = "60 kg"\n'
    with pytest.raises(OutputError, match="declared twice"):
        correct(tmp_path, twice, frame__mass=Correction(61.5))
