"""Measured frequency responses from a campaign file, under the names that the model's response has."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from os import PathLike, fspath
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import PkmodesError, shown
from pkmodes.core.support.ordering import listed
from pkmodes.machine.response.measured import MeasuredResponse
from pkmodes.modaltest.campaign.campaign import FRF_KIND, Campaign, Record, read_campaign
from pkmodes.modaltest.campaign.frequency_records import read_responses
from pkmodes.modaltest.campaign.impact_records import read_impact_responses
from pkmodes.modaltest.campaign.mode_estimates import NAMELESS
from pkmodes.modaltest.campaign.sensors import NEGATIVE, Transducer, without_sign

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
#: Kinds of records with frequency response functions, measured or to be estimated.
RESPONSE_KINDS = (FRF_KIND, "impact")
#: Times that an acceleration is integrated for each quantity of a response.
INTEGRALS = {"acceleration": 0, "velocity": 1, "displacement": 2}
#: A pose is that of a record within this distance [m, rad], or this many standard deviations of the record's pose.
MAX_POSE_DISTANCE, MAX_POSE_SIGMAS = 1e-6, 3.0
#: Largest weight of other channels, relative to that of the first, in a transducer along one channel.
MAX_CROSS_WEIGHT = 1e-3
#: Maximum number of names in an error.
MAX_NAMES = 8
#: Prefixes of the model's inputs by those of the channels along which they act.
INPUT_PREFIXES = {"p_": "force_", "r_": "moment_"}


@dataclass(frozen=True, eq=False)
class RecordResponse:
    """Accelerances of a record at F frequencies.

    - frequencies: (F,) [Hz]
    - channels: by ``OUTPUT/FORCE``, with the campaign's names of forces, each (F,)
    - excitations: of each force, the weights of the model's inputs that it is
    """

    frequencies: Array
    channels: dict[str, Complex]
    excitations: dict[str, Mapping[str, float]]


def record_response(campaign: Campaign, record: Record) -> RecordResponse:
    """Read the accelerances of a record whose forces the campaign places; repeats are averaged.

    Raises PkmodesError if the campaign places none of its forces, or none of its sensors is along a channel.
    Raises MeasurementError if one of its files is faulty.
    """
    unplaced, excitations = set[str](), dict[str, Mapping[str, float]]()

    def functions() -> Iterator[tuple[str, Array, Complex]]:
        for output, excitation, f, values in _functions(campaign, record, (), unplaced):
            # A force that acts elsewhere in another setup is drawn where it acts in the first.
            if excitations.setdefault(excitation.name, excitation.weights) == excitation.weights:
                yield f"{output}/{excitation.name}", f, values

    averages = _averaged(functions())
    if averages is None:
        remedy = "add [[force]] with its name in the files, its channel or direction, and fixed = true"
        raise _nothing_to_draw(unplaced, f"{campaign.source}: {record.pose}", remedy)
    return RecordResponse(*averages, excitations)


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
    unplaced, oblique, assumed = set[str](), set[str](), dict[str, str]()

    def functions() -> Iterator[tuple[str, Array, Complex]]:
        for record in records:
            for output, excitation, f, values in _functions(campaign, record, inputs, unplaced):
                port = _single_channel(excitation.weights)
                if port is None:
                    oblique.add(excitation.name)
                    continue
                if excitation.is_assumed:
                    assumed[excitation.name] = port[0]
                yield f"{output}/{port[0]}", f, port[1] * values

    averages = _averaged(functions())
    if averages is None and oblique:
        names = listed(sorted(map(shown, oblique)), MAX_NAMES)
        problem = f"expected a force along one input of the model, found {names} along several"
        remedy = "draw it on the page of a diagnosis: pkmodes diagnose with --campaign and --report"
        raise PkmodesError(problem, source, remedy)
    if averages is None:
        remedy = "ask for the input in which it acts alone, such as --inputs force_x"
        raise _nothing_to_draw(unplaced, source, remedy)
    frequencies, averaged_channels = averages
    omega = 2j * np.pi * frequencies
    channels = {name: values / omega ** INTEGRALS[quantity] for name, values in averaged_channels.items()}
    notes = [
        f"{source} does not say where the force {shown(name)} acts: it is taken as {into} at the platform's centre"
        for name, into in sorted(assumed.items())
    ]
    return MeasuredResponse(source, frequencies, channels, {"drives": records[0].drives}, tuple(notes))


def _averaged(functions: Iterable[tuple[str, Array, Complex]]) -> tuple[Array, dict[str, Complex]] | None:
    """Return the frequencies above 0 [Hz], (F,), and the mean of the functions of each channel, each (F,)."""
    f: Array | None = None
    values_by_name = dict[str, list[Complex]]()
    for name, frequencies, values in functions:
        f = frequencies if f is None else f
        # Functions of another resolution are left out.
        if len(frequencies) == len(f) and np.allclose(frequencies, f, rtol=1e-9):
            values_by_name.setdefault(name, []).append(values)
    if f is None:
        return None
    positive = f > 0.0
    return f[positive], {name: np.mean(values, axis=0)[positive] for name, values in values_by_name.items()}


def _nothing_to_draw(unplaced: Collection[str], where: str, remedy: str) -> PkmodesError:
    if not unplaced:
        remedy = "give a sensor along a channel of the robot, or enough of them to solve for its motion"
        return PkmodesError("expected a sensor along a channel of the robot, found none", where, remedy)
    names = listed(sorted(map(shown, unplaced)), MAX_NAMES)
    return PkmodesError(f"the campaign does not say where the force {names} acts", where, remedy)


def _records_at(campaign: Campaign, point: Sequence[float], source: str) -> list[Record]:
    """Return the records with frequency response functions at a pose."""
    if campaign.model is None:
        raise PkmodesError("expected the campaign of a robot", source, 'name its file, robot = "robot.toml"')
    names = [component.name for component in campaign.model.mechanism.pose]
    records = [record for record in campaign.records if record.kind in RESPONSE_KINDS]
    at_pose = [
        record
        for record in records
        if all(
            abs(record.point.get(name, 0.0) - value)
            <= max(MAX_POSE_DISTANCE, MAX_POSE_SIGMAS * record.point_sigma.get(name, 0.0))
            for name, value in zip(names, point, strict=True)
        )
    ]
    if not at_pose:
        poses = [
            f"{record.pose} ({','.join(f'{record.point.get(name, 0.0):g}' for name in names)})"
            for record in records
        ]
        problem = (
            f"expected frequency response functions at the pose, found those at {listed(poses, MAX_NAMES)}"
        )
        if not poses:
            problem = "expected records of frequency response functions, found none"
        raise PkmodesError(problem, source, "give --pose of one of them")
    return at_pose


class _Excitation(NamedTuple):
    """A force of the files.

    - weights: of the model's inputs that it is
    - is_assumed: whether the campaign does not say where it acts
    """

    name: str
    weights: Mapping[str, float]
    is_assumed: bool


def _functions(
    campaign: Campaign, record: Record, inputs: Sequence[str], unplaced: set[str]
) -> Iterator[tuple[str, _Excitation, Array, Complex]]:
    """Yield the functions of a record, accelerations per force: output, force, frequencies and values, each (F,).

    - unplaced: takes the names of forces that are left out, as the campaign does not say where they act
    """
    rotation = campaign.platform.rotation(record.point)
    for setup, paths in record.independent_setups.items():
        sensors, forces = campaign.sensors_in(setup), campaign.all_forces_in(setup)
        for path in paths:
            if record.kind == FRF_KIND:
                responses = read_responses(path, record, setup, campaign).responses
            else:
                responses = read_impact_responses(path, record, setup, campaign)
            values, sensor_names, force_names = responses.values, responses.names, responses.references
            if responses.is_roving:  # the places of the functions are those of the forces
                values, sensor_names, force_names = values.transpose(0, 2, 1), force_names, sensor_names
            for r, force_name in enumerate(force_names or ("",)):
                excitation = _excitation(force_name, sensors, forces, inputs, rotation)
                if excitation is None:
                    unplaced.add(force_name)
                    continue
                measured = [
                    (sensors[name], values[:, s, r])
                    for s, name in enumerate(sensor_names)
                    if name in sensors and np.isfinite(values[:, s, r]).all()
                ]
                for output, motion in _channels(measured, rotation):
                    yield output, excitation, responses.frequencies, motion


def _channels(
    measured: Sequence[tuple[Transducer, Complex]], rotation: Array
) -> Iterator[tuple[str, Complex]]:
    """Yield the motion of each channel, (F,): solved from all sensors where these determine it.

    Sensors beside the platform's centre measure several components of its motion.
    """
    weights = [sensor.rotated(rotation).weights for sensor, _ in measured]
    channels = list(dict.fromkeys(name for row in weights for name, weight in row.items() if weight))
    W = np.array([[row.get(name, 0.0) for name in channels] for row in weights])
    if channels and np.linalg.matrix_rank(W / np.abs(W).max(axis=0)) == len(channels):
        motions = np.linalg.pinv(W) @ np.array([values for _, values in measured])
        yield from zip(channels, motions, strict=True)
        return
    for sensor, values in measured:
        if (channel := _single_channel(sensor.rotated(rotation).weights)) is not None:
            yield channel[0], values * channel[1]


def _excitation(
    name: str,
    sensors: Mapping[str, Transducer],
    forces: Mapping[str, Transducer],
    inputs: Sequence[str],
    rotation: Array,
) -> _Excitation | None:
    """Return where a force acts, in inputs of the model; None where the campaign does not say.

    Without a [[force]] of that name, it acts where the sensor of that name measures, at the driving point; else it is
    the only force among the inputs of the model.
    """
    places = _places(name, sensors, forces)
    if not places:
        candidates = [port for port in inputs if port.startswith(tuple(INPUT_PREFIXES.values()))]
        sign = -1.0 if NEGATIVE.fullmatch(name) else 1.0  # an impact along a negative direction
        return _Excitation(name, {candidates[0]: sign}, True) if len(candidates) == 1 else None
    weights = {}
    for channel, weight in places[0].rotated(rotation).weights.items():
        prefix = INPUT_PREFIXES.get(channel[:2])
        if weight:
            weights[channel if prefix is None else prefix + channel[2:]] = weight
    return _Excitation(name, weights, False) if weights else None


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


def _single_channel(weights: Mapping[str, float]) -> tuple[str, float] | None:
    """Return the channel or input along which a transducer stands, and its sign; None where it is along several."""
    if not any(weights.values()):
        return None
    name = max(weights, key=lambda name: abs(weights[name]))
    cross_weight = max((abs(weight) for other, weight in weights.items() if other != name), default=0.0)
    is_single = cross_weight <= MAX_CROSS_WEIGHT * abs(weights[name])
    return (name, float(np.sign(weights[name]))) if is_single else None
