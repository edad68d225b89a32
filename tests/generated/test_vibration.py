"""The C for a robot in use: frequencies, damping ratios and amplitudes are those of `Model.modes`.

Motors are held or, where the robot file says so, on their servo stiffness.
"""

from __future__ import annotations

import re
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np
import pytest

from helpers.commands.adding_a_mechanism import DEFINITION, ROBOT
from helpers.generated.generated_robots import ROBOTS
from helpers.generated.held_robots import CASES, HeldRobot, build, library_of
from helpers.runs.programs import needed
from helpers.runs.shared import Shared
from pkmodes.codegen.generation import generate
from pkmodes.core.mechanism import registry
from pkmodes.core.robot.reading import read_robot
from pkmodes_derive import mechanisms
from pkmodes_derive.assembly.held import held_motors
from pkmodes_derive.emit import product
from pkmodes_derive.functions import HeldMotors

pytestmark = pytest.mark.compiler
#: Options with which clang only parses, without a warning of options that are for the linker.
READ = ["-fsyntax-only", "-Wno-unused-command-line-argument"]
#: Highest over lowest frequency up to which single precision leaves a frequency four digits.
MODERATE = 12.0
#: Condition number up to which the rounding of the kinematics does not dominate.
REGULAR = 30.0


@pytest.fixture(scope="module", params=CASES)
def robot(request: pytest.FixtureRequest, shared: Shared) -> HeldRobot:
    case: str = request.param
    return HeldRobot(shared.folder(f"held_{case}", lambda folder: HeldRobot.write(folder, case)), case)


def test_vibrations_are_those_of_the_runtime(robot: HeldRobot) -> None:
    poses = robot.valid(60)
    assert len(poses) == 60
    expected = robot.model.modes(poses, drives=robot.drives, backend="numpy")
    assert expected.rigid_modes == 0
    assert robot.count == len(expected.frequencies[0])
    amplitudes = np.linalg.norm(expected.vibration_amplitudes, axis=-1)
    for i, p in enumerate(poses):
        found = robot.vibration(p)
        assert found.status == 0
        # Rounding of the largest eigenvalue, as in NumPy.
        spread = (expected.frequencies[i, -1] / expected.frequencies[i, 0]) ** 2
        bound = max(1e-10, 1e-14 * spread)
        np.testing.assert_allclose(found.frequencies, expected.frequencies[i], rtol=bound)
        np.testing.assert_allclose(found.damping_ratios, expected.damping_ratios[i], rtol=bound, atol=1e-16)
        np.testing.assert_allclose(
            found.amplitudes, amplitudes[i], rtol=bound, atol=bound * amplitudes[i].max()
        )


def test_frequencies_in_single_precision_have_four_digits(robot: HeldRobot) -> None:
    """Where the highest frequency is not many times the lowest: the error is rounding of the largest eigenvalue."""
    poses = robot.valid(300).astype(np.float32).astype(float)
    doing = robot.drives
    expected = robot.model.modes(poses, drives=doing, fields=["frequencies"], backend="numpy").frequencies
    spread = expected[:, -1] / expected[:, 0]
    regular = robot.condition_numbers(poses) < REGULAR
    errors, bounds = [], []
    for p, f, apart, well in zip(poses, expected, spread, regular, strict=True):
        found = robot.vibration(p, single=True)
        if well:
            assert found.status == 0
            errors.append(np.abs(found.frequencies / f - 1.0).max())
            bounds.append(max(1e-4, 1e-4 * (apart / MODERATE) ** 2))
    assert len(errors) > 30
    assert (np.array(errors) < bounds).all()


def test_where_a_pose_cannot_be_evaluated_the_status_says_why(robot: HeldRobot) -> None:
    poses = robot.poses(500)
    poses[::100, 0] = np.nan
    codes = robot.model.check(poses).codes
    assert len(set(codes.tolist())) > 2
    assert [robot.vibration(p).status for p in poses] == codes.tolist()


def test_compilers_have_nothing_to_say(robot: HeldRobot, tmp_path: Path) -> None:
    """In double precision gcc has built the libraries, with warnings as errors; clang warns before it optimises."""
    needed("gcc", "clang")
    library = library_of(tmp_path / robot.source.name, True)
    build(robot.source, library, True, "gcc", ["-Os"])
    for single in (False, True):
        build(robot.source, library, single, "clang", READ)


def test_nothing_is_allocated(robot: HeldRobot) -> None:
    source = robot.source.read_text(encoding="utf-8")
    assert not re.search(r"\b(malloc|calloc|realloc|alloca|static pkmodes_real \w+[\[;])", source)


def test_equal_frequencies_on_the_axis_of_a_symmetric_robot(shared: Shared) -> None:
    robot = HeldRobot(
        shared.folder("held_clavel", lambda folder: HeldRobot.write(folder, "clavel")), "clavel"
    )
    p = np.array([0.0, 0.0, -0.55])
    found, expected = robot.vibration(p), robot.model.modes(p, drives="held")
    assert np.diff(expected.frequencies).min() < 1e-9 * expected.frequencies[0]
    np.testing.assert_allclose(found.frequencies, expected.frequencies, rtol=1e-12)
    np.testing.assert_allclose(found.damping_ratios, 0.015, rtol=1e-12)
    assert np.isfinite(found.amplitudes).all()


def test_the_ratio_of_the_robot_file_changes_the_hash(tmp_path: Path) -> None:
    text = (ROBOTS / "corexy-printer.toml").read_text(encoding="utf-8")
    hashes = set()
    for ratio in ("1 %", "2 %"):
        file = tmp_path / "robot.toml"
        file.write_text(f'{text}\n[damping]\nratio = "{ratio}"\n', encoding="utf-8")
        generate(file, tmp_path / "out")
        header = (tmp_path / "out" / "corexy_printer.h").read_text(encoding="utf-8")
        hashes |= set(re.findall(r'_HASH "(\w+)"', header))
    assert len(hashes) == 2


def test_a_mechanism_of_ones_own_has_the_function(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(registry, "_package_by_name", {})
    (tmp_path / "five_bar.py").write_text(DEFINITION, encoding="utf-8")
    more = '\n[damping]\nratio = "1 %"\n[effects.reducer_loss]\nloss_factor = 0.02\n'
    (tmp_path / "robot.toml").write_text(ROBOT + more, encoding="utf-8")
    generate(tmp_path / "robot.toml", tmp_path / "out", tmp_path / "five_bar.py")
    monkeypatch.setitem(CASES, "own", ("robot.toml", "", {}, ([-0.15, -0.45], [0.15, -0.3])))
    source = tmp_path / "out" / "pick_and_place.c"
    build(source, library_of(source, False), False)
    build(source, library_of(source, True), True)
    robot = HeldRobot.__new__(HeldRobot)
    robot.out, robot.name, robot.source = tmp_path / "out", "pick_and_place", source
    robot.header = source.with_suffix(".h").read_text(encoding="utf-8")
    import pkmodes

    model = pkmodes.load(tmp_path / "robot.toml")
    for p in ([0.03, -0.42], [-0.1, -0.35]):
        found, expected = robot.vibration(np.array(p)), model.modes(p, drives="held", backend="numpy")
        assert found.status == 0
        np.testing.assert_allclose(found.frequencies, expected.frequencies, rtol=1e-12)
        np.testing.assert_allclose(found.damping_ratios, expected.damping_ratios, rtol=1e-12)
        amplitudes = np.linalg.norm(expected.vibration_amplitudes, axis=-1)
        np.testing.assert_allclose(found.amplitudes, amplitudes, rtol=1e-12)


def test_a_machine_that_stays_loose_has_no_function_and_the_header_says_why() -> None:
    """One belt of two is held: the tool head moves freely along the other one's direction."""
    machine = mechanisms.machine("corexy")
    machine.drives.pop()
    loose = held_motors(machine)
    assert loose == HeldMotors(("x", "y", "theta_2"), reason="1 motion strains nothing elastic")
    robot = read_robot(ROBOTS / "corexy-printer.toml")
    model = replace(mechanisms.base("corexy"), held=loose)
    texts = _written(model, robot)
    assert "_vibration(" not in texts["corexy.h"] + texts["corexy.c"]
    assert "HELD_MODES" not in texts["corexy.h"]
    said = "There is no function corexy_vibration: with the motors held, 1 motion strains nothing elastic."
    assert said in " ".join(texts["corexy.h"].split())


def test_a_machine_without_elastic_parts_between_motor_and_platform_has_no_function() -> None:
    """The motors drive the tool head itself: held, nothing moves."""
    machine = mechanisms.machine("corexy")
    for drive, q in zip(machine.drives, machine.coordinates[:2], strict=True):
        (pair,) = drive.rotors
        pair[0].coordinate = q
    remaining = held_motors(machine).coordinates
    assert remaining == ("theta_1", "theta_2")


def _written(model: object, robot: object) -> dict[str, str]:
    from pkmodes_derive.emit.identity import Identity
    from pkmodes_derive.emit.provenance import Provenance

    provenance = Provenance("corexy", "model", "t", "o", "g", "c", identity=Identity("corexy", "0"))
    texts, _ = product.write_models((model, provenance))
    return texts


def test_a_wind_up_that_moves_no_inertia_is_condensed() -> None:
    some = tuple(effect for effect in mechanisms.effects("corexy") if effect.name == "gearbox_compliance")
    pulleys = mechanisms.machine("corexy", some).tables.fields
    (inertia,) = (field for field in pulleys if field.name == "pulley_inertia")
    assert held_motors(mechanisms.machine("corexy", some)).coordinates == ("x", "y", "psi_1", "psi_2")
    condensed = held_motors(mechanisms.machine("corexy", some), frozenset(inertia.symbols))
    assert condensed.coordinates == ("x", "y")
    assert condensed.functions


def test_springs_on_held_motors_and_their_inertia_are_gone() -> None:
    """They would cancel, and take digits with them."""
    some = tuple(effect for effect in mechanisms.effects("linear_delta") if effect.name != "frame_compliance")
    machine = mechanisms.machine("linear_delta", some)
    (drive,) = (field for field in machine.tables.fields if field.name == "drive")
    idle = frozenset(symbol for index, symbol in zip(drive.indices, drive.symbols, strict=True) if index[1])
    (function,) = held_motors(machine, idle).functions
    inert = ("k_S", "b_D", "I_m")
    used, reached = set(), {s for o in function.outputs for e in o.entries for s in e.free_symbols}
    while reached:
        used |= reached
        reached = {t for s in reached for t in function.definitions.get(s, s).free_symbols} - used
    assert not [s.name for s in used if s.name.startswith(inert)]
    assert [s.name for s in used if s.name.startswith(("I_p", "k_sp"))]


def test_the_header_says_what_the_motors_do(shared: Shared) -> None:
    for case, words, count in (
        ("printer", "the motors held", 2),
        ("slinger_on_springs", "the motors on their servo stiffness", 4),
    ):
        robot = HeldRobot(shared.folder(f"held_{case}", partial(HeldRobot.write, case=case)), case)
        upper = robot.name.upper()
        assert f"/* modes with {words} */\n#define {upper}_HELD_MODES {count}\n" in robot.header
        assert f"/* The vibrations with {words}, as in use, lowest first:" in robot.header
        assert (
            f"Matrices of the vibrations with {words.removeprefix('the ')}, evaluated together."
            in robot.header
        )


def test_a_stiffness_of_nothing_leaves_the_motors_held(tmp_path: Path) -> None:
    """As everywhere: an effect whose values are 0 is none."""
    text = (ROBOTS / "bed-slinger.toml").read_text(encoding="utf-8")
    heads = []
    for more in ("", '\n[effects.servo_stiffness]\nstiffness = "0 N*m/rad"\n'):
        (tmp_path / "robot.toml").write_text(text + more, encoding="utf-8")
        generate(tmp_path / "robot.toml", tmp_path / "out")
        heads.append((tmp_path / "out" / "bed_slinger.h").read_text(encoding="utf-8"))
    assert all("_HELD_MODES 2\n" in head for head in heads)
