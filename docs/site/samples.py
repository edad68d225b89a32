"""A directive for live samples: commands of the gallery, run when the site is built, with links to what they wrote.

Where there is no site, as on GitHub, the commands stand as code.
"""

from __future__ import annotations

import contextlib
import io
import shlex
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from shutil import copy2
from tempfile import TemporaryDirectory

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.errors import ExtensionError
from sphinx.util.docutils import SphinxDirective

from pkmodes.cli import run

ROOT = Path(__file__).parents[2]
#: Folder of the site for what the commands write.
FOLDER = "samples"
LINKED = ("robots", "examples")
WORDS = {".html": "Open the live page", ".png": "Open the picture", ".gif": "Open the moving picture"}


class Sample(SphinxDirective):
    """``{sample} FILE`` with commands that write FILE: the commands, and a link to it."""

    required_arguments = 1
    has_content = True

    def run(self) -> list[nodes.Node]:
        """Return the commands and the link, and note the commands for the end of the build."""
        name, commands = self.arguments[0], "\n".join(self.content)
        samples = self.env.metadata[self.env.docname].setdefault("samples", {})
        samples[name] = commands
        code = nodes.literal_block(commands, commands, language="sh")
        up = "../" * self.env.docname.count("/")
        link = nodes.reference("", WORDS[Path(name).suffix], refuri=f"{up}{FOLDER}/{name}", internal=False)
        link["classes"].append("sample")
        return [code, nodes.paragraph("", "", link)]


def make(app: Sphinx, failed: Exception | None) -> None:
    """Run the commands of all samples, each after the other in one folder, and copy what they wrote.

    They run in this process, which has loaded pkmodes anyway.

    Raises
    ------
    ExtensionError
        If a command fails or does not write its file.
    """
    if failed is not None or app.builder.format != "html":
        return
    samples = {
        name: commands
        for about in app.env.metadata.values()
        for name, commands in about.get("samples", {}).items()
    }
    target = Path(app.outdir) / FOLDER
    with TemporaryDirectory() as place:
        for part in LINKED:
            (Path(place) / part).symlink_to(ROOT / part)
        for name, commands in samples.items():
            for command in commands.splitlines():
                words = shlex.split(command, comments=True)
                if words[0] != "pkmodes":
                    raise ExtensionError(f"sample {name}: expected a command of pkmodes, found {words[0]}")
                said = io.StringIO()
                with contextlib.chdir(place), redirect_stdout(said), redirect_stderr(said):
                    code = run(words[1:])
                if code != 0:
                    raise ExtensionError(f"sample {name}: {command} failed: {said.getvalue()}")
            if not (Path(place) / name).is_file():
                raise ExtensionError(f"sample {name}: its commands did not write it")
            (target / name).parent.mkdir(parents=True, exist_ok=True)
            copy2(Path(place) / name, target / name)


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the directive, and its work at the end."""
    app.add_directive("sample", Sample)
    app.connect("build-finished", make)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
