"""Lines for firmware: the impulses that each makes of them, by its own formulas, are those of the design."""

from __future__ import annotations

import re

import numpy as np
import pytest

from pkmodes.shaping import KINDS, shaper
from pkmodes.shaping.firmware import command, firmware

F, ZETA = 31.27, 0.02


def lines(kind: str, f: tuple[float, ...] = (F,)) -> dict[str, str | None]:
    return firmware(kind, f, ZETA, shaper(kind, f if len(f) > 1 else f[0], ZETA))


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
    f = {name: command(kind, (F,), ZETA, shaper(kind, F, ZETA))[name] for name in ("klipper", "marlin")}
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
    assert firmware("zvd", (F,), 0.0, shaper("zvd", F, 0.0))["marlin"] == "M493 S1 X Y C2 A31.27 I0.0100"


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
        return firmware(kind, (f,), zeta, shaper(kind, f, zeta))

    assert of("3hump_ei", F, 0.2)["klipper"] is not None
    assert of("3hump_ei", F, 0.21)["klipper"] is None
    assert of("mzv", 19.9, 0.02)["marlin"] is None
    assert of("mzv", F, 0.26)["marlin"] is None
    assert of("zv", 19.9, 0.02)["marlin"] == "M593 F19.90 D0.0200"
    # With damping its humps are those of other formulas: the impulses instead of the name.
    assert str(of("2hump_ei", F, 0.1)["reprapfirmware"]).startswith('M593 P"custom" H')
