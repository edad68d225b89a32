"""The plot of `backends.py`: cost of a pose against the number of poses in a call."""

from __future__ import annotations

from pathlib import Path

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

OURS = "#0b5394"
PEERS = {
    "lambdify, SciPy": "#5f6368",
    "NumPy, batched eigh": "#b45f06",
    "CasADi, batched eigh": "#38761d",
    "JAX": "#8e44ad",
    "numba": "#c0392b",
    "MuJoCo": "#7f6000",
}
#: What a line is called at its end.
NAMES = {
    "pkmodes, compiled": "pkmodes: frequencies",
    "pkmodes, compiled, with shapes": "pkmodes: with shapes",
}
#: Least distance of two labels, as a ratio of costs.
APART = 1.62


def write(growth: dict[str, list[tuple[int, float]]], target: Path) -> None:
    """Write the plot as SVG, without anything that differs between runs.

    Parameters
    ----------
    growth : dict of str to list of (int, float)
        Poses in a call, and microseconds per pose.
    target : Path
    """
    mpl.rcParams.update(
        {"svg.hashsalt": "pkmodes", "font.size": 11, "font.family": "sans-serif", "axes.linewidth": 0.8}
    )
    plot = Figure(figsize=(9.0, 5.4), layout="constrained", facecolor="white")
    axes = plot.add_subplot()
    ends = {}
    for label, points in growth.items():
        sizes, costs = np.array(points).T
        own = label in NAMES
        axes.plot(
            sizes,
            costs,
            color=PEERS.get(label, OURS),
            linewidth=2.4 if own else 1.3,
            linestyle="--" if label == "pkmodes, compiled, with shapes" else "-",
            marker="o",
            markersize=4 if own else 3,
        )
        ends[label] = sizes[-1], costs[-1]
    for label, height in apart({label: cost for label, (_, cost) in ends.items()}).items():
        axes.annotate(
            NAMES.get(label, label),
            ends[label],
            xytext=(1.35e7, height),
            textcoords="data",
            verticalalignment="center",
            color=PEERS.get(label, OURS),
            fontweight="bold" if label in NAMES else "normal",
            annotation_clip=False,
            arrowprops={"arrowstyle": "-", "color": "#c8c8c8", "linewidth": 0.7, "shrinkA": 1, "shrinkB": 4},
        )
    axes.set(xscale="log", yscale="log", xlim=(0.8, 1.2e7), xlabel="poses in a call")
    axes.set_title("processor time per pose [µs], frequencies, one core", loc="left", fontsize=11)
    axes.set_xticks([10**k for k in range(8)], ["1", "10", "100", "1000", "10⁴", "10⁵", "10⁶", "10⁷"])
    top = int(np.ceil(np.log10(max(cost for points in growth.values() for _, cost in points))))
    axes.set_yticks([10.0**k for k in range(-1, top + 1)], [f"{10.0**k:g}" for k in range(-1, top + 1)])
    axes.minorticks_off()
    axes.grid(color="#e4e4e4", linewidth=0.7)
    axes.set_axisbelow(True)
    axes.spines[["top", "right"]].set_visible(False)
    target.parent.mkdir(parents=True, exist_ok=True)
    plot.savefig(
        target, metadata={"Date": None, "Creator": None} if target.suffix == ".svg" else None, dpi=110
    )


def apart(heights: dict[str, float]) -> dict[str, float]:
    """Spread labels on a logarithmic axis so that they do not touch, each as near to its place as may be."""
    order = sorted(heights, key=heights.__getitem__)
    wanted = np.log([heights[label] for label in order])
    placed, gap = wanted.copy(), np.log(APART)
    for _ in range(500):
        overlap = gap - np.diff(placed)
        for i in np.flatnonzero(overlap > 1e-6):
            placed[i] -= overlap[i] / 2
            placed[i + 1] += overlap[i] / 2
    return dict(zip(order, np.exp(placed).tolist(), strict=True))
