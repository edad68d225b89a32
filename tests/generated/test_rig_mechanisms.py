"""The rigs of all mechanisms but the linear delta against each other and against the models that they test."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pkmodes
from pkmodes_rig.corexy import corexy
from pkmodes_rig.rotary_delta import by_engine, by_hand, rotary_delta
from pkmodes_rig.rows import OUTSIDE
from pkmodes_rig.six_legged import hexaglide, hexapod

ROBOTS = Path(__file__).resolve().parents[2] / "robots"
FILES = {
    "rotary_delta": "clavel-delta.toml",
    "corexy": "corexy-printer.toml",
    "hexapod": "hexapod.toml",
    "hexaglide": "hexaglide.toml",
}
RIGS: dict[str, Any] = {
    "rotary_delta": rotary_delta,
    "corexy": corexy,
    "hexapod": hexapod,
    "hexaglide": hexaglide,
}
POSES = {
    "rotary_delta": np.array([0.1, 0.05, -0.5]),
    "corexy": np.array([0.1, 0.05]),
    "hexapod": np.array([0.01, -0.015, 0.24, 0.05, -0.1, 0.12]),
    "hexaglide": np.array([0.05, -0.03, 0.2, -0.15, 0.2, 0.1]),
}
#: 1e-9 of the highest frequency: the error of differences.
CLOSE = 1e-9

COMMON = {
    "payload.mass": 0.1,
    "gearbox_inertia.inertia": 1e-6,
    "servo_stiffness.stiffness": 2.0,
    "cable_stiffness.stiffness": 3e3,
    "frame_compliance.compliance": 1e-6,
}
EFFECTS = {
    "rotary_delta": {
        **COMMON,
        "link_compliance.compliance": 1e-6,
        "axis_reducer_stiffness.factor_1": 0.1,
        "axis_reducer_stiffness.factor_3": -0.2,
    },
    "corexy": {
        **COMMON,
        "gearbox_compliance.compliance": 1e-2,
        "clamp_compliance.compliance": 1e-6,
        "belt_end_compliance.compliance": 2e-6,
        "belt_mass.linear_density": 0.01,
        "axis_belt_stiffness.factor_2": -0.2,
    },
    "hexapod": {
        **COMMON,
        "gearbox_inertia.inertia": 30.0,
        "servo_stiffness.stiffness": 2e5,
        "axis_leg_stiffness.factor_2": -0.2,
        "axis_leg_stiffness.factor_6": 0.1,
    },
    "hexaglide": {
        **COMMON,
        "link_compliance.compliance": 1e-7,
        "gearbox_compliance.compliance": 1e-3,
        "clamp_compliance.compliance": 1e-6,
        "belt_end_compliance.compliance": 2e-6,
        "belt_mass.linear_density": 0.01,
        "axis_belt_stiffness.factor_5": -0.2,
    },
}


def declared(mechanism: str, effects: Mapping[str, float], folder: Path) -> pkmodes.Model:
    text = (ROBOTS / FILES[mechanism]).read_text(encoding="utf-8")
    for name, value in effects.items():
        effect, parameter = name.split(".")
        header = f"[effects.{effect}]\n"
        text = text if header in text else f"{text}\n{header}"
        text = text.replace(header, f"{header}{parameter} = {value}\n")
    (folder / "robot.toml").write_text(text, encoding="utf-8")
    return pkmodes.load(folder / "robot.toml")


@pytest.mark.parametrize(
    ("mechanism", "without"),
    [
        ("rotary_delta", ""),
        ("rotary_delta", "link_compliance"),
        ("corexy", ""),
        ("corexy", "belt_mass"),
        ("hexapod", ""),
        ("hexaglide", ""),
        ("hexaglide", "belt_mass"),
    ],
)
def test_rig_and_model_agree(mechanism: str, without: str, tmp_path: Path) -> None:
    """All effects together; with rigid links MuJoCo closes the loops, without belt mass clamps are condensed."""
    effects = {n: v for n, v in EFFECTS[mechanism].items() if n.split(".")[0] != without}
    model, p = declared(mechanism, effects, tmp_path), POSES[mechanism]
    plain = pkmodes.load(ROBOTS / FILES[mechanism])
    found = RIGS[mechanism](plain.robot.parameters, p, {**effects, "frame_compliance.mass": 50.0})
    expected = model.modes(p, drives="free")
    frequencies = expected.frequencies
    assert found.frequencies == pytest.approx(frequencies, abs=CLOSE * frequencies[-1])
    assert found.rigid == expected.rigid_modes


@pytest.mark.parametrize("mechanism", ["hexapod", "hexaglide"])
def test_rig_and_model_of_six_legs_agree_with_motors_held(mechanism: str, tmp_path: Path) -> None:
    """The platform's rotations are among the shapes that both give."""
    effects = EFFECTS[mechanism]
    found = RIGS[mechanism](
        pkmodes.load(ROBOTS / FILES[mechanism]).robot.parameters,
        POSES[mechanism],
        {**effects, "frame_compliance.mass": 50.0},
        held=True,
    )
    expected = declared(mechanism, effects, tmp_path).modes(POSES[mechanism], drives="held")
    assert found.frequencies == pytest.approx(expected.frequencies, abs=CLOSE * expected.frequencies[-1])
    motion = np.abs([found.shapes[name] for name in ("p_x", "p_y", "p_z", "r_x", "r_y", "r_z")]).T
    size = np.abs(expected.platform_shapes).max(axis=0)
    assert motion / size == pytest.approx(np.abs(expected.platform_shapes) / size, abs=1e-6)


def test_loops_closed_by_hand_are_those_of_the_engine() -> None:
    q, p = pkmodes.load(ROBOTS / FILES["rotary_delta"]).robot.parameters, POSES["rotary_delta"]
    engine, hand = by_engine(q, p, 0.2, 0.1), by_hand(q, p, 0.2, 0.1)
    kept = [hand.names.index(name) for name in engine.names]
    np.testing.assert_allclose(hand.M[np.ix_(kept, kept)], engine.M, atol=1e-13)
    np.testing.assert_allclose(hand.weights[np.ix_(kept, kept)], engine.weights, atol=1e-10)
    np.testing.assert_allclose(hand.platform[:, kept], engine.platform, atol=1e-13)


#: Causes outside the catalogue, with strengths that change little.
STRANGERS = {
    "rotary_delta": {
        "tuned_absorber": 1e-3,
        "directional_cable": 10.0,
        "one_servo": 1e-3,
        "arm_hose": 1.0,
        "one_link": 1e-9,
        "rocking_frame": 1e-9,
    },
    "corexy": {
        "tuned_absorber": 1e-3,
        "directional_cable": 10.0,
        "one_servo": 1e-3,
        "one_gearbox": 1e-5,
        "one_run": 1e-9,
        "racking_gantry": 1e-8,
    },
    "hexapod": {
        "tuned_absorber": 1e-3,
        "directional_cable": 1e3,
        "one_servo": 1e3,
        "leg_hose": 1e3,
    },
    "hexaglide": {"one_gearbox": 1e-6, "one_link": 1e-9},
}


@pytest.mark.parametrize(
    ("mechanism", "kind", "strength"),
    [(m, kind, strength) for m, kinds in STRANGERS.items() for kind, strength in kinds.items()],
)
def test_a_weak_stranger_changes_little_and_a_strong_one_more(
    mechanism: str, kind: str, strength: float
) -> None:
    assert kind in OUTSIDE
    parameters, p = pkmodes.load(ROBOTS / FILES[mechanism]).robot.parameters, POSES[mechanism]
    rig = RIGS[mechanism]
    plain = rig(parameters, p).frequencies
    plain = plain[len(plain) // 2 :]  # the others are rigid-body modes

    def change(size: float) -> float:
        found = rig(parameters, p, {}, {kind: size}).frequencies
        # Compared with the nearest frequency, because a cause may add a mode.
        return float(np.abs(found[:, None] / plain - 1.0).min(axis=0).max())

    assert 1e-9 < change(strength) < change(4.0 * strength) < 0.05
