"""A real browser for pages from pkmodes: headless Chromium, which may load nothing but the page itself."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal

import pytest

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
#: Impacts of findings of axe-core that no page may have.
GRAVE = ("serious", "critical")


@dataclass
class Opened:
    """An open page: the page of Playwright, what it wrote to the console, and what it asked for."""

    page: Any
    problems: list[str] = field(default_factory=list)
    requests: list[str] = field(default_factory=list)

    def findings(self) -> list[str]:
        """Return the grave findings of axe-core."""
        from axe_playwright_python.sync_playwright import Axe

        found = Axe().run(self.page).response["violations"]
        return [
            f"{one['id']}: {node['html'][:200]}"
            for one in found
            if one["impact"] in GRAVE
            for node in one["nodes"]
        ]


@contextmanager
def opened(
    file: Path,
    *,
    width: int = 1280,
    height: int = 900,
    scheme: Literal["light", "dark"] = "light",
    media: Literal["screen", "print"] = "screen",
) -> Iterator[Opened]:
    """Open a file in headless Chromium.

    Where there is none, the test is skipped, but not where CI is set: there it fails.
    """
    if CHROMIUM is None:
        if os.environ.get("CI"):
            pytest.fail("needs Chromium: install the Debian package chromium")
        pytest.skip("needs Chromium: install the Debian package chromium")
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=["--no-sandbox"])
        try:
            context = browser.new_context(viewport={"width": width, "height": height}, color_scheme=scheme)
            page = context.new_page()
            page.emulate_media(media=media)
            found = Opened(page)
            page.on("console", lambda message: found.problems.append(message.text))
            page.on("pageerror", lambda error: found.problems.append(str(error)))
            page.on("request", lambda request: found.requests.append(request.url))
            page.goto(file.resolve().as_uri())
            yield found
        finally:
            browser.close()
