"""A picture of the machine marks the bodies of what was found, on every mechanism."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import pkmodes
from helpers.pages.documentation import ROOT
from helpers.pages.report_examples import made_up
from pkmodes.core.mechanism.registry import mechanism
from pkmodes.loop.diagnosis.problem import Joint
from pkmodes.loop.diagnosis.verdict.findings import Finding
from pkmodes.loop.diagnosis.verdict.joints import JointAlone
from pkmodes.pages.plots.evidence import PlottedEvidence
from pkmodes.pages.plots.places import MARK_COLOURS, MarkedBody, marked_machine
from pkmodes.pages.report.blocks import Picture
from pkmodes.pages.report.places import mark_term, marked_elements, place_pictures
from pkmodes.pages.report.report_context import ReportContext
from pkmodes.pages.view import scene
from pkmodes.pages.view.poses import typical_pose

#: Terms of each mechanism, and the names of the elements that show them; None where none does.
SHOWN = {
    "linear_delta": {
        "mass:platform": {"platform"},
        "mass:link_2": {"rod of linkage 2"},
        "mount:carriage_2.y": {"carriage 2"},
        "spring:pulley_2_1/pulley_2_2": {"pulley 1 of axis 2", "pulley 2 of axis 2"},
        "compliance:eps_3": {"belt 3"},
        "parameter:axis.2.pulley.radius": {"pulley 1 of axis 2", "pulley 2 of axis 2"},
        "parameter:axis.1.belt.width": {"belt 1"},
        "payload": None,
        "spring:frame.x": None,
    },
    "hexaglide": {"mass:link_6": {"rod 6"}, "resonator:carriage_4": {"carriage 4"}},
    "rotary_delta": {
        "mass:arm_3": {"arm 3"},
        "mass:motor_1": {"motor 1"},
        "mass:link_3": {"rod of linkage 3"},
    },
    "hexapod": {
        "mount:leg_5.y": {"base part of leg 5"},
        "mass:rod_3": {"rod of leg 3"},
        "parameter:axis.4.leg.stiffness": {"base part of leg 4"},
        "mass:motor_2": None,
        "spring:platform.rx": {"platform"},
    },
    "corexy": {
        "mass:gantry": {"gantry"},
        "mount:pulley_2": {"motor pulley 2"},
        "mass:platform": {"tool head"},
    },
    "cartesian": {"mass:beam": {"beam"}, "mass:pulley_1": {"motor pulley 1"}},
    "bed_slinger": {"mass:bed": {"bed"}, "resonator:toolhead": {"tool head"}},
}
EACH = [(name, term) for name, terms in SHOWN.items() for term in terms]


@pytest.mark.parametrize(("name", "term"), EACH)
def test_a_term_is_shown_by_its_bodies(name: str, term: str) -> None:
    elements = mechanism(name).drawing.elements
    sentences = {one.name: one.sentence for one in mechanism(name).terms}
    mark = mark_term(
        term, sentences.get(term, "displacement of the clamp of belt 3 relative to the body"), elements
    )
    shown = SHOWN[name][term]
    assert (None if mark is None else {elements[i].name for i in mark.elements}) == shown
    if mark is not None:
        assert mark.axis == (term[-1] if term.endswith((".x", ".y", ".z")) else "")


def test_the_picture_has_the_marked_bodies_in_colour_and_an_arrow() -> None:
    model = pkmodes.load(ROOT / "robots" / "linear-delta-2022.toml")
    shown = scene(model, [0.6, 0.0, -0.245])
    (carriage,) = (i for i, element in enumerate(shown.elements) if element.name == "carriage 2")
    drawing = marked_machine(
        shown, [MarkedBody("the rail of carriage 2", (carriage,), "y"), MarkedBody("the platform", (0,))]
    )
    (panel,) = drawing.wide.panels
    colours = [line.get_color() for line in panel.axes.lines]
    assert colours.count(MARK_COLOURS[0]) == 2  # the carriage, and its entry of the legend
    legend = panel.axes.get_legend()
    assert legend is not None
    assert [text.get_text() for text in legend.get_texts()] == ["the rail of carriage 2", "the platform"]
    arrow, letter = panel.axes.texts
    assert letter.get_text() == "y"
    # Parallel to y as the camera sees it: the marked block lies in the middle of the arrow.
    (block,) = (
        line for line in panel.axes.lines if line.get_color() == MARK_COLOURS[0] and len(line.get_xdata())
    )
    middle = np.mean(block.get_xydata(), axis=0)
    ends = np.array([arrow.xy, arrow.get_position()])  # type: ignore[attr-defined]
    np.testing.assert_allclose(ends.mean(axis=0), middle, atol=0.2 * np.ptp(ends, axis=0).max())


@pytest.mark.parametrize(("count", "others"), [(6, ""), (8, " 2 further places are not marked.")])
def test_every_leg_of_a_hexapod_is_marked_and_what_is_not_is_counted(count: int, others: str) -> None:
    robot = pkmodes.read_robot(ROOT / "robots" / "hexapod.toml")
    model = pkmodes.Model(robot)
    result, data = made_up(4, 3)
    names = [f"leg {k}" for k in range(1, 7)] + ["the platform", "the rod of leg 1"]
    terms = [*(f"parameter:axis.{k}.leg.stiffness" for k in range(1, 7)), "mass:platform", "mass:rod_1"]
    joints = [Joint(term, words, "stiffness", term) for term, words in zip(terms, names, strict=True)]
    effects = tuple(
        Finding(
            joint.term, (joint.term,), (), {joint.term: ()}, 1e-9, "", alone=JointAlone(joint, -0.2, 0.01, 5)
        )
        for joint in joints[:count]
    )
    found = replace(result, effects=effects)
    evidence = replace(PlottedEvidence.of(result, data), poses=np.tile(typical_pose(model), (4, 1)))
    (drawn,) = place_pictures(found, evidence, ReportContext("hexapod", robot, data, (), None))
    assert isinstance(drawn, Picture)
    assert f"in colour: {'; '.join(names[:6])}.{others}" in drawn.svg
    assert drawn.caption.endswith(f".{others}")
    assert "arrow" not in drawn.caption  # no leg acts along an axis
    legs = {
        element.name for element in robot.mechanism.drawing.elements if element.name.startswith("base part")
    }
    shown = {robot.mechanism.drawing.elements[i].name for i in marked_elements(found, robot)}
    assert len(legs) == 6
    assert legs <= shown
