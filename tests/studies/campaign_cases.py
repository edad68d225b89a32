"""Runs a machine of the suite of campaigns: the folder is measured, identified, diagnosed and judged."""

from __future__ import annotations

import csv
import io
import tempfile
import time
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from pkmodes import updating
from pkmodes.core.robot.robot import Robot
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.loop.measured.writing import as_csv
from pkmodes.modaltest.campaign.campaign import read_campaign
from pkmodes.modaltest.campaign.identify import identify
from pkmodes_rig.signals.campaigns import CAMPAIGN, make
from pkmodes_rig.signals.small_motion import Losses
from studies.campaign_judging import Judged, judge
from studies.campaign_machines import CampaignCase, bench
from studies.judging import diagnosed, judged, same_of
from studies.running import Outcome
from studies.specimens import measurements_of, robot_of
from studies.strengths import left_by_declared

#: What a laboratory knows of the sensitivity and mounting of its sensors, relative to the largest component.
CALIBRATION = 0.01
#: The damping ratio of all modes, as a candidate.
RATIO = "parameter:damping.ratio"
#: Columns that have no part in the signal.
LEFT_OUT = ("sigma_shape", "damping", "sigma_damping")


@dataclass(frozen=True)
class CampaignOutcome(Outcome[CampaignCase]):
    """Outcome of a machine.

    Attributes
    ----------
    calibrated : str
        The state of a diagnosis of the same rows with `CALIBRATION` added to every ``sigma_shape``, in quadrature.
    judged : Judged or None
        None if the identification failed.
    unkind : tuple of str
        What went wrong in the laboratory.
    messages : tuple of str
        Of the identification.
    identifying : float
        Time of the identification [s].
    files : int
    """

    calibrated: str = ""
    judged: Judged | None = None
    unkind: tuple[str, ...] = ()
    messages: tuple[str, ...] = ()
    identifying: float = 0.0
    files: int = 0


def run(case: CampaignCase, keep: Path | None = None) -> CampaignOutcome:
    """Measure, identify, diagnose and judge a machine; its folder is written to `keep` if given."""
    rng = np.random.default_rng([case.seed, 2, case.number])
    on = bench(case, rng)
    with tempfile.TemporaryDirectory() as temporary:
        folder = keep or Path(temporary)
        folder.mkdir(parents=True, exist_ok=True)
        tests = [on.test] * len(on.poses)
        made = make(folder, on.machine, on.robot, on.poses, on.repeats, on.wander, tests, on.paper, rng)
        begin = time.perf_counter()
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", RuntimeWarning)
            found = identify(read_campaign(folder / CAMPAIGN))
        identifying = time.perf_counter() - begin
        rows = judge(found.records, made, on.test, on.paper.band)
        text = as_csv(found.measurements, [])
        (folder / "modes.csv").write_text(text, encoding="utf-8")
    robot = robot_of(case.robot)
    diagnosis, fields = diagnosed(
        case.names, {}, lambda: updating.diagnose(robot, measurements_of(text, robot), terms=False)
    )
    wider = updating.diagnose(robot, measurements_of(_rewritten(text, _calibrated), robot), terms=False)
    return CampaignOutcome(
        case=case,
        **fields | {"state": _state(case, on.machine.losses, diagnosis)},
        signal=_signal(robot, text, rows, diagnosis) if case.cause else 0.0,
        calibrated=_state(case, on.machine.losses, wider),
        judged=rows,
        unkind=on.unkind,
        messages=tuple(message for one in found.records for message in one.messages),
        identifying=identifying,
        files=len(made.files),
    )


def _state(case: CampaignCase, losses: Losses, diagnosis: Diagnosis) -> str:
    """Return the state of an outcome: of the cause that shifts frequencies, and of losses that are claimed beside it.

    A claim of losses is wrong if the machine has none of a class.  Where a machine has Coulomb friction, viscous
    friction at its joints is wrong too: the catalogue lacks what is there.
    """
    claims = [set(f.members) for f in diagnosis.damping.effects]
    true = {RATIO} if losses.ratio else set()
    true |= {"belt_loss", "reducer_loss"} if losses.factor else set()
    true |= {"rail_friction"} if losses.viscous and not losses.coulomb else set()
    if any(not claim & true for claim in claims):
        return "wrong"
    return judged(case.names, diagnosis, same=same_of(case.robot))


def _rewritten(text: str, change: Callable[[int, dict[str, str]], dict[str, str] | None]) -> str:
    """Return a measurement file with changed rows, given by their numbers and cells; None leaves a row out."""
    lines = text.splitlines()
    begin = next(i for i, line in enumerate(lines) if not line.startswith("#"))
    rows = [change(i, row) for i, row in enumerate(csv.DictReader(lines[begin:]))]
    kept = [row for row in rows if row is not None]
    out = io.StringIO()
    writer = csv.DictWriter(out, list(kept[0]) if kept else [], lineterminator="\n")
    writer.writeheader()
    writer.writerows(kept)
    return "\n".join([*lines[:begin], out.getvalue()])


def _calibrated(_: int, row: dict[str, str]) -> dict[str, str]:
    stated = row.get("sigma_shape")
    return {**row, "sigma_shape": f"{np.hypot(float(stated), CALIBRATION):.6g}"} if stated else row


def _signal(robot: Robot, text: str, rows: Judged, diagnosis: Diagnosis) -> float:
    """Return the signal of the cause: rows at their true frequencies, with their standard deviations.

    The band is left out: a true frequency may lie outside it where the measured one does not.
    """
    without_band = "\n".join(line for line in text.splitlines() if not line.startswith("# band"))

    def exact(i: int, row: dict[str, str]) -> dict[str, str] | None:
        # Shapes serve only to pair the modes: the signal is computed from the frequencies.
        kept = {name: cell for name, cell in row.items() if name not in LEFT_OUT}
        one = rows.rows[i]
        return {**kept, "frequency": f"{one.nominal:.12g}"} if one.mode >= 0 else None

    try:
        data = measurements_of(_rewritten(without_band, exact), robot)
        return left_by_declared(robot, data, diagnosis.held_out_poses) or 0.0
    except (ValueError, IndexError):  # too few rows
        return 0.0
