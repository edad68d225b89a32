"""Regenerate the committed code and the derivation pages: ``python -m pkmodes_derive``."""

from __future__ import annotations

import argparse
from importlib.resources import files
from pathlib import Path

from pkmodes_derive import mechanisms
from pkmodes_derive.emit import latex, product

ROOT = Path(__file__).parents[2]


def main() -> None:
    """Write the parametric model of every mechanism, or the derivation pages in LaTeX."""
    parser = argparse.ArgumentParser(prog="python -m pkmodes_derive", description=main.__doc__)
    commands = parser.add_subparsers(dest="command", required=True)
    generate = commands.add_parser("generate", help="write the parametric model of every mechanism")
    generate.add_argument("--out", type=Path, default=Path(str(files("pkmodes_generated"))))
    page = commands.add_parser(
        "latex", help="write every derived quantity in LaTeX, a page for each mechanism"
    )
    page.add_argument("--out", type=Path, default=ROOT / "docs" / "derivation", help="folder for the pages")
    for command in (generate, page):
        command.add_argument("--mechanism", choices=mechanisms.names(), help="by default every mechanism")
    arguments = parser.parse_args()
    for mechanism in [arguments.mechanism] if arguments.mechanism else mechanisms.names():
        if arguments.command == "latex":
            _write(arguments.out / f"{mechanism}.md", latex.page(mechanisms.base(mechanism)))
            continue
        for name, text in product.parametric(mechanism).items():
            _write(arguments.out / mechanism / name, text)


def _write(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    staged = path.with_name(f".{path.name}.new")
    staged.write_bytes(text.encode("utf-8"))
    staged.replace(path)
    print(path)


if __name__ == "__main__":
    main()
