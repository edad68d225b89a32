"""What the figures of measured modes draw, read back from the drawing, and what their captions say, by hand."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from matplotlib.collections import LineCollection, PathCollection, QuadMesh
from matplotlib.colors import to_hex, to_rgba

from helpers.pages.report_examples import made_up
from pkmodes.loop.diagnosis.match.predicted import PartnerPredictions
from pkmodes.loop.diagnosis.verdict.findings import Corrected, Examined, Unseen
from pkmodes.pages.plots import differences, scores
from pkmodes.pages.plots.evidence import ModelStage, PlottedEvidence
from pkmodes.pages.plots.mac_matrices import mac_matrices
from pkmodes.pages.plots.setup_frequencies import setup_frequencies
from pkmodes.pages.plots.style import BLUE, GREEN, GREY
from pkmodes.pages.report import explanations, figures, numbers
from pkmodes.pages.report.blocks import Picture
from pkmodes.pages.report.report_context import ReportContext

NAN = np.nan
MACS = np.array([[0.9, 0.2, 0.1], [0.3, 0.8, 0.15], [NAN] * 3, [0.7, 0.4, 0.06], [0.12, 0.22, 0.6]])
PAIRS = np.array([0.9, 0.8, NAN, 0.7, 0.6])
#: Modes 1 and 2 at A, mode 2 set aside and a third row unmatched; modes 1 and 3 at B, which is held out.
BEFORE = PartnerPredictions(
    frequency=np.array([102.0, 210.0, NAN, 98.0, 206.0]),
    partner_mode=np.array([1, 2, 0, 1, 3]),
    normalised_differences=np.array([2.0, 5.0, NAN, -2.5, 1.5]),
    partner_mac=PAIRS,
    fitted_mac=PAIRS,
    mac_by_mode=MACS,
    elastic_frequencies=np.array([[102.0, 210.0, 400.0], [98.0, 190.0, 206.0]]),
    nearest_frequency=np.full(5, NAN),
    nearest_mac=np.full(5, NAN),
)
AFTER = replace(
    BEFORE,
    frequency=np.array([100.5, 201.0, NAN, 99.5, 199.0]),
    normalised_differences=np.array([0.5, 0.25, NAN, -0.5, -0.75]),
    elastic_frequencies=np.array([[100.5, 201.0, 390.0], [99.5, 185.0, 199.0]]),
)
EVIDENCE = PlottedEvidence(
    labels=("A", "B"),
    setup_indices=np.array([0, 0, 0, 1, 1]),
    measured=np.array([100.0, 200.0, 300.0, 100.0, 200.0]),
    sigma=np.ones(5),
    held_out=np.array([False, False, False, True, True]),
    outlier=np.array([False, True, False, False, False]),
    stages=(ModelStage("before", "as declared", BEFORE), ModelStage("after", "with the cause", AFTER)),
    poses=np.array([[0.1, 0.0, -0.2], [0.3, 0.0, -0.2]]),
    components=("x", "y", "z"),
    units=("m", "m", "m"),
    setup_noun="pose",
)


def marks(axes: Any) -> dict[str, list[tuple[float, float]]]:
    """Places of the marks by their name in the legend, to nine digits."""
    return {
        str(one.get_label()): [tuple(np.round(place, 9)) for place in np.asarray(one.get_offsets())]
        for one in axes.collections
        if isinstance(one, PathCollection)
    }


def segments(axes: Any, label: str | None = None) -> list[tuple[float, float, float]]:
    """Left end, right end and height of horizontal lines."""
    return sorted(
        (round(float(a[0]), 9), round(float(b[0]), 9), round(float(a[1]), 9))
        for one in axes.collections
        if isinstance(one, LineCollection) and (label is None or one.get_label() == label)
        for a, b in one.get_segments()
    )


def titles(figure: Any) -> list[str]:
    return [axes.get_title(loc="left") for axes in figure.axes]


def test_the_frequencies_of_setups_have_the_lines_of_each_stage_and_a_mark_for_each_row() -> None:
    (axes,) = setup_frequencies(EVIDENCE).figure.axes
    # Up to 1.12 of the highest measured frequency.
    for label, colour, rows in (
        ("model as declared", GREY, ((0, 102.0), (0, 210.0), (1, 98.0), (1, 190.0), (1, 206.0))),
        ("model with the cause", GREEN, ((0, 100.5), (0, 201.0), (1, 99.5), (1, 185.0), (1, 199.0))),
    ):
        assert segments(axes, label) == [(round(at - 0.36, 9), round(at + 0.36, 9), f) for at, f in rows]
        (lines,) = (one for one in axes.collections if one.get_label() == label)
        assert {to_hex(one) for one in lines.get_color()} == {colour}
    assert marks(axes) == {
        "fitted": [(0.0, 100.0)],
        "set aside": [(0.0, 200.0)],
        "held out": [(1.0, 100.0), (1.0, 200.0)],
        "unmatched": [(0.0, 300.0)],
    }
    assert [label.get_text() for label in axes.get_xticklabels()] == ["A", "B"]
    assert axes.get_ylim() == pytest.approx((0.0, 336.0))


def test_bands_are_one_standard_deviation_on_either_side_of_the_declared_model() -> None:
    """The declared model has 102, 210 Hz and 98, 190, 206 Hz; one mode of setup A has no standard deviation."""
    spread = np.array([[2.0, np.nan, np.nan], [1.0, 3.0, 0.5]])
    (axes,) = setup_frequencies(replace(EVIDENCE, frequency_sigma=spread)).figure.axes
    (bands,) = (one for one in axes.collections if one.get_label() == "\u00b1 \u03c3 as declared")
    boxes = sorted(
        tuple(path.vertices[:4].min(axis=0)) + tuple(path.vertices[:4].max(axis=0))
        for path in bands.get_paths()
    )
    expected = [(0, 102.0, 2.0), (1, 98.0, 1.0), (1, 190.0, 3.0), (1, 206.0, 0.5)]
    assert boxes == [pytest.approx((at - 0.36, f - s, at + 0.36, f + s)) for at, f, s in expected]
    *_, by_frequency = figures.mode_figures(replace(EVIDENCE, frequency_sigma=spread))
    assert "one standard deviation on either side of the model as declared" in by_frequency.caption
    *_, without = figures.mode_figures(EVIDENCE)
    assert without.caption.startswith("Frequencies at each pose")
    assert "standard deviation on" not in without.caption


def test_a_comparison_has_one_kind_of_lines() -> None:
    (axes,) = setup_frequencies(replace(EVIDENCE, stages=EVIDENCE.stages[:1])).figure.axes
    assert len(segments(axes, "model as declared")) == 5
    assert "measured mode" in marks(axes)


def test_differences_by_mode_are_model_over_measurement_in_per_cent_with_medians() -> None:
    figure = differences.by_mode(EVIDENCE).figure
    assert titles(figure) == ["Model as declared", "Model with the cause"]
    # Setup A stands left of the mode's number, setup B right of it.
    for axes, fitted, aside, held, medians in (
        (figure.axes[0], 2.0, 5.0, (-2.0, 3.0), (0.0, 3.0)),
        (figure.axes[1], 0.5, 0.5, (-0.5, -0.5), (0.0, -0.5)),
    ):
        assert marks(axes) == {
            "fitted": [(0.85, fitted)],
            "set aside": [(1.85, aside)],
            "held out": [(1.15, held[0]), (3.15, held[1])],
        }
        # No line for mode 2, whose only row was set aside.
        assert segments(axes) == [(0.66, 1.34, medians[0]), (2.66, 3.34, medians[1])]
    assert [label.get_text() for label in figure.axes[1].get_xticklabels()] == [
        *("1\n100 Hz", "2\n200 Hz", "3\n200 Hz")
    ]


def test_differences_by_setup_and_against_the_pose_are_in_standard_deviations() -> None:
    drawn = differences.against_pose(EVIDENCE)
    assert drawn is not None
    by_setup, against = differences.by_setup(EVIDENCE).figure, drawn.figure
    assert titles(against) == titles(by_setup) == ["Model as declared", "Model with the cause"]
    for figure, first, second in ((by_setup, 0.0, 1.0), (against, 0.1, 0.3)):
        for axes, sigmas in zip(
            figure.axes, (BEFORE.normalised_differences, AFTER.normalised_differences), strict=True
        ):
            assert marks(axes) == {
                "fitted": [(first, sigmas[0])],
                "set aside": [(first, sigmas[1])],
                "held out": [(second, sigmas[3]), (second, sigmas[4])],
            }
            (band,) = axes.patches
            assert (band.get_y(), band.get_height()) == (-2.0, 4.0)
            low, high = axes.get_ylim()
            assert low < np.nanmin(sigmas)
            assert high > np.nanmax(sigmas)
    assert against.axes[-1].get_xlabel() == "x [m]", "y and z do not vary"
    assert differences.against_pose(replace(EVIDENCE, poses=EVIDENCE.poses[[0, 0]])) is None


def test_mac_matrices_have_the_measured_modes_in_rows_and_the_setup_with_the_lowest_mac_below() -> None:
    drawn = mac_matrices(EVIDENCE)
    assert drawn is not None
    panels = [
        axes for axes in drawn.figure.axes if axes.get_title(loc="left") or "lowest" in axes.get_ylabel()
    ]
    assert panels[0].get_ylabel() == "mean of all poses\nmeasured mode"
    assert panels[2].get_ylabel() == "lowest MAC: B\nmeasured mode"
    mean = np.array([[0.8, 0.3, 0.08], [0.3, 0.8, 0.15], [0.12, 0.22, 0.6]])
    worst = np.array([[0.7, 0.4, 0.06], [NAN] * 3, [0.12, 0.22, 0.6]])
    for axes, expected in ((panels[0], mean), (panels[2], worst)):
        (mesh,) = (one for one in axes.collections if isinstance(one, QuadMesh))
        np.testing.assert_allclose(np.ma.filled(mesh.get_array().astype(float), NAN), expected)
        assert mesh.get_clim() == (0.0, 1.0)
        assert axes.yaxis_inverted(), "mode 1 is at the top"
        written = {one.get_position(): one.get_text() for one in axes.texts}
        there = np.argwhere(np.isfinite(expected))
        assert written == {(k + 1, i + 1): f"{expected[i, k]:.2f}" for i, k in there}


def test_captions_say_the_errors_of_each_stage() -> None:
    by_mode, by_setup, by_frequency = figures.mode_figures(EVIDENCE)
    assert "1 measured mode without a partner in the model." in by_frequency.caption
    # Without the row set aside, 2, -2 and 3 %: rms sqrt(17 / 3).
    assert "as declared: rms 2.4 %; with the cause: rms 0.5 %" in by_mode.svg
    said = "largest as declared: 5 standard deviations; largest with the cause: 0.75 standard deviations"
    assert said in by_setup.svg
    (poses,) = figures.pose_figures(EVIDENCE)
    assert said in poses.svg
    assert poses.caption.startswith("Differences against x.")
    (macs,) = figures.shape_figures(EVIDENCE)
    assert "The lowest of a pair is 0.600, at pose B." in macs.svg
    assert macs.caption.endswith("the pose with the lowest MAC of a pair, 0.600.")


def test_stages_are_named_as_they_are() -> None:
    result, data = made_up(3, 2)
    assert result.stages is not None
    found = PlottedEvidence.of(result, data)
    assert [(stage.key, stage.title) for stage in found.stages] == [
        ("before", "as declared"),
        ("after", "with the cause"),
    ]
    assert found.stages[0].predicted is result.stages.before
    assert found.stages[1].predicted is result.stages.after
    refitted = replace(result, stages=replace(result.stages, after=None))
    assert [stage.title for stage in PlottedEvidence.of(refitted).stages] == ["as declared", "refitted"]
    assert PlottedEvidence.of(refitted).last_stage.predicted is result.stages.refit
    twice = replace(result, effects=result.effects * 2)
    assert PlottedEvidence.of(twice).last_stage.title == "with the causes"


def test_candidates_stand_in_the_order_of_their_scores_with_the_colour_of_their_standing() -> None:
    result, _ = made_up(3, 2)
    tested = tuple(
        Examined(name, p, (), seen)
        for name, p, seen in (
            ("belt_mass", 0.1, True),
            ("payload", 1e-8, True),
            ("link_compliance", 1e-3, False),
            ("servo_stiffness", 1.0, True),
        )
    )
    drawn = scores.candidate_scores(replace(result, candidates=tested, survivors=(("belt_mass + other",),)))
    assert drawn is not None
    (axes,) = drawn.figure.axes
    assert [label.get_text() for label in axes.get_yticklabels()] == [
        *("payload", "link_compliance", "belt_mass", "servo_stiffness")
    ]
    assert axes.yaxis_inverted()
    assert marks(axes) == {
        "claimed, with its class": [(8.0, 0.0)],
        "remains": [(1.0, 2.0)],
        "not claimed": [(0.0, 3.0)],
        "not claimed, not detectable": [(3.0, 1.0)],
    }
    colours = {
        one.get_label(): to_rgba(one.get_edgecolor()[0])
        for one in axes.collections
        if isinstance(one, PathCollection)
    }
    assert colours["claimed, with its class"] == to_rgba(BLUE)
    assert colours["remains"] == to_rgba(GREEN)
    assert colours["not claimed"] == to_rgba(GREY)


def test_a_p_value_that_no_number_holds_is_beyond_the_axis() -> None:
    """Of 0 and of 1e-310, which ends at 300 on the axis of the others, neither says how far."""
    result, _ = made_up(3, 2)
    tested = tuple(
        Examined(name, p, (), True)
        for name, p in (("belt_mass", 0.0), ("payload", 1e-310), ("link_compliance", 1e-20))
    )
    drawn = scores.candidate_scores(replace(result, candidates=tested))
    assert drawn is not None
    (axes,) = drawn.figure.axes
    shown = marks(axes)
    assert [y for _, y in shown.pop("beyond 300")] == [0.0, 1.0]
    assert [place for places in shown.values() for place in places] == [(20.0, 2.0)]
    said = explanations.candidate_blocks(replace(result, candidates=tested))[0]
    assert isinstance(said, Picture)
    assert "The p-values of 2 candidates are too small for a number" in said.caption


def test_the_bars_of_moved_values_are_the_standard_deviations_of_the_table() -> None:
    """0.04 kg of the fit and 0.03 kg of what was not observed are 0.05 kg, as the table and the saved file have."""
    value = Corrected("platform.mass", 1.3, 0.04, "kg", 1.5, 0.1, False, Unseen(0.03, "payload"))
    drawn = scores.shifts_from_prior([value])
    assert drawn is not None
    (bars,) = (one for one in drawn.figure.axes[0].collections if isinstance(one, LineCollection))
    np.testing.assert_allclose(bars.get_segments()[0][:, 0], [-2.5, -1.5], rtol=1e-6)


def test_more_values_than_a_figure_holds_are_said() -> None:
    values = tuple(
        Corrected(f"{name}.mass", 1.3, 0.05, "kg", 1.5, 0.1, False) for name in "abcdefghijklmnopqrst"
    )
    result, _ = made_up(3, 2)
    many = replace(result, corrected=values, correlation=np.eye(20).tolist(), refitted=(), effects=())
    setting = ReportContext("s", None, None, (), None)
    assert "(the 16 that moved most of 20)" in numbers.pull_pictures(many, setting)[0].caption
    assert "(the first 16 of 20)" in numbers.correlation_pictures(many)[0].caption


def test_values_stand_where_the_fit_moved_them_in_standard_deviations_of_their_prior() -> None:
    """1.5 kg within 0.1 kg became 1.3 kg within 0.05 kg; a value without a prior has no place."""
    values = (
        Corrected("link.length", 0.401, 0.0005, "m", 0.4, 0.001, False),
        Corrected("platform.mass", 1.3, 0.05, "kg", 1.5, 0.1, False),
        Corrected("effects.payload.mass", 0.3, 0.01, "kg", 0.0, None, False),
    )
    drawn = scores.shifts_from_prior(values)
    assert drawn is not None
    (axes,) = drawn.figure.axes
    assert [label.get_text() for label in axes.get_yticklabels()] == ["platform.mass", "link.length"]
    (points,) = (line for line in axes.lines if line.get_marker() == "o")
    np.testing.assert_allclose(points.get_xydata(), [[-2.0, 0.0], [1.0, 1.0]])
    (bars,) = (one for one in axes.collections if isinstance(one, LineCollection))
    np.testing.assert_allclose(
        [segment[:, 0] for segment in bars.get_segments()], [[-2.5, -1.5], [0.5, 1.5]], rtol=1e-6
    )
    assert scores.shifts_from_prior(values[2:]) is None
