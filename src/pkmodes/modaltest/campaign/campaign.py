"""A campaign: what was measured at which poses, with which sensors; checked, and in SI units."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from os import PathLike, fspath
from pathlib import Path

from pkmodes.core.base.drives import FREE
from pkmodes.core.base.errors import MeasurementError, PkmodesError, nearest_name, shown
from pkmodes.core.model import Model
from pkmodes.core.robot.reading import read_robot
from pkmodes.core.robot.report_fields import read_report
from pkmodes.loop.measured.rules import PRINTABLE_REMEDY, is_label
from pkmodes.loop.updating.channels import channels
from pkmodes.loop.updating.load_cases import settable_paths
from pkmodes.modaltest.campaign.boards import Clock, read_clocks
from pkmodes.modaltest.campaign.description import (
    CampaignTable,
    EditTable,
    RecordTable,
    parse_band,
    parse_fraction,
    parse_frequency,
    parse_quantity,
    parse_uncertain,
    read_description,
)
from pkmodes.modaltest.campaign.mounts import Platform
from pkmodes.modaltest.campaign.sensors import (
    NO_CHANNEL,
    Force,
    MotionSensor,
    Transducer,
    check_forces,
    check_names_in_files,
    check_sensors,
)
from pkmodes.modaltest.identification.requested_modes import NO_EDITS, RequestedModes

#: Value of `repeatability` other than a share: estimate it from poses that were measured twice.
REVISITS = "revisits"
#: Unit of the components of shapes that are angles.
ANGLE = "rad"
#: Kind of record with frequency response functions.
FRF_KIND = "frf"


@dataclass(frozen=True)
class Record:
    """What was measured at one pose, in one load case.

    - number: in the file, from 1
    - point, point_sigma: components of the pose in SI units, and their standard deviations
    - settings: known values of parameters by path, in SI units
    - setups: files of each setup: repeats.  The only setup of a plain list is called "".
    - band: [Hz]
    - exponential, rate: time constant of an exponential window [s], and sampling rate [Hz]
    - columns: names of a table's columns, by those of a measurement file
    - header: names of all columns of a table of signals, in order, where its own header is missing or different
    - names: names that the files use for time, frequency, force and sensors, by the names in the campaign
    - invert, conjugate: whether the functions are force over motion, or complex conjugates
    - clocks: of all setups except the first, if they are boards that recorded together
    """

    number: int
    pose: str
    point: Mapping[str, float]
    point_sigma: Mapping[str, float]
    settings: Mapping[str, float]
    kind: str
    setups: Mapping[str, tuple[Path, ...]]
    band: tuple[float, float]
    drives: str
    averages: int | None
    exponential: float | None
    hits: int
    rate: float | None
    columns: Mapping[str, str]
    header: tuple[str, ...] = ()
    names: Mapping[str, str] = field(default_factory=dict)
    invert: bool = False
    conjugate: bool = False
    clocks: Mapping[str, Clock] = field(default_factory=dict)

    @property
    def independent_setups(self) -> Mapping[str, tuple[Path, ...]]:
        """The setups that are identified separately: boards that recorded together count as one."""
        return dict(list(self.setups.items())[:1]) if self.clocks else self.setups

    def simultaneous_files(self, path: Path) -> dict[str, Path]:
        """Return the files that other boards recorded together with one of the first board, by setup."""
        number = next(iter(self.setups.values())).index(path) if self.clocks else 0
        return {setup: self.setups[setup][number] for setup in self.clocks}


@dataclass(frozen=True)
class Campaign:
    """A campaign.

    - model: of the robot; None for another structure
    - channels: names that shape components may have, with their units; those of another structure may be lengths or
      angles, and have none
    - repeatability: relative standard deviation of a frequency when a pose is approached again; None to estimate it
    - tones: of mains, fans and motors [Hz]: these and their multiples are not modes
    - edits: what the user decides about the modes of records, by their labels
    - report: fields of the head of its report, which prevail over those of the robot
    - signs_of_file: whether the sign in the name of a degree of freedom is that of the direction
    """

    source: str
    model: Model | None
    channels: Mapping[str, str]
    repeatability: float | None
    tones: tuple[float, ...]
    sensors: tuple[MotionSensor, ...]
    forces: tuple[Force, ...]
    records: tuple[Record, ...]
    edits: Mapping[str, RequestedModes]
    report: Mapping[str, str] = field(default_factory=dict)
    signs_of_file: bool = False

    @property
    def platform(self) -> Platform:
        """The axes along and about which the platform moves."""
        return _platform(self.model)

    @cached_property
    def lengths(self) -> Mapping[str, float]:
        """What makes metres of the components of shapes that are angles, by channel and by key of the sensor.

        It is the characteristic length of the platform; empty where none turns.
        """
        if self.model is None or not self.platform.rotations:
            return {}
        angles = [name for name, unit in self.channels.items() if unit == ANGLE]
        angles += [
            sensor.key
            for sensor in self.sensors
            if (sensor.mount.angular if sensor.mount else any(name in angles for name in sensor.weights))
        ]
        return dict.fromkeys(angles, self.model.characteristic_length)

    def sensors_in(self, setup: str) -> dict[str, MotionSensor]:
        """Return the sensors that apply to a setup, by name."""
        return {sensor.name: sensor for sensor in self.sensors if sensor.setup in (None, setup)}

    def forces_in(self, setup: str) -> dict[str, Transducer]:
        """Return the points of a roving hammer that apply to a setup, by name: the places of shapes."""
        return {name: force for name, force in self.all_forces_in(setup).items() if not force.fixed}

    def all_forces_in(self, setup: str) -> dict[str, Force]:
        """Return the forces that apply to a setup, by name, fixed ones included."""
        return {force.name: force for force in self.forces if force.setup in (None, setup)}

    def edits_of(self, record: Record) -> RequestedModes:
        """Return the user's edits of the modes of a record."""
        return self.edits.get(record.pose, NO_EDITS)

    def transducers_at(self, record: Record) -> dict[str, Transducer]:
        """Return sensors and forces of all setups, by key, as oriented at the pose of a record."""
        R = self.platform.rotation(record.point)
        return {transducer.key: transducer.rotated(R) for transducer in (*self.sensors, *self.forces)}


def read_campaign(path: str | PathLike[str]) -> Campaign:
    """Read and check a campaign file; the files that it names are not read.

    - path: a TOML file, format 1.  Paths in it are relative to its folder.

    Raises MeasurementError if the file cannot be read, or anything in it is wrong: with the place in it.
    Raises RobotFileError if the robot file is invalid.
    """
    source = fspath(path)
    return check_campaign(read_description(Path(path)), source)


def check_campaign(table: CampaignTable, source: str) -> Campaign:
    """Check the tables of a campaign file; `source` is its path."""
    folder = Path(source).parent
    if (table.robot is None) == (table.channels is None):
        problem = "expected either a robot or channels, found " + (
            "both" if table.robot is not None else "neither"
        )
        raise MeasurementError(
            problem, source, 'write robot = "robot.toml", or channels = ["floor_1"] for a structure'
        )
    model = None if table.robot is None else Model(read_robot(folder / table.robot))
    _check_channels(table.channels or [], source)
    channel_units = dict.fromkeys(table.channels or (), "") if model is None else channels(model.mechanism)
    if not table.record:
        raise MeasurementError(
            "expected records, found none", f"{source}: record", "add [[record]] for each pose"
        )
    band = parse_band(table.band, f"{source}: band")
    records = tuple(
        _record(record, i, table, model, folder, band, f"{source}: record.{i}")
        for i, record in enumerate(table.record, start=1)
    )
    _check_labels(records, source)
    setups = {name for record in records for name in record.setups}

    def refuse_field(path: str, what: str, remedy: str) -> None:
        raise MeasurementError(what, f"{source}: {path}", remedy)

    return Campaign(
        source=source,
        model=model,
        channels=channel_units,
        repeatability=(
            None
            if table.repeatability == REVISITS
            else parse_fraction(table.repeatability, f"{source}: repeatability")
        ),
        tones=tuple(parse_frequency(text, f"{source}: tones") for text in table.tones),
        sensors=check_sensors(table.sensor, channel_units, _platform(model), setups, source),
        forces=check_forces(table.force, channel_units, _platform(model), setups, source),
        records=records,
        edits=_edits(table.edit, records, source),
        report=read_report(table.report, refuse_field),
        signs_of_file=table.signs is not None,
    )


def _platform(model: Model | None) -> Platform:
    return Platform() if model is None else Platform(model.mechanism.directions, model.mechanism.rotations)


def _check_channels(names: list[str], source: str) -> None:
    for i, name in enumerate(names):
        if not name.strip() or not name.isprintable() or name == NO_CHANNEL:
            problem = f"expected the name of a channel, found {shown(name)}"
            raise MeasurementError(problem, f"{source}: channels", "use printable characters, and not none")
        if name in names[:i]:
            raise MeasurementError(f"{shown(name)} is given twice", f"{source}: channels", "give each once")


def _record(
    record_table: RecordTable,
    number: int,
    table: CampaignTable,
    model: Model | None,
    folder: Path,
    band: tuple[float, float],
    where: str,
) -> Record:
    files = record_table.files if isinstance(record_table.files, dict) else {"": record_table.files}
    if not files or not all(files.values()):
        raise MeasurementError(
            "expected files, found none", f"{where}.files", 'for example: files = ["p1.uff"]'
        )
    repeated = [
        name
        for name, count in Counter(name for listed in files.values() for name in listed).items()
        if count > 1
    ]
    if repeated:
        problem = f"the file {shown(repeated[0])} is given twice"
        raise MeasurementError(
            problem, f"{where}.files", "a repeat is another measurement: give each file once"
        )
    if not record_table.pose.strip():
        raise MeasurementError("expected a label, found none", f"{where}.pose", 'for example: pose = "P1"')
    if not is_label(record_table.pose):
        raise MeasurementError(
            f"expected a label, found {shown(record_table.pose)}", f"{where}.pose", PRINTABLE_REMEDY
        )
    if record_table.pose.lstrip().startswith("#"):
        problem = f"expected a label that does not begin with #, found {shown(record_table.pose)}"
        raise MeasurementError(problem, f"{where}.pose", "its rows would be comments of the measurement file")
    for name, count in (("averages", record_table.averages), ("hits", record_table.hits)):
        if count is not None and count < 1:
            problem = f"expected at least 1, found {count}"
            raise MeasurementError(problem, f"{where}.{name}", "count what is in each file")
    for name, flag in (("invert", record_table.invert), ("conjugate", record_table.conjugate)):
        if flag and record_table.kind != FRF_KIND:
            problem = f"expected the kind {FRF_KIND} with {name}, found {shown(record_table.kind)}"
            raise MeasurementError(
                problem, f"{where}.{name}", "leave it out: it is for frequency responses only"
            )
    point, point_sigma = _point(record_table, model, where)
    return Record(
        number=number,
        pose=record_table.pose.strip(),  # as the measurement file is read
        point=point,
        point_sigma=point_sigma,
        settings=_settings(record_table, model, where),
        kind=record_table.kind,
        setups={name: tuple(folder / file for file in listed) for name, listed in files.items()},
        band=band if record_table.band is None else parse_band(record_table.band, f"{where}.band"),
        drives=record_table.drives or table.drives or (FREE if model is None else model.robot.drives),
        averages=record_table.averages,
        exponential=None
        if record_table.exponential is None
        else _parse_time(record_table.exponential, f"{where}.exponential"),
        hits=record_table.hits,
        rate=None
        if record_table.rate is None
        else parse_frequency(record_table.rate, f"{where}.rate", "3200 Hz"),
        columns=record_table.columns if isinstance(record_table.columns, dict) else {},
        header=tuple(record_table.columns) if isinstance(record_table.columns, list) else (),
        names=check_names_in_files(record_table, table.sensor, where),
        invert=record_table.invert,
        conjugate=record_table.conjugate,
        clocks={} if record_table.clock is None else read_clocks(record_table, files, where),
    )


def _parse_time(text: str, where: str) -> float:
    value = parse_quantity(text, "s", where)
    if value <= 0.0:
        raise MeasurementError(
            f"expected a time above 0, found {shown(text)}", where, 'for example: "0.35 s"'
        )
    return value


def _point(
    record_table: RecordTable, model: Model | None, where: str
) -> tuple[dict[str, float], dict[str, float]]:
    """Return the pose and its standard deviations; empty for a structure that is not a robot."""
    if model is None:
        if record_table.at:
            problem = "a structure without a robot has no positions"
            raise MeasurementError(problem, f"{where}.at", "leave it out, or give the robot file")
        return {}, {}
    units = {component.name: component.unit for component in model.mechanism.pose}
    for name in record_table.at:
        if name not in units:
            raise MeasurementError(
                f"unknown component {shown(name)}", f"{where}.at", nearest_name(name, units)
            )
    missing = [name for name in units if name not in record_table.at]
    if missing:
        problem = f"expected {', '.join(units)}, found no {', '.join(missing)}"
        raise MeasurementError(problem, f"{where}.at", 'for example: at = { x = "600 mm", ... }')
    values_and_sigmas = {
        name: parse_uncertain(record_table.at[name], unit, f"{where}.at.{name}")
        for name, unit in units.items()
    }
    point = {name: value for name, (value, _) in values_and_sigmas.items()}
    try:
        model.checked(list(point.values()), "raise")
    except PkmodesError as error:
        raise MeasurementError(error.what, f"{where}.at", error.remedy) from None
    return point, {name: sigma for name, (_, sigma) in values_and_sigmas.items()}


def _settings(record_table: RecordTable, model: Model | None, where: str) -> dict[str, float]:
    if model is None:
        if record_table.settings:
            problem = "a structure without a robot has no parameters"
            raise MeasurementError(problem, f"{where}.set", "leave it out, or give the robot file")
        return {}
    settable_units = settable_paths(model.mechanism, model.robot)
    values = {}
    for path, value in record_table.settings.items():
        if path not in settable_units:
            problem = f"unknown parameter path {shown(path)}"
            raise MeasurementError(
                problem,
                f"{where}.set",
                nearest_name(path, settable_units, "see docs/reference/parameter-paths.md"),
            )
        values[path] = parse_quantity(value, settable_units[path], f"{where}.set.{path}")
    try:
        model.robot.with_values(values)
    except PkmodesError as error:
        raise MeasurementError(error.what, f"{where}.set", error.remedy) from None
    return values


def _check_labels(records: tuple[Record, ...], source: str) -> None:
    first: dict[str, int] = {}
    for record in records:
        number = first.setdefault(record.pose, record.number)
        if number != record.number:
            problem = f"the label {shown(record.pose)} is also that of record {number}"
            remedy = "give each record its own label; repeats are several files of one record"
            raise MeasurementError(problem, f"{source}: record.{record.number}.pose", remedy)


def _edits(
    tables: Sequence[EditTable], records: tuple[Record, ...], source: str
) -> dict[str, RequestedModes]:
    labels = [record.pose for record in records]
    edits: dict[str, RequestedModes] = {}
    for i, edit in enumerate(tables, start=1):
        where, label = f"{source}: edit.{i}", edit.pose.strip()
        if label not in labels:
            problem = f"no record has the label {shown(edit.pose)}"
            raise MeasurementError(problem, f"{where}.pose", nearest_name(edit.pose, labels))
        strike = tuple(parse_frequency(text, f"{where}.strike") for text in edit.strike)
        add = tuple(parse_frequency(text, f"{where}.add") for text in edit.add)
        earlier = edits.get(label, NO_EDITS)
        edits[label] = RequestedModes(earlier.strike + strike, earlier.add + add)
    return edits
