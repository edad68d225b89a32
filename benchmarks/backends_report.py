"""The text of `backends.py`: tables in Markdown, and their place in a document."""

from __future__ import annotations

import textwrap
from pathlib import Path
from typing import Any

import numpy as np

WRITER = "benchmarks/backends.py"
BEGIN, END = f"<!-- begin: written by {WRITER} -->", "<!-- end -->"
OURS = "pkmodes, compiled"
#: Cores that two threads must get; with fewer, other processes were in the way.
FREE = 1.8


def put(document: Path, text: str, writer: str = WRITER) -> None:
    """Replace what stands between the marks of a writer; a document that is missing is written.

    Raises
    ------
    ValueError
        If the document has no marks.
    """
    mark = BEGIN.replace(WRITER, writer)
    old = document.read_text(encoding="utf-8") if document.is_file() else f"{mark}\n{END}\n"
    head, begin, rest = old.partition(mark)
    _, end, tail = rest.partition(END)
    if not (begin and end):
        raise ValueError(f"{document} has no lines {mark} and {END}")
    document.parent.mkdir(parents=True, exist_ok=True)
    document.write_text(f"{head}{mark}\n{text}{END}{tail}", encoding="utf-8")


def text(found: dict[str, Any], machine: str | None) -> str:
    """Write all tables; `machine` says what measured."""
    one, memory = found["one"], found["memory"]
    machine = machine or f"one core with vectors of {one['machine']['width']} doubles"
    parts = [comparison(one, machine), requirements(one, found["all"]), bounds(one)]
    parts += [cores(found["all"]), memory_text(memory)] if memory else [cores(found["all"])]
    return "\n\n".join(parts) + "\n"


def table(head: list[str], rows: list[list[str]]) -> str:
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def paragraph(words: str) -> str:
    return textwrap.fill(words, 118, break_long_words=False, break_on_hyphens=False)


def digits(value: float) -> str:
    return f"{value:.2f}" if value < 10 else f"{value:.1f}" if value < 100 else f"{value:,.0f}"


def times(value: float) -> str:
    return f"{value:.1f}" if value < 10 else f"{value:,.0f}"


def comparison(one: dict[str, Any], machine: str) -> str:
    (ours,) = (row for row in one["rows"] if row["label"] == OURS)
    rows = [
        [
            row["name"],
            digits(row["frequencies"]),
            times(row["frequencies"] / ours["frequencies"]),
            digits(row["shapes"]),
            times(row["shapes"] / ours["shapes"]),
            f"{row['error']:.0e}",
        ]
        for row in one["rows"]
    ]
    head = ["way", "frequencies [us]", "ratio", "with shapes [us]", "ratio", "difference"]
    about = (
        f"Processor time per pose on {machine}; {one['poses']:,} random poses, smallest of interleaved repetitions. "
        "Ratios are to (g). The difference is the largest relative one of the vibration frequencies from "
        "those of generated NumPy and LAPACK."
    )
    gradients = f"(g) needs {digits(one['gradients'])} us for 64 gradients of all frequencies."
    return "\n\n".join([paragraph(about), table(head, rows), gradients])


def requirements(one: dict[str, Any], every: dict[str, Any]) -> str:
    row = {row["label"]: row for row in one["rows"]}
    ours, batched, loop = row[OURS], row["NumPy, batched eigh"], row["lambdify, SciPy"]
    two = every["times"].get(f"{OURS}, 2")
    more = one["gradients"] - ours["shapes"]
    wanted = [
        ("frequencies", "0.4 us", f"{digits(ours['frequencies'])} us", ours["frequencies"] <= 0.4),
        ("with shapes", "0.75 us", f"{digits(ours['shapes'])} us", ours["shapes"] <= 0.75),
        ("64 gradients, beyond shapes", "0.4 us", f"{digits(more)} us", more <= 0.4),
    ]
    for name, other, target in (("(b)", batched, 10), ("(a)", loop, 100)):
        both = [other[kind] / ours[kind] for kind in ("frequencies", "shapes")]
        wanted.append(
            (
                f"as fast as {name}, frequencies; with shapes",
                f"{target} times",
                f"{times(both[0])}; {times(both[1])} times",
                min(both) >= target,
            )
        )
    if two is not None:
        gain, name = every["times"][f"{OURS}, 1"] / two, f"second core, {every['poses']:,} poses, `out=`"
        free = "" if cores_got(every) >= FREE else " while not free"
        wanted.append((name, "1.8 times", f"{gain:.2f} times{free}", gain >= 1.8))
    rows = [[name, target, found, "met" if met else "**NOT MET**"] for name, target, found, met in wanted]
    return table(["requirement", "at most / at least", "measured", ""], rows)


def bounds(one: dict[str, Any]) -> str:
    """State the fraction of the peak, and what takes the time."""
    found, (ours,) = one["machine"], (row for row in one["rows"] if row["label"] == OURS)
    counts = found["operations"]
    total = sum(counts[name] for name in ("matrices", "reduction", "tridiagonal", "iteration"))
    lines = []
    if "fused" in found:
        rate, peak = total / found["frequencies"] / 1e3, found["fused"] / 1e9
        more = ours["shapes"] - ours["frequencies"]
        bare = 1e6 * found["three_rotations"] * found["rotations_together"] / found["together"]
        lines.append(
            f"**Peak.** Frequencies take {total:,.0f} floating-point operations: {counts['matrices']} for M, K and "
            f"the checks, {counts['reduction']:,} for the reduction, {counts['tridiagonal']:,} for the tridiagonal "
            f"form, {counts['iteration']:,.0f} for {found['iterations']:.1f} iterations of QL with "
            f"{found['rotations']:.0f} rotations (`benchmarks/operations.py`). That is {rate:.1f} Gflop/s, "
            f"{100 * rate / peak:.0f} % of the {peak:.0f} Gflop/s that the core reaches with independent "
            f"products and sums of {found['width']} doubles. Shapes add {counts['vectors']:,.0f} operations in "
            f"{more:.2f} us, {100 * counts['vectors'] / more / 1e3 / peak:.0f} % of the peak."
        )
        lines.append(
            f"**What bounds it.** Each rotation of QL has a root and a quotient on which the next one waits: "
            f"{1e9 * found['rotation']:.0f} ns for {found['width']} poses, most of it waiting. Three groups of "
            f"lanes together take {1e9 * found['three_rotations']:.0f} ns instead of {3e9 * found['rotation']:.0f}, "
            f"limited by the unit for roots and quotients. {found['together']} poses iterate until the slowest has "
            f"converged: {found['rotations_together']:.0f} rotations instead of {found['rotations']:.0f}. The "
            f"rotations alone would take {bare:.2f} us per pose; with the masks for lanes that split or have "
            f"converged, and the tests for both, QL takes {found.get('iteration', np.nan):.2f}."
        )
        lines = [paragraph(line) for line in lines]
    rows = [["poses checked (also first, where an error is raised)", found["checked"]]]
    rows.append(["M and K, checked, written to memory", found["matrices"]])
    if "iteration" in found:
        rows.append(["reduction to a standard problem", found["reduction"]])
        rows.append(["tridiagonal form", found["tridiagonal"]])
        rows.append(["QL", found["iteration"]])
    rows.append(["all of it: frequencies", found["frequencies"]])
    rows.append(["the same at equal poses, which converge together", found["same"]])
    lines.append(table(["part", "us per pose"], [[name, f"{value:.3f}"] for name, value in rows]))
    return "\n\n".join(lines)


def cores(every: dict[str, Any]) -> str:
    names = {
        f"{OURS}, {k}": f"pkmodes, {k} thread{'s' if k > 1 else ''}" for k in range(1, every["cores"] + 2)
    }
    rows = [[names.get(name, name), digits(time)] for name, time in every["times"].items()]
    got = cores_got(every)
    words = ""
    if got < FREE:
        words = (
            f"Both cores were not idle: at best, two threads got {got:.1f} of them, so these times do not say what a "
            "second core is worth."
        )
    head = f"Frequencies on {every['cores']} cores, time on the wall:"
    parts = [head, table(["way", "us per pose"], rows), paragraph(words)]
    return "\n\n".join(part for part in parts if part)


def cores_got(every: dict[str, Any]) -> float:
    """Return how many cores two threads got: processor time over time on the wall."""
    return float(every["processor"] / (every["times"][f"{OURS}, 2"] * every["poses"] / 1e6))


def memory_text(memory: list[dict[str, int]]) -> str:
    rows = [
        [f"{row['poses']:,}", f"{row['output'] / 1e6:,.1f}", f"{row['more'] / 1e6:,.1f}"] for row in memory
    ]
    head = ["poses", "output [MB]", "more [MB]"]
    about = (
        "Memory that one call with `out=` takes at most besides poses and output: a copy of the poses, 24 bytes "
        "each, and two bytes for their codes. Nothing else grows with the number of poses."
    )
    return paragraph(about) + "\n\n" + table(head, rows)
