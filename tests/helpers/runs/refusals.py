"""Bad input by table: each call is refused, with words that are expected of it."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable

from pkmodes.core.base.errors import PkmodesError


def assert_refused(
    table: Iterable[tuple[Callable[[], object], str]], kind: type[Exception] = PkmodesError
) -> None:
    """Make every call of a table, and name those that are not refused with an error that has these words.

    Parameters
    ----------
    table : iterable of (callable, str)
        Calls, each with a regular expression that is found in the message.
    kind : type
        What is raised.
    """
    wrong = []
    for call, words in table:
        try:
            found = f"the result {call()!r:.200}"
        except kind as error:
            if re.search(words, str(error)):
                continue
            found = f'"{error}"'
        wrong.append(f'{found} instead of "{words}"')
    assert not wrong, "\n".join(wrong)
