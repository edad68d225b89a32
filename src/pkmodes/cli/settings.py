"""Values of parameters on the command line: ranges to sweep, and the heights of a growing print."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

import click

from pkmodes.core.base.errors import PkmodesError, shown
from pkmodes.core.robot.declaration import changeable_units

if TYPE_CHECKING:
    from pkmodes.core.model import Model

#: A density times an area, each a number with its unit; the ** of a power such as m**2 is not taken for a product.
DENSITY_AND_AREA = re.compile(r"(.*[^*\s])\s*\*\s*([\d.][^*]*(?:\*\*[^*]*)?)")
HEIGHT_EXAMPLE = 'write --height 0:200mm, or density * area: --height "1.24 g/cm^3 * 40 cm^2"'

height_option = click.option(
    "--height",
    metavar="START:STOP",
    help="With one range in --set: heights of the print at its first and last values, such as 0:200mm; or, for a "
    'mass, density times area of the print, such as "1.24 g/cm^3 * 40 cm^2".  Each line for firmware then '
    "states the first layer it applies to.",
)


def settings_option(meaning: str) -> Callable[[Any], Any]:
    """Return the option for values of parameters; `meaning` is its help."""
    return click.option("--set", "settings", metavar="PATH=START:STOP:COUNT", multiple=True, help=meaning)


def parse_settings_option(model: Model, texts: tuple[str, ...]) -> dict[str, Any] | None:
    """Return the values of ``--set`` by path; None without any.

    Raises PkmodesError as `pkmodes.machine.maps.ranges.parse_settings` does.
    """
    if not texts:
        return None
    from pkmodes.machine.maps.ranges import parse_settings

    return parse_settings(texts, changeable_units(model.robot), "--set")


def parse_height_option(
    model: Model, text: str | None, settings: Mapping[str, Any] | None
) -> tuple[float, float] | None:
    """Return the heights of the first and the last value of ``--set`` [m]; None without ``--height``.

    Raises PkmodesError if it is neither two heights nor a density times an area, or if it is the latter and the
    parameter that is set is not a mass.
    """
    if text is None:
        return None
    ranges = {path: values for path, values in (settings or {}).items() if len(values) > 1}
    if len(ranges) != 1:
        problem = f"expected --set with one range for the heights, found {len(ranges)} of them"
        raise PkmodesError(
            problem, "--height", "for example: --set effects.payload.mass=0:1.2kg:7 --height 0:200mm"
        )
    from pkmodes.machine.maps.ranges import parse_value

    ends = text.split(":")
    if len(ends) == 2:
        low, high = (parse_value(end, "m", "--height") for end in ends)
        if not 0.0 <= low < high:
            problem = f"expected two heights, the lower one first, found {shown(text)}"
            raise PkmodesError(problem, "--height", f"a number without a unit is in m: {HEIGHT_EXAMPLE}")
        return low, high
    ((path, values),) = ranges.items()
    unit = changeable_units(model.robot)[path]
    if unit != "kg":
        problem = f"expected two heights, as {path} is no mass that a print could have, found {shown(text)}"
        raise PkmodesError(problem, "--height", "write --height 0:200mm")
    return 0.0, float(values.max() - values.min()) / _mass_per_height(text)


def _mass_per_height(text: str) -> float:
    """Read a density times an area [kg/m]."""
    from pkmodes.core.robot.units import NUMBER, QuantityError, check_plain_number, parse

    product = DENSITY_AND_AREA.fullmatch(text.strip())
    factors = () if product is None else product.groups()
    for factor in factors:
        try:
            check_plain_number(factor, "a density times an area")
        except QuantityError as error:
            raise PkmodesError(str(error), "--height", error.remedy) from None
    parts = [NUMBER.fullmatch(factor) for factor in factors]
    problem = f"expected two heights, or a density times an area, found {shown(text)}"
    if len(parts) != 2 or not all(part is not None and part[2] for part in parts):
        raise PkmodesError(problem, "--height", HEIGHT_EXAMPLE)
    (first_number, first_unit), (second_number, second_unit) = (
        (part[1], part[2]) for part in parts if part is not None
    )
    try:
        number = float(first_number) * float(second_number)
        linear_density = parse(f"{number!r} ({first_unit})*({second_unit})", "linear density")
    except QuantityError:
        raise PkmodesError(problem, "--height", HEIGHT_EXAMPLE) from None
    if not linear_density > 0.0:
        raise PkmodesError(
            f"expected a positive density and area, found {shown(text)}", "--height", HEIGHT_EXAMPLE
        )
    return linear_density
