"""What calls of a pose and of a batch take, as ratios that can be compared between machines and commits."""

from __future__ import annotations

import itertools
import subprocess
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache, partial
from pathlib import Path

import numpy as np

import backends_report
import pkmodes
from peers import BLOCK, Way, ways
from published import published, valid_poses
from timing import interleaved
from turning import machine

WRITER = "benchmarks/one_core.py"
ROOT = Path(__file__).parents[1]
#: Calls of one pose that are timed together: one alone takes not much longer than reading the clock.
CALLS = 20
BATCH = 10_000
REPETITIONS = 9
FREE, HELD = "free", "held"
EIGH = "one eigh [us]"


@dataclass(frozen=True)
class Ratio:
    """A time as a multiple of another one in the same run.

    Attributes
    ----------
    name, of : str
        Of the times.
    head : str
        First cell of its row in the table.
    most : float, optional
        What is asked.
    """

    name: str
    of: str
    head: str
    most: float | None = None


RATIOS = (
    Ratio("frequencies of a pose", "eigh", "frequencies", 1.5),
    Ratio("frequencies of a pose, held", "eigh", "frequencies, held", 1.5),
    Ratio("modes of a pose", "eigh", "modes", 3.0),
    Ratio("modes of a pose, held", "eigh", "modes, held", 3.0),
    Ratio("modes of a pose, every field read", "eigh", "modes, every field read", 3.0),
    Ratio("modes of a pose, held, every field read", "eigh", "modes, held, every field read", 6.0),
    Ratio("matrices of a pose", "eigh", "matrices", 1.5),
    Ratio("statics of a pose", "eigh", "statics", 2.0),
    Ratio("platform_jacobian of a pose", "eigh", "platform_jacobian", 2.0),
    Ratio("inverse_kinematics of a pose", "eigh", "inverse_kinematics", 2.0),
    Ratio("condition of a pose", "eigh", "condition", 2.0),
    Ratio("check of a pose", "eigh", "check"),
    Ratio("compliance of a pose", "eigh", "compliance", 10.0),
    Ratio("poles of a pose", "eigh", "poles", 10.0),
    Ratio("shaper of a pose", "eigh", "shaper", 20.0),
    Ratio("sensitivities of a pose", "eigh", "sensitivities", 60.0),
    Ratio("with_values", "eigh", "with_values", 10.0),
    Ratio("modes of a batch", "frequencies of a batch", "batch: modes", 2.0),
    Ratio("modes of a batch, held", "frequencies of a batch, held", "batch: modes, held", 2.0),
    Ratio("modes of a batch, every field read", "frequencies of a batch", "batch: every field read", 2.0),
    Ratio(
        "modes of a batch, held, every field read",
        "frequencies of a batch, held",
        "batch: every field read, held",
        2.0,
    ),
    Ratio("matrices of a batch", "frequencies of a batch", "batch: matrices", 2.0),
    Ratio("statics of a batch", "frequencies of a batch", "batch: statics", 2.0),
    Ratio("condition of a batch", "frequencies of a batch", "batch: condition", 2.0),
)
#: What is evaluated at one pose, and at a batch, with free motors.
OF_POSE = ("matrices", "statics", "platform_jacobian", "inverse_kinematics", "condition", "check")
OF_BATCH = ("matrices", "statics", "condition")
#: Rows that other implementations have, too.
OF_PEERS = ("frequencies of a pose", "modes of a pose", "frequencies of a batch", "modes of a batch")
OURS = "pkmodes"
#: Suffix of the writer in the mark of the table of other implementations.
PEERS = " peers"


def machines() -> dict[str, tuple[pkmodes.Model, np.ndarray]]:
    """Return the machines, each with its poses, by the name that follows the writer's in the mark of their table."""
    return {"": (published(), valid_poses(BATCH)), " hexapod": machine("hexapod", BATCH)}


def times(model: pkmodes.Model, poses: np.ndarray, repetitions: int = REPETITIONS) -> dict[str, float]:
    """Measure [s]: `eigh` is one `numpy.linalg.eigh` of the standard problem at a pose, n by n."""
    pose = poses[0]
    M, K = model.matrices(pose)
    inverse = np.linalg.inv(np.linalg.cholesky(M))
    standard = inverse @ K @ inverse.T
    fields = type(model.modes(pose)).fields_of(model.mechanism)
    masses = itertools.cycle([0.9, 1.1])

    def read(at: np.ndarray, drives: str) -> None:
        modes = model.modes(at, drives=drives, threads=1)
        for name in fields:
            getattr(modes, name)

    short: dict[str, Callable[[], object]] = {"eigh": partial(np.linalg.eigh, 0.5 * (standard + standard.T))}
    long: dict[str, Callable[[], object]] = {}
    for drives, word in ((FREE, ""), (HELD, ", held")):
        short[f"frequencies of a pose{word}"] = partial(model.frequencies, pose, drives=drives)
        short[f"modes of a pose{word}"] = partial(model.modes, pose, drives=drives)
        short[f"modes of a pose{word}, every field read"] = partial(read, pose, drives)
        long[f"frequencies of a batch{word}"] = partial(model.frequencies, poses, drives=drives, threads=1)
        long[f"modes of a batch{word}"] = partial(model.modes, poses, drives=drives, threads=1)
        long[f"modes of a batch{word}, every field read"] = partial(read, poses, drives)
    for name in OF_POSE:
        short[f"{name} of a pose"] = partial(getattr(model, name), pose)
    for name in OF_BATCH:
        long[f"{name} of a batch"] = partial(getattr(model, name), poses)
    short["shaper of a pose"] = partial(model.shaper, "zv", pose)
    for name in ("compliance", "poles", "sensitivities"):
        short[f"{name} of a pose"] = partial(getattr(model, name), pose)
    short["with_values"] = lambda: model.robot.with_values({"platform.mass": next(masses)})

    calls = {name: partial(_repeated, call) for name, call in short.items()} | long
    for call in calls.values():
        call()
    found = interleaved(calls, repetitions)
    return {name: time / (CALLS if name in short else 1) for name, time in found.items()}


def peer_times(
    model: pkmodes.Model, poses: np.ndarray, repetitions: int = REPETITIONS
) -> dict[str, dict[str, float]]:
    """Measure the times of other implementations for one pose and for a batch, in the same run as the library [s].

    Returns
    -------
    dict
        By implementation, the times of the rows of `OF_PEERS`; those of a batch are for all its poses.
        Implementations whose packages are missing are left out, and so is MuJoCo, whose pose takes milliseconds.
    """
    n, batch = len(model.coordinates), poses[:BLOCK]
    frequencies, shapes = np.zeros((len(batch), n)), np.zeros((len(batch), n, n))
    frequencies_of = {OURS: partial(model.frequencies, threads=1)}
    modes_of = {OURS: partial(model.modes, threads=1)}
    for way in ways():
        if isinstance(way, Way) and way.label != "MuJoCo":
            frequencies_of[way.label] = partial(_into, way, frequencies, None)
            modes_of[way.label] = partial(_into, way, frequencies, shapes)
    calls: dict[tuple[str, str], Callable[[], object]] = {}
    for name, of_ways in (("frequencies", frequencies_of), ("modes", modes_of)):
        for label, call in of_ways.items():
            pose = poses[0] if label == OURS else poses[:1]
            calls[label, f"{name} of a pose"] = partial(_repeated, partial(call, pose))
            calls[label, f"{name} of a batch"] = partial(call, batch)
    for call in calls.values():
        call()
    taken = interleaved(calls, repetitions)
    return {
        label: {row: taken[label, row] / (CALLS if row.endswith("pose") else 1) for row in OF_PEERS}
        for label in frequencies_of
    }


def _into(way: Way, frequencies: np.ndarray, shapes: np.ndarray | None, poses: np.ndarray) -> None:
    """Run another implementation, into arrays that were used before."""
    count = len(poses)
    way.run(poses, frequencies[:count], None if shapes is None else shapes[:count])


def peer_table(found: dict[str, dict[str, float]]) -> str:
    """Return the table of other implementations: multiples of the time of the library."""
    heads = [*found]  # ours first
    rows = [
        [row, *(backends_report.digits(found[label][row] / found[OURS][row]) for label in heads)]
        for row in OF_PEERS
    ]
    return backends_report.table(["call", *heads], rows)


def _repeated(call: Callable[[], object]) -> None:
    for _ in range(CALLS):
        call()


def ratios(found: dict[str, float]) -> dict[str, float]:
    """Return the ratios by the first cells of their rows."""
    return {one.head: found[one.name] / found[one.of] for one in RATIOS}


def lines(found: dict[str, float]) -> list[str]:
    """Write times and ratios for a terminal."""
    written = [f"one numpy.linalg.eigh: {1e6 * found['eigh']:.1f} us"]
    for one, ratio in zip(RATIOS, ratios(found).values(), strict=True):
        asked = (
            "" if one.most is None else f", at most {one.most:g}: {'met' if ratio <= one.most else 'NOT MET'}"
        )
        what = "one eigh" if one.of == "eigh" else one.of
        written.append(f"{one.name}: {ratio:.2f} times {what}{asked}")
    return written


def keep(found: dict[str, float], document: Path, suffix: str) -> None:
    """Add a column for the present commit to the table in a document, or replace the column.

    Parameters
    ----------
    suffix : str
        Of the writer in the mark of the table: a key of `machines`.
    """
    writer = WRITER + suffix
    begin = backends_report.BEGIN.replace(backends_report.WRITER, writer)
    text = document.read_text(encoding="utf-8").partition(begin)[2].partition(backends_report.END)[0]
    head, _, *rows = [
        [cell.strip() for cell in line.strip("|").split("|")] for line in text.split("\n") if line
    ]
    known = {row[0]: dict(zip(head[2:], row[2:], strict=True)) for row in rows}
    now = commit()
    commits = [*(one for one in head[2:] if one != now), now]
    new = {EIGH: f"{1e6 * found['eigh']:.1f}"}
    new |= {name: backends_report.digits(ratio) for name, ratio in ratios(found).items()}
    asked = {one.head: "" if one.most is None else f"{one.most:g}" for one in RATIOS}
    table = [
        [name, asked.get(name, ""), *({**known.get(name, {}), now: value}.get(one, "") for one in commits)]
        for name, value in new.items()
    ]
    whole = backends_report.table(["call", "asked, at most", *commits], table)
    backends_report.put(document, whole + "\n", writer)


def keep_peers(found: dict[str, dict[str, float]], document: Path) -> None:
    """Replace the table of other implementations in a document."""
    backends_report.put(document, peer_table(found) + "\n", WRITER + PEERS)


@cache  # before a document is changed
def commit() -> str:
    """Return the present commit, with a plus if files were changed since."""
    said = ["git", "-C", str(ROOT), "describe", "--always", "--abbrev=8", "--dirty=+", "--exclude=*"]
    return subprocess.run(said, check=True, text=True, stdout=subprocess.PIPE).stdout.strip()
