"""Photograph the live samples of docs/tutorial/gallery.md, in headless Chromium.

    make docs && python docs/figures/gallery.py build/site

writes the thumbnails of the gallery, which other pages show, too.
"""

from __future__ import annotations

import shutil
import sys
from collections.abc import Sequence
from io import BytesIO
from pathlib import Path

from PIL import Image
from playwright.sync_api import sync_playwright

FOLDER = Path(__file__).parent / "gallery"
#: Sample and element of its page that is photographed, by the name of the picture; the top of the page without one.
SHOWN = {
    "show": ("robot.html", ".pkview-frame"),
    "diagnosis": ("diagnosis.html", ""),
    "voron": ("voron.html", ""),
    "comparison": ("comparison.html", "#modes"),
    "identification": ("identification.html", "#records ~ section"),
    "map": ("map.html", ""),
    "response": ("response.html", "#responses"),
    "shaper": ("shaper.html", "#workspace"),
}
#: Viewport [px], width of a thumbnail, and colours of its palette.
VIEW, WIDTH, COLOURS = {"width": 1180, "height": 760}, 720, 128
WEBGL = ("--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader")


def main(arguments: Sequence[str]) -> None:
    """Write every thumbnail."""
    samples = Path(arguments[0]).resolve() / "samples"
    FOLDER.mkdir(exist_ok=True)
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=shutil.which("chromium") or shutil.which("chromium-browser"), args=list(WEBGL)
        )
        page = browser.new_page(viewport=VIEW, device_scale_factor=2)
        for name, (sample, part) in SHOWN.items():
            page.goto((samples / sample).as_uri())
            page.evaluate("document.querySelectorAll('details').forEach((part) => { part.open = true; })")
            page.wait_for_timeout(2000)  # until the machine is drawn
            if part:
                page.locator(part).first.evaluate("part => part.scrollIntoView()")
            image = Image.open(BytesIO(page.screenshot())).convert("RGB")
            size = (WIDTH, round(WIDTH * image.height / image.width))
            small = image.resize(size, Image.Resampling.LANCZOS)
            small.quantize(COLOURS, dither=Image.Dither.NONE).save(FOLDER / f"{name}.png", optimize=True)
        browser.close()


if __name__ == "__main__":
    main(sys.argv[1:])
