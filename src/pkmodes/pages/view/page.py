"""A page that shows a scene: one HTML file without anything from a network; or the same viewer inside another page.

`fragment` is the viewer itself, and `assets` what all viewers of a page share: the style, three.js and the program.
Without WebGL or JavaScript, the table of the first pose remains.
"""

from __future__ import annotations

from html import escape
from importlib.resources import files

import numpy as np

from pkmodes.core.robot.units import DISPLAY_UNITS
from pkmodes.core.support.page_policy import with_policy
from pkmodes.pages.view.interpolation import SLIDER_STEPS
from pkmodes.pages.view.markup import breakable
from pkmodes.pages.view.measured_data import measured_sentence, measured_table, numbers_table
from pkmodes.pages.view.mode_words import energy_text, frequency_text, motion_text, sigma_note, signed_text
from pkmodes.pages.view.page_data import data_element, platform_directions, scene_data
from pkmodes.pages.view.scene import AMPLITUDE, Scene
from pkmodes.pages.view.still import still_svg
from pkmodes_description import Named

#: Scripts of the viewer, in loading order.
PROGRAM = ("palette.js", "states.js", "shapes.js", "stage.js", "panel.js", "viewer.js")
#: Note on motions that strain no spring.
RIGID_NOTE = "Rigid-body motions strain no spring: without gravity, their frequency is 0."
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
<p>{escape(scene.title[:1].upper() + scene.title[1:])}; {scene.doing}{sigma_note(scene)}</p>
{_about_list(scene)}</header>
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


def _about_list(scene: Scene) -> str:
    """Return the lines of the robot file for the head of a page; empty if there are none."""
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
    prefix = escape(name)
    data = data_element(scene_data(scene))
    return f"""<section class="pkview" aria-label="{escape(scene.robot)} in three dimensions">
<div class="pkview-frame">
<div class="pkview-stage">
<canvas tabindex="0" role="application" aria-label="{escape(scene.robot)}, moving in the chosen mode.
 Arrow keys turn the view, plus and minus zoom, Home resets it, space plays and pauses."></canvas>
<canvas class="pkview-still" aria-hidden="true"></canvas>
{still_svg(scene)}
{_title(scene)}
<div class="pkview-legend" aria-hidden="true">Share of the strain energy
<div class="pkview-scale"></div>
<div class="pkview-ends"><span>0 %</span><span>50 %</span><span>100 %</span></div></div>
<div class="pkview-buttons"><button type="button" data-part="reset">Reset view</button>
<button type="button" class="pkview-play" data-part="play" aria-pressed="false"><span>Play</span></button></div>
<p class="pkview-message" role="alert" data-part="message" hidden></p>
</div>
<div class="pkview-panel">
{_pose_controls(scene, prefix)}
{_mode_controls(scene, prefix)}
{_motion_controls(scene, prefix)}
</div>
</div>
<noscript><p>The moving picture needs JavaScript; the table is that of one pose.</p></noscript>
{_mode_table(scene, prefix)}
{measured_table(scene, prefix)}
{data}
</section>
"""


def _pose_controls(scene: Scene, prefix: str) -> str:
    if scene.levels is None:
        options = ""
        for i, pose in enumerate(scene.poses):  # in few characters: with one unit where all have the same
            parts = [
                _format_component(c, value).rpartition(" ") for c, value in zip(scene.pose, pose, strict=True)
            ]
            single_unit = len({symbol for *_, symbol in parts}) == 1
            text = ", ".join(value if single_unit else f"{value} {symbol}" for value, _, symbol in parts)
            label = f"{scene.labels[i]}: " if scene.labels else ""
            text = escape(f"{label}{text} {parts[0][2]}" if single_unit else label + text)
            options += f'<option value="{i}"{" selected" if i == scene.chosen else ""}>{text}</option>'
        names = escape(", ".join(c.name for c in scene.pose))
        return (
            f'<fieldset><legend id="{prefix}-pose-title">Pose: {names}</legend>'
            f'<select id="{prefix}-pose" data-part="pose" aria-labelledby="{prefix}-pose-title">{options}</select>'
            "</fieldset>"
        )
    shown_values = scene.poses[scene.chosen] if scene.values is None else scene.values[scene.chosen]
    rows = "".join(
        f'<div class="pkview-row"><label for="{prefix}-{c.name}">{breakable(c.name)}</label>'
        f'<input type="range" id="{prefix}-{c.name}" data-part="level" min="0"'
        f' max="{SLIDER_STEPS * (len(values) - 1)}" step="1"'
        f' value="{SLIDER_STEPS * int(np.argmin(np.abs(values - value)))}" title="{escape(c.description)}">'
        f'<output for="{prefix}-{c.name}" data-part="level-value">{_format_component(c, value)}</output></div>'
        for c, values, value in zip(scene.axes, scene.levels, shown_values, strict=True)
    )
    title, css_class = ("Values", ' class="pkview-varied"') if scene.varied else ("Pose", "")
    hint = '<p class="pkview-hint" data-part="between"></p>'
    return f"<fieldset{css_class}><legend>{title}</legend>{rows}{hint}</fieldset>"


def _title(scene: Scene) -> str:
    """Return the title of the first mode: frequency, springs with most energy, motion, model, measurement."""
    pose, mode = scene.chosen, min(scene.rigid_modes, scene.frequencies.shape[1] - 1)
    number = mode - scene.rigid_modes + 1
    name = f"Mode {number}" if number > 0 else f"Rigid-body motion {mode + 1}"
    motion = motion_text(scene.bodies, scene.moves, platform_directions(scene)[pose, mode].tolist())
    further_lines = f"<p>Model {escape(scene.what)}</p>" if scene.what else ""
    if scene.varied:
        further_lines += '<p>Thin lines: as declared<span data-part="declared"></span></p>'
    if scene.measured is not None:
        further_lines += (
            f'<p class="pkview-measured"><span data-part="observed">{measured_sentence(scene)}</span></p>'
        )
    return (
        f'<div class="pkview-title"><h2 data-part="title">{name}: '
        f"{frequency_text(scene, pose, mode, with_sigma=True)}</h2>"
        f'<p><span data-part="held">{escape(energy_text(scene, pose, mode))}</span></p>'
        f'<p><span data-part="motion">{escape(motion[0].upper() + motion[1:])}</span></p>{further_lines}</div>'
    )


def _mode_controls(scene: Scene, prefix: str) -> str:
    rigid, count = scene.rigid_modes, scene.frequencies.shape[1]
    first_mode = min(rigid, count - 1)
    labels, comparison = (
        [],
        ""
        if scene.measured is None and not scene.varied
        else '<small data-part="beside" data-mode="{}"></small>',
    )
    for mode in [*range(rigid, count), *range(rigid)]:
        css_class = "" if mode >= rigid else ' class="pkview-rigid"'
        name = str(mode - rigid + 1) if mode >= rigid else f"rigid {mode + 1}"
        chosen = " checked" if mode == first_mode else ""
        labels.append(
            f'<label{css_class}><input type="radio" name="{prefix}-mode" value="{mode}" data-part="mode"{chosen}>'
            f'<b>{name}</b><span data-part="frequency" data-mode="{mode}">'
            f"{frequency_text(scene, scene.chosen, mode)}</span>"
            f"{comparison.format(mode)}</label>"
        )
    return (
        f'<fieldset><legend>Mode</legend><div class="pkview-modes">{"".join(labels)}</div></fieldset>'
        '<p class="pkview-status" role="status" aria-live="polite" data-part="status">'
        f"{RIGID_NOTE if rigid else ''}</p>"
        + ("" if scene.measured is None else '<p class="pkview-hint" data-part="unmatched"></p>')
    )


def _motion_controls(scene: Scene, prefix: str) -> str:
    def row(name: str, label: str, low: float, high: float, step: float, value: float) -> str:
        return (
            f'<div class="pkview-row"><label for="{prefix}-{name}">{label}</label>'
            f'<input type="range" id="{prefix}-{name}" data-part="{name}" min="{low}" max="{high}" step="{step}"'
            f' value="{value}"><output for="{prefix}-{name}" data-part="{name}-value"></output></div>'
        )

    return (
        "<fieldset><legend>Motion</legend>"
        f"{row('amplitude', 'Amplitude', 0, 20, 0.5, 100 * AMPLITUDE)}{row('speed', 'Speed', 0.1, 2, 0.05, 0.5)}"
        '<p class="pkview-hint">Amplitude: the largest displacement as a share of the robot&#8217;s size.'
        ' <span data-part="enlarged"></span></p></fieldset>'
        '<div class="pkview-boxes">'
        f"{_checkbox('labels', 'Labels')}"
        f"{_checkbox('space', 'Workspace') if scene.workspace is not None else ''}"
        f"{_checkbox('marks', 'Measured shape') if scene.channels else ''}</div>"
    )


def _checkbox(part: str, label: str) -> str:
    return f'<label><input type="checkbox" data-part="{part}" checked>{label}</label>'


def _mode_table(scene: Scene, prefix: str) -> str:
    """Return the table of the vibration modes at the first pose: frequencies, directions, shares of the springs."""
    pose, modes = scene.chosen, range(scene.rigid_modes, scene.frequencies.shape[1])
    moves, shares = platform_directions(scene)[pose], scene.shares[pose]
    head_cells = "".join(
        f'<th scope="col" data-column="{m}">Mode {m - scene.rigid_modes + 1}</th>' for m in modes
    )
    frequencies = "".join(
        f'<td data-column="{m}" data-part="frequency" data-mode="{m}" data-sigma>'
        f"{frequency_text(scene, pose, m, with_sigma=True)}</td>"
        for m in modes
    )
    rows = [f'<tr><th scope="row">Frequency</th>{frequencies}</tr>']
    for k, component in enumerate(scene.moves):
        cells = "".join(
            f'<td data-column="{m}" data-part="direction" data-mode="{m}" data-component="{k}">'
            f"{signed_text(moves[m, k], 2)}</td>"
            for m in modes
        )
        motion = component if component.startswith("about") else f"along {component}"
        row_title = escape(f"{scene.bodies[k]} {motion}".capitalize())
        rows.append(f'<tr><th scope="row">{row_title}</th>{cells}</tr>')
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
        f"<b>Modes with {scene.doing}:</b> share of every spring in the strain energy of each mode, and the"
        f" direction of motion of the {scene.moving_body}{_rotation_note(scene)},"
        f' at <span data-part="place">{_place_text(scene, pose)}</span>{sigma_note(scene)}'
    )
    return numbers_table(f"{prefix}-caption", caption, head_cells, rows)


def _rotation_note(scene: Scene) -> str:
    """Return the length by which rotations of the platform are multiplied, in words; empty without rotations."""
    if not (scene.lengths != 1.0).any():
        return ""
    return f" (rotations times {1e3 * float(scene.lengths[-1]):.4g} mm)"


def _place_text(scene: Scene, index: int) -> str:
    parts = [
        f"{c.name} = {_format_component(c, value)}"
        for c, value in zip(scene.pose, scene.poses[index], strict=True)
    ]
    if scene.values is not None:
        parts += [
            f"{c.name} = {_format_component(c, v)}"
            for c, v in zip(scene.varied, scene.values[index], strict=True)
        ]
    label = f"{scene.labels[index]}: " if scene.labels else ""
    return escape(label + ", ".join(parts))


def _format_component(component: Named, value: float) -> str:
    if "." in component.name:  # a parameter, of any size
        digits = float(f"{value:.4g}")
        text = (
            np.format_float_positional(digits, trim="-") if abs(value) >= 1e-6 or not value else f"{digits:g}"
        )
        return f"{text} {component.unit}".removesuffix(" 1").replace("-", "\u2212")
    unit, factor = DISPLAY_UNITS.get(component.unit, (component.unit, 1.0))
    return f"{round(factor * value, 1) + 0.0:.1f} {unit}".replace("-", "\u2212")


def _read(folder: str, name: str) -> str:
    return (files("pkmodes.pages.view") / folder / name).read_text(encoding="utf-8")
