"""Build hook of the wheel: add the robot files and examples, and compile the libraries of the mechanisms.

Without a C compiler the package is built all the same, and evaluates with NumPy.
"""

from __future__ import annotations

import runpy
import sys
import sysconfig
import tempfile
from pathlib import Path
from types import SimpleNamespace
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

ROOT = Path(__file__).parent
COMPILED = ROOT / "src/pkmodes/core/compiled"
LIBRARIES = "libraries"
#: Folders that `pkmodes examples` writes, and where it looks for them; in a checkout they lie beside the sources.
SUPPLIED = {folder: f"pkmodes/supplied/{folder}" for folder in ("robots", "examples")}


class CompiledLibraries(BuildHookInterface):  # type: ignore[misc]  # hatchling is only there while building
    """Hook of hatchling: ``[tool.hatch.build.targets.wheel.hooks.custom]``."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Add the examples and the compiled libraries; of an editable install both lie beside the sources."""
        if version != "editable":
            build_data["force_include"] |= {str(ROOT / folder): place for folder, place in SUPPLIED.items()}
        build = _build()
        cc = build.compiler()
        if cc is None:
            self._notice(build.WINDOWS if sys.platform == "win32" else "no C compiler found")
            return
        folder = COMPILED / LIBRARIES
        if version != "editable":
            self._temporary = tempfile.TemporaryDirectory()
            folder = Path(self._temporary.name)
        folder.mkdir(exist_ok=True)
        for header in sorted((ROOT / "generated/pkmodes_generated").glob(f"*/{build.HEADER}")):
            name = header.parent.name
            try:
                for old in (folder / f"{name}.so", *folder.glob(f"{name}.*.so")):  # of an editable install
                    old.unlink(missing_ok=True)
                library = build.build(header.read_text(encoding="utf-8"), folder, name, cc)
            except (build.BuildError, OSError) as error:
                self._notice(str(error))
                return
            if version != "editable":
                build_data["force_include"][str(library)] = (
                    f"pkmodes/core/compiled/{LIBRARIES}/{library.name}"
                )
        platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
        build_data["pure_python"] = False
        build_data["tag"] = f"py3-none-{platform}"

    def finalize(self, version: str, build_data: dict[str, Any], artifact_path: str) -> None:
        """Remove what was compiled for the wheel."""
        if hasattr(self, "_temporary"):
            self._temporary.cleanup()

    def _notice(self, why: str) -> None:
        self.app.display_warning(
            f"pkmodes is installed without its compiled evaluator ({why}): it evaluates with NumPy, some ten "
            "times slower"
            + ("" if sys.platform == "win32" else "; install a C compiler and then pkmodes again")
        )


def _build() -> SimpleNamespace:
    """The module that builds, without its package: what that imports is not installed while a wheel is built."""
    return SimpleNamespace(**runpy.run_path(str(COMPILED / "build.py")))
