"""Saves a term that a diagnosis found beyond the catalogue: an effect for the derivation, and the robot with it."""

from __future__ import annotations

from pathlib import Path

from pkmodes.core.base.errors import OutputError
from pkmodes.core.model import Model
from pkmodes.core.robot.robot import Robot
from pkmodes.core.support.writing import write_file
from pkmodes.loop.diagnosis.verdict.findings import Corrected
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.loop.diagnosis.verdict.terms import DECLARED, TermClass
from pkmodes.loop.robot_files.editing import sigma_text
from pkmodes.loop.robot_files.saving import Correction, corrected_text
from pkmodes.loop.sensitivity.paths import resolve
from pkmodes.loop.updating import frame
from pkmodes.loop.updating.measured_robot import robot_of

#: Significant digits of an effect's value.
DIGITS = 10
#: Significant digits of the value before, in a comment.
NOTED_DIGITS = 6


def effect_name(term: str) -> str:
    """Return the name of the effect of a term: "spring:pulley_2_1/pulley_2_2" is spring_pulley_2_1_pulley_2_2."""
    for separator in (":", "/", "."):
        term = term.replace(separator, "_")
    return term


def effect_text(result: Diagnosis, where: str = "effect_text") -> str:
    """Return the best member of the class that was found beyond the catalogue, as an effect's Python file.

    - where: for messages

    Raises OutputError if no class was found, or its best member is a declared value or an effect of the catalogue.
    """
    best, term = _best_member(result, where)
    form, _, place = term.partition(":")
    if best.forms[term] == DECLARED:
        problem = f"there is no effect to write: {term} is a value of the robot file"
        raise OutputError(problem, where, "write the robot with that value: --save-robot FILE.toml")
    ends, _, direction = place.partition(".")
    noun = best.finding.member(term).words
    values = ", ".join(
        f"{best.quantity(term, value)} {value.rounded} {value.unit}" for value in best.finding.parameters
    )
    arguments = [*(f'"{end}"' for end in ends.split("/")), *([f'along="{direction}"'] if direction else [])]
    arguments += [f'name="{effect_name(term)}"', f'sentence="there is {noun}"']
    lines = "".join(f"    {argument},\n" for argument in arguments)
    return (
        f'"""{noun[0].upper()}{noun[1:]}.\n\n'
        f"Written by pkmodes diagnose, which found {term}: {values}.\n"
        "Derive a mechanism with it: pkmodes generate ROBOT.toml --effect FILE.py --out DIR\n"
        f'"""\n\nfrom pkmodes_derive.terms import {form}\n\nEFFECT = {form}(\n{lines})\n'
    )


def save_effect(result: Diagnosis, target: str | Path) -> None:
    """Write what was found beyond the catalogue as an effect's Python file.

    Parameters
    ----------
    result : Diagnosis
        That found one class of terms.
    target : path-like
        A Python file; an existing one is replaced.

    Raises
    ------
    OutputError
        As for `effect_text`, or if the file cannot be written.
    """
    write_file(Path(target), effect_text(result, str(target)))


def robot_with_term(robot: Robot | Model, result: Diagnosis) -> str:
    """Return the text of the robot file with what was found beyond the catalogue, and the uncertain values beside it.

    Only a mechanism that was generated with the effect reads such a file.

    Raises OutputError if no class was found.
    """
    declared = robot_of(robot)
    best, term = _best_member(result, declared.source)
    term_values = {value.name for value in best.finding.parameters}
    changes: dict[str, Correction] = {}
    added: list[Corrected] = []
    for value in best.corrected:
        if value.name.startswith(frame.OF_MEASUREMENT):
            continue
        if value.name in term_values and best.forms[term] != DECLARED:
            added.append(value)
            continue
        verb = "found" if value.name in term_values else "refitted"
        note = change_note(value, resolve(declared, value.name).value, verb)
        changes[value.name] = Correction(value.value, value.saved_sigma, note)
    text = corrected_text(Path(declared.source), changes)
    if not added:
        return text
    noun = best.finding.member(term).words
    lines = [f"\n# {noun}, found by pkmodes diagnose\n[effects.{effect_name(term)}]\n"]
    for value in added:
        unit = value.unit.replace("*", " ")
        quantity = f'value = "{value.value:.{DIGITS}g} {unit}", sigma = "{sigma_text(value.sigma)} {unit}"'
        lines.append(f"{best.quantity(term, value)} = {{ {quantity} }}\n")
    return text.rstrip("\n") + "\n" + "".join(lines)


def change_note(value: Corrected, before: float | None, verb: str) -> str:
    """Return the comment on a saved value: what it was, None for a value that is new, and what was done to it."""
    if before is None:
        return f"{verb} by pkmodes diagnose"
    shown_before, shown_after = (f"{number:.{NOTED_DIGITS}g}" for number in (before, value.value))
    if shown_before == shown_after:
        return "unchanged by pkmodes diagnose"
    unit = "" if value.unit == "1" else f" {value.unit}"
    return f"was {shown_before}{unit}: {verb} by pkmodes diagnose"


def term_to_save(result: Diagnosis) -> TermClass | None:
    """Return what was found beyond the catalogue, where the verdict itself leaves nothing to save."""
    return None if result.settled or result.beyond is None else result.beyond.found


def is_declared(terms: TermClass) -> bool:
    """Return whether the best member of a class is a value of the robot file, which needs no effect."""
    return terms.forms[terms.finding.name] == DECLARED


def _best_member(result: Diagnosis, where: str) -> tuple[TermClass, str]:
    """Return the class that was found, and the name of its best member, which is a term."""
    terms = None if result.beyond is None else result.beyond.found
    if terms is None:
        status = "terms were not tried"
        if result.beyond is not None:
            status = f"the search among terms ended with {result.beyond.status}"
        problem = f"there is nothing beyond the catalogue to write: {status}"
        raise OutputError(problem, where, "write it only where the diagnosis found one class of terms")
    name = terms.finding.name
    if not terms.forms[name]:
        problem = f"there is no effect to write: {name} is in the catalogue"
        raise OutputError(problem, where, "add it to the robot file with --candidates and --save-robot")
    return terms, name
