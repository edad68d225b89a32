"""A robot with a term: frequencies are those of the rig, and derivatives those of finite differences."""

from __future__ import annotations

import pickle

import numpy as np
import pytest

from helpers.diagnoses.robot_structures import declared, index, structure_at
from pkmodes.loop.diagnosis import Prediction
from pkmodes.loop.updating.robot_with_terms import ExtensibleRobot, RobotWithTerms
from pkmodes_rig.one_place import Fault, modes_of
from studies.specimens import MACHINES, robot_of

#: A fault of each form, at places of each kind; a rail yields across itself on the tower, and obliquely on the other.
FAULTS = {
    "asymmetric": (
        Fault("mass", ("link_2",), values={"mass": 0.2}),
        Fault("mass", ("pulley_1_2",), values={"inertia": 2e-4}),
        Fault("spring", ("platform",), values={"stiffness": 3e4}),
        Fault("spring", ("carriage_3",), values={"stiffness": 3e4}),
        Fault("spring", ("pulley_2_1", "pulley_2_2"), values={"stiffness": 60.0}),
        Fault("spring", ("platform", "link_1"), "y", {"stiffness": 3e4}),
        Fault("mount", ("pulley_3_1",), values={"compliance": 5e-7, "mass": 0.4}),
        Fault("resonator", ("platform",), "z", {"mass": 0.3, "frequency": 40.0}),
        Fault("resonator", ("pulley_1_1",), values={"inertia": 1e-4, "frequency": 70.0}),
        Fault("mount", ("carriage_3",), "y", {"compliance": 5e-7}),
    ),
    "tower": (Fault("mount", ("carriage_2",), "y", {"compliance": 5e-7}),),
    "hexapod": (
        Fault("mass", ("rod_3",), values={"mass": 0.3}),
        Fault("spring", ("platform",), "rx", {"stiffness": 4e4}),
        Fault("mount", ("leg_5",), "y", {"compliance": 3e-8}),
        Fault("resonator", ("leg_2",), "x", {"mass": 0.2, "frequency": 150.0}),
    ),
    "corexy": (
        Fault("mass", ("gantry",), values={"mass": 0.1}),
        Fault("spring", ("platform",), "x", {"stiffness": 2e4}),
        Fault("mount", ("pulley_2",), values={"compliance": 4e-7, "mass": 0.1}),
        Fault("resonator", ("gantry",), values={"mass": 0.05, "frequency": 60.0}),
    ),
}
EACH = [(machine, fault) for machine, faults in FAULTS.items() for fault in faults]
each_fault = pytest.mark.parametrize(
    ("machine", "fault"), EACH, ids=[f"{machine} {fault.term}" for machine, fault in EACH]
)


def extensible(machine: str, points: np.ndarray) -> ExtensibleRobot:
    structure = structure_at(robot_of(machine), points, ["payload"])
    assert isinstance(structure, ExtensibleRobot)
    return structure


def poses(machine: str) -> np.ndarray:
    return MACHINES[machine].points[1:4]


def extended(machine: str) -> RobotWithTerms:
    return extensible(machine, poses(machine)).with_terms()


def places_of(structure: RobotWithTerms, fault: Fault) -> list[int]:
    """The indices of a term's parameters, that of its size first."""
    return [index(structure, f"{fault.term}.{name}") for name in fault.values]


def with_fault(structure: RobotWithTerms, fault: Fault) -> np.ndarray:
    values = declared(structure)
    values[places_of(structure, fault)] = list(fault.values.values())
    return values


@each_fault
def test_frequencies_are_those_of_the_rig(machine: str, fault: Fault) -> None:
    structure, robot = extended(machine), robot_of(machine)
    found = structure.predict(with_fault(structure, fault), [])
    plain = structure.predict(declared(structure), [])
    for p, eigenvalues in zip(poses(machine), found.eigenvalues, strict=True):
        true = modes_of(robot.mechanism_name, robot.parameters, p, [fault])
        vibrations = (2.0 * np.pi * true.frequencies[found.rigid :]) ** 2
        # a mode that strains a spring alone is rigid on the rig, with an eigenvalue of rounding errors
        np.testing.assert_allclose(eigenvalues[found.rigid :], vibrations, rtol=1e-9, atol=1.0)
    assert plain.eigenvalues.shape != found.eigenvalues.shape or not np.allclose(
        found.eigenvalues, plain.eigenvalues, rtol=1e-5
    )


# Derivatives ----------------------------------------------------------------------------------------------------

#: Relative step of a central difference: of its errors, the step causes 4e-10, and rounding 5e-9 of what changes.
CENTRAL = 2e-5
#: Steps from 0, relative to the size of a fault: with a smaller compliance the digits of its stiffness are lost, and
#: the mass of a resonator must be small beside the distance of its frequency from those of the modes.
FROM_0 = {"mass": 1e-4, "spring": 1e-4, "mount": 1e-3, "resonator": 1e-5}
#: Digits of a second-order difference from 0, relative to the largest derivative.
DIGITS = 5e-5


def aligned(prediction: Prediction, like: Prediction) -> np.ndarray:
    """Shapes with the signs of other ones."""
    return prediction.shapes * np.sign((prediction.shapes * like.shapes).sum(axis=2, keepdims=True))


def assert_same(rates: np.ndarray, difference: np.ndarray, within: float, rounding: float = 0.0) -> None:
    size = np.abs(difference).max()
    assert size > 0.0
    np.testing.assert_allclose(rates, difference, rtol=0.0, atol=within * size + rounding)


@each_fault
def test_derivatives_beside_a_term_are_those_of_central_differences(machine: str, fault: Fault) -> None:
    structure = extended(machine)
    values = with_fault(structure, fault)
    uncertain = [i for i, p in enumerate(structure.parameters) if p.sigma is not None]
    by = [*places_of(structure, fault), *uncertain]
    found = structure.predict(values, by, shape_rates=True)
    assert found.shape_rates is not None
    elastic = slice(found.rigid, None)
    for k, i in enumerate(by):
        step = np.zeros_like(values)
        step[i] = CENTRAL * values[i]
        ahead, behind = (structure.predict(values + sign * step, []) for sign in (1.0, -1.0))
        slope = (ahead.eigenvalues - behind.eigenvalues) / (2.0 * step[i])
        assert_same(found.rates[:, elastic, k], slope[:, elastic], 1e-6)
        turning = (aligned(ahead, found) - aligned(behind, found)) / (2.0 * step[i])
        # where all stiffnesses change alike, shapes change by nothing but rounding, more where modes are close
        rounding = 3e-9 * np.abs(found.shapes).max() / values[i]
        assert_same(found.shape_rates[:, elastic, :, k], turning[:, elastic], 1e-5, rounding)


@pytest.mark.parametrize("present", [True, False])
def test_derivatives_are_in_the_order_asked_for(present: bool) -> None:
    machine, fault = EACH[0]
    structure = extended(machine)
    values = with_fault(structure, fault) if present else declared(structure)
    by = [0, 1, *places_of(structure, fault), 2]
    ahead, back = (structure.predict(values, order, shape_rates=True) for order in (by, by[::-1]))
    assert ahead.shape_rates is not None
    assert back.shape_rates is not None
    np.testing.assert_array_equal(ahead.rates, back.rates[..., ::-1])
    np.testing.assert_array_equal(ahead.shape_rates, back.shape_rates[..., ::-1])


@each_fault
def test_derivatives_of_an_absent_term_are_those_of_a_small_one(machine: str, fault: Fault) -> None:
    structure = extended(machine)
    size, values = places_of(structure, fault)[0], with_fault(structure, fault)
    step = FROM_0[fault.form] * values[size]
    values[size] = 0.0
    plain = structure.predict(values, [size], shape_rates=True)
    modes, elastic = plain.eigenvalues.shape[1], slice(plain.rigid, None)
    assert plain.shape_rates is not None
    eigenvalues, shapes = [], []
    for multiple in (1.0, 2.0):
        values[size] = multiple * step
        small = structure.predict(values, [])
        if fault.form == "resonator":  # its own mode is at its frequency
            added = np.abs(small.eigenvalues - (2.0 * np.pi * fault.values["frequency"]) ** 2).argmin(axis=1)
            kept = np.array([np.delete(np.arange(modes + 1), k) for k in added])
        else:  # that of a stiff mount is the highest
            kept = np.tile(np.arange(modes), (len(small.shapes), 1))
        small = Prediction(
            np.take_along_axis(small.eigenvalues, kept, axis=1),
            small.rates,
            np.take_along_axis(small.shapes, kept[..., None], axis=1),
        )
        eigenvalues.append(small.eigenvalues)
        shapes.append(aligned(small, plain))
    slope = (4.0 * eigenvalues[0] - eigenvalues[1] - 3.0 * plain.eigenvalues) / (2.0 * step)
    turning = (4.0 * shapes[0] - shapes[1] - 3.0 * plain.shapes) / (2.0 * step)
    assert_same(plain.rates[:, elastic, 0], slope[:, elastic], DIGITS)
    assert_same(plain.shape_rates[:, elastic, :, 0], turning[:, elastic], DIGITS)


@pytest.mark.parametrize(
    ("machine", "fault"), [EACH[0], EACH[6], ("tower", FAULTS["tower"][0]), ("hexapod", FAULTS["hexapod"][2])]
)
def test_derivatives_with_the_position_are_those_of_other_poses(machine: str, fault: Fault) -> None:
    structure, points = extended(machine), poses(machine)
    values, step = with_fault(structure, fault), 1e-6  # m
    found = structure.position_rates(values)

    def at(moved: np.ndarray) -> np.ndarray:
        there = RobotWithTerms(
            extensible(machine, moved), structure.terms, structure.parameters, structure.candidates
        )
        return there.predict(values, []).eigenvalues

    for k in range(3):
        shift = step * np.eye(points.shape[1])[k]
        slope = (at(points + shift) - at(points - shift)) / (2.0 * step)
        assert_same(found.rates[:, found.rigid :, k], slope[:, found.rigid :], 1e-6)


# Many at once ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("machine", FAULTS)
@pytest.mark.parametrize("rates", [False, True])
def test_many_at_once_are_those_one_by_one(machine: str, rates: bool) -> None:
    structure = extended(machine)
    values = np.array([declared(structure), *(with_fault(structure, fault) for fault in FAULTS[machine])])
    by = [places_of(structure, FAULTS[machine][0])[:1] if rates else [] for _ in values]
    batches = structure.predict_many(values, by)
    assert sorted(k for batch in batches for k in batch.sets) == list(range(len(values)))
    setups = len(poses(machine))
    for batch in batches:
        for place, k in enumerate(batch.sets):
            part, alone = slice(place * setups, (place + 1) * setups), structure.predict(values[k], by[k])
            found = batch.prediction
            np.testing.assert_allclose(
                found.eigenvalues[part, alone.rigid :], alone.eigenvalues[:, alone.rigid :], rtol=1e-11
            )
            np.testing.assert_allclose(found.rates[part], alone.rates, rtol=1e-9, atol=1e-3)
            signs = np.sign((found.shapes[part] * alone.shapes).sum(axis=2, keepdims=True))
            elastic = slice(alone.rigid, None)
            np.testing.assert_allclose(
                (signs * found.shapes[part])[:, elastic], alone.shapes[:, elastic], rtol=0.0, atol=1e-7
            )


def test_some_of_the_setups_and_a_copy_in_another_process_are_the_same() -> None:
    machine, fault = EACH[7]
    structure = extended(machine)
    values = with_fault(structure, fault)
    whole = structure.predict(values, places_of(structure, fault))
    some = structure.subset([2, 0]).predict(values, places_of(structure, fault))
    np.testing.assert_array_equal(some.eigenvalues, whole.eigenvalues[[2, 0]])
    np.testing.assert_array_equal(some.rates, whole.rates[[2, 0]])
    copy = pickle.loads(pickle.dumps(structure)).predict(values, places_of(structure, fault))
    np.testing.assert_array_equal(copy.eigenvalues, whole.eigenvalues)


def test_the_masses_of_a_bearing_from_which_fits_start_are_those_of_bodies() -> None:
    """A pulley rotates, but its bearing is displaced: a start has no moment of inertia for a mass."""
    structure = extended("asymmetric")
    (term,) = (c for c in structure.candidates if c.name == "mount:pulley_1_1")
    masses = {mass for _, mass in term.starts} - {0.0}
    carriage = robot_of("asymmetric").parameters.carriage_mass[0]
    assert len(masses) == 3
    assert min(masses) < carriage < 2.0 * max(masses) < 5.0 * carriage


def test_supports_are_fitted_from_modes_in_the_band_and_far_above_it() -> None:
    structure = extended("rotary_delta")
    (term,) = (c for c in structure.candidates if c.name == "mount:arm_1.x")
    plain, modes = declared(structure), []
    for (compliance,) in term.starts:
        values = plain.copy()
        values[index(structure, "mount:arm_1.x.compliance")] = compliance
        modes.append(np.sqrt(structure.predict(values, []).eigenvalues.max()))
    highest = np.sqrt(structure.predict(plain, []).eigenvalues.max())
    assert len(modes) == 25
    assert max(modes) > 5.0 * highest
    assert sum(mode < 1.3 * highest for mode in modes) >= 15


@pytest.mark.parametrize("fault", FAULTS["corexy"][1:3], ids=lambda fault: fault.term)
@pytest.mark.parametrize("present", [True, False])
def test_masses_that_are_none_of_a_machine_predict_no_modes(fault: Fault, present: bool) -> None:
    """A fit may try a mass of zero; the motors are free, so that a spring to ground holds rigid motions."""
    structure = extended("corexy")
    values = with_fault(structure, fault) if present else declared(structure)
    values[index(structure, "toolhead.mass")] = 0.0
    found = structure.predict(values, places_of(structure, fault))
    assert np.isnan(found.eigenvalues).all()
    assert found.rates.shape == (*found.eigenvalues.shape, len(fault.values))
