"""Where a map may be written, and what is refused before anything is computed."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

import pytest
import xarray
import zarr

from helpers.commands.map_runs import model
from pkmodes.core.base.errors import OutputError
from pkmodes.machine.maps.storage import GROUP_NAME, LOCK_NAME

POSE = {"x": 0.6, "y": 0.0, "z": -0.245}
OTHER = {"x": 0.5, "y": 0.0, "z": -0.245}


def refused(out: object, **options: object) -> OutputError:
    with pytest.raises(OutputError) as error:
        model().map(POSE, out=out, **options)  # type: ignore[arg-type]
    return error.value


@pytest.mark.parametrize("name", ["map", "map.txt", "map.nc.gz", "map.toml", "", ".nc", "map.h5", "a\0.nc"])
def test_the_name_says_the_format(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    monkeypatch.chdir(tmp_path)
    error = refused(name)
    assert "expected a name that ends in .nc, .zarr, .csv or .parquet" in error.what
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("out", [5, b"map.nc", True, ["map.nc"]])
def test_what_is_no_name(out: object) -> None:
    assert "expected the name of a file" in refused(out).what


def test_a_missing_folder(tmp_path: Path) -> None:
    assert refused(tmp_path / "nowhere" / "map.nc").what == f"the folder {tmp_path}/nowhere does not exist"


@pytest.mark.parametrize("name", ["map.nc", "map.zarr", "map.csv", "map.parquet"])
def test_an_existing_output_is_replaced_only_if_asked(tmp_path: Path, name: str) -> None:
    out = tmp_path / name
    first = model().map(POSE, out=out).load()
    error = refused(out)
    assert error.what == f"{out}: the output exists"
    assert "--overwrite" in error.remedy
    with model().map(OTHER, out=out, overwrite=True) as found:
        assert float(found["x"][0]) == 0.5
        assert not first.identical(found)
    assert [one.name for one in tmp_path.iterdir()] == [name]


def test_a_map_that_is_open_elsewhere_can_be_replaced(tmp_path: Path) -> None:
    out = tmp_path / "map.nc"
    with model().map(POSE, out=out) as first, model().map(OTHER, out=out, overwrite=True) as second:
        assert float(first["x"][0]) == 0.6
        assert float(second["x"][0]) == 0.5


def test_other_things_of_that_name_are_left_alone(tmp_path: Path) -> None:
    (tmp_path / "folder.nc").mkdir()
    (tmp_path / "file.zarr").write_text("mine")
    (tmp_path / "mine.zarr").mkdir()
    (tmp_path / "mine.zarr" / "notes.txt").write_text("mine")
    for name, what in (
        ("folder.nc", "expected a file, found a folder"),
        ("file.zarr", "expected a folder, found a file"),
        ("mine.zarr", "the folder to replace does not hold a Zarr store"),
    ):
        assert refused(tmp_path / name, overwrite=True).what == what
    assert (tmp_path / "mine.zarr" / "notes.txt").read_text() == "mine"


@pytest.mark.parametrize("place", ["notes.txt", "frequency/notes.txt", "pictures/first.svg", "7"])
def test_a_store_that_holds_something_else_is_not_replaced(tmp_path: Path, place: str) -> None:
    out = tmp_path / "map.zarr"
    model().map(POSE, out=out).close()
    mine = out / place
    mine.parent.mkdir(exist_ok=True)
    mine.write_text("mine")
    error = refused(out, overwrite=True)
    held = place.partition("/")[0] if place.startswith("pictures") else place
    assert error.what == f'the folder to replace holds "{held}", which is no part of the map'
    assert error.remedy == "move that away, or choose another name"
    assert mine.read_text() == "mine"


@pytest.mark.parametrize("zarr_format", [2, 3])
def test_a_store_of_either_format_is_replaced_whole(tmp_path: Path, zarr_format: Literal[2, 3]) -> None:
    """With several pieces of an array, as zarr itself lays them out."""
    group = zarr.create_group(tmp_path / "map.zarr", zarr_format=zarr_format)
    array = group.create_array("values", shape=(4, 4), chunks=(2, 2), dtype="f8")
    array[:] = 1.0
    assert len([one for one in (tmp_path / "map.zarr").rglob("*") if one.is_file()]) > 4
    model().map(POSE, out=tmp_path / "map.zarr", overwrite=True).close()
    assert not (tmp_path / "map.zarr" / "values").exists()


def test_something_in_the_place_of_the_folder_for_interrupted_maps(tmp_path: Path) -> None:
    (tmp_path / "map.nc.partial").write_text("mine")
    error = refused(tmp_path / "map.nc")
    assert error.what == "expected a folder for the map in progress, found a file"
    assert error.where == str(tmp_path / "map.nc.partial")
    assert error.remedy == "move or rename it, or choose another output"
    assert (tmp_path / "map.nc.partial").read_text() == "mine"


def test_a_folder_of_the_user_with_the_name_of_that_for_interrupted_maps(tmp_path: Path) -> None:
    """Nothing in it is touched, whatever its files are called."""
    mine = tmp_path / "map.nc.partial"
    mine.mkdir()
    for name in ("thesis.tex", GROUP_NAME, "lock"):
        (mine / name).write_text("mine")
    error = refused(tmp_path / "map.nc")
    assert (
        error.what == 'expected a folder for the map in progress, found one with other files ("fields.zarr")'
    )
    assert error.where == str(mine)
    assert error.remedy == "move or rename it, or choose another output"
    assert {file.name: file.read_text() for file in mine.iterdir()} == dict.fromkeys(
        ("thesis.tex", GROUP_NAME, "lock"), "mine"
    )


def test_a_file_that_the_user_adds_to_an_interrupted_map_survives_it(tmp_path: Path) -> None:
    mine = tmp_path / "map.nc.partial"
    mine.mkdir()
    (mine / LOCK_NAME).touch()
    (mine / "notes.txt").write_text("mine")
    model().map(POSE, out=tmp_path / "map.nc").close()
    assert [(file.name, file.read_text()) for file in mine.iterdir() if file.name != LOCK_NAME] == [
        ("notes.txt", "mine")
    ]


def test_a_link_in_the_place_of_the_folder_for_interrupted_maps(tmp_path: Path) -> None:
    (tmp_path / "elsewhere").mkdir()
    (tmp_path / "map.nc.partial").symlink_to(tmp_path / "elsewhere")
    error = refused(tmp_path / "map.nc")
    assert error.what == "expected a folder for the map in progress, found a symbolic link"
    assert not list((tmp_path / "elsewhere").iterdir())
    (tmp_path / "map.nc.partial").unlink()
    (tmp_path / "map.nc.partial").symlink_to(tmp_path / "nowhere")
    assert refused(tmp_path / "map.nc").what == error.what
    assert not (tmp_path / "nowhere").exists()


@pytest.mark.parametrize(
    "name", [LOCK_NAME, GROUP_NAME, f"{GROUP_NAME}/frequency", f"{GROUP_NAME}/frequency/zarr.json", "new.nc"]
)
def test_links_in_a_received_folder_are_not_followed(tmp_path: Path, name: str) -> None:
    other, folder = tmp_path / "other", tmp_path / "map.nc.partial"
    other.write_text("mine")
    folder.mkdir()
    (folder / LOCK_NAME).touch()
    (folder / name).unlink(missing_ok=True)
    (folder / name).parent.mkdir(parents=True, exist_ok=True)
    (folder / name).symlink_to(other)
    assert "found a link or device" in refused(tmp_path / "map.nc").what
    assert other.read_text() == "mine"


def test_a_link_to_another_suffix_is_refused(tmp_path: Path) -> None:
    (tmp_path / "map.nc").symlink_to(tmp_path / "thesis.tex")
    error = refused(tmp_path / "map.nc")
    assert error.what.startswith(
        "expected a link to a name that ends in .nc, .zarr, .csv or .parquet, found "
    )
    assert not (tmp_path / "thesis.tex").exists()


def test_a_link_to_itself_is_refused(tmp_path: Path) -> None:
    (tmp_path / "map.nc").symlink_to(tmp_path / "map.nc")
    assert "symbolic links that lead back to themselves" in refused(tmp_path / "map.nc").what


def test_a_folder_that_cannot_be_written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """As another user would see it: tests may run as root, whom permissions do not stop."""
    real = Path.mkdir

    def denied(self: Path, *arguments: object, **options: object) -> None:
        if self.name.endswith(".partial"):
            raise PermissionError(13, "Permission denied", str(self))
        real(self, *arguments, **options)  # type: ignore[arg-type]

    monkeypatch.setattr(Path, "mkdir", denied)
    error = refused(tmp_path / "map.nc")
    assert error.what == "cannot write: permission denied"
    assert error.where == str(tmp_path / "map.nc.partial")
    monkeypatch.setattr("os.access", lambda *_: False)
    assert refused(tmp_path / "map.nc").what == "cannot write: permission denied"


def test_a_link_is_followed(tmp_path: Path) -> None:
    (tmp_path / "real").mkdir()
    (tmp_path / "link.nc").symlink_to(tmp_path / "real" / "map.nc")
    model().map(POSE, out=tmp_path / "link.nc").close()
    assert (tmp_path / "link.nc").is_symlink()
    with xarray.open_dataset(tmp_path / "real" / "map.nc") as found:
        assert found.sizes["mode"] == 6


@pytest.mark.parametrize("name", ["a b.nc", "größe #1.nc", "x;y.zarr", "-.nc", "file:x.nc", "MAP.NC"])
def test_unusual_names(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    monkeypatch.chdir(tmp_path)
    with model().map(POSE, out=name) as found:
        assert found.sizes["mode"] == 6
    assert [one.name for one in tmp_path.iterdir()] == [name]


def test_nothing_is_left_where_nothing_was_begun(tmp_path: Path) -> None:
    with pytest.raises(Exception, match="none of the 1 poses"):
        model().map({**POSE, "x": 5.0}, out=tmp_path / "map.nc")
    assert list(tmp_path.iterdir()) == []


def test_an_old_store_is_put_back_where_the_new_one_cannot_take_its_place(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out = tmp_path / "map.zarr"
    model().map(POSE, out=out).close()
    real = Path.replace

    def fails(self: Path, target: Path) -> Path:
        if target == out:
            raise OSError(5, "Input/output error")
        return real(self, target)

    monkeypatch.setattr(Path, "replace", fails)
    assert "input/output error" in refused(out, overwrite=True).what
    with xarray.open_dataset(out) as kept:
        assert float(kept["x"][0]) == 0.6


def test_an_old_store_is_put_back_after_a_kill_between_the_two_renames(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out, folder = tmp_path / "map.zarr", tmp_path / "map.zarr.partial"
    model().map(POSE, out=out).close()
    folder.mkdir()
    (folder / LOCK_NAME).touch()
    out.rename(folder / "replaced.zarr")

    def full(*_: object, **__: object) -> None:
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(xarray.Dataset, "to_zarr", full)
        assert "no space left" in refused(out).what
    with xarray.open_dataset(out) as kept:
        assert float(kept["x"][0]) == 0.6
    model().map(POSE, out=out, overwrite=True).close()
    assert [one.name for one in tmp_path.iterdir()] == ["map.zarr"]
