"""A CoreXY whose beam turns on its guides: closed forms, the rig, and what the robot file accepts."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np
import pytest
import scipy.linalg

import pkmodes
from pkmodes.core.base.errors import RobotFileError
from pkmodes.core.mechanism.registry import mechanism
from pkmodes_rig.corexy import corexy

FILE = Path(__file__).resolve().parents[2] / "robots" / "corexy-printer.toml"
J_B, C_B = 0.012, 8e-5
RACKING = {"gantry_racking.compliance": C_B, "gantry_racking.inertia": J_B}


def printer(folder: Path, effects: Mapping[str, float], keys: str = f"inertia = {J_B}") -> pkmodes.Model:
    """Return the printer with effects, and with keys of its beam; its second belt mirrors the first one."""
    text = FILE.read_text(encoding="utf-8").replace("[gantry]", f"[gantry]\n{keys}\n")
    text = text.replace('lengths = ["750 mm", "750 mm"]', 'lengths = ["750 mm", "450 mm"]')
    names = dict.fromkeys(path.partition(".")[0] for path in effects)
    for name in names:
        own = {
            path.partition(".")[2]: value for path, value in effects.items() if path.startswith(f"{name}.")
        }
        given = (f"{key} = {value}" for key, value in own.items() if key not in ("inertia", "mass"))
        mass = f"mass = {own['mass']}" if name == "payload" else ""
        text += "\n".join([f"\n[effects.{name}]", *given, mass, ""])
    (folder / "robot.toml").write_text(text, encoding="utf-8")
    return pkmodes.load(folder / "robot.toml")


@pytest.mark.parametrize("x", [0.03, 0.15, 0.24])
def test_a_beam_with_rigid_motors_is_two_coupled_bodies(x: float, tmp_path: Path) -> None:
    """Motors held: (x, y, psi) remain; with k_i the sum of both runs of belt i and b = x - 0.15 m

    2 V = sum k_i (g_ix dx + g_iy (dy + b psi))^2 + psi^2 / c,
    2 T = m_h (x'^2 + (y' + b psi')^2) + m_g y'^2 + J psi'^2.
    """
    model = printer(tmp_path, {"gantry_racking.compliance": C_B})
    q, y = model.robot.parameters, 0.2
    g, pull = q.belt_path_direction, q.belt_path_direction @ [x, y]
    runs = q.belt_path_lengths + pull[:, None] * [1.0, -1.0]
    k = q.belt_width * q.belt_specific_stiffness * np.sum(1.0 / runs, axis=1)
    b = x - 0.15
    m_h, m_g = q.toolhead_mass, q.gantry_mass
    strain = np.column_stack([g[:, 0], g[:, 1], g[:, 1] * b])
    K = strain.T @ np.diag(k) @ strain + np.diag([0.0, 0.0, 1.0 / C_B])
    M = np.array([[m_h, 0.0, 0.0], [0.0, m_h + m_g, m_h * b], [0.0, m_h * b, J_B + m_h * b**2]])
    expected = np.sqrt(scipy.linalg.eigh(K, M, eigvals_only=True)) / (2.0 * np.pi)
    found = model.modes([x, y], drives="held")
    assert found.coordinates[-1] == "psi_b"
    np.testing.assert_allclose(found.frequencies, expected, rtol=1e-11)
    if b == 0.0:  # the head on the middle: the beam turns alone on its spring
        alone = 1.0 / (2.0 * np.pi * np.sqrt(C_B * J_B))
        assert np.abs(found.frequencies / alone - 1.0).min() < 1e-11


def test_the_first_mode_depends_on_where_the_head_is(tmp_path: Path) -> None:
    """Beside the same machine with a rigid beam: as high in the middle, lower towards both ends, symmetrically."""
    x = np.array([0.0, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3])
    poses = np.column_stack([x, np.full(7, 0.2)])
    first, rigid = (
        printer(tmp_path, {"gantry_racking.compliance": c}).frequencies(poses, drives="held")[:, 0]
        for c in (4e-5, 0.0)
    )
    share = first / rigid
    np.testing.assert_allclose(share, share[::-1], rtol=1e-9)
    assert share[3] == pytest.approx(1.0, rel=1e-9)
    assert (np.diff(share[:4]) > 0.0).all()
    assert share[0] < 0.99


@pytest.mark.parametrize("backend", ["numpy", pytest.param("compiled", marks=pytest.mark.compiler)])
@pytest.mark.parametrize("drives", ["free", "held"])
def test_with_everything_else_it_is_the_rig(drives: str, backend: str, tmp_path: Path) -> None:
    effects = {
        **RACKING,
        "gantry_racking.center": 0.13,
        "payload.mass": 0.2,
        "cable_stiffness.stiffness": 3e3,
        "gearbox_compliance.compliance": 1e-2,
        "clamp_compliance.compliance": 1e-6,
        "belt_mass.linear_density": 0.01,
        "belt_end_compliance.compliance": 2e-6,
        "frame_compliance.compliance_y": 1e-6,
    }
    model, p = printer(tmp_path, effects), np.array([0.27, 0.08])
    assert model.coordinates[-2:] == ("u_y", "psi_b")
    expected = corexy(
        model.robot.parameters, p, {**effects, "frame_compliance.mass": 50.0}, held=drives == "held"
    )
    found = model.modes(p, drives=drives, backend=backend)
    close = 1e-9 * found.frequencies[-1]
    np.testing.assert_allclose(found.frequencies, expected.frequencies, atol=close, rtol=0)
    # The head moves with the beam: p_y is not y + u_y.
    sign = np.sign(found.platform_shapes[-1, 1] * expected.shapes["p_y"][-1])
    shape = sign * expected.shapes["p_y"][-1]
    assert found.platform_shapes[-1, 1] == pytest.approx(shape, rel=1e-6)


@pytest.mark.parametrize("path", ["gantry.inertia", "gantry.center", "workspace.x.max", "toolhead.mass"])
def test_sensitivities_are_differences_of_read_robots(path: str, tmp_path: Path) -> None:
    """The middle of the beam follows the travel where the file does not give it."""
    keys = f"inertia = {J_B}" + ("\ncenter = 0.14" if path == "gantry.center" else "")
    model, p = printer(tmp_path, {"gantry_racking.compliance": C_B}, keys), [0.27, 0.08]
    value = model.robot.quantities[path].value
    step = 1e-5 * value
    ahead, behind = (model.with_values({path: value + s}).frequencies(p)[2:] for s in (step, -step))
    found = model.sensitivities(p, [path]).frequencies[0, 2:]
    assert np.abs(found).max() > 0.0
    difference = (ahead - behind) / (2.0 * step)
    np.testing.assert_allclose(found, difference, rtol=1e-6, atol=1e-6 * np.abs(difference).max())


def test_null_is_the_base_model_and_a_beam_needs_an_inertia(tmp_path: Path) -> None:
    plain = printer(tmp_path, {}, "")
    null = printer(tmp_path, {"gantry_racking.compliance": 0.0})
    p = [0.2, 0.1]
    assert null.coordinates == plain.coordinates
    np.testing.assert_array_equal(null.frequencies(p), plain.frequencies(p))
    with pytest.raises(
        RobotFileError, match="moment of inertia about its middle above 0, found 0 kg m"
    ) as error:
        printer(tmp_path, {"gantry_racking.compliance": C_B}, "")
    assert "effects.gantry_racking.inertia" in str(error.value)
    assert "declare inertia in the table of the beam" in str(error.value)
    for other in ("linear_delta", "rotary_delta"):
        assert "gantry_racking" not in mechanism(other).effects


def test_the_head_and_the_beam_turn_in_the_picture(tmp_path: Path) -> None:
    """Per unit of psi_b, a point of the beam moves by (-(y - y_beam), x - center); the rails stay."""
    from pkmodes.pages.view.robot_drawing import RobotDrawing

    drawing = RobotDrawing(printer(tmp_path, {"gantry_racking.compliance": C_B}).robot)
    p = np.array([[0.27, 0.08]])
    points, motions = drawing.points(p)[0], drawing.motions(p)[0][list(drawing.drawing.motions)]
    turned = motions[:, :, drawing.coordinates.index("psi_b")]
    by_kind = {e.kind: list(e.points) for e in drawing.drawing.elements}
    for kind in ("gantry", "toolhead"):
        at = points[by_kind[kind]]
        expected = np.column_stack([0.08 - at[:, 1], at[:, 0] - 0.15, 0.0 * at[:, 0]])
        np.testing.assert_allclose(turned[by_kind[kind]], expected, atol=1e-15)
    assert not turned[by_kind["rail"]].any()
