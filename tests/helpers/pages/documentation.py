"""The pages of the documentation and their code blocks.

Comments before a block say what GitHub and the site need not show:

``<!-- file: NAME -->``    the block is the file NAME, ``append: NAME`` its continuation
``<!-- exit N -->``        the last command of the block ends with code N instead of 0
``<!-- from a fit -->``    numbers of this output agree to some digits only
``<!-- shortened -->``     the output has more lines, or more on a line
``<!-- fragment -->``      part of a robot file
``<!-- drawing -->``       text that nothing prints

Several are separated by semicolons.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import pytest
from markdown_it import MarkdownIt

ROOT = Path(__file__).parents[3]
PAGES = (
    "README.md",
    *sorted(path.relative_to(ROOT).as_posix() for path in (ROOT / "docs").rglob("*.md")),
    "examples/controller_1khz/README.md",
)
NUMBER = re.compile(r"(?<![\w.])[+-]?\d+(?:\.\d+)?(?:e[+-]?\d+)?(?!\w)")
HINT = re.compile(r"(?:file|append): [\w./-]+|exit \d|from a fit|shortened|fragment|drawing")
#: Blocks that another test runs, or that nothing can run, by the beginning of their first line.
ELSEWHERE = {
    ("README.md", "make demo"): "run by .ci/run",
    ("docs/how-to/adding-a-mechanism.md", ""): "tests/codegen/own_mechanism/test_page.py",
    (
        "docs/how-to/adding-a-mechanism-that-turns.md",
        "",
    ): "tests/codegen/own_mechanism/test_turning_platform.py",
    ("docs/how-to/adding-an-effect.md", ""): "tests/derive/effects/test_adding_an_effect.py",
    ("docs/how-to/an-effect-of-your-own.md", ""): "tests/loop/diagnosis/test_an_effect_of_your_own.py",
    ("docs/how-to/cluster.md", ""): "tests/machine/maps/test_workers.py without Slurm and Kubernetes",
    (
        "docs/reference/generated-code.md",
        "import linear_delta",
    ): "for a folder on Python's path; tests/codegen/test_generate.py",
    (
        "docs/reference/generated-code.md",
        "cc -std=c99 -O2 -DPKMODES_FLOAT",
    ): "my_robot.c stands for any robot's",
    (
        "docs/reference/json.md",
        "pkmodes diagnose robot.toml",
    ): "file names of the reader; tests/cli/test_diagnose.py",
    (
        "docs/how-to/releasing.md",
        "uv build",
    ): ".ci/reproducible builds; tests/core/compiled/test_other_processors.py cross-compiles",
    ("docs/explanation/published-tables.md", "python docs/studies"): "tests/test_published_tables.py",
    (
        "docs/reference/robot-file.md",
        "M, K = robot.modal_matrices",
    ): "tests/derive/effects/test_extended_model.py",
    ("docs/reference/robot-file.md", "error: expected a length"): "tests/core/robot/test_units.py",
    ("docs/explanation/voron.md", "python examples/voron"): "tests/test_voron.py",
    ("examples/controller_1khz/README.md", ""): "tests/test_controller_example.py",
}


@dataclass(frozen=True)
class Block:
    """A code block of a page.

    Attributes
    ----------
    page : str
        Its path in the repository.
    line : int
        Line of its opening fence, or its first line if it is indented, from 1.
    language : str
        As written after the fence; ``indented`` where there is none.
    text : str
    hints : tuple of str
        From the comment before it.
    """

    page: str
    line: int
    language: str
    text: str
    hints: tuple[str, ...]

    @property
    def elsewhere(self) -> str | None:
        """Where it is run instead, or why not at all."""
        for (page, start), reason in ELSEWHERE.items():
            if page == self.page and self.text.startswith(start):
                return reason
        return None

    def hint(self, word: str) -> str | None:
        """Return what follows a word in the hints; None without it."""
        return next((h.removeprefix(word).strip(": ") for h in self.hints if h.startswith(word)), None)


@cache
def blocks(page: str) -> tuple[Block, ...]:
    """Return the code blocks of a page; formulas and directives of Sphinx are none."""
    tokens = MarkdownIt("commonmark").parse((ROOT / page).read_text(encoding="utf-8"))
    found = []
    for before, token in zip([None, *tokens], tokens, strict=False):
        if token.type not in ("fence", "code_block") or token.info == "math" or token.info.startswith("{"):
            continue
        comment = before.content if before is not None and before.type == "html_block" else ""
        hints = tuple(
            h.strip() for h in comment.strip().removeprefix("<!--").removesuffix("-->").split(";") if h
        )
        assert token.map is not None
        language = token.info if token.type == "fence" else "indented"
        found.append(Block(page, token.map[0] + 1, language, token.content, hints))
    return tuple(found)


def same(shown: str, printed: str, *, fit: bool = False, shortened: bool = False) -> None:
    """Check that the lines shown were printed, in their order and apart from spaces and line breaks.

    Numbers are equal, or where they come from a fit nearly equal.
    """
    lines = [shown] if not shortened else shown.splitlines()
    words = printed.split()
    start = 0
    for line in lines:
        wanted = line.split()
        last = len(words) - len(wanted)
        places = range(start, last + 1)
        place = next((p for p in places if _all_alike(wanted, words[p : p + len(wanted)], fit=fit)), None)
        assert place is not None, f"not printed after what is shown before it: {line!r} in\n{printed}"
        start = place + len(wanted)
        assert shortened or (place == 0 and start == len(words)), (
            f"more was printed than is shown:\n{printed}"
        )


def _all_alike(shown: list[str], printed: list[str], *, fit: bool) -> bool:
    return all(_alike(a, b, fit=fit) for a, b in zip(shown, printed, strict=True))


def _alike(shown: str, printed: str, *, fit: bool) -> bool:
    """Return whether two words are equal, but for the numbers in them if they come from a fit."""
    if shown == printed or not fit:
        return shown == printed
    numbers = NUMBER.findall(shown), NUMBER.findall(printed)
    return NUMBER.sub("#", shown) == NUMBER.sub("#", printed) and all(
        _close(float(a), float(b)) for a, b in zip(*numbers, strict=True)
    )


def _close(a: float, b: float) -> bool:
    if 0.0 < a < 1e-9 and b > 0.0:  # p-values
        return math.log(a) == pytest.approx(math.log(b), rel=0.05)
    return a == pytest.approx(b, rel=0.05, abs=5e-3 if abs(a) > 5e-3 else 0.0)
