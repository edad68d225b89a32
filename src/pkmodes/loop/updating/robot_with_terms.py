"""A robot at measured poses with terms beyond its catalogue, as a structure for the diagnosis.

Without a term it is the robot itself, and the rates of absent terms follow from its modes.  With one, M and K are
those of the robot with what the term changes (`term_changes`), and everything follows from these matrices.
"""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Collection, Sequence

import numpy as np
from numpy.typing import NDArray

from pkmodes.loop.diagnosis.problem import Batch, Candidate, Parameter, Prediction, Sensor
from pkmodes.loop.updating.predictions import Moves, concatenated, joined_modes
from pkmodes.loop.updating.robot_structure import RobotStructure
from pkmodes.loop.updating.site_with_term import (
    PlacedTerm,
    PresentTerm,
    Site,
    TermMatrices,
    TermModes,
    channels_of,
    eigenmodes,
    held_motions,
    in_all_coordinates,
    matrices_with,
    platform_with,
    term_modes,
    without_term,
)
from pkmodes.loop.updating.term_candidates import term_candidates
from pkmodes.loop.updating.term_changes import Surroundings
from pkmodes.loop.updating.term_rates import TermRates
from pkmodes_description import Term

Array = NDArray[np.float64]
#: Robots whose matrices are cached: a fit evaluates many terms on the same robot.
KEPT = 4


class RobotWithTerms:
    """A robot at poses with the terms of its mechanism beside its own candidates.

    - parameters, candidates: of the robot, then of the terms
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
        self._robot_count = len(robot.parameters)
        self._owner = {i: place for place in self.terms for i in place.index}
        self._sites: OrderedDict[bytes, list[Site]] = OrderedDict()
        self._last: tuple[bytes, list[tuple[Site, TermModes | None]]] | None = None
        self._held: dict[tuple[str, int, int], int] = {}

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
        values, by = np.asarray(values, dtype=float), list(by)
        present, robot_values = self._present(values), values[: self._robot_count]
        of_robot = [i for i in by if i < self._robot_count]
        of_terms = [i for i in by if i >= self._robot_count]
        if present is None and not of_terms:
            return self.robot.predict(robot_values, of_robot, shape_rates=shape_rates)
        if present is None:
            sites = self._at(robot_values)
            absent = [
                TermRates(site, modes, None) for site in sites if (modes := without_term(site)) is not None
            ]
            if not sites or len(absent) < len(sites):
                return self._nothing(len(by))
            of_absent = [(at.site.setups, self._by_terms(at, values, of_terms, shape_rates)) for at in absent]
            prediction = self.robot.predict(robot_values, of_robot, shape_rates=shape_rates)
            return _in_order(
                prediction, joined_modes(of_absent, len(self.robot.points)), by, self._robot_count
            )
        parts = []
        for site, modes in self._modes(values, present):
            if modes is not None:
                at = TermRates(site, modes, present)
                prediction = at.of_robot(self._moves(values, of_robot, site), shape_rates)
                term_prediction = self._by_terms(at, values, of_terms, shape_rates)
                parts.append((site.setups, _in_order(prediction, term_prediction, by, self._robot_count)))
        return joined_modes(parts, len(self.robot.points)) if parts else self._nothing(len(by))

    @np.errstate(over="ignore", invalid="ignore", divide="ignore")
    def position_rates(self, values: Array, *, shape_rates: bool = False) -> Prediction:
        """Return the modes at all poses, with derivatives with respect to the platform's position."""
        values = np.asarray(values, dtype=float)
        present = self._present(values)
        if present is None:
            return self.robot.position_rates(values[: self._robot_count], shape_rates=shape_rates)
        shifts = Moves(self.robot.shifts, None)
        parts = [
            (site.setups, TermRates(site, modes, present).of_robot(shifts, shape_rates))
            for site, modes in self._modes(values, present)
            if modes is not None
        ]
        return joined_modes(parts, len(self.robot.points)) if parts else self._nothing(len(shifts.paths))

    def predict_many(
        self, values: Array, by: Sequence[Sequence[int]], *, shape_rates: bool = False
    ) -> list[Batch]:
        """Return the modes at all poses for several sets of values; those with equally many modes form one batch."""
        values = np.asarray(values, dtype=float)
        batches = [] if any(by) else self._batched(values)
        done = {int(k) for batch in batches for k in batch.sets}
        groups: dict[object, list[tuple[int, Prediction]]] = {}
        for k in range(len(values)):
            if k in done:
                continue
            prediction = self.predict(values[k], by[k], shape_rates=shape_rates)
            finite = bool(np.isfinite(prediction.eigenvalues).all())
            size = (prediction.eigenvalues.shape[1], prediction.rigid, prediction.rates.shape[-1])
            groups.setdefault((*size, finite or k), []).append((k, prediction))
        return batches + [
            Batch(np.array([k for k, _ in alike]), concatenated([prediction for _, prediction in alike]))
            for alike in groups.values()
        ]

    @np.errstate(over="ignore", invalid="ignore", divide="ignore")
    def _batched(self, values: Array) -> list[Batch]:
        """Return the modes for sets of values that differ in their terms only, without derivatives, many at once."""
        groups: dict[tuple[object, ...], list[tuple[int, PresentTerm, list[TermMatrices]]]] = {}
        for k, row in enumerate(values):
            present, sites = self._present(row), self._at(row[: self._robot_count])
            if present is None or sum(len(site.setups) for site in sites) != len(self.robot.points):
                continue
            matrices = [self._matrices(site, present) for site in sites]
            key = (row[: self._robot_count].tobytes(), *((m.massless.tobytes(), m.rigid) for m in matrices))
            groups.setdefault(key, []).append((k, present, matrices))
        batches = []
        for group in groups.values():
            sets = np.array([k for k, *_ in group])
            sites = self._at(values[sets[0], : self._robot_count])
            terms = [present.place.term for _, present, _ in group]
            prediction = self._stacked(sites, terms, [matrices for *_, matrices in group])
            if prediction is not None:
                batches.append(Batch(sets, prediction))
        return batches

    def _stacked(
        self, sites: Sequence[Site], terms: Sequence[Term], matrices: Sequence[list[TermMatrices]]
    ) -> Prediction | None:
        """Return the modes of one robot with several terms in turn; None where one of them is not a machine."""
        setups, parts = len(self.robot.points), []
        for site, of_terms in zip(sites, zip(*matrices, strict=True), strict=True):
            M, K = (
                np.concatenate(stack)
                for stack in zip(*(term_matrices.in_free() for term_matrices in of_terms), strict=True)
            )
            modes = eigenmodes(site.system.base_count, of_terms[0], M, K)
            if modes is None:
                return None
            eigenvalues, shapes = modes
            platform = np.concatenate([np.real(platform_with(term, site.around)) for term in terms])
            channels = channels_of(site.system, platform, in_all_coordinates(of_terms[0], shapes))
            rows = (setups * np.arange(len(terms))[:, None] + site.setups).ravel()
            rates = np.zeros((*eigenvalues.shape, 0))
            parts.append((rows, Prediction(eigenvalues, rates, channels, of_terms[0].rigid)))
        return joined_modes(parts, setups * len(terms))

    def _present(self, values: Array) -> PresentTerm | None:
        """Return the term that is present; with several, the first."""
        for place in self.terms:
            index = list(place.index)
            if values[index[0]] != self.parameters[index[0]].value:
                return PresentTerm(place, values[index])
        return None

    def _by_terms(self, at: TermRates, values: Array, by: Sequence[int], shape_rates: bool) -> Prediction:
        """Return the modes of a site with derivatives with respect to parameters of terms."""
        places = [(self._owner[i], i) for i in by]
        entries = [(place, place.index.index(i), values[list(place.index)]) for place, i in places]
        return at.of_terms(entries, shape_rates)

    def _nothing(self, count: int) -> Prediction:
        """Return the prediction where no pose can be evaluated."""
        plain = self.robot.predict(np.array([p.value for p in self.robot.parameters]), ())
        gone = np.full_like(plain.eigenvalues, np.nan)
        return Prediction(gone, np.full((*gone.shape, count), np.nan), plain.shapes, plain.rigid)

    def _moves(self, values: Array, by: Sequence[int], site: Site) -> Moves:
        case = int(self.robot.loads.of[site.setups[0]])
        (moves,) = self.robot.moved_by(values[: self._robot_count], by, site.setups, [case])
        return moves

    # The robot and one term ----------------------------------------------------------------------------------

    def _at(self, robot_values: Array) -> list[Site]:
        """Return the sites of the robot with values of its parameters, at the poses that it reaches."""
        key = robot_values.tobytes()
        if key not in self._sites:
            machines = self.robot.machines(robot_values)
            reached, sites = self.robot.reachable(machines), []
            for c, system in enumerate(machines.systems):
                setups = np.flatnonzero((self.robot.loads.of == c) & reached)
                if len(setups):
                    points = machines.where[setups]
                    matrices = system.all_coordinates(points)
                    sites.append(Site(setups, system, points, matrices, Surroundings(system, points)))
            self._sites[key] = sites
            while len(self._sites) > KEPT:
                self._sites.popitem(last=False)
        return self._sites[key]

    def _modes(self, values: Array, present: PresentTerm) -> list[tuple[Site, TermModes | None]]:
        """Return the sites with their modes; the last ones are kept."""
        key = values.tobytes()
        if self._last is None or self._last[0] != key:
            sites = self._at(values[: self._robot_count])
            self._last = key, [(site, term_modes(site, self._matrices(site, present))) for site in sites]
        return self._last[1]

    def _matrices(self, site: Site, present: PresentTerm) -> TermMatrices:
        term, system = present.place.term, site.system
        key = term.name, system.rigid_modes, len(system.free)
        if key not in self._held:
            held = held_motions(site, term)
            if held is None:  # nor is it a machine with the term
                return matrices_with(site, present, 0)
            self._held[key] = held
        return matrices_with(site, present, self._held[key])


def _in_order(robot: Prediction, terms: Prediction, by: Sequence[int], robot_count: int) -> Prediction:
    """Return a prediction with the derivatives by the robot's parameters and by terms in the requested order."""
    robot_first = np.argsort([i >= robot_count for i in by], kind="stable")
    place = np.argsort(robot_first)
    rates = np.concatenate([robot.rates, terms.rates], axis=-1)[..., place]
    along = None
    if robot.shape_rates is not None and terms.shape_rates is not None:
        along = np.concatenate([robot.shape_rates, terms.shape_rates], axis=-1)[..., place]
    return Prediction(robot.eigenvalues, rates, robot.shapes, robot.rigid, along)


class ExtensibleRobot(RobotStructure):
    """A robot at poses that can be extended by the terms of its mechanism."""

    def with_terms(self) -> RobotWithTerms:
        """Return the robot with the parameters and candidates of all its terms beside its own."""
        terms = term_candidates(self)
        placed, parameters = [], list(self.parameters)
        for term, term_parameters in terms.terms:
            placed.append(
                PlacedTerm(term, tuple(range(len(parameters), len(parameters) + len(term_parameters))))
            )
            parameters += term_parameters
        return RobotWithTerms(self, placed, parameters, [*terms.of_robot, *terms.candidates])
