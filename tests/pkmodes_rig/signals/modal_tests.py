"""Modal tests of the rig: what is excited how, at which poses, and what the files of each record hold."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from pkmodes_rig.signals import excitation
from pkmodes_rig.signals.analyser import Functions, averaged, together
from pkmodes_rig.signals.integration import responses, responses_with_friction
from pkmodes_rig.signals.sensors import OVERSAMPLED, Room, Sensor, heard, sampled
from pkmodes_rig.signals.small_motion import SmallMotion

#: Sampling rate of the laboratory, and of the integration [Hz].
RATE = 1024.0
STEP = 1.0 / (RATE * OVERSAMPLED)
#: Where the hammer first meets the machine in a file [s], and how long it stays there.
FIRST_BLOW, BLOW = 0.05, 0.0025
#: What a double hit is: when the second blow comes [s], and its size.
BOUNCE, BOUNCED = 0.035, 0.4
#: Band of the shaker, and the cut-off of ambient forces [Hz].
SHAKEN, AMBIENT_CUT = (5.0, 420.0), 450.0
#: Time that ambient vibration has had to build up [s].
BEFORE = 5.0

#: A direction: components along coordinates and platform directions.
Direction = Mapping[str, float]


@dataclass(frozen=True)
class Flaws:
    """What goes wrong in single files, by (record, repeat).

    Attributes
    ----------
    double_hits, overloads : frozenset of (int, int)
    dead : int or None
        Number of a sensor whose cable is broken.
    """

    double_hits: frozenset[tuple[int, int]] = frozenset()
    overloads: frozenset[tuple[int, int]] = frozenset()
    dead: int | None = None


@dataclass(frozen=True, eq=False)
class ModalTest:
    """How records are made.

    Attributes
    ----------
    kind : str
        ``frf``, ``impact`` or ``ambient``.
    sensors : tuple of Sensor
    room : Room
    exciters : tuple of mapping
        Directions of the hammer or the shakers, one after the other; of all ambient forces.
    size : float
        Largest force of a blow [N], rms of a shaker [N], power spectral density of ambient forces [N^2/Hz].
    seconds : float
        Length of a hit, of a block of the analyser or of an ambient record.
    averages, hits : int
        Blocks of the analyser, blows in a file.
    flaws : Flaws
    """

    kind: str
    sensors: tuple[Sensor, ...]
    room: Room
    exciters: tuple[Direction, ...]
    size: float
    seconds: float
    averages: int = 3
    hits: int = 1
    flaws: Flaws = field(default_factory=Flaws)

    @property
    def count(self) -> int:
        """Steps of integration of one force in a file."""
        blocks = {"frf": 2 * self.averages, "impact": self.hits, "ambient": 1}[self.kind]
        seconds = blocks * self.seconds + (BEFORE if self.kind == "ambient" else 0.0)
        return round(seconds / STEP)


@dataclass(frozen=True, eq=False)
class Recorded:
    """What a file holds: signals in time, or functions; and how strongly each exciter acted.

    Attributes
    ----------
    force : ndarray, shape (N,), or None
    motion : ndarray, shape (N, S), or None
    functions : Functions or None
    frequencies, power : ndarray, shapes (F,), (F, exciters)
        One-sided power spectral density of the forces [N^2/Hz], averages counted as if they added up.
    """

    force: np.ndarray | None
    motion: np.ndarray | None
    functions: Functions | None
    frequencies: np.ndarray
    power: np.ndarray


def recorded(
    test: ModalTest, machines: Mapping[tuple[int, int], SmallMotion], rng: np.random.Generator
) -> dict[tuple[int, int], Recorded]:
    """Record all files of a test.

    Parameters
    ----------
    test : ModalTest
    machines : mapping of (int, int) to SmallMotion
        The machine as it is in each record and repeat.
    rng : numpy.random.Generator
    """
    jobs = [
        (place, i) for place in machines for i in range(1 if test.kind == "ambient" else len(test.exciters))
    ]
    forces = [_force(test, place, rng) for place, _ in jobs]
    intos = [_into(test, machines[place], i) for place, i in jobs]
    rows = [_rows(test, machines[place]) for place, _ in jobs]
    moving = [machines[place] for place, _ in jobs]
    if moving[0].coulomb:
        motions = responses_with_friction(moving, STEP, forces, intos, rows)
    else:
        each = zip(moving, forces, intos, rows, strict=True)
        motions = [responses(one, STEP, force, into, row) for one, force, into, row in each]
    found: dict[tuple[int, int], Recorded] = {}
    for place in machines:
        own = [k for k, (other, _) in enumerate(jobs) if other == place]
        found[place] = _KINDS[test.kind](
            test, place, [forces[k] for k in own], [motions[k] for k in own], rng
        )
    return found


def _into(test: ModalTest, machine: SmallMotion, exciter: int) -> np.ndarray:
    every = np.array(
        [sum(part * machine.shapes[name] for name, part in one.items()) for one in test.exciters]
    )
    return every if test.kind == "ambient" else every[exciter : exciter + 1]


def _rows(test: ModalTest, machine: SmallMotion) -> np.ndarray:
    return np.array([sensor.row(machine.shapes) for sensor in test.sensors])


def _force(test: ModalTest, place: tuple[int, int], rng: np.random.Generator) -> np.ndarray:
    """Return the force before it is measured, shape (N, 1) or (N, exciters)."""
    if test.kind == "ambient":
        sizes = [test.size] * len(test.exciters)
        return excitation.broadband(rng, STEP, test.count, sizes, AMBIENT_CUT)
    if test.kind == "impact":
        starts = [FIRST_BLOW + test.seconds * k for k in range(test.hits)]
        sizes = list(test.size * rng.uniform(0.6, 1.4, test.hits))
        if place in test.flaws.double_hits:
            starts, sizes = [*starts, starts[0] + BOUNCE], [*sizes, BOUNCED * sizes[0]]
        return excitation.half_sines(STEP, test.count, starts, sizes, BLOW)[:, None]
    block = round(test.seconds / STEP)
    periods = [
        np.tile(excitation.multisine(rng, STEP, block, SHAKEN, test.size), 2) for _ in range(test.averages)
    ]
    return np.concatenate(periods)[:, None]


def _heard(
    test: ModalTest, place: tuple[int, int], motion: np.ndarray, rng: np.random.Generator
) -> np.ndarray:
    """Return what the sensors record: with noise, an overload, a broken cable."""
    found = heard(sampled(motion), 1.0 / RATE, test.sensors, test.room, rng)
    if place in test.flaws.overloads:
        limit = 0.3 * np.abs(found).max(axis=0)
        found = np.clip(found, -limit, limit)
    if test.flaws.dead is not None:
        found[:, test.flaws.dead] = 0.0
    return found


def _impact(
    test: ModalTest,
    place: tuple[int, int],
    forces: Sequence[np.ndarray],
    motions: Sequence[np.ndarray],
    rng: np.random.Generator,
) -> Recorded:
    force = sampled(forces[0][:, 0])
    force += 1e-3 * np.abs(force).max() * rng.standard_normal(len(force))
    lines = np.fft.rfftfreq(round(test.seconds * RATE), 1.0 / RATE)
    whole = np.fft.rfftfreq(len(force), 1.0 / RATE)
    blows = np.abs(np.fft.rfft(sampled(forces[0][:, 0]))) / RATE
    # Blows of a file add up their powers; between the lines of the whole file they interfere.
    smooth = np.sqrt(np.convolve(blows**2, np.ones(4 * test.hits + 1) / (4 * test.hits + 1), mode="same"))
    power = np.interp(lines, whole, 2.0 * smooth**2 / test.seconds)
    return Recorded(force, _heard(test, place, motions[0], rng), None, lines, power[:, None])


def _ambient(
    test: ModalTest,
    place: tuple[int, int],
    forces: Sequence[np.ndarray],
    motions: Sequence[np.ndarray],
    rng: np.random.Generator,
) -> Recorded:
    motion = _heard(test, place, motions[0], rng)[round(BEFORE * RATE) :]
    lines = np.array([0.0, RATE])
    return Recorded(None, motion, None, lines, np.full((2, len(test.exciters)), test.size))


def _frf(
    test: ModalTest,
    place: tuple[int, int],
    forces: Sequence[np.ndarray],
    motions: Sequence[np.ndarray],
    rng: np.random.Generator,
) -> Recorded:
    block, parts = round(test.seconds * RATE), list[Functions]()
    for force, motion in zip(forces, motions, strict=True):
        cell = sampled(force[:, 0])
        cell += 1e-3 * test.size * rng.standard_normal(len(cell))
        parts.append(averaged(1.0 / RATE, cell, _heard(test, place, motion, rng), block, SHAKEN[1]))
    power = test.averages * test.size**2 / (SHAKEN[1] - SHAKEN[0])
    return Recorded(None, None, together(parts), np.array(SHAKEN), np.full((2, len(parts)), power))


_KINDS = {"impact": _impact, "ambient": _ambient, "frf": _frf}
