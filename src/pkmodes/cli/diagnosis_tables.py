"""Print a diagnosis on the terminal: verdict, causes, error before and after, refitted values."""

from __future__ import annotations

from collections.abc import Sequence

from pkmodes.cli.measured_rows import poses_in_words, rows_in_words, settings_in_words
from pkmodes.cli.terminal import Terminal
from pkmodes.core.base.drives import HELD
from pkmodes.core.base.numbers import p_in_words, plain, round_to_sigma
from pkmodes.core.robot.robot import Robot
from pkmodes.core.support.motors import motors_in_words
from pkmodes.core.support.ordering import sorted_labels
from pkmodes.loop.diagnosis.verdict import naming
from pkmodes.loop.diagnosis.verdict.findings import (
    Corrected,
    Finding,
    Value,
    explain_saved_sigma,
    omission_in_words,
    saved_as,
    with_saved_sigma,
)
from pkmodes.loop.diagnosis.verdict.result import Damping, Diagnosis
from pkmodes.pages.report.action import recommended_action
from pkmodes.pages.report.beyond import beyond_blocks
from pkmodes.pages.report.damping import ratio_error_paragraphs, refitted_loss_blocks
from pkmodes.pages.report.numbers import error_blocks, fitted_value_tables
from pkmodes.pages.report.report_context import ReportContext
from pkmodes.pages.report.stability import stability_sentence

#: Maximum number of limits listed.
MAX_LIMITS_LISTED = 5


def show_diagnosis(robot: Robot, result: Diagnosis) -> None:
    """Print the diagnosis of a robot."""
    terminal, context = Terminal(), ReportContext(robot.name, robot, None, (), None)
    terminal.heading(f"{robot.name}: {result.verdict}")
    terminal.line(result.reason, "  ")
    terminal.show(recommended_action(result, context))
    _show_explained(terminal, result)
    terminal.show(*error_blocks(result))
    _show_beyond(terminal, result, context)
    damping = result.damping
    if damping.measured:  # with a verdict that is independent of the one above
        terminal.line()
        terminal.line(f"damping: {damping.verdict}")
        terminal.line(damping.reason, "  ")
        _show_explained(terminal, damping)
        terminal.show(*ratio_error_paragraphs(result), *refitted_loss_blocks(damping, context))
        for note in damping.notes:
            terminal.line()
            terminal.line(f"note on the damping: {note}")
    count = sum(not (row.held_out or row.outlier) for row in result.rows)
    terminal.line()
    motors = motors_in_words(robot, [row.drives for row in result.rows])
    terminal.line(f"{count} measured mode{'' if count == 1 else 's'} fitted, {motors}")
    if len({row.drives for row in result.rows}) > 1:
        labels = sorted_labels(dict.fromkeys(row.pose for row in result.rows if row.drives == HELD))
        terminal.line(f"motors held: {poses_in_words(labels)}")
    if settings := settings_in_words(context, result.rows):
        terminal.line(settings)
    terminal.show(*fitted_value_tables(result, context))
    _show_remarks(terminal, result)


def show_causes(terminal: Terminal, result: Diagnosis, context: ReportContext) -> None:
    """Print the causes found, and what a single term at one place would explain."""
    _show_explained(terminal, result)
    _show_beyond(terminal, result, context)


def _show_beyond(terminal: Terminal, result: Diagnosis, context: ReportContext) -> None:
    """Print what a single term at one place would explain that the catalogue does not."""
    if result.beyond is None:
        return
    terminal.line()
    terminal.line(f"beyond the catalogue: {result.beyond.status}")
    terminal.show(*beyond_blocks(result, context))


def _show_explained(terminal: Terminal, result: Diagnosis | Damping) -> None:
    """Print the causes found with their values, and the explanations that remain."""
    for effect in result.effects:
        terminal.line()
        if len(effect.members) > 1:
            _show_class(terminal, effect, result.corrected)
        else:
            sentence = f": {effect.sentence}" if effect.sentence else ""
            terminal.line(f"cause: {effect.name} ({p_in_words(effect.p_value)}){sentence}")
            _show_values(terminal, effect, result.corrected)
    for group in result.survivors:
        terminal.line(f"remains: {' or '.join(group)}", "  ")


def _show_class(terminal: Terminal, effect: Finding, corrected: Sequence[Corrected]) -> None:
    """Print a class of causes: what they have in common, and each cause with its value, and why it is implausible."""
    label = f"one of {naming.number_in_words(len(effect.members))} ({p_in_words(effect.p_value)})"
    terminal.line(f"cause: {label}: {naming.class_in_words(effect)}")
    for index, member in enumerate(effect.members):
        if index == 1:
            terminal.line("these data cannot distinguish it from", "  ")
        relative, reason = effect.relative(member), effect.member(member).implausible
        values = ", ".join(
            f"{_short_name(v)} = {_with_sigma(v)}" for v in relative or effect.alternatives[member]
        )
        relative_note = " relative to their mean" if relative else ""
        implausible = f" (implausible: {reason})" if reason else ""
        assumed = f", for {text}" if (text := effect.member(member).assumed) else ""
        terminal.line(f"{values}{relative_note}{assumed}{implausible}", "    " if index else "  ")
    remarks = ["each +- is that of the fit alone"]
    for value in effect.parameters:
        saved_value = saved_as(value, corrected)
        if saved_value is None or saved_value.unseen is None:
            continue
        if saved_value.widened:
            remarks.append(
                f"{_short_name(value)} is saved with +- {plain(saved_value.saved_sigma, 2)}, which "
                f"allows for {saved_value.unseen.agent}"
            )
        if saved_value.unseen.unbounded:
            remarks.append(omission_in_words(saved_value.unseen))
    terminal.line("; ".join(dict.fromkeys(remarks)), "  ")


def _show_values(terminal: Terminal, effect: Finding, corrected: Sequence[Corrected]) -> None:
    """Print the values of a cause: relative to their mean, where the mean is far less certain.

    The standard deviation is the one to rely on; where it is larger than that of the fit, the reason is below it.
    """
    relative = effect.relative()
    if effect.alone is not None:
        joint = effect.alone.joint
        term = f" ({joint.term})" if joint.term else ""
        joint_change = round_to_sigma(100.0 * effect.alone.change, 100.0 * effect.alone.sigma)
        terminal.line(f"{joint.words} alone: its {joint.quantity} changes by {joint_change} %{term}", "  ")
    if relative:
        terminal.line("relative to their mean:", "  ")
    for value in relative or effect.parameters:
        reliable_value, reason = (
            (value, "")
            if relative
            else (with_saved_sigma(value, corrected), explain_saved_sigma(value, corrected))
        )
        terminal.line(
            f"{_short_name(value)} = {_with_sigma(reliable_value)}{effect.assumed}",
            "    " if relative else "  ",
        )
        if reason:
            terminal.line(reason, "    ")
    if reason := effect.member(effect.name).implausible:
        terminal.line(f"implausible: {reason}", "  ")
    if relative:
        values_with_mean = ", ".join(
            _with_sigma(with_saved_sigma(value, corrected)) for value in effect.parameters
        )
        terminal.line("with their mean, which is less certain:", "  ")
        terminal.line(values_with_mean, "    ")
        reasons = dict.fromkeys(explain_saved_sigma(value, corrected) for value in effect.parameters)
        for reason in filter(None, reasons):
            terminal.line(reason, "    ")


def _show_remarks(terminal: Terminal, result: Diagnosis) -> None:
    """Print outliers, unmatched modes, limits and notes."""
    remarks = []
    if result.outliers:
        remarks.append(f"set aside as outliers: {rows_in_words(result.outliers)}")
    if result.unpaired:
        condition = "" if result.beyond is None or result.beyond.found is None else " without the term"
        remarks.append(f"unmatched measured modes{condition}: {rows_in_words(result.unpaired)}")
    if result.scatter:
        remarks.append(f"error common to the modes of a pose: {plain(100 * result.scatter, 2)} %")
    if result.undetectable:
        remarks.append(f"not detectable with these data: {', '.join(result.undetectable)}")
    if limits := largest_limits(result):
        remarks.append(f"not excluded at 95 %: {', '.join(limits)}; all limits: --json or --report")
    remarks += [f"note: {text}" for text in result.notes]
    remarks += [text] if (text := stability_sentence(result)) else []
    for remark in remarks:
        terminal.line()
        terminal.line(remark)


def largest_limits(result: Diagnosis) -> list[str]:
    """Return the limits of the absent effects that could change the frequencies most, if the verdict is settled."""
    if not result.settled:
        return []
    effects = {name: limit for name, limit in result.limits.items() if name.startswith(f"{limit.candidate}.")}
    ranked = sorted((n for n in effects if effects[n].value is not None), key=lambda n: -effects[n].change)
    largest_by_effect: dict[str, str] = {}  # of the parameters of an effect, the one that could change most
    for name in ranked:
        largest_by_effect.setdefault(effects[name].candidate, name)
    return [
        f"{name} up to {plain(value, 2)} {effects[name].unit}".removesuffix(" 1")
        for name in list(largest_by_effect.values())[:MAX_LIMITS_LISTED]
        if (value := effects[name].value) is not None
    ]


def _short_name(value: Value) -> str:
    return value.name.removeprefix("effects.")


def _with_sigma(value: Value) -> str:
    unit = "" if value.unit == "1" else f" {value.unit}"
    return f"{value.rounded}{unit}"
