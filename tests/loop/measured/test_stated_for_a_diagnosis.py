"""What a file, the command line or a script states for a diagnosis: priors, and where the next pose may be."""

from __future__ import annotations

import pickle
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

import pkmodes
from pkmodes import updating
from pkmodes.cli import run
from pkmodes.core.base.errors import MeasurementError, PkmodesError
from pkmodes.core.robot.robot import Robot
from pkmodes.core.robot.usable import Limits, Radius
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.measured.writing import as_csv
from pkmodes.loop.updating.measured_robot import MeasuredRobot
from pkmodes.pages.report.report_context import ReportContext

LOOP = Path(__file__).resolve().parents[3] / "examples" / "closed_loop"
MODES = (LOOP / "measured.csv").read_text(encoding="utf-8")
OFFSET = "measurement:offset.z"


@pytest.fixture(scope="module")
def robot() -> Robot:
    return pkmodes.read_robot(LOOP / "robot.toml")


@pytest.fixture
def read(robot: Robot, tmp_path: Path):
    """Read the modes of the example below some comments."""

    def reading(*comments: str, **given) -> Measurements:
        path = tmp_path / "modes.csv"
        path.write_text("\n".join([*comments, MODES]), encoding="utf-8")
        return updating.read(path, robot=robot, **given)

    return reading


def sigmas(robot: Robot, data: Measurements, *names: str, **given) -> list[float]:
    found = {one.name: one.sigma for one in MeasuredRobot.of(robot, data).structure(None, **given).candidates}
    return [found[name][0] for name in names]


def test_a_comment_states_a_prior_of_a_candidate(robot: Robot, read) -> None:
    length = "parameter:link.length"
    data = read(f"# prior: {OFFSET} = 2 mm", f'"# Prior: {length} = 0,5 %";;;', "# priority = high")
    assert sigmas(robot, data, OFFSET, length) == pytest.approx([2e-3, 0.005 * 0.4], rel=1e-12)
    assert sigmas(robot, read(f"# prior: {OFFSET} = 0.003"), OFFSET) == [3e-3]  # without a unit: SI
    assert sigmas(robot, read(priors={OFFSET: "2 mm"}), OFFSET) == [2e-3]
    assert sigmas(robot, read(f"# prior: {OFFSET} = 2 mm", priors={OFFSET: "2mm"}), OFFSET) == [2e-3]
    both = sigmas(robot, read(f"# prior: {OFFSET} = 2 mm"), OFFSET, length, priors={length: "1 mm"})
    assert both == [2e-3, 1e-3]
    assert sigmas(robot, pickle.loads(pickle.dumps(data)).at([0, 1]), OFFSET) == [2e-3]
    # Among others than those chosen it says nothing.
    assert MeasuredRobot.of(robot, data).structure(["payload"]).candidates[0].sigma is None


def test_a_comment_states_where_the_next_pose_may_be(robot: Robot, read) -> None:
    for lines in (
        ("# usable: z = -250 mm, -240 mm", "# usable: radius = 700 mm"),
        ("# usable: z = -250,0 mm; -240,0 mm;;;", "# usable: radius=0.7"),
        ("# usable: z = ['-250 mm', '-240 mm']".replace("'", '"'), '# usable: radius = "70 cm"'),
    ):
        data = read(*lines)
        declared = Robot.of(replace(robot, usable={"x": Limits(0.1, 1.1), "z": Limits(-0.4, -0.1)}))
        measured = MeasuredRobot.of(declared, data).where_usable()
        of_both = {"x": (0.1, 1.1), "z": (-0.25, -0.24), "radius": Radius(0.7, (0.0, 0.0))}
        assert measured.robot.usable == of_both
        drawn, _ = measured.structure().elsewhere(50)
        assert len(drawn) > 10
        assert np.all((drawn[:, 2] >= -0.25) & (drawn[:, 2] <= -0.24))
        assert np.hypot(*drawn.T[:2]).max() <= 0.7


def test_what_is_stated_is_written_and_read_back(read, tmp_path: Path, robot: Robot) -> None:
    data = read(f"# prior: {OFFSET} = 2 mm", "# usable: z = -250 mm, -240 mm", "# usable: radius = 0.7")
    path = tmp_path / "written.csv"
    path.write_text(as_csv(data), encoding="utf-8")
    again = updating.read(path, robot=robot)
    for one, other in ((data.priors, again.priors), (data.usable, again.usable)):
        assert {name: stated.value for name, stated in one.items()} == {n: s.value for n, s in other.items()}


WRONG = [
    ([f"# prior {OFFSET} = 2 mm"], {}, "line 1", 'expected a colon after "prior"'),
    (["# prior: 2 mm"], {}, "line 1", 'expected a name = a value, found "2 mm"'),
    (["# usable: z ="], {}, "line 1", "expected a name = a value"),
    (["# usable z = 1, 2"], {}, "line 1", 'expected a colon after "usable"'),
    (["#", f"# prior: {OFFSET} = 2 mm", f"# prior: {OFFSET} = 3 mm"], {}, "line 3", "that in line 2"),
    ([f"# prior: {OFFSET} = 2 mm"], {"priors": {OFFSET: "3 mm"}}, "line 1", "= 2 mm, not 3 mm"),
    (["# usable: z = 1, 2"], {"usable": {"z": [1.0, 3.0]}}, "line 1", "z = 1.0, 2.0, not 1.0, 3.0"),
    ([], {"usable": 3}, "usable", "expected a mapping of names to values, found 3"),
    (["# prior: measurement:ofset.z = 1 mm"], {}, "line 1", "no candidate"),
    ([f"# prior: {OFFSET} = 1 kg"], {}, "line 1", "wrong dimension"),
    ([f"# prior: {OFFSET} = 2 MM"], {}, "line 1", 'write "2 mm"'),
    ([], {"priors": {OFFSET: "2,5 mm"}}, OFFSET, 'write "2.5 mm"'),
    (["# prior: platform.mass = 1 g"], {}, "line 1", "the robot file gives a sigma"),
    (["# usable: w = 1, 2"], {}, "line 1", 'found "w"'),
    (["# usable: z = 2, 1"], {}, "line 1", "exchange them"),
    (["# usable: z = 2 kg, 1"], {}, "line 1", "expected a length"),
    ([], {"usable": {"z": [1, "x"]}}, "usable: z", "expected a length"),
]


def test_what_is_no_prior_and_no_limit_is_refused_with_its_line(
    subtests: pytest.Subtests, robot: Robot, read
) -> None:
    for comments, given, where, what in WRONG:
        with subtests.test(comments=comments, given=given), pytest.raises(PkmodesError) as error:
            updating.diagnose(robot, read(*comments, **given))
        assert error.value.where.endswith(where), str(error.value)
        assert what in str(error.value)
        assert error.value.remedy


def test_the_command_line_states_the_same(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    given: list[Measurements] = []

    def diagnose(_: Robot, data: Measurements, **__: object) -> None:
        given.append(data)
        raise PkmodesError("enough", "here", "go on")

    files = [str(LOOP / "robot.toml"), str(LOOP / "measured.csv")]
    with monkeypatch.context() as patched:
        patched.setattr(updating, "diagnose", diagnose)
        options = [f"--prior={OFFSET}=2mm", "--usable", "z = 0, 20 cm", "--usable", "radius=0.7"]
        assert run(["diagnose", *files, *options]) == 2
    assert given[0].priors[OFFSET].value == "2mm"
    assert {name: one.value for name, one in given[0].usable.items()} == {"z": [0.0, "20 cm"], "radius": 0.7}
    capsys.readouterr()
    for option, where in {
        "--prior=far": "(--prior)",
        "--prior=far=1": "(--prior far)",
        "--usable=w=1,2": "(--usable w)",
        "--usable=z": "(--usable)",
    }.items():
        assert run(["diagnose", *files, option]) == 2
        assert where in capsys.readouterr().err


def test_the_report_says_what_was_stated(read) -> None:
    data = read(f"# prior: {OFFSET} = 2 mm", "# usable: z = -1, 20 cm")
    evidence = SimpleNamespace(labels=["P1"], measured=[50.0], setup_noun="pose")
    facts = str(ReportContext("x", None, data, (), None).origin(evidence))
    assert f"{OFFSET} = 2 mm" in facts
    assert "z = -1.0, 20 cm" in facts


def test_a_script_states_them_with_its_rows() -> None:
    data = Measurements.from_rows(["A"], [50.0], [0.1], priors={OFFSET: "1 mm"}, usable={"z": ["0 m", "1 m"]})
    assert data.priors[OFFSET].value == "1 mm"
    assert data.usable["z"].where == "usable: z"
    with pytest.raises(MeasurementError, match="expected a mapping"):
        Measurements.from_rows(["A"], [50.0], [0.1], priors=["1 mm"])  # type: ignore[arg-type]
