"""Correlations in a corrected robot file: a new table, and one in the place of those that were there."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from helpers.robots.corrected_files import changed_lines, reread
from helpers.robots.robot_text import published
from pkmodes.core.base.errors import OutputError
from pkmodes.core.robot.covariance import Covariance
from pkmodes.loop.robot_files.saving import Correction, corrected_text

PATHS = ("platform.mass", "effects.payload.mass")
NEW = Covariance(PATHS, ((1.0, -0.123456789), (-0.123456789, 1.0)), (0.0123456789, 0.02))
CHANGES = {PATHS[0]: Correction(1.4, 0.0123456789), PATHS[1]: Correction(0.2, 0.05)}
#: Two tables, with comments everywhere, before another table.
OLD = """
# what the scales say
[[covariance]]  # weighed together
paths = ["platform.mass", "belt.width"]  # in this order
correlation = [
    [1, 0.5],  # by hand
    [0.5, 1],
]

# measured in March
[[covariance]]
paths = ["pulley.radius", "effects.payload.mass", "link.mass"]
sigma = ["0.1 mm", "10 g", "1 g"]
correlation = [[1, 0.2, 0.3], [0.2, 1, 0.4], [0.3, 0.4, 1]]

# where it works
[usable]
z = ["-300 mm", "-200 mm"]
"""


def saved(folder: Path, text: str, covariance: Covariance | None = NEW) -> str:
    path = folder / "robot.toml"
    path.write_bytes(text.encode("utf-8"))
    return corrected_text(path, CHANGES, covariance)


def uncertain() -> str:
    text = published()
    for value, sigma in (("1.5 kg", "0.1 kg"), ("15 mm", "1 mm"), ("35 mm", "1 mm"), ("0.7 kg", "0.1 kg")):
        text = text.replace(f'"{value}"', f'{{ value = "{value}", sigma = "{sigma}" }}', 1)
    return text + '\n[effects.payload]\nmass = { value = "0.1 kg", sigma = "0.05 kg" }\n'


def test_a_new_table_is_added_at_the_end_and_reads_back(tmp_path: Path) -> None:
    before = uncertain()
    after = saved(tmp_path, before)
    gone, new = changed_lines(before, after)
    assert len(gone) == 2
    assert after.startswith(before[: before.index('mass = { value = "1.5 kg"')])
    assert [line for line in new[2:] if line.strip()] == [
        "# correlations of the errors of the fitted values, used for frequencies and samples\n",
        "[[covariance]]\n",
        'paths = ["platform.mass", "effects.payload.mass"]\n',
        "sigma = [0.012345679, 0.02]\n",
        "correlation = [\n",
        "    [1, -0.123456789],\n",
        "    [-0.123456789, 1],\n",
        "]\n",
    ]
    robot = reread(tmp_path, after)
    (table,) = robot.covariance
    assert table.paths == PATHS
    assert table.correlation == NEW.correlation
    assert table.sigmas == pytest.approx(NEW.sigmas, rel=1e-8)
    assert robot.quantities[PATHS[1]].sigma == 0.05
    windows = saved(tmp_path, before.replace("\n", "\r\n"))
    assert windows == after.replace("\n", "\r\n")


def test_tables_with_a_changed_value_become_one_and_comments_stay(tmp_path: Path) -> None:
    before = uncertain() + OLD
    after = saved(tmp_path, before)
    (table,) = reread(tmp_path, after).covariance
    assert table.paths == (*PATHS, "belt.width", "pulley.radius", "link.mass")
    expected = np.eye(5)
    expected[:2, :2] = NEW.correlation
    expected[3, 4] = expected[4, 3] = 0.3
    np.testing.assert_allclose(table.correlation, expected, atol=1e-9)
    assert table.sigmas == pytest.approx((0.0123456789, 0.02, 0.001, 0.0001, 0.001), rel=1e-7)
    for comment in (
        "# what the scales say\n[[covariance]]  # weighed together\n",
        "  # in this order\n",
        "# measured in March\n",
        '# where it works\n[usable]\nz = ["-300 mm", "-200 mm"]\n',
    ):
        assert comment in after
    assert after.index("# what") < after.index("# measured") < after.index("# where")
    assert saved(tmp_path, after) == after  # the same once more


def test_a_table_of_other_values_stays_as_it_is(tmp_path: Path) -> None:
    other = '\n[[covariance]]\npaths = ["belt.width"]\ncorrelation = [[1]]  # alone\n'
    after = saved(tmp_path, uncertain() + other)
    assert other in after
    assert [table.paths for table in reread(tmp_path, after).covariance] == [("belt.width",), PATHS]


def test_tables_on_one_line_stay_so(tmp_path: Path) -> None:
    inline = (
        'covariance = [{ paths = ["platform.mass", "belt.width"], correlation = [[1, 0.5], [0.5, 1]] }]\n'
    )
    after = saved(tmp_path, uncertain().replace("format = 1\n", f"format = 1\n{inline}", 1))
    assert "[[covariance]]" not in after
    (table,) = reread(tmp_path, after).covariance
    assert table.paths == (*PATHS, "belt.width")


def test_without_new_correlations_the_old_ones_stay(tmp_path: Path) -> None:
    """A smaller sigma of a value that its table states otherwise would not be read: it is refused."""
    plain = OLD.replace('sigma = ["0.1 mm", "10 g", "1 g"]\n', "")
    assert saved(tmp_path, uncertain() + plain, None).endswith(plain)
    with pytest.raises(OutputError, match="would be rejected: expected a standard deviation above 0"):
        corrected_text(tmp_path / "robot.toml", {PATHS[1]: Correction(0.2, 0.001)}, NEW)
