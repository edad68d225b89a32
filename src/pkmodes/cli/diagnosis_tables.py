"""Print a diagnosis on the terminal: verdict, causes, error before and after, refitted values."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from statistics import median

from pkmodes.cli.stability_text import stability_sentence
from pkmodes.cli.terminal import Terminal
from pkmodes.core.base.drives import HELD
from pkmodes.core.mechanism.poses import placed
from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.core.robot.robot import Robot
from pkmodes.diagnosis.verdict import naming
from pkmodes.diagnosis.verdict.findings import (
    NOTICEABLE,
    Corrected,
    Finding,
    Refitted,
    Value,
    believed,
    saved_as,
    why_larger,
)
from pkmodes.diagnosis.verdict.result import Diagnosis
from pkmodes.diagnosis.verdict.rows import Error, Row
from pkmodes.support.motors import motors_in_words
from pkmodes.support.numbers import p_in_words, plain, rounded
from pkmodes.support.ordering import listed, sorted_labels
from pkmodes.updating.load_cases import settable

#: Largest number of measurement lines listed; the JSON has all of them.
MOST_LISTED = 8
#: Largest number of limits listed.
MOST_LIMITS = 5


def show(robot: Robot, result: Diagnosis) -> None:
    """Print the diagnosis of a robot."""
    terminal = Terminal()
    terminal.heading(f"{robot.name}: {result.verdict}")
    terminal.line(result.reason, "  ")
    _causes(terminal, result.effects, result.corrected)
    for group in result.survivors:
        terminal.line(f"remains: {' or '.join(group)}", "  ")
    terminal.line()
    _errors(terminal, result)
    _damping(terminal, result)
    _counts(terminal, robot, result)
    of_losses = {value.name for value in result.damping.refitted}  # the damping says more of them
    if refitted := [value for value in result.refitted if value.name not in of_losses]:
        terminal.line()
        _refitted(terminal, refitted)
    _remarks(terminal, robot, result)


def _causes(terminal: Terminal, effects: Sequence[Finding], corrected: Sequence[Corrected]) -> None:
    """Print causes with their values and classes."""
    for effect in effects:
        terminal.line()
        if len(effect.members) > 1:
            _class(terminal, effect, corrected)
            continue
        sentence = f": {effect.sentence}" if effect.sentence else ""
        terminal.line(f"cause: {effect.name} ({p_in_words(effect.p_value)}){sentence}")
        _values(terminal, effect, corrected)


def _class(terminal: Terminal, effect: Finding, corrected: Sequence[Corrected]) -> None:
    """Print a class: what its members have in common, and each with its value and whether that is implausible."""
    what = f"one of {naming.count(len(effect.members))} ({p_in_words(effect.p_value)})"
    terminal.line(f"cause: {what}: {naming.of_class(effect)}")
    for place, member in enumerate(effect.members):
        if place == 1:
            terminal.line("these data cannot distinguish it from", "  ")
        relative, why = effect.relative(member), effect.member(member).implausible
        values = ", ".join(f"{_short(v)} = {_with_sigma(v)}" for v in relative or effect.alternatives[member])
        mean, also = " relative to their mean" if relative else "", f" (implausible: {why})" if why else ""
        terminal.line(f"{values}{mean}{also}", "    " if place else "  ")
    saved = [
        one for value in effect.parameters if (one := saved_as(value, corrected)) is not None and one.widened
    ]
    larger = [
        f"{_short(one)} is saved with +- {plain(one.saved_sigma, 2)}, for what an unseen {one.unseen.candidate} "
        "could have done"
        for one in saved
        if one.unseen is not None
    ]
    terminal.line("; ".join(["+- by the fit alone", *larger]), "  ")


def _values(terminal: Terminal, effect: Finding, corrected: Sequence[Corrected]) -> None:
    """Print the values of a cause: relative to their mean, where the mean is far less certain.

    The standard deviation is the one that may be relied on, with that of the fit below it.
    """
    relative = effect.relative()
    if relative:
        terminal.line("relative to their mean:", "  ")
    for value in relative or effect.parameters:
        shown, why = (value, "") if relative else (believed(value, corrected), why_larger(value, corrected))
        terminal.line(f"{_short(value)} = {_with_sigma(shown)}", "    " if relative else "  ")
        if why:
            terminal.line(why, "    ")
    if why := effect.member(effect.name).implausible:
        terminal.line(f"implausible: {why}", "  ")
    if relative:
        each = ", ".join(_with_sigma(believed(value, corrected)) for value in effect.parameters)
        terminal.line("with their mean, which is less certain:", "  ")
        terminal.line(each, "    ")


def _errors(terminal: Terminal, result: Diagnosis) -> None:
    held = any(error.held_out_rms_relative is not None for _, error in result.errors.values())
    titles = ("error", "rms [%]", *(("held out [%]",) if held else ()), "chi2 per dof")
    rows = [(title, *_row(error, held)) for title, error in result.errors.values()]
    terminal.table(titles, rows, left=("error",))


def _row(error: Error, held: bool) -> tuple[str, ...]:
    chi2 = error.chi2_per_dof
    return (
        _percent(error.rms_relative),
        *((_percent(error.held_out_rms_relative),) if held else ()),
        f"{chi2:.3g}" if chi2 < 999.5 else f"{chi2:.0f}",
    )


def _percent(relative: float | None) -> str:
    return "" if relative is None else f"{100.0 * relative:.3f}"


def _damping(terminal: Terminal, result: Diagnosis) -> None:
    """Print what the damping says, which changes nothing above."""
    found = result.damping
    if not found.measured:
        return
    terminal.line()
    terminal.line(f"damping: {found.verdict}")
    terminal.line(found.reason, "  ")
    _causes(terminal, found.effects, found.corrected)
    for group in found.survivors:
        terminal.line(f"remains: {' or '.join(group)}", "  ")
    if found.fitted:
        _ratios(terminal, result)
    if found.refitted:
        terminal.line()
        _refitted(terminal, found.refitted)
    for note in found.notes:
        terminal.line()
        terminal.line(f"note on the damping: {note}")


def _ratios(terminal: Terminal, result: Diagnosis) -> None:
    """Print how far the damping ratios of the model are from the measured ones, and with which errors."""
    found = result.damping
    factors = {"as declared": found.before, "as diagnosed": found.after, "held out": found.held_out}
    parts = [f"{factor:.3g} {name}" for name, factor in factors.items() if factor is not None]
    if found.before is None:
        parts.insert(0, "nothing dissipates as declared")
    errors = [
        row.sigma_damping_used / row.damping
        for row in result.rows
        if row.damping_used and row.damping and row.sigma_damping_used is not None
    ]
    count = f"{found.fitted} ratio{'' if found.fitted == 1 else 's'} fitted"
    each = f" with a sigma of {100.0 * median(errors):.0f} % (median)" if errors else ""
    terminal.line()
    terminal.line(f"{count}{each}; rms factor between model and measurement: {', '.join(parts)}")


def _counts(terminal: Terminal, robot: Robot, result: Diagnosis) -> None:
    count = sum(not (row.held_out or row.outlier) for row in result.rows)
    held = f" (held out: {', '.join(sorted_labels(result.held_out_poses))})" if result.held_out_poses else ""
    terminal.line()
    did = motors_in_words(robot, [row.drives for row in result.rows])
    terminal.line(f"{count} measured mode{'' if count == 1 else 's'} fitted, {did}{held}")
    if len({row.drives for row in result.rows}) > 1:
        labels = sorted_labels(dict.fromkeys(row.pose for row in result.rows if row.drives == HELD))
        terminal.line(f"motors held: {_poses(labels)}")
    at = {row.pose: setting(robot.mechanism, row.load) for row in result.rows if row.load}
    loads: dict[str, list[str]] = {}
    for label in sorted_labels(at):
        loads.setdefault(at[label], []).append(label)
    if loads:
        cases = [f"{load} ({_poses(labels)})" for load, labels in loads.items()]
        terminal.line(f"set by the measurements: {listed(cases, MOST_LISTED, '; ', '; and ')}")


def _poses(labels: Sequence[str]) -> str:
    return f"pose{'' if len(labels) == 1 else 's'} {listed(labels, MOST_LISTED)}"


def _refitted(terminal: Terminal, values: Sequence[Refitted]) -> None:
    widened = any(value.saved_sigma > NOTICEABLE * value.sigma for value in values)
    rows = [
        (
            value.name.removeprefix("effects."),
            plain(value.before),
            str(rounded(value.after, value.saved_sigma)),
            *((rounded(value.after, value.sigma).columns[1],) if widened else ()),
            "" if value.unit == "1" else value.unit,
        )
        for value in values
    ]
    fit = ("+- of fit",) if widened else ()
    terminal.table(("uncertain value", "before", "after", *fit, "unit"), rows, ("uncertain value", "unit"))
    if widened:
        terminal.line("after: with what candidates that these data do not show could have done to the values")


def _remarks(terminal: Terminal, robot: Robot, result: Diagnosis) -> None:
    remarks = []
    if result.outliers:
        remarks.append(f"set aside as outliers: {_listed(result.outliers)}")
    if result.unpaired:
        remarks.append(f"unmatched measured modes: {_listed(result.unpaired)}")
    if result.scatter:
        remarks.append(f"error common to the modes of a pose: {100 * result.scatter:.2g} %")
    if result.undetectable:
        remarks.append(f"not detectable with these data: {', '.join(result.undetectable)}")
    if limits := largest_limits(result):
        remarks.append(f"not excluded at 95 %: {', '.join(limits)}; all limits: --json or --report")
    if (proposed := result.next_measurement) is not None:
        place = placed(robot.mechanism, proposed.pose, ".4f")
        load = setting(robot.mechanism, proposed.load)
        place += f" with {load}" if load else ""
        place += f", {motors_in_words(robot, proposed.drives)}" if proposed.drives else ""
        differ = f"{' and '.join(proposed.separates)} differ there by {proposed.sigmas:.0f} sigma"
        caveat = f"; {proposed.caveat}" if proposed.caveat else ""
        remarks.append(f"measure next at {place}: {differ}{caveat}")
    elif result.next_measurement_reason:
        remarks.append(f"no next measurement is proposed: {result.next_measurement_reason}")
    remarks += [f"note: {text}" for text in result.notes]
    remarks += [text] if (text := stability_sentence(result)) else []
    for remark in remarks:
        terminal.line()
        terminal.line(remark)


def largest_limits(result: Diagnosis) -> list[str]:
    """Return the limits of the absent effects that could change the frequencies most, once the residual is noise."""
    if not result.settled:
        return []
    effects = {name: limit for name, limit in result.limits.items() if name.startswith(f"{limit.candidate}.")}
    ranked = sorted((n for n in effects if effects[n].value is not None), key=lambda n: -effects[n].change)
    first: dict[str, str] = {}  # of the parameters of an effect, the one that could change most
    for name in ranked:
        first.setdefault(effects[name].candidate, name)
    return [
        f"{name} up to {plain(value, 2)} {effects[name].unit}".removesuffix(" 1")
        for name in list(first.values())[:MOST_LIMITS]
        if (value := effects[name].value) is not None
    ]


def setting(mechanism: Mechanism, load: Mapping[str, float]) -> str:
    """Format the settings of a pose: paths with values and units."""
    units = settable(mechanism)
    return ", ".join(
        f"{path} = {plain(value)} {units[path]}".removesuffix(" 1") for path, value in load.items()
    )


def _listed(rows: Sequence[Row]) -> str:
    named = [f"line {row.line}, pose {row.pose}, {row.measured:g} Hz" for row in rows]
    return listed(named, MOST_LISTED, "; ", "; and ")


def _short(value: Value) -> str:
    return value.name.removeprefix("effects.")


def _with_sigma(value: Value) -> str:
    unit = "" if value.unit == "1" else f" {value.unit}"
    return f"{rounded(value.value, value.sigma)}{unit}"
