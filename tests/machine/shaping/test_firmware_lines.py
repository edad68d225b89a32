"""Lines for firmware: the impulses that each makes of them, by its own formulas, are those of the design."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from pkmodes.machine.shaping import KINDS, residual, shaper
from pkmodes.machine.shaping.firmware import (
    VERSIONS,
    commands_by_firmware,
    configuration_lines,
    lines_by_firmware,
    runtime_command,
)
from pkmodes.machine.shaping.firmware_impulses import firmware_shaper
from pkmodes.machine.shaping.version_lines import lines_by_version

ROOT = Path(__file__).parents[3]
F, ZETA = 31.27, 0.02


def lines(kind: str, f: tuple[float, ...] = (F,)) -> dict[str, str | None]:
    return lines_by_firmware(kind, f, ZETA, shaper(kind, f if len(f) > 1 else f[0], ZETA))


@pytest.mark.parametrize("kind", KINDS)
def test_klipper_gets_a_section_with_the_names_of_its_manual(kind: str) -> None:
    text = lines(kind)["klipper"]
    if kind == "zvdd":
        assert text is None
        return
    assert text is not None
    assert text.splitlines() == [
        "[input_shaper]",
        f"shaper_type: {kind}",
        "shaper_freq_x: 31.27",
        "shaper_freq_y: 31.27",
        "damping_ratio_x: 0.0200",
        "damping_ratio_y: 0.0200",
    ]


@pytest.mark.parametrize("kind", KINDS)
def test_klipper_changes_the_shaper_during_a_print_to_what_the_section_says(kind: str) -> None:
    """Names and values of ``SET_INPUT_SHAPER``, which it splits at blanks and equal signs (klipper3d.org/G-Codes)."""
    f = {
        name: commands_by_firmware(kind, (F,), ZETA, shaper(kind, F, ZETA))[name]
        for name in ("klipper", "marlin")
    }
    assert f["marlin"] == lines(kind)["marlin"]
    section = lines(kind)["klipper"]
    if section is None:
        assert f["klipper"] is None
        return
    name, *parts = (f["klipper"] or "").split()
    assert name == "SET_INPUT_SHAPER"
    given = dict(part.split("=") for part in parts)
    declared = dict(line.split(": ") for line in section.splitlines()[1:])
    assert {key.lower(): value for key, value in given.items()} == declared


def test_marlin_gets_m593_for_zv_and_fixed_time_motion_for_the_others() -> None:
    assert lines("zv")["marlin"] == "M593 F31.27 D0.0200"
    assert lines("mzv")["marlin"] == "M493 S1 X Y C8 A31.27 I0.0200"
    assert lines("2hump_ei")["marlin"] == "M493 S1 X Y C6 A31.27 I0.0200 Q0.05"
    assert lines("zv*zv", (20.0, 33.0))["marlin"] is None
    # It accepts no damping ratio below 1 %.
    assert (
        lines_by_firmware("zvd", (F,), 0.005, shaper("zvd", F, 0.005))["marlin"]
        == "M493 S1 X Y C2 A31.27 I0.0100"
    )


@pytest.mark.parametrize("kind", ["zv", "mzv", "2hump_ei"])
def test_a_damping_ratio_of_zero_is_no_line_to_paste(kind: str) -> None:
    """Klipper and Marlin get none and take their own; RepRapFirmware gets the impulses themselves."""
    one = shaper(kind, F, 0.0)
    for version in VERSIONS:
        for text in (
            configuration_lines(version, kind, (F,), 0.0, one),
            runtime_command(version, kind, (F,), 0.0, one),
        ):
            assert text is not None
            assert "damping" not in text.lower()
            assert not re.search(r" [DSIJ]0\.0", text)
            assert ('P"custom"' in text) == version.startswith("reprapfirmware")
    assert configuration_lines("klipper", kind, (F,), 0.0, one) == (
        f"[input_shaper]\nshaper_type: {kind}\nshaper_freq_x: 31.27\nshaper_freq_y: 31.27"
    )


def test_lines_without_a_damping_ratio_are_judged_with_that_of_the_firmware() -> None:
    """zv of Klipper for a ratio of 0.1, by hand, on an undamped mode: |1 + K exp(i pi f/f0 ...)| / (1 + K)."""
    choice = pkmodes.load(ROOT / "robots/corexy-printer.toml").shapers([[0.05, 0.05]], "zv", modes=1)
    f = float(choice.ringing.frequencies[0, 0])
    for option, ratio in (("klipper", 0.1), ("marlin", 0.15)):
        decay = np.exp(-np.pi * ratio / np.sqrt(1.0 - ratio**2))
        delay = 0.5 / (choice.best.frequencies[0] * np.sqrt(1.0 - ratio**2))
        expected = abs(1.0 + decay * np.exp(2j * np.pi * f * delay)) / (1.0 + decay)
        (line,) = [line for line in lines_by_version(choice) if line.option == option]
        assert line.worst_at_pose == pytest.approx(expected, rel=1e-6)
        assert line.worst_at_pose > 0.15
    # Asked for by name, the shaper is designed for that ratio, and the line has it.
    asked = pkmodes.load(ROOT / "robots/corexy-printer.toml").shapers(
        [[0.05, 0.05]], "zv", firmware="klipper"
    )
    assert "damping_ratio_x: 0.1000" in str(lines_by_version(asked)[0].lines)
    assert any("shapers are designed for 0.1, which Klipper takes by default" in note for note in asked.notes)


def test_reprapfirmware_gets_its_names_where_it_has_them() -> None:
    assert lines("zvd")["reprapfirmware"] == 'M593 P"zvd" F31.27 S0.0200'
    assert lines("3hump_ei")["reprapfirmware"] == 'M593 P"ei3" F31.27 S0.0200'


@pytest.mark.parametrize(("kind", "f"), [("zv", (F,)), ("ei", (F,)), ("zv*zv", (20.0, 33.0))])
def test_reprapfirmware_gets_the_impulses_where_it_has_no_name(kind: str, f: tuple[float, ...]) -> None:
    """H: amplitudes of all but the last; T: delays of all but the first, in s (its manual, version 3.6)."""
    text = lines(kind, f)["reprapfirmware"]
    assert text is not None
    found = re.fullmatch(r'M593 P"custom" H([\d.:]+) T([\d.:]+)', text)
    assert found is not None
    H, T = ([float(number) for number in group.split(":")] for group in found.groups())
    one = shaper(kind, f if len(f) > 1 else f[0], ZETA)
    np.testing.assert_allclose([*H, 1.0 - sum(H)], one.amplitudes, rtol=0, atol=3e-4)
    np.testing.assert_allclose([0.0, *T], one.delays, rtol=0, atol=1e-5)


def test_reprapfirmware_takes_no_more_than_five_impulses_and_none_that_coincide() -> None:
    assert lines("zv*zv*zv", (20.0, 33.0, 47.0))["reprapfirmware"] is None
    assert lines("zv*zv", (20.0, 20.0))["reprapfirmware"] is None


def test_what_firmware_would_refuse_is_not_printed() -> None:
    """Limits of Klipper's damping ratios; of Marlin's frequencies and damping ratios in fixed-time motion."""

    def of(kind: str, f: float, zeta: float) -> dict[str, str | None]:
        return lines_by_firmware(kind, (f,), zeta, shaper(kind, f, zeta))

    assert of("3hump_ei", F, 0.2)["klipper"] is not None
    assert of("3hump_ei", F, 0.21)["klipper"] is None
    assert of("mzv", 19.9, 0.02)["marlin"] is None
    assert of("mzv", F, 0.26)["marlin"] is None
    assert of("zv", 19.9, 0.02)["marlin"] == "M593 F19.90 D0.0200"
    # With damping its humps are those of other formulas: the impulses instead of the name.
    assert str(of("2hump_ei", F, 0.1)["reprapfirmware"]).startswith('M593 P"custom" H')


def parsed_m493(text: str | None, *, by_axis: bool) -> dict[str, tuple[float, ...]]:
    """Shaper, frequency, ratio and tolerance of X and Y, as the two parsers of Marlin read them (M493.cpp).

    Before October 2025 X and Y have values, and Y letters of its own; afterwards they are flags of the axes.
    """
    assert text is not None
    name, *words = text.split()
    given = {word[0]: float(word[1:]) if word[1:] else None for word in words}
    assert name == "M493"
    assert given.pop("S") == 1
    letters = {"X": "CAIQ", "Y": "CAIQ"} if by_axis else {"X": "XAIQ", "Y": "YBJR"}
    if by_axis:
        assert given.pop("X") is given.pop("Y") is None
    assert set(given) <= set(letters["X"] + letters["Y"])
    return {
        axis: tuple(given[letter] or 0.0 for letter in each if letter in given)
        for axis, each in letters.items()
    }


@pytest.mark.parametrize("kind", ["zvd", "mzv", "3hump_ei"])
def test_marlin_before_october_2025_gets_the_letters_of_its_own(kind: str) -> None:
    one = shaper(kind, F, ZETA)
    newer = parsed_m493(runtime_command("marlin", kind, (F,), ZETA, one), by_axis=True)
    older = parsed_m493(runtime_command("marlin-2025-09", kind, (F,), ZETA, one), by_axis=False)
    number = {"zvd": 2.0, "mzv": 8.0, "3hump_ei": 7.0}[kind]
    assert (
        newer == older == {axis: (number, F, ZETA, *([0.05] if kind == "3hump_ei" else [])) for axis in "XY"}
    )
    assert runtime_command("marlin-2025-09", "zv", (F,), ZETA, one) == runtime_command(
        "marlin", "zv", (F,), ZETA, one
    )


def test_reprapfirmware_before_3_6_gets_sums_and_times_between_impulses() -> None:
    """H: share of the acceleration after each impulse but the last; T: how long each lasts [s] (source of 3.5.3)."""
    one = shaper("zv*zv", (20.0, 33.0), ZETA)
    text = runtime_command("reprapfirmware-3.5", "zv*zv", (20.0, 33.0), ZETA, one)
    found = re.fullmatch(r'M593 P"custom" H([\d.:]+) T([\d.:]+)', text or "")
    assert found is not None
    H, T = ([float(number) for number in group.split(":")] for group in found.groups())
    np.testing.assert_allclose(np.diff([0.0, *H, 1.0]), one.amplitudes, rtol=0, atol=3e-4)
    np.testing.assert_allclose([0.0, *np.cumsum(T)], one.delays, rtol=0, atol=3e-5)


def test_reprapfirmware_gets_the_impulses_of_mzv_where_its_own_are_in_reverse_order() -> None:
    assert str(lines("mzv")["reprapfirmware"]).startswith('M593 P"custom" H')
    hardly_damped = lines_by_firmware("mzv", (F,), 0.0005, shaper("mzv", F, 0.0005))["reprapfirmware"]
    assert hardly_damped == 'M593 P"mzv" F31.27 S0.0005'


def test_klipper_before_september_2025_has_no_limit_of_damping_ratios() -> None:
    one = shaper("3hump_ei", F, 0.3)
    assert configuration_lines("klipper", "3hump_ei", (F,), 0.3, one) is None
    assert "shaper_type: 3hump_ei" in str(configuration_lines("klipper-2025-08", "3hump_ei", (F,), 0.3, one))
    assert configuration_lines("klipper-2025-08", "zvdd", (F,), 0.0, shaper("zvdd", F, 0.0)) is None


def test_versions_that_differ_are_offered_with_what_each_leaves() -> None:
    """What is left is that of the impulses of each version, of a machine with one mode beside the design."""
    model = pkmodes.load(ROOT / "robots/corexy-printer.toml").with_values({"damping.ratio": 0.06})
    choice = model.shapers([[0.05, 0.05]], "2hump_ei", modes=1)
    best, at = choice.candidates[0], choice.ringing
    found = {one.option: one for one in lines_by_version(choice)}
    assert list(found) == [
        "klipper",
        "klipper-2025-08",
        "marlin",
        "marlin-2025-09",
        "reprapfirmware",
        "reprapfirmware-3.5",
    ]
    assert found["klipper"].version == "Klipper from 22 September 2025 (v0.13.0-273)"
    assert found["klipper-2025-08"].version == "Klipper before 22 September 2025 (v0.13.0-273)"
    for option in ("klipper", "klipper-2025-08", "marlin"):
        made = firmware_shaper(option, "2hump_ei", best.frequencies[0], best.damping_ratio)
        left = residual(made, at.frequencies, at.damping_ratios)[0, 0]
        assert found[option].worst == pytest.approx(left, rel=1e-9, abs=1e-12)
    assert found["klipper"].worst != pytest.approx(found["klipper-2025-08"].worst, rel=0.1)
    # Asked for by name, the design is for the impulses of that version.
    asked = model.shapers([[0.05, 0.05]], "2hump_ei", modes=1, firmware="klipper")
    made = firmware_shaper("klipper", "2hump_ei", asked.candidates[0].frequencies[0], best.damping_ratio)
    np.testing.assert_allclose(asked.candidates[0].shaper.delays, made.delays, rtol=1e-12)
    assert any(
        "2hump_ei is compared with the impulses that Klipper from 31 March 2026" in note
        for note in asked.notes
    )
    older = model.shapers([[0.05, 0.05]], "2hump_ei", modes=1, firmware="klipper-2025-08")
    assert older.candidates[0].frequencies == best.frequencies
