"""The rig's laboratories miss modes realistically, state their errors as specified, and make mistakes."""

from __future__ import annotations

from collections import Counter
from functools import cache

import numpy as np
import pytest

from pkmodes.core.mechanism.registry import mechanism
from pkmodes.loop.updating.channels import channels
from pkmodes_rig.engine import TrueModes, true_modes
from pkmodes_rig.laboratory import SENSORS, Laboratory, seen
from pkmodes_rig.measurements import exact, identified, measure_modes, written
from pkmodes_rig.mistakes import ASKEW, MISTAKES, ORDERS, followed, mistaken, parsed
from pkmodes_rig.robots import POSES, read

POSE = POSES["asymmetric"]["grid"][4]


@cache
def modes() -> TrueModes:
    return true_modes(read("asymmetric").parameters, POSE)


def true() -> np.ndarray:
    return modes().frequencies[3:]


def file(count: int = 12, seed: int = 1, **options: object) -> str:
    """The same modes at a few poses."""
    points = POSES["asymmetric"]["grid"]
    return measure_modes(
        [modes()] * count,
        [points[i % 12] for i in range(count)],
        rng=np.random.default_rng(seed),
        **{"shapes": SENSORS, **options},
    )


def test_a_laboratory_without_faults_gives_the_files_of_one_that_nobody_described() -> None:
    assert file(**Laboratory().options()) == file()


def test_modes_that_hardly_move_the_sensors_are_missed() -> None:
    motion = np.outer([0.05, 0.2, 0.5, 1.0, 1.0, 2.0, 3.0], np.ones(4))
    chance = seen(motion, 0.2)
    assert chance[1] == pytest.approx(0.5)
    assert chance == pytest.approx(
        [1 / 257, 1 / 2, 1 / (1 + 0.4**4), *(1 / (1 + (0.2 / v) ** 4) for v in (1, 1, 2, 3))]
    )
    assert seen(motion, 0.0) == pytest.approx(np.ones(7))
    found = identified([modes()] * 400, rng=np.random.default_rng(2), shapes=("x_1",), nodes=0.5)
    visible = np.abs(modes().shapes["x_1"][3:])
    visible = visible / np.median(visible)
    counts = Counter(row.mode for row in found)
    expected = visible**4 / (visible**4 + 0.5**4)
    assert [counts[3 + i] / 400 for i in range(6)] == pytest.approx(expected, abs=0.09)
    assert expected.min() < 0.5 < expected.max()


def test_modes_must_show_at_the_sensors_also_where_shapes_are_not_written_down() -> None:
    def found(**options: object) -> list[int]:
        rng = np.random.default_rng(2)
        return sorted(row.mode for row in identified([modes()] * 50, rng=rng, nodes=0.5, **options))

    assert found(sensors=("x_1",)) != found(sensors=("p_z",))


def test_nothing_is_found_outside_the_band_and_the_file_may_say_so() -> None:
    band = (float(f"{(true()[0] + true()[1]) / 2:.3g}"), float(f"{(true()[4] + true()[5]) / 2:.3g}"))
    for stated in (False, True):
        comments, rows = parsed(file(band=band, band_stated=stated))
        assert len(rows) == 12 * 4
        assert all(band[0] <= float(row["frequency"]) <= band[1] for row in rows)
        assert comments[1:] == ([f"# band: {band[0]:g} Hz, {band[1]:g} Hz"] if stated else [])


def test_the_number_of_modes_varies_from_pose_to_pose() -> None:
    rows = identified([modes()] * 200, rng=np.random.default_rng(0), modes=(2, 5))
    counts = Counter(Counter(row.pose for row in rows).values())
    assert set(counts) == {2, 3, 4, 5}
    assert min(counts.values()) > 30
    tied = true_modes(read("asymmetric").parameters, POSE, {"cable_stiffness.stiffness": 3e4})
    lowest = identified([tied], rng=np.random.default_rng(0), modes=(4, 4))
    assert sorted(row.mode for row in lowest) == [0, 1, 2, 3]


def test_uneven_errors_are_stated_row_by_row() -> None:
    rows = identified([modes()] * 300, rng=np.random.default_rng(5), uneven=0.3, sigma_scale=2.0)
    part = np.array([row.sigma / row.frequency for row in rows])
    assert np.std(np.log(part)) == pytest.approx(0.3, rel=0.1)
    assert [row.stated / row.sigma for row in rows] == pytest.approx([2.0] * len(rows))
    z = [np.log(row.frequency / modes().frequencies[row.mode]) for row in rows] / part
    assert np.std(z) == pytest.approx(1.0, rel=0.06)


@pytest.mark.parametrize(("says", "blank"), [("stated", 0.0), ("some", 0.5)])
def test_the_error_of_shapes_may_be_stated(says: str, blank: float) -> None:
    _, rows = parsed(file(100, sigma_shape=says, shape_noise=0.03))
    assert set(rows[0]) - set(parsed(file())[1][0]) == {"sigma_shape"}
    assert {row["sigma_shape"] for row in rows} <= {"0.03", ""}
    assert sum(not row["sigma_shape"] for row in rows) == pytest.approx(blank * len(rows), abs=60)


def test_exact_rows_are_the_modes_themselves() -> None:
    rows = identified([modes()], rng=np.random.default_rng(0), shapes=SENSORS, sigma_scale=3.0, uneven=0.5)
    for before, row in zip(rows, exact(rows, [modes()], SENSORS), strict=True):
        assert row.frequency == modes().frequencies[row.mode]
        assert row.stated == row.sigma == pytest.approx(row.frequency * before.sigma / before.frequency)
        assert list(row.shape) == [modes().shapes[name][row.mode] for name in SENSORS]


def test_laboratories_differ_and_are_reproduced() -> None:
    def draw(seed: int) -> Laboratory:
        return Laboratory.drawn(np.random.default_rng(seed), (40.0, 160.0))

    many = [draw(seed) for seed in range(200)]
    assert draw(3) == many[3]
    assert {lab.band_stated for lab in many} == {False, True}
    assert {lab.sigma_shape for lab in many} == {"absent", "stated", "some"}
    assert Counter(len(lab.shapes) for lab in many).keys() == {0, 3, 6}
    assert 0.15 < np.mean([lab.sigma_scale != 1.0 for lab in many]) < 0.35
    assert all(0.01 <= lab.shape_noise <= 0.05 for lab in many)
    assert 0.2 < np.mean([lab.band[0] > 38.0 for lab in many]) < 0.45
    text = file(**many[0].options())
    assert text == file(**many[0].options())


def before_and_after(mistake: str) -> tuple[list[dict[str, str]], list[dict[str, str]]]:
    text = file()
    return parsed(text)[1], parsed(mistaken(text, mistake, np.random.default_rng(0)))[1]


def column(rows: list[dict[str, str]], name: str) -> np.ndarray:
    return np.array([float(row[name]) for row in rows])


@pytest.mark.parametrize(
    ("mistake", "columns", "factor"),
    [
        ("rad/s for Hz", ("frequency", "sigma"), 2 * np.pi),
        ("rpm for Hz", ("frequency", "sigma"), 60.0),
        ("sigma far too large", ("sigma",), 100.0),
        ("sigma far too small", ("sigma",), 0.1),
    ],
)
def test_wrong_units_and_errors_multiply(mistake: str, columns: tuple[str, ...], factor: float) -> None:
    before, after = before_and_after(mistake)
    for name in before[0]:
        if name in columns:
            np.testing.assert_allclose(column(after, name), factor * column(before, name), rtol=1e-8)
        else:
            assert [row[name] for row in before] == [row[name] for row in after]
    assert all(float(row["sigma"]) < float(row["frequency"]) for row in after)  # a reader takes the file


@pytest.mark.parametrize(("a", "b"), [("x_1", "x_2"), ("p_y", "p_z")])
def test_exchanged_sensors_are_exchanged(a: str, b: str) -> None:
    before, after = before_and_after(f"{a} and {b} exchanged")
    for one, other in zip(before, after, strict=True):
        assert (one[f"shape:{a}"], one[f"shape:{b}"]) == (other[f"shape:{b}"], other[f"shape:{a}"])


def test_a_flipped_channel_is_one_channel() -> None:
    before, after = before_and_after("sign of one channel")
    ratios = [set(np.round(column(after, f"shape:{n}") / column(before, f"shape:{n}"), 6)) for n in SENSORS]
    assert sorted(ratios, key=min) == [{-1.0}] + [{1.0}] * 5


def test_a_wrong_signed_order_has_other_components_with_signs() -> None:
    before, after = before_and_after("p_y, -p_x, p_z")
    np.testing.assert_allclose(column(after, "shape:p_x"), column(before, "shape:p_y"), rtol=1e-8)
    np.testing.assert_allclose(column(after, "shape:p_y"), -column(before, "shape:p_x"), rtol=1e-8)
    assert [row["shape:p_z"] for row in after] == [row["shape:p_z"] for row in before]
    assert len(ORDERS) == 47


def test_a_sensor_askew_measures_the_same_vector() -> None:
    before, after = before_and_after(ASKEW)
    lengths = [np.hypot(column(rows, "shape:p_x"), column(rows, "shape:p_y")) for rows in (before, after)]
    np.testing.assert_allclose(*lengths, rtol=1e-7)
    turned = np.cos(np.radians(40)) * column(before, "shape:p_x") + np.sin(np.radians(40)) * column(
        before, "shape:p_y"
    )
    np.testing.assert_allclose(column(after, "shape:p_x"), turned, rtol=1e-6, atol=1e-12)


@pytest.mark.parametrize(
    ("order", "advice"),
    [
        (
            ["p_y", "-p_x", "p_z"],
            "rename the column shape:p_x to shape:p_y, rename the column shape:p_y to shape:p_x and change the sign "
            "of its values",
        ),
        (["-p_x", "p_y", "-p_z"], "change the sign of the columns shape:p_x and shape:p_z"),
        (["-p_x", "-p_y", "-p_z"], "change the sign of the column shape:x_1"),
        (
            ["-p_y", "p_x", "-p_z"],
            "rename the column shape:p_x to shape:p_y and change the sign of its values, rename the column shape:p_y "
            "to shape:p_x, change the sign of the column shape:p_z",
        ),
    ],
)
def test_good_advice_restores_the_file(order: list[str], advice: str) -> None:
    assert followed(order, advice) == ["p_x", "p_y", "p_z"]
    assert followed(["p_z", *order[1:]], advice) != ["p_x", "p_y", "p_z"]


def test_copied_shapes_and_poses_are_copies() -> None:
    _, after = before_and_after("all shapes equal")
    assert len({tuple(row[f"shape:{n}"] for n in SENSORS) for row in after}) == 1
    before, after = before_and_after("one pose copied")
    assert len(after) == len(before)
    by_pose = {
        label: sorted(r["frequency"] for r in after if r["pose"] == label)
        for label in {r["pose"] for r in after}
    }
    assert len(by_pose) == 12
    assert len({tuple(f) for f in by_pose.values()}) == 11
    assert len({(r["pose"], r["x"], r["y"], r["z"]) for r in after}) == 12


def test_poses_are_displaced_as_a_whole() -> None:
    before, after = before_and_after("poses too high")
    np.testing.assert_allclose(column(after, "z") - column(before, "z"), 0.02, atol=1e-9)
    before, after = before_and_after("poses turned")
    a, b = ((column(rows, "x") + 1j * column(rows, "y")) for rows in (before, after))
    np.testing.assert_allclose(b, a * np.exp(1j * np.radians(2.0)), atol=1e-8)


@pytest.mark.parametrize("mistake", MISTAKES)
def test_every_mistake_changes_the_file(mistake: str) -> None:
    before, after = before_and_after(mistake)
    assert before != after
    assert set(SENSORS) <= set(channels(mechanism("linear_delta")))


def test_rows_that_are_written_again_are_the_same() -> None:
    rows = identified([modes()], rng=np.random.default_rng(1), shapes=SENSORS)
    text = written(rows, [POSE], SENSORS, band=(10.0, 400.0), sigma_shape=True)
    assert text.splitlines()[1] == "# band: 10 Hz, 400 Hz"
    assert [row["sigma_shape"] for row in parsed(text)[1]] == [""] * len(rows)
