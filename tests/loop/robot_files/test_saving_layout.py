"""The corrected robot keeps the layout of its file: tables, vectors, comments and ends of lines."""

from __future__ import annotations

from pathlib import Path

from helpers.robots.corrected_files import changed_lines, correct
from helpers.robots.robot_text import edited, published
from pkmodes.loop.robot_files.saving import Correction, save_corrected


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
