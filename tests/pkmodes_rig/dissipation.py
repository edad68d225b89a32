"""Damping on the virtual test rig: ratios of light damping from what each joint dissipates in each true mode.

The shapes and frequencies are those of the rig; the springs and joints that dissipate are described here once more,
from the specification, so that nothing is shared with the derived model.  A mode that moves a joint by y(t) loses in
it, per cycle and relative to 4 pi times its energy omega^2 a^2 / 2, its damping ratio:

* a loss factor eta of a spring k that the mode strains by s: eta k s^2 / (2 omega^2),
* viscous friction b: b y^2 / (2 omega),
* Coulomb friction F, which loses 4 F |y| a in a cycle of amplitude a: 2 F |y| / (pi omega^2 a).  This is the
  equivalent linearisation (Den Hartog, Forced vibrations with combined Coulomb and viscous friction, Transactions of
  the ASME 53, 1931), and the only one that depends on the amplitude.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from pkmodes_rig.engine import TrueModes
from pkmodes_rig.mujoco_engine import carriage_positions

Joint = Mapping[str, float]
AXES = range(3)


def motions(modes: TrueModes, joint: Joint) -> np.ndarray:
    """Return the motion of a joint in each mode, given by its coefficients of the coordinates, (m,)."""
    zero = np.zeros(len(modes.frequencies))
    return np.asarray(sum((factor * modes.shapes.get(name, zero) for name, factor in joint.items()), zero))


def lossy_springs(mechanism: str, q: Any, p: np.ndarray) -> list[tuple[float, Joint]]:
    """Return stiffness and strain of the springs with a loss factor: belts, or the reducers of a rotary delta."""
    springs: list[tuple[float, Joint]] = []
    if mechanism == "rotary_delta":
        return [(q.reducer_stiffness[j], {f"theta_{j + 1}": 1.0, f"phi_{j + 1}": -1.0}) for j in AXES]
    modulus = q.belt_width * q.belt_specific_stiffness
    if mechanism == "corexy":
        for i in (0, 1):
            g, runs = q.belt_path_direction[i], q.belt_path_lengths[i]
            strain = {"x": g[0], "y": g[1], f"theta_{i + 1}": q.pulley_radius[i], f"eps_{i + 1}": 1.0}
            springs += [
                (modulus[i] / (run + sign * (g @ p)), strain) for run, sign in zip(runs, (1, -1), strict=True)
            ]
        return springs
    for j, x in enumerate(carriage_positions(q, p)):
        (low, high), half, radius = q.limits[j], q.carriage_length[j] / 2, q.pulley_radius[j]
        clamp = {f"x_{j + 1}": 1.0, f"eps_{j + 1}": 1.0}
        first, second = f"theta_{j + 1}_1", f"theta_{j + 1}_2"
        springs += [
            (modulus[j] / (high - low), {first: radius, second: -radius}),
            (modulus[j] / (x - low - half), {**clamp, second: -radius}),
            (modulus[j] / (high - x - half), {**clamp, first: -radius}),
        ]
    return springs


def rails(mechanism: str) -> list[Joint]:
    """Return the motions along the rails."""
    names = {"linear_delta": ("x_1", "x_2", "x_3"), "corexy": ("x", "y"), "rotary_delta": ()}[mechanism]
    return [{name: 1.0} for name in names]


def drives(mechanism: str, q: Any) -> list[Joint]:
    """Return the motions of the motors."""
    if mechanism == "linear_delta":
        driven = [int(np.argmax(q.drive[j])) + 1 for j in AXES]
        return [{f"theta_{j + 1}_{k}": 1.0, f"psi_{j + 1}": 1.0} for j, k in enumerate(driven)]
    if mechanism == "corexy":
        return [{f"theta_{i}": 1.0, f"psi_{i}": 1.0} for i in (1, 2)]
    return [{f"phi_{j + 1}": 1.0, f"psi_{j + 1}": 1.0} for j in AXES]


def damping_ratios(
    mechanism: str, q: Any, p: np.ndarray, modes: TrueModes, losses: Mapping[str, float]
) -> np.ndarray:
    """Return the damping ratio of each mode, (m,).

    Parameters
    ----------
    mechanism : str
    q : Parameters
        One robot, without batch axes.
    p : array
        Pose.
    losses : mapping
        ``ratio`` of every mode; loss factor of the springs, ``springs``; viscous friction of the ``rails``, of the
        first rail alone, ``one_rail``, and of the ``drives``; ``mass``, damping proportional to mass [1/s].
    """
    omega = 2 * np.pi * np.abs(modes.frequencies)
    ratios = np.full(len(omega), losses.get("ratio", 0.0)) + losses.get("mass", 0.0) / (2 * omega)
    for stiffness, strain in lossy_springs(mechanism, q, p):
        ratios += losses.get("springs", 0.0) * stiffness * motions(modes, strain) ** 2 / (2 * omega**2)
    for j, rail in enumerate(rails(mechanism)):
        viscous = losses.get("rails", 0.0) + (losses.get("one_rail", 0.0) if j == 0 else 0.0)
        ratios += viscous * motions(modes, rail) ** 2 / (2 * omega)
    for drive in [] if modes.held else drives(mechanism, q):
        ratios += losses.get("drives", 0.0) * motions(modes, drive) ** 2 / (2 * omega)
    return ratios


def coulomb_ratios(mechanism: str, modes: TrueModes, force: float, amplitudes: np.ndarray) -> np.ndarray:
    """Return the damping ratios of Coulomb friction on the rails, (m,).

    Parameters
    ----------
    force : float
        Of each rail [N].
    amplitudes : array, shape (m,)
        Amplitude of each mode-normalised coordinate [m sqrt(kg)].
    """
    omega = 2 * np.pi * np.abs(modes.frequencies)
    moved = sum((np.abs(motions(modes, rail)) for rail in rails(mechanism)), np.zeros(len(omega)))
    return np.asarray(2 * force * moved / (np.pi * omega**2 * amplitudes))
