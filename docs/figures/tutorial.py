"""Draw the pictures of docs/tutorial/tutorial.md: its machine at a pose, frequencies, a mode, and the residual.

    python docs/figures/tutorial.py [FOLDER]

writes them next to this file, or into another folder.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path

import matplotlib as mpl
import matplotlib.lines
import numpy as np
from matplotlib.figure import Figure

import pkmodes
from pkmodes import updating
from pkmodes.figures import pictures
from pkmodes.figures.files import image_bytes
from pkmodes.pages.plots.animation import animation
from pkmodes.view import scene

HERE = Path(__file__).parent
LOOP = HERE.parents[1] / "examples" / "closed_loop"
POSE = (0.6, 0.0, -0.245)
#: Okabe and Ito's colours: told apart with any colour vision.
COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9")
STYLE = {
    "font.size": 10,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.color": "#d8d8d8",
    "grid.linewidth": 0.6,
    "legend.frameon": False,
    "svg.fonttype": "none",
    "svg.hashsalt": "pkmodes",
    "font.family": "sans-serif",
}


def machine(model: pkmodes.Model) -> Figure:
    """Draw rails, carriages, linkages and platform from above and from the side."""
    robot = model.robot.parameters
    origins, directions = robot.origin, robot.direction
    low, high = robot.limits.T
    slides = model.modes(POSE, fields=["joint_positions"]).joint_positions
    carriages = origins + slides[:, None] * directions
    joints = np.array(POSE) + robot.joint
    figure = Figure(figsize=(5.4, 4.8), layout="constrained")
    above, side = figure.subplots(2, 1, sharex=True, height_ratios=(0.6, 0.38))
    for axes, vertical, name in ((above, 1, "y"), (side, 2, "z")):
        for j in range(3):
            ends = origins[j] + np.outer((low[j], high[j]), directions[j])
            axes.plot(ends[:, 0], ends[:, vertical], color="#8c8c8c", lw=4, solid_capstyle="butt", zorder=1)
            link = np.array([carriages[j], joints[j]])
            axes.plot(link[:, 0], link[:, vertical], color=COLOURS[j], lw=2, zorder=2)
            axes.plot(*carriages[j, [0, vertical]], "s", color=COLOURS[j], ms=9, zorder=3)
            if axes is above:
                axes.annotate(
                    f"carriage {j + 1}",
                    carriages[j, :2],
                    (0, -20 if j == 1 else 10),
                    textcoords="offset points",
                    ha="center",
                    color=COLOURS[j],
                )
        axes.plot(POSE[0], POSE[vertical], "o", color="black", ms=8, zorder=4)
        axes.set(aspect="equal", ylabel=f"{name} [m]")
        axes.set_ylim((-0.3, 0.3) if axes is above else (-0.3, 0.08))
    above.annotate("platform", POSE[:2], (12, -16), textcoords="offset points")
    above.set_title("from above", loc="left")
    side.set_title("from the side", loc="left")
    side.set_xlabel("x [m]")
    return figure


def frequencies(model: pkmodes.Model) -> Figure:
    """Plot the six vibration modes along the centre line of the working plane."""
    x = np.linspace(0.33, 0.87, 271)
    poses = np.stack([x, np.zeros_like(x), np.full_like(x, POSE[2])], axis=-1)
    found = model.frequencies(poses, on_error="nan")[:, 3:]
    figure = Figure(figsize=(5.4, 3.4), layout="constrained")
    axes = figure.subplots()
    for values, colour in zip(found.T, COLOURS, strict=True):
        axes.plot(x, values, color=colour, lw=1.8)
    for modes, height in together(found[-1]):
        axes.annotate(modes, (x[-1], height), (6, 0), textcoords="offset points", va="center")
    axes.axvline(POSE[0], color="black", lw=0.8, ls=":")
    axes.set(xlabel="x of the platform [m]", ylabel="frequency [Hz]", ylim=(0, None))
    axes.set_title("vibration modes along y = 0, z = -0.245 m", loc="left")
    return figure


def together(values: np.ndarray, apart: float = 10.0) -> list[tuple[str, float]]:
    """Return one label and height for each group of modes whose curves end close together."""
    groups: list[list[int]] = []
    for mode, value in enumerate(values):
        if groups and value - values[groups[-1][-1]] < apart:
            groups[-1].append(mode)
        else:
            groups.append([mode])
    return [
        (f"mode{'s' if group[1:] else ''} {', '.join(str(m + 1) for m in group)}", values[group].mean())
        for group in groups
    ]


def residual(model: pkmodes.Model) -> Figure:
    """Plot prediction minus measurement of every row, before and after the diagnosis."""
    result = updating.diagnose(model.robot, updating.read(LOOP / "measured.csv", robot=model))
    content = result.as_json()
    figure = Figure(figsize=(5.4, 3.4), layout="constrained")
    left, right = figure.subplots(1, 2, sharey=True)
    for axes, stage in ((left, "before"), (right, "after")):
        rms = 100 * content["error"][stage]["rms_relative"]
        for row in content["rows"]:
            predicted = row[f"{stage}_hz"]
            held = row["held_out"]
            axes.errorbar(
                row["frequency_hz"],
                100 * (predicted / row["frequency_hz"] - 1),
                100 * row["sigma_hz"] / row["frequency_hz"],
                fmt="s" if held else "o",
                color=COLOURS[1] if held else COLOURS[0],
                ms=4,
                lw=1,
            )
        axes.axhline(0, color="black", lw=0.8)
        axes.set(xlabel="measured frequency [Hz]")
        axes.set_title(f"{'declared' if stage == 'before' else 'with the cause'}: {rms:.2f} %", loc="left")
    left.set_ylabel("prediction minus measurement [%]")
    handles = [
        mpl.lines.Line2D([], [], marker=marker, ls="", color=colour, label=label)
        for marker, colour, label in (("o", COLOURS[0], "fitted pose"), ("s", COLOURS[1], "held-out pose"))
    ]
    right.legend(handles=handles, loc="upper right")
    return figure


def plane(model: pkmodes.Model) -> bytes:
    """Draw the frequencies over the working plane, as ``pkmodes figures`` does."""
    grid = {"x": np.linspace(0.3, 0.8, 101), "y": np.linspace(-0.1, 0.1, 41), "z": POSE[2]}
    drawn = next(picture for picture in pictures(model, grid) if picture.name == "frequencies")
    return image_bytes(drawn, "png")


def moving(model: pkmodes.Model) -> bytes:
    """Draw the second mode, as ``pkmodes show`` does."""
    shown = scene(model, POSE)
    return animation(shown, shown.rigid_modes + 1)


#: Pictures as pkmodes makes them, with their files.
MADE = {"tutorial-plane.png": plane, "tutorial-mode.gif": moving}
PICTURES = {"tutorial-machine": machine, "tutorial-frequencies": frequencies, "tutorial-residual": residual}


def main(arguments: Sequence[str]) -> None:
    """Write every picture."""
    folder = Path(arguments[0]) if arguments else HERE
    model = pkmodes.load(LOOP / "robot.toml")
    for name, make in MADE.items():
        (folder / name).write_bytes(make(model))
    with mpl.rc_context(STYLE):
        for name, draw in PICTURES.items():
            draw(model).savefig(folder / f"{name}.svg", metadata={"Date": None, "Creator": None})


if __name__ == "__main__":
    main(sys.argv[1:])
