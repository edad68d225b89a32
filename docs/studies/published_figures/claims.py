"""What the paper writes about its figures 7 to 20, checked for the identified and for the declared robot.

    python docs/studies/published_figures/claims.py

writes the table in docs/explanation/published-figures.md, and the sentences with numbers below it (sentences.py).
"Upper" and "lower" are the ends of the rails with large and small x, as in docs/explanation/published-tables.md; the
paper calls this direction y in section 5 and x in section 2.
"""

from __future__ import annotations

import frequencies as f
import motions as m
import sentences
from answers import Check
from working_area import CASES, ROOT, area_of

PAGE = ROOT / "docs" / "explanation/published-figures.md"
BEGIN, END = "<!-- begin: written by docs/studies/published_figures/claims.py -->", "<!-- end -->"

#: (figure, what the paper writes, check)
CLAIMS: tuple[tuple[str, str, Check], ...] = (
    ("7", "the mean condition number of the plane is 3.5", f.condition),
    ("8", "all graphs are symmetric with respect to the central axis", f.symmetric),
    ("8", "mode 1: the maximum is in the lower half", f.extreme(1, "maximum", 0.0, 0.5)),
    ("8", "mode 1: from it the frequency decreases towards both ends", f.falls_from_its_maximum),
    ("8", "mode 1: the minimum is at the upper end", f.extreme(1, "minimum", 0.95, 1.0)),
    ("8", "mode 2: the minimum is at the upper end", f.extreme(2, "minimum", 0.95, 1.0)),
    ("8", "mode 2: the maximum is at the lower end", f.extreme(2, "maximum", 0.0, 0.05)),
    ("8", "mode 2: the frequency increases towards the lower end", f.changes(2, -1)),
    ("8", "mode 2: the gradient is larger in the lower half", f.steeper(2, "lower")),
    ("8", "mode 3: the minimum is approximately in the middle", f.extreme(3, "minimum", 0.35, 0.65)),
    ("8", "mode 3: the gradient becomes quite significant near the ends", f.steep_near_the_ends),
    ("8", "mode 4: almost symmetric also along the axis", f.symmetric_along),
    ("8", "mode 4: the maximum is at the upper end", f.extreme(4, "maximum", 0.95, 1.0)),
    ("8", "mode 4: the minimum is in the middle", f.extreme(4, "minimum", 0.35, 0.65)),
    ("8", "mode 5: a progressive increase from the lower end to the higher one", f.changes(5, 1)),
    ("8", "mode 6: the minimum is approximately in the middle", f.extreme(6, "minimum", 0.35, 0.65)),
    ("8", "mode 6: the maximum is at the lower end", f.extreme(6, "maximum", 0.0, 0.05)),
    ("8", "mode 6: the gradient is higher in the upper half", f.steeper(6, "upper")),
    ("tables", "driven pulleys move most in modes 1 to 3, free ones in modes 4 to 6", m.driven_pulleys),
    ("tables", "trucks move at least ten times as much in modes 1 to 3 as in 4 to 6", m.trucks),
    ("9-14", "the directions are symmetric with respect to the central axis", m.symmetric_directions),
    ("15-17", "the displacements of modes 1 to 3 are significant", m.significant),
    ("15", "mode 1, in plane: lower in the upper half", m.compare("in_plane", 1, "lower")),
    ("15", "mode 1, in plane: increases as y_p increases", m.compare("in_plane", 1, "upper")),
    ("15", "mode 1, vertical: decreases as y_p increases", m.compare("out_of_plane", 1, "lower")),
    ("15", "mode 1, vertical: a sudden change near the middle of the axis", m.sudden("out_of_plane", 1)),
    ("16", "mode 2, in plane: decreases as y_p increases", m.compare("in_plane", 2, "lower")),
    ("16", "mode 2, vertical: increases as y_p increases", m.compare("out_of_plane", 2, "upper")),
    ("16", "mode 2, vertical: a sudden change around the middle", m.sudden("out_of_plane", 2)),
    (
        "17",
        "mode 3, in plane: the lower half has lower values than the upper",
        m.compare("in_plane", 3, "upper"),
    ),
    ("17", "mode 3, in plane: no sudden changes", m.no_sudden),
    ("17", "mode 3, vertical: quite uniform", m.uniform),
    ("18-20", "the displacements of modes 4 to 6 are clearly negligible", m.negligible),
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


#: What the page has from here, by its first line; each part ends with `END`.
PARTS = {
    BEGIN: table,
    "<!-- begin: written by differences() of docs/studies/published_figures/sentences.py -->": sentences.differences,
    "<!-- begin: written by influences() of docs/studies/published_figures/sentences.py -->": sentences.influences,
}


def main() -> None:
    """Write the table and the sentences."""
    text = PAGE.read_text(encoding="utf-8")
    for begin, part in PARTS.items():
        before, rest = text.split(begin)
        _, after = rest.split(END, maxsplit=1)
        text = f"{before}{begin}\n{part()}{END}{after}"
    PAGE.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
