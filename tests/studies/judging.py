"""Run the cases and judge their outcomes."""

from __future__ import annotations

import itertools
import re
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from pkmodes import updating
from pkmodes.loop.diagnosis import diagnose
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes_rig import ASKEW, MISTAKES, ORDERS, Laboratory, followed
from studies.buildings import Building
from studies.cases import Case, Trial, tried
from studies.motors import OTHER_DRIVES
from studies.running import Outcome
from studies.specimens import measurements, robot_of
from studies.strengths import signal

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


def _inertias(prefix: str, *more: str) -> tuple[str, ...]:
    return tuple(f"parameter:{prefix}{name}" for name in ("motor.inertia", "motor.gear_ratio", *more))


def _equivalent(*groups: tuple[str, ...]) -> dict[str, tuple[str, ...]]:
    return {name: group for group in groups for name in group}


#: The same for the other machines.
EQUIVALENT = {
    # Only inertia * gear_ratio^2 at phi_j enters the modes.
    "rotary_delta": _equivalent(("gearbox_inertia", *_inertias("")), _inertias("axis.2.")),
    # Only inertia / travel^2 at s_j enters the modes.
    "hexapod": _equivalent(
        ("gearbox_inertia", *(f"parameter:motor.{name}" for name in ("inertia", "travel")))
    ),
    # With rigid shafts, the modes depend only on (inertias at theta_i) / radius^2: theta_i is not measured here.
    # Another belt width changes the stiffness of each belt; and because the common stiffness is uncertain,
    # another width of one belt is equivalent to unequal stiffness of the two.
    "corexy": _equivalent(
        ("gearbox_inertia", *_inertias("", "pulley.inertia", "pulley.radius")),
        _inertias("belt_path.2.", "pulley.inertia", "pulley.radius"),
    )
    | {
        "parameter:belt.width": ("axis_belt_stiffness",),
        "axis_belt_stiffness": tuple(f"parameter:belt_path.{i}.belt.width" for i in (1, 2)),
    },
}


def same_of(machine: str) -> Mapping[str, tuple[str, ...]]:
    """Return the candidates equivalent to the truth, for one of `specimens.MACHINES`."""
    return EQUIVALENT.get(machine, SAME)


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
class CaseOutcome(Outcome[Case]):
    """Outcome of a case; ``wrong`` are also rows of a faulty case that were set aside without redundancy.

    Attributes
    ----------
    renamed : bool
        Whether a class counts as right only by `SAME`.
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

    renamed: bool = False
    beyond: tuple[float, ...] = ()
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


def run(case: Case) -> CaseOutcome:
    """Measure, diagnose and judge a case."""
    test = tried(case)
    diagnosis, fields = diagnosed(case.names, case.truth.sizes, lambda: _diagnosis(case, test.text))
    faulty = bool(case.edit or case.names or case.truth.outside)
    if diagnosis.verdict in ("adequate", "effect_found") and faulty and set_aside_blindly(case, diagnosis):
        fields["state"] = "wrong"
    notes = tuple(diagnosis.notes)
    return CaseOutcome(
        case=case,
        **fields,
        renamed=judged(case.names, diagnosis) != judged(case.names, diagnosis, same={}),
        **_signals(case, test, diagnosis),
        scatter=diagnosis.scatter,
        outliers=len(diagnosis.outliers),
        rows=len(diagnosis.rows),
        poses=len({row.pose for row in diagnosis.rows}),
        physical=fields["state"] == "wrong" and physical(case.names, diagnosis),
        mac=_macs(test, diagnosis) if diagnosis.effects else None,
        noted=mentioned(kind, notes) if (kind := noticeable(case)) else None,
        **_rewired(case, test, notes),
        notes=notes,
        laboratory=test.laboratory,
    )


def diagnosed(
    names: tuple[str, ...],
    sizes: Mapping[str, float],
    made: Callable[[], Diagnosis],
    same: Mapping[str, tuple[str, ...]] = SAME,
) -> tuple[Diagnosis, dict[str, Any]]:
    """Diagnose a specimen, and return what outcomes of all suites say of it.

    Parameters
    ----------
    names : tuple of str
        Candidates that should be named.
    sizes : mapping of str to float
        True values by parameter, see `Specimen.sizes`.
    made : callable
        Returns the diagnosis.
    same : mapping
        Equivalent candidates.
    """
    start = time.perf_counter()
    diagnosis = made()
    seconds = time.perf_counter() - start
    return diagnosis, {
        "state": judged(names, diagnosis, same),
        "verdict": diagnosis.verdict,
        "classes": tuple(f.members for f in diagnosis.effects) or diagnosis.survivors,
        "values": tuple(
            (value.name, value.value, value.sigma, sizes[value.name])
            for finding in diagnosis.effects
            for name in names
            for value in finding.alternatives.get(name, ())
            if value.name in sizes
        ),
        "seconds": seconds,
        "reason": diagnosis.reason,
        "rule": diagnosis.rule,
        "probabilities": diagnosis.probabilities,
        "candidates": tuple(one.name for one in diagnosis.candidates),
    }


def _diagnosis(case: Case, text: str) -> Diagnosis:
    """Diagnose a specimen from the text of a file, as a user would."""
    if isinstance(case.truth, Building):
        return diagnose(case.truth.structure(), measurements(text, case.truth.channels))
    return updating.diagnose(robot_of(case.truth.machine), measurements(text), terms=False)


def noticeable(case: Case) -> str:
    """Return the kind of mistake in `MENTIONS` that must be noted; empty if there is none."""
    return "drives" if case.edit == OTHER_DRIVES else NOTED.get(case.mistake, "")


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
        uncertain = sum(bool(q.sigma) for q in robot_of(case.truth.machine).quantities.values())
    unknown = uncertain + sum(len(finding.parameters) for finding in diagnosis.effects)
    fitted = sum(not row.held_out and not row.outlier for row in diagnosis.rows)
    return fitted - unknown < SPARE


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
        return signal(truth, case.points, holdout=diagnosis.held_out_poses, beside=beside, rows=rows)

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
