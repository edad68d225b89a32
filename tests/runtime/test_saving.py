"""The corrected robot: values are changed in their own units, and the rest of the file is unchanged."""

from __future__ import annotations

import difflib
import itertools
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from pkmodes.errors import OutputError, RobotFileError
from pkmodes.robot.reading import read_robot
from pkmodes.robot.robot import Robot
from pkmodes.robot.saving import Correction, corrected_text, save_corrected
from robot_text import PUBLISHED, edited, published

#: Joints of a tower printer, instead of joints at the centre.
JOINTS = ('["30 mm", "40 mm", 0]', "[0.0, 0.06, 0]", '["-3 cm", "0 mm", "-4 cm"]')


def correct(tmp_path: Path, text: str, **changes: Correction) -> str:
    """Return the text after corrections; in the keywords, __ stands for the dots of paths."""
    path = tmp_path / "robot.toml"
    path.write_bytes(text.encode("utf-8"))
    return corrected_text(path, {name.replace("__", "."): change for name, change in changes.items()})


def reread(tmp_path: Path, text: str) -> Robot:
    path = tmp_path / "corrected.toml"
    path.write_bytes(text.encode("utf-8"))
    return read_robot(path)


def changed_lines(before: str, after: str) -> tuple[list[str], list[str]]:
    """Return the lines that are in only one of the texts, with their line endings."""
    changes = list(difflib.ndiff(before.splitlines(keepends=True), after.splitlines(keepends=True)))
    return tuple([line[2:] for line in changes if line[0] == mark] for mark in "-+")


def with_joints() -> str:
    parts = published().split('joint = ["0 mm", "0 mm", "0 mm"]')
    assert len(parts) == 4
    return "".join(itertools.chain(*zip(parts, [*(f"joint = {joint}" for joint in JOINTS), ""], strict=True)))


def test_only_the_line_of_the_value_changes(tmp_path: Path) -> None:
    after = correct(
        tmp_path, published(), platform__mass=Correction(1.4912345678901, 0.0123456, "was 1.5 kg: refitted")
    )
    assert changed_lines(published(), after) == (
        ['mass = "1.5 kg"                     # m_p, after equation 24\n'],
        [
            'mass = { value = "1.491234568 kg", sigma = "0.0123 kg" }                     '
            "# m_p, after equation 24; was 1.5 kg: refitted\n"
        ],
    )
    quantity = reread(tmp_path, after).quantities["platform.mass"]
    assert quantity.value == pytest.approx(1.4912345678901, rel=1e-9)
    assert quantity.sigma == 0.0123


def test_no_correction_changes_nothing(tmp_path: Path) -> None:
    for text in (
        published(),
        published().replace("\n", "\r\n"),
        "\ufeff" + published(),
        published().rstrip(),
    ):
        assert correct(tmp_path, text) == text


@pytest.mark.parametrize(
    ("path", "old", "value", "new"),
    [
        ("platform.mass", '"1.5 kg"', 1.25, '"1.25 kg"'),
        ("link.length", '"400 mm"', 0.40123, '"401.23 mm"'),
        ("link.mass", '"0.7 kg"', 0.0, '"0 kg"'),
        ("carriage.mass", '"1 kg"', 1.125, '"1.125 kg"'),
        ("carriage.length", '"0 mm"', 0.05, '"50 mm"'),
        ("belt.specific_stiffness", '"2.42e6 N/m"', 2.5e6, '"2500000 N/m"'),
        ("belt.width", '"15 mm"', 1 / 70, '"14.28571429 mm"'),
        ("pulley.radius", '"35 mm"', 0.0351, '"35.1 mm"'),
        ("pulley.inertia", '"130e-6 kg*m^2"', 1.3e-5, '"1.3e-05 kg*m^2"'),
        ("motor.inertia", '"0.017e-3 kg*m^2"', 2e-5, '"2e-05 kg*m^2"'),
        ("motor.gear_ratio", "gear_ratio = 10", 10.5, "gear_ratio = 10.5"),
        ("gravity.z", '"-9.81 m/s^2"', -9.80665, '"-9.80665 m/s^2"'),
        ("axis.1.limits.min", '["0 m", "1.2 m"]', -0.01, '["-0.01 m", "1.2 m"]'),
        ("axis.1.limits.max", '["0 m", "1.2 m"]', 1.3, '["0 m", "1.3 m"]'),
        ("axis.2.origin.y", '"-200 mm"', -0.201, '"-201 mm"'),
        ("axis.1.origin.x", '["0 mm", "0 mm", "0 mm"]', 0.001, '["1 mm", "0 mm", "0 mm"]'),
    ],
)
def test_every_kind_of_value_keeps_its_unit(
    tmp_path: Path, path: str, old: str, value: float, new: str
) -> None:
    after = correct(tmp_path, published(), **{path.replace(".", "__"): Correction(value)})
    assert after == edited(old, new)
    assert reread(tmp_path, after).quantities[path].value == pytest.approx(value, rel=1e-9)


@pytest.mark.parametrize(
    ("old", "value", "sigma", "new"),
    [
        ("0.4", 0.41, None, "0.41"),
        ("1", 0.5, None, "0.5"),
        ("0.4", 0.41, 0.002, "{ value = 0.41, sigma = 0.002 }"),
        ("'40 cm'", 0.41, 0.002, "{ value = '41 cm', sigma = '0.2 cm' }"),
        ('"""400mm"""', 0.41, None, '"410mm"'),
        ('" +400  mm "', 0.41, None, '"410  mm "'),
        ('"400e3 \u00b5m"', 0.41, None, '"410000 \u00b5m"'),
        ('{ value = "400 mm" }', 0.41, None, '{ value = "410 mm" }'),
        ('{ value = "400 mm" }', 0.41, 0.0, '{ value = "410 mm", sigma = "0 mm"}'),
        (
            '{value="400 mm",  sigma = "2 %"}',
            0.41,
            0.001234,
            '{value="410 mm",  sigma = "1.23 mm"}',
        ),
        ('{sigma = "0.2 cm", value = 0.4}', 0.41, 0.001, "{sigma = 0.001, value = 0.41}"),
        ('{ value = "400 mm", sigma = "1 cm" }', 0.41, None, '{ value = "410 mm", sigma = "1 cm" }'),
        # A deviation of 2 % stays 8 mm when it is not corrected itself.
        ('{ value = "400 mm", sigma = "2 %" }', 0.41, None, '{ value = "410 mm", sigma = "8 mm" }'),
    ],
)
def test_a_value_keeps_its_notation(
    tmp_path: Path, old: str, value: float, sigma: float | None, new: str
) -> None:
    text = edited('"400 mm"', old)
    assert correct(tmp_path, text, link__length=Correction(value, sigma)) == edited('"400 mm"', new)


def test_a_percentage_gets_an_absolute_deviation(tmp_path: Path) -> None:
    text = published() + '\n[effects.axis_belt_stiffness]\nfactor_2 = "-5 %"\n'
    after = correct(tmp_path, text, effects__axis_belt_stiffness__factor_2=Correction(-0.04, 0.002))
    assert after.endswith('factor_2 = { value = "-4 %", sigma = 0.002 }\n')
    assert reread(tmp_path, after).quantities["effects.axis_belt_stiffness.factor_2"].sigma == 0.002


def test_a_table_of_its_own_stays_one(tmp_path: Path) -> None:
    text = edited(
        'mass = "1.5 kg"                     # m_p, after equation 24\n',
        '[platform.mass] # m\nvalue = "1.5 kg" # v\nsigma = "2 %" # s\n',
    )
    after = correct(tmp_path, text, platform__mass=Correction(1.4, 0.01, "new"))
    assert changed_lines(text, after)[1] == ['value = "1.4 kg" # v; new\n', 'sigma = "0.01 kg" # s\n']
    without = text.replace('sigma = "2 %" # s\n', "")
    after = correct(tmp_path, without, platform__mass=Correction(1.4, 0.01))
    assert changed_lines(without, after)[1] == ['value = "1.4 kg" # v\n', 'sigma = "0.01 kg"\n']


def test_elements_of_a_vector_share_the_comment_of_their_line(tmp_path: Path) -> None:
    after = correct(
        tmp_path,
        published(),
        axis__2__origin__y=Correction(-0.201, 1e-4, "was -200 mm"),
        axis__2__origin__z=Correction(0.003, None, "was 0 mm"),
    )
    assert changed_lines(published(), after)[1] == [
        'origin = ["0 mm", { value = "-201 mm", sigma = "0.1 mm" }, "3 mm"]  # was -200 mm; was 0 mm\n'
    ]


def test_a_vector_over_several_lines_keeps_them(tmp_path: Path) -> None:
    text = edited(
        'origin = ["0 mm", "-200 mm", "0 mm"]\n',
        'origin = [ # o\n  0,\n  "-200 mm", # y\n  0, # z\n] # end\n',
    )
    after = correct(tmp_path, text, axis__2__origin__y=Correction(-0.21, None, "was -200 mm"))
    assert changed_lines(text, after)[1] == ['  "-210 mm", # y\n', "] # end; was -200 mm\n"]


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


def test_the_span_moves_both_ends_of_every_axis(tmp_path: Path) -> None:
    text = edited('limits = ["0 m", "1.2 m"]', 'limits = [{ value = "100 mm", sigma = 0 }, 1.2]')
    after = correct(tmp_path, text, axis__span=Correction(1.1014, 0.000412, "was 1.1 m"))
    assert changed_lines(text, after)[1] == [
        'limits = [{ value = "99.3 mm", sigma = 0 }, 1.2007]  # was 1.1 m; sigma of axis.span 0.000412 m\n',
        *2 * ['limits = ["-0.0007 m", "1.2007 m"]  # was 1.1 m; sigma of axis.span 0.000412 m\n'],
    ]
    limits = reread(tmp_path, after).parameters.limits
    np.testing.assert_allclose(limits[:, 1] - limits[:, 0], [1.1014, 1.2014, 1.2014], rtol=1e-10)
    again = correct(tmp_path, after, axis__span=Correction(1.1))
    np.testing.assert_allclose(
        reread(tmp_path, again).parameters.limits, [[0.1, 1.2], [0, 1.2], [0, 1.2]], atol=0
    )


def test_the_joint_radius_changes_along_the_joints(tmp_path: Path) -> None:
    text = with_joints()
    after = correct(tmp_path, text, axis__joint_radius=Correction(0.055, 0.001, "fitted"))
    assert changed_lines(text, after)[1] == [
        f"joint = {joint}  # fitted; sigma of axis.joint_radius 0.001 m\n"
        for joint in ('["33 mm", "44 mm", 0]', "[0.0, 0.065, 0]", '["-3.3 cm", "0 mm", "-4.4 cm"]')
    ]
    joint = reread(tmp_path, after).parameters.joint
    np.testing.assert_allclose(np.linalg.norm(joint, axis=1), [0.055, 0.065, 0.055], rtol=1e-11)


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


def test_inline_tables_and_dotted_keys_stay_what_they_are(tmp_path: Path) -> None:
    text = published()
    for table, keys in {
        '[platform]\nmass = "1.5 kg"': 'platform = { mass = "1.5 kg" }',
        '[belt]\nspecific_stiffness = "2.42e6 N/m"': 'belt.specific_stiffness = "2.42e6 N/m"',
        'width = "15 mm"': 'belt . "width" = "15 mm"',
    }.items():
        assert table in text
        # Dotted keys and inline tables of the root come before all tables.
        end = text.index("\n", text.index(table) + len(table)) + 1
        line = text[text.index(table) : end].replace(table, keys)
        text = text[: text.index(table)] + text[end:]
        text = text.replace("[link]", line + "[link]", 1)
    text += 'pulley.radius = "30 mm"\nmotor = { gear_ratio = 12 } # own motor\n'
    after = correct(
        tmp_path,
        text,
        platform__mass=Correction(1.4, None, "less"),
        belt__width=Correction(0.016, 1e-4, "wider"),
        axis__3__pulley__radius=Correction(0.031),
        axis__3__pulley__inertia=Correction(1e-4, None, "own"),
        axis__3__motor__gear_ratio=Correction(12.5),
        axis__3__motor__inertia=Correction(1e-5, None, "new"),
        axis__3__belt__width=Correction(0.02),
    )
    comment = "                     # m_p, after equation 24"
    removed, added = changed_lines(text, after)
    assert len(removed) == 4
    assert added == [
        f'platform = {{ mass = "1.4 kg" }}{comment}; less\n',
        'belt . "width" = { value = "16 mm", sigma = "0.1 mm" }                     # w_b, section 2.1; wider\n',
        'pulley.radius = "31 mm"\n',
        'pulley.inertia = "0.0001 kg*m^2"  # own\n',
        'motor = { gear_ratio = 12.5, inertia = "1e-05 kg*m^2"} # own motor; new\n',
        "\n",
        "[axis.belt]\n",
        'width = "20 mm"\n',
    ]


def test_axes_and_effects_on_a_line_each(tmp_path: Path) -> None:
    head = published().split("[[axis]]")[0]
    table = (
        'origin = [0, {y}, 0], direction = [1, 0, 0], joint = ["3 mm", 0, 0], limits = [0, 1.2], '
        "driven_pulley = 1, branch = 1"
    )
    rows = [f"  {{ {table.replace('{y}', y)} }}," for y in ("0", "'-200 mm'", "0.2")]
    axes = "\n".join(["axis = [ # three", rows[0], rows[1] + " # middle", rows[2], "] # all"])
    inline = "effects = { payload = { mass = 0 } } # none\n"
    text = head.replace("[platform]", f"{inline}{axes}\n[platform]", 1)
    after = correct(
        tmp_path,
        text,
        axis__2__origin__y=Correction(-0.21, None, "moved"),
        axis__3__belt__width=Correction(0.02, None, "wider"),
        axis__joint_radius=Correction(0.004),
        effects__payload__mass=Correction(0.3),
        effects__belt_mass__linear_density=Correction(0.06, None, "weighed"),
    )
    removed, added = changed_lines(text, after)
    assert len(removed) == len(added) == 5
    assert added[0].startswith(
        'effects = { payload = { mass = 0.3 }, belt_mass = {linear_density = "0.06 kg/m"}'
    )
    assert added[0].endswith("# none; weighed\n")
    assert added[2].endswith("# middle\n")
    assert "origin = [0, '-210 mm', 0]" in added[2]
    assert added[4] == "] # all; moved; wider\n"


def test_effects_that_stand_apart_or_are_dotted_get_more(tmp_path: Path) -> None:
    apart = (
        edited("[link]\n", "[effects.payload]\nmass = 0.1\n\n[link]\n")
        + "[effects.belt_mass]\nlinear_density = 0.1\n"
    )
    dotted = edited("[platform]\n", "effects.payload.mass = 0.1\n\n[platform]\n")
    for text in (apart, dotted):
        after = correct(
            tmp_path,
            text,
            effects__payload__mass=Correction(0.2),
            effects__cable_stiffness__stiffness=Correction(100.0),
        )
        assert after == text.replace("mass = 0.1\n", "mass = 0.2\n", 1) + (
            '\n[effects.cable_stiffness]\nstiffness = "100 N/m"\n'
        )


def test_windows_ends_of_lines_and_byte_order_marks_are_kept(tmp_path: Path) -> None:
    changes = {
        "platform__mass": Correction(1.4, 0.01, "new"),
        "axis__1__belt__width": Correction(0.02),
        "effects__payload__mass": Correction(0.35, None, "new"),
        "frame__mass": Correction(60.0),
    }
    plain = correct(tmp_path, published(), **changes)
    windows = correct(tmp_path, published().replace("\n", "\r\n"), **changes)
    assert windows == plain.replace("\n", "\r\n")
    assert correct(tmp_path, "\ufeff" + published(), **changes) == "\ufeff" + plain
    save_corrected(
        tmp_path / "robot.toml", tmp_path / "new.toml", {k.replace("__", "."): v for k, v in changes.items()}
    )
    assert (tmp_path / "new.toml").read_bytes().decode() == "\ufeff" + plain


@pytest.mark.parametrize(
    ("path", "correction", "expected"),
    [
        ("platform.mas", Correction(1.0), 'did you mean "platform.mass"?'),
        ("axis.4.belt.width", Correction(1.0), 'did you mean "axis.'),
        ("axis.1.direction", Correction(1.0), "there is no value"),
        ("axis.1.branch", Correction(1.0), "there is no value"),
        ("", Correction(1.0), "there is no value"),
        ("effects.paylod.mass", Correction(1.0), 'did you mean "effects.payload.mass"?'),
        ("platform.mass", Correction(float("nan")), "expected a finite value"),
        ("platform.mass", Correction(1.0, -1.0), "standard deviation of at least 0"),
        ("platform.mass", Correction(1.0, float("inf")), "standard deviation of at least 0"),
        ("platform.mass", Correction(-1.0), "would be rejected: expected a mass greater than 0 kg"),
        ("platform.mass", Correction(1e99), "would be rejected: expected a mass"),
        ("effects.payload.mass", Correction(-1.0), "would be rejected: expected a mass greater than 0 kg"),
        ("axis.joint_radius", Correction(0.1), "joint 1 cannot be changed along its direction: it is 0"),
        ("axis.span", Correction(-0.1), "would be rejected: expected the lower limit first"),
    ],
)
def test_what_cannot_be_corrected_is_refused(
    tmp_path: Path, path: str, correction: Correction, expected: str
) -> None:
    source = tmp_path / "robot.toml"
    source.write_text(published(), encoding="utf-8")
    with pytest.raises(OutputError) as error:
        save_corrected(source, tmp_path / "new.toml", {path: correction})
    assert expected in str(error.value)
    assert str(source) in error.value.where
    assert not (tmp_path / "new.toml").exists()


def test_a_shared_value_that_is_not_there_is_not_added(tmp_path: Path) -> None:
    text = edited('width = "15 mm"', "").replace("branch = ", "belt.width = 0.015\nbranch = ")
    with pytest.raises(OutputError, match="there is no value"):
        correct(tmp_path, text, belt__width=Correction(0.02))


def test_a_joint_cannot_shrink_through_the_centre(tmp_path: Path) -> None:
    with pytest.raises(OutputError, match=r"joint 1 .* it would become 0 m"):
        correct(tmp_path, with_joints(), axis__joint_radius=Correction(0.0))


def test_a_value_is_not_changed_twice(tmp_path: Path) -> None:
    changes = {"axis.1.limits.min": Correction(0.1), "axis.span": Correction(1.3)}
    with pytest.raises(OutputError, match="changed twice") as error:
        corrected_text(PUBLISHED, changes)
    assert error.value.where == f"{PUBLISHED}: axis.1.limits.min"


def test_a_layout_that_cannot_be_kept_is_refused(tmp_path: Path) -> None:
    text = published().replace("[platform]\n", "")
    head, first, rest = text.split("[[axis]]", 2)
    link = '[platform]\nmass = "1.5 kg"\n'
    head = head.replace('mass = "1.5 kg"                     # m_p, after equation 24\n', "")
    with pytest.raises(OutputError, match="keep its layout"):
        correct(tmp_path, f"{head}[[axis]]{first}{link}[[axis]]{rest}", link__mass=Correction(0.6))


def test_what_does_not_read_back_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("pkmodes.robot.corrections.DIGITS_OF_ELEMENTS", 3)
    with pytest.raises(OutputError, match=r"does not read back: expected 1\.20005 .* found 1\.2 "):
        corrected_text(PUBLISHED, {"axis.span": Correction(1.2001)})


def test_the_robot_file_is_never_replaced(tmp_path: Path) -> None:
    source = tmp_path / "robot.toml"
    source.write_text(published(), encoding="utf-8")
    (tmp_path / "link.toml").symlink_to(source)
    (tmp_path / "hard.toml").hardlink_to(source)
    for name in ("robot.toml", "link.toml", "hard.toml", "../" + tmp_path.name + "/robot.toml"):
        with pytest.raises(OutputError, match="replace its own input"):
            save_corrected(source, tmp_path / name, {"platform.mass": Correction(1.4)})
    for name in ("", "absent/new.toml", "a\0b"):
        with pytest.raises(OutputError, match="existing folder"):
            save_corrected(source, tmp_path / name, {"platform.mass": Correction(1.4)})
    assert source.read_text(encoding="utf-8") == published()
    with pytest.raises(RobotFileError, match="no such file"):
        save_corrected(tmp_path / "absent.toml", tmp_path / "new.toml", {})


UNITS = {"m": 1.0, "mm": 1e-3, "inch": 0.0254, None: 1.0}


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], max_examples=40, deadline=None)
@given(st.floats(1e-6, 1e6), st.none() | st.floats(1e-9, 1e3), st.sampled_from(list(UNITS)))
def test_any_value_reads_back(tmp_path: Path, value: float, sigma: float | None, unit: str | None) -> None:
    text = edited('"400 mm"', "0.4" if unit is None else f'"{0.4 / UNITS[unit]} {unit}"')
    quantity = reread(tmp_path, correct(tmp_path, text, link__length=Correction(value, sigma))).quantities[
        "link.length"
    ]
    assert quantity.value == pytest.approx(value, rel=1e-9)
    assert quantity.sigma is None if sigma is None else quantity.sigma == pytest.approx(sigma, rel=5.1e-3)
