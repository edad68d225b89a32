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
]
root_doc = "index"
exclude_patterns = ["site", "studies", "schemas"]
nitpicky = True
#: In docstrings, names without dots in single backquotes may be parameters and attributes, as numpydoc suggests.
nitpick_ignore_regex = [("py:obj", r"[a-z_]+")]

# Markdown as GitHub reads it: its anchors, $`...$` and ```math.
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 4
myst_fence_as_directive = ["math"]

autodoc_typehints = "none"  # docstrings give types with shapes and units
autodoc_member_order = "bysource"
autodoc_class_signature = "separated"
numpydoc_show_class_members = False
numpydoc_class_members_toctree = False
default_role = "py:obj"
toc_object_entries_show_parents = "hide"

html_theme = "furo"
html_title = "pkmodes"
html_short_title = "pkmodes"
html_static_path = ["static", str(files("ziamath") / "fonts" / "STIXTwoMath-Regular.ttf")]
html_css_files = ["site.css"]
html_js_files = ["site.js"]
html_copy_source = False
html_show_sourcelink = False
html_show_sphinx = False
html_math_renderer = "mathml"
html_theme_options = {"navigation_with_keys": False}
pygments_style = "a11y-light"
pygments_dark_style = "a11y-dark"
highlight_language = "none"


def setup(app: Sphinx) -> None:
    """Show measurement files as they are: Pygments has no lexer for them."""
    app.add_lexer("csv", TextLexer)
