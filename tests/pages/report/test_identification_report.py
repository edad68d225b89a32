"""The report of ``pkmodes identify``: its numbers are those of the JSON, and it is usable in a real browser."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from helpers.pages.browser import opened
from helpers.pages.page_reading import Element, at, powers, read, shown
from helpers.pages.report_examples import HOSTILE
from modaltest.campaign.structures import Frame, accelerations, write_frf
from pkmodes.cli import run
from pkmodes.pages.report.identification import _points_to_check, lowest_coherence

F = np.arange(10.0, 220.0, 0.5)
HEAD = 'format = 1\nchannels = ["u1", "u2", "u3"]\nband = ["20 Hz", "200 Hz"]\ntones = ["50 Hz"]\n'
SENSORS = "".join(f'[[sensor]]\nname = "a{k}"\nchannel = "u{k}"\nunit = "m/s^2"\n' for k in (1, 2, 3))


#: Label of the first pose of the campaign: a careless page would execute it.
LABEL = f"P1 {' '.join(HOSTILE[:6])}"


def write_campaign(folder: Path) -> Path:
    """Write functions in two setups with a mode struck out and one added, responses alone, and a spectrum."""
    frame, rng = Frame.build(), np.random.default_rng(41)
    natural = frame.modes()[0]
    for i in range(2):
        H = frame.accelerances(F)[:, :, 2]
        write_frf(folder / f"x{i}.csv", F, {"a1": H[:, 0], "a2": H[:, 1]}, 0.02, rng)
        write_frf(folder / f"y{i}.csv", F, {"a1": H[:, 0], "a3": H[:, 2]}, 0.02, rng)
    step = 1.0 / 512.0
    count = round(20.0 / step)
    a = sum(accelerations(frame, step, rng.normal(size=count), floor) for floor in range(3))
    table = np.column_stack([step * np.arange(count), a + 0.02 * a.std(axis=0) * rng.normal(size=a.shape)])
    np.savetxt(folder / "t.csv", table, delimiter=",", header="time,a1,a2,a3", comments="", fmt="%.8g")
    f = np.arange(4.8, 250.0, 1.6)
    power = np.abs(np.einsum("fkk->fk", frame.accelerances(f))) ** 2
    np.savetxt(
        folder / "s.csv", np.column_stack([f, power[:, 0]]), delimiter=",", header="freq,a1", comments=""
    )
    name = json.dumps(LABEL)
    text = HEAD + SENSORS
    text += f'[[record]]\npose = {name}\nkind = "frf"\n'
    text += 'files = { x = ["x0.csv", "x1.csv"], y = ["y0.csv", "y1.csv"] }\n'
    text += '[[record]]\npose = "P2"\nkind = "ambient"\nfiles = ["t.csv"]\n'
    text += '[[record]]\npose = "P3"\nkind = "spectrum"\nfiles = ["s.csv"]\n'
    text += f'[[edit]]\npose = {name}\nstrike = ["{natural[2]:.6g} Hz"]\nadd = ["{natural[1]:.6g} Hz"]\n'
    path = folder / "c.toml"
    path.write_text(text, encoding="utf-8")
    return path


def report(folder: Path, path: Path, name: str = "r.html") -> str:
    arguments = ["identify", str(path), "--out", str(folder / "m.csv"), "--json", str(folder / "m.json")]
    assert run([*arguments, "--report", str(folder / name)]) == 0
    return (folder / name).read_text(encoding="utf-8")


PARTS = [f"sigma_parts/{part}" for part in ("scatter", "fit", "repeatability")]


@pytest.fixture(scope="module")
def page(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("identified")
    report(folder, write_campaign(folder))
    return folder / "r.html"


def content(page: Path) -> dict:
    return json.loads((page.parent / "m.json").read_text(encoding="utf-8"))


def test_it_opens_on_at_most_six_screens(page: Path) -> None:
    """The records are folded, as in the page of a diagnosis; unfolded they are longer."""
    with opened(page, width=1280, height=900) as browser:
        height = "document.documentElement.scrollHeight"
        assert browser.page.evaluate(height) <= 6 * 900
        browser.page.get_by_role("button", name="Unfold all").click()
        assert browser.page.evaluate(height) > 6 * 900
        assert browser.page.locator("#record-1 table").is_visible()


def test_the_coherence_of_a_record_is_the_lowest_of_its_modes() -> None:
    """Each mode by the function that shows it best: 0.9 of 0.9 and 0.2 at 10 Hz, 0.7 of 0.4 and 0.7 at 20 Hz."""
    f = np.array([5.0, 10.0, 20.0, 30.0])
    curves = [
        SimpleNamespace(frequencies=f, coherence=np.array(values))
        for values in ([1.0, 0.9, 0.4, 1.0], [1.0, 0.2, 0.7, 1.0])
    ]
    modes = [SimpleNamespace(frequency=frequency) for frequency in (10.1, 19.8)]
    record: Any = SimpleNamespace(inspections=[SimpleNamespace(curves=curves)], modes=modes)
    assert lowest_coherence(record) == pytest.approx(0.7)
    record.inspections[0].curves = [SimpleNamespace(frequencies=f, coherence=None)]
    assert lowest_coherence(record) is None


def test_numbers_are_those_of_the_json(page: Path) -> None:
    document, root = content(page), read(page.read_text(encoding="utf-8"))
    placed, exponents = [one for one in root.all("data") if "data-at" in one.attributes], powers(root)
    for one in placed:
        where = one.attributes["data-at"]
        value = at(document, where)
        assert float(one.attributes["value"]) == value
        number, half = (10.0 ** exponents.get(id(one), 0) * part for part in shown(one.text))
        scale = 100.0 if where.endswith(("damping", "repeatability")) and "parts" not in where else 1.0
        assert number == pytest.approx(scale * value, abs=half * 1.001, rel=0.06)
    found = {one.attributes["data-at"] for one in placed}
    for i, record in enumerate(document["records"]):
        said = root.by_id(f"record-{i + 1}").text.partition("In every row: ")[2].partition(".")[0].split(", ")
        for key in ("frequency", "sigma", "damping", "sigma_damping", "complexity", "files", *PARTS):
            pointers = [f"/records/{i}/modes/{k}/{key}" for k in range(len(record["modes"]))]
            values = [at(document, pointer) for pointer in pointers]
            if any(pointer in found for pointer in pointers):
                # A mode that only one file has does not scatter.
                is_shown = [key != "sigma_parts/scatter" or mode["files"] > 1 for mode in record["modes"]]
                shown_values = zip(pointers, values, is_shown, strict=True)
                assert {p for p, v, show in shown_values if v is not None and show} <= found
            elif key == "sigma_parts/scatter":
                assert all(mode["files"] == 1 for mode in record["modes"])
            elif any(value is not None for value in values):  # a count that is the same for all modes
                assert len(set(values)) == 1
                assert any(text.endswith(f"{key.rsplit('/')[-1]} {values[0]:.0f}") for text in said)
        assert {f"/records/{i}/struck/{k}" for k in range(len(record["struck"]))} <= found


def test_the_head_says_what_was_found_and_edited(page: Path) -> None:
    document, root = content(page), read(page.read_text(encoding="utf-8"))
    summary = root.by_id("summary").text
    count = sum(len(record["modes"]) for record in document["records"])
    assert f"{count} modes at 3 poses" in summary
    (struck,) = document["records"][0]["struck"]
    (added,) = [mode for mode in document["records"][0]["modes"] if mode["edited"]]
    assert f"Struck out by the campaign: {LABEL} ({struck:.4g} Hz)." in summary
    assert f"Added by the campaign: {LABEL} ({added['frequency']:.4g} Hz)." in summary
    assert "the scatter of repeats is unknown: P2, P3" in summary


def test_the_headline_counts_what_the_notes_list(page: Path) -> None:
    """Every mode or pose that notes list is one point, of however many sentences."""
    summary = read(page.read_text(encoding="utf-8")).by_id("summary")
    notes = [item.text for item in summary.all("li")]
    listed = [note.rstrip(".").split(": ", 1)[1].split(", ") for note in notes]
    assert any(len(places) > 1 for places in listed)
    points = {place for places in listed for place in places}
    assert f", {len(points)} points to check" in summary.text


def test_a_mode_that_few_model_orders_have_is_a_point_to_check() -> None:
    """Fewer than a quarter of them; a mode that was not sought in orders is none."""
    orders = [(0, 20), (4, 20), (5, 20), (20, 20), None]
    modes = [
        SimpleNamespace(
            frequency=100.0 + k, found_in=found_in, edited=None, complexity=1.0, files=2, complex_shape={},
            sigma_damping=1e-4, damping=1e-2, lengths={},
        )
        for k, found_in in enumerate(orders)
    ]  # fmt: skip
    repeat = SimpleNamespace(files=("a", "b"))
    result = SimpleNamespace(
        record=SimpleNamespace(pose="P1"),
        modes=modes,
        left_out=(),
        struck=(),
        repeats=[repeat],
        is_left_out=False,
        messages=(),
    )
    assert _points_to_check(SimpleNamespace(records=[result])) == [
        ("Weak modes, found in fewer than 25 % of the model orders:", ["P1 (100 Hz)", "P1 (101 Hz)"])
    ]


def test_each_kind_of_record_has_its_figures(page: Path) -> None:
    root = read(page.read_text(encoding="utf-8"))
    titles = {
        k: [box.all("title")[0].text for box in root.by_id(f"record-{k}").all("figure") if box.all("svg")]
        for k in (1, 2, 3)
    }
    assert titles[1] == [
        "Stabilisation diagram of setup x, file x0.csv",
        "Measured and synthesised functions of setup x, file x0.csv",
        "Stabilisation diagram of setup y, file y0.csv",
        "Measured and synthesised functions of setup y, file y0.csv",
        "autoMAC",
        "Shapes in the complex plane",
        "Frequencies in each file",
    ]
    assert titles[2][:2] == [
        "Stabilisation diagram of file t.csv",
        "Measured and synthesised functions of file t.csv",
    ]
    assert titles[3] == ["Measured and synthesised functions of file s.csv"]
    text = root.by_id("record-1").text
    assert "The other file of the setup is not drawn." in text
    for label in ("struck out", "added", "tone", "stable pole"):
        assert label in root.by_id("record-1").all("svg")[0].text


def test_messages_of_a_record_are_on_the_page(page: Path) -> None:
    root = read(page.read_text(encoding="utf-8"))
    for i, record in enumerate(content(page)["records"]):
        text = " ".join(root.by_id(f"record-{i + 1}").text.split())
        for message in record["messages"]:
            assert " ".join(message.split()) in text


def test_the_same_campaign_gives_the_same_bytes(page: Path) -> None:
    assert report(page.parent, page.parent / "c.toml", "again.html") == page.read_text(encoding="utf-8")


def test_the_origin_names_files_without_their_folders(page: Path) -> None:
    assert str(page.parent) not in read(page.read_text(encoding="utf-8")).by_id("origin").text


def test_a_hostile_label_is_shown_as_text(page: Path) -> None:
    root = read(page.read_text(encoding="utf-8"))
    assert [one for one in root.all("script") if "hacked" in one.text] == []
    assert root.all("img") == []
    assert "<script>" in root.by_id("record-1").all("h2")[0].text


def test_the_page_works_in_a_browser_and_its_figures_hold_their_labels(page: Path) -> None:
    outside = """() => [...document.querySelectorAll("figure svg[role=img]")]
      .filter(svg => svg.checkVisibility()).flatMap(svg => {
      const box = svg.getBoundingClientRect();
      return [...svg.querySelectorAll("text")].filter(text => {
        const b = text.getBoundingClientRect();
        return b.left < box.left - 1 || b.right > box.right + 1 || b.top < box.top - 1 || b.bottom > box.bottom + 1;
      }).map(text => text.textContent);
    })"""
    with opened(page) as browser:
        for width in (320, 360, 768, 1200, 1280):
            browser.page.set_viewport_size({"width": width, "height": 800})
            assert not browser.sideways
            assert width not in (360, 1280) or browser.page.evaluate(outside) == []
        assert browser.findings_in_light_and_dark() == []
        assert browser.problems == []
        assert browser.outside == []


@pytest.mark.parametrize(
    ("target", "message"),
    [
        ("link.html", "the report would replace its own input"),
        ("c.toml", "the report would replace its own input"),
        ("m.csv", "the modes and the report would be the same file"),
        ("nowhere/r.html", "does not exist"),
        ("r.txt", "expected a name that ends in .html"),
    ],
)
def test_a_report_that_must_not_be_written_is_refused(
    page: Path, target: str, message: str, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = page.parent
    link = folder / "link.html"
    if not link.exists():
        link.symlink_to(folder / "x0.csv")
    before = {path: path.read_bytes() for path in folder.iterdir()}
    arguments = ["identify", str(folder / "c.toml"), "--out", str(folder / "m.csv")]
    assert run([*arguments, "--report", str(folder / target)]) == 2
    assert message in " ".join(capsys.readouterr().err.split())
    assert {path: path.read_bytes() for path in folder.iterdir()} == before


def test_missing_libraries_are_named_before_anything_is_read(
    page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    arguments = ["identify", str(page.parent / "c.toml"), "--out", str(tmp_path / "m.csv")]
    assert run([*arguments, "--report", str(tmp_path / "r.html")]) == 2
    assert "pkmodes[report]" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def test_pairs_of_labels_do_not_overlap() -> None:
    from pkmodes.pages.plots.fits import label_rows

    assert label_rows([0.1, 0.105, 0.11, 0.5], ["1", "2", "3", "4"]) == [0, 1, 2, 0]


def cells(row: Element) -> list[str]:
    return [cell.text.strip() for cell in row.children if isinstance(cell, Element)]


def test_the_added_mode_is_marked_in_the_table(page: Path) -> None:
    rows = read(page.read_text(encoding="utf-8")).by_id("record-1").all("tbody")[0].all("tr")
    assert [cells(row)[-1] for row in rows] == ["", "added"]


def test_the_files_of_a_roving_hammer_are_counted_one_by_one(tmp_path: Path) -> None:
    campaign = Path(__file__).parents[3] / "examples/roving_hammer/campaign.toml"
    command = ["identify", str(campaign), "--out", str(tmp_path / "modes.csv")]
    assert run([*command, "--report", str(tmp_path / "page.html")]) == 0
    files = len(list(campaign.parent.glob("*.uff")))
    assert files > 20
    assert f"From {files} files." in read((tmp_path / "page.html").read_text(encoding="utf-8")).text
