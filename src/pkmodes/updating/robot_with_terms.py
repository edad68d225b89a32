"""A robot at measured poses with terms beyond its catalogue, as a structure for the diagnosis.

Without a term it is the robot itself, and the rates of absent terms follow from its modes.  With one, M and K are
those of the robot with what the term changes (`term_changes`), and everything follows from these matrices.
"""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.linalg.eigen import condensed_eigh
from pkmodes.core.mechanism.stepped import STEP
from pkmodes.core.system.evaluation import ExtendedSystem
from pkmodes.diagnosis.problem import Batch, Candidate, Parameter, Prediction, Sensor
from pkmodes.sensitivity.matrices import MatrixDerivatives
from pkmodes.sensitivity.paths import ParameterPath
from pkmodes.support.expansion import modal_expansion
from pkmodes.updating.predictions import Moves, concatenated, joined
from pkmodes.updating.robot_structure import Machines, RobotStructure
from pkmodes.updating.term_candidates import term_candidates
from pkmodes.updating.term_changes import ADDING, Surroundings, at_null, change_of, changes_along, strains
from pkmodes_description import Term

Array = NDArray[np.float64]
Index = NDArray[np.intp]
#: A spring strains a rigid motion if by more than this part of what it strains other motions.
STRAINED = 1e-7
#: Ratio of the largest eigenvalue to the lowest one up to which this has the digits that a fit needs.
LOSSY = 1e9
#: Robots whose matrices are kept: a fit evaluates many terms beside the same one.
KEPT = 4


@dataclass(frozen=True)
class PlacedTerm:
    """A term with the indices of its parameters among those of the structure; the first determines its size."""

    term: Term
    index: tuple[int, ...]


class _Site(NamedTuple):
    """The robot of one load case at its setups: matrices in all coordinates, and what terms need."""

    rows: Index
    system: ExtendedSystem
    points: Array
    matrices: tuple[Array, Array]
    around: Surroundings


class _Present(NamedTuple):
    """A term that is present: itself and the values of its parameters."""

    place: PlacedTerm
    values: Array


class _Matrices(NamedTuple):
    """M and K of a site with a term, in all coordinates and that of the term: see `_Modes`."""

    M: Array
    K: Array
    free: Index
    massless: NDArray[np.bool_]
    rigid: int


class _Modes(NamedTuple):
    """Modes of a site with a term, in all coordinates and that of the term.

    Attributes
    ----------
    M, K : ndarray, shape (N, e + a, e + a)
    free : ndarray of int, shape (n,)
    massless : ndarray of bool, shape (n,)
    eigenvalues, shapes : ndarray, shapes (N, m) and (N, m, n)
    rigid : int
    """

    M: Array
    K: Array
    free: Index
    massless: NDArray[np.bool_]
    eigenvalues: Array
    shapes: Array
    rigid: int


class RobotWithTerms:
    """A robot at poses with the terms of its mechanism beside its own candidates.

    Parameters
    ----------
    robot : RobotStructure
    terms : sequence of PlacedTerm
    parameters, candidates
        Of the robot, then of the terms.
    """

    def __init__(
        self,
        robot: RobotStructure,
        terms: Sequence[PlacedTerm],
        parameters: Sequence[Parameter],
        candidates: Sequence[Candidate],
    ) -> None:
        self.robot, self.terms = robot, tuple(terms)
        self.parameters: tuple[Parameter, ...] = tuple(parameters)
        self.candidates: tuple[Candidate, ...] = tuple(candidates)
        self.channels, self.channel_units = robot.channels, robot.channel_units
        self._own = len(robot.parameters)
        self._owner = {i: term for term in self.terms for i in term.index}
        self._sites: OrderedDict[bytes, list[_Site]] = OrderedDict()
        self._last: tuple[bytes, list[tuple[_Site, _Modes | None]]] | None = None
        self._ranks: dict[tuple[str, int, int], int] = {}

    def __getstate__(self) -> dict[str, object]:
        return {**self.__dict__, "_sites": OrderedDict(), "_last": None}

    @property
    def sensors(self) -> tuple[Sensor, ...]:
        """Channels that are axes of one sensor."""
        return self.robot.sensors

    @property
    def drives(self) -> str:
        """What the motors do, at most of the poses."""
        return self.robot.drives

    @property
    def surroundings(self) -> str:
        """What `elsewhere` offers, in words."""
        return self.robot.surroundings

    def with_other_drives(self, setups: Sequence[int]) -> RobotWithTerms:
        """Return the robot with motors free instead of held, or held instead of free, in some of the setups."""
        return self._with(self.robot.with_other_drives(setups))

    def may_be_held(self, causes: Collection[str]) -> bool:
        """Return whether a measurement with held motors may be proposed."""
        return self.robot.may_be_held(causes)

    def subset(self, setups: Sequence[int]) -> RobotWithTerms:
        """Return the same robot at some of its poses."""
        return self._with(self.robot.subset(setups))

    def elsewhere(self, count: int) -> tuple[Array, RobotWithTerms]:
        """Return reachable poses around the measured ones, and the robot there."""
        points, robot = self.robot.elsewhere(count)
        return points, self._with(robot)

    def _with(self, robot: RobotStructure) -> RobotWithTerms:
        return RobotWithTerms(robot, self.terms, self.parameters, self.candidates)

    # Predictions -------------------------------------------------------------------------------------------

    @np.errstate(over="ignore", invalid="ignore", divide="ignore")  # a fit may try impossible values
    def predict(self, values: Array, by: Sequence[int], *, shape_rates: bool = False) -> Prediction:
        """Return the modes at all poses, with derivatives with respect to some of the parameters."""
        values = np.asarray(values, dtype=float)
        return self._predicted(values, list(by), None, shape_rates)

    def position_rates(self, values: Array, *, shape_rates: bool = False) -> Prediction:
        """Return the modes at all poses, with derivatives with respect to the platform's position."""
        values = np.asarray(values, dtype=float)
        if self._present(values) is None:
            return self.robot.position_rates(values[: self._own], shape_rates=shape_rates)
        return self._predicted(values, [], self.robot.shifts, shape_rates)

    def predict_many(
        self, values: Array, by: Sequence[Sequence[int]], *, shape_rates: bool = False
    ) -> list[Batch]:
        """Return the modes at all poses for several sets of values; those with equally many modes form one batch."""
        values = np.asarray(values, dtype=float)
        batches, left = [] if any(by) else self._together(values), range(len(values))
        done = {int(k) for batch in batches for k in batch.sets}
        groups: dict[object, list[tuple[int, Prediction]]] = {}
        for k in (k for k in left if k not in done):
            prediction = self.predict(values[k], by[k], shape_rates=shape_rates)
            finite = bool(np.isfinite(prediction.eigenvalues).all())
            size = (prediction.eigenvalues.shape[1], prediction.rigid, prediction.rates.shape[-1])
            groups.setdefault((*size, finite or k), []).append((k, prediction))
        return batches + [
            Batch(np.array([k for k, _ in alike]), concatenated([prediction for _, prediction in alike]))
            for alike in groups.values()
        ]

    @np.errstate(over="ignore", invalid="ignore", divide="ignore")
    def _together(self, values: Array) -> list[Batch]:
        """Return the modes for sets of values that differ in their terms only, without derivatives, many at once."""
        alike: dict[tuple[object, ...], list[tuple[int, _Present, list[_Matrices]]]] = {}
        for k, one in enumerate(values):
            present = self._present(one)
            if present is None:
                continue
            sites = self._at(one[: self._own])
            if sum(len(site.rows) for site in sites) != len(self.robot.points):
                continue
            changed = [self._changed(site, present) for site in sites]
            key = (one[: self._own].tobytes(), *((c.massless.tobytes(), c.rigid) for c in changed))
            alike.setdefault(key, []).append((k, present, changed))
        batches = []
        for some in alike.values():
            sites = self._at(values[some[0][0]][: self._own])
            prediction = self._stacked(sites, [present for _, present, _ in some], [c for *_, c in some])
            if prediction is not None:
                batches.append(Batch(np.array([k for k, *_ in some]), prediction))
        return batches

    def _stacked(
        self, sites: Sequence[_Site], present: Sequence[_Present], changed: Sequence[list[_Matrices]]
    ) -> Prediction | None:
        """Return the modes of several terms beside one robot; None where they cannot be evaluated together."""
        sets, setups = len(present), len(self.robot.points)
        eigenvalues, shapes, rigid = None, None, set()
        for s, site in enumerate(sites):
            each = [one[s] for one in changed]
            free, massless, count = each[0].free, each[0].massless, len(site.rows)
            part = (..., free[:, None], free)
            M = np.stack([one.M[part] for one in each]).reshape(sets * count, len(free), len(free))
            K = np.stack([one.K[part] for one in each]).reshape(M.shape)
            system = site.system
            try:
                levels, modes = _eigh(M, K, system.first, each[0].rigid, massless)
            except np.linalg.LinAlgError:
                return None
            if not np.isfinite(levels).all():
                return None
            every = np.zeros((sets, count, levels.shape[1], each[0].M.shape[-1]))
            every[..., free] = modes.reshape(sets, count, levels.shape[1], len(free))
            platform = np.stack([_platform_of(site, one.place.term) for one in present])
            own = system.of_model(every[..., : site.matrices[0].shape[-1]])
            channels = np.concatenate([own, every @ np.swapaxes(platform, -1, -2)], axis=-1)
            if eigenvalues is None or shapes is None:
                eigenvalues = np.empty((sets, setups, levels.shape[1]))
                shapes = np.empty((sets, setups, *channels.shape[2:]))
            if eigenvalues.shape[2] != levels.shape[1]:
                return None
            rigid.add(each[0].rigid)
            eigenvalues[:, site.rows] = levels.reshape(sets, count, -1)
            shapes[:, site.rows] = channels
        if len(rigid) != 1 or eigenvalues is None or shapes is None:
            return None
        size = sets * setups
        flat = eigenvalues.reshape(size, -1)
        rates = np.zeros((*flat.shape, 0))
        return Prediction(flat, rates, shapes.reshape(size, *shapes.shape[2:]), rigid.pop())

    def _present(self, values: Array) -> _Present | None:
        """Return the term that is present; with several, the first."""
        for term in self.terms:
            index = list(term.index)
            if values[index[0]] != self.parameters[index[0]].value:
                return _Present(term, values[index])
        return None

    def _predicted(
        self, values: Array, by: list[int], shifts: tuple[ParameterPath, ...] | None, shape_rates: bool
    ) -> Prediction:
        present, own = self._present(values), values[: self._own]
        of_robot = [i for i in by if i < self._own]
        if present is None and len(of_robot) == len(by):
            return self.robot.predict(own, of_robot, shape_rates=shape_rates)
        if present is None:
            plain = self.robot.predict(own, of_robot, shape_rates=shape_rates)
            rates = self._rates_of_absent(values, [i for i in by if i >= self._own], plain, shape_rates)
            return _in_order(plain, rates, by, self._own)
        key = values.tobytes()
        if self._last is None or self._last[0] != key:
            self._last = key, [(site, self._solved(site, present)) for site in self._at(own)]
        parts = []
        for site, modes in self._last[1]:
            if modes is not None:
                moves = self._moves(values, of_robot, site) if shifts is None else Moves(shifts, None)
                others = [i for i in by if i >= self._own]
                part = _AtSite(self, site, modes, present).prediction(values, moves, others, shape_rates)
                parts.append((site.rows, _in_order(*part, by, self._own) if shifts is None else part[0]))
        return joined(parts, len(self.robot.points)) if parts else self._nothing(len(by))

    def _nothing(self, count: int) -> Prediction:
        """Return the prediction where no pose can be evaluated."""
        plain = self.robot.predict(self.robot_values, ())
        gone = np.full_like(plain.eigenvalues, np.nan)
        return Prediction(gone, np.full((*gone.shape, count), np.nan), plain.shapes, plain.rigid)

    @cached_property
    def robot_values(self) -> Array:
        """The declared values of the robot's parameters."""
        return np.array([p.value for p in self.robot.parameters])

    def _moves(self, values: Array, by: Sequence[int], site: _Site) -> Moves:
        case = int(self.robot.loads.of[site.rows[0]])
        (moves,) = self.robot.moved_by(values[: self._own], by, site.rows, [case])
        return moves

    # The robot and one term ----------------------------------------------------------------------------------

    def _at(self, own: Array) -> list[_Site]:
        """Return the sites of the robot with values of its parameters, at the poses that it reaches."""
        key = own.tobytes()
        if key not in self._sites:
            machines: Machines = self.robot.machines(own)
            reached, sites = self.robot.reachable(machines), []
            for c, system in enumerate(machines.systems):
                rows = np.flatnonzero((self.robot.loads.of == c) & reached)
                if len(rows):
                    points = machines.where[rows]
                    both = system.all_coordinates(points)
                    sites.append(_Site(rows, system, points, both, Surroundings(system, points)))
            self._sites[key] = sites
            while len(self._sites) > KEPT:
                self._sites.popitem(last=False)
        return self._sites[key]

    def _solved(self, site: _Site, present: _Present) -> _Modes | None:
        """Return the modes of a site with a term; None if there are none."""
        M, K, free, massless, rigid = self._changed(site, present)
        part = (slice(None), free[:, None], free)
        try:
            eigenvalues, shapes = _eigh(M[part], K[part], site.system.first, rigid, massless)
        except np.linalg.LinAlgError:  # these values are not a machine
            return None
        if not np.isfinite(eigenvalues).all():
            return None
        return _Modes(M, K, free, massless, eigenvalues, shapes, rigid)

    def _changed(self, site: _Site, present: _Present) -> _Matrices:
        """Return M and K of a site with a term."""
        system = site.system
        change = change_of(present.place.term, present.values, site.around)
        M, K = (_padded(a, b) for a, b in zip(site.matrices, change, strict=True))
        e, size = site.matrices[0].shape[-1], M.shape[-1]
        added = np.arange(e, size)
        free = np.concatenate([system.free, added]).astype(np.intp)
        without = [bool((change.M[:, q] == 0.0).all()) for q in added]
        massless = np.concatenate([system.massless, np.array(without, dtype=bool)])
        rigid = system.rigid_modes - self._held(site, present.place.term)
        return _Matrices(M, K, free, massless, rigid)

    def _held(self, site: _Site, term: Term) -> int:
        """Return how many rigid motions of a site a spring holds."""
        system = site.system
        if term.form != "spring" or not system.rigid_modes:
            return 0
        key = term.name, system.rigid_modes, len(system.free)
        if key not in self._ranks:
            M, K = (a[:1, system.free[:, None], system.free] for a in site.matrices)
            _, shapes = condensed_eigh(M, K, system.first, system.rigid_modes, system.massless)
            strained = strains(term, site.around)[0][:, system.free] @ shapes[0].T
            size = np.abs(strained).max(initial=0.0)
            held = np.linalg.svd(strained[:, : system.rigid_modes], compute_uv=False)
            self._ranks[key] = int((held > STRAINED * size).sum()) if size > 0.0 else 0
        return self._ranks[key]

    # Rates of absent terms -----------------------------------------------------------------------------------

    def _rates_of_absent(
        self, values: Array, by: Sequence[int], plain: Prediction, shape_rates: bool
    ) -> Prediction:
        """Return the modes of the robot with derivatives with respect to parameters of terms that it lacks."""
        parts = []
        for site in self._at(values[: self._own]):
            system = site.system
            free, massless = system.free.astype(np.intp), system.massless
            M, K = (a[:, free[:, None], free] for a in site.matrices)
            eigenvalues, shapes = condensed_eigh(M, K, system.first, system.rigid_modes, massless)
            modes = _Modes(*site.matrices, free, massless, eigenvalues, shapes, system.rigid_modes)
            at = _AtSite(self, site, modes, None)
            parts.append((site.rows, at.prediction(values, Moves((), None), by, shape_rates)[1]))
        return joined(parts, len(self.robot.points))

    def term_of(self, i: int) -> PlacedTerm:
        """Return the term of a parameter."""
        return self._owner[i]


def _padded(matrix: Array, change: Array) -> Array:
    """Return the sum of matrices (N, e, e) and (N, e + a, e + a)."""
    total = np.array(np.broadcast_to(change, (len(matrix), *change.shape[1:])), dtype=float)
    total[:, : matrix.shape[-1], : matrix.shape[-1]] += matrix
    return total


def _eigh(M: Array, K: Array, first: int, rigid: int, massless: NDArray[np.bool_]) -> tuple[Array, Array]:
    """Solve the eigenproblem with the digits that a fit needs: a stiff joint only where it costs those."""
    eigenvalues, shapes = condensed_eigh(M, K, M.shape[-1], rigid, massless)
    if rigid < eigenvalues.shape[1]:
        lost = eigenvalues[:, -1] > LOSSY * np.abs(eigenvalues[:, rigid])
        if lost.any():
            eigenvalues[lost], shapes[lost] = condensed_eigh(M[lost], K[lost], first, rigid, massless)
    return eigenvalues, shapes


def _platform_of(site: _Site, term: Term | None) -> Array:
    """Return the motion of the platform per unit of all coordinates and that of a term, (N, components, e + a)."""
    return np.real(_platform_with(term, site.around))


def _platform_with(term: Term | None, around: Surroundings) -> NDArray[Any]:
    if term is None or term.form not in ADDING:
        return around.platform
    own = np.zeros((*around.platform.shape[:-1], 1))
    if term.form == "mount":
        own = around.mounts[4][:, term.mount][..., None]
    return np.concatenate([around.platform, own], axis=-1)


def _in_order(robot: Prediction, terms: Prediction, by: Sequence[int], own: int) -> Prediction:
    """Return a prediction whose derivatives are in the order asked for: of the robot's parameters and of terms."""
    place = np.argsort(
        np.argsort([i if i < own else own for i in by], kind="stable"), kind="stable"
    )  # the robot's come first
    rates = np.concatenate([robot.rates, terms.rates], axis=-1)[..., place]
    along = None
    if robot.shape_rates is not None and terms.shape_rates is not None:
        along = np.concatenate([robot.shape_rates, terms.shape_rates], axis=-1)[..., place]
    return Prediction(robot.eigenvalues, rates, robot.shapes, robot.rigid, along)


class _AtSite:
    """Derivatives of the modes of a robot at a site, with a term or without."""

    def __init__(
        self, structure: RobotWithTerms, site: _Site, modes: _Modes, present: _Present | None
    ) -> None:
        self.structure, self.site, self.modes, self.present = structure, site, modes, present
        self.system, self.e = site.system, site.matrices[0].shape[-1]

    def prediction(
        self, values: Array, moves: Moves, others: Sequence[int], shape_rates: bool
    ) -> tuple[Prediction, Prediction]:
        """Return the modes with derivatives along moves of the robot, and with respect to parameters of terms."""
        m = self.modes
        channels = self._channels(self._every(m.shapes))
        predictions = []
        for changed in (self._along(moves.paths), self._by_terms(values, others)):
            collected = list(changed)
            count = len(collected)
            rates = np.zeros((*m.eigenvalues.shape, count))
            along = np.zeros((*channels.shape, count)) if shape_rates else None
            if count:
                change = np.stack([one.change for one in collected], axis=1)
                norm = np.stack([one.norm for one in collected], axis=1)
                rates = np.einsum("ntmi,nmi->nmt", change, m.shapes)
                if along is not None:
                    along = self._shape_rates(change, norm, collected, channels)
            predictions.append((rates, along))
        (rates, along), (more, also) = predictions
        if moves.mix is not None:
            rates, along = rates @ moves.mix, None if along is None else along @ moves.mix[:, None]
        given = m.eigenvalues, channels, m.rigid
        return (
            Prediction(given[0], rates, given[1], given[2], along),
            Prediction(given[0], more, given[1], given[2], also),
        )

    # What changes along a parameter --------------------------------------------------------------------------

    def _along(self, paths: Sequence[ParameterPath]) -> Iterator[_Changed]:
        """Yield the changes along paths of the robot."""
        if not paths:
            return
        derivatives = MatrixDerivatives(self.system, self.site.points, [paths], self.site.matrices)
        dM, dK = derivatives.dense()
        locked = derivatives.locked_joints
        for t, path in enumerate(paths):
            of_M, of_K = (np.zeros_like(self._free(self.modes.M)) for _ in range(2))
            n = dM.shape[-1]
            known = np.isfinite(dM[0, t]).all() if len(dM) else True
            if known:
                of_M[:, :n, :n], of_K[:, :n, :n] = dM[:, t], dK[:, t]
            motion, present = None, self.present
            assert present is not None  # without a term, the robot itself is evaluated
            if path.weights and changes_along(present.place.term, self.system, path):
                stepped = Surroundings(self.system, self.site.points, path)
                change = change_of(present.place.term, present.values, stepped).rates()
                of_M, of_K = of_M + self._free(change.M), of_K + self._free(change.K)
                motion = self._motion_rate(path, stepped)
            changed = self._linear(of_M, of_K, motion)
            for joints, weight in locked.get(t, []):
                changed = changed.plus(self._released(joints, weight))
            yield changed

    def _by_terms(self, values: Array, by: Sequence[int]) -> Iterator[_Changed]:
        """Yield the changes with parameters of terms."""
        for i in by:
            place = self.structure.term_of(i)
            k, own = place.index.index(i), values[list(place.index)]
            if self.present is not None and place is self.present.place:
                stepped = own.astype(complex)
                stepped[k] += STEP * 1j
                change = change_of(place.term, stepped, self.site.around).rates()
                yield self._linear(self._free(change.M), self._free(change.K), None)
            elif k == 0:
                yield self._absent(place.term, own)
            else:
                none = np.zeros_like(self._free(self.modes.M))
                yield self._linear(none, none, None)

    def _free(self, matrix: Array) -> Array:
        free = self.modes.free
        return matrix[:, free[:, None], free]

    def _linear(self, dM: Array, dK: Array, motion: Array | None) -> _Changed:
        shapes, eigenvalues = self.modes.shapes, self.modes.eigenvalues
        inertia = shapes @ dM
        change = shapes @ dK - eigenvalues[..., None] * inertia
        moved = None if motion is None else self._every(shapes) @ np.swapaxes(motion, -1, -2)
        return _Changed(change, np.einsum("nmi,nmi->nm", inertia, shapes), moved, None)

    def _released(self, joints: Sequence[int], weight: float) -> _Changed:
        """Return the change with the compliance of locked joints: each deflects under its force."""
        shapes, eigenvalues = self.modes.shapes, self.modes.eigenvalues
        K, M = (a[:, list(joints)][..., self.modes.free] for a in (self.modes.K, self.modes.M))
        of_K, of_M = shapes @ np.swapaxes(K, -1, -2), shapes @ np.swapaxes(M, -1, -2)
        force = of_K - eigenvalues[..., None] * of_M
        change = -weight * (force @ K - eigenvalues[..., None] * (force @ M))
        deflected = np.zeros((*shapes.shape[:2], self.modes.M.shape[-1]))
        deflected[..., list(joints)] -= weight * force
        return _Changed(change, -2.0 * weight * np.sum(force * of_M, axis=-1), None, deflected)

    def _absent(self, term: Term, values: Array) -> _Changed:
        every = self._every(self.modes.shapes)
        rates = at_null(term, values, self.site.around, self.modes.eigenvalues, every[..., : self.e])
        change = np.zeros_like(every)
        change[..., : self.e] = rates.change
        return _Changed(change[..., self.modes.free], rates.norm, rates.motion, None)

    # Channels --------------------------------------------------------------------------------------------------

    def _every(self, shapes: Array) -> Array:
        """Return shapes in the free coordinates in all of them, (..., e + a)."""
        every = np.zeros((*shapes.shape[:-1], self.modes.M.shape[-1]))
        every[..., self.modes.free] = shapes
        return every

    @cached_property
    def _platform(self) -> Array:
        """Motion of the platform per unit of all coordinates and that of the term, (N, components, e + a)."""
        return _platform_of(self.site, None if self.present is None else self.present.place.term)

    def _motion_rate(self, path: ParameterPath, stepped: Surroundings) -> Array:
        """Differentiate the motion of the platform along a path, (N, components, e + a)."""
        term = None if self.present is None else self.present.place.term
        return np.imag(_platform_with(term, stepped)) / STEP

    def _channels(self, every: Array, platform: Array | None = None) -> Array:
        """Return the channels of motions in all coordinates, (N, ..., C)."""
        moved = self._platform if platform is None else platform
        turned = np.swapaxes(moved, -1, -2)
        turned = turned if every.ndim == 3 else turned[:, None]
        return np.concatenate([self.system.of_model(every[..., : self.e]), every @ turned], axis=-1)

    def _shape_rates(self, change: Array, norm: Array, changed: Sequence[_Changed], channels: Array) -> Array:
        m = self.modes
        share = modal_expansion(change, norm, m.eigenvalues, m.shapes)
        rates = share @ channels[:, None]
        beyond = np.zeros((*share.shape[:3], m.M.shape[-1]))
        r = np.flatnonzero(m.massless)
        if len(r):
            at = m.free[r]
            K = m.K[:, at[:, None], at]
            moved = np.linalg.solve(K[:, None], np.swapaxes(change[..., r], -1, -2))
            beyond[..., at] -= np.swapaxes(moved, -1, -2)
        for t, one in enumerate(changed):
            if one.deflected is not None:
                beyond[:, t] += one.deflected
        rates += self._channels(beyond)
        components = self._platform.shape[-2]
        for t, one in enumerate(changed):
            if one.motion is not None:
                rates[:, t, :, -components:] += one.motion
        return np.ascontiguousarray(np.moveaxis(rates, 1, -1))


class _Changed(NamedTuple):
    """Rates along one parameter.

    Attributes
    ----------
    change : ndarray, shape (N, m, n)
        Of (K - lambda M) phi.
    norm : ndarray, shape (N, m)
        Of phi^T M phi.
    motion : ndarray, shape (N, m, components), or None
        Of the platform's motion in fixed coordinates.
    deflected : ndarray, shape (N, m, e + a), or None
        Of coordinates that are locked.
    """

    change: Array
    norm: Array
    motion: Array | None
    deflected: Array | None

    def plus(self, other: _Changed) -> _Changed:
        """Return the sum."""
        parts = [one for one in (self.deflected, other.deflected) if one is not None]
        deflected = np.sum(parts, axis=0) if parts else None
        return _Changed(self.change + other.change, self.norm + other.norm, self.motion, deflected)


class ExtensibleRobot(RobotStructure):
    """A robot at poses that can be extended by the terms of its mechanism."""

    def with_terms(self) -> RobotWithTerms:
        """Return the robot with the parameters and candidates of all its terms beside its own."""
        found = term_candidates(self)
        placed, parameters = [], list(self.parameters)
        for term, own in found.terms:
            placed.append(PlacedTerm(term, tuple(range(len(parameters), len(parameters) + len(own)))))
            parameters += own
        return RobotWithTerms(self, placed, parameters, [*found.of_robot, *found.candidates])
