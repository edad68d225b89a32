"""Shapers for measured modes alone, within their errors; and what is drawn over a measured spectrum."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from helpers.commands.printed_tables import printed_table
from pkmodes.cli import run
from pkmodes.core.base.errors import MeasurementError
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.machine.shaping import measured_shapers
from pkmodes.machine.shaping.measured_modes import of_measured
from pkmodes.machine.shaping.measured_spectrum import read_spectrum
from pkmodes.machine.shaping.results import Candidate
from pkmodes.pages.report.shaper_curves import frequency_figure

KINDS = ["zv", "mzv", "ei", "2hump_ei", "3hump_ei"]
TABLE = """# drives: held
pose,frequency,sigma,damping,sigma_damping
front,41.2,0.4,0.05,0.01
front,63.1,0.3,0.03,0.01
rear,44.9,0.5,0.04,0.01
rear,69.6,0.3,0.03,0.01
"""


def table(*rows: tuple[str, float, float, float, float], **others: Any) -> Measurements:
    """Return measurements of rows of pose, frequency, sigma, damping ratio and its sigma."""
    pose, f, sigma, zeta, spread = zip(*rows, strict=True)
    return Measurements.from_rows(pose, f, sigma, damping=zeta, damping_sigma=spread, **others)


def amplitude_after(one: Candidate, f: np.ndarray, zeta: np.ndarray) -> np.ndarray:
    """Return the amplitude at the last impulse of oscillators that the impulses hit one after the other.

    By their states: an impulse changes the velocity, and in between displacement and velocity follow the solution of
    the free oscillator.  Relative to a single impulse of the same sum at time 0.
    """
    omega = 2.0 * np.pi * f
    damped = omega * np.sqrt(1.0 - zeta**2)
    x, v, before = np.zeros_like(f), np.zeros_like(f), 0.0
    for a, t in zip(one.shaper.amplitudes, one.shaper.delays, strict=True):
        dt = t - before
        decay, c, s = np.exp(-zeta * omega * dt), np.cos(damped * dt), np.sin(damped * dt)
        b = (v + zeta * omega * x) / damped
        x, v = (
            decay * (x * c + b * s),
            decay * ((b * damped - zeta * omega * x) * c - (x * damped + zeta * omega * b) * s),
        )
        v, before = v + a, t
    return np.asarray(np.hypot(x, (v + zeta * omega * x) / damped) * damped)


def test_zv_leaves_of_a_band_what_the_closed_form_says() -> None:
    """|cos(pi f / (2 f0))| is equal at both ends where f0 is their middle; 4 % is two standard deviations."""
    choice = measured_shapers(table(("a", 50.0, 1.0, 0.0, 0.0)), ["zv"])
    low, high = 50.0 * np.exp(-0.04), 50.0 * np.exp(0.04)
    (one,) = choice.candidates
    assert "worst, 2 \u03c3 [%]" in choice._repr_html_()
    assert one.frequencies[0] == pytest.approx(0.5 * (low + high), rel=1e-4)
    assert one.left.worst == pytest.approx(np.sin(0.5 * np.pi * (high - low) / (high + low)), rel=1e-3)
    left, most = of_measured(choice).left_of(one)
    assert left[0] == pytest.approx(abs(np.cos(0.5 * np.pi * 50.0 / one.frequencies[0])), abs=1e-9)
    assert most[0] == one.left.worst


def test_no_movement_leaves_more_whatever_the_shares_of_the_modes() -> None:
    """Two thousand machines within the errors at two poses, with shares of modes that nobody measured."""
    rows = [
        ("front", 41.0, 0.6, 0.05, 0.015),
        ("front", 63.0, 0.3, 0.03, 0.008),
        ("rear", 45.0, 0.5, 0.04, 0.01),
        ("rear", 70.0, 0.3, 0.03, 0.01),
    ]
    choice = measured_shapers(table(*rows))
    assert not any(one.follows_pose for one in choice.candidates)
    values = np.array([row[1:] for row in rows])
    rng = np.random.default_rng(11)
    x, y = rng.uniform(-2.0, 2.0, (2, 2000, 4))
    f, zeta = values[:, 0] + x * values[:, 1], values[:, 2] + y * values[:, 3]
    weights = rng.exponential(size=f.shape) ** 3
    for one in choice.candidates:
        v = amplitude_after(one, f, zeta)
        for pose in (slice(0, 2), slice(2, 4)):
            w = weights[:, pose]
            together = np.linalg.norm(w * v[:, pose], axis=1) / np.linalg.norm(w, axis=1)
            # Five frequencies are looked at within the errors: between them up to 2 % more may be left.
            assert together.max() <= one.left.worst * 1.02 + 1e-4, one.kind
        assert v.max() > 0.9 * one.left.worst, one.kind
        left, most = of_measured(choice).left_of(one)
        np.testing.assert_allclose(left, amplitude_after(one, values[:, 0], values[:, 2]), atol=1e-9)
        np.testing.assert_array_less(v.max(axis=0), most * 1.02 + 1e-4)


def test_a_shaper_is_for_all_poses_of_the_table() -> None:
    """One of a pose alone is shorter, and would leave more than it may at the other."""
    near, far = ("near", 50.0, 0.1, 0.02, 0.0), ("far", 62.0, 0.1, 0.02, 0.0)
    alone, both = measured_shapers(table(near)), measured_shapers(table(near, far))
    assert alone.candidates[alone.recommended].kind == "zv"
    best = both.candidates[both.recommended]
    assert best.duration > alone.candidates[alone.recommended].duration
    assert of_measured(both).left_of(best)[1].max() <= 0.1
    short = alone.candidates[alone.recommended]
    assert amplitude_after(short, np.array([62.0]), np.array([0.02]))[0] > 0.1


def test_a_larger_sigma_needs_a_longer_shaper() -> None:
    durations = []
    for sigma in (0.1, 1.0, 4.0):
        choice = measured_shapers(table(("a", 50.0, sigma, 0.02, 0.0)), KINDS)
        durations.append(choice.candidates[choice.recommended].duration)
    assert durations[1] == pytest.approx(durations[0], rel=0.01)  # both zv
    assert durations[2] > 1.5 * durations[1]


def test_of_an_unknown_damping_ratio_all_up_to_ten_per_cent_are_covered() -> None:
    data = Measurements.from_rows(["a"], [50.0], [0.2])
    choice = measured_shapers(data, KINDS)
    assert any(
        note.startswith("no mode has a damping ratio: whichever from 0 to 10 %") for note in choice.notes
    )
    zeta = np.linspace(0.0, 0.1, 41)
    stated = measured_shapers(data, KINDS, damping=0.03)
    assert "no mode has a damping ratio: 3 % is taken instead, by --damping" in stated.notes
    for one, other in zip(choice.candidates, stated.candidates, strict=True):
        assert amplitude_after(one, np.full(41, 50.0), zeta).max() <= one.left.worst * 1.001
        assert other.damping_ratio == pytest.approx(0.03)
        assert other.left.worst < one.left.worst


def test_modes_of_held_motors_count_where_there_are_any() -> None:
    rows = [("a", 41.0, 0.2, 0.02, 0.0), ("b", 80.0, 0.2, 0.02, 0.0)]
    mixed = measured_shapers(table(*rows, drives=["held", "free"]), ["zv"])
    assert of_measured(mixed).rows.tolist() == [0]
    assert any(note.startswith("1 pose is left out: motors turned freely there") for note in mixed.notes)
    free = measured_shapers(table(*rows), ["zv"])
    assert of_measured(free).rows.tolist() == [0, 1]
    assert any(note.startswith("the table does not say that motors were held") for note in free.notes)
    held = measured_shapers(table(*rows, drives="held"), ["zv"])
    assert not any("held" in note for note in held.notes)


def test_the_lowest_modes_at_each_pose_count_if_so_many_are_asked_for() -> None:
    rows = [("a", f, 0.2, 0.02, 0.0) for f in (60.0, 40.0, 50.0)] + [("b", 45.0, 0.2, 0.02, 0.0)]
    choice = measured_shapers(table(*rows), modes=2)
    assert of_measured(choice).rows.tolist() == [1, 2, 3]
    assert "zv*zv" in [one.kind for one in choice.candidates]
    assert "zv*zv*zv" not in [one.kind for one in choice.candidates]


def test_a_turn_is_rounded_by_half_the_variance_of_the_impulses() -> None:
    """Against a path that turns back with 1 m/s^2, as the shaper moves it, at the moment of the turn."""
    choice = measured_shapers(table(("a", 40.0, 0.2, 0.05, 0.0)), KINDS)
    for one in choice.candidates:
        a, t = one.shaper
        middle = float((a * t).sum())
        assert one.rounding == pytest.approx(float((a * 0.5 * (middle - t) ** 2).sum()), rel=1e-12)


# What the command writes.


@pytest.fixture
def modes(tmp_path: Path) -> str:
    file = tmp_path / "modes.csv"
    file.write_text(TABLE, encoding="utf-8")
    return str(file)


def resonances(folder: Path, modes: tuple[tuple[float, float, float], ...]) -> Path:
    """Write a spectrum as Klipper's with peaks at modes of frequency, damping ratio and share along x and y."""
    f = np.arange(0.0, 200.0, 1.6)
    with np.errstate(divide="ignore", invalid="ignore"):
        parts = [share * f**2 / (f0**2 - f**2 + 2j * zeta * f * f0) for f0, zeta, share in modes]
    x = 1e3 * np.abs(np.sum(parts, axis=0)) ** 2 + 1.0
    rows = np.column_stack([f, x, 0.25 * x, np.full_like(f, 2.0), 1.25 * x + 2.0])
    file = folder / "resonances_x.csv"
    lines = [",".join(f"{value:.6g}" for value in row) for row in rows]
    file.write_text("freq,psd_x,psd_y,psd_z,psd_xyz\n" + "\n".join(lines) + "\n", encoding="utf-8")
    return file


def test_the_command_says_what_is_left_of_each_mode_and_what_is_not_known(
    modes: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file, page = tmp_path / "s.json", tmp_path / "s.html"
    assert run(["shaper", "--measured", modes, "--json", str(file), "--report", str(page)]) == 0
    printed = capsys.readouterr().out
    found = json.loads(file.read_text(encoding="utf-8"))
    assert (found["drives"], found["poses"], found["modes"], found["spectrum"]) == ("held", 2, 4, None)
    best = found["shapers"][found["recommended"]]
    titles = ("shaper", "design [Hz]", "lasts [ms]", "worst [%]", "worst, 2 sigma [%]", "rounds [um]")
    rows = printed_table(printed, *titles, "max_accel")
    assert rows[found["recommended"]][0] == f"{best['kind']} *"
    for row, one in zip(rows, found["shapers"], strict=True):
        assert row[3:5] == [f"{100.0 * one['left'][key]:.2f}" for key in ("worst", "worst_uncertain")]
        assert row[5] == f"{1e6 * one['rounding_s2']:.1f}"
    assert [one["line"] for one in found["measured_modes"]] == [3, 4, 5, 6]
    assert (
        max(one["left_uncertain"] for one in found["measured_modes"])
        == best["left"]["worst_uncertain"]
        <= 0.1
    )
    said = " ".join(printed.split())
    assert "How much each mode takes part in a movement is not in the table" in said
    assert "4 measured modes at 2 poses" in said
    text = page.read_text(encoding="utf-8")
    assert "The measured modes" in text
    assert "Over frequency" in text
    assert "the largest one without a shaper" not in text  # shares of a movement, which a table cannot give


def test_curves_over_the_spectrum_are_those_of_the_closed_forms(modes: str, tmp_path: Path) -> None:
    """Undamped, by the formulas of Singhose et al. (1997); the spectrum is the sum of its directions."""
    Path(modes).write_text(
        "# drives: held\npose,frequency,sigma,damping\na,40,0.2,0\na,66,0.2,0\n", encoding="utf-8"
    )
    spectrum = resonances(tmp_path, ((40.0, 0.04, 1.0), (66.0, 0.03, 0.5)))
    out, file, figure = tmp_path / "s.csv", tmp_path / "s.json", tmp_path / "s.svg"
    arguments = [
        "--shapers",
        ",".join(KINDS),
        "--out",
        str(out),
        "--json",
        str(file),
        "--figure",
        str(figure),
    ]
    assert run(["shaper", "--measured", modes, "--spectrum", str(spectrum), *arguments]) == 0
    found = json.loads(file.read_text(encoding="utf-8"))
    written = np.genfromtxt(out, delimiter=",", names=True, deletechars="")
    given = np.genfromtxt(spectrum, delimiter=",", names=True)[1:]  # 0 Hz is left out
    np.testing.assert_allclose(written["frequency"], given["freq"])
    np.testing.assert_allclose(written["density"], given["psd_xyz"], rtol=1e-5)
    V = 0.05
    X = np.cbrt(V**2 * (np.sqrt(1.0 - V**2) + 1.0))
    two = (3.0 * X**2 + 2.0 * X + 3.0 * V**2) / (16.0 * X)
    three = (1.0 + 3.0 * V + 2.0 * np.sqrt(2.0 * (V**2 + V))) / 16.0
    forms = {  # of x, the phase of half a period
        "zv": lambda x: np.cos(0.5 * x),
        "mzv": lambda x: (np.sqrt(2.0) + 2.0 * np.cos(0.75 * x)) / (2.0 + np.sqrt(2.0)),
        "ei": lambda x: 0.5 * (1.0 + V) * np.cos(x) + 0.5 * (1.0 - V),
        "2hump_ei": lambda x: 2.0 * two * np.cos(1.5 * x) + (1.0 - 2.0 * two) * np.cos(0.5 * x),
        "3hump_ei": lambda x: (
            2.0 * three * np.cos(2.0 * x) + 0.5 * (1.0 - V) * np.cos(x) + 0.5 * (1.0 + V) - 2.0 * three
        ),
    }
    for one in found["shapers"]:
        x = np.pi * written["frequency"] / one["frequencies_hz"][0]
        np.testing.assert_allclose(written[f"left:{one['kind']}"], np.abs(forms[one["kind"]](x)), atol=1e-9)
    assert found["spectrum"]["peak_hz"] == pytest.approx(40.0)
    assert found["spectrum"]["at_mode"] is True
    assert figure.read_text(encoding="utf-8").startswith("<?xml")


def test_the_figure_shows_of_the_spectrum_what_the_recommended_shaper_leaves(tmp_path: Path) -> None:
    """Of the amplitude, over the highest peak: what moves the machine at low frequencies is no peak."""
    spectrum = resonances(tmp_path, ((50.0, 0.04, 1.0),))
    lines = spectrum.read_text(encoding="utf-8").splitlines()
    lines[2] = "1.6,1e9,0,0,1e9"
    spectrum.write_text("\n".join(lines), encoding="utf-8")
    choice = measured_shapers(table(("a", 50.0, 0.2, 0.0, 0.0)), ["zv", "mzv"])
    drawing, caption = frequency_figure(choice, read_spectrum(spectrum))
    seen = {series.name: series for panel in drawing.wide.panels for series in panel.series}
    before, after = seen["measured spectrum"], seen["after the recommended shaper"]
    near = before.x > 25.0
    assert before.y[near].max() == pytest.approx(100.0)
    assert before.x[near][np.argmax(before.y[near])] == pytest.approx(49.6)
    given = np.genfromtxt(spectrum, delimiter=",", names=True)[1 : len(before.x) + 1]
    total = given["psd_x"] + given["psd_y"] + given["psd_z"]
    np.testing.assert_allclose(before.y[near], 100.0 * np.sqrt(total[near] / total[near].max()))
    best = choice.candidates[choice.recommended]
    assert best.kind == "zv"
    left = np.abs(np.cos(0.5 * np.pi * before.x / best.frequencies[0]))
    np.testing.assert_allclose(after.y, before.y * left, atol=1e-6)
    assert "summed over x, y and z" in caption
    (dots,) = (seen[name] for name in seen if name == "measured modes")
    assert dots.x.tolist() == [50.0]


def test_the_shapers_of_a_robot_are_drawn_over_a_spectrum_too(tmp_path: Path) -> None:
    spectrum, file, page = (
        resonances(tmp_path, ((45.0, 0.04, 1.0),)),
        tmp_path / "s.json",
        tmp_path / "s.html",
    )
    grid = ["--grid", "x=0.05:0.25:2,y=0.1", "--shapers", "zv,mzv", "--spectrum", str(spectrum)]
    robot = str(Path(__file__).parents[3] / "robots/corexy-printer.toml")
    assert run(["shaper", robot, *grid, "--json", str(file), "--report", str(page)]) == 0
    assert json.loads(file.read_text(encoding="utf-8"))["spectrum"]["peak_hz"] == pytest.approx(44.8)
    assert "Over the measured spectrum" in page.read_text(encoding="utf-8")


def test_a_peak_that_is_no_measured_mode_is_said(
    modes: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    spectrum = resonances(tmp_path, ((41.2, 0.05, 0.5), (52.8, 0.03, 1.0)))
    assert run(["shaper", "--measured", modes, "--spectrum", str(spectrum), "--shapers", "zv,mzv"]) == 0
    said = " ".join(capsys.readouterr().out.split())
    assert (
        "The highest peak of the spectrum, at 52.8 Hz, is at none of the modes: a mode may be missing" in said
    )


def test_spectra_that_are_none_are_refused_with_what_to_do(tmp_path: Path) -> None:
    raw = tmp_path / "raw_data_x.csv"
    raw.write_text("#time,accel_x,accel_y,accel_z\n" + "".join(f"{k / 3200},1,2,{k % 3}\n" for k in range(9)))
    with pytest.raises(MeasurementError, match="found signals in time") as error:
        read_spectrum(raw)
    assert "OUTPUT=resonances" in str(error.value)
    logarithm = tmp_path / "log.csv"
    logarithm.write_text("freq,psd_x\n10,-3.0\n20,-2.0\n30,-4.0\n")
    with pytest.raises(MeasurementError, match="not its logarithm"):
        read_spectrum(logarithm)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ([], "give ROBOT.toml, or --measured MODES.csv"),
        (["robot.toml", "--measured", "MODES"], "--measured takes the place of ROBOT.toml: give one of them"),
        (["--measured", "MODES", "--grid", "x=0:1:3"], "--grid is for a robot file"),
        (["modes.csv"], 'expected ROBOT.toml, found "modes.csv": measured modes are given by --measured'),
        (["robot.toml", "--damping", "5 %"], "--damping is for measured modes"),
        (
            ["--measured", "MODES", "--damping", "1.5"],
            "expected a damping ratio from 0 to below 1, found 1.5 (--damping)",
        ),
        (
            ["--measured", "MODES", "--shapers", "zv*zv*zv"],
            "zv*zv*zv is for 3 modes, but only 2 count (--shapers)",
        ),
        # Refused before a file is read: there is none.
        (["none.toml", "--shapers", "zv,"], 'names separated by commas, found "zv," (--shapers)'),
        (
            ["--measured", "none.csv", "--shapers", "zv,"],
            'names separated by commas, found "zv," (--shapers)',
        ),
        (["--measured", "MODES", "--out", "curves.txt"], "expected a name that ends in .csv"),
    ],
)
def test_wrong_options_are_refused(
    modes: str, arguments: list[str], message: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["shaper", *(modes if one == "MODES" else one for one in arguments)]) == 2
    assert message in " ".join(capsys.readouterr().err.split())
