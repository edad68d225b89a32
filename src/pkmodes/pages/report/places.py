"""Where a cause is: a picture of the machine in which the bodies of terms are marked."""

from __future__ import annotations

import re
from collections.abc import Sequence

import numpy as np

from pkmodes.core.model import Model
from pkmodes.core.robot.robot import Robot
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.pages.plots.evidence import PlottedEvidence
from pkmodes.pages.plots.places import MARK_COLOURS, MarkedBody, marked_machine
from pkmodes.pages.report.blocks import Block, Picture
from pkmodes.pages.report.contrast import contrast_of_parts
from pkmodes.pages.report.formatting import clean, plural
from pkmodes.pages.report.report_context import ReportContext
from pkmodes.pages.view import scene
from pkmodes_description import Element

#: Maximum number of places that are marked: each has a colour of its own.
MAX_MARKED = len(MARK_COLOURS)
#: Prefix of a declared value as a candidate.
VALUE_PREFIX = "parameter:"
#: Directions that an arrow can show.
ARROW_DIRECTIONS = ("x", "y", "z")


def named_terms(result: Diagnosis, context: ReportContext) -> list[tuple[str, str]]:
    """Return the terms that remain, and the parts that claimed causes single out, with their words."""
    joints = [effect.alone.joint for effect in result.effects if effect.alone is not None]
    parts = [
        (part.term, part.part)
        for effect in result.effects
        if (part := contrast_of_parts(effect, context)) is not None
    ]
    values = [
        (name, _value_in_words(name, context))
        for effect in result.effects
        for name in effect.members
        if name.startswith(VALUE_PREFIX)
    ]
    term_classes = () if result.beyond is None else result.beyond.classes
    members = [
        (
            name,
            _value_in_words(name, context)
            if name.startswith(VALUE_PREFIX)
            else term_class.finding.member(name).words,
        )
        for term_class in term_classes
        for name in term_class.forms
    ]
    return [*((joint.term, joint.words) for joint in joints), *parts, *values, *members]


def _value_in_words(name: str, context: ReportContext) -> str:
    """Return the words of a declared value; its path where the robot does not describe it."""
    path = name.removeprefix(VALUE_PREFIX)
    return context.meaning(path) or clean(path)


def marked_elements(result: Diagnosis, robot: Robot) -> frozenset[int]:
    """Return the elements of a machine's drawing that show these places."""
    context = ReportContext("", robot, None, (), None)
    return frozenset(i for mark in _marked_places(result, context)[:MAX_MARKED] for i in mark.elements)


def _marked_places(result: Diagnosis, context: ReportContext) -> list[MarkedBody]:
    """Return the marked elements of all places that the drawing of the machine shows, each place once."""
    if context.robot is None:
        return []
    elements, marks = context.robot.mechanism.drawing.elements, dict[tuple[object, ...], MarkedBody]()
    for name, words in named_terms(result, context):
        if (marked := mark_term(name, words, elements)) is not None:
            marks.setdefault((marked.elements, marked.axis), marked)
    return [*marks.values()]


def place_pictures(result: Diagnosis, evidence: PlottedEvidence, context: ReportContext) -> list[Block]:
    """Return a picture of the machine with these places in colour; empty if it shows none of them."""
    if context.robot is None:
        return []
    marks, model = _marked_places(result, context), Model(context.robot)
    points = evidence.poses
    if not points.shape[1] and context.data is not None:  # all measured at 0
        points = np.zeros((len(evidence.labels), len(context.robot.mechanism.pose)))
    if not marks or not points.shape[1]:
        return []
    marks, omitted = marks[:MAX_MARKED], max(len(marks) - MAX_MARKED, 0)
    omitted_note = (
        f" {plural(omitted, 'further place')} {'is' if omitted == 1 else 'are'} not marked."
        if omitted
        else ""
    )
    valid = np.flatnonzero(model.check(points).valid)
    if not len(valid):
        return []
    middle = points[valid].mean(axis=0)
    pose_index = valid[np.linalg.norm(points[valid] - middle, axis=1).argmin()]
    words = "; ".join(mark.name for mark in marks)
    title = "Where it is"
    has_direction = any(mark.axis for mark in marks)
    arrow_note = " An arrow shows the direction in which something acts." if has_direction else ""
    machine_text = f"the machine at {evidence.setup_noun} {clean(evidence.labels[pose_index])}"
    return [
        Picture.from_drawing(
            marked_machine(scene(model, points[pose_index]), marks),
            title,
            f"{machine_text}, with these bodies in colour: {words}.{omitted_note}",
            f"{title}: {machine_text}.{arrow_note}{omitted_note}",
        )
    ]


def mark_term(term: str, words: str, elements: Sequence[Element]) -> MarkedBody | None:
    """Return the marked elements that show a term.

    - term: as in results: "spring:pulley_2_1/pulley_2_2", "parameter:axis.3.leg.stiffness", "compliance:eps_2"
    - words: its noun phrase
    - elements: of the mechanism's drawing

    Returns None where no element shows a body of it.
    """
    form, _, location = term.partition(":")
    if not location:  # a cause of the catalogue
        return None
    if form in ("parameter", "compliance"):  # of the table or joint of one axis, or else all of that axis
        axis_numbers, tables = re.findall(r"(?<![a-z])\d+", location), re.findall(r"[a-z]+", location)
        if not axis_numbers:
            return None
        axis_number = axis_numbers[0]
        matchers = (
            lambda e: e.place and e.place.startswith(tuple(f"{table}_{axis_number}" for table in tables)),
            lambda e: e.kind in tables and e.name.endswith(f" {axis_number}"),
            lambda e: " ".join(e.name.split()[-2:]) in words,
            lambda e: axis_number in re.findall(r"\d+", e.place)[:1],
        )
        for matches in matchers:
            if indices := tuple(i for i, element in enumerate(elements) if matches(element)):
                return MarkedBody(words, indices)
        return None
    ends, _, direction = location.partition(".")
    names = ends.split("/")
    indices = tuple(i for i, element in enumerate(elements) if element.place in names)
    if {elements[i].place for i in indices} != {*names}:
        return None
    return MarkedBody(words, indices, direction if direction in ARROW_DIRECTIONS else "")
