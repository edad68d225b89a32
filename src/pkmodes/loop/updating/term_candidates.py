"""The terms of a robot as candidates of the diagnosis: parameters, bounds, plausible sizes, and where fits start.

Terms of the mechanism's description come with the single joints and the values of single axes that the catalogue
tries without claiming them: a compliance of the catalogue in one joint is ``compliance:<coordinate>``.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.linalg.eigen import condensed_eigh
from pkmodes.core.system.evaluation import ExtendedSystem
from pkmodes.loop.diagnosis.problem import Candidate, Parameter
from pkmodes.loop.updating.robot_structure import RobotStructure
from pkmodes.loop.updating.term_changes import Surroundings, change_of, strains
from pkmodes_description import Named, Term

Array = NDArray[np.float64]
#: Largest undeclared mass, relative to the effective mass at its place.
MAX_MASS_RATIO = 2.0
#: Largest undeclared spring stiffness, relative to the stiffness of the machine at its place.
MAX_STIFFNESS_RATIO = 10.0
#: Masses from which the fit of a resonator starts, relative to the effective mass at its place.
START_MASS_RATIOS = (0.03, 0.15, 0.6)
#: Number of frequencies from which its fit starts, and their range relative to the lowest and highest frequency of
#: the machine.
START_FREQUENCY_COUNT, LOWEST_START, HIGHEST_START = 20, 0.6, 1.15
#: Further frequencies from which the fit of a support's mode starts, relative to the machine's highest one: there
#: the support is hardly more than a spring in series.
STARTS_ABOVE = (1.4, 2.0, 3.0, 5.0, 8.0)
#: Compliances of a bearing without mass of its own, relative to that of the belt there.
START_COMPLIANCE_RATIOS = (0.003, 0.01, 0.03, 0.1, 0.3, 1.0, 3.0)
#: A row of displacements below this fraction of the largest counts as zero; rows that differ by less are the same.
ZERO_FRACTION = 1e-9
#: An inertia matrix, scaled to a unit diagonal, is singular if it has an eigenvalue below this.
MIN_EIGENVALUE = 1e-6


class _Machine(NamedTuple):
    """The declared machine at one of its poses: effective masses and compliances of its places."""

    system: ExtendedSystem
    surroundings: Surroundings
    M: Array
    eigenvalues: Array
    shapes: Array

    def rows(self, term: Term) -> Array:
        """Return the displacements that a term uses, in the free coordinates, (rows, n)."""
        if term.form == "mount":
            return np.zeros((0, len(self.system.free)))
        if term.form == "spring":
            return np.asarray(strains(term, self.surroundings)[0][:, self.system.free])
        row_indices = list(term.rows) or ([term.swings] if term.swings >= 0 else [])
        return np.asarray(self.surroundings.motion[0][row_indices][:, self.system.free])

    def has_inertia(self, term: Term) -> bool:
        """Return whether the motion that a mount releases has its own inertia: else the catalogue has it as a joint.

        A rail that yields along itself moves the same as its carriage; without any inertia it is condensed.
        """
        values = [1.0] * len(term.parameters)
        added_mass = change_of(term, values, self.surroundings).M[0]
        e = len(added_mass) - 1
        free = [*self.system.free, e]
        M = added_mass.copy()
        M[:e, :e] += self.M
        with_inertia = [q for q in free if M[q, q] > 0.0]
        M = M[np.ix_(with_inertia, with_inertia)]
        size = np.sqrt(np.diagonal(M))
        return bool(np.linalg.eigvalsh(M / np.outer(size, size))[0] > MIN_EIGENVALUE)

    def mobility(self, row: Array) -> float:
        """Return the inverse of the effective mass of a displacement."""
        return float(((self.shapes @ row) ** 2).sum())

    def flexibility(self, row: Array) -> float:
        """Return the compliance of the machine there, rigid motions left out."""
        first = self.system.rigid_modes
        return float(((self.shapes[first:] @ row) ** 2 / self.eigenvalues[first:]).sum())

    @property
    def smallest_effective_mass(self) -> float:
        """The smallest effective mass of a displaced body [kg]."""
        mass_terms = [term for term in self.system.mechanism.terms if term.form == "mass" and term.rows]
        rows = [row for term in mass_terms if term.parameters[0].unit == "kg" for row in self.rows(term)]
        return 1.0 / max(map(self.mobility, rows))

    @property
    def frequencies(self) -> Array:
        """Natural frequencies without rigid motions [Hz]."""
        elastic = self.eigenvalues[self.system.rigid_modes :]
        return np.sqrt(np.abs(elastic)) / (2.0 * np.pi)


class TermCandidates(NamedTuple):
    """Terms with their parameters and candidates, in the same order, and the robot's candidates beside them."""

    terms: list[tuple[Term, tuple[Parameter, ...]]]
    candidates: list[Candidate]
    of_robot: list[Candidate]


def term_candidates(structure: RobotStructure) -> TermCandidates:
    """Return the terms of a robot at its poses that change something there, each once."""
    declared = np.array([p.value for p in structure.parameters])
    machines = structure.machines(declared)
    case = int(np.argmax(np.bincount(structure.loads.case_index)))
    row = int(np.flatnonzero(structure.loads.case_index == case)[0])
    system, point = machines.systems[case], machines.points[row : row + 1]
    matrices = system.all_coordinates(point)
    M, K = (system.free_part(a) for a in matrices)
    eigenvalues, shapes = condensed_eigh(M, K, system.base_count, system.rigid_modes, system.massless)
    machine = _Machine(system, Surroundings(system, point), matrices[0][0], eigenvalues[0], shapes[0])
    terms: list[tuple[Term, tuple[Parameter, ...]]] = []
    candidates = []
    for term in _distinct_terms(structure.robot.mechanism.terms, machine):
        parameters = tuple(_parameter(term, named_parameter, machine) for named_parameter in term.parameters)
        starts = tuple(_STARTS[term.form](term, machine)) if term.form in _STARTS else ()
        names = tuple(p.name for p in parameters)
        terms.append((term, parameters))
        candidates.append(
            Candidate(term.name, names, term.sentence, remote=True, form=term.form, starts=starts)
        )
    return TermCandidates(
        terms, candidates, [_as_term(structure, candidate) for candidate in structure.candidates]
    )


def _distinct_terms(terms: Sequence[Term], machine: _Machine) -> Iterator[Term]:
    """Yield the terms that change the machine.

    A spring between two bodies is left out where it is the same as one from a single body to ground: where one of the
    bodies does not move that way, or both move alike.
    """
    grounded: list[Array] = []
    for term in terms:
        if term.form == "mount":
            if machine.has_inertia(term):
                yield term
            continue
        rows = machine.rows(term)
        if term.form == "mass" and not term.rows:
            yield term
            continue
        size = float(np.abs(rows).max(initial=0.0))
        if size <= ZERO_FRACTION:
            continue
        if term.form == "spring" and len(rows) == 1:
            direction = rows[0] / np.linalg.norm(rows[0])
            is_between_bodies = len(term.strains[0]) == 2
            if is_between_bodies and any(
                abs(abs(direction_to_ground @ direction) - 1.0) <= ZERO_FRACTION
                for direction_to_ground in grounded
            ):
                continue
            if not is_between_bodies:
                grounded.append(direction)
        yield term


def _parameter(term: Term, named_parameter: Named, machine: _Machine) -> Parameter:
    name, unit = f"{term.name}.{named_parameter.name}", named_parameter.unit.replace(" ", "*")
    rows = machine.rows(term)
    if named_parameter.name == "frequency":
        low, *_, high = _start_frequencies(machine)
        middle = float(np.sqrt(low * high))
        return Parameter(name, middle, unit, lower=0.3 * low, upper=3.0 * high)
    upper = None
    if named_parameter.name in ("mass", "inertia") and len(rows):
        largest_mobility = max(machine.mobility(row) for row in rows)
        upper = MAX_MASS_RATIO / largest_mobility if largest_mobility > 0.0 else None
    if named_parameter.name == "stiffness":
        largest_flexibility = max(machine.flexibility(row) for row in rows)
        upper = MAX_STIFFNESS_RATIO / largest_flexibility if largest_flexibility > 0.0 else None
    return Parameter(name, 0.0, unit, lower=0.0, usual=None if upper is None else (0.0, upper))


def _start_frequencies(machine: _Machine) -> Array:
    f = machine.frequencies
    low = LOWEST_START * float(f.min())
    return np.geomspace(low, max(HIGHEST_START * float(f.max()), 2.0 * low), START_FREQUENCY_COUNT)


def _starts_of_mount(term: Term, machine: _Machine) -> Iterator[tuple[float, ...]]:
    """Yield compliances from which a mount is fitted, with the mass of a bearing: its mode may be anywhere."""
    e = len(machine.M)
    masses = [0.0]
    if len(term.parameters) > 1:
        masses += [part * machine.smallest_effective_mass for part in START_MASS_RATIOS]
    for mass in masses:
        change = change_of(term, [1.0, mass][: len(term.parameters)], machine.surroundings)
        M = change.M[0].copy()
        M[:e, :e] += machine.M
        with_inertia = [q for q in (*machine.system.free, e) if M[q, q] > 0.0]
        mass_value = (mass,) if len(term.parameters) > 1 else ()
        if e in with_inertia:
            inertia = 1.0 / np.linalg.inv(M[np.ix_(with_inertia, with_inertia)])[-1, -1]
            for frequency in (
                *_start_frequencies(machine),
                *(np.array(STARTS_ABOVE) * machine.frequencies.max()),
            ):
                yield 1.0 / (inertia * (2.0 * np.pi * float(frequency)) ** 2), *mass_value
        else:  # without a mode of its own: compliances relative to those of the springs there
            stiffness = float(change.K[0, e, e]) - 1.0
            for part in START_COMPLIANCE_RATIOS if stiffness > 0.0 else ():
                yield part / stiffness, *mass_value


def _starts_of_resonator(term: Term, machine: _Machine) -> Iterator[tuple[float, float]]:
    """Yield masses and frequencies from which a resonator is fitted."""
    displacement = machine.surroundings.motion[0][term.swings][machine.system.free]
    effective_mass = 1.0 / machine.mobility(displacement)
    for frequency in _start_frequencies(machine):
        for part in START_MASS_RATIOS:
            yield part * effective_mass, float(frequency)


_STARTS: dict[str, Callable[[Term, _Machine], Iterator[tuple[float, ...]]]] = {
    "mount": _starts_of_mount,
    "resonator": _starts_of_resonator,
}


def _as_term(structure: RobotStructure, candidate: Candidate) -> Candidate:
    """Return a candidate of the robot; what acts at one joint or axis alone as a term."""
    if not candidate.remote or len(candidate.parameters) != 1:
        return candidate
    (path,) = candidate.parameters
    mechanism = structure.robot.mechanism
    for effect in mechanism.effects.values():
        for q in effect.coordinates:
            if path == f"effects.{effect.name}.{effect.parameters[0].name}.{q.name}":
                sentence = f"a compliance of one joint alone: {q.description}"
                return replace(
                    candidate,
                    name=f"compliance:{q.name}",
                    sentence=sentence,
                    form="compliance",
                    nameable=True,
                )
    if candidate.name == f"parameter:{path}" and path.startswith("axis."):
        return replace(candidate, sentence=f"another value of {path}", form="parameter")
    return candidate
