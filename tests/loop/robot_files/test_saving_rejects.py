"""Corrections that are refused: values that would not be accepted, layouts, and files that would be replaced."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

import pkmodes
from helpers.pages.report_examples import made_up
from helpers.robots.corrected_files import correct, with_joints
from helpers.robots.robot_text import PUBLISHED, edited, published
from pkmodes.core.base.errors import OutputError, PkmodesError, RobotFileError
from pkmodes.loop.diagnosis.verdict.findings import Corrected
from pkmodes.loop.robot_files.saving import Correction, corrected_text, save_corrected
from pkmodes.loop.updating.corrected_robot import corrected_robot, corrections


@pytest.mark.parametrize(
    ("path", "correction", "expected"),
    [
        ("platform.mas", Correction(1.0), 'did you mean "platform.mass"?'),
        ("axis.4.belt.width", Correction(1.0), 'did you mean "axis.'),
        ("axis.1.direction", Correction(1.0), "there is no value"),
        ("axis.1.branch", Correction(1.0), "there is no value"),
        ("", Correction(1.0), "there is no value"),
        ("effects.paylod.mass", Correction(1.0), 'did you mean "effects.payload.mass"?'),
        ("platform.mass", Correction(float("nan")), "expected a finite value"),
        ("platform.mass", Correction(1.0, -1.0), "standard deviation of at least 0"),
        ("platform.mass", Correction(1.0, float("inf")), "standard deviation of at least 0"),
        ("platform.mass", Correction(-1.0), "would be rejected: expected a mass greater than 0 kg"),
        ("platform.mass", Correction(1e99), "would be rejected: expected a mass"),
        ("effects.payload.mass", Correction(-1.0), "would be rejected: expected a mass greater than 0 kg"),
        ("axis.joint_radius", Correction(0.1), "joint 1 cannot be changed along its direction: it is 0"),
        ("axis.span", Correction(-0.1), "would be rejected: expected the lower limit first"),
    ],
)
def test_what_cannot_be_corrected_is_refused(
    tmp_path: Path, path: str, correction: Correction, expected: str
) -> None:
    source = tmp_path / "robot.toml"
    source.write_text(published(), encoding="utf-8")
    with pytest.raises(OutputError) as error:
        save_corrected(source, tmp_path / "new.toml", {path: correction})
    assert expected in str(error.value)
    assert str(source) in error.value.where
    assert not (tmp_path / "new.toml").exists()


def test_a_shared_value_that_is_not_there_is_not_added(tmp_path: Path) -> None:
    text = edited('width = "15 mm"', "").replace("branch = ", "belt.width = 0.015\nbranch = ")
    with pytest.raises(OutputError, match="there is no value"):
        correct(tmp_path, text, belt__width=Correction(0.02))


def test_a_joint_cannot_shrink_through_the_centre(tmp_path: Path) -> None:
    with pytest.raises(OutputError, match=r"joint 1 .* it would become 0 m"):
        correct(tmp_path, with_joints(), axis__joint_radius=Correction(0.0))


def test_a_value_is_not_changed_twice(tmp_path: Path) -> None:
    changes = {"axis.1.limits.min": Correction(0.1), "axis.span": Correction(1.3)}
    with pytest.raises(OutputError, match="changed twice") as error:
        corrected_text(PUBLISHED, changes)
    assert error.value.where == f"{PUBLISHED}: axis.1.limits.min"


def test_a_layout_that_cannot_be_kept_is_refused(tmp_path: Path) -> None:
    text = published().replace("[platform]\n", "")
    head, first, rest = text.split("[[axis]]", 2)
    link = '[platform]\nmass = "1.5 kg"\n'
    head = head.replace('mass = "1.5 kg"                     # m_p, after equation 24\n', "")
    with pytest.raises(OutputError, match="keep its layout"):
        correct(tmp_path, f"{head}[[axis]]{first}{link}[[axis]]{rest}", link__mass=Correction(0.6))


def test_what_does_not_read_back_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("pkmodes.loop.robot_files.saving.DIGITS_OF_ELEMENTS", 3)
    with pytest.raises(OutputError, match=r"does not read back: expected 1\.20005 .* found 1\.2 "):
        corrected_text(PUBLISHED, {"axis.span": Correction(1.2001)})


def test_the_robot_file_is_never_replaced(tmp_path: Path) -> None:
    source = tmp_path / "robot.toml"
    source.write_text(published(), encoding="utf-8")
    (tmp_path / "link.toml").symlink_to(source)
    (tmp_path / "hard.toml").hardlink_to(source)
    for name in ("robot.toml", "link.toml", "hard.toml", "../" + tmp_path.name + "/robot.toml"):
        with pytest.raises(OutputError, match="replace its own input"):
            save_corrected(source, tmp_path / name, {"platform.mass": Correction(1.4)})
    for name in ("", "absent/new.toml", "a\0b"):
        with pytest.raises(OutputError, match="existing folder"):
            save_corrected(source, tmp_path / name, {"platform.mass": Correction(1.4)})
    assert source.read_text(encoding="utf-8") == published()
    with pytest.raises(RobotFileError, match="no such file"):
        save_corrected(tmp_path / "absent.toml", tmp_path / "new.toml", {})


def test_only_a_settled_diagnosis_of_a_robot_file_corrects_it(tmp_path: Path) -> None:
    """What concerns the measurements, such as their yaw, is no value of the robot."""
    robot = pkmodes.read_robot(PUBLISHED)
    yaw = Corrected("measurement.yaw", 0.01, 0.001, "rad", 0.0, None, False)
    mass = Corrected("platform.mass", 1.25, 0.01, "kg", 1.5, 0.1, False)
    found, _ = made_up(poses=2, modes=2)
    found = replace(found, effects=(), corrected=(yaw, mass))
    assert list(corrections(robot, found)) == ["platform.mass"]
    for verdict in ("ambiguous", "unexplained", "insufficient_data"):
        with pytest.raises(PkmodesError, match=f"the verdict is {verdict}"):
            corrected_robot(robot, replace(found, verdict=verdict))
    with pytest.raises(PkmodesError, match="expected a robot read from a file"):
        corrected_robot(replace(robot, source=str(tmp_path / "gone.toml")), found)
