"""Build the parsed robot file that declares given values: the inverse of reading dotted paths."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from pkmodes.core.mechanism.described import Mechanism
from pkmodes.core.robot.covariance import COVARIANCE, Covariance
from pkmodes.core.robot.layout import EFFECTS, items, lent
from pkmodes.core.robot.report_fields import REPORT
from pkmodes.core.robot.tables import FORMAT
from pkmodes.core.robot.usable import USABLE, Bound, raw_of


def document_of(
    mechanism: Mechanism,
    name: str,
    values: Mapping[str, Any],
    usable: Mapping[str, Bound] | None = None,
    report: Mapping[str, str] | None = None,
    covariance: Sequence[Covariance] = (),
) -> dict[str, Any]:
    """Return the document of a robot file with only these values.

    Parameters
    ----------
    name : str
        The robot's name.
    values : mapping of str to value
        By path, as a file could contain them; a vector by all of its elements.
    usable : mapping of str to Limits, Radius or SingularAngle, optional
        Where the machine is used.
    report : mapping of str to str, optional
        Fields of the head of reports.
    covariance : sequence of Covariance, optional
        Values whose errors belong together.

    Raises
    ------
    KeyError
        If an element of a vector is missing.
    """
    document: dict[str, Any] = {"format": FORMAT, "name": name, "mechanism": mechanism.name}
    for table in mechanism.tables:
        if table.count:
            document[table.name] = [{} for _ in range(table.count)]
    for item in items(mechanism):
        elements = [number.path for number in item.numbers if number.path != item.path]
        if item.path in values:
            _put(document, item.place, values[item.path])
        elif any(path in values for path in elements):
            _put(document, item.place, [values[path] for path in elements])
    for path, raw in values.items():
        # A value that an effect takes from a table is declared in the table; the effect only repeats it.
        if path.startswith(f"{EFFECTS}.") and lent(mechanism).get(path) not in values:
            _put(document, tuple(path.split(".")), raw)
    if usable:
        document[USABLE] = {name: raw_of(bound) for name, bound in usable.items()}
    if report:
        document[REPORT] = dict(report)
    if covariance:
        document[COVARIANCE] = [table.raw() for table in covariance]
    return document


def _put(document: dict[str, Any], place: tuple[str | int, ...], raw: Any) -> None:
    node: Any = document
    for key in place[:-1]:
        node = node[key] if isinstance(key, int) else node.setdefault(key, {})
    node[place[-1]] = raw
