"""The sentences with numbers of docs/explanation/published-figures.md: disagreements, and dependences."""

from __future__ import annotations

from functools import cache
from textwrap import fill

import numpy as np

import pkmodes
from pkmodes.machine.maps.workspace import box_of
from pkmodes.pages.figures.quantities import relative_sensitivities
from pkmodes.pages.plots.labels import typeset
from pkmodes.pages.plots.plane import Plane
from working_area import CASES, ROOT, Area, area_of

IDENTIFIED = CASES[0]
#: Distances of the poses over which the condition number is averaged [m].
SPACINGS = (0.01, 0.005, 0.0025, 0.00125)
#: The plane of docs/figures/identified, as in the Makefile.
PLANE = {"x": np.linspace(0.29, 1.23, 95), "y": np.linspace(-0.16, 0.16, 33), "z": IDENTIFIED.z}
#: Parameters named for each mode.
LARGEST = 3


def differences() -> str:
    """Return what does not agree, and why, in Markdown."""
    area = area_of(IDENTIFIED)
    means, medians, extent = condition_numbers()
    (first, second), rise = _against(area, 2, -1)
    sixth = area.line(area.f, 6)
    interrupted = float((np.diff(area.line(area.f, 5)) <= 0.0).mean())
    slope, half = np.abs(np.diff(sixth)), len(area.f) // 2
    every = np.sqrt(area.in_plane**2 + area.out_of_plane**2)
    large = every[..., 3:].max(axis=-1) > 0.5 * every[..., :3].max(axis=-1)
    upto = area.place(int(np.flatnonzero(large.any(axis=1)).max()))
    found = [
        (
            "Figure 7",
            "The condition number grows without bound towards the singular edge of the plane, so that its mean is "
            f"decided by the poses next to that edge: for the identified robot it is {_listed(means, '.2f')} with "
            f"poses every {_listed([1e3 * s for s in SPACINGS], 'g')} mm.  The median hardly depends on the spacing: "
            f"{_listed(medians, '.2f')}, over the {extent:.2f} m\N{SUPERSCRIPT TWO} that can be reached.  The "
            "picture has the median, the table the mean of the paper's statement, every 5 mm.",
        ),
        (
            "Figure 8, mode 2",
            f"The frequency does not rise all the way to the lower end: from {_percent(first)} to "
            f"{_percent(second)} of the axis (identified), where modes 1 and 2 veer, it falls by {rise:.1f} Hz "
            "towards it.  The extremes are where the paper sees them.",
        ),
        (
            "Figure 8, mode 4",
            "Maximum and minimum are exchanged in the sentence: the paper's own tables have the minimum at the upper "
            "end and the maximum in the middle ([published tables](../explanation/published-tables.md)).",
        ),
        (
            "Figure 8, mode 5",
            f"The increase is interrupted at the lower end and near the middle, on {_percent(interrupted)} of the "
            "axis.",
        ),
        (
            "Figure 8, mode 6",
            "The two halves of the axis differ little in their slope: the lower one is "
            f"{slope[:half].mean() / slope[half:].mean():.2f} times as steep; the declared robot is nearly symmetric "
            "along the axis, so that both of its ends are maxima.",
        ),
        (
            "Figure 15, in plane",
            "The paper says both that the upper half has lower values and that the displacement increases towards "
            "the upper end.  The second is right.",
        ),
        (
            "Figure 17",
            "In mode 3 the in-plane motion does change suddenly, near the lower end where modes 3 and 4 exchange "
            "shapes (identified), or near the middle (declared), within bands that a grid of 37.5 mm hardly shows.",
        ),
        (
            "Figures 18 to 20",
            f"Negligible, except in the last {_percent(upto)} at the lower end, where modes 3 and 4 exchange shapes: "
            f"in {_percent(float(large.mean()))} of the area one of the modes 4 to 6 moves the platform more than "
            "half as much as the modes 1 to 3.",
        ),
    ]
    return "\n".join(_filled(f"* **{figure}.**  {text}", "  ") for figure, text in found) + "\n"


def influences() -> str:
    """Return what the frequencies depend on, in Markdown."""
    paths, middle = _medians()
    lines = []
    for mode, column in enumerate(middle.T, start=1):
        order = np.argsort(-np.abs(column.round(3)), kind="stable")[:LARGEST]  # ties in their own order
        lines.append(f"* mode {mode}: {', '.join(f'{_named(paths[i])} {_signed(column[i])}' for i in order)}")
    links = middle[_place(paths, "link.length")]
    first, second = np.argsort(-np.abs(links))[:2]
    lines += [
        "",
        _filled(
            f"The length of the links matters most in modes {first + 1} ({_signed(links[first])}) and {second + 1} "
            f"({_signed(links[second])}).  {_halves(paths, middle, 'motor.inertia')}  "
            f"{_halves(paths, middle, 'pulley.inertia')}"
        ),
    ]
    return "\n".join(lines) + "\n"


@cache
def condition_numbers() -> tuple[list[float], list[float], float]:
    """Return the mean and the median condition number of the plane for each spacing, and its area [m^2]."""
    model = pkmodes.load(ROOT / "robots" / f"{IDENTIFIED.name}.toml")
    low, high = box_of(model)
    means, medians, area = [], [], 0.0
    for step in SPACINGS:
        x, y = (np.arange(np.ceil(a / step), b / step) * step for a, b in zip(low[:2], high[:2], strict=True))
        found = model.map({"x": x, "y": y, "z": IDENTIFIED.z})["condition"].values
        means.append(float(np.nanmean(found)))
        medians.append(float(np.nanmedian(found)))
        area = float(np.isfinite(found).sum() * step**2)
    return means, medians, area


@cache
def _medians() -> tuple[list[str], np.ndarray]:
    """Return parameters and the median d ln f / d ln p over the plane, (parameters, modes), as in the picture."""
    model = pkmodes.load(ROOT / "robots" / f"{IDENTIFIED.name}.toml")
    plane = Plane.of(model.map(PLANE, shapes=True), ["x", "y", "z"])
    paths, relative = relative_sensitivities(model, plane, "free")
    return paths, np.median(relative[np.isfinite(relative).all(axis=(2, 3))], axis=0)


def _against(area: Area, mode: int, sign: int) -> tuple[tuple[float, float], float]:
    """Return the longest part of the axis on which a frequency changes against a sign, and by how much [Hz]."""
    line = area.line(area.f, mode)
    wrong = np.flatnonzero(sign * np.diff(line) <= 0.0)
    longest = max(np.split(wrong, np.flatnonzero(np.diff(wrong) > 1) + 1), key=len)
    start, stop = int(longest[0]), int(longest[-1]) + 1
    return (area.place(start), area.place(stop)), float(abs(line[stop] - line[start]))


def _halves(paths: list[str], middle: np.ndarray, path: str) -> str:
    """Return the influence of a parameter on the three lower and on the three upper frequencies."""
    lower, upper = np.split(middle[_place(paths, path)], 2)
    return f"`{path}` has {_between(lower)} in modes 1 to 3, and {_between(upper)} in modes 4 to 6."


def _place(paths: list[str], path: str) -> int:
    """Return the place of a parameter, which may stand with others that act alike."""
    return next(i for i, names in enumerate(paths) if path in names)


def _named(names: str) -> str:
    """Return the name of a parameter, or of those that act as one, as code."""
    return " and ".join(f"`{name}`" for name in names.split(", "))


def _between(values: np.ndarray) -> str:
    low, high = _signed(values.min()), _signed(values.max())
    return low if low == high else f"{low} to {high}"


def _signed(value: float) -> str:
    return typeset(f"{value:+.2f}")


def _filled(text: str, indent: str = "") -> str:
    """Return text in lines that are as long as those of the page."""
    return fill(text, 120, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False)


def _percent(value: float) -> str:
    return f"{100 * value:.0f} %"


def _listed(values: list[float], form: str) -> str:
    *first, last = (format(value, form) for value in values)
    return f"{', '.join(first)} and {last}"
