"""How much mode shapes change between neighbouring poses: their MAC."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from numpy.typing import NDArray

from pkmodes.plots.maps import mode_panels, panels_of
from pkmodes.plots.plane import Plane

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[Any]


def neighbouring_mac(plane: Plane, mac: Array) -> Figure:
    """Draw the smallest MAC of each mode with the mode of the same number at the neighbouring poses.

    Parameters
    ----------
    mac : ndarray, shape (along, across, modes)
        From `pkmodes.figures.quantities.smallest_mac`.
    """
    modes = mac.shape[-1]
    drawn, panels = panels_of(plane, modes, colour_bars=False)
    mesh = None
    for mode, axes in mode_panels(plane, panels, modes):
        mesh = plane.draw(axes, mac[..., mode], vmin=0.0, vmax=1.0)
    if mesh is not None:
        bar = drawn.colorbar(mesh, ax=panels, location="right", shrink=0.9, aspect=35)
        bar.set_label("smallest MAC with a neighbouring pose [1]")
    return drawn
