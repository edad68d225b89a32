"""The command group: rejects repeated options, shows progress, and ends silently on an interrupt."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import click

from pkmodes.cli.progress import progress_line


class Commands(click.Group):
    """A group whose commands reject a repeated option, of which click would use only the last."""

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Find the command and check its options."""
        name, command, rest = super().resolve_command(ctx, args)
        if command is not None:
            _refuse_repetitions(click.Context(command, info_name=name, parent=ctx), rest)
        return name, command, rest

    def make_context(self, *args: Any, **kwargs: Any) -> click.Context:
        """Read the arguments; click itself would print an empty line on an interrupt."""
        with _interruptible():
            return super().make_context(*args, **kwargs)

    def invoke(self, ctx: click.Context) -> Any:
        """Run the command."""
        with _interruptible(), progress_line("loading"):
            return super().invoke(ctx)


@contextmanager
def _interruptible() -> Iterator[None]:
    try:
        yield
    except KeyboardInterrupt:
        raise click.Abort from None


def _refuse_repetitions(ctx: click.Context, arguments: list[str]) -> None:
    try:
        _, _, order = ctx.command.make_parser(ctx).parse_args(list(arguments))
    except click.UsageError:
        return  # the command itself reports the error
    for option in dict.fromkeys(order):
        once = isinstance(option, click.Option) and not (option.multiple or option.count or option.is_flag)
        if once and order.count(option) > 1:
            raise click.UsageError(f"option '{option.opts[0]}' is given more than once", ctx)
