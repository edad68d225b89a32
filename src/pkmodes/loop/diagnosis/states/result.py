"""What changed between states: a diagnosis of the difference, with the states and whether anything changed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from typing import Any

import numpy as np
from msgspec import structs

from pkmodes.loop.diagnosis.match.predicted import PartnerPredictions
from pkmodes.loop.diagnosis.problem import Array
from pkmodes.loop.diagnosis.states.shared_errors import SharedErrors
from pkmodes.loop.diagnosis.states.words import reword_result
from pkmodes.loop.diagnosis.verdict.naming import found_in_words
from pkmodes.loop.diagnosis.verdict.result import Diagnosis, Stages
from pkmodes.loop.diagnosis.verdict.rows import Error, Row
from pkmodes.loop.diagnosis.verdict.verdicts import (
    ADEQUATE,
    AMBIGUOUS,
    EFFECT_FOUND,
    INSUFFICIENT_DATA,
    UNEXPLAINED,
)
from pkmodes.loop.measured.measurements import Measurements

#: Rules whose verdicts leave open whether anything changed: the residual may be due to errors of the measurement.
INCONCLUSIVE_RULES = (
    "before.",
    "after.",
    "adequacy.",
    "claims.errors",
    "claims.not_significant",
    "claims.one_row",
    "open.small",
    "open.no_direction",
)
#: Precedence of verdicts: that of several states together is the first of these that any of them has.
VERDICT_PRECEDENCE = (UNEXPLAINED, AMBIGUOUS, INSUFFICIENT_DATA, EFFECT_FOUND, ADEQUATE)


@dataclass(frozen=True)
class Counterpart:
    """The same mode at the same setup in the trusted state.

    - line: line of the row in its file
    - measured, sigma: frequency and its standard deviation [Hz]
    """

    line: int
    measured: float
    sigma: float


@dataclass(frozen=True)
class Change(Diagnosis):
    """What changed from a trusted state of a machine to another one, or to several.

    The attributes are those of a `Diagnosis` of the difference.  In its rows the standard deviations are those of
    the difference, and what the model predicts has the errors that the trusted state shows.

    - states: the trusted state first
    - changed: whether anything changed; None where the data do not tell
    - counterparts: counterpart of each row
    - model_error: root mean square of the relative error of the model in the trusted state, which both states share
    - by_state: changes of several later states, each by itself; empty for a single one
    """

    states: tuple[str, ...] = ()
    changed: bool | None = None
    counterparts: tuple[Counterpart | None, ...] = ()
    model_error: float = 0.0
    by_state: Mapping[str, Change] = field(default_factory=dict)

    @property
    def explained(self) -> bool:
        """Whether something is claimed to have changed, of the catalogue or at one place."""
        return bool(self.effects) or (self.beyond is not None and self.beyond.found is not None)

    @property
    def claimed(self) -> set[str]:
        """The names of everything in the classes of what is claimed."""
        beyond = [] if self.beyond is None or self.beyond.found is None else [self.beyond.found.finding]
        return {name for finding in (*self.effects, *beyond) for name in finding.members}

    @property
    def what(self) -> str:
        """What changed, as a clause: "change found: ...", or that nothing did, or that the data do not tell."""
        if self.effects:
            return f"change {found_in_words(self.effects)}"
        if self.beyond is not None and self.beyond.found is not None:
            return f"change {found_in_words([self.beyond.found.finding])}"
        if self.changed is None:
            return "the data do not tell whether anything changed"
        if self.changed is False:
            return "nothing changed beyond the errors of both"
        return "something changed, and the data do not tell what"

    @property
    def errors(self) -> dict[str, tuple[str, Error]]:
        """For each stage that was reached, by its key in the JSON: its title and its errors."""
        trusted = self.states[0]
        titles = {
            "before": f"as in {trusted}",
            "refit": f"as in {trusted}, on another day",
            "after": "with what changed",
        }
        return {key: (titles[key], error) for key, (_, error) in super().errors.items()}

    def as_json(self) -> dict[str, object]:
        """Return the result in the form described in docs/reference/json.md, without NaN.

        Returns what ``pkmodes changed --json`` writes.
        """
        by_state = {name: result._json_of_one_state() for name, result in self.by_state.items()}
        return {**self._json_of_one_state(), "by_state": by_state}

    def _json_of_one_state(self) -> dict[str, object]:
        content: dict[str, Any] = super().as_json()
        for cause, effect in zip(content["effects"], self.effects, strict=True):
            cause["state"] = effect.state
        for terms in (content["beyond"] or {}).get("classes", []):
            for member in terms["members"]:
                member["state"] = self.states[-1]
        for row, counterpart in zip(content["rows"], self.counterparts, strict=True):
            row["trusted_hz"] = None if counterpart is None else counterpart.measured
            row["trusted_line"] = None if counterpart is None else counterpart.line
        first = {name: content.pop(name) for name in ("verdict", "reason")}
        state_keys = {"states": list(self.states), "changed": self.changed, "model_error": self.model_error}
        return {**first, **state_keys, **content}


def change_from_difference(
    result: Diagnosis,
    states: tuple[str, str],
    data: Measurements,
    shared: SharedErrors,
    counterparts: tuple[Counterpart | None, ...],
    model_error: float,
) -> Change:
    """Return the diagnosis of a difference as a change.

    - result: diagnosis of measurements without the errors that the model has in the trusted state
    - states: the trusted state, and the later one
    - data: measurements of the later state, as they were made
    - shared: the errors of the model in the trusted state
    """
    trusted, later = states
    content = {attribute.name: getattr(result, attribute.name) for attribute in fields(Diagnosis)}
    content |= {
        "rows": tuple(
            map(_with_model_errors, result.rows, data.frequency.tolist(), np.exp(shared.offset).tolist())
        ),
        "effects": tuple(replace(effect, state=later) for effect in result.effects),
        "stages": None if result.stages is None else _stages_with_model_errors(result.stages, shared),
    }
    change = Change(
        **content,
        states=states,
        changed=_has_changed(result),
        counterparts=counterparts,
        model_error=model_error,
    )
    return reword_result(change, trusted, later)


def _with_model_errors(row: Row, measured: float, factor: float) -> Row:
    """Return a row with the error that the model has in the trusted state, and the measurement as in its file."""
    scaled = {
        name: None if (value := getattr(row, name)) is None else value * factor
        for name in ("sigma", "before", "refit", "after", "beyond", "nearest")
    }
    return structs.replace(row, measured=measured, **scaled)


def _stages_with_model_errors(stages: Stages, shared: SharedErrors) -> Stages:
    """Return the stages of a model with the errors that it has in the trusted state."""

    def spectrum(frequencies: Array) -> Array:
        errors = np.zeros_like(frequencies)
        count = min(errors.shape[1], shared.mode_offsets.shape[1])
        errors[:, :count] = shared.mode_offsets[:, :count]
        return np.asarray(frequencies * np.exp(errors))

    def stage(predicted: PartnerPredictions | None) -> PartnerPredictions | None:
        if predicted is None:
            return None
        return replace(
            predicted,
            frequency=predicted.frequency * np.exp(shared.offset),
            nearest_frequency=predicted.nearest_frequency * np.exp(shared.offset),
            elastic_frequencies=spectrum(predicted.elastic_frequencies),
        )

    before = stage(stages.before)
    assert before is not None
    without_causes = None if stages.without is None else spectrum(stages.without)
    return Stages(before, stage(stages.refit), stage(stages.after), without_causes, stage(stages.beyond))


def _has_changed(result: Diagnosis) -> bool | None:
    """Return whether anything changed; None if the verdict leaves this open."""
    if result.verdict == ADEQUATE.word:
        return False
    if result.beyond is not None and result.beyond.found is not None:
        return True
    return None if result.rule.startswith(INCONCLUSIVE_RULES) else True


def merge_changes(trusted: str, changes: Mapping[str, Change]) -> Change:
    """Return what changed in several later states, each compared with the trusted one."""
    if len(changes) == 1:
        return next(iter(changes.values()))
    results = list(changes.values())
    verdict = next(
        option.word
        for option in VERDICT_PRECEDENCE
        if any(result.verdict == option.word for result in results)
    )
    answers = {result.changed for result in results}
    changed = next((word for word in (True, None, False) if word in answers), None)
    first_result = results[0]
    content = {attribute.name: getattr(first_result, attribute.name) for attribute in fields(Diagnosis)}
    content |= {
        "verdict": verdict,
        "reason": "; ".join(f"{name}: {change.what}" for name, change in changes.items()),
        "effects": tuple(effect for result in results for effect in result.effects),
        "survivors": tuple(group for result in results for group in result.survivors),
        "rows": tuple(row for result in results for row in result.rows),
        "notes": tuple(f"{name}: {note}" for name, change in changes.items() for note in change.notes),
        "before": _pooled_error([result.before for result in results], results),
        "refit": _pooled_error([result.refit for result in results], results),
        "after": _pooled_error([result.after or result.refit for result in results], results)
        if any(result.after for result in results)
        else None,
        "held_out_poses": tuple(dict.fromkeys(pose for result in results for pose in result.held_out_poses)),
        "undetectable": tuple(
            name
            for name in first_result.undetectable
            if all(name in result.undetectable for result in results)
        ),
        "limits": {},
        "next_measurement": None,
        "not_separated": "each later state has its own, under by_state",
        "beyond": None,
        "probabilities": None,
        "stages": None,
        "headline": "",
        "rule": "",
        "alone": {},
    }
    return Change(
        **content,
        states=(trusted, *list(changes)),
        changed=changed,
        counterparts=tuple(counterpart for result in results for counterpart in result.counterparts),
        model_error=first_result.model_error,
        by_state=dict(changes),
    )


def _pooled_error(errors: Sequence[Error | None], results: Sequence[Change]) -> Error | None:
    """Return the errors of a stage over the rows of all states."""
    errors_and_counts = [
        (error, len(result.rows)) for error, result in zip(errors, results, strict=True) if error is not None
    ]
    if not errors_and_counts:
        return None
    counts = np.array([count for _, count in errors_and_counts], dtype=float)

    def mean(values: Sequence[float | None]) -> float | None:
        is_known = np.array([value is not None for value in values])
        if not is_known.any():
            return None
        squares = np.array([0.0 if value is None else value**2 for value in values])
        return float(np.sqrt((counts[is_known] * squares[is_known]).sum() / counts[is_known].sum()))

    chi2 = float(counts @ np.array([error.chi2_per_dof for error, _ in errors_and_counts]) / counts.sum())
    return Error(
        mean([error.rms_relative for error, _ in errors_and_counts]),
        mean([error.held_out_rms_relative for error, _ in errors_and_counts]),
        chi2,
    )
