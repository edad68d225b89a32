"""Two measurements compared: which modes are the same, and which changed by more than their errors."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.stats import norm

from pkmodes.cli import run
from pkmodes.core.base.errors import MeasurementError
from pkmodes.loop.measured.compared import compare_measurements
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.measured.significance import SIGNIFICANCE_LEVEL

SHAPES = np.array([[1.0, 0.4, 0.1], [-0.5, 1.0, 0.3], [0.2, -0.3, 1.0]])


def measured(
    frequencies: list[float], shapes: np.ndarray | None = None, pose: str = "A", **more: object
) -> Measurements:
    count = len(frequencies)
    of_shapes = {} if shapes is None else {"shapes": dict(zip("abc", shapes.T, strict=True))}
    return Measurements.from_rows([pose] * count, frequencies, [0.1] * count, **of_shapes, **more)


def test_changes_are_those_of_the_files() -> None:
    found = compare_measurements(measured([50.0, 60.0, 90.0]), measured([50.1, 63.0, 200.0], pose="B"))
    first, second = found.pairs
    assert (first.pose, first.second_pose) == ("A", "B")
    assert first.sigmas == pytest.approx(0.1 / np.hypot(0.1, 0.1))
    assert second.relative == pytest.approx(0.05)
    assert [first.differs, second.differs] == [False, True]
    assert len(found.first_unpaired) == len(found.second_unpaired) == 1
    assert found.chi2 == pytest.approx(first.sigmas**2 + second.sigmas**2)
    assert found.chi2 == pytest.approx(0.1**2 / 0.02 + 3.0**2 / 0.02)
    assert found.median_relative == pytest.approx(np.median([0.002, 0.05]))


def test_modes_that_change_places_are_paired_by_their_shapes() -> None:
    before, after = measured([50.0, 52.0, 90.0], SHAPES), measured([51.5, 53.0, 90.0], SHAPES[[1, 0, 2]])
    found = compare_measurements(before, after)
    assert [pair.second for pair in found.pairs] == [53.0, 51.5, 90.0]
    assert [pair.mac for pair in found.pairs] == pytest.approx([1.0, 1.0, 1.0])
    without = compare_measurements(measured([50.0, 52.0, 90.0]), measured([51.5, 53.0, 90.0]))
    assert [pair.second for pair in without.pairs] == [51.5, 53.0, 90.0]
    assert [pair.mac for pair in without.pairs] == [None, None, None]


def test_shapes_that_are_not_alike_are_no_pair() -> None:
    """A MAC of 0.22, by hand cos^2 of the angle between the shapes: frequencies nearby do not make it one mode."""
    cosine = np.sqrt(0.22)
    shape, unlike = np.array([[1.0, 0.0, 0.0]]), np.array([[cosine, np.sqrt(1.0 - cosine**2), 0.0]])
    found = compare_measurements(measured([50.0], shape), measured([51.0], unlike))
    assert found.pairs == []
    assert (found.changed, len(found.first_unpaired), len(found.second_unpaired)) == ("no_pairs", 1, 1)
    alike = np.array([[np.sqrt(0.6), np.sqrt(0.4), 0.0]])
    (pair,) = compare_measurements(measured([50.0], shape), measured([51.0], alike)).pairs
    assert pair.mac == pytest.approx(0.6)


def test_nothing_is_claimed_too_often_and_a_change_is_found() -> None:
    """1,000 pairs of measurements of 8 modes with normal errors: false claims at the level, 5 sigma nearly always."""
    rng = np.random.default_rng(20261128)
    f = np.linspace(40.0, 180.0, 8)
    claims = found = 0
    low = 0
    for _ in range(1000):
        a, b = (f + 0.1 * rng.normal(size=(2, 8))).tolist()
        same = compare_measurements(measured(a), measured(b))
        claims += any(pair.differs for pair in same.pairs)
        low += same.p_value < 0.05
        b[3] += 5.0 * 0.1 * np.sqrt(2.0)
        found += compare_measurements(measured(a), measured(b)).pairs[3].differs
    assert claims <= 1000 * SIGNIFICANCE_LEVEL + 3.0 * np.sqrt(1000 * SIGNIFICANCE_LEVEL)
    assert abs(low - 50) < 4.0 * np.sqrt(50)
    power = norm.sf(norm.isf(SIGNIFICANCE_LEVEL / 16) - 5.0)
    assert found / 1000 == pytest.approx(power, abs=0.04)


def test_poses_without_a_partner_and_other_drives_are_refused() -> None:
    two = Measurements.from_rows(["A", "B"], [50.0, 60.0], [0.1, 0.1])
    with pytest.raises(MeasurementError, match="expected poses of"):
        compare_measurements(two, measured([50.0], pose="C"))
    with pytest.raises(MeasurementError, match="expected motors free"):
        compare_measurements(measured([50.0]), measured([50.0], drives=["held"]))


def test_measurements_of_two_machines_are_refused() -> None:
    in_space = measured([50.0], points=[[0.6, 0.0, -0.2]])
    turning = measured([50.1], points=[[0.6, 0.1]], components={"x": "m", "c": "rad"}, source="other.csv")
    with pytest.raises(MeasurementError, match=r"poses given by x, y, z, .* found x, c \(other.csv: pose\)"):
        compare_measurements(in_space, turning)


def test_the_same_rows_are_refused_in_any_order_and_others_are_not() -> None:
    first, shifted = measured([50.0, 60.0, 90.0], SHAPES), measured([50.0, 60.0, 90.1], SHAPES)
    order = [2, 0, 1]
    copy = measured([90.0, 50.0, 60.0], SHAPES[order], source="copy.csv")
    for same in (first, copy):
        with pytest.raises(MeasurementError, match=r"the same rows as in .*give the file of the second"):
            compare_measurements(first, same)
    for other in (shifted, measured([50.0, 60.0, 90.0], -SHAPES), measured([50.0, 60.0], SHAPES[:2])):
        compare_measurements(first, other)


def test_other_loads_and_positions_are_told() -> None:
    def at(x: float, mass: float) -> Measurements:
        more = {"points": [[x, 0.0, -0.2]], "settings": {"effects.payload.mass": [mass]}}
        return measured([50.0 + mass + x], **more)

    first = at(0.6, 0.1)
    assert not any("Pose A" in note for note in compare_measurements(first, at(0.6 + 1e-8, 0.1)).notes)
    for other, part in ((at(0.5, 0.1), "the positions differ"), (at(0.6, 0.3), "columns set: differ")):
        assert [part in note for note in compare_measurements(first, other).notes if "Pose A" in note] == [
            True
        ]


def test_options_of_robots_are_refused_and_a_structure_needs_none(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    for name, f in {"a": 50.0, "b": 53.0}.items():
        Path(f"{name}.csv").write_text(
            f"pose,frequency,sigma,shape:floor_1,shape:floor_2\nP,{f},0.1,1,0.5\n", encoding="utf-8"
        )
    assert run(["compare", "a.csv", "b.csv"]) == 0
    assert "1 of 1 mode changed: 50 Hz at P by +6 % (21 sigma)" in " ".join(capsys.readouterr().out.split())
    table = "sep=;\nPose;Frequency (Hz);Sigma;Shape:floor_1;SHAPE:floor_2\nP;53,0;0,1;1;0,5\n"
    Path("b.csv").write_text(table, encoding="utf-16")  # as Excel writes it
    assert run(["compare", "a.csv", "b.csv"]) == 0
    assert "1 of 1 mode changed: 50 Hz at P by +6 % (21 sigma)" in " ".join(capsys.readouterr().out.split())
    assert run(["compare", "a.csv", "b.csv", "--grid", "x=0"]) == 2
    assert "does not apply to two measurement files" in capsys.readouterr().err


@pytest.mark.parametrize("unit", [1.0, 180.0 / np.pi])
def test_rotations_in_any_unit_do_not_make_different_modes_alike(unit: float) -> None:
    """Sway and tilt of a platform in metres and radians: as (1, 1) and (1, -1), which have nothing in common."""
    shapes = np.array([[1.0, 10.0], [1.0, -10.0]]) * [1.0, unit]

    def of(frequencies: list[float], rows: np.ndarray) -> Measurements:
        named = dict(zip(("p_x", "r_y"), rows.T, strict=True))
        return Measurements.from_rows(["A", "A"], frequencies, [0.1, 0.1], shapes=named)

    found = compare_measurements(of([50.0, 60.0], shapes), of([50.2, 60.3], shapes[::-1]))
    # Each mode has its partner at the other frequency: a pair of modes with a MAC of 0 is none.
    assert [(pair.first, pair.second) for pair in found.pairs] == [(50.0, 60.3), (60.0, 50.2)]
    assert [pair.mac for pair in found.pairs] == pytest.approx([1.0, 1.0])
    same = compare_measurements(of([50.0, 60.0], shapes), of([50.2, 60.3], shapes))
    assert [pair.mac for pair in same.pairs] == pytest.approx([1.0, 1.0])


def test_poses_are_paired_by_position_where_the_labels_name_other_places() -> None:
    """The labels of two campaigns are those of their own lists: P1 of one need not be P1 of the other."""
    near, far, third = [0.6, 0.0, -0.2], [0.3, 0.1, -0.2], [0.4, 0.0, -0.3]

    def campaign(*labels: str, source: str, factor: float) -> Measurements:
        return Measurements.from_rows(
            labels,
            np.array([50.0, 80.0, 70.0]) * factor,
            [0.1] * 3,
            points=[near, far, third if factor == 1.0 else (np.array(third) + 0.1).tolist()],
            components={"x": "m", "y": "m", "z": "m"},
            source=source,
        )

    first = campaign("A", "B", "D", source="first.csv", factor=1.0)
    for labels in (("B", "A", "D"), ("C", "A", "D")):
        result = compare_measurements(first, campaign(*labels, source="second.csv", factor=1.01))
        assert [(pair.pose, pair.second_pose) for pair in result.pairs] == [
            ("A", labels[0]),
            ("B", labels[1]),
        ]
        assert [round(pair.relative, 6) for pair in result.pairs] == [0.01, 0.01]
        assert any("Pose A of the first file is paired with" in note for note in result.notes)
        assert not any("the positions differ" in note for note in result.notes)
