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
HEAVIEST = 2.0
#: Largest undeclared spring stiffness, relative to the stiffness of the machine at its place.
STIFFEST = 10.0
#: Masses from which the fit of a resonator starts, relative to the effective mass at its place.
PARTS = (0.03, 0.15, 0.6)
#: Number of frequencies from which its fit starts, and their range relative to the lowest and highest frequency of
#: the machine.
FREQUENCIES, LOWEST, HIGHEST = 20, 0.6, 1.15
#: Frequencies above that range from which the fit of a support's mode starts, relative to the highest of the machine:
#: the support is then hardly more than a spring in series.
ABOVE = (1.4, 2.0, 3.0, 5.0, 8.0)
#: Compliances of a bearing without mass of its own, relative to that of the belt there.
YIELDS = (0.003, 0.01, 0.03, 0.1, 0.3, 1.0, 3.0)
#: A row of displacements below this fraction of the largest counts as zero; rows that differ by less are the same.
ZERO = 1e-9
#: An inertia matrix, scaled to a unit diagonal, is singular if it has an eigenvalue below this.
SINGULAR = 1e-6


class _Machine(NamedTuple):
    """The declared machine at one of its poses: effective masses and compliances of its places."""

    system: ExtendedSystem
    around: Surroundings
    M: Array
    eigenvalues: Array
    shapes: Array

    def rows(self, term: Term) -> Array:
        """Return the displacements that a term uses, in the free coordinates, (rows, n)."""
        if term.form == "mount":
            return np.zeros((0, len(self.system.free)))
        if term.form == "spring":
            return np.asarray(strains(term, self.around)[0][:, self.system.free])
        which = list(term.rows) or ([term.swings] if term.swings >= 0 else [])
        return np.asarray(self.around.motion[0][which][:, self.system.free])

    def has_inertia(self, term: Term) -> bool:
        """Return whether the motion that a mount releases has its own inertia: else the catalogue has it as a joint.

        A rail that yields along itself moves the same as its carriage; without any inertia it is condensed.
        """
        values = [1.0] * len(term.parameters)
        added = change_of(term, values, self.around).M[0]
        e = len(added) - 1
        free = [*self.system.free, e]
        M = added.copy()
        M[:e, :e] += self.M
        heavy = [q for q in free if M[q, q] > 0.0]
        M = M[np.ix_(heavy, heavy)]
        size = np.sqrt(np.diagonal(M))
        return bool(np.linalg.eigvalsh(M / np.outer(size, size))[0] > SINGULAR)

    def mobility(self, row: Array) -> float:
        """Return the inverse of the effective mass of a displacement."""
        return float(((self.shapes @ row) ** 2).sum())

    def flexibility(self, row: Array) -> float:
        """Return the compliance of the machine there, rigid motions left out."""
        first = self.system.rigid_modes
        return float(((self.shapes[first:] @ row) ** 2 / self.eigenvalues[first:]).sum())

    @property
    def heft(self) -> float:
        """The smallest effective mass of a displaced body [kg]."""
        heavy = [term for term in self.system.mechanism.terms if term.form == "mass" and term.rows]
        rows = [row for term in heavy if term.parameters[0].unit == "kg" for row in self.rows(term)]
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
    case = int(np.argmax(np.bincount(structure.loads.of)))
    row = int(np.flatnonzero(structure.loads.of == case)[0])
    system, point = machines.systems[case], machines.where[row : row + 1]
    matrices = system.all_coordinates(point)
    M, K = (system.free_part(a) for a in matrices)
    eigenvalues, shapes = condensed_eigh(M, K, system.base_count, system.rigid_modes, system.massless)
    machine = _Machine(system, Surroundings(system, point), matrices[0][0], eigenvalues[0], shapes[0])
    kept: list[tuple[Term, tuple[Parameter, ...]]] = []
    candidates = []
    for term in _different(structure.robot.mechanism.terms, machine):
        parameters = tuple(_parameter(term, named, machine) for named in term.parameters)
        starts = tuple(_STARTS[term.form](term, machine)) if term.form in _STARTS else ()
        names = tuple(p.name for p in parameters)
        kept.append((term, parameters))
        candidates.append(
            Candidate(term.name, names, term.sentence, remote=True, form=term.form, starts=starts)
        )
    return TermCandidates(
        kept, candidates, [_of_robot(structure, candidate) for candidate in structure.candidates]
    )


def _different(terms: Sequence[Term], machine: _Machine) -> Iterator[Term]:
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
        if size <= ZERO:
            continue
        if term.form == "spring" and len(rows) == 1:
            direction = rows[0] / np.linalg.norm(rows[0])
            between = len(term.strains[0]) == 2
            if between and any(abs(abs(earlier @ direction) - 1.0) <= ZERO for earlier in grounded):
                continue
            if not between:
                grounded.append(direction)
        yield term


def _parameter(term: Term, named: Named, machine: _Machine) -> Parameter:
    name, unit = f"{term.name}.{named.name}", named.unit.replace(" ", "*")
    rows = machine.rows(term)
    if named.name == "frequency":
        low, *_, high = _band(machine)
        middle = float(np.sqrt(low * high))
        return Parameter(name, middle, unit, lower=0.3 * low, upper=3.0 * high)
    upper = None
    if named.name in ("mass", "inertia") and len(rows):
        felt = max(machine.mobility(row) for row in rows)
        upper = HEAVIEST / felt if felt > 0.0 else None
    if named.name == "stiffness":
        yields = max(machine.flexibility(row) for row in rows)
        upper = STIFFEST / yields if yields > 0.0 else None
    return Parameter(name, 0.0, unit, lower=0.0, usual=None if upper is None else (0.0, upper))


def _band(machine: _Machine) -> Array:
    f = machine.frequencies
    low = LOWEST * float(f.min())
    return np.geomspace(low, max(HIGHEST * float(f.max()), 2.0 * low), FREQUENCIES)


def _starts_of_mount(term: Term, machine: _Machine) -> Iterator[tuple[float, ...]]:
    """Yield compliances from which a mount is fitted, with the mass of a bearing: its mode may be anywhere."""
    e = len(machine.M)
    masses = [0.0]
    if len(term.parameters) > 1:
        masses += [part * machine.heft for part in PARTS]
    for mass in masses:
        change = change_of(term, [1.0, mass][: len(term.parameters)], machine.around)
        M = change.M[0].copy()
        M[:e, :e] += machine.M
        inertial = [q for q in (*machine.system.free, e) if M[q, q] > 0.0]
        further = (mass,) if len(term.parameters) > 1 else ()
        if e in inertial:
            inertia = 1.0 / np.linalg.inv(M[np.ix_(inertial, inertial)])[-1, -1]
            for frequency in (*_band(machine), *(np.array(ABOVE) * machine.frequencies.max())):
                yield 1.0 / (inertia * (2.0 * np.pi * float(frequency)) ** 2), *further
        else:  # no mode of its own: what it gives way beside the springs there
            stiffness = float(change.K[0, e, e]) - 1.0
            for part in YIELDS if stiffness > 0.0 else ():
                yield part / stiffness, *further


def _starts_of_resonator(term: Term, machine: _Machine) -> Iterator[tuple[float, float]]:
    """Yield masses and frequencies from which a resonator is fitted."""
    swings = machine.around.motion[0][term.swings][machine.system.free]
    felt = 1.0 / machine.mobility(swings)
    for frequency in _band(machine):
        for part in PARTS:
            yield part * felt, float(frequency)


_STARTS: dict[str, Callable[[Term, _Machine], Iterator[tuple[float, ...]]]] = {
    "mount": _starts_of_mount,
    "resonator": _starts_of_resonator,
}


def _of_robot(structure: RobotStructure, candidate: Candidate) -> Candidate:
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
