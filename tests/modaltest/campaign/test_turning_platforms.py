"""Sensors and blows on a platform that turns, against the kinematics of a rigid body, written here."""

from __future__ import annotations

import csv
import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.linalg import expm

from modaltest.campaign.structures import identify, write_frf
from pkmodes.core.base.errors import MeasurementError
from pkmodes.modaltest.campaign.description import ForceTable, SensorTable
from pkmodes.modaltest.campaign.motion import parse_motion
from pkmodes.modaltest.campaign.mounts import Platform
from pkmodes.modaltest.campaign.sensors import Transducer, check_forces, check_motion, check_sensors
from pkmodes.modaltest.campaign.shapes import UNDETERMINED, blank_messages, combine_sensors

Array = NDArray[np.float64]
ROBOT = Path(__file__).parents[3] / "robots/hexapod.toml"
PLATFORM = Platform(("x", "y", "z"), ("x", "y", "z"))
PLANAR = Platform(("x", "y"), ("z",))
TILT = np.array([0.3, -0.5, 0.2])
#: Six accelerometers, skew enough to tell all six components: direction and place [mm].
SIX: list[tuple[list[float], list[float]]] = [
    ([0, 0, 1], [60, 0, -5]),
    ([0, 0, 1], [-30, 52, -5]),
    ([0.6, 0, 0.8], [-30, -52, -5]),
    ([0, 1, 0], [60, 0, -5]),
    ([0.8, -0.6, 0], [0, 40, 10]),
    ([-0.5, -0.8, 0.1], [-30, -52, 15]),
]


def known(platform: Platform) -> dict[str, str]:
    return {name: "m" if name.startswith("p_") else "rad" for name in platform.components} | {"s_1": "m"}


def read(kind: str, platform: Platform, *tables: dict[str, Any]) -> dict[str, Transducer]:
    numbered = [{"name": str(i)} | table for i, table in enumerate(tables)]
    if kind == "force":
        found: Sequence[Transducer] = check_forces(
            msgspec.convert(numbered, list[ForceTable]), known(platform), platform, {""}, "c.toml"
        )
    else:
        given = [{"unit": "m/s^2"} | table for table in numbered]
        found = check_sensors(
            msgspec.convert(given, list[SensorTable]), known(platform), platform, {""}, "c.toml"
        )
    return {one.name: one for one in found}


def at(places: dict[str, Transducer], turn: Array, platform: Platform = PLATFORM) -> dict[str, Transducer]:
    R = platform.rotation(dict(zip(("rx", "ry", "rz"), turn, strict=True)))
    np.testing.assert_allclose(R, expm(cross(turn)), rtol=0, atol=1e-14)
    return {name: one.rotated(R) for name, one in places.items()}


def cross(vector: Array) -> Array:
    x, y, z = vector
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def velocity(b: Sequence[float], turn: Array, v: Array, omega: Array) -> Array:
    """Return that of a point of the body [mm] by central differences of where it is."""
    there = expm(cross(turn)) @ np.array(b) / 1e3

    def where(t: float) -> Array:
        return v * t + expm(cross(omega) * t) @ there

    return (where(1e-4) - where(-1e-4)) / 2e-4


def mounted(direction: Sequence[float], place: Sequence[float]) -> dict[str, Any]:
    return {"direction": list(direction), "at": [f"{one} mm" for one in place]}


V, OMEGA = np.array([0.4, -1.0, 0.3]), np.array([7.0, 2.0, -11.0])


def shown(directions: Sequence[Array], places: Sequence[Sequence[float]], turn: Array) -> dict[str, complex]:
    each = zip(directions, places, strict=True)
    return {str(i): complex(d @ velocity(b, turn, V, OMEGA)) for i, (d, b) in enumerate(each)}


@pytest.mark.parametrize("turn", [np.zeros(3), TILT])
def test_six_accelerometers_that_turn_with_the_platform_give_its_motion_along_base_axes(turn: Array) -> None:
    R = expm(cross(turn))
    along = [R @ np.array(d) / np.linalg.norm(d) for d, _ in SIX]
    places = at(read("sensor", PLATFORM, *(mounted(*one) for one in SIX)), turn)
    found = combine_sensors(shown(along, [b for _, b in SIX], turn), places)
    assert list(found.values) == ["p_x", "p_y", "p_z", "r_x", "r_y", "r_z"]
    assert not found.blank
    # Central differences leave |omega|^3 h^2 / 6, 4e-6 of what the lever arm moves.
    np.testing.assert_allclose(list(found.values.values()), [*V, *OMEGA], rtol=0, atol=1e-4)


def test_a_channel_of_the_platform_is_along_a_base_axis_wherever_the_platform_turns() -> None:
    places = at(
        read("sensor", PLATFORM, {"channel": "-p_y", "at": ["0 mm", "40 mm", "10 mm"]}, {"channel": "p_z"}),
        TILT,
    )
    point = velocity([0, 40, 10], TILT, V, OMEGA)
    for name, expected in (("0", -point[1]), ("1", V[2])):
        weights = places[name].weights
        assert sum(weights[c] * m for c, m in zip(PLATFORM.components, [*V, *OMEGA], strict=True)) == (
            pytest.approx(expected, abs=1e-6)
        )


def test_gyroscopes_complete_accelerometers_wherever_they_sit() -> None:
    """Along a direction of the platform, or by a channel about a base axis; three accelerometers stand together."""
    b, R = [10, 40, -5], expm(cross(TILT))
    axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
    gyro = {"unit": "rad/s"}
    tables = [
        *(mounted(d, b) for d in axes),
        {"channel": "r_x", **gyro},
        {"channel": "-r_y", "at": ["9 mm", "0 mm", "0 mm"], **gyro},
        mounted([0.6, 0, 0.8], [60, 0, 0]) | {"unit": "deg/s"},
    ]
    places = at(read("sensor", PLATFORM, *tables), TILT)
    shape = shown([R @ np.array(d, dtype=float) for d in axes], [b] * 3, TILT)
    turned = [OMEGA[0], -OMEGA[1], R @ np.array([0.6, 0, 0.8]) @ OMEGA]
    found = combine_sensors(shape | {str(3 + i): complex(one) for i, one in enumerate(turned)}, places)
    np.testing.assert_allclose(list(found.values.values()), [*V, *OMEGA], rtol=0, atol=1e-4)


def test_what_five_accelerometers_leave_open_is_blank_and_said() -> None:
    """None of the five shows a rotation about z, of the platform; where it is turned, no base axis is without it."""
    five = [
        *((d, b) for d, b in SIX[:2]),
        ([0, 0, 1], [-30, -52, -5]),
        ([1, 0, 0], [0, 0, 9]),
        ([0, 1, 0], [0, 0, 9]),
    ]
    places = read("sensor", PLATFORM, *(mounted(*one) for one in five))
    level = combine_sensors(
        shown([np.array(d, dtype=float) for d, _ in five], [b for _, b in five], np.zeros(3)), places
    )
    np.testing.assert_allclose(list(level.values.values()), [*V, *OMEGA[:2]], rtol=0, atol=1e-4)
    assert level.blank == ("r_z",)
    tilted = combine_sensors(dict.fromkeys(places, 1.0 + 0j), at(places, TILT))
    assert set(tilted.values) == {"p_x", "p_y", "p_z"}
    alone = combine_sensors(dict.fromkeys("012", 1.0 + 0j), places)
    assert alone.blank == ("p_x", "p_y", "r_z")
    said = blank_messages("P1", UNDETERMINED, [(50.0, level.blank), (60.0, ()), (70.123, level.blank)])
    assert said == [
        "P1: the measurements on the platform do not determine r_z in the modes at 50, 70.12 Hz: left blank; add a "
        "sensor at another place or in another direction"
    ]
    assert blank_messages("P1", UNDETERMINED, [(50.0, ())]) == []


def test_the_error_of_the_least_certain_component_is_that_of_the_row() -> None:
    """Noise of the sensors is propagated as it scatters; what is no better known than to the largest is blank."""
    rng = np.random.default_rng(3)
    places = read("sensor", PLATFORM, *(mounted(*one) for one in SIX))
    whole = shown([np.array(d) / np.linalg.norm(d) for d, _ in SIX], [b for _, b in SIX], np.zeros(3))
    noise = 0.01 * max(abs(value) for value in whole.values())
    found = [
        list(
            combine_sensors(
                {name: value + noise * rng.normal() for name, value in whole.items()}, places
            ).values.values()
        )
        for _ in range(2000)
    ]
    scatter = np.std(np.real(found), axis=0).max() / np.abs(OMEGA).max()
    growth = combine_sensors(whole, places, 0.01).growth
    assert 0.01 * growth == pytest.approx(scatter, rel=0.05)  # the scatter of 2000 is known to 2 %
    rough = combine_sensors(whole, places, 1.01 / growth)
    assert not rough.blank
    assert "r_z" in rough.uncertain
    assert set(rough.values) >= {"p_x", "p_y"}


def test_blows_at_other_places_give_the_motion_that_they_excite() -> None:
    """A mode answers a blow by the work of its wrench, force and moment about the origin, on its motion."""
    R = expm(cross(TILT))
    places = at(read("force", PLATFORM, *(mounted(*one) for one in SIX)), TILT)
    shape = {}
    for i, (d, b) in enumerate(SIX):
        force = R @ np.array(d) / np.linalg.norm(d)
        moment = np.cross(R @ np.array(b) / 1e3, force)
        shape[str(i)] = complex(force @ V + moment @ OMEGA)
    found = combine_sensors(shape, places)
    np.testing.assert_allclose(list(found.values.values()), [*V, *OMEGA], rtol=0, atol=1e-12)


def test_a_plate_that_turns_in_its_plane_needs_three_sensors() -> None:
    tables = [mounted([1, 0], [0, 30, 0]), mounted([1, 0], [0, -30, 0]), mounted([0, 1], [50, 0, 4])]
    R = expm(cross(np.array([0, 0, 0.7])))
    places = {
        name: one.rotated(PLANAR.rotation({"x": 1.0, "rz": 0.7}))
        for name, one in read("sensor", PLANAR, *tables).items()
    }
    v, omega = np.array([0.4, -1.0, 0.0]), np.array([0.0, 0.0, 5.0])
    shape = {
        str(i): complex(R @ np.array([*t["direction"], 0.0]) @ velocity(b, np.array([0, 0, 0.7]), v, omega))
        for i, (t, b) in enumerate(zip(tables, ([0, 30, 0], [0, -30, 0], [50, 0, 4]), strict=True))
    }
    found = combine_sensors(shape, places).values
    assert list(found) == ["p_x", "p_y", "r_z"]
    np.testing.assert_allclose(list(found.values()), [0.4, -1.0, 5.0], rtol=0, atol=1e-5)


@pytest.mark.parametrize("kind", ["sensor", "force"])
def test_a_campaign_of_a_hexapod_has_the_shapes_of_its_platform(tmp_path: Path, kind: str) -> None:
    """Six accelerometers and one reference, or blows at these six places and one accelerometer that stays."""
    turn, f = np.radians([3.0, -5.0, 6.0]), np.arange(60.0, 260.0, 0.25)
    R, rng = expm(cross(turn)), np.random.default_rng(8)
    modes = {
        90.0: [1, 0.2, -0.4, 3, -2, 1],
        150.0: [0.1, 0.3, 0.2, -9, 5, 12],
        210.0: [-0.3, 1, 0.6, 8, 9, -3],
    }
    H = np.zeros((len(f), 6), dtype=complex)
    for natural, shape in modes.items():
        v, omega = np.array(shape[:3], dtype=float), np.array(shape[3:], dtype=float)
        at_six = [R @ np.array(d) / np.linalg.norm(d) @ velocity(b, turn, v, omega) for d, b in SIX]
        H += np.outer(f**2 / (f**2 - natural**2 - 0.02j * f * natural), at_six)
    names = [f"{i}" if kind == "sensor" else f"acc/{i}" for i in range(6)]
    for number in (0, 1):
        write_frf(tmp_path / f"{number}.csv", f, dict(zip(names, H.T, strict=True)), 0.01, rng)
    tables = "".join(
        f'[[{kind}]]\nname = "{i}"\ndirection = {d}\nat = {json.dumps([f"{one} mm" for one in b])}\n'
        + ('unit = "m/s^2"\n' if kind == "sensor" else "")
        for i, (d, b) in enumerate(SIX)
    )
    head = f'format = 1\nrobot = {json.dumps(str(ROBOT))}\nband = ["70 Hz", "240 Hz"]\n'
    stays = '[[sensor]]\nname = "acc"\nchannel = "none"\nunit = "m/s^2"\n' if kind == "force" else ""
    pose = 'x = "4 mm", y = "-6 mm", z = "232 mm", rx = "3 deg", ry = "-5 deg", rz = "6 deg"'
    record = f'[[record]]\npose = "P1"\nat = {{ {pose} }}\nkind = "frf"\nfiles = ["0.csv", "1.csv"]\n'
    found = identify(tmp_path, head + tables + stays + record)
    with found.file.open(encoding="utf-8") as lines:
        rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    assert [round(float(row["frequency"])) for row in rows] == list(modes)
    for row, true in zip(rows, modes.values(), strict=True):
        shape = np.array([float(row[f"shape:{name}"]) for name in PLATFORM.components])
        largest = np.argmax(np.abs(true))
        errors = shape - np.array(true) / true[largest]
        assert np.abs(errors).max() < 3.0 * float(row["sigma_shape"]) < 0.2
        assert [float(row[name]) for name in ("x", "rz")] == pytest.approx([0.004, np.radians(6.0)])


@pytest.mark.parametrize(
    ("platform", "table", "message"),
    [
        (PLATFORM, {"channel": "r_x"}, "r_x cannot have a linear motion (c.toml: sensor.1.unit)"),
        (PLATFORM, {"channel": "s_1", "at": ["0 m"] * 3}, 'the channel "s_1" is not a motion of a platform'),
        (PLANAR, {"direction": [0, 1], "unit": "rad/s"}, "by r_z only: give that as its channel"),
        (PLATFORM, {"direction": [0, 1]}, "expected a direction along x, y, z, found [0.0, 1.0]"),
    ],
)
def test_sensors_that_no_turning_platform_has_are_refused(
    platform: Platform, table: dict[str, Any], message: str
) -> None:
    with pytest.raises(MeasurementError) as error:
        read("sensor", platform, table)
    assert message in str(error.value)


def test_a_gyroscope_whose_unit_only_the_file_says_is_refused_with_what_to_write() -> None:
    place = read("sensor", PLATFORM, mounted([0, 0, 1], [0, 0, 0]))["0"]
    with pytest.raises(MeasurementError) as error:
        check_motion(parse_motion("rad/s^2", "a.csv"), place, known(PLATFORM), "a.csv: 0")
    assert 'write unit = "rad/s^2" in the campaign' in str(error.value)
