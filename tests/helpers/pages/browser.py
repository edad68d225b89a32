"""A real browser for pages from pkmodes: headless Chromium, which may load nothing but the page itself."""

from __future__ import annotations

import asyncio
import functools
import shutil
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any, Literal

from helpers.runs.programs import absent

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
#: WebGL without a graphics card.
SOFTWARE_WEBGL = ("--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader")
#: Longer than any machine takes for what a test waits for [ms].
TIMEOUT = 600_000
#: Impacts of findings of axe-core that no page may have.
GRAVE = ("serious", "critical")


@dataclass
class Opened:
    """An open page: the page of Playwright, what it wrote to the console, and what it asked for."""

    page: Any
    problems: list[str] = field(default_factory=list)
    requests: list[str] = field(default_factory=list)

    @property
    def outside(self) -> list[str]:
        """Requests for anything but the page and what it contains."""
        own = (self.page.url.split("#")[0], "data:", "blob:")
        return [address for address in self.requests if not address.startswith(own)]

    @property
    def sideways(self) -> bool:
        """Whether the page scrolls sideways."""
        return bool(self.page.evaluate("document.documentElement.scrollWidth > window.innerWidth"))

    def until(self, condition: str, argument: Any = None) -> None:
        """Wait until JavaScript holds; the policy of a page forbids the way of Playwright."""
        end = time.monotonic() + TIMEOUT / 1000
        while not self.page.evaluate(condition, argument):
            if time.monotonic() > end:
                raise TimeoutError(condition)
            self.page.wait_for_timeout(20)

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

    def findings_in_light_and_dark(self) -> list[str]:
        """Return the grave findings of axe-core where light colours are preferred, and where dark ones are."""
        found = []
        for scheme in ("light", "dark"):
            self.page.emulate_media(color_scheme=scheme)
            found += [f"{scheme}: {one}" for one in self.findings()]
        return found


@contextmanager
def opened(
    place: Path | str,
    *,
    width: int = 1280,
    height: int = 900,
    scheme: Literal["light", "dark"] = "light",
    media: Literal["screen", "print"] = "screen",
    motion: Literal["no-preference", "reduce"] = "no-preference",
    arguments: tuple[str, ...] = SOFTWARE_WEBGL,
    **options: Any,
) -> Iterator[Opened]:
    """Open a file or an address in headless Chromium; further options are those of the browser's context.

    Where there is none, the test is skipped, but not where CI is set: there it fails.
    """
    if CHROMIUM is None:
        absent("Chromium: install the Debian package chromium")
    with _playing():
        context = _browser(arguments).new_context(
            viewport={"width": width, "height": height},
            color_scheme=scheme,
            reduced_motion=motion,
            **options,
        )
        context.set_default_timeout(TIMEOUT)
        try:
            page = context.new_page()
            page.emulate_media(media=media)
            view = Opened(page)
            page.on("console", lambda message: view.problems.append(message.text))
            page.on("pageerror", lambda error: view.problems.append(str(error)))
            page.on("request", lambda request: view.requests.append(request.url))
            page.on("requestfailed", lambda request: view.problems.append(f"failed: {request.url}"))
            page.goto(place.resolve().as_uri() if isinstance(place, Path) else place)
            yield view
        finally:
            context.close()


@functools.cache
def _playwright() -> tuple[Any, asyncio.AbstractEventLoop]:
    """Playwright and its event loop, from the first page of this process to `close_browsers`."""
    from playwright.sync_api import sync_playwright

    playwright = sync_playwright().start()
    loop = asyncio._get_running_loop()
    assert loop is not None
    return playwright, loop


@functools.cache
def _browser(arguments: tuple[str, ...]) -> Any:
    """Return the browser that was started with these arguments: a page has a context of its own in it."""
    playwright, _ = _playwright()
    return playwright.chromium.launch(executable_path=CHROMIUM, args=["--no-sandbox", *arguments])


@contextmanager
def _playing() -> Iterator[None]:
    """Let Playwright's event loop be that of this thread, and none while other tests run, which may start their own.

    Playwright runs it in a greenlet of this thread, where asyncio takes it for running until Playwright stops.
    """
    before = asyncio._get_running_loop()  # that of Playwright where another page is open already
    _, loop = _playwright()
    asyncio._set_running_loop(loop)
    try:
        yield
    finally:
        asyncio._set_running_loop(before)


def close_browsers() -> None:
    """End Playwright, and with it the browsers that it started."""
    if _playwright.cache_info().currsize:
        playwright, loop = _playwright()
        asyncio._set_running_loop(loop)
        playwright.stop()
        asyncio._set_running_loop(None)
        _browser.cache_clear()
        _playwright.cache_clear()


class _Quiet(SimpleHTTPRequestHandler):
    def log_message(self, format: str, *args: object) -> None:  # noqa: A002 - the name in the library
        pass


@contextmanager
def served(folder: Path) -> Iterator[str]:
    """Serve a folder on a free port of this machine, and give its address."""
    handler = functools.partial(_Quiet, directory=str(folder))
    with ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        thread = threading.Thread(target=server.serve_forever)
        thread.start()
        try:
            yield f"http://127.0.0.1:{server.server_port}"
        finally:
            server.shutdown()
            thread.join()
