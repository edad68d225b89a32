"""A robot at measured poses with terms beyond its catalogue, as a structure for the diagnosis.

Without a term it is the robot itself, and the rates of absent terms follow from its modes.  With one, M and K are
those of the robot with what the term changes (`term_changes`), and everything follows from these matrices.
"""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Collection, Sequence

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.system.motors import MotorEffects
from pkmodes.loop.diagnosis.problem import Batch, Candidate, Parameter, Prediction, Sensor
from pkmodes.loop.updating.predictions import Motions, concatenate_predictions, join_modes
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
MAX_CACHED_ROBOTS = 4


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
        self._term_of_parameter = {i: placed_term for placed_term in self.terms for i in placed_term.index}
        self._sites: OrderedDict[bytes, list[Site]] = OrderedDict()
        self._cached_modes: tuple[bytes, list[tuple[Site, TermModes | None]]] | None = None
        self._held_counts: dict[tuple[str, int, int], int] = {}

    def __getstate__(self) -> dict[str, object]:
        return {**self.__dict__, "_sites": OrderedDict(), "_cached_modes": None}

    @property
    def sensors(self) -> tuple[Sensor, ...]:
        """Channels that are axes of one sensor."""
        return self.robot.sensors

    @property
    def drives(self) -> str:
        """What the motors do, at most of the poses."""
        return self.robot.drives

    @property
    def motor_effects(self) -> MotorEffects:
        """Candidates by which the motors, or what joins them to the machine, give way."""
        return self.robot.motor_effects

    @property
    def surroundings(self) -> str:
        """What `elsewhere` offers, in words."""
        return self.robot.surroundings

    def with_other_drives(self, setups: Sequence[int]) -> RobotWithTerms:
        """Return the robot with motors free instead of held, or held instead of free, in some of the setups."""
        return self._with_robot(self.robot.with_other_drives(setups))

    def may_be_held(self, causes: Collection[str]) -> bool:
        """Return whether a measurement with held motors may be proposed."""
        return self.robot.may_be_held(causes)

    def subset(self, setups: Sequence[int]) -> RobotWithTerms:
        """Return the same robot at some of its poses."""
        return self._with_robot(self.robot.subset(setups))

    def elsewhere(self, count: int) -> tuple[Array, RobotWithTerms]:
        """Return reachable poses around the measured ones, and the robot there."""
        points, robot = self.robot.elsewhere(count)
        return points, self._with_robot(robot)

    def _with_robot(self, robot: RobotStructure) -> RobotWithTerms:
        return RobotWithTerms(robot, self.terms, self.parameters, self.candidates)

    # Predictions -------------------------------------------------------------------------------------------

    @np.errstate(over="ignore", invalid="ignore", divide="ignore")  # a fit may try impossible values
    def predict(self, values: Array, by: Sequence[int], *, shape_rates: bool = False) -> Prediction:
        """Return the modes at all poses, with derivatives with respect to some of the parameters."""
        values, by = np.asarray(values, dtype=float), list(by)
        present, robot_values = self._present_term(values), values[: self._robot_count]
        robot_indices = [i for i in by if i < self._robot_count]
        term_indices = [i for i in by if i >= self._robot_count]
        if present is None and not term_indices:
            return self.robot.predict(robot_values, robot_indices, shape_rates=shape_rates)
        if present is None:
            sites = self._sites_at(robot_values)
            term_rates = [
                TermRates(site, modes, None) for site in sites if (modes := without_term(site)) is not None
            ]
            if not sites or len(term_rates) < len(sites):
                return self._failed_prediction(len(by))
            absent_parts = [
                (rates.site.setups, self._term_prediction(rates, values, term_indices, shape_rates))
                for rates in term_rates
            ]
            prediction = self.robot.predict(robot_values, robot_indices, shape_rates=shape_rates)
            return _in_requested_order(
                prediction, join_modes(absent_parts, len(self.robot.points)), by, self._robot_count
            )
        parts = []
        for site, modes in self._modes_of_sites(values, present):
            if modes is not None:
                rates = TermRates(site, modes, present)
                case = int(self.robot.loads.case_index[site.setups[0]])
                (motions,) = self.robot.motions_of(robot_values, robot_indices, site.setups, [case])
                prediction = rates.of_robot(motions, shape_rates)
                term_prediction = self._term_prediction(rates, values, term_indices, shape_rates)
                parts.append(
                    (site.setups, _in_requested_order(prediction, term_prediction, by, self._robot_count))
                )
        return join_modes(parts, len(self.robot.points)) if parts else self._failed_prediction(len(by))

    @np.errstate(over="ignore", invalid="ignore", divide="ignore")
    def position_rates(self, values: Array, *, shape_rates: bool = False) -> Prediction:
        """Return the modes at all poses, with derivatives with respect to the platform's position."""
        values = np.asarray(values, dtype=float)
        present = self._present_term(values)
        if present is None:
            return self.robot.position_rates(values[: self._robot_count], shape_rates=shape_rates)
        pose_motions = Motions(self.robot.shifts, None)
        parts = [
            (site.setups, TermRates(site, modes, present).of_robot(pose_motions, shape_rates))
            for site, modes in self._modes_of_sites(values, present)
            if modes is not None
        ]
        return (
            join_modes(parts, len(self.robot.points))
            if parts
            else self._failed_prediction(len(pose_motions.paths))
        )

    def predict_many(
        self, values: Array, by: Sequence[Sequence[int]], *, shape_rates: bool = False
    ) -> list[Batch]:
        """Return the modes at all poses for several sets of values; those with equally many modes form one batch."""
        values = np.asarray(values, dtype=float)
        batches = [] if any(by) else self._batch_terms(values)
        evaluated_sets = {int(k) for batch in batches for k in batch.sets}
        groups: dict[object, list[tuple[int, Prediction]]] = {}
        for k in range(len(values)):
            if k in evaluated_sets:
                continue
            prediction = self.predict(values[k], by[k], shape_rates=shape_rates)
            finite = bool(np.isfinite(prediction.eigenvalues).all())
            size = (prediction.eigenvalues.shape[1], prediction.rigid, prediction.rates.shape[-1])
            groups.setdefault((*size, finite or k), []).append((k, prediction))
        return batches + [
            Batch(
                np.array([k for k, _ in members]),
                concatenate_predictions([prediction for _, prediction in members]),
            )
            for members in groups.values()
        ]

    @np.errstate(over="ignore", invalid="ignore", divide="ignore")
    def _batch_terms(self, values: Array) -> list[Batch]:
        """Return the modes for sets of values that differ in their terms only, without derivatives, many at once."""
        groups: dict[tuple[object, ...], list[tuple[int, PresentTerm, list[TermMatrices]]]] = {}
        for k, row in enumerate(values):
            present, sites = self._present_term(row), self._sites_at(row[: self._robot_count])
            if present is None or sum(len(site.setups) for site in sites) != len(self.robot.points):
                continue
            matrices = [self._matrices(site, present) for site in sites]
            key = (row[: self._robot_count].tobytes(), *((m.massless.tobytes(), m.rigid) for m in matrices))
            groups.setdefault(key, []).append((k, present, matrices))
        batches = []
        for group in groups.values():
            sets = np.array([k for k, *_ in group])
            sites = self._sites_at(values[sets[0], : self._robot_count])
            terms = [present.placed_term.term for _, present, _ in group]
            prediction = self._stacked(sites, terms, [matrices for *_, matrices in group])
            if prediction is not None:
                batches.append(Batch(sets, prediction))
        return batches

    def _stacked(
        self, sites: Sequence[Site], terms: Sequence[Term], matrices: Sequence[list[TermMatrices]]
    ) -> Prediction | None:
        """Return the modes of one robot with several terms in turn; None where one of them is not a machine."""
        setups, parts = len(self.robot.points), []
        for site, term_matrices_of_site in zip(sites, zip(*matrices, strict=True), strict=True):
            M, K = (
                np.concatenate(stack)
                for stack in zip(
                    *(term_matrices.in_free() for term_matrices in term_matrices_of_site), strict=True
                )
            )
            modes = eigenmodes(site.system.base_count, term_matrices_of_site[0], M, K)
            if modes is None:
                return None
            eigenvalues, shapes = modes
            platform = np.concatenate([np.real(platform_with(term, site.surroundings)) for term in terms])
            channels = channels_of(
                site.system, platform, in_all_coordinates(term_matrices_of_site[0], shapes)
            )
            rows = (setups * np.arange(len(terms))[:, None] + site.setups).ravel()
            rates = np.zeros((*eigenvalues.shape, 0))
            parts.append((rows, Prediction(eigenvalues, rates, channels, term_matrices_of_site[0].rigid)))
        return join_modes(parts, setups * len(terms))

    def _present_term(self, values: Array) -> PresentTerm | None:
        """Return the term that is present; with several, the first."""
        for placed_term in self.terms:
            index = list(placed_term.index)
            if values[index[0]] != self.parameters[index[0]].value:
                return PresentTerm(placed_term, values[index])
        return None

    def _term_prediction(
        self, rates: TermRates, values: Array, by: Sequence[int], shape_rates: bool
    ) -> Prediction:
        """Return the modes of a site with derivatives with respect to parameters of terms."""
        placed_terms = [(self._term_of_parameter[i], i) for i in by]
        entries = [
            (placed_term, placed_term.index.index(i), values[list(placed_term.index)])
            for placed_term, i in placed_terms
        ]
        return rates.of_terms(entries, shape_rates)

    def _failed_prediction(self, count: int) -> Prediction:
        """Return the prediction where no pose can be evaluated."""
        robot_prediction = self.robot.predict(np.array([p.value for p in self.robot.parameters]), ())
        eigenvalues = np.full_like(robot_prediction.eigenvalues, np.nan)
        return Prediction(
            eigenvalues,
            np.full((*eigenvalues.shape, count), np.nan),
            robot_prediction.shapes,
            robot_prediction.rigid,
        )

    # The robot and one term ----------------------------------------------------------------------------------

    def _sites_at(self, robot_values: Array) -> list[Site]:
        """Return the sites of the robot with values of its parameters, at the poses that it reaches."""
        key = robot_values.tobytes()
        if key not in self._sites:
            machines = self.robot.machines(robot_values)
            reached, sites = self.robot.reachable(machines), []
            for c, system in enumerate(machines.systems):
                setups = np.flatnonzero((self.robot.loads.case_index == c) & reached)
                if len(setups):
                    points = machines.points[setups]
                    matrices = system.all_coordinates(points)
                    sites.append(Site(setups, system, points, matrices, Surroundings(system, points)))
            self._sites[key] = sites
            while len(self._sites) > MAX_CACHED_ROBOTS:
                self._sites.popitem(last=False)
        return self._sites[key]

    def _modes_of_sites(self, values: Array, present: PresentTerm) -> list[tuple[Site, TermModes | None]]:
        """Return the sites with their modes; the last ones are kept."""
        key = values.tobytes()
        if self._cached_modes is None or self._cached_modes[0] != key:
            sites = self._sites_at(values[: self._robot_count])
            self._cached_modes = (
                key,
                [(site, term_modes(site, self._matrices(site, present))) for site in sites],
            )
        return self._cached_modes[1]

    def _matrices(self, site: Site, present: PresentTerm) -> TermMatrices:
        term, system = present.placed_term.term, site.system
        key = term.name, system.rigid_modes, len(system.free)
        if key not in self._held_counts:
            held_count = held_motions(site, term)
            if held_count is None:  # nor is it a machine with the term
                return matrices_with(site, present, 0)
            self._held_counts[key] = held_count
        return matrices_with(site, present, self._held_counts[key])


def _in_requested_order(
    robot: Prediction, terms: Prediction, by: Sequence[int], robot_count: int
) -> Prediction:
    """Return a prediction with the derivatives by the robot's parameters and by terms in the requested order."""
    robot_first = np.argsort([i >= robot_count for i in by], kind="stable")
    order = np.argsort(robot_first)
    rates = np.concatenate([robot.rates, terms.rates], axis=-1)[..., order]
    shape_rates = None
    if robot.shape_rates is not None and terms.shape_rates is not None:
        shape_rates = np.concatenate([robot.shape_rates, terms.shape_rates], axis=-1)[..., order]
    return Prediction(robot.eigenvalues, rates, robot.shapes, robot.rigid, shape_rates)


class ExtensibleRobot(RobotStructure):
    """A robot at poses that can be extended by the terms of its mechanism."""

    def with_terms(self) -> RobotWithTerms:
        """Return the robot with the parameters and candidates of all its terms beside its own."""
        terms = term_candidates(self)
        placed_terms, parameters = [], list(self.parameters)
        for term, term_parameters in terms.terms:
            placed_terms.append(
                PlacedTerm(term, tuple(range(len(parameters), len(parameters) + len(term_parameters))))
            )
            parameters += term_parameters
        return RobotWithTerms(self, placed_terms, parameters, [*terms.of_robot, *terms.candidates])
