"""Draw the picture of docs/how-to/shapers.md: shapers over a measured spectrum, by the commands of the page.

    python docs/figures/shapers.py [FOLDER]

writes it next to this file, or into another folder.
"""

from __future__ import annotations

import contextlib
import re
import shlex
import shutil
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

from pkmodes.cli import run

HERE = Path(__file__).parent
PAGE = HERE.parent / "how-to/shapers.md"
PICTURES = ("shapers",)


def main(arguments: Sequence[str]) -> None:
    """Write the picture."""
    folder = Path(arguments[0]).absolute() if arguments else HERE
    found = re.search(
        r"^(pkmodes identify .*\n)(pkmodes shaper --measured .*\n)", PAGE.read_text("utf-8"), re.MULTILINE
    )
    assert found is not None
    with tempfile.TemporaryDirectory() as name, contextlib.chdir(name):
        shutil.copytree(HERE.parents[1] / "examples/printer", ".", dirs_exist_ok=True)
        for line in found.groups():
            assert run(shlex.split(line)[1:]) == 0
        shutil.copy("shapers.svg", folder)


if __name__ == "__main__":
    main(sys.argv[1:])
