"""Regenerate the committed code and the LaTeX page: ``python -m pkmodes_derive``."""

from __future__ import annotations

import argparse
from pathlib import Path

from pkmodes_derive.emit import product

ROOT = Path(__file__).parents[2]


def main() -> None:
    """Write the parametric models below ``generated/`` and, on request, the derivation as a page."""
    parser = argparse.ArgumentParser(prog="python -m pkmodes_derive", description=main.__doc__)
    commands = parser.add_subparsers(dest="command", required=True)
    generate = commands.add_parser("generate", help="write the parametric model of every mechanism")
    generate.add_argument("--out", type=Path, default=ROOT / "generated" / "pkmodes_generated")
    arguments = parser.parse_args()
    for mechanism in product.MECHANISMS:
        folder = arguments.out / mechanism
        folder.mkdir(parents=True, exist_ok=True)
        for name, text in product.parametric(mechanism).items():
            (folder / name).write_bytes(text.encode("utf-8"))
            print(folder / name)


if __name__ == "__main__":
    main()
