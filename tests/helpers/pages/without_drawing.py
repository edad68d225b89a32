"""Pages and pictures without drawing, for tests of what else is on them: drawing takes most of the time of a page."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from html import escape

import pytest


@contextmanager
def without_drawing() -> Iterator[None]:
    """Let figures on pages have their names and descriptions only; captions, numbers and all else are as always.

    The files of ``pkmodes figures`` are written, but not drawn.
    """

    def named(figure: object, title: str, description: str, **_: object) -> str:
        inside = f"<title>{escape(title)}</title><desc>{escape(description)}</desc>"
        return f'<svg viewBox="0 0 2 1">{inside}</svg>'

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("pkmodes.pages.report.blocks.inline_svg", named)
        patch.setattr("pkmodes.pages.report.blocks.inline_narrow_svg", lambda *_: "")
        patch.setattr("pkmodes.pages.figures.files.image_bytes", lambda *_, **__: b"drawn")
        yield
