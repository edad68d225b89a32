"""Measured frequency responses from a campaign file, under the names that the model's response has."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from os import PathLike, fspath

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import PkmodesError, shown
from pkmodes.core.support.ordering import listed
from pkmodes.machine.response.measured import MeasuredResponse
from pkmodes.modaltest.campaign.campaign import FRF_KIND, Campaign, Record, read_campaign
from pkmodes.modaltest.campaign.frequency_records import read_responses
from pkmodes.modaltest.campaign.impact_records import impact_modes
from pkmodes.modaltest.campaign.mode_estimates import NAMELESS
from pkmodes.modaltest.campaign.sensors import NEGATIVE, Transducer, without_sign

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
#: Kind of record with blows in time.
BLOWS = "impact"
#: Times that an acceleration is integrated for each quantity of a response.
INTEGRALS = {"acceleration": 0, "velocity": 1, "displacement": 2}
#: A pose is that of a record within this distance [m, rad], and this many standard deviations of the record's.
NEAR, SIGMAS = 1e-6, 3.0
#: Largest part of another channel in a sensor that still counts as one channel.
ASIDE = 1e-3
#: Most poses named in an error.
MOST = 8
#: Inputs of the model by the beginnings of the channels along which they act.
ACTING = {"p_": "force_", "r_": "moment_"}


def campaign_response(
    path: str | PathLike[str], point: Sequence[float], quantity: str, inputs: Sequence[str] = ()
) -> MeasuredResponse:
    """Read the frequency responses that a campaign measured at a pose.

    Sensors and forces are the outputs and inputs of the model that the campaign says they are; repeats are averaged.

    - path: the campaign file
    - point: the pose, components in SI units, (d,)
    - quantity: of the outputs, as that of the model's response
    - inputs: of the model's response; a force that the campaign does not place is the only one of these

    Raises PkmodesError if the campaign has no robot, or no frequency response functions at the pose.
    Raises MeasurementError if the campaign or one of its files is faulty.
    """
    source, campaign = fspath(path), read_campaign(path)
    records = _records_at(campaign, point, source)
    f: Array | None = None
    sums: dict[str, Complex] = {}
    counts: dict[str, int] = {}
    unplaced, assumed = set[str](), dict[str, str]()
    for record in records:
        for name, frequencies, values in _functions(campaign, record, inputs, unplaced, assumed):
            f = frequencies if f is None else f
            if len(frequencies) != len(f) or not np.allclose(frequencies, f, rtol=1e-9):
                continue  # of another resolution: its lines are not those of the first
            sums[name] = sums.get(name, np.zeros(len(f), complex)) + values
            counts[name] = counts.get(name, 0) + 1
    if f is None:
        names = listed(sorted(map(shown, unplaced)), MOST)
        problem = f"the campaign does not say where the force {names} acts"
        if not unplaced:
            problem = "expected a sensor along a channel of the robot, found none"
        raise PkmodesError(
            problem, source, "ask for the input in which it acts alone, such as --inputs force_x"
        )
    kept = f > 0.0
    omega = 2j * np.pi * f[kept]
    channels = {
        name: (total / counts[name])[kept] / omega ** INTEGRALS[quantity] for name, total in sums.items()
    }
    notes = [
        f"{source} does not say where the force {shown(name)} acts: it is taken as {into} at the platform's centre"
        for name, into in sorted(assumed.items())
    ]
    return MeasuredResponse(source, f[kept], channels, {"drives": records[0].drives}, tuple(notes))


def _records_at(campaign: Campaign, point: Sequence[float], source: str) -> list[Record]:
    """Return the records with frequency response functions at a pose."""
    if campaign.model is None:
        raise PkmodesError("expected the campaign of a robot", source, 'name its file, robot = "robot.toml"')
    names = [component.name for component in campaign.model.mechanism.pose]
    records = [record for record in campaign.records if record.kind in (FRF_KIND, BLOWS)]
    found = [
        record
        for record in records
        if all(
            abs(record.point.get(name, 0.0) - value) <= max(NEAR, SIGMAS * record.point_sigma.get(name, 0.0))
            for name, value in zip(names, point, strict=True)
        )
    ]
    if not found:
        poses = [
            f"{record.pose} ({','.join(f'{record.point.get(name, 0.0):g}' for name in names)})"
            for record in records
        ]
        problem = f"expected frequency response functions at the pose, found those at {listed(poses, MOST)}"
        if not poses:
            problem = "expected records of frequency response functions, found none"
        raise PkmodesError(problem, source, "give --pose of one of them")
    return found


def _functions(
    campaign: Campaign, record: Record, inputs: Sequence[str], unplaced: set[str], assumed: dict[str, str]
) -> Iterator[tuple[str, Array, Complex]]:
    """Yield the functions of a record, accelerations per force: ``OUTPUT/INPUT``, frequencies and values, each (F,).

    - unplaced, assumed: take the names of forces of which the campaign does not say where they act: those left out,
      and those taken as an input
    """
    rotation = campaign.platform.rotation(record.point)
    for setup, paths in record.independent_setups.items():
        sensors, forces = campaign.sensors_in(setup), campaign.forces_in(setup)
        for path in paths:
            if record.kind == FRF_KIND:
                read = read_responses(path, record, setup, campaign).responses
                f, values, rows, columns = read.frequencies, read.values, read.names, read.references
                roves = read.is_roving
            else:
                modes = impact_modes(path, record, setup, campaign)
                assert modes.fit is not None
                f, values = modes.fit.estimate.frequencies, modes.fit.estimate.measured
                rows, columns, roves = modes.fit.responses, modes.fit.references, bool(modes.forces)
            if roves:  # the places of the functions are those of the forces
                values, rows, columns = values.transpose(0, 2, 1), columns, rows
            places = [sensors.get(name) for name in rows]
            for r, column in enumerate(columns or ("",)):
                into = _acting(column, sensors, forces, inputs, rotation)
                if into is None:
                    unplaced.add(column)
                    continue
                if not _places(column, sensors, forces):
                    assumed[column] = into[0]
                measured = [
                    (place, values[:, s, r])
                    for s, place in enumerate(places)
                    if place is not None and np.isfinite(values[:, s, r]).all()
                ]
                for output, motion in _channels(measured, rotation):
                    yield f"{output}/{into[0]}", f, into[1] * motion


def _channels(
    measured: Sequence[tuple[Transducer, Complex]], rotation: Array
) -> Iterator[tuple[str, Complex]]:
    """Yield the motion of each channel, (F,): solved from all sensors where these determine it.

    Sensors beside the platform's centre measure several components of its motion.
    """
    weights = [place.rotated(rotation).weights for place, _ in measured]
    channels = list(dict.fromkeys(name for one in weights for name, weight in one.items() if weight))
    W = np.array([[one.get(name, 0.0) for name in channels] for one in weights])
    if channels and np.linalg.matrix_rank(W / np.abs(W).max(axis=0)) == len(channels):
        motions = np.linalg.pinv(W) @ np.array([values for _, values in measured])
        yield from zip(channels, motions, strict=True)
        return
    for place, values in measured:
        port = _port(place, rotation)
        if port is not None:
            yield port[0], values * port[1]


def _acting(
    name: str,
    sensors: Mapping[str, Transducer],
    forces: Mapping[str, Transducer],
    inputs: Sequence[str],
    rotation: Array,
) -> tuple[str, float] | None:
    """Return the input of the model in which a force acts, and its sign; None where the campaign does not say.

    Without a [[force]] of that name, it acts where the sensor of that name measures, at the driving point; else it is
    the only force among the inputs of the model.
    """
    places = _places(name, sensors, forces)
    if not places:
        pushing = [into for into in inputs if into.startswith(tuple(ACTING.values()))]
        against = bool(NEGATIVE.fullmatch(name))  # a hammer blow along a negative direction
        return (pushing[0], -1.0 if against else 1.0) if len(pushing) == 1 else None
    port = _port(places[0], rotation)
    if port is None:
        return None
    channel, sign = port
    beginning = next((one for one in ACTING if channel.startswith(one)), None)
    return (channel if beginning is None else ACTING[beginning] + channel[len(beginning) :]), sign


def _places(
    name: str, sensors: Mapping[str, Transducer], forces: Mapping[str, Transducer]
) -> list[Transducer]:
    """Return where a force acts as the campaign says it; empty where it does not."""
    plain = without_sign(name)
    places = [
        place
        for place in (*forces.values(), *sensors.values())
        if without_sign(place.name) == plain and plain
    ]
    return [*forces.values()] if not places and name in NAMELESS and len(forces) == 1 else places


def _port(place: Transducer | None, rotation: Array) -> tuple[str, float] | None:
    """Return the channel along which a transducer stands, and its sign; None where it is along several."""
    if place is None:
        return None
    weights = {name: weight for name, weight in place.rotated(rotation).weights.items() if weight}
    if not weights:
        return None
    channel = max(weights, key=lambda name: abs(weights[name]))
    aside = max((abs(weight) for name, weight in weights.items() if name != channel), default=0.0)
    return (channel, float(np.sign(weights[channel]))) if aside <= ASIDE * abs(weights[channel]) else None
