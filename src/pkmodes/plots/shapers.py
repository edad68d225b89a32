"""What shapers leave of the vibration: over the workspace, and where frequencies differ from the model's."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from numpy.typing import NDArray

from pkmodes.plots.style import GREY, PALETTE, figure

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[Any]
#: Relative errors of all frequencies that are drawn.
ERROR = 0.2


def left_over(
    points: Array, names: Sequence[str], units: Sequence[tuple[str, float]], left: Mapping[str, Array]
) -> Figure:
    """Draw what shapers leave at poses, one panel for each, on a common scale.

    Parameters
    ----------
    points : ndarray, shape (N, 2)
        Poses in a plane [SI].
    names, units : sequence
        Of the two components, and the unit in which each is drawn with its factor.
    left : mapping of str to ndarray, shape (N,)
        By shaper: vibration relative to none at the pose.
    """
    drawn = figure(2.6 if len(left) > 1 else 3.2)
    panels = drawn.subplots(1, len(left), squeeze=False, sharey=True)[0]
    highest = 100.0 * max(float(values.max()) for values in left.values())
    x, y = (points[:, i] * units[i][1] for i in (0, 1))
    size = max(2.0, min(60.0, 9000.0 / max(len(points), 1) / len(left)))
    for axes, (title, values) in zip(panels, left.items(), strict=True):
        mesh = axes.scatter(
            x,
            y,
            c=100.0 * values,
            s=size,
            marker="s",
            linewidths=0.0,
            vmin=0.0,
            vmax=max(highest, 1e-9),
            rasterized=True,
        )
        axes.set_title(title)
        axes.set_xlabel(f"{names[0]} [{units[0][0]}]")
        if units[0][0] == units[1][0]:
            axes.set_aspect("equal")
    panels[0].set_ylabel(f"{names[1]} [{units[1][0]}]")
    bar = drawn.colorbar(mesh, ax=panels, aspect=20)
    bar.set_label("left [%]")
    return drawn


def against_error(errors: Array, left: Mapping[str, Array], spread: float | None) -> Figure:
    """Draw what shapers leave where all frequencies differ from those of the model.

    Parameters
    ----------
    errors : ndarray, shape (E,)
        Relative errors of the frequencies.
    left : mapping of str to ndarray, shape (E,)
        By shaper: the root mean square over the poses, relative to none.
    spread : float or None
        Mean standard deviation of the frequencies, as a band.
    """
    drawn = figure(2.9)
    axes = drawn.subplots()
    if spread is not None:
        axes.axvspan(-100.0 * spread, 100.0 * spread, color=GREY, alpha=0.2, linewidth=0.0)
    styles = ("-", "--", ":")
    for i, (name, values) in enumerate(left.items()):
        colour, style = PALETTE[i % len(PALETTE)], styles[i // len(PALETTE) % len(styles)]
        axes.plot(100.0 * errors, 100.0 * values, style, color=colour, label=name)
    axes.set_xlim(100.0 * errors[0], 100.0 * errors[-1])
    axes.set_ylim(0.0, None)
    axes.set_xlabel("actual frequencies beyond those of the model [%]")
    axes.set_ylabel("left, rms [%]")
    axes.legend(ncols=2, fontsize=7.5)
    return drawn
