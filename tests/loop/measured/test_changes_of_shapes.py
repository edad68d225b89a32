"""Two measurements compared: whether the shapes say where something changed, against chains of masses and springs."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
from scipy.linalg import eigh
from scipy.stats import chi2

from pkmodes.cli import run
from pkmodes.loop.measured.compared import compare_measurements
from pkmodes.loop.measured.comparison import MeasurementsCompared
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.measured.series import series_of
from pkmodes.loop.measured.shape_changes import change_covariance
from pkmodes.loop.measured.strain_energy import energy_shares, most_changed

FLOORS = 5
STIFFNESS, MASS = np.full(FLOORS, 2e6), np.full(FLOORS, 5.0)


def modes_of(stiffness: np.ndarray, mass: np.ndarray = MASS) -> tuple[np.ndarray, np.ndarray]:
    """Return frequencies [Hz] and shapes, in rows, of masses on springs, the first of which stands on the ground."""
    drift = np.eye(len(mass)) - np.eye(len(mass), k=-1)
    values, vectors = eigh(drift.T @ np.diag(stiffness) @ drift, np.diag(mass))
    return np.sqrt(values) / (2.0 * np.pi), (vectors / np.abs(vectors).max(axis=0)).T


def measured(
    stiffness: np.ndarray,
    rng: np.random.Generator | None = None,
    *,
    of_shape: float | None = 0.005,
    of_frequency: float = 0.002,
    name: str = "floor_",
    count: int = FLOORS,
    **more: object,
) -> Measurements:
    """Return the lowest modes, with errors where a generator is given."""
    f, shapes = (part[:count] for part in modes_of(stiffness))
    if rng is not None:
        f = f * (1.0 + of_frequency * rng.normal(size=f.shape))
        shapes = shapes + (of_shape or 0.0) * rng.normal(size=shapes.shape)
    columns = {f"{name}{i + 1}": shapes[:, i] for i in range(FLOORS)}
    return Measurements.from_rows(
        ["frame"] * count, f, of_frequency * f, shapes=columns, shape_sigma=of_shape, **more
    )


def softer(storey: int, factor: float = 0.8) -> np.ndarray:
    """Return the stiffness of the storeys, from 1, with one changed."""
    return np.where(np.arange(1, FLOORS + 1) == storey, factor, 1.0) * STIFFNESS


def test_the_chain_is_that_of_the_closed_form() -> None:
    """A uniform chain, fixed at one end: sines."""
    f, shapes = modes_of(STIFFNESS)
    angles = (2.0 * np.arange(1, FLOORS + 1) - 1.0) * np.pi / (2.0 * FLOORS + 1.0)
    assert f == pytest.approx(np.sqrt(2e6 / 5.0) / np.pi * np.sin(angles / 2.0))
    sine = np.sin(np.outer(angles, np.arange(1, FLOORS + 1)))
    for shape, expected in zip(shapes, sine, strict=True):
        assert abs(shape @ expected) == pytest.approx(np.linalg.norm(shape) * np.linalg.norm(expected))


@pytest.mark.parametrize("storey", range(2, FLOORS + 1))
@pytest.mark.parametrize("factor", [0.8, 1.25])
def test_a_storey_that_changed_is_named_by_its_neighbours(storey: int, factor: float) -> None:
    """In ten measurements with errors of 0.5 %, never another storey and at most two times none."""
    rng = np.random.default_rng([20261130, storey])
    named = []
    for _ in range(10):
        result = compare_measurements(measured(STIFFNESS, rng), measured(softer(storey, factor), rng))
        if place := most_changed(result.strain_energy):
            named.append((place.channels, place.index > 1.0))
    assert named == [([f"floor_{storey - 1}", f"floor_{storey}"], factor < 1.0)] * len(named)
    assert len(named) >= 8


def test_nothing_is_said_to_have_moved_where_nothing_did() -> None:
    """200 pairs without a change: at most 2 % claims of shapes of any kind, at a level of 1 % of all together."""
    rng = np.random.default_rng(20261130)
    claims, p_values = 0, []
    for _ in range(200):
        result = compare_measurements(measured(STIFFNESS, rng, count=3), measured(STIFFNESS, rng, count=3))
        shapes = [pair.shape for pair in result.pairs]
        places = [place for shape in shapes for place in (*shape.components, *shape.curvatures)]
        claims += any(place.differs for place in (*places, *result.strain_energy))
        p_values += [shape.p_value for shape in shapes]
    assert claims <= 0.02 * 200
    # The p-values of whole shapes are uniform: 600 of them.
    assert abs(np.mean(np.array(p_values) < 0.1) - 0.1) < 4.0 * np.sqrt(0.1 * 0.9 / 600)


@pytest.mark.parametrize("of_shape", [0.003, 0.02])
def test_standard_deviations_are_those_of_noisy_draws(of_shape: float) -> None:
    """10,000 draws about two different shapes, with scales of their own; least squares, by another formula."""
    rng = np.random.default_rng(20261201)
    a, b = modes_of(STIFFNESS)[1][1], -3.0 * modes_of(softer(3))[1][1]
    size, other = np.abs(a).max(), np.abs(b).max()
    first = a + of_shape * size * rng.normal(size=(10_000, FLOORS))
    second = b + 2.0 * of_shape * other * rng.normal(size=(10_000, FLOORS))
    factors = np.array(
        [np.linalg.lstsq(y[:, None], x, rcond=None)[0][0] for x, y in zip(first, second, strict=True)]
    )
    change = (factors[:, None] * second - first) / size
    curvature = change[:, :-2] - 2.0 * change[:, 1:-1] + change[:, 2:]
    energy, later = (np.diff(shapes, axis=1) ** 2 for shapes in (first, second))
    index = (later / later.sum(axis=1, keepdims=True) + 1.0) / (
        energy / energy.sum(axis=1, keepdims=True) + 1.0
    )

    channels = [f"x_{i + 1}" for i in range(FLOORS)]
    result = compare_measurements(
        *(
            Measurements.from_rows(
                ["A"], [f], [0.1], shapes=dict(zip(channels, shape[:, None], strict=True)), shape_sigma=sigma
            )
            for f, shape, sigma in ((50.0, a, of_shape), (49.0, b, 2.0 * of_shape))
        )
    )
    shape = result.pairs[0].shape
    for places, draws in (
        (shape.components, change),
        (shape.curvatures, curvature),
        (result.strain_energy, index),
    ):
        stated = np.array([place.sigma for place in places])
        assert stated == pytest.approx(draws.std(axis=0), rel=0.05 if of_shape < 0.01 else 0.1)
    assert [place.change for place in shape.components] == pytest.approx(
        ((a @ b) / (b @ b) * b - a) / size, abs=1e-12
    )
    assert [place.channel for place in shape.curvatures] == ["x_2", "x_3", "x_4"]


def test_curvatures_have_about_the_root_of_six_times_the_noise() -> None:
    result = compare_measurements(measured(STIFFNESS), measured(softer(3)))
    ratios = [
        np.mean([place.sigma for place in shape.curvatures])
        / np.mean([place.sigma for place in shape.components])
        for shape in (pair.shape for pair in result.pairs)
    ]
    assert np.mean(ratios) == pytest.approx(np.sqrt(6.0), rel=0.1)


def test_a_channel_that_has_nearly_the_whole_shape_has_the_error_of_second_order() -> None:
    """To first order least squares leave nothing of its change, which would make any noise one."""
    rng = np.random.default_rng(20261203)
    shape, error = np.array([1.0, 0.0, 0.0, 0.0]), 0.03
    first, second = shape + error * rng.normal(size=(2, 10_000, 4))
    factors = (first * second).sum(axis=1) / (second**2).sum(axis=1)
    draws = factors * second[:, 0] - first[:, 0]
    sigma = np.sqrt(change_covariance(shape, shape, error, error)[0, 0])
    assert sigma == pytest.approx(np.sqrt(np.mean(draws**2)), rel=0.1)


def test_neighbours_that_move_alike_have_the_error_of_second_order() -> None:
    """To first order their share is exact, which would make any noise a change."""
    rng = np.random.default_rng(20261202)
    motion, error = np.array([1.0, 1.0, 0.0]), 0.02
    shares, variances = energy_shares(motion, error)
    relative = np.diff(motion + error * rng.normal(size=(10_000, 3)), axis=1) ** 2
    draws = relative[:, 0] / relative.sum(axis=1)
    assert shares == pytest.approx([0.0, 1.0])
    assert np.sqrt(variances[0]) == pytest.approx(np.sqrt(np.mean(draws**2)), rel=0.05)


def test_scale_and_sign_of_a_shape_do_not_matter() -> None:
    before, after = measured(STIFFNESS), measured(softer(3))
    plain = compare_measurements(before, after)
    scaled = Measurements.from_rows(
        ["frame"] * FLOORS,
        after.frequency,
        after.sigma,
        shapes={name: -7.3 * after.shapes[:, k] for k, name in enumerate(after.channels)},
        shape_sigma=after.shape_sigma,
    )
    for pair, other in zip(plain.pairs, compare_measurements(before, scaled).pairs, strict=True):
        assert other.shape.chi2 == pytest.approx(pair.shape.chi2)
        for place, again in zip(pair.shape.components, other.shape.components, strict=True):
            assert (again.second, again.sigma) == pytest.approx((place.second, place.sigma))


def test_the_error_is_relative_to_the_largest_component_also_where_the_other_file_lacks_it() -> None:
    shapes = {"a": [4.0], "b": [1.0], "c": [0.5], "d": [-1.0]}
    first = Measurements.from_rows(["A"], [50.0], [0.1], shapes=shapes, shape_sigma=0.01)
    common = {name: shapes[name] for name in "bcd"}
    second = Measurements.from_rows(["A"], [50.0], [0.1], shapes=common, shape_sigma=0.01)
    shape = compare_measurements(first, second).pairs[0].shape
    # 1 % of 4 and of 1, relative to 1, across the shape (1, 0.5, -1).
    across = np.sqrt(1.0 - 0.25 / 2.25)
    expected = np.hypot(0.04, 0.01) * across
    assert [place.channel for place in shape.components] == ["b", "c", "d"]
    assert shape.components[1].sigma == pytest.approx(expected, rel=0.01)
    assert shape.p_value == pytest.approx(chi2.sf(0.0, 2))


@pytest.mark.parametrize(
    ("channels", "expected"),
    [
        (["x_2", "x_10", "x_1", "x_3"], [["x_1", "x_2", "x_3"]]),
        (["floor 1", "floor 2", "floor 3", "floor 5", "floor 6"], [["floor 1", "floor 2", "floor 3"]]),
        (["n1_x", "n2_x", "n3_x", "n1_y", "n2_y"], [["n1_x", "n2_x", "n3_x"]]),
        (["p1_z8", "p1_z9", "p1_z10"], [["p1_z8", "p1_z9", "p1_z10"]]),
        (["p_x", "p_y", "p_z", "x_1", "y_2", "z_3"], []),
    ],
)
def test_channels_that_are_numbered_without_a_gap_are_a_series(
    channels: list[str], expected: list[list[str]]
) -> None:
    assert [[channels[k] for k in run] for run in series_of(channels)] == expected


def test_joints_of_a_machine_are_no_series() -> None:
    """Where positions are given, numbers are those of axes, which stand beside each other."""
    place = {"points": np.tile([0.1, 0.0, 0.2], (FLOORS, 1)), "name": "x_"}
    result = compare_measurements(measured(STIFFNESS, **place), measured(softer(3), **place))
    assert result.strain_energy == []
    assert all(pair.shape.components and not pair.shape.curvatures for pair in result.pairs)


def cautions(result: MeasurementsCompared) -> list[list[str]]:
    return [pair.cautions for pair in result.pairs]


def test_it_is_said_when_shapes_may_not_be_trusted() -> None:
    before = measured(STIFFNESS)
    assert cautions(compare_measurements(before, measured(softer(3)))) == [[]] * FLOORS
    everywhere = compare_measurements(before, measured(0.9 * STIFFNESS))
    assert cautions(everywhere) == [["same_shape"]] * FLOORS
    assert any("in proportion everywhere" in note for note in everywhere.notes)
    unknown = compare_measurements(before, measured(softer(3), of_shape=None))
    assert cautions(unknown) == [["no_sigma_shape"]] * FLOORS
    assert all(place.sigma is None and not place.differs for place in unknown.strain_energy)
    assert unknown.pairs[0].shape.p_value is None
    two = measured(softer(3))
    few = Measurements.from_rows(
        ["frame"] * FLOORS,
        two.frequency,
        two.sigma,
        shapes={name: two.shapes[:, k] for k, name in enumerate(two.channels[:2])},
        shape_sigma=0.005,
    )
    assert all("few_channels" in each for each in cautions(compare_measurements(before, few)))


def test_close_modes_and_shapes_of_little_in_common_name_no_place(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Two modes 2 % apart turned by 15 degrees into each other, and one by 40 into one that is not in the files."""
    monkeypatch.chdir(tmp_path)
    basis = np.linalg.qr(np.random.default_rng(5).normal(size=(5, 5)))[0]

    def write(name: str, turned: float, further: float) -> None:
        c, s = np.cos(np.radians(turned)), np.sin(np.radians(turned))
        shapes = [c * basis[0] + s * basis[1], c * basis[1] - s * basis[0]]
        shapes += [np.cos(np.radians(further)) * basis[2] + np.sin(np.radians(further)) * basis[3]]
        header = ",".join(["pose,frequency,sigma,sigma_shape", *(f"shape:at_{i}" for i in range(1, 6))])
        rows = [
            f"P,{f},0.1,0.01," + ",".join(f"{x:.6f}" for x in shape)
            for f, shape in zip((100.0, 102.0, 150.0), shapes, strict=True)
        ]
        Path(name).write_text("\n".join([header, *rows, ""]), encoding="utf-8")

    write("a.csv", 0.0, 0.0)
    write("b.csv", 15.0, 40.0)
    assert run(["compare", "a.csv", "b.csv"]) == 0
    text = " ".join(capsys.readouterr().out.split())
    assert "Lines 2, 3 of the first file: another mode is within 3 %" in text
    assert "Line 4 of the first file: the MAC is below 0.9" in text
    assert "The shape of" not in text
    assert "strain energy" not in text
    assert "channel" not in text


def test_what_is_printed_of_a_softer_storey(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    for name, data in {"a": measured(STIFFNESS), "b": measured(softer(3))}.items():
        header = ["pose", "mode", "frequency", "sigma", "sigma_shape", *(f"shape:{c}" for c in data.channels)]
        rows = [
            ",".join(map(str, ["frame", k + 1, data.frequency[k], data.sigma[k], 0.005, *data.shapes[k]]))
            for k in range(FLOORS)
        ]
        Path(f"{name}.csv").write_text("\n".join([",".join(header), *rows, ""]), encoding="utf-8")
    assert run(["compare", "a.csv", "b.csv"]) == 0
    text = " ".join(capsys.readouterr().out.split())
    assert re.search(r"5 modes changed: [\d.]+ Hz at frame by", text)
    assert "more is between floor_2 and floor_3: index 1.0" in text
    assert "as where stiffness is lost" in text
    assert "differs most at floor_" in text
    assert "in the order of their numbers and at equal distances" in text
    assert run(["compare", "a.csv", "b.csv", "--all"]) == 0
    whole = " ".join(capsys.readouterr().out.split())
    assert whole.count("curvature floor_") == 3 * FLOORS
