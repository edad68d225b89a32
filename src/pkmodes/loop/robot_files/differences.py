"""Differences between two robot files of one mechanism: values with their uncertainties, and effects."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Annotated

from msgspec import Meta

from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.base.numbers import plain
from pkmodes.core.robot.covariance import COVARIANCE
from pkmodes.core.robot.declaration import Declaration
from pkmodes.core.robot.layout import items_by_path, overrides_by_path
from pkmodes.core.robot.tables import STATE_OF_MOTORS
from pkmodes.core.robot.usable import limit_values
from pkmodes.core.support.documents import Document


class ValueDifference(Document, frozen=True):
    """A quantity that the two robots declare differently."""

    path: Annotated[str, Meta(description="Its dotted path.")]
    unit: Annotated[str, Meta(description="Its SI unit; 1 if dimensionless.")]
    first: Annotated[float | None, Meta(description="Value of the first robot; null where it declares none.")]
    second: Annotated[
        float | None, Meta(description="Value of the second robot; null where it declares none.")
    ]
    first_sigma: Annotated[float | None, Meta(description="Standard deviation; null where none is declared.")]
    second_sigma: Annotated[float | None, Meta(description="Likewise of the second robot.")]
    relative: Annotated[
        float | None,
        Meta(description="second / first - 1; null where one is not declared, or the first is 0."),
    ]


class ChoiceDifference(Document, frozen=True):
    """A choice, such as a direction, or the correlations, that the two robots declare differently."""

    path: Annotated[str, Meta(description="Its dotted path.")]
    first: Annotated[str, Meta(description="As the first robot has it.")]
    second: Annotated[str, Meta(description="As the second robot has it.")]


@dataclass(frozen=True)
class Differences:
    """Differences between the declarations of two robots.

    - values: in the order of the first file, then those of the second alone
    - added, removed: effects that only the second robot has, and only the first
    - compared: quantities that were compared
    """

    values: tuple[ValueDifference, ...]
    choices: tuple[ChoiceDifference, ...]
    added: tuple[str, ...]
    removed: tuple[str, ...]
    compared: int


def check_one_mechanism(first: Declaration, second: Declaration) -> None:
    """Refuse robots of different mechanisms, whose values and poses cannot be compared.

    Raises PkmodesError.
    """
    if first.mechanism_name != second.mechanism_name:
        problem = (
            f"expected two robots of one mechanism, found {first.mechanism_name} and {second.mechanism_name}"
        )
        raise PkmodesError(
            problem, f"{first.source}, {second.source}", "compare two files of the same mechanism"
        )


def differences(first: Declaration, second: Declaration) -> Differences:
    """Compare the declarations of two robots.

    An axis's own value is compared with the shared one where the other robot has none of its own.

    Raises PkmodesError if their mechanisms differ.
    """
    check_one_mechanism(first, second)
    robots, mechanism_items, compared = (
        (first, second),
        items_by_path(first.mechanism),
        list[ValueDifference](),
    )
    for path in dict.fromkeys([*first.quantities, *second.quantities]):
        # A shared value is not compared by itself where the other robot's axes have their own.
        overrides = [item.path for item in overrides_by_path(first.mechanism).get(path, ())]
        overridden = any(name in robot.quantities for robot in robots for name in overrides)
        if overridden and not all(path in robot.quantities for robot in robots):
            continue
        item = mechanism_items.get(path)
        shared = "" if item is None or not item.shared else path.replace(item.path, item.shared, 1)
        quantities = [robot.quantities.get(path, robot.quantities.get(shared)) for robot in robots]
        unit = next(quantity.unit for quantity in quantities if quantity is not None)
        before, after = (None if quantity is None else quantity.value for quantity in quantities)
        sigma_before, sigma_after = (None if quantity is None else quantity.sigma for quantity in quantities)
        relative = _relative(before, after)
        compared.append(ValueDifference(path, unit, before, after, sigma_before, sigma_after, relative))
    limits = [limit_values(robot.mechanism, robot.usable) for robot in robots]
    for path in dict.fromkeys([*limits[0], *limits[1]]):
        unit = (limits[0].get(path) or limits[1][path])[1]
        before, after = (numbers[path][0] if path in numbers else None for numbers in limits)
        compared.append(ValueDifference(path, unit, before, after, None, None, _relative(before, after)))
    choices = [
        ChoiceDifference(path, str(choice), str(second.declared[path]))
        for path, choice in first.declared.items()
        if path not in first.quantities and path in second.declared and choice != second.declared[path]
    ]
    if first.drives != second.drives:
        choices.append(ChoiceDifference(STATE_OF_MOTORS, first.drives, second.drives))
    first_effects, second_effects = (
        list(dict.fromkeys(path.split(".")[0] for path in robot.effects)) for robot in robots
    )
    return Differences(
        tuple(
            difference
            for difference in compared
            if (difference.first, difference.first_sigma) != (difference.second, difference.second_sigma)
        ),
        (*choices, *_correlations(first, second)),
        tuple(name for name in second_effects if name not in first_effects),
        tuple(name for name in first_effects if name not in second_effects),
        len(compared),
    )


def _relative(first: float | None, second: float | None) -> float | None:
    return second / first - 1.0 if first and second is not None else None


def _correlations(first: Declaration, second: Declaration) -> Iterator[ChoiceDifference]:
    """Yield one entry if the errors of values are correlated differently."""
    first_pairs, second_pairs = (_correlation_by_pair(robot) for robot in (first, second))
    before, after = _correlation_words(first_pairs), _correlation_words(second_pairs)
    if first_pairs != second_pairs:
        largest_difference = max(
            abs(first_pairs.get(pair, 0.0) - second_pairs.get(pair, 0.0))
            for pair in first_pairs.keys() | second_pairs.keys()
        )
        clause = (
            f", which differ from those by up to {plain(largest_difference, 2)}"
            if first_pairs and second_pairs
            else ""
        )
        yield ChoiceDifference(COVARIANCE, before, after + clause)
    elif first_pairs and _stated_sigmas(first) != _stated_sigmas(second):
        yield ChoiceDifference(COVARIANCE, before, f"{after}, the same with other standard deviations")


def _correlation_by_pair(robot: Declaration) -> dict[frozenset[str], float]:
    """Return the correlation of each pair of values that are correlated."""
    return {
        frozenset((table.paths[i], table.paths[k])): rate
        for table in robot.covariance
        for i, row in enumerate(table.correlation)
        for k, rate in enumerate(row[:i])
        if rate
    }


def _stated_sigmas(robot: Declaration) -> dict[str, float]:
    """Return the standard deviations that tables of correlations state."""
    return {
        path: sigma
        for table in robot.covariance
        for path, sigma in zip(table.paths, table.sigmas or (), strict=False)
    }


def _correlation_words(pairs: Mapping[frozenset[str], float]) -> str:
    """Return a table of correlations in words."""
    count = len({path for pair in pairs for path in pair})
    return f"correlations of {count} values" if count else "no correlations"
