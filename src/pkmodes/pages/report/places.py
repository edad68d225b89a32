"""Where it is: a picture of the machine in which the bodies of terms are marked."""

from __future__ import annotations

import re
from collections.abc import Sequence

import numpy as np

from pkmodes.core.model import Model
from pkmodes.core.robot.robot import Robot
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.pages.plots.evidence import PlottedEvidence
from pkmodes.pages.plots.places import COLOURS, Marked, places
from pkmodes.pages.report.blocks import Block, Picture
from pkmodes.pages.report.contrast import contrast
from pkmodes.pages.report.formatting import clean, plural
from pkmodes.pages.report.setting import ReportSetting
from pkmodes.pages.view import scene
from pkmodes_description import Element

#: Most places that are marked: each has a colour of its own.
MOST = len(COLOURS)
#: Prefix of a declared value as a candidate.
VALUE = "parameter:"
#: Directions that an arrow can show.
AXES = ("x", "y", "z")


def named_terms(result: Diagnosis, setting: ReportSetting) -> list[tuple[str, str]]:
    """Return the terms that remain, and the parts that claimed causes single out, with their words."""
    joints = [effect.alone.joint for effect in result.effects if effect.alone is not None]
    parts = [
        (part.term, part.part) for effect in result.effects if (part := contrast(effect, setting)) is not None
    ]
    values = [
        (name, _value(name, setting))
        for effect in result.effects
        for name in effect.members
        if name.startswith(VALUE)
    ]
    groups = () if result.beyond is None else result.beyond.classes
    members = [
        (name, _value(name, setting) if name.startswith(VALUE) else group.finding.member(name).words)
        for group in groups
        for name in group.forms
    ]
    return [*((joint.term, joint.words) for joint in joints), *parts, *values, *members]


def _value(name: str, setting: ReportSetting) -> str:
    """Return the words of a declared value; its path where the robot does not describe it."""
    path = name.removeprefix(VALUE)
    return setting.words(path) or clean(path)


def marked_elements(result: Diagnosis, robot: Robot) -> frozenset[int]:
    """Return the elements of a machine's drawing that show these places."""
    setting = ReportSetting("", robot, None, (), None)
    return frozenset(i for mark in _marks(result, setting)[:MOST] for i in mark.elements)


def _marks(result: Diagnosis, setting: ReportSetting) -> list[Marked]:
    """Return the marked elements of all places that the drawing of the machine shows, each place once."""
    if setting.robot is None:
        return []
    elements, marks = setting.robot.mechanism.drawing.elements, dict[tuple[object, ...], Marked]()
    for name, words in named_terms(result, setting):
        if (mark := marked(name, words, elements)) is not None:
            marks.setdefault((mark.elements, mark.along), mark)
    return [*marks.values()]


def picture(result: Diagnosis, evidence: PlottedEvidence, setting: ReportSetting) -> list[Block]:
    """Return a picture of the machine with these places in colour; empty if it shows none of them."""
    if setting.robot is None:
        return []
    marks, model = _marks(result, setting), Model(setting.robot)
    points = evidence.points
    if not points.shape[1] and setting.data is not None:  # all measured at 0
        points = np.zeros((len(evidence.labels), len(setting.robot.mechanism.pose)))
    if not marks or not points.shape[1]:
        return []
    marks, omitted = marks[:MOST], max(len(marks) - MOST, 0)
    others = (
        f" {plural(omitted, 'further place')} {'is' if omitted == 1 else 'are'} not marked."
        if omitted
        else ""
    )
    valid = np.flatnonzero(model.check(points).valid)
    if not len(valid):
        return []
    middle = points[valid].mean(axis=0)
    chosen = valid[np.linalg.norm(points[valid] - middle, axis=1).argmin()]
    words = "; ".join(mark.name for mark in marks)
    arrow = (
        " An arrow shows the direction in which something acts." if any(mark.along for mark in marks) else ""
    )
    title, at = "Where it is", f"the machine at {evidence.place} {clean(evidence.labels[chosen])}"
    return [
        Picture.of(
            places(scene(model, points[chosen]), marks),
            title,
            f"{at}, with these bodies in colour: {words}.{others}",
            f"{title}: {at}.{arrow}{others}",
        )
    ]


def marked(term: str, words: str, elements: Sequence[Element]) -> Marked | None:
    """Return the marked elements that show a term.

    - term: as in results: "spring:pulley_2_1/pulley_2_2", "parameter:axis.3.leg.stiffness", "compliance:eps_2"
    - words: its noun phrase
    - elements: of the mechanism's drawing

    Returns None where no element shows a body of it.
    """
    form, _, place = term.partition(":")
    if not place:  # a cause of the catalogue
        return None
    if form in ("parameter", "compliance"):  # of the table or joint of one axis, or else all of that axis
        numbers, tables = re.findall(r"(?<![a-z])\d+", place), re.findall(r"[a-z]+", place)
        if not numbers:
            return None
        number = numbers[0]
        tried = (
            lambda e: e.place and e.place.startswith(tuple(f"{table}_{number}" for table in tables)),
            lambda e: e.kind in tables and e.name.endswith(f" {number}"),
            lambda e: " ".join(e.name.split()[-2:]) in words,
            lambda e: number in re.findall(r"\d+", e.place)[:1],
        )
        for shows in tried:
            if indices := tuple(i for i, element in enumerate(elements) if shows(element)):
                return Marked(words, indices)
        return None
    ends, _, along = place.partition(".")
    names = ends.split("/")
    indices = tuple(i for i, element in enumerate(elements) if element.place in names)
    if {elements[i].place for i in indices} != {*names}:
        return None
    return Marked(words, indices, along if along in AXES else "")
