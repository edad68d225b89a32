"""Measured frequency responses on the page of a diagnosis, over those of the robot before and after."""

from __future__ import annotations

import shutil
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from pkmodes.cli import run
from pkmodes.core.base.errors import PkmodesError
from pkmodes.diagnosis import Diagnosis
from pkmodes.loop import updating
from pkmodes.machine.response.campaign_responses import record_response
from pkmodes.modaltest.campaign.campaign import Campaign, read_campaign
from pkmodes.pages.report import report
from pkmodes.pages.report.campaign_responses import accelerances, measured_responses

EXAMPLES = Path(__file__).resolve().parents[3] / "examples"
CAMPAIGN = EXAMPLES / "campaign/campaign.toml"
#: What the machine in MuJoCo has and its robot file lacks (examples/campaign/README.md).
TRUTH = {"effects.link_compliance.compliance": 4.0e-7, "effects.rail_friction.viscous": 3.0}
#: A force across the axes: `direction` in the campaign file, normalised.
OBLIQUE = np.array([0.6, 0.5, -0.624]) / np.linalg.norm([0.6, 0.5, -0.624])


@cache
def campaign() -> Campaign:
    return read_campaign(CAMPAIGN)


def misfits(record: int, values: dict[str, float]) -> np.ndarray:
    """Return the median error of the magnitude of each channel, as a factor's logarithm, where it responds."""
    measured = record_response(campaign(), campaign().records[record])
    f = measured.frequencies[(measured.frequencies >= 15.0) & (measured.frequencies <= 180.0)]
    robot = pkmodes.load(CAMPAIGN.with_name("robot.toml")).robot
    model = accelerances(robot.with_values(values), campaign().records[record], measured, f, 0.01).values
    errors = []
    for name, x in model.items():
        y = measured.channels[name][np.isin(measured.frequencies, f)]
        large = np.abs(y) > 0.02 * np.abs(y).max()
        assert (
            np.cos(np.angle(x[large] / y[large])).mean() > 0.9 or not values
        )  # the force has the right sign
        errors.append(np.median(np.abs(np.log(np.abs(x[large] / y[large])))))
    return np.array(errors)


@pytest.mark.parametrize("record", [1, 4])  # blows of a hammer, functions of a shaker
def test_the_responses_of_a_machine_in_another_engine_are_those_of_the_model_with_its_effects(
    record: int,
) -> None:
    declared, true = misfits(record, {}), misfits(record, TRUTH)
    assert len(true) == 6
    # Of the values that the file calls uncertain some are off: peaks are shifted a little.
    assert np.median(true) < 0.1 < 0.15 < declared.max()
    assert (true < declared).all()


def test_an_oblique_force_is_the_sum_of_forces_along_the_axes() -> None:
    record = campaign().records[4]
    measured = record_response(campaign(), record)
    assert list(measured.excitations) == ["101:+X"]
    weights = measured.excitations["101:+X"]
    np.testing.assert_allclose([weights[f"force_{axis}"] for axis in "xyz"], OBLIQUE, rtol=1e-12)
    model = pkmodes.load(CAMPAIGN.with_name("robot.toml")).with_values({"damping.ratio": 0.02})
    f = np.linspace(20.0, 60.0, 5)
    found = accelerances(model.robot, record, measured, f, 0.5)
    expected = model.frf(
        [record.point[axis] for axis in "xyz"],
        f,
        ["force_x", "force_y", "force_z"],
        ["p_x", "x_2"],
        drives="held",
        quantity="acceleration",
    )
    for o, name in enumerate(("p_x/101:+X", "x_2/101:+X")):
        np.testing.assert_allclose(found.values[name], expected.values[:, o] @ OBLIQUE, rtol=1e-12)
        assert found.units[name] == expected.units[o][0]


def test_a_force_beside_the_origin_of_a_platform_that_turns_has_moments_too() -> None:
    hexapod = read_campaign(EXAMPLES / "hexapod/campaign.toml")
    (weights,) = record_response(hexapod, hexapod.records[0]).excitations.values()
    arm, direction = np.array([0.060, -0.080, 0.025]), np.array([-0.36, 0.48, -0.80])
    expected = dict(zip(("force_x", "force_y", "force_z"), direction, strict=True))
    expected |= dict(zip(("moment_x", "moment_y", "moment_z"), np.cross(arm, direction), strict=True))
    for name, value in expected.items():
        assert weights.get(name, 0.0) == pytest.approx(value, abs=1e-12)


def test_a_fixed_force_changes_no_mode_and_gives_no_component(tmp_path: Path) -> None:
    for path in (CAMPAIGN.with_name("robot.toml"), *CAMPAIGN.parent.glob("p5_*.uff")):
        shutil.copy(path, tmp_path)
    text = CAMPAIGN.read_text(encoding="utf-8")
    head, _, records = text.partition('[[record]]\npose = "P1"')
    head = head.replace('repeatability = "0.2 %"', 'repeatability = "0.1 %"')
    fifth = records[records.index('[[record]]\npose = "P5"') : records.index('[[record]]\npose = "P6"')]
    start, end = head.index("[[force]]"), len(head)
    rows = []
    for name, forces in (("with", head[start:end]), ("without", "")):
        (tmp_path / f"{name}.toml").write_text(head[:start] + forces + fifth, encoding="utf-8")
        assert run(["identify", str(tmp_path / f"{name}.toml"), "--out", str(tmp_path / "modes.csv")]) == 0
        rows.append((tmp_path / "modes.csv").read_text(encoding="utf-8").replace(f"{name}.toml", ""))
    assert rows[0] == rows[1]
    assert rows[0].count("\nP5,") > 3


@pytest.fixture(scope="module")
def diagnosed(tmp_path_factory: pytest.TempPathFactory) -> Diagnosis:
    """The diagnosis of the example's modes."""
    file = tmp_path_factory.mktemp("modes") / "modes.csv"
    assert run(["identify", str(CAMPAIGN), "--out", str(file)]) == 0
    robot = pkmodes.read_robot(CAMPAIGN.with_name("robot.toml"))
    return updating.diagnose(robot, updating.read(file, robot=robot))


def test_the_page_draws_the_poses_at_which_the_robot_is_worst(diagnosed: Diagnosis) -> None:
    robot = pkmodes.read_robot(CAMPAIGN.with_name("robot.toml"))
    pictures = measured_responses(diagnosed, robot, campaign())
    text = " ".join(str(picture) for picture in pictures)
    errors = {
        stage: max(
            (row for row in diagnosed.rows if row.before is not None and not row.outlier),
            key=lambda row: abs(getattr(row, stage) / row.measured - 1.0),
        ).pose
        for stage in ("before", "after")
    }
    assert f"at {errors['before']}" in text
    assert f"at {errors['after']}" in text
    assert (
        "broad lines are measured, dashed ones the robot as declared (before), thin ones as corrected" in text
    )
    assert "the largest of 6: broad lines" in text
    assert len(pictures) == len(set(errors.values()))


def test_a_campaign_of_other_poses_or_without_the_place_of_its_force_is_refused(
    diagnosed: Diagnosis, tmp_path: Path
) -> None:
    robot = pkmodes.read_robot(CAMPAIGN.with_name("robot.toml"))
    renamed = replace(
        campaign(), records=tuple(replace(record, pose=f"Q{record.number}") for record in campaign().records)
    )
    with pytest.raises(PkmodesError, match="at P1, P2, P3, P4, P5, P6, found those at Q1, Q2"):
        measured_responses(diagnosed, robot, renamed)
    with pytest.raises(PkmodesError, match=r'does not say where the force "101:\+X" acts.*fixed = true'):
        measured_responses(diagnosed, robot, replace(campaign(), forces=()))
    along_rail = replace(campaign().forces[0], weights={"x_1": 1.0})
    with pytest.raises(PkmodesError, match="expected a force on the platform, found forces along x_1"):
        measured_responses(diagnosed, robot, replace(campaign(), forces=(along_rail,)))


def test_the_command_needs_a_report_to_draw_in(capsys: pytest.CaptureFixture[str]) -> None:
    robot = str(CAMPAIGN.with_name("robot.toml"))
    assert (
        run(["diagnose", robot, str(EXAMPLES / "closed_loop/measured.csv"), "--campaign", str(CAMPAIGN)]) == 2
    )
    error = capsys.readouterr().err
    assert "--campaign is for the report, which is not written" in error
    assert "add --report FILE.html, or leave --campaign out" in " ".join(error.split())


def test_a_report_takes_a_campaign_that_was_read_or_its_file(diagnosed: Diagnosis) -> None:
    robot = pkmodes.read_robot(CAMPAIGN.with_name("robot.toml"))
    from_file = report(diagnosed, robot=robot, campaign=CAMPAIGN)
    assert 'id="responses"' in from_file
    assert report(diagnosed, robot=robot, campaign=campaign()) == from_file
