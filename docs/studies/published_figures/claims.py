"""What the paper writes about its figures 7 to 20, checked for the identified and for the declared robot.

    python docs/studies/published_figures/claims.py

writes the table in docs/figures.md.  "Upper" and "lower" are the ends of the rails with large and small x, as in the
published tables (docs/published-tables.md); the paper calls this direction y in section 5 and x in section 2.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import pkmodes
from pkmodes.workspace import box_of

ROOT = Path(__file__).parents[3]
PAGE = ROOT / "docs" / "figures.md"
BEGIN, END = "<!-- begin: written by docs/studies/published_figures/claims.py -->", "<!-- end -->"
#: Length of the line over which a change counts as sudden.
SUDDEN = 0.05
#: Distance of the poses over which the condition number is averaged [m].
STEP = 0.005


@dataclass(frozen=True)
class Case:
    """A robot on its useful working area: the plane without boundary effects.

    Attributes
    ----------
    name : str
    ends : tuple of float
        Range of x [m]: docs/published-tables.md.
    side : float
        Largest distance from the central axis [m].
    z : float
        Height of the plane [m].
    """

    name: str
    ends: tuple[float, float]
    side: float
    z: float


CASES = (
    Case("linear-delta-2022-identified", (0.35, 1.1375), 0.15, -0.24383544),
    Case("linear-delta-2022", (0.365, 0.764), 0.10, -0.245),
)


@dataclass(frozen=True, eq=False)
class Area:
    """The modes over a working area; y has an odd number of values, the middle one on the central axis.

    Attributes
    ----------
    f, in_plane, out_of_plane : ndarray, shape (x, y, mode)
    p : ndarray, shape (x, y, mode, 3)
        Directions of the platform's motion, unit vectors.
    shape : ndarray, shape (x, y, mode, 9)
    condition : float
        Mean condition number of the whole plane, every 5 mm.
    radius : float
        Of the pulleys [m].
    """

    f: np.ndarray
    in_plane: np.ndarray
    out_of_plane: np.ndarray
    p: np.ndarray
    shape: np.ndarray
    condition: float
    radius: float

    def line(self, values: np.ndarray, mode: int) -> np.ndarray:
        """Return values of a mode, from 1, along the central axis."""
        return values[:, values.shape[1] // 2, mode - 1]

    def place(self, index: int) -> float:
        """Return a place along the axis from 0, the lower end, to 1, the upper end."""
        return index / (len(self.f) - 1)

    def halves(self, values: np.ndarray, mode: int) -> tuple[float, float]:
        """Return the means of a mode, from 1, over the lower and the upper half of the area."""
        one, half = values[..., mode - 1], len(self.f) // 2
        return float(np.nanmean(one[:half])), float(np.nanmean(one[-half:]))

    def jump(self, values: np.ndarray, mode: int) -> tuple[float, float]:
        """Return the largest change over 5 % of the axis, relative to the range, and where it is."""
        line, step = self.line(values, mode), max(1, round(SUDDEN * (len(self.f) - 1)))
        change = np.abs(line[step:] - line[:-step])
        return float(change.max() / np.ptp(line)), self.place(int(change.argmax()) + step // 2)


def area_of(case: Case) -> Area:
    """Evaluate a robot over its working area."""
    model = pkmodes.load(ROOT / "robots" / f"{case.name}.toml")
    grid = {"x": np.linspace(*case.ends, 211), "y": np.linspace(-case.side, case.side, 41), "z": case.z}
    found = model.map(grid, shapes=True).squeeze("z").transpose("x", "y", ...)
    low, high = box_of(model)
    steps = [np.arange(np.ceil(a / STEP), b / STEP) * STEP for a, b in zip(low[:2], high[:2], strict=True)]
    plane = model.map({"x": steps[0], "y": steps[1], "z": case.z})
    motion = found["platform_shape"].values
    return Area(
        found["frequency"].values,
        found["in_plane"].values,
        found["out_of_plane"].values,
        motion / np.linalg.norm(motion, axis=-1, keepdims=True),
        found["shape"].values,
        float(plane["condition"].mean()),
        model.robot.quantities["pulley.radius"].value,
    )


Answer = tuple[bool, str]
Check = Callable[[Area], Answer]


def percent(value: float) -> str:
    """Format a ratio."""
    return f"{100 * value:.0f} %"


def extreme(mode: int, which: str, low: float, high: float) -> Check:
    """Check where a frequency is extreme along the axis: between two places from 0 to 1."""

    def check(area: Area) -> Answer:
        line = area.line(area.f, mode)
        at = area.place(int(line.argmin() if which == "minimum" else line.argmax()))
        return low <= at <= high, f"{which} at {percent(at)}"

    return check


def falls_from_its_maximum(area: Area) -> Answer:
    """Check that mode 1 falls from its maximum towards both ends."""
    line = area.line(area.f, 1)
    top = int(line.argmax())
    wrong = max(np.diff(line[: top + 1]).min() * -1, np.diff(line[top:]).max(), 0.0)
    return bool(wrong <= 1e-9), f"{line[0]:.1f}, {line[top]:.1f}, {line[-1]:.1f} Hz"


def steeper(mode: int, half: str) -> Check:
    """Check that the mean slope of a frequency is larger in one half of the axis."""

    def check(area: Area) -> Answer:
        slope, middle = np.abs(np.diff(area.line(area.f, mode))), len(area.f) // 2
        lower, upper = float(slope[:middle].mean()), float(slope[middle:].mean())
        ratio = lower / upper if half == "lower" else upper / lower
        return ratio > 1.0, f"{ratio:.1f} times"

    return check


def falls(mode: int) -> Check:
    """Check that a frequency falls from the lower to the upper end, on 99 % of the axis."""

    def check(area: Area) -> Answer:
        share = float((np.diff(area.line(area.f, mode)) < 0).mean())
        return share > 0.99, f"on {percent(share)} of the axis"

    return check


def rises(mode: int) -> Check:
    """Check that a frequency rises from the lower to the upper end, on 99 % of the axis."""

    def check(area: Area) -> Answer:
        holds, text = falls(mode)(Area(-area.f, *(getattr(area, n) for n in list(area.__dict__)[1:])))
        return holds, text

    return check


def steep_near_the_ends(area: Area) -> Answer:
    """Check that mode 3 is at least twice as steep in the outer fifths of the axis as in the middle."""
    slope = np.abs(np.diff(area.line(area.f, 3)))
    fifth = len(slope) // 5
    ratio = float(
        np.concatenate([slope[:fifth], slope[-fifth:]]).mean() / slope[2 * fifth : -2 * fifth].mean()
    )
    return ratio > 2.0, f"{ratio:.0f} times the middle"


def symmetric_along(area: Area) -> Answer:
    """Check that mode 4 is the same within 5 % when the axis is reversed."""
    line = area.line(area.f, 4)
    difference = float(np.abs(line - line[::-1]).max() / line.mean())
    return difference < 0.05, f"within {100 * difference:.1f} %"


def symmetric(area: Area) -> Answer:
    """Check that all frequencies are the same on both sides of the axis."""
    difference = float(np.nanmax(np.abs(area.f - area.f[:, ::-1]) / area.f))
    return difference < 1e-9, "to 1e-9" if difference < 1e-9 else f"only to {difference:.0e}"


def symmetric_directions(area: Area) -> Answer:
    """Check that directions on both sides of the axis are mirror images."""
    mirrored = area.p[:, ::-1] * [1.0, -1.0, 1.0]
    same = np.abs((area.p * mirrored).sum(axis=-1))
    inside = np.isfinite(same)
    share = float((same[inside] > 1 - 1e-6).mean())
    return share > 0.99, f"{100 * share:.1f} % of the poses"


def condition(area: Area) -> Answer:
    """Check that the mean condition number is between 3 and 4."""
    return 3.0 <= area.condition <= 4.0, f"{area.condition:.2f}"


def driven_pulleys(area: Area) -> Answer:
    """Pulleys 1,1, 2,2 and 3,2 are driven; coordinates as in equation 32, lengths divided by the radius."""
    driven, free = [3, 7, 8], [6, 4, 5]
    size = np.abs(area.shape)[np.isfinite(area.f).all(axis=-1)][:, None]
    low = size[:, :, :3][..., driven].max(axis=-1) > size[:, :, :3][..., free].max(axis=-1)
    high = size[:, :, 3:][..., free].max(axis=-1) > size[:, :, 3:][..., driven].max(axis=-1)
    share = float(np.concatenate([low, high], axis=-1).mean())
    return share > 0.9, f"{percent(share)} of the modes"


def trucks(area: Area) -> Answer:
    """Compare trucks of shapes whose largest component is 1, as in the tables."""
    size = np.abs(area.shape)[np.isfinite(area.f).all(axis=-1)]
    size[..., :3] /= area.radius
    relative = (size / size.max(axis=-1, keepdims=True))[..., :3].max(axis=-1)
    ratio = float(np.median(relative[..., :3].max(axis=-1) / relative[..., 3:].max(axis=-1)))
    return ratio >= 10.0, f"{ratio:.0f} times, median"


def significant(area: Area) -> Answer:
    """Check that the platform moves at least twice as much in modes 1 to 3 as in any other."""
    every = np.sqrt(area.in_plane**2 + area.out_of_plane**2)
    ratio = float(np.nanmedian(every[..., :3].min(axis=-1) / every[..., 3:].max(axis=-1)))
    return ratio > 2.0, f"{ratio:.1f} times modes 4 to 6, median"


def negligible(area: Area) -> Answer:
    """Check that the platform moves less than a quarter as much in modes 4 to 6, at 90 % of the poses."""
    every = np.sqrt(area.in_plane**2 + area.out_of_plane**2)
    share = float(np.nanquantile(every[..., 3:].max(axis=-1) / every[..., :3].max(axis=-1), 0.9))
    return share < 0.25, f"below {percent(share)} of modes 1 to 3, at 90 % of the poses"


def compare(field: str, mode: int, larger: str) -> Check:
    """Check in which half of the area a component is larger."""

    def check(area: Area) -> Answer:
        lower, upper = area.halves(getattr(area, field), mode)
        holds = lower > upper if larger == "lower" else upper > lower
        return holds, f"lower {lower:.2f}, upper {upper:.2f}"

    return check


def sudden(field: str, mode: int) -> Check:
    """Check that a component changes by 40 % of its range within 5 % of the axis, near the middle."""

    def check(area: Area) -> Answer:
        change, at = area.jump(getattr(area, field), mode)
        return change > 0.4 and 0.3 <= at <= 0.7, f"{percent(change)} of the range at {percent(at)}"

    return check


def no_sudden(area: Area) -> Answer:
    """Check that mode 3 has no such change."""
    change, at = area.jump(area.in_plane, 3)
    return change <= 0.4, f"{percent(change)} of the range at {percent(at)}"


def uniform(area: Area) -> Answer:
    """Check that 80 % of the values are within half of the median."""
    values = area.out_of_plane[..., 2]
    spread = float((np.nanquantile(values, 0.9) - np.nanquantile(values, 0.1)) / np.nanmedian(values))
    return spread < 0.5, f"10 to 90 % quantiles within {percent(spread)} of the median"


#: (figure, what the paper writes, check)
CLAIMS: tuple[tuple[str, str, Check], ...] = (
    ("7", "the mean condition number of the plane is 3.5", condition),
    ("8", "all graphs are symmetric with respect to the central axis", symmetric),
    ("8", "mode 1: the maximum is in the lower half", extreme(1, "maximum", 0.0, 0.5)),
    ("8", "mode 1: from it the frequency decreases towards both ends", falls_from_its_maximum),
    ("8", "mode 1: the minimum is at the upper end", extreme(1, "minimum", 0.95, 1.0)),
    ("8", "mode 2: the minimum is at the upper end", extreme(2, "minimum", 0.95, 1.0)),
    ("8", "mode 2: the maximum is at the lower end", extreme(2, "maximum", 0.0, 0.05)),
    ("8", "mode 2: the frequency increases towards the lower end", falls(2)),
    ("8", "mode 2: the gradient is larger in the lower half", steeper(2, "lower")),
    ("8", "mode 3: the minimum is approximately in the middle", extreme(3, "minimum", 0.35, 0.65)),
    ("8", "mode 3: the gradient becomes quite significant near the ends", steep_near_the_ends),
    ("8", "mode 4: almost symmetric also along the axis", symmetric_along),
    ("8", "mode 4: the maximum is at the upper end", extreme(4, "maximum", 0.95, 1.0)),
    ("8", "mode 4: the minimum is in the middle", extreme(4, "minimum", 0.35, 0.65)),
    ("8", "mode 5: a progressive increase from the lower end to the higher one", rises(5)),
    ("8", "mode 6: the minimum is approximately in the middle", extreme(6, "minimum", 0.35, 0.65)),
    ("8", "mode 6: the maximum is at the lower end", extreme(6, "maximum", 0.0, 0.05)),
    ("8", "mode 6: the gradient is higher in the upper half", steeper(6, "upper")),
    ("tables", "driven pulleys move most in modes 1 to 3, free ones in modes 4 to 6", driven_pulleys),
    ("tables", "trucks move at least ten times as much in modes 1 to 3 as in 4 to 6", trucks),
    ("9-14", "the directions are symmetric with respect to the central axis", symmetric_directions),
    ("15-17", "the displacements of modes 1 to 3 are significant", significant),
    ("15", "mode 1, in plane: lower in the upper half", compare("in_plane", 1, "lower")),
    ("15", "mode 1, in plane: increases as y_p increases", compare("in_plane", 1, "upper")),
    ("15", "mode 1, vertical: decreases as y_p increases", compare("out_of_plane", 1, "lower")),
    ("15", "mode 1, vertical: a sudden change near the middle of the axis", sudden("out_of_plane", 1)),
    ("16", "mode 2, in plane: decreases as y_p increases", compare("in_plane", 2, "lower")),
    ("16", "mode 2, vertical: increases as y_p increases", compare("out_of_plane", 2, "upper")),
    ("16", "mode 2, vertical: a sudden change around the middle", sudden("out_of_plane", 2)),
    (
        "17",
        "mode 3, in plane: the lower half has lower values than the upper",
        compare("in_plane", 3, "upper"),
    ),
    ("17", "mode 3, in plane: no sudden changes", no_sudden),
    ("17", "mode 3, vertical: quite uniform", uniform),
    ("18-20", "the displacements of modes 4 to 6 are clearly negligible", negligible),
)


def table() -> str:
    """Return the table of claims in Markdown."""
    areas = [area_of(case) for case in CASES]
    lines = ["| figure | the paper | identified robot | declared robot |", "| --- | --- | --- | --- |"]
    counts = [0, 0]
    for figure, sentence, check in CLAIMS:
        cells = []
        for i, area in enumerate(areas):
            holds, text = check(area)
            counts[i] += holds
            cells.append(f"{'yes' if holds else '**no**'}: {text}")
        lines.append(f"| {figure} | {sentence} | {' | '.join(cells)} |")
    total = len(CLAIMS)
    lines.append(f"| | **agree** | **{counts[0]} of {total}** | **{counts[1]} of {total}** |")
    return "\n".join(lines) + "\n"


def main() -> None:
    """Write the table."""
    text = PAGE.read_text(encoding="utf-8")
    before, rest = text.split(BEGIN)
    _, after = rest.split(END)
    PAGE.write_text(f"{before}{BEGIN}\n{table()}{END}{after}", encoding="utf-8")


if __name__ == "__main__":
    main()
