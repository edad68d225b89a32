"""Derivatives of the modes of a robot at a site, with a term or without."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.mechanism.stepped import COMPLEX_STEP
from pkmodes.core.support.expansion import modal_expansion
from pkmodes.loop.diagnosis.problem import Prediction
from pkmodes.loop.sensitivity.locked import released_changes
from pkmodes.loop.sensitivity.matrices import MatrixDerivatives
from pkmodes.loop.sensitivity.paths import ParameterPath
from pkmodes.loop.updating.predictions import Motions
from pkmodes.loop.updating.site_with_term import (
    PlacedTerm,
    PresentTerm,
    Site,
    TermModes,
    channels_of,
    in_all_coordinates,
    platform_with,
)
from pkmodes.loop.updating.term_changes import (
    Surroundings,
    TermContribution,
    absent_term_rates,
    change_of,
    changes_along,
)

Array = NDArray[np.float64]
Index = NDArray[np.intp]


class _Rates(NamedTuple):
    """Rates along one parameter.

    - change: of (K - lambda M) phi, (N, m, n)
    - norm: of phi^T M phi, (N, m)
    - motion: of the platform's motion in fixed coordinates, (N, m, components)
    - deflection: of coordinates that are locked, (N, m, e + a)
    """

    change: Array
    norm: Array
    motion: Array | None = None
    deflection: Array | None = None


class TermRates:
    """Derivatives of the modes of a site.

    - modes: at the site
    - present: the term that the modes have
    """

    def __init__(self, site: Site, modes: TermModes, present: PresentTerm | None) -> None:
        self.site, self.modes, self.present = site, modes, present
        self._term = None if present is None else present.placed_term.term
        self._platform = np.real(platform_with(self._term, site.surroundings))

    def of_robot(self, motions: Motions, shape_rates: bool) -> Prediction:
        """Return the modes with derivatives along motions of the robot."""
        prediction = self._prediction(list(self._rates_along(motions.paths)), shape_rates)
        if motions.weights is None:
            return prediction
        channel_rates = prediction.shape_rates
        return Prediction(
            prediction.eigenvalues,
            prediction.rates @ motions.weights,
            prediction.shapes,
            prediction.rigid,
            None if channel_rates is None else channel_rates @ motions.weights[:, None],
        )

    def of_terms(self, parameters: Sequence[tuple[PlacedTerm, int, Array]], shape_rates: bool) -> Prediction:
        """Return the modes with derivatives with respect to parameters of terms.

        - parameters: the term, which of its parameters, and the values of all of them
        """
        return self._prediction([self._with_parameter(*parameter) for parameter in parameters], shape_rates)

    @cached_property
    def _channels(self) -> Array:
        """Channels of the modes, (N, m, C)."""
        return channels_of(self.site.system, self._platform, self._motions)

    @cached_property
    def _motions(self) -> Array:
        """Shapes in all coordinates, (N, m, e + a)."""
        return in_all_coordinates(self.modes.matrices, self.modes.shapes)

    def _prediction(self, rates: Sequence[_Rates], shape_rates: bool) -> Prediction:
        eigenvalues, shapes = self.modes.eigenvalues, self.modes.shapes
        slopes = np.zeros((*eigenvalues.shape, len(rates)))
        channel_rates = np.zeros((*self._channels.shape, len(rates))) if shape_rates else None
        if rates:
            change = np.stack([rate.change for rate in rates], axis=1)
            slopes = np.einsum("ntmi,nmi->nmt", change, shapes)
            if channel_rates is not None:
                channel_rates = self._shape_rates(change, rates)
        return Prediction(eigenvalues, slopes, self._channels, self.modes.matrices.rigid, channel_rates)

    def _rates_along(self, paths: Sequence[ParameterPath]) -> Iterator[_Rates]:
        """Yield the rates along paths of the robot, which has a term."""
        if not paths:
            return
        assert self.present is not None  # without a term, the robot itself is evaluated
        term, values = self.present.placed_term.term, self.present.values
        site, matrices = self.site, self.modes.matrices
        derivatives = MatrixDerivatives(site.system, site.points, [paths], site.matrices)
        dM, dK = derivatives.dense()
        n = dM.shape[-1]
        for t, path in enumerate(paths):
            of_M, of_K = (np.zeros_like(matrix) for matrix in matrices.in_free())
            if t not in derivatives.locked_paths:
                of_M[:, :n, :n], of_K[:, :n, :n] = dM[:, t], dK[:, t]
            motion = None
            if path.weights and changes_along(term, site.system, path):
                stepped = Surroundings(site.system, site.points, path)
                of_term = self._in_free_coordinates(change_of(term, values, stepped).rates())
                of_M, of_K = of_M + of_term.M, of_K + of_term.K
                platform_rates = np.imag(platform_with(term, stepped)) / COMPLEX_STEP
                motion = self._motions @ np.swapaxes(platform_rates, -1, -2)
            rates = self._rates_of_change(of_M, of_K)._replace(motion=motion)
            if t in derivatives.locked_paths:
                # Each locked joint deflects under its force.
                joints = derivatives.locked_joints.joints
                weights = derivatives.locked_joints.weights[derivatives.locked_paths.index(t)]
                force, change, norm = released_changes(
                    (matrices.M, matrices.K),
                    matrices.free,
                    joints,
                    weights[None],
                    self.modes.eigenvalues,
                    self.modes.shapes,
                )
                deflection = np.zeros_like(self._motions)
                deflection[..., joints] -= weights * force
                rates = _Rates(rates.change + change[:, 0], rates.norm + norm[:, 0], motion, deflection)
            yield rates

    def _with_parameter(self, placed_term: PlacedTerm, k: int, values: Array) -> _Rates:
        """Return the rates with parameter k of a term, from the values of all its parameters."""
        if self.present is not None and placed_term is self.present.placed_term:
            stepped = values.astype(complex)
            stepped[k] += COMPLEX_STEP * 1j
            return self._rates_of_change(
                *self._in_free_coordinates(
                    change_of(placed_term.term, stepped, self.site.surroundings).rates()
                )
            )
        if k > 0:  # the term is absent whatever this parameter is
            return _Rates(np.zeros_like(self.modes.shapes), np.zeros_like(self.modes.eigenvalues))
        motions, e = self._motions, self.site.matrices[0].shape[-1]
        rates = absent_term_rates(
            placed_term.term, values, self.site.surroundings, self.modes.eigenvalues, motions[..., :e]
        )
        change = np.zeros_like(motions)
        change[..., :e] = rates.change
        return _Rates(change[..., self.modes.matrices.free], rates.norm, rates.motion)

    def _in_free_coordinates(self, change: TermContribution) -> TermContribution:
        free = self.modes.matrices.free
        return TermContribution(change.M[:, free[:, None], free], change.K[:, free[:, None], free])

    def _rates_of_change(self, dM: Array, dK: Array) -> _Rates:
        shapes, eigenvalues = self.modes.shapes, self.modes.eigenvalues
        inertia = shapes @ dM
        change = shapes @ dK - eigenvalues[..., None] * inertia
        return _Rates(change, np.einsum("nmi,nmi->nm", inertia, shapes))

    def _shape_rates(self, change: Array, rates: Sequence[_Rates]) -> Array:
        """Return the derivatives of the channels, (N, m, C, T)."""
        modes, matrices = self.modes, self.modes.matrices
        norm = np.stack([rate.norm for rate in rates], axis=1)
        share = modal_expansion(change, norm, modes.eigenvalues, modes.shapes)
        channel_rates = share @ self._channels[:, None]
        # Coordinates without inertia, and locked ones, are in no mode.
        static_motion = np.zeros((*share.shape[:3], matrices.M.shape[-1]))
        r = np.flatnonzero(matrices.massless)
        if len(r):
            q = matrices.free[r]
            K = matrices.K[:, q[:, None], q]
            solution = np.linalg.solve(K[:, None], np.swapaxes(change[..., r], -1, -2))
            static_motion[..., q] -= np.swapaxes(solution, -1, -2)
        for t, rate in enumerate(rates):
            if rate.deflection is not None:
                static_motion[:, t] += rate.deflection
        channel_rates += channels_of(self.site.system, self._platform, static_motion)
        components = self._platform.shape[-2]
        for t, rate in enumerate(rates):
            if rate.motion is not None:
                channel_rates[:, t, :, -components:] += rate.motion
        return np.ascontiguousarray(np.moveaxis(channel_rates, 1, -1))
