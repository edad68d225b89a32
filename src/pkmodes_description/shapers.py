r"""Kinds of input shapers: impulses for an undamped mode, a constant step apart.

The runtime designs shapers from this table, and the derivation prints it into C.

Impulses of amplitudes a_i at times t_i excite, of a mode (omega, zeta), the free vibration

.. math:: \mathrm{Im} \sum_i a_i e^{(-\zeta + i \sqrt{1 - \zeta^2}) \omega (t - t_i)}, \qquad t \ge t_n,

up to a factor.  With :math:`t_k = k s T`, k = 0, 1, ..., and :math:`a_k \propto b_k e^{-\zeta \omega t_k}` the sum is
proportional to that of :math:`b_k e^{-2 \pi i s k}`, whatever the damping: a shaper that cancels the vibration of an
undamped mode cancels that of a damped one as soon as its amplitudes decay like the mode.  So a kind is the step s and
the amplitudes b_k for no damping.

zv, zvd, zvdd
    s = 1/2, where the sum is a polynomial in x at x = -1.  That the vibration and its first p - 1 derivatives with
    respect to frequency vanish is a root of multiplicity p, and (1 + x)^p has the coefficients b_k.
    Singer and Seering, "Preshaping Command Inputs to Reduce System Vibration", J. Dyn. Sys. Meas. Control 112 (1990).
mzv
    s = 3/8: three impulses in 3/4 of the time of zvd.  Their vectors have the angles 0, -135 and -270 degrees.
    The real part of the sum vanishes where b_0 = b_1/sqrt(2), the imaginary part where b_2 = b_1/sqrt(2).
    So (1, sqrt(2), 1) is the only solution, without a condition left for the derivative.
ei
    s = 1/2: of the mode itself the tolerance V is left, and nothing at one frequency on either side.
    Singhose, Seering and Singer, "Residual Vibration Reduction Using Vector Diagrams to Generate Shaped Inputs",
    J. Mech. Design 116 (1994).
2hump_ei, 3hump_ei
    s = 1/2: between the frequencies of which nothing is left, there are two and three humps of height V.
    Singhose, Porter, Tuttle and Singer, "Vibration Reduction Using Multi-Hump Input Shapers",
    J. Dyn. Sys. Meas. Control 119 (1997).

With damping, the conditions of the last three have no solution in closed form.  Amplitudes that decay like the mode
keep the vibration within V over a band of frequencies that is wider than without damping.  Solving the conditions of
ei numerically would widen it further: by 0.8 % for zeta = 0.01, by 8 % for zeta = 0.1.
"""

from __future__ import annotations

from math import cbrt, sqrt
from typing import NamedTuple

#: Vibration that ei, 2hump_ei and 3hump_ei leave of an undamped mode: the height of their humps.
TOLERANCE = 0.05


class Kind(NamedTuple):
    """Impulses for an undamped mode.

    Attributes
    ----------
    step : float
        Time between impulses, in periods of the mode.
    weights : tuple of float
        Amplitudes without damping, up to a factor.
    """

    step: float
    weights: tuple[float, ...]


def _two_humps(V: float) -> tuple[float, ...]:
    """Return the amplitudes of 2hump_ei (Singhose et al. 1997)."""
    X = cbrt(V**2 * (sqrt(1.0 - V**2) + 1.0))
    outer = (3.0 * X**2 + 2.0 * X + 3.0 * V**2) / (16.0 * X)
    return outer, 0.5 - outer, 0.5 - outer, outer


def _three_humps(V: float) -> tuple[float, ...]:
    """Return the amplitudes of 3hump_ei (Singhose et al. 1997)."""
    outer = (1.0 + 3.0 * V + 2.0 * sqrt(2.0 * (V**2 + V))) / 16.0
    second = (1.0 - V) / 4.0
    return outer, second, 1.0 - 2.0 * (outer + second), second, outer


SHAPERS: dict[str, Kind] = {
    "zv": Kind(1 / 2, (1.0, 1.0)),
    "zvd": Kind(1 / 2, (1.0, 2.0, 1.0)),
    "zvdd": Kind(1 / 2, (1.0, 3.0, 3.0, 1.0)),
    "mzv": Kind(3 / 8, (1.0, sqrt(2.0), 1.0)),
    "ei": Kind(1 / 2, ((1.0 + TOLERANCE) / 4.0, (1.0 - TOLERANCE) / 2.0, (1.0 + TOLERANCE) / 4.0)),
    "2hump_ei": Kind(1 / 2, _two_humps(TOLERANCE)),
    "3hump_ei": Kind(1 / 2, _three_humps(TOLERANCE)),
}
