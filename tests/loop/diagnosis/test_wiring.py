"""Sensors wired or mounted otherwise than the file says, on the virtual test rig.

The columns of a correct file are put in a wrong order, and whoever follows the advice of the diagnosis must get the
correct file back (`pkmodes_rig.followed`); shapes have any sign, so all columns may be of the opposite sign.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from pkmodes import updating
from pkmodes.loop.diagnosis.diagnose import diagnose
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Fit, Hypothesis
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.one_state import split_setups
from pkmodes.loop.diagnosis.readings.misfits import WiringMisfit
from pkmodes.loop.diagnosis.readings.wiring import certain_wiring, find_better_wirings, other_wiring
from pkmodes.loop.diagnosis.readings.wirings import Wiring
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.updating.measured_robot import MeasuredRobot
from pkmodes_rig import ORDERS, POSES, SENSORS, followed, measure_modes, read
from studies.cases import tried
from studies.hard_suites import UNDECIDED
from studies.mechanism_cases import MechanismCase, measured
from studies.specimens import Specimen, measurements, measurements_of, robot_of
from studies.suites import SUITES

PLATFORM = ("p_x", "p_y", "p_z")
#: Near the axis of a tower printer two pairs of modes have nearly equal frequencies; elsewhere they are separate.
PLANS = ("middle", "scattered")


@cache
def tower(plan: str, channels: tuple[str, ...] = SENSORS, poses: int = 8) -> Measurements:
    return simulated(Specimen("tower"), POSES["tower"][plan][:poses], 7003, channels)


def simulated(
    specimen: Specimen,
    points: Sequence[np.ndarray],
    seed: int,
    channels: tuple[str, ...] = SENSORS,
    noise: float = 0.02,
    stated: str = "stated",
) -> Measurements:
    """Six modes of a specimen with errors of the shapes."""
    text = measure_modes(
        specimen.modes(points),
        points,
        rng=np.random.default_rng(seed),
        shapes=channels,
        shape_noise=noise,
        sigma_shape=stated,
    )
    return measurements(text)


#: A machine with a cause that the declared model lacks.
COMPLIANT = Specimen("tower", {"gearbox_compliance.compliance": 0.2})


def miswired(data: Measurements, order: Sequence[str], signs: Sequence[int]) -> Measurements:
    """Return measurements whose columns of the platform's sensor have other components."""
    place = [data.channels.index(name) for name in PLATFORM[: len(order)]]
    shapes = data.shapes.copy()
    shapes[:, place] = data.shapes[:, [data.channels.index(name) for name in order]] * signs
    return replace(data, shapes=shapes)


def declared_fit(data: Measurements, robot: str = "tower", fitted: Sequence[int] = ()) -> tuple[Fitter, Fit]:
    """The declared model fitted to all setups, or to these."""
    structure = MeasuredRobot.of(robot_of(robot), data).structure(candidates=())
    setups = fitted or range(len(data.labels))
    fitter = Fitter(structure.subset(setups), data.at(setups))
    fit = fitter.fit(Hypothesis())
    assert fit is not None
    return fitter, fit


def advice(data: Measurements, robot: str = "tower") -> str:
    """What a diagnosis says of the wiring before it searches for causes."""
    return certain_wiring(FitStore(declared_fit(data, robot)[0]))


@pytest.mark.parametrize("plan", PLANS)
def test_all_signed_orders_of_a_triaxial_sensor_are_named(subtests: pytest.Subtests, plan: str) -> None:
    """Five poses tell them."""
    data = tower(plan, poses=5)
    for name, order in ORDERS.items():
        with subtests.test(name):
            said = advice(miswired(data, *order))
            assert followed(name.split(", "), said) == list(PLATFORM), said
    assert advice(data) == ""


@pytest.mark.parametrize(
    ("order", "what"),
    [
        ("p_x, -p_y, p_z", "p_y is reversed: the shapes differ from the model by "),
        ("p_y, p_x, p_z", "p_x and p_y are exchanged: "),
        (
            "p_y, -p_x, p_z",
            "the sensor at the platform is turned by 90 degrees about z (p_x measures p_y, p_y measures -p_x): ",
        ),
        ("-p_y, p_x, p_z", "the sensor at the platform is turned by -90 degrees about z ("),
        ("p_x, p_z, -p_y", "the sensor at the platform is turned by 90 degrees about x ("),
        ("-p_z, p_y, p_x", "the sensor at the platform is turned by 90 degrees about y ("),
        ("-p_x, p_y, -p_z", "the sensor at the platform is turned by 180 degrees about y ("),
        ("p_y, p_z, p_x", "p_x, p_y and p_z are exchanged cyclically (p_x measures p_y, p_y measures p_z, "),
        ("p_y, -p_z, -p_x", "the sensor at the platform is turned (p_x measures p_y, "),
        ("p_y, p_x, -p_z", "the sensor at the platform is turned (p_x measures p_y, "),
        ("-p_y, -p_x, p_z", "p_x and p_y are exchanged and p_x and p_y reversed ("),
        ("-p_x, -p_y, -p_z", "p_x, p_y and p_z are all reversed: "),
    ],
)
def test_a_wiring_is_named_as_a_test_engineer_would(order: str, what: str) -> None:
    said = advice(miswired(tower("middle"), *ORDERS[order]))
    assert said.startswith(what)
    assert " of their largest component as in the file, by " in said


@pytest.mark.parametrize("order", ["p_x, -p_y, p_z", "p_y, p_x, p_z"])
def test_a_diagnosis_names_the_wiring_and_claims_no_cause(order: str) -> None:
    found = updating.diagnose(read("tower"), miswired(tower("middle"), *ORDERS[order]))
    assert found.verdict == "unexplained"
    assert followed(order.split(", "), found.reason) == list(PLATFORM)
    assert found.notes[0] == found.reason
    assert found.effects == ()
    if order == "p_x, -p_y, p_z":
        assert "change the sign of the column shape:p_y" in found.reason
        assert "or check the sensor's direction and the sign of y in the poses" in found.reason


def test_the_sign_of_a_whole_sensor_counts_only_beside_other_channels() -> None:
    order = ORDERS["-p_x, -p_y, -p_z"]
    alone = tower("scattered", PLATFORM)
    assert advice(alone) == advice(miswired(alone, *order)) == ""
    one = tower("scattered", ("x_1", *PLATFORM))
    said = advice(miswired(one, *order))
    assert said.startswith("x_1 is reversed")  # or all others are: for shapes, the same
    assert followed(["-p_x", "-p_y", "-p_z"], said) == list(PLATFORM)


def test_mistakes_that_differ_by_the_sign_of_all_columns_are_named_together() -> None:
    said = advice(miswired(tower("scattered", PLATFORM), *ORDERS["p_x, -p_y, p_z"]))
    assert said.startswith(
        "p_y is reversed or the sensor at the platform is turned by 180 degrees about y "
        "(p_x measures -p_x, p_z measures -p_z) (for shapes, which have any sign, the same): "
    )


def test_an_axis_that_is_not_in_the_file_may_be_measured() -> None:
    data = tower("scattered")
    two = replace(
        data, channels=("x_1", "x_2", "p_x", "p_y"), shapes=data.shapes[:, [0, 1, 3, 5]]
    )  # p_z under p_y
    assert advice(two).startswith("p_y measures p_z: ")
    assert "rename the column shape:p_y to shape:p_z" in advice(two)


def test_wirings_that_these_data_do_not_tell_apart_are_all_listed() -> None:
    """In the plane of symmetry y = 0, modes move either p_y alone or p_x and p_z: the sign of p_y is unknown."""
    points = [np.array([x, 0.0, z]) for x, z in itertools.product((-0.05, 0.03, 0.06), (0.12, 0.25))]
    data = simulated(Specimen("tower"), points, 7004, ("x_1", *PLATFORM))
    said = advice(miswired(data, *ORDERS["p_z, p_y, p_x"]))
    assert said.startswith("sensors are exchanged, reversed or turned, and these data do not tell which: ")
    assert "p_x and p_z are exchanged;" in said
    assert "p_y reversed" in said or "p_y measures -p_y" in said


@pytest.mark.parametrize("columns", [("x_1", "x_3"), ("x_2", "p_y")])
def test_joint_channels_may_be_exchanged(columns: tuple[str, str]) -> None:
    data = tower("middle")
    i, k = (data.channels.index(name) for name in columns)
    order = np.arange(len(data.channels))
    order[[i, k]] = k, i
    said = advice(replace(data, shapes=data.shapes[:, order]))
    assert said.startswith(f"{columns[0]} and {columns[1]} are exchanged: ")


def test_a_reversed_joint_channel_is_named() -> None:
    data = tower("middle")
    said = advice(replace(data, shapes=data.shapes * [1, -1, 1, 1, 1, 1]))
    assert said.startswith("x_2 is reversed: ")
    assert said.endswith("change the sign of the column shape:x_2, or check the sensor's direction")


@pytest.mark.parametrize("plan", PLANS)
@pytest.mark.parametrize("channels", [SENSORS, PLATFORM, ("x_2", "p_y", "p_z")])
def test_right_wirings_are_not_called_wrong(plan: str, channels: tuple[str, ...]) -> None:
    """With 5 % errors of the shapes, and a cause that the declared model lacks."""
    for truth, stated in itertools.product((Specimen("tower"), COMPLIANT), ("stated", "absent")):
        data = simulated(truth, POSES["tower"][plan], 7005, channels, 0.05, stated)
        assert other_wiring(*declared_fit(data)) == ""


def test_a_wiring_is_named_beside_a_cause() -> None:
    data = simulated(COMPLIANT, POSES["tower"]["scattered"], 7006)
    said = advice(miswired(data, *ORDERS["p_x, -p_y, p_z"]))
    assert "p_y is reversed: " in said
    assert "something else is wrong too: correct this, and diagnose again" in said


def test_a_structure_without_known_sensors_has_exchanges_and_reversals() -> None:
    data = miswired(tower("scattered"), *ORDERS["p_y, p_z, p_x"])

    class Plain:
        """The same model, which does not say which channels are one sensor."""

        def __init__(self, structure: object) -> None:
            self._structure = structure

        def __getattr__(self, name: str) -> object:
            if name == "sensors":
                raise AttributeError(name)
            return getattr(self._structure, name)

        def subset(self, setups: Sequence[int]) -> Plain:
            return Plain(self._structure.subset(setups))  # type: ignore[attr-defined]

    structure = Plain(MeasuredRobot.of(read("tower"), data).structure(candidates=()))
    assert "exchanged cyclically" not in diagnose(structure, data).reason  # type: ignore[arg-type]


@pytest.fixture(scope="module")
def corexy() -> Measurements:
    _, text = measured(MechanismCase("wiring", 0, Specimen("corexy"), seed=7007))
    return measurements_of(text, robot_of("corexy"))


@pytest.mark.parametrize("order", list(itertools.permutations(("p_x", "p_y"))))
@pytest.mark.parametrize("signs", list(itertools.product((1, -1), repeat=2)))
def test_the_eight_signed_orders_of_a_planar_sensor_are_named(
    corexy: Measurements, order: tuple[str, str], signs: tuple[int, int]
) -> None:
    said = advice(miswired(corexy, order, signs), "corexy")
    has = [f"{'-' if sign < 0 else ''}{name}" for name, sign in zip(order, signs, strict=True)]
    assert followed([*has, "p_z"], said)[:2] == ["p_x", "p_y"], said
    if (order, signs) == (("p_y", "p_x"), (1, -1)):
        assert said.startswith(
            "the sensor at the tool head is turned by 90 degrees about z (p_x measures p_y, "
        )


@pytest.mark.parametrize(("number", "order"), [(70, "p_y, p_z, p_x"), (75, "-p_y, p_z, -p_x")])
def test_the_right_order_is_among_those_that_remain(number: int, order: str) -> None:
    """Near the axis of a tower printer, with the platform's sensor alone; in one case with unequal belts."""
    case = next(c for c in SUITES["units and wiring"]() if c.number == number)
    assert (case.kind, case.mistake) == (UNDECIDED, order)
    data = measurements(tried(replace(case, seed=7002)).text)
    found = find_better_wirings(*declared_fit(data, fitted=split_setups(data, None)[0]))
    assert found is not None
    assert len(found.wirings) > 1
    assert Wiring(*ORDERS[order]).up_to_sign in found.wirings


def test_the_misfit_does_not_depend_on_whether_errors_are_stated() -> None:
    count = np.array([10.0, 20.0, 0.0])
    one = WiringMisfit(np.array([30.0, 10.0, 0.0]), count, np.array([10.0, 20.0, 1e-300]), 0.1)
    assert one.deviance() == pytest.approx(10 * np.log(3.0))  # no better than the errors
    assert one.deviance(frequencies=False) == 0.0
    assert one.shape_squares == pytest.approx(20.0)
