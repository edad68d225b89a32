"""How a mechanism is known: from its folder or an installed package, in other processes, and when it cannot be."""

from __future__ import annotations

import multiprocessing
import pickle
import re
import shutil
import sys
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.commands.adding_a_mechanism import POSE
from helpers.commands.answers import printed, refused
from pkmodes.cli import run
from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.mechanism import packages as mechanism_packages
from pkmodes.core.mechanism import registry as known


@pytest.mark.parametrize("method", ["fork", "spawn"])
def test_models_travel_to_other_processes(model: pkmodes.Model, method: str) -> None:
    loaded = model.with_values({"effects.link_compliance.compliance": 1e-6})
    assert pickle.loads(pickle.dumps(loaded)).robot == loaded.robot
    with multiprocessing.get_context(method).Pool(1) as pool:
        found = pool.map(loaded.frequencies, [POSE])
    np.testing.assert_array_equal(found[0], loaded.frequencies(POSE))


def test_a_robot_file_to_begin_with(place: Path, tmp_path: Path) -> None:
    """Its values are the sample of the definition."""
    option, file = ["--mechanism", "build/five_bar"], tmp_path / "bar.toml"
    assert f"next: pkmodes show {file} --mechanism build/five_bar" in printed(
        "new", "five_bar", *option, "--out", file
    )
    (pose,) = re.findall(r"modes FILE --pose (\S+) --mechanism FOLDER\n", file.read_text(encoding="utf-8"))
    assert printed("modes", file, "--pose", pose, *option).startswith("my-five-bar at [")


def test_a_folder_is_read_again_after_it_changed(copy: Path) -> None:
    first = known.add_folder(copy / "build/five_bar")
    assert known.add_folder(copy / "build/five_bar") is first
    description = copy / "build/five_bar/description.json"
    description.write_text(description.read_text().replace('"title": "two arms', '"title": "both arms'))
    assert known.add_folder(copy / "build/five_bar").title.startswith("both arms")


def test_an_installed_package_is_known_by_its_entry_point(
    copy: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    package = copy / "site" / "my_robots"
    shutil.copytree(copy / "build" / "five_bar", package / "five_bar")
    (package / "__init__.py").write_text("")
    metadata = copy / "site" / "my_robots-1.dist-info"
    metadata.mkdir()
    (metadata / "METADATA").write_text("Metadata-Version: 2.1\nName: my-robots\nVersion: 1\n")
    points = (
        "[pkmodes.mechanisms]\nfive_bar = my_robots.five_bar\ncorexy = my_robots.five_bar\nlost = nowhere\n"
    )
    (metadata / "entry_points.txt").write_text(points)
    monkeypatch.syspath_prepend(str(copy / "site"))
    mechanism_packages.installed_packages.cache_clear()
    try:
        robot = pkmodes.read_robot(copy / "robot.toml")
        assert robot.mechanism.package == "my_robots.five_bar"
        assert known.mechanism("corexy").package != "my_robots.five_bar"
        assert run(["check", str(copy / "robot.toml")]) == 0
        with pytest.raises(PkmodesError, match=r"cannot read the description .* \(package nowhere\)"):
            known.mechanism("lost")
    finally:
        mechanism_packages.installed_packages.cache_clear()
        for name in [name for name in sys.modules if name.startswith("my_robots")]:
            del sys.modules[name]


def test_folders_that_are_none(copy: Path) -> None:
    def said(folder: str) -> str:
        return refused("modes", "--mechanism", folder, "robot.toml", "--pose", "0.03,-0.42")

    assert "no such folder (nowhere); give the folder DIR/<mechanism>" in said("nowhere")
    assert "found a file (five_bar.py); give the folder DIR/<mechanism>" in said("five_bar.py")
    assert "give the mechanism folder inside it: build/five_bar" in said("build")
    file = copy / "build/five_bar/extended.py"
    whole = file.read_text()
    file.write_text(whole + "\nraise ValueError('broken')\n")
    assert "the generated code cannot be imported: ValueError: broken" in said("build/five_bar")
    error = refused("modes", "robot.toml", "--pose", "0.03,-0.42")
    assert (
        f'unknown mechanism "five_bar" (robot.toml: mechanism); known: {", ".join(known.supplied_names())}; '
        in error
    )
    assert "--mechanism" in error
    file.write_text("")
    assert "AttributeError: module" in said("build/five_bar")
    file.write_text("raise SystemExit(0)\n")
    assert "the generated code cannot be imported: SystemExit: 0" in said("build/five_bar")
    file.write_text(whole)
    description = copy / "build/five_bar/description.json"
    shutil.copytree(copy / "build/five_bar", copy / "taken")
    text = description.read_text().replace('"mechanism": "five_bar"', '"mechanism": "corexy"')
    description.write_text(text)
    assert '"corexy" is already the name of a mechanism supplied with pkmodes' in said("build/five_bar")
