"""Run the cases and judge their outcomes."""

from __future__ import annotations

import itertools
import re
import time
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from pkmodes import updating
from pkmodes.diagnosis import diagnose
from pkmodes.diagnosis.verdict.result import Diagnosis
from pkmodes_rig import ASKEW, MISTAKES, ORDERS, Laboratory, followed, read
from pkmodes_rig.suites.buildings import Building
from pkmodes_rig.suites.cases import Case, Trial, tried
from pkmodes_rig.suites.motors import OTHER_DRIVES
from pkmodes_rig.suites.strengths import measurements, signal

#: Corrections of the measurement itself, which are not causes in the machine.
MEASUREMENT = "measurement:"
POSITIONS = tuple(f"{MEASUREMENT}{name}" for name in ("offset.x", "offset.y", "offset.z", "yaw"))

#: Candidates equivalent to the truth whatever is measured: a class that contains one of them is right.  The modes
#: depend only on the product gear_ratio^2 * motor.inertia, which is an inertia on the driven pulley; another belt
#: width changes the stiffness of each axis with that belt; where the poses in the file are wrong, a displacement that
#: stands for a rotation is right.
SAME: dict[str, tuple[str, ...]] = {
    "gearbox_inertia": ("parameter:motor.gear_ratio",),
    "parameter:motor.gear_ratio": ("gearbox_inertia",),
    "parameter:belt.width": ("axis_belt_stiffness",),
    "parameter:axis.2.belt.width": ("axis_belt_stiffness",),
    **dict.fromkeys(POSITIONS, POSITIONS),
}

#: Rows beyond the unknowns that a claim needs after a row was set aside: one for that row, and one to test it with.
SPARE = 2

#: Words that a note must mention, by kind of mistake in the file.
MENTIONS = {
    "unit": re.compile(r"\bunits?\b|\bfactor\b|rad/s|\brpm\b|2 ?\*? ?pi", re.IGNORECASE),
    "channels": re.compile(r"channel|sensor|wir(ed|ing)|swapped|exchanged|\b[xp]_[123xyz]\b", re.IGNORECASE),
    "drives": re.compile("with motors (free|held)(, not| than) with|with free and held exchanged"),
    "sigma": re.compile(
        r"(sigma|stated|standard deviation|error).*\b(large|great|high|big|cautious)", re.IGNORECASE
    ),
}
#: A note that calls the wiring of the sensors wrong, and one that leaves open which wiring is right.
MISWIRED, OPEN = re.compile("as in the file, by"), "do not tell which"
#: Mistakes that must be noted.
NOTED = {
    "rad/s for Hz": "unit",
    "rpm for Hz": "unit",
    "x_1 and x_2 exchanged": "channels",
    "p_y and p_z exchanged": "channels",
    "sigma far too large": "sigma",
}


@dataclass(frozen=True)
class Outcome:
    """Outcome of a case; attributes not described here are copied from the diagnosis.

    Attributes
    ----------
    state : str
        ``adequate``; ``abstained`` (ambiguous, unexplained, insufficient_data); for a claim: ``named`` (each
        cause in a separate class), ``partly`` (nothing wrong, but not every cause), ``wrong`` (a class without any
        of the causes, or rows of a faulty case set aside without redundancy).
    classes : tuple of tuple of str
        Classes of the causes found, or the survivors.
    values : tuple of (name, estimate, sigma, true)
        Parameters of the causes that were named.
    renamed : bool
        Whether a class counts as right only by `SAME`.
    signal : float
        Predicted signal for the modes that were found; see `strengths`.
    beyond : tuple of float
        For two effects: the signal of each beyond the other.
    physical : bool
        Whether a wrong class claims a cause in the machine, not just a correction of the measurement.
    mac : tuple of two floats, or None
        Smallest MAC of the claim, and of the truth, against the measured shapes.
    noted : bool or None
        Whether the notes mention the mistake, if they should.
    rewired : bool or None
        For a wrong signed order, whether the file is right after the advice of the notes was followed; otherwise
        whether the notes call the wiring wrong, None if it is.
    misnamed : bool
        Whether the notes name another signed order than the right one.
    """

    case: Case
    state: str
    verdict: str
    classes: tuple[tuple[str, ...], ...]
    values: tuple[tuple[str, float, float, float], ...] = ()
    renamed: bool = False
    signal: float = 0.0
    beyond: tuple[float, ...] = ()
    seconds: float = 0.0
    reason: str = ""
    scatter: float = 0.0
    outliers: int = 0
    rows: int = 0
    poses: int = 0
    physical: bool = False
    mac: tuple[float, float] | None = None
    noted: bool | None = None
    rewired: bool | None = None
    misnamed: bool = False
    notes: tuple[str, ...] = ()
    laboratory: Laboratory | None = None


def run(case: Case) -> Outcome:
    """Measure, diagnose and judge a case."""
    test = tried(case)
    start = time.perf_counter()
    diagnosis = diagnosed(case, test.text)
    seconds = time.perf_counter() - start
    state = judged(case.names, diagnosis)
    faulty = bool(case.edit or case.names or case.truth.outside)
    if diagnosis.verdict in ("adequate", "effect_found") and faulty and set_aside_blindly(case, diagnosis):
        state = "wrong"
    notes = tuple(diagnosis.notes) if hasattr(diagnosis, "notes") else ()
    return Outcome(
        case=case,
        state=state,
        verdict=diagnosis.verdict,
        classes=tuple(f.members for f in diagnosis.effects) or diagnosis.survivors,
        values=tuple(values(case, diagnosis)),
        renamed=judged(case.names, diagnosis) != judged(case.names, diagnosis, same={}),
        **_signals(case, test, diagnosis),
        seconds=seconds,
        reason=diagnosis.reason,
        scatter=diagnosis.scatter,
        outliers=len(diagnosis.outliers),
        rows=len(diagnosis.rows),
        poses=len({row.pose for row in diagnosis.rows}),
        physical=state == "wrong" and physical(case.names, diagnosis),
        mac=_macs(test, diagnosis) if diagnosis.effects else None,
        noted=mentioned(kind, notes) if (kind := noticeable(case)) else None,
        **_rewired(case, test, notes),
        notes=notes,
        laboratory=test.laboratory,
    )


def noticeable(case: Case) -> str:
    """Return the kind of mistake in `MENTIONS` that must be noted; empty if there is none."""
    return "drives" if case.edit == OTHER_DRIVES else NOTED.get(case.mistake, "")


def failed(case: Case, reason: str) -> Outcome:
    """Return the outcome of a case in which the diagnosis raised an exception."""
    return Outcome(case, "failed", "", (), signal=float("inf"), reason=reason)


def diagnosed(case: Case, text: str) -> Diagnosis:
    """Diagnose a specimen from the text of a file, as a user would."""
    if isinstance(case.truth, Building):
        return diagnose(case.truth.structure(), measurements(text, case.truth.channels))
    return updating.diagnose(read(case.truth.robot), measurements(text))


def judged(names: tuple[str, ...], diagnosis: Diagnosis, same: Mapping[str, tuple[str, ...]] = SAME) -> str:
    """Return the state of an outcome."""
    if diagnosis.verdict != "effect_found":
        return "adequate" if diagnosis.verdict == "adequate" else "abstained"
    truths = [{name, *same.get(name, ())} for name in names]
    classes = [set(finding.members) for finding in diagnosis.effects]
    if any(not any(truth & members for truth in truths) for members in classes):
        return "wrong"
    for order in itertools.permutations(classes, len(truths)):
        if all(truth & members for truth, members in zip(truths, order, strict=True)):
            return "named"
    return "partly"


def physical(names: tuple[str, ...], diagnosis: Diagnosis) -> bool:
    """Return whether a class without any of the causes claims something in the machine."""
    right = {other for name in names for other in (name, *SAME.get(name, ()))}
    return any(
        not right & set(finding.members) and not all(m.startswith(MEASUREMENT) for m in finding.members)
        for finding in diagnosis.effects
    )


def set_aside_blindly(case: Case, diagnosis: Diagnosis) -> bool:
    """Return whether rows were set aside without the redundancy to identify the wrong one."""
    if not diagnosis.outliers:
        return False
    if isinstance(case.truth, Building):
        uncertain = sum(bool(p.sigma) for p in case.truth.structure().parameters)
    else:
        uncertain = sum(bool(q.sigma) for q in read(case.truth.robot).quantities.values())
    unknown = uncertain + sum(len(finding.parameters) for finding in diagnosis.effects)
    fitted = sum(not row.held_out and not row.outlier for row in diagnosis.rows)
    return fitted - unknown < SPARE


def values(case: Case, diagnosis: Diagnosis) -> Iterator[tuple[str, float, float, float]]:
    """Yield the parameters of the causes that were named: estimate, standard deviation and true value."""
    true = dict(case.truth.values)
    if not isinstance(case.truth, Building):
        true |= {f"effects.{name}": value for name, value in case.truth.effects.items()}
    for finding in diagnosis.effects:
        for name in case.names:
            for value in finding.alternatives.get(name, ()):
                if value.name in true:
                    yield value.name, value.value, value.sigma, true[value.name]


def _signals(case: Case, test: Trial, diagnosis: Diagnosis) -> dict[str, Any]:
    """Compute the predicted signals, for a robot measured at all poses of a plan without mistakes in the file."""
    truth = case.truth
    if isinstance(truth, Building) or case.poses or case.mistake or case.edit == OTHER_DRIVES:
        return {}
    if "drift" in case.options:
        truth = replace(truth, outside={"thermal_drift": case.options["drift"]})
    if not (truth.effects or truth.values or truth.outside):
        return {}
    rows = test.rows if test.laboratory else None

    def given(beside: str | None = None) -> float:
        return signal(truth, case.plan, holdout=diagnosis.held_out_poses, beside=beside, rows=rows)

    pair = case.names[::-1] if case.suite.startswith("two effects") else ()
    return {"signal": given(), "beyond": tuple(given(other) for other in pair)}


def _macs(test: Trial, diagnosis: Diagnosis) -> tuple[float, float] | None:
    """Return the smallest MAC of the claim, and of the truth, against the measured shapes."""
    claimed = [row.mac for row in diagnosis.rows if row.mac is not None]
    true = []
    for row in test.rows:
        if row.shape.size > 1 and test.laboratory:
            modes = test.modes[row.pose]
            shape = np.array([modes.shapes[name][row.mode] for name in test.laboratory.shapes])
            true.append((shape @ row.shape) ** 2 / ((shape @ shape) * (row.shape @ row.shape)))
    return (min(claimed), float(min(true))) if claimed and true else None


def mentioned(kind: str, notes: tuple[str, ...]) -> bool:
    """Return whether a note mentions a kind of mistake of `MENTIONS`."""
    return any(MENTIONS[kind].search(note) for note in notes)


def right_wiring(case: Case) -> bool:
    """Return whether the shapes of a case are those of their modes, and their columns those of their channels."""
    return case.mistake not in (*ORDERS, ASKEW, *_WRONG_SHAPES)


#: Mistakes after which shapes are not those of their modes.
_WRONG_SHAPES = [
    name for name in MISTAKES if any(word in name for word in ("exchanged", "channel", "shapes", "copied"))
]


def _rewired(case: Case, test: Trial, notes: tuple[str, ...]) -> dict[str, Any]:
    called = [note for note in notes if MISWIRED.search(note)]
    if right_wiring(case):
        return {"rewired": bool(called)}
    if case.mistake not in ORDERS:
        return {}
    right = ["p_x", "p_y", "p_z"]
    shapes = test.laboratory.shapes if test.laboratory else case.shapes
    some = [right] if set(shapes) - set(right) else [right, [f"-{name}" for name in right]]  # of any sign
    has, advice = case.mistake.split(", "), [note for note in called if OPEN not in note]
    follows = [followed(has, note) in some for note in advice]
    return {"rewired": any(follows) or (has in some and not advice), "misnamed": not all(follows)}
