"""A page that shows a scene: one HTML file without anything from a network; or the same viewer inside another page.

`fragment` is the viewer itself, and `assets` what all viewers of a page share: the style, three.js and the program.
Without WebGL, and without JavaScript, the table of the first pose remains.
"""

from __future__ import annotations

from html import escape
from importlib.resources import files

import numpy as np

from pkmodes.core.robot.units import SHOWN
from pkmodes.core.support.page_policy import with_policy
from pkmodes.pages.view.interpolation import FINE
from pkmodes.pages.view.measured_data import measured_table, numbers_table, observed
from pkmodes.pages.view.page_data import as_data, packed, platform_directions
from pkmodes.pages.view.scene import AMPLITUDE, Scene
from pkmodes.pages.view.still import still
from pkmodes_description import Named

#: Parts of the program in the browser, in loading order.
PROGRAM = ("palette.js", "states.js", "shapes.js", "stage.js", "panel.js", "viewer.js")
#: Shares of the strain energy that differ by less count as equal, as in panel.js.
TIED = 0.0005
#: End of every page title, by which `pkmodes show` recognises its own pages.
PAGE_MARK = b": vibration modes</title>"
ICON = "data:image/svg+xml,%3Csvg xmlns='http://www.w3.org/2000/svg'/%3E"


def page(scene: Scene) -> str:
    """Return a self-contained HTML page that shows a scene.

    Parameters
    ----------
    scene : Scene
        From `scene` or `poses_around`.

    Returns
    -------
    str
        HTML that needs no other file and no network.

    Examples
    --------
    >>> import pkmodes
    >>> from pkmodes.pages.view import page, poses_around
    >>> model = pkmodes.load("robots/linear-delta-2022.toml")
    >>> text = page(poses_around(model, [0.6, 0.0, -0.245]))
    >>> text.startswith("<!doctype html>"), len(text) < 1_500_000
    (True, True)
    """
    name, style = escape(scene.robot), _read("browser", "page.css")
    return with_policy(f"""<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{name}{PAGE_MARK.decode()}
<link rel="icon" href="{ICON}">
<style>
{style}</style>
</head>
<body>
<main>
<header>
<h1>{name}</h1>
<p>{escape(scene.title[:1].upper() + scene.title[1:])}; {scene.doing}</p>
{_head(scene)}</header>
{fragment(scene)}
<footer>
<p>A mode is a free vibration about the static equilibrium at the pose.  The picture enlarges it; displacements are
linear in the amplitude.  Parts whose size or place the robot file does not
give are drawn schematically.</p>
</footer>
</main>
{assets()}</body>
</html>
""")


def _head(scene: Scene) -> str:
    """Return what the robot file says of the machine; empty if it says nothing."""
    lines = "".join(f"<dt>{title}</dt><dd><bdi>{escape(text)}</bdi></dd>\n" for title, text in scene.head)
    return f'<dl class="about">\n{lines}</dl>\n' if lines else ""


def assets() -> str:
    """Return the style and the program that the viewers of a page share.

    Returns
    -------
    str
        HTML; place it once, after the last viewer.
    """
    library = _read("vendor", "three.min.js")
    licence = _read("vendor", "LICENSE").strip()
    program = "\n".join(_read("browser", name) for name in PROGRAM)
    return (
        f"<style>\n{_read('browser', 'viewer.css')}</style>\n"
        f"<script>\n/*! three.js\n{licence}\n*/\n{library}</script>\n"
        f'<script>\n(() => {{\n"use strict";\nconst T = PkmodesThree;\n{program}}})();\n</script>\n'
    )


def fragment(scene: Scene, name: str = "robot") -> str:
    """Return the viewer of a scene for a page that also has the `assets`.

    Parameters
    ----------
    scene : Scene
        From `scene` or `poses_around`.
    name : str
        Prefix of the identifiers in the fragment; different for each viewer of a page.

    Returns
    -------
    str
        HTML.
    """
    key = escape(name)
    data = packed(as_data(scene))
    return f"""<section class="pkview" aria-label="{escape(scene.robot)} in three dimensions">
<div class="pkview-frame">
<div class="pkview-stage">
<canvas tabindex="0" role="application" aria-label="{escape(scene.robot)}, moving in the chosen mode.
 Arrow keys turn the view, plus and minus zoom, Home resets it, space plays and pauses."></canvas>
<canvas class="pkview-still" aria-hidden="true"></canvas>
{still(scene)}
{_title(scene)}
<div class="pkview-legend" aria-hidden="true">Share of the strain energy
<div class="pkview-scale"></div>
<div class="pkview-ends"><span>0 %</span><span>50 %</span><span>100 %</span></div></div>
<div class="pkview-buttons"><button type="button" data-part="reset">Reset view</button>
<button type="button" class="pkview-play" data-part="play" aria-pressed="false"><span>Play</span></button></div>
<p class="pkview-message" role="alert" data-part="message" hidden></p>
</div>
<div class="pkview-panel">
{_poses(scene, key)}
{_modes(scene, key)}
{_motion(scene, key)}
</div>
</div>
<noscript><p>The moving picture needs JavaScript; the table is that of one pose.</p></noscript>
{_table(scene, key)}
{measured_table(scene, key)}
{data}
</section>
"""


def _poses(scene: Scene, key: str) -> str:
    if scene.levels is None:
        options = ""
        for i, pose in enumerate(scene.poses):  # in few characters: with one unit where all have the same
            parts = [_shown(c, value).rpartition(" ") for c, value in zip(scene.pose, pose, strict=True)]
            single_unit = len({symbol for *_, symbol in parts}) == 1
            text = ", ".join(value if single_unit else f"{value} {symbol}" for value, _, symbol in parts)
            label = f"{scene.labels[i]}: " if scene.labels else ""
            text = escape(f"{label}{text} {parts[0][2]}" if single_unit else label + text)
            options += f'<option value="{i}"{" selected" if i == scene.chosen else ""}>{text}</option>'
        names = escape(", ".join(c.name for c in scene.pose))
        return (
            f'<fieldset><legend id="{key}-pose-title">Pose: {names}</legend>'
            f'<select id="{key}-pose" data-part="pose" aria-labelledby="{key}-pose-title">{options}</select>'
            "</fieldset>"
        )
    at = scene.poses[scene.chosen] if scene.values is None else scene.values[scene.chosen]
    rows = "".join(
        f'<div class="pkview-row"><label for="{key}-{c.name}">{escape(c.name).replace(".", ".<wbr>")}</label>'
        f'<input type="range" id="{key}-{c.name}" data-part="level" min="0" max="{FINE * (len(values) - 1)}" step="1"'
        f' value="{FINE * int(np.argmin(np.abs(values - value)))}" title="{escape(c.description)}">'
        f'<output for="{key}-{c.name}" data-part="level-value">{_shown(c, value)}</output></div>'
        for c, values, value in zip(scene.axes, scene.levels, at, strict=True)
    )
    title, kind = ("Values", ' class="pkview-varied"') if scene.varied else ("Pose", "")
    hint = '<p class="pkview-hint" data-part="between"></p>'
    return f"<fieldset{kind}><legend>{title}</legend>{rows}{hint}</fieldset>"


def _title(scene: Scene) -> str:
    """Return what the picture shows first: mode, frequency, spring with most energy, motion, model, measurement."""
    pose, mode = scene.chosen, min(scene.rigid_modes, scene.frequencies.shape[1] - 1)
    number, shares = mode - scene.rigid_modes + 1, scene.shares[pose, mode]
    name = f"Mode {number}" if number > 0 else f"Rigid-body motion {mode + 1}"
    held = "no spring is strained"
    if np.isfinite(shares).any():
        largest = float(np.nanmax(shares))
        *preceding, last = (
            escape(spring.name)
            for spring, share in zip(scene.springs, shares, strict=True)
            if share > largest - TIED
        )
        where = f"each of {', '.join(preceding)} and {last}" if preceding else last
        held = f"{100 * largest:.0f} % of the strain energy in {where}"
    moves = zip(scene.moves, platform_directions(scene)[pose, mode], strict=True)
    along = ", ".join(
        f"{component} {round(move, 2) + 0.0:.2f}".replace("-", "\u2212") for component, move in moves
    )
    about = f"<p>Model {escape(scene.what)}</p>" if scene.what else ""
    if scene.varied:
        about += '<p>Thin lines: as declared<span data-part="declared"></span></p>'
    if scene.measured is not None:
        about += f'<p class="pkview-measured"><span data-part="observed">{observed(scene)}</span></p>'
    return (
        f'<div class="pkview-title"><h2 data-part="title">{name}: {scene.frequencies[pose, mode]:.2f} Hz</h2>'
        f'<p><span data-part="held">{held}</span></p>'
        f'<p>Platform moves along <span data-part="along">{along}</span></p>{about}</div>'
    )


def _modes(scene: Scene, key: str) -> str:
    rigid, count = scene.rigid_modes, scene.frequencies.shape[1]
    first = min(rigid, count - 1)
    labels, beside = (
        [],
        ""
        if scene.measured is None and not scene.varied
        else '<small data-part="beside" data-mode="{}"></small>',
    )
    for mode in [*range(rigid, count), *range(rigid)]:
        kind = "" if mode >= rigid else ' class="pkview-rigid"'
        name = str(mode - rigid + 1) if mode >= rigid else f"rigid {mode + 1}"
        chosen = " checked" if mode == first else ""
        hertz = f"{round(scene.frequencies[scene.chosen, mode], 2) + 0.0:.2f} Hz".replace("-", "\u2212")
        labels.append(
            f'<label{kind}><input type="radio" name="{key}-mode" value="{mode}" data-part="mode"{chosen}>'
            f'<b>{name}</b><span data-part="frequency" data-mode="{mode}">{hertz}</span>'
            f"{beside.format(mode)}</label>"
        )
    return (
        f'<fieldset><legend>Mode</legend><div class="pkview-modes">{"".join(labels)}</div></fieldset>'
        '<p class="pkview-status" role="status" aria-live="polite" data-part="status">'
        f"{'Rigid-body motions strain no spring.' if rigid else ''}</p>"
        + ("" if scene.measured is None else '<p class="pkview-hint" data-part="unmatched"></p>')
    )


def _motion(scene: Scene, key: str) -> str:
    def row(name: str, label: str, low: float, high: float, step: float, value: float) -> str:
        return (
            f'<div class="pkview-row"><label for="{key}-{name}">{label}</label>'
            f'<input type="range" id="{key}-{name}" data-part="{name}" min="{low}" max="{high}" step="{step}"'
            f' value="{value}"><output for="{key}-{name}" data-part="{name}-value"></output></div>'
        )

    return (
        "<fieldset><legend>Motion</legend>"
        f"{row('amplitude', 'Amplitude', 0, 20, 0.5, 100 * AMPLITUDE)}{row('speed', 'Speed', 0.1, 2, 0.05, 0.5)}"
        '<p class="pkview-hint">Amplitude: the largest displacement as a share of the robot&#8217;s size.'
        ' <span data-part="enlarged"></span></p></fieldset>'
        '<div class="pkview-boxes">'
        f"{_box('labels', 'Labels')}"
        f"{_box('space', 'Workspace') if scene.workspace is not None else ''}"
        f"{_box('marks', 'Measured shape') if scene.channels else ''}</div>"
    )


def _box(part: str, label: str) -> str:
    return f'<label><input type="checkbox" data-part="{part}" checked>{label}</label>'


def _table(scene: Scene, key: str) -> str:
    """Return the table of the vibration modes at the first pose: frequencies, directions, shares of the springs."""
    i, modes = scene.chosen, range(scene.rigid_modes, scene.frequencies.shape[1])
    moves, shares = platform_directions(scene)[i], scene.shares[i]
    heads = "".join(f'<th scope="col" data-column="{m}">Mode {m - scene.rigid_modes + 1}</th>' for m in modes)
    frequencies = "".join(
        f'<td data-column="{m}" data-part="frequency" data-mode="{m}">{scene.frequencies[i, m]:.2f} Hz</td>'
        for m in modes
    )
    rows = [f'<tr><th scope="row">Frequency</th>{frequencies}</tr>']
    for k, component in enumerate(scene.moves):
        cells = "".join(
            f'<td data-column="{m}" data-part="direction" data-mode="{m}" data-component="{k}">'
            f"{round(moves[m, k], 2) + 0.0:.2f}</td>"
            for m in modes
        )
        which = component if component.startswith("about") else f"along {component}"
        rows.append(f'<tr><th scope="row">Platform {escape(which)}</th>{cells}</tr>')
    for k, spring in enumerate(scene.springs):
        cells = ""
        for m in modes:
            percent = "\u2013" if np.isnan(shares[m, k]) else f"{100 * shares[m, k]:.1f}"
            cells += (
                f'<td data-column="{m}" data-part="share" data-mode="{m}" data-spring="{k}"'
                f' style="--share: {np.nan_to_num(shares[m, k]):.3f}">{percent}</td>'
            )
        title = escape(f"{spring.name} [%]")
        rows.append(
            f'<tr data-part="spring" data-spring="{k}"><th scope="row" title="{escape(spring.description)}">'
            f"{title}</th>{cells}</tr>"
        )
    caption = (
        f"<b>What rings with {scene.doing}:</b> share of every spring in the strain energy of each mode, and the"
        f" direction of the platform&#8217;s motion{_turning(scene)},"
        f' at <span data-part="place">{_place(scene, i)}</span>'
    )
    return numbers_table(f"{key}-caption", caption, heads, rows)


def _turning(scene: Scene) -> str:
    """State how rotations of the platform count."""
    if not (scene.lengths != 1.0).any():
        return ""
    return f" (rotations times {1e3 * float(scene.lengths[-1]):.4g} mm)"


def _place(scene: Scene, index: int) -> str:
    parts = [
        f"{c.name} = {_shown(c, value)}" for c, value in zip(scene.pose, scene.poses[index], strict=True)
    ]
    if scene.values is not None:
        parts += [
            f"{c.name} = {_shown(c, v)}" for c, v in zip(scene.varied, scene.values[index], strict=True)
        ]
    label = f"{scene.labels[index]}: " if scene.labels else ""
    return escape(label + ", ".join(parts))


def _shown(component: Named, value: float) -> str:
    if "." in component.name:  # a parameter, of any size
        digits = float(f"{value:.4g}")
        text = (
            np.format_float_positional(digits, trim="-") if abs(value) >= 1e-6 or not value else f"{digits:g}"
        )
        return f"{text} {component.unit}".removesuffix(" 1").replace("-", "\u2212")
    unit, factor = SHOWN.get(component.unit, (component.unit, 1.0))
    return f"{round(factor * value, 1) + 0.0:.1f} {unit}".replace("-", "\u2212")


def _read(folder: str, name: str) -> str:
    return (files("pkmodes.pages.view") / folder / name).read_text(encoding="utf-8")
