"""Results to make reports of: one of every verdict from the virtual rig, and made-up ones, large or hostile."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from helpers.diagnoses.diagnose_command import files
from helpers.diagnoses.verdict_examples import given, judged
from helpers.runs.shared import Shared
from pkmodes import read_robot, updating
from pkmodes.core.robot.robot import Robot
from pkmodes.loop.diagnosis import Diagnosis, Measurements
from pkmodes.loop.diagnosis.match.predicted import PartnerPredictions
from pkmodes.loop.diagnosis.verdict.findings import Corrected, Examined, Finding, Stability, Value
from pkmodes.loop.diagnosis.verdict.result import Stages
from pkmodes.loop.diagnosis.verdict.rows import Error, Row
from pkmodes.pages.report import report

#: Text that a careless page would execute, obey or be torn apart by.
HOSTILE = (
    '<script>document.title = "hacked"</script>',
    "<img src=x onerror=\"document.title='hacked'\">",
    '"><svg onload=alert(1)>',
    "</style></title></script><h1>",
    "{{ 7 * 7 }}{% raw %}",
    "$\\frac{1}{$ unbalanced $$",
    "\u202egnitset\u202c \u2066isolated\u2069 \u05e9\u05dc\u05d5\u05dd",
    "\x00\x07\x1b[31m\ud800 controls",
    "#0072b2 url(#a) var(--ink)",
    "\u6f22\u5b57\u30fb\U0001f600",
    "' onmouseover='alert(1)",
    "x" * 10_000,
)


#: Made once: the files are the same in every folder.
_DIAGNOSES: dict[str, Diagnosis] = {}


def diagnosed(verdict: str, folder: Path) -> tuple[Diagnosis, Robot, Measurements]:
    """Return a diagnosis with a verdict, and what it was made from."""
    modes, candidates = given(verdict)
    robot_file, modes_file = files(folder, modes=modes)
    robot = read_robot(robot_file)
    data = updating.read(modes_file, None, robot)
    if verdict not in _DIAGNOSES:
        with judged(verdict):
            _DIAGNOSES[verdict] = updating.diagnose(robot, data, candidates=candidates.split(","))
    result = _DIAGNOSES[verdict]
    assert result.verdict == verdict
    return result, robot, data


def page_of(verdict: str, folder: Path, shared: Shared) -> str:
    """Return the page of `diagnosed`, which the tests of a run make once."""

    def made() -> str:
        result, robot, data = diagnosed(verdict, folder)
        return report(result, robot=robot, data=data)

    return shared.value(f"page of {verdict}", made)


def many_modes(shared: Shared) -> str:
    """Return the page of 10 000 measured modes, which the tests of a run make once."""

    def made() -> str:
        result, data = made_up(500, 20)
        return report(result, data=data, title="many")

    return shared.value("page of many modes", made)


def hostile_page(shared: Shared) -> str:
    """Return the page on which every name and label is hostile, which the tests of a run make once."""

    def made() -> str:
        result, data = made_up(12, 3, labels=HOSTILE, names=HOSTILE)
        return report(result, data=data, title=" ".join(HOSTILE))

    return shared.value("page of hostile names", made)


def made_up(
    poses: int,
    modes: int,
    *,
    labels: tuple[str, ...] | None = None,
    names: tuple[str, ...] = (),
    seed: int = 3,
) -> tuple[Diagnosis, Measurements]:
    """Return a diagnosis of `poses` times `modes` measured modes that nobody computed.

    Parameters
    ----------
    poses, modes : int
    labels : tuple of str, optional
        Labels of the poses.
    names : tuple of str
        Names of further candidates and values, and sentences of notes.
    seed : int
    """
    rng = np.random.default_rng(seed)
    labels = labels or tuple(f"P{i}" for i in range(poses))
    count = poses * modes
    setup, mode = np.divmod(np.arange(count), modes)
    spectrum = 40.0 * np.arange(1, modes + 3) ** 0.8 * (1 + 0.05 * rng.random((poses, 1)))
    true = spectrum[setup, mode]
    frequency = true * (1 + 0.002 * rng.standard_normal(count))
    sigma = 0.002 * frequency
    macs = np.eye(modes + 2)[mode] * 0.9 + 0.05 * rng.random((count, modes + 2))

    def stage(error: float) -> PartnerPredictions:
        own = true * (1 + error * mode / modes)
        lost = rng.random(count) < 0.01
        return PartnerPredictions(
            frequency=np.where(lost, np.nan, own),
            partner_mode=np.where(lost, 0, mode + 1),
            normalised_differences=np.where(lost, np.nan, np.log(own / frequency) / 0.002),
            partner_mac=np.where(lost, np.nan, macs[np.arange(count), mode]),
            fitted_mac=np.where(lost, np.nan, macs[np.arange(count), mode]),
            mac_by_mode=macs,
            elastic_frequencies=spectrum,
            nearest_frequency=np.full(count, np.nan),
            nearest_mac=np.full(count, np.nan),
        )

    before, refit, after = stage(0.04), stage(0.02), stage(0.0)
    held, outlier = setup % 6 == 0, rng.random(count) < 0.003
    known = [[None if np.isnan(f) else float(f) for f in s.frequency] for s in (before, refit, after)]
    rows = tuple(
        Row(
            pose=labels[setup[i]],
            line=i + 2,
            mode=names[i % len(names)] if names else "",
            measured=float(frequency[i]),
            sigma=float(sigma[i]),
            drives="free",
            before=known[0][i],
            refit=known[1][i],
            after=known[2][i],
            mac=None if np.isnan(after.partner_mac[i]) else float(after.partner_mac[i]),
            held_out=bool(held[i]),
            outlier=bool(outlier[i]),
        )
        for i in range(count)
    )
    value = Value("effects.payload.mass", 0.3, 0.01, "kg")
    data = Measurements.from_rows(
        [f"P{i}" for i in setup],
        frequency,
        sigma,
        points=np.repeat(rng.uniform(-0.5, 0.5, (poses, 3)), modes, axis=0),
        lines=np.arange(count) + 2,
    )
    if names:  # labels that a file cannot have
        object.__setattr__(data, "labels", labels)
    members = ("payload", *names)
    result = Diagnosis(
        verdict="effect_found",
        reason=" ".join(["the residual of the declared model is not noise", *names]),
        effects=(
            Finding("payload", members, (value,), dict.fromkeys(members, (value,)), 0.0, " ".join(names)),
        ),
        survivors=(),
        refitted=(),
        before=Error(0.02, 0.021, 180.0),
        refit=Error(0.01, 0.011, 61.0),
        after=Error(0.002, 0.002, 1.02),
        held_out_poses=tuple(labels[i] for i in range(0, poses, 6)),
        undetectable=names,
        next_measurement=None,
        candidates=tuple(Examined(n, 0.1, (value,), True) for n in ("payload", "belt_mass", *names)),
        rows=rows,
        scatter=0.0,
        corrected=tuple(
            Corrected(name, 0.3, 0.01, "kg", 0.0, 0.2, False) for name in ("effects.payload.mass", *names)
        ),
        notes=names,
        stability=(Stability("sigma x 2", "effect_found", ("payload", *names)),),
        stages=Stages(before, refit, after),
    )
    return result, data
