"""Shapers over settings: modes by closed forms, what is left by simulated motion, layers by hand, bad input."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import pkmodes
from helpers.commands.printed_tables import printed_table
from helpers.pages.page_reading import read
from pkmodes.cli import run
from pkmodes.core.base.errors import PkmodesError
from pkmodes.machine.shaping import Shaper, residual
from pkmodes.machine.shaping.results import Choice

ROOT = Path(__file__).parents[3]
PRINTER = ROOT / "robots/corexy-printer.toml"
PAYLOAD = "effects.payload.mass"
MASSES = np.linspace(0.0, 1.2, 4)
POSE = np.array([0.06, 0.21])
POSES = np.array([POSE, [0.15, 0.1], [0.25, 0.25]])


@pytest.fixture(scope="module")
def printer() -> pkmodes.Model:
    return pkmodes.load(PRINTER)


@pytest.fixture(scope="module")
def choice(printer: pkmodes.Model) -> Choice:
    return printer.shapers(POSES, ["zv", "mzv"], settings={PAYLOAD: MASSES}, height=(0.0, 0.2))


def by_hand(pose: np.ndarray, payload: float) -> tuple[np.ndarray, np.ndarray]:
    """M and K of tool head and gantry on the four runs of the robot file's belts, motors held."""
    x, y = pose
    M = np.diag([0.5 + payload, 0.5 + payload + 0.7])
    runs = [
        (np.array([1.0, -1.0]), (0.45 + x - y, 0.75 - x + y)),
        (np.array([-1.0, -1.0]), (0.75 - x - y, 0.75 + x + y)),
    ]
    K = sum(6e-3 * 2.6e6 / length * np.outer(g, g) for g, lengths in runs for length in lengths)
    return M, np.asarray(K)


def frequencies_by_hand(pose: np.ndarray, payload: float) -> np.ndarray:
    """Roots of det(K - lambda M), a quadratic."""
    M, K = by_hand(pose, payload)
    a, c = M[0, 0] * M[1, 1], K[0, 0] * K[1, 1] - K[0, 1] ** 2
    b = M[0, 0] * K[1, 1] + M[1, 1] * K[0, 0]
    root = np.sqrt(b**2 - 4.0 * a * c)
    return np.sqrt([(b - root) / (2.0 * a), (b + root) / (2.0 * a)]) / (2.0 * np.pi)


def rings(pose: np.ndarray, payload: float, impulses: Shaper) -> float:
    """Vibration of the tool head after steps of its acceleration along x and y: integrated, then split into modes."""
    M, K = by_hand(pose, payload)
    total = 0.0
    for direction in np.eye(2):
        state, reached, times = np.zeros(4), 0.0, impulses.delays
        for k, start in enumerate(times):
            reached += impulses.amplitudes[k]
            stop = times[k + 1] if k + 1 < len(times) else start + 0.01
            force = -M @ direction * reached

            def rates(_: float, s: np.ndarray, force: np.ndarray = force) -> np.ndarray:
                return np.concatenate([s[2:], np.linalg.solve(M, force - K @ s[:2])])

            state = solve_ivp(rates, (start, stop), state, "DOP853", rtol=1e-10, atol=1e-14).y[:, -1]
        away = state[:2] - np.linalg.solve(K, -M @ direction)
        for f in frequencies_by_hand(pose, payload):
            omega = 2.0 * np.pi * f
            shape = np.array([K[0, 1], omega**2 * M[0, 0] - K[0, 0]])
            shape /= np.sqrt(shape @ M @ shape)
            at, speed = shape @ M @ away, shape @ M @ state[2:]
            total += (shape @ shape) * (at**2 + (speed / omega) ** 2)
    return float(np.sqrt(total))


def test_the_modes_of_every_payload_are_those_of_two_masses_on_belts(choice: Choice) -> None:
    assert choice.schedule is not None
    for mass, step in zip(MASSES, choice.schedule.steps, strict=True):
        assert step.setting.values == {PAYLOAD: mass}
        expected = [frequencies_by_hand(pose, mass) for pose in POSES]
        np.testing.assert_allclose(step.choice.ringing.frequencies, expected, rtol=1e-9)
    lowest = [step.choice.ringing.frequencies[0, 0] for step in choice.schedule.steps]
    assert lowest[0] > 1.3 * lowest[-1]  # what the schedule is for


def test_what_is_left_is_what_a_simulated_machine_still_does(printer: pkmodes.Model) -> None:
    """Of the shaper of each payload, and of the fixed one for all of them, at a pose."""
    whole = printer.shapers(POSE, ["zv", "mzv"], settings={PAYLOAD: [0.0, 1.2]})
    assert whole.schedule is not None
    fixed = whole.candidates[whole.recommended].shaper
    for step in whole.schedule.steps:
        mass = step.setting.values[PAYLOAD]
        before = rings(POSE, mass, Shaper(np.ones(1), np.zeros(1)))
        assert step.choice.unshaped.worst == pytest.approx(before, rel=1e-6)
        assert step.best.left.worst == pytest.approx(
            rings(POSE, mass, step.best.shaper) / before, rel=1e-4, abs=1e-6
        )
        assert step.fixed == pytest.approx(rings(POSE, mass, fixed) / before, rel=1e-4, abs=1e-6)


def test_each_step_is_what_is_recommended_for_a_machine_with_that_payload_alone(
    printer: pkmodes.Model,
) -> None:
    rule: dict[str, Any] = {"kinds": ["zv", "mzv"], "left": 0.22}
    choice = printer.shapers(POSES, settings={PAYLOAD: MASSES}, **rule)
    assert choice.schedule is not None
    worst = []
    for step in choice.schedule.steps:
        alone = printer.with_values(step.setting.values).shapers(POSES, **rule)
        best = alone.candidates[alone.recommended]
        assert (step.best.kind, step.best.frequencies) == (best.kind, best.frequencies)
        assert step.best.left.worst == best.left.worst
        assert step.best.left.rms_uncertain == pytest.approx(best.left.rms_uncertain, rel=1e-12)
        worst.append(best.left.worst * alone.unshaped.worst)
    assert {step.best.kind for step in choice.schedule.steps} == {"zv", "mzv"}
    assert choice.schedule.left.worst == pytest.approx(max(worst) / choice.unshaped.worst, rel=1e-12)


def test_the_fixed_shaper_and_those_that_follow_count_every_payload(choice: Choice) -> None:
    at = choice.ringing
    assert len(at.poses) == len(POSES) * len(MASSES)
    for one in choice.candidates:
        left = residual(one.shaper, at.frequencies, at.damping_ratios) * at.weights
        assert one.left.worst == pytest.approx(
            np.linalg.norm(left, axis=1).max() / np.linalg.norm(at.weights, axis=1).max(), rel=1e-9
        )
    fixed, following = choice.candidates[1], choice.candidates[3]
    assert (fixed.follows_pose, following.follows_pose) == (False, True)
    assert choice.schedule is not None
    assert following.left.worst < choice.schedule.left.worst < 0.8 * fixed.left.worst
    assert choice.unshaped.setting is not None
    assert choice.unshaped.setting.values == {PAYLOAD: 1.2}  # a heavier head on the same belts rings more


def test_a_step_serves_until_halfway_and_says_what_it_leaves_there(
    printer: pkmodes.Model, choice: Choice
) -> None:
    assert choice.schedule is not None
    steps = choice.schedule.steps
    serves = [(0.0, 0.2), (0.2, 0.6), (0.6, 1.0), (1.0, 1.2)]
    np.testing.assert_allclose([one.serves for one in steps], serves, rtol=1e-12, atol=1e-12)
    layers = [(0.0, 1.0 / 30.0), (1.0 / 30.0, 0.1), (0.1, 1.0 / 6.0), (1.0 / 6.0, 0.2)]
    np.testing.assert_allclose([one.heights for one in steps], layers, rtol=1e-12, atol=1e-12)
    for number, halfway in ((0, [0.2]), (1, [0.2, 0.6])):
        found = []
        for mass in halfway:
            modes = printer.with_values({PAYLOAD: mass}).modes(POSES, drives="held")
            weights = np.linalg.norm(modes.vibration_amplitudes, axis=-1)
            left = residual(steps[number].best.shaper, modes.frequencies, 0.0) * weights
            found.append(np.linalg.norm(left, axis=1).max() / np.linalg.norm(weights, axis=1).max())
        assert steps[number].at_ends == pytest.approx(max(found), rel=1e-9)
    assert any(
        note.startswith("halfway between two settings the schedule leaves up to") for note in choice.notes
    )


def test_the_lines_of_a_schedule_say_at_which_layer_they_belong(choice: Choice) -> None:
    assert choice.schedule is not None
    lines = choice.schedule.lines()
    for name, begin in {"klipper": "SET_INPUT_SHAPER ", "marlin": "M493 ", "reprapfirmware": "M593 "}.items():
        text = lines[name]
        assert text is not None
        comments, commands = text.splitlines()[::2], text.splitlines()[1::2]
        assert comments == [
            f"; from the layer at {height} mm on: {PAYLOAD} {masses} kg"
            for height, masses in (
                ("0.0", "0 to 0.2"),
                ("33.3", "0.2 to 0.6"),
                ("100.0", "0.6 to 1"),
                ("166.7", "1 to 1.2"),
            )
        ]
        for command, step in zip(commands, choice.schedule.steps, strict=True):
            assert command.startswith(begin)
            # RepRapFirmware gets the impulses of a machine without damping, the others the frequency.
            design = f"{step.best.frequencies[0]:.2f}"
            assert (design if name != "reprapfirmware" else f"{step.best.shaper.delays[1]:.5f}") in command


def test_a_firmware_that_lacks_a_shaper_gets_the_best_that_it_has(printer: pkmodes.Model) -> None:
    given: dict[str, Any] = {"settings": {PAYLOAD: [0.0, 1.2]}, "left": 0.06}
    free = printer.shapers(POSES, ["mzv", "zv*zv"], **given)
    assert free.schedule is not None
    assert free.schedule.lines()["klipper"] is None
    assert any(
        note.startswith("Klipper and Marlin lack a shaper of the schedule: lines have the best")
        for note in free.notes
    )
    # The lines are those of mzv, the only one compared that it has, at each step.
    commands = str(free.schedule.commands("klipper")).splitlines()[1::2]
    for command, step in zip(commands, free.schedule.steps, strict=True):
        mzv = next(one for one in step.choice.candidates if one.kind == "mzv")
        assert command.startswith(f"SET_INPUT_SHAPER SHAPER_TYPE=mzv SHAPER_FREQ_X={mzv.frequencies[0]:.2f}")
    asked = printer.shapers(POSES, ["mzv", "zv*zv"], firmware="klipper", **given)
    assert asked.schedule is not None
    assert {one.best.kind for one in asked.schedule.steps} == {"mzv"}
    assert asked.schedule.lines()["klipper"] is not None
    assert any(
        "effects.payload.mass 1.2 kg no fixed shaper leaves at most 6 %" in note for note in asked.notes
    )


def test_several_parameters_are_combined_and_have_no_layers(printer: pkmodes.Model) -> None:
    settings = {"toolhead.mass": [0.6, 0.4], PAYLOAD: [0.0, 1.0], "belt.width": 0.009}
    schedule = printer.shapers(POSE, "zv", settings=settings).schedule
    assert schedule is not None
    assert [list(one.setting.values.values()) for one in schedule.steps] == [
        [head, mass, 0.009] for head in (0.4, 0.6) for mass in (0.0, 1.0)
    ]
    assert {(one.serves, one.at_ends, one.heights) for one in schedule.steps} == {(None, None, None)}
    # 0.4 + 1 kg on the belts is more than 0.6 kg; together they count.
    frequencies = [one.choice.ringing.frequencies[0, 0] for one in schedule.steps]
    assert frequencies[3] < frequencies[1] < frequencies[2] < frequencies[0]
    assert "; toolhead.mass 0.4 kg, effects.payload.mass 1 kg, belt.width 0.009 m" in (
        schedule.lines()["klipper"] or ""
    )


def test_one_value_only_changes_the_machine(printer: pkmodes.Model) -> None:
    found = printer.shapers(POSES, "zv", settings={PAYLOAD: 0.3})
    alone = printer.with_values({PAYLOAD: 0.3}).shapers(POSES, "zv")
    assert found.schedule is None
    assert [one.left.worst for one in found.candidates] == [one.left.worst for one in alone.candidates]


def test_a_parameter_that_changes_no_frequency_is_said(printer: pkmodes.Model) -> None:
    notes = printer.shapers(POSES, "zv", settings={"gravity.z": [-9.0, 0.0]}).notes
    assert any(
        note.startswith("no frequency changes with the settings: gravity.z cannot be") for note in notes
    )


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"settings": 3}, "expected values by path, found 3 (settings)"),
        ({"settings": {PAYLOAD: [0.1, 0.1]}}, "the value 0.1 is repeated (settings: effects.payload.mass)"),
        ({"settings": {PAYLOAD: ["1 kg"]}}, "expected numbers in SI units"),
        (
            {"settings": {PAYLOAD: [-1.0, 1.0]}},
            "expected a mass greater than 0 kg, or 0 for no effect, found -1",
        ),
        ({"settings": {"effects.payload": [0.0, 1.0]}}, 'unknown parameter path "effects.payload"'),
        ({"settings": {PAYLOAD: range(201)}}, "expected at most 200 settings, found 201 (settings)"),
        (
            {"settings": {PAYLOAD: [0.0, 1.0]}, "tick": 0.006},
            "at effects.payload.mass 0 kg: the shapers last",
        ),
        ({"settings": {"workspace.x.max": [0.3, 0.05]}}, "found none among 3, at workspace.x.max 0.05 m"),
        ({"height": (0.0, 0.2)}, "layer heights belong to one parameter that takes several values"),
        (
            {"settings": {PAYLOAD: [0.0, 1.0]}, "height": (0.2, 0.0)},
            "expected two heights in m, the lower one",
        ),
        ({"settings": {PAYLOAD: [0.0, 1.0]}, "height": "02"}, 'the lower one first, found "02" (height)'),
    ],
)
def test_bad_settings_are_refused(printer: pkmodes.Model, given: dict[str, Any], message: str) -> None:
    with pytest.raises(PkmodesError) as error:
        printer.shapers(POSES, "zv", **given)
    assert message in str(error.value)


def options(*more: str) -> list[str]:
    return ["shaper", str(PRINTER), "--grid", "x=0.1:0.2:2,y=0.1", "--shapers", "zv", *more]


RANGE = f"{PAYLOAD}=0:1.2kg:3"


def test_the_command_writes_and_prints_the_schedule(
    printer: pkmodes.Model, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "s.json"
    # 1240 kg/m^3 times 0.004 m^2 are 4.96 kg per metre of height.
    height = ["--height", "1.24 g/cm^3 * 40 cm^2"]
    assert run(options("--set", RANGE, *height, "--json", str(file))) == 0
    found = json.loads(file.read_text(encoding="utf-8"))["schedule"]
    np.testing.assert_allclose(
        [one["heights_m"] for one in found["steps"]],
        np.array([(0.0, 0.3), (0.3, 0.9), (0.9, 1.2)]) / 4.96,
        rtol=1e-12,
    )
    expected = printer.shapers([[0.1, 0.1], [0.2, 0.1]], "zv", settings={PAYLOAD: [0.0, 0.6, 1.2]}).schedule
    assert expected is not None
    titles = ("payload.mass [kg]", "from [mm]", "shaper", "design [Hz]", "damping [%]", "left [%]")
    rows = printed_table(capsys.readouterr().out, *titles, "halfway [%]", "fixed [%]", "rounds [um]")
    for cells, one, step in zip(rows, found["steps"], expected.steps, strict=True):
        assert one["set"] == {PAYLOAD: pytest.approx(step.setting.values[PAYLOAD])}
        assert one["frequencies_hz"] == pytest.approx(list(step.best.frequencies), rel=1e-9)
        assert one["left"]["worst"] == pytest.approx(step.best.left.worst, rel=1e-9)
        assert one["left_at_ends"] == pytest.approx(step.at_ends, rel=1e-9)
        assert one["left_by_fixed"] == pytest.approx(step.fixed, rel=1e-9)
        # Two impulses of one half, half a period apart: the variance in time is its square over 16.
        period = 1.0 / one["frequencies_hz"][0]
        assert one["rounding_s2"] == pytest.approx(period**2 / 32.0, rel=1e-9)
        assert cells == [
            f"{one['set'][PAYLOAD]:.4g}",
            f"{1e3 * one['heights_m'][0]:.1f}",
            "zv",
            f"{one['frequencies_hz'][0]:.2f}",
            "0",
            *(
                f"{100 * share:.2f}"
                for share in (one["left"]["worst"], one["left_at_ends"], one["left_by_fixed"])
            ),
            f"{1e6 * one['rounding_s2']:.1f}",
        ]


def test_the_page_opens_with_the_lines_of_the_schedule(tmp_path: Path) -> None:
    """Those of one shaper for all payloads are folded, so that the page stays short."""
    page = tmp_path / "page.html"
    assert run(options("--set", RANGE, "--height", "0:0.2m", "--report", str(page))) == 0
    found = read(page.read_text(encoding="utf-8"))
    folded = {name: found.by_id(name).attributes.get("class") for name in ("firmware", "schedule-lines")}
    assert folded == {"firmware": "folded", "schedule-lines": None}
    assert "SET_INPUT_SHAPER" in found.by_id("schedule-lines").text
    assert "shaper_freq_x" in found.by_id("firmware").text


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (
            ["--set", f"{PAYLOAD}=0:1.2kg"],
            'found "0:1.2kg" (--set effects.payload.mass); for example: 0:1.2kg:7',
        ),
        (["--set", f"{PAYLOAD}=500:1200g:7"], "a number without a unit is in kg: write 500g:1200g:7"),
        (["--set", f"{PAYLOAD}=0:1.2kg:1"], "expected several values from 0 to 1.2, found 1 (--set"),
        (
            ["--set", f"{PAYLOAD}=0:1.2 mm:7"],
            'found "1.2 mm", which is a length (--set effects.payload.mass)',
        ),
        (["--set", f"{PAYLOAD}=-1:1:3"], "or 0 for no effect, found -1.0"),
        (["--set", f"{PAYLOAD}=0:1:201"], "expected at most 200 settings, found 201 (--set)"),
        (["--height", "0:0.2"], "expected --set with one range for the heights, found 0 of them (--height)"),
        (["--set", RANGE, "--height", "200mm:0"], "two heights, the lower one first, found"),
        (["--set", RANGE, "--height", "10:200mm"], "a number without a unit is in m: write --height 0:200mm"),
        (["--set", RANGE, "--height", "0:200kg"], 'found "200kg", which is a mass (--height)'),
        (["--set", RANGE, "--height", "0:1:2"], "expected two heights, or a density times an area"),
        (["--set", RANGE, "--height", "1 kg/m^3 * 2 m"], "expected two heights, or a density times an area"),
        (["--set", RANGE, "--height", "0 kg/m^3 * 2 m**2"], "expected a positive density and area"),
        (
            ["--set", "belt.width=6mm:9mm:2", "--height", "1 kg/m^3 * 2 m**2"],
            "belt.width is no mass that a print could have",
        ),
    ],
)
def test_wrong_options_are_refused(
    arguments: list[str], message: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(options(*arguments)) == 2
    assert message in " ".join(capsys.readouterr().err.split())


def test_settings_are_for_a_robot_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["shaper", "--measured", str(tmp_path / "m.csv"), "--set", RANGE]) == 2
    assert "--set is for a robot file" in capsys.readouterr().err
