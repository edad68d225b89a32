"""Templates, which lay out lines and contain no mathematics; each language keeps its own with its code."""

from __future__ import annotations

from importlib.resources import files

from jinja2 import Environment, FunctionLoader, StrictUndefined


def render(package: str, template: str, /, **values: object) -> str:
    """Render a template of a package; an undefined name is an error, and the text ends with one newline."""
    folder = files(package)
    environment = Environment(
        loader=FunctionLoader(lambda name: folder.joinpath(name).read_text(encoding="utf-8")),
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=False,
    )
    return environment.get_template(template).render(**values).rstrip("\n") + "\n"
