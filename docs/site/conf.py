"""The documentation site: Sphinx with MyST for the Markdown pages and numpydoc for the docstrings.

``make docs`` builds it.  The extensions of this folder typeset formulas (`mathml`), show the JSON schemas (`schemas`)
and give links the titles of pages (`links`).
"""

import sys
from importlib.resources import files
from pathlib import Path

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
sys.path[:0] = [str(HERE), *(str(ROOT / part) for part in ("src", "generated", "derive"))]

import numpydoc.xref  # noqa: E402
from pygments.lexers.special import TextLexer  # noqa: E402
from sphinx.application import Sphinx  # noqa: E402

import pkmodes  # noqa: E402 - from this checkout, whatever is installed

project = "pkmodes"
author = "The pkmodes developers"
project_copyright = author
version = release = pkmodes.__version__
language = "en"

extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "numpydoc",
    "sphinx_click",
    "mathml",
    "schemas",
    "links",
    "samples",
    "defined",
]
root_doc = "index"
exclude_patterns = ["site", "studies", "schemas"]
nitpicky = True
#: In docstrings, names without dots in single backquotes may be parameters and attributes, as numpydoc suggests; in
#: the help of a command, other commands.
nitpick_ignore_regex = [("py:obj", r"[a-z_]+|pkmodes [a-z]+")]

# Markdown as GitHub reads it: its anchors, $`...$` and ```math.
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 4
myst_fence_as_directive = ["math"]

autodoc_typehints = "none"  # docstrings give types with shapes and units
autodoc_member_order = "bysource"
numpydoc_show_class_members = False
numpydoc_class_members_toctree = False
numpydoc_xref_param_type = True
#: Types in docstrings that are links; words such as "sequence of" are none.
numpydoc_xref_ignore = "all"
numpydoc_xref_aliases = {name: f"pkmodes.{name}" for name in pkmodes.__all__ if name[0].isupper()} | {
    name: f"pkmodes.diagnosis.{name}" for name in pkmodes.diagnosis.__all__ if name[0].isupper()
}
numpydoc.xref.DEFAULT_LINKS.clear()  # to the documentation of Python and NumPy, which is not at hand offline
default_role = "py:obj"
smartquotes = False  # they would change the dashes of options
toc_object_entries_show_parents = "hide"

html_theme = "furo"
html_title = "pkmodes"
html_short_title = "pkmodes"
html_static_path = ["static", str(files("ziamath") / "fonts" / "STIXTwoMath-Regular.ttf")]
html_favicon = "static/favicon.svg"
html_css_files = ["site.css"]
html_js_files = ["site.js"]
html_copy_source = False
html_show_sourcelink = False
html_show_sphinx = False
html_math_renderer = "mathml"
html_theme_options = {
    "navigation_with_keys": False,
    "light_css_variables": {"color-brand-primary": "#0b5394", "color-brand-content": "#0b5394"},
    "dark_css_variables": {"color-brand-primary": "#7fb3e6", "color-brand-content": "#7fb3e6"},
}
pygments_style = "a11y-light"
pygments_dark_style = "a11y-dark"
highlight_language = "none"


def complete_captions(
    app: Sphinx, page: str, template: str, context: dict[str, object], doctree: object
) -> None:
    """Give the captions in the sidebar, which Sphinx makes headings, the level that headings need."""
    tree = str(context.get("furo_navigation_tree", ""))
    context["furo_navigation_tree"] = tree.replace('role="heading"', 'role="heading" aria-level="2"')


def show_examples(app: Sphinx, context: object, lines: list[str]) -> None:
    """Show the examples in the help of a command as code."""
    title, *commands = [line.removeprefix("| ") for line in lines if line.strip()]
    lines[:] = [f".. rubric:: {title.rstrip(':')}", "", ".. code-block:: sh", ""]
    lines += [f"   {command.removeprefix('  ')}" for command in commands] + [""]


def setup(app: Sphinx) -> None:
    """Adapt what Sphinx and the theme leave open."""
    app.add_lexer("csv", TextLexer)  # shown as they are: Pygments has no lexer for measurement files
    app.connect("sphinx-click-process-epilog", show_examples)
    app.connect("html-page-context", complete_captions, priority=900)
