"""A hammer that roves in front of sensors that stay, with a file of frequency responses for each point."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from pathlib import Path

import numpy as np
import pytest
from scipy.io import savemat

from modaltest.campaign.structures import CHANNELS, HEAD, Frame, Identified, identify, refused, write_frf
from modaltest.campaign.test_impact_campaigns import roving as in_time
from modaltest.campaign.test_impact_campaigns import write_blows
from modaltest.signals.universal import frf58
from pkmodes.loop.measured.reading import read_modes

STEP = 0.25
F = STEP * np.arange(40, 880)
TIP = '[[sensor]]\nname = "tip"\nchannel = "none"\nunit = "m/s^2"\n'
POINTS = tuple(f"floor_{k}" for k in range(1, 7))
ALONE = "each point is fitted by itself"


def campaign(
    files: Mapping[int, list[str]],
    keys: str = "",
    *,
    signs: Mapping[int, str] | None = None,
    head: str = HEAD,
) -> str:
    """Return the campaign of a setup for each point, in which one force acts."""
    forces = "".join(
        f'[[force]]\nname = "hammer"\nchannel = "{(signs or {}).get(k, "")}floor_{k}"\nsetup = "at {k}"\n'
        for k in files
    )
    setups = ", ".join(f'"at {k}" = {json.dumps(each)}' for k, each in files.items())
    return f'{head}{TIP}{forces}[[record]]\npose = "P1"\nkind = "frf"\nfiles = {{ {setups} }}\n{keys}'


def has_the_modes_of_the_frame(found: Identified) -> None:
    natural, shapes = Frame.build().modes()
    data = read_modes(found.file, CHANNELS)
    np.testing.assert_allclose(data.frequency, natural, rtol=3e-4)
    np.testing.assert_allclose(data.numbers["damping"], Frame.build().ratios, rtol=0.03)
    for row, shape in zip(data.shapes, shapes.T, strict=True):
        np.testing.assert_allclose(row, shape / shape[np.argmax(np.abs(shape))], rtol=0, atol=0.02)


def write_points(
    folder: Path, factors: tuple[float, ...] = (1.0, 1.0, 1.0), repeats: int = 1, seed: int = 7
) -> dict[int, list[str]]:
    """Write tables of the third floor by blows on each; `factors` are of the springs while a point was hit."""
    rng = np.random.default_rng(seed)
    files: dict[int, list[str]] = {}
    for k, factor in enumerate(factors, start=1):
        H = Frame.build().accelerances(F, factor)[:, 2, k - 1]
        files[k] = [f"p{k}_{i}.csv" for i in range(repeats)]
        for name in files[k]:
            write_frf(folder / name, F, {"tip": H}, 0.01, rng)
    return files


def write_as(way: str, path: Path, H: np.ndarray, point: int) -> None:
    if way == "array":
        savemat(path, {"frequency": F, "tip": H})
    elif way == "universal":
        whole = np.concatenate([np.zeros(len(F) and 40, complex), H])  # from 0 Hz
        path.write_bytes(frf58(whole, STEP, response=(9, 3), reference=(point, -3)))
    else:
        names = {"header": "frequency,re:tip,im:tip", "other header": "f,a,b", "no header": ""}[way]
        table = np.column_stack([F, H.real, H.imag])
        np.savetxt(path, table, delimiter=",", header=names, comments="")


@pytest.mark.parametrize("way", ["header", "other header", "no header", "array", "universal"])
def test_each_way_to_store_a_point_gives_the_modes_of_the_frame(tmp_path: Path, way: str) -> None:
    """The second point is hit against its direction; in no file but the universal ones has the force a name."""
    rng = np.random.default_rng(3)
    files = {k: [f"p{k}.{'mat' if way == 'array' else 'x'}"] for k in (1, 2, 3)}
    for k, (name,) in files.items():
        H = (-1.0 if k == 2 else 1.0) * Frame.build().accelerances(F)[:, 2, k - 1]
        noise = 0.005 * np.sqrt(np.mean(np.abs(H) ** 2)) * (rng.normal(size=(2, len(F))))
        write_as(way, tmp_path / name, H + noise[0] + 1j * noise[1], k)
    columns = 'columns = ["frequency", "re:tip", "im:tip"]\n' if way in ("other header", "no header") else ""
    text = campaign(files, columns, signs={2: "-"})
    if way == "universal":
        text = text.replace('"tip"', '"9:+Z"').replace('unit = "m/s^2"\n', "")
        for k in files:
            text = text.replace(
                f'"hammer"\nchannel = "{"-" * (k == 2)}floor_{k}"\nsetup = "at {k}"',
                f'"{k}:+Z"\nchannel = "{"-" * (k == 2)}floor_{k}"',
            )
    found = identify(tmp_path, text)
    has_the_modes_of_the_frame(found)
    assert ALONE not in found.remarks


def plate() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Frequencies, damping ratios, shapes (points, modes): a pair 0.3 % apart, and modes that points hardly show."""
    rng = np.random.default_rng(17)
    natural = np.array([31.0, 55.0, 55.0 * 1.003, 80.0, 104.0, 151.0])
    shapes = rng.normal(size=(6, 6))
    shapes[1, [0, 3]] = 0.0
    shapes[4, 1:3] = 0.02
    return natural, np.array([0.01, 0.004, 0.005, 0.012, 0.006, 0.008]), shapes


def write_plate(folder: Path, repeats: int, warming: float = 0.0) -> dict[int, list[str]]:
    """Write tables of the first point of the plate by blows on each, while its frequencies fall."""
    natural, ratios, shapes = plate()
    rng, w = np.random.default_rng(18), 2.0 * np.pi * F[:, None]
    files = {k: [f"p{k}_{i}.csv" for i in range(repeats)] for k in range(1, 7)}
    for k, names in files.items():
        wn = 2.0 * np.pi * natural * (1.0 - warming * (k - 1) / 5.0)
        H = (-(w**2) * shapes[0] * shapes[k - 1] / (wn**2 - w**2 + 2j * ratios * wn * w)).sum(axis=1)
        for name in names:
            write_frf(folder / name, F, {"tip": H}, 0.01, rng)
    return files


def test_a_pair_of_modes_that_single_points_do_not_tell_apart_is_two_rows(tmp_path: Path) -> None:
    natural, ratios, shapes = plate()
    files = write_plate(tmp_path, 2)
    found = identify(tmp_path, campaign(files, head=HEAD.replace(json.dumps(CHANNELS), json.dumps(POINTS))))
    data = read_modes(found.file, POINTS)
    np.testing.assert_allclose(data.frequency, natural, rtol=5e-4)
    np.testing.assert_allclose(data.numbers["damping"], ratios, rtol=0.1)
    for row, shape in zip(data.shapes, shapes.T, strict=True):
        np.testing.assert_allclose(row, shape / shape[np.argmax(np.abs(shape))], rtol=0, atol=0.05)
    for mode in found.record["modes"]:
        assert mode["files"] == 2
        assert mode["sigma_parts"]["scatter"] > 0.0
    assert "differ" not in found.remarks


def test_blows_in_time_and_their_functions_give_the_same_modes(tmp_path: Path) -> None:
    rng = np.random.default_rng(30)
    for k in (1, 2, 3):
        write_blows(tmp_path / f"b{k}0.csv", rng, floor=k - 1)
    by_time = read_modes(identify(tmp_path, in_time(repeats=1)).file, CHANNELS)
    by_functions = read_modes(identify(tmp_path, campaign(write_points(tmp_path))).file, CHANNELS)
    np.testing.assert_allclose(by_functions.frequency, by_time.frequency, rtol=1e-3)
    np.testing.assert_allclose(by_functions.shapes, by_time.shapes, rtol=0, atol=0.03)


@pytest.mark.parametrize(("last", "change"), [(1.0, ""), (0.996, "0.2 %"), (0.985, "0.75 %")])
def test_a_machine_that_changed_between_the_points_is_found_out(
    tmp_path: Path, last: float, change: str
) -> None:
    """Its frequencies fell by 0.75 % at the last point; with 0.2 % the functions are those of one machine."""
    head = 'repeatability = "0.01 %"\n' + HEAD
    found = identify(tmp_path, campaign(write_points(tmp_path, (1.0, 1.0, last)), head=head))
    assert (f"differ by {change} between" in found.remarks) is bool(change)
    assert (ALONE in found.remarks) is (change == "0.75 %")
    data = read_modes(found.file, CHANNELS)
    if change != "0.75 %":
        natural, shapes = Frame.build().modes(0.5 + 0.5 * last)
        np.testing.assert_allclose(data.frequency, natural, rtol=3e-4)
        np.testing.assert_allclose(data.numbers["damping"], Frame.build().ratios, rtol=0.03)
        for row, shape in zip(data.shapes, shapes.T, strict=True):
            np.testing.assert_allclose(row, shape / shape[np.argmax(np.abs(shape))], rtol=0, atol=0.02)
    if change == "0.2 %":
        np.testing.assert_allclose(data.sigma, 0.001 * data.frequency, rtol=0.1)


def test_a_machine_that_warms_from_point_to_point_has_each_mode_once(tmp_path: Path) -> None:
    """By 0.1 % in all, a tenth of the half-power bandwidth of its sharpest modes, which the pair feels most."""
    natural, ratios, _ = plate()
    files = write_plate(tmp_path, 1, warming=0.001)
    found = identify(tmp_path, campaign(files, head=HEAD.replace(json.dumps(CHANNELS), json.dumps(POINTS))))
    data = read_modes(found.file, POINTS)
    np.testing.assert_allclose(data.frequency, natural * (1.0 - 0.0005), rtol=1e-3)
    alone = [0, 3, 4, 5]
    np.testing.assert_allclose(data.frequency[alone], natural[alone] * (1.0 - 0.0005), rtol=1.5e-4)
    np.testing.assert_allclose(data.numbers["damping"][alone], ratios[alone], rtol=0.03)


def test_points_with_other_lines_are_fitted_by_themselves(tmp_path: Path) -> None:
    files = write_points(tmp_path)
    table = np.loadtxt(tmp_path / "p2_0.csv", delimiter=",", skiprows=1)
    write = partial_write(tmp_path / "p2_0.csv")
    write(table[::2])
    found = identify(tmp_path, campaign(files))
    expected = (
        "expected in p2_0.csv the frequencies of p1_0.csv in the band, 721 lines from 20 Hz, 0.25 Hz apart"
    )
    assert f"{ALONE}: {expected}, found 361 lines from 20 Hz, 0.5 Hz apart" in found.remarks
    has_the_modes_of_the_frame(found)
    write(table[20:-30])  # the same lines, which cover the band
    found = identify(tmp_path, campaign(files))
    assert ALONE not in found.remarks
    has_the_modes_of_the_frame(found)


def partial_write(path: Path) -> Callable[[np.ndarray], None]:
    """Return what writes a table of the tip."""
    return lambda table: np.savetxt(path, table, delimiter=",", header="frequency,re:tip,im:tip", comments="")


def test_of_two_sensors_that_which_all_points_have_is_used(tmp_path: Path) -> None:
    H, rng = Frame.build().accelerances(F), np.random.default_rng(8)
    files = {k: [f"p{k}.csv"] for k in (1, 2, 3)}
    for k, (name,) in files.items():
        write_frf(tmp_path / name, F, {"tip": H[:, 2, k - 1], "side": H[:, 0, k - 1]}, 0.01, rng)
    text = campaign(files).replace(TIP, TIP + TIP.replace("tip", "side"))
    both = identify(tmp_path, text)
    has_the_modes_of_the_frame(both)
    assert "not used" not in both.remarks
    write_frf(tmp_path / "p2.csv", F, {"tip": H[:, 2, 1]}, 0.01, rng)
    found = identify(tmp_path, text)
    has_the_modes_of_the_frame(found)
    assert "not used, as only some of the points that were hit have it: side" in found.remarks
    write_frf(tmp_path / "p3.csv", F, {"side": H[:, 0, 2]}, 0.01, rng)
    assert 'expected a sensor with a signal for every point, found none among "tip", "side"' in (
        identify(tmp_path, text).remarks
    )


def test_points_with_more_files_and_faulty_ones(tmp_path: Path) -> None:
    files = write_points(tmp_path, repeats=2)
    text = campaign(files | {3: files[3][:1]})
    found = identify(tmp_path, text)
    has_the_modes_of_the_frame(found)
    assert "not used, as some point has only one file: p1_1.csv, p2_1.csv" in found.remarks
    (tmp_path / "p1_0.csv").write_text("nothing")
    found = identify(tmp_path, text, "--keep-going")
    has_the_modes_of_the_frame(found)
    assert ALONE not in found.remarks
    assert [each["file"] for each in found.record["left_out"]] == ["p1_0.csv"]


def test_a_point_hit_again_has_the_mean_of_its_functions(tmp_path: Path) -> None:
    """The first point once more at the end, as a check: its function is 4 % larger there."""
    files = write_points(tmp_path)
    table = np.loadtxt(tmp_path / "p1_0.csv", delimiter=",", skiprows=1)
    partial_write(tmp_path / "again.csv")(table * [1.0, 1.04, 1.04])
    text = campaign(files).replace(" }", ', again = ["again.csv"] }')
    text = text.replace(
        "[[record]]", '[[force]]\nname = "hammer"\nchannel = "floor_1"\nsetup = "again"\n[[record]]'
    )
    data = read_modes(identify(tmp_path, text).file, CHANNELS)
    once = read_modes(identify(tmp_path, campaign(files)).file, CHANNELS)
    np.testing.assert_allclose(
        data.shapes[:2, 0] / data.shapes[:2, 2], 1.02 * once.shapes[:2, 0] / once.shapes[:2, 2], rtol=5e-3
    )


def test_setups_with_the_same_points_are_no_roving_hammer(tmp_path: Path) -> None:
    """Both floors from one file, cold and warm: the setups differ, and it is said of the modes."""
    rng = np.random.default_rng(5)
    for name, factor in (("cold", 1.0), ("warm", 0.975)):
        H = Frame.build().accelerances(F, factor)
        write_frf(tmp_path / f"{name}.csv", F, {f"tip/{k}": H[:, 2, k - 1] for k in (1, 2, 3)}, 0.01, rng)
    forces = "".join(f'[[force]]\nname = "{k}"\nchannel = "floor_{k}"\n' for k in (1, 2, 3))
    text = (
        HEAD
        + TIP
        + forces
        + '[[record]]\npose = "P1"\nkind = "frf"\nfiles = { a = ["cold.csv"], b = ["warm.csv"] }\n'
    )
    found = identify(tmp_path, text)
    assert "the setups a, b differ by more than their standard deviations" in found.remarks
    assert "points that were hit" not in found.remarks
    assert len(found.record["modes"]) == 3


def test_a_force_without_a_name_needs_a_setup_of_its_own(tmp_path: Path) -> None:
    text = campaign(write_points(tmp_path))
    for k in (1, 2, 3):
        text = text.replace(
            f'name = "hammer"\nchannel = "floor_{k}"\nsetup = "at {k}"',
            f'name = "h{k}"\nchannel = "floor_{k}"',
        )
    said = refused(tmp_path, text)
    assert 'expected the force "h1" in a file, found none in those of P1 (c.toml: force.1.name)' in said
    assert "give each [[force]] the setup in which it acts alone" in said


def test_a_sensor_with_the_name_of_a_force_is_no_force(tmp_path: Path) -> None:
    """One file names its force, the other does not, and which of two it is nothing tells: no roving hammer."""
    H, rng = Frame.build().accelerances(F), np.random.default_rng(8)
    write_frf(tmp_path / "p1.csv", F, {"p3/p1": H[:, 2, 0]}, 0.01, rng)
    write_frf(tmp_path / "p3.csv", F, {"p3": H[:, 2, 2]}, 0.01, rng)
    forces = "".join(f'[[force]]\nname = "p{k}"\nchannel = "floor_{k}"\n' for k in (1, 3))
    text = HEAD + TIP.replace("tip", "p3") + forces
    text += '[[record]]\npose = "P1"\nkind = "frf"\nfiles = { a = ["p1.csv"], b = ["p3.csv"] }\n'
    data = read_modes(identify(tmp_path, text).file, CHANNELS)
    np.testing.assert_allclose(data.frequency, Frame.build().modes()[0], rtol=3e-4)
    assert data.channels == ("floor_1",)
