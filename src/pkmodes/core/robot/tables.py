"""Read the tables of a parsed robot file one by one: values by path, and all problems."""

from __future__ import annotations

from collections.abc import Callable, Container, Mapping, Sequence
from functools import partial
from typing import Any, TypeVar

from pkmodes.core.base.drives import FREE
from pkmodes.core.base.errors import PkmodesError, RobotFileError, nearest_name, shown
from pkmodes.core.mechanism import registry
from pkmodes.core.mechanism.described import Mechanism
from pkmodes.core.robot import schema
from pkmodes.core.robot.covariance import COVARIANCE
from pkmodes.core.robot.layout import EFFECTS, GRAVITY, XYZ, items_by_path, table_sources
from pkmodes.core.robot.report_fields import REPORT, read_report
from pkmodes.core.robot.units import DIMENSIONS, Quantity, article, with_unit
from pkmodes.core.robot.usable import USABLE, Bound, read_usable
from pkmodes_description import Effect, EffectParameter, Key, Table

FORMAT_HELP = "see docs/reference/robot-file.md for the format"
FORMAT = 1
#: Keys that every robot file has before its tables.
HEAD_KEYS = ("format", "name", "mechanism", GRAVITY.name)
#: Key before the tables that says how the machine is used.
STATE_OF_MOTORS = "drives"
OWN_EFFECT_REMEDY = (
    "for an effect of your own, give the mechanism generated with it: --mechanism DIR/<mechanism>"
)
NUMBER_WORDS = ("no", "one", "two", "three", "four", "five", "six")

T = TypeVar("T")


class Tables:
    """The tables of a robot file.

    - document: the parsed file
    - source: its name, for messages

    Its attributes:
    - name: the robot's name
    - values: by path, as given in the tables: without merging and without defaults
    - effects: parameters of the effects in the file, by path
    - usable: limits of components of the pose, where the file gives any
    - report: fields for the header of reports
    - covariance: the tables of correlations as they were given: they need all values
    - drives: what the motors do where the machine is used

    Raises RobotFileError if the mechanism is unknown, because it defines the tables.
    """

    def __init__(self, document: Mapping[str, Any], source: str) -> None:
        self.source = source
        self.values: dict[str, schema.Value] = {}
        self.problems: list[PkmodesError] = []
        self._read_required(document, "format", lambda raw: schema.read_choice(raw, (FORMAT,)))
        self.name = self._read_required(document, "name", schema.read_name) or ""
        mechanism = self._read_required(document, "mechanism", self._find_mechanism)
        if mechanism is None:
            raise RobotFileError(self.problems)
        self.mechanism = mechanism
        self._read_key(document, GRAVITY, GRAVITY.name)
        for table in mechanism.tables:
            if table.count:
                self._read_repeated(
                    document, table, [t for t in mechanism.tables if t.shared_by == table.name]
                )
            elif table.name in document:
                self._read_table(document[table.name], table.name, table.keys, needed=not table.shared_by)
            elif not table.shared_by and any(key.default is None for key in table.keys):
                self._report_missing(table.name)
        self.effects = self._read_effects(document.get(EFFECTS, {}))
        tables = [table.name for table in mechanism.tables]
        self.usable: dict[str, Bound] = {}
        if USABLE not in tables:  # a user's mechanism may have a table of that name
            self.usable = read_usable(mechanism, document.get(USABLE, {}), self.problem)
        self.report: dict[str, str] = {}
        if REPORT not in tables:
            self.report = read_report(document.get(REPORT, {}), self.problem)
        self.covariance: Any = [] if COVARIANCE in tables else document.get(COVARIANCE, [])
        self.drives = FREE
        if STATE_OF_MOTORS not in tables and STATE_OF_MOTORS in document:
            self.drives = self._read_required(document, STATE_OF_MOTORS, schema.read_drives) or FREE
        optional_keys = EFFECTS, USABLE, REPORT, COVARIANCE, STATE_OF_MOTORS
        self._report_unknown(document, "", [*HEAD_KEYS, *tables, *optional_keys])

    def raise_problems(self) -> None:
        """Raise an error with all problems, if there are any."""
        if self.problems:
            raise RobotFileError(self.problems)

    def _find_mechanism(self, raw: Any) -> Mechanism:
        if not isinstance(raw, str):
            raise schema.RefusedError(f"expected the name of a mechanism, found {shown(raw)}", FORMAT_HELP)
        try:
            return registry.mechanism(raw)
        except PkmodesError as error:
            raise schema.RefusedError(error.what, error.remedy) from error

    def _read_repeated(self, document: Mapping[str, Any], table: Table, overrides: Sequence[Table]) -> None:
        """Read the entries of a repeated table, each with its overrides of shared values."""
        if table.name not in document:
            self._report_missing(table.name)
            return
        entries = document[table.name]
        number_given = len(entries) if isinstance(entries, list) else shown(entries)
        if number_given != table.count:
            count_text = NUMBER_WORDS[table.count] if table.count < len(NUMBER_WORDS) else str(table.count)
            self.problem(
                table.name,
                f"expected exactly {count_text} [[{table.name}]] tables, found {number_given}",
                f"describe each of the {count_text} once: {table.description}",
            )
        for j, entry in enumerate(entries[: table.count] if isinstance(entries, list) else ()):
            self._read_table(entry, f"{table.name}.{j + 1}", table.keys, overrides)

    def _read_table(
        self, raw: Any, path: str, keys: Sequence[Key], overrides: Sequence[Table] = (), needed: bool = True
    ) -> None:
        if not isinstance(raw, dict):
            self.problem(path, f"expected a table, found {shown(raw)}", FORMAT_HELP)
            return
        for key in keys:
            self._read_key(raw, key, f"{path}.{key.name}", needed)
        for table in overrides:
            if table.name in raw:
                self._read_table(raw[table.name], f"{path}.{table.name}", table.keys, needed=False)
        self._report_unknown(raw, path, [*(key.name for key in keys), *(table.name for table in overrides)])

    def _read_key(self, raw: Mapping[str, Any], key: Key, path: str, needed: bool = True) -> None:
        if key.name in raw:
            value = self._read_value(raw[key.name], path, lambda entry: schema.read_value(entry, key))
            if value is not None:
                self.values[path] = value
        elif needed and key.default is None:
            self._report_missing(path)

    def _read_effects(self, raw: Any) -> dict[str, Quantity]:
        """Read the effects; a value that an effect takes from a table must not be declared in both."""
        if not isinstance(raw, dict):
            self.problem(EFFECTS, f"expected a table, found {shown(raw)}", FORMAT_HELP)
            return {}
        for path, table_path in table_sources(self.mechanism).items():
            _, effect, name = path.split(".")
            effect_table, table = raw.get(effect), table_path.rpartition(".")[0]
            if table_path in self.values and isinstance(effect_table, dict) and name in effect_table:
                problem = f"the {name} of the {table} is declared twice"
                self.problem(path, problem, f"keep it in [{table}] and remove it here")
        values = values_from_tables(self.mechanism, self.values)
        quantities: dict[str, Quantity] = {}
        for name, table in raw.items():
            path = f"{EFFECTS}.{name}"
            applicable = self.mechanism.effects
            if name not in applicable and any(
                name in registry.mechanism(mechanism_name).effects for mechanism_name in registry.names()
            ):
                problem = f"the effect {name} does not apply to the mechanism {self.mechanism.name}"
                self.problem(
                    f"{EFFECTS}.{shown(name)}", problem, f"effects that apply: {', '.join(applicable)}"
                )
            elif name not in applicable:
                problem = f"unknown effect {shown(name)}"
                known = f"known: {', '.join(applicable)}; {OWN_EFFECT_REMEDY}"
                self.problem(f"{EFFECTS}.{shown(name)}", problem, nearest_name(name, applicable, known))
            elif not isinstance(table, dict):
                self.problem(path, f"expected a table, found {shown(table)}", f"write a table [{path}]")
            else:
                quantities |= self._read_effect(self.mechanism.effects[name], table, values)
        return quantities

    def _read_effect(
        self, effect: Effect, table: Mapping[str, Any], declared: Mapping[str, Quantity | None]
    ) -> dict[str, Quantity]:
        """Read the table of an effect; `declared` are values that other tables of the file give, by path."""
        names = [parameter.name for parameter in effect.parameters]
        numbers: dict[str, Any] = {}
        for key, entry in table.items():
            # A vector, such as ``offset``, stands for the parameters of its components, such as ``offset_x``.
            components = [name for name in names if name in (f"{key}_{axis}" for axis in XYZ)]
            if not components or key in names:
                numbers[key] = entry
            elif not isinstance(entry, list) or len(entry) != len(components):
                path = f"{EFFECTS}.{effect.name}.{key}"
                problem = f"expected a list of {len(components)} lengths, found {shown(entry)}"
                self.problem(path, problem, f"write {key} = [{', '.join(XYZ[: len(components)])}]")
            else:
                numbers |= dict(zip(components, entry, strict=True))
        for key in numbers:
            if key not in names:
                place = f"{EFFECTS}.{effect.name}"
                self.problem(place, f"unknown parameter {shown(key)}", nearest_name(key, names))

        def read(parameter: EffectParameter, path: str) -> Quantity | None:
            return self._read_value(
                numbers[parameter.name], path, partial(read_effect_parameter, parameter=parameter)
            )

        return read_effect_parameters(effect, numbers, read, declared, self.problem)

    def _read_required(self, document: Mapping[str, Any], key: str, read: Callable[[Any], T]) -> T | None:
        if key in document:
            return self._read_value(document[key], key, read)
        self._report_missing(key)
        return None

    def _read_value(self, raw: Any, path: str, read: Callable[[Any], T]) -> T | None:
        try:
            return read(raw)
        except schema.RefusedError as error:
            self.problem(f"{path}.{error.element}" if error.element else path, error.what, error.remedy)
            return None

    def _report_missing(self, path: str) -> None:
        self.problem(path, f"the key {path} is missing", f"add it; {FORMAT_HELP}")

    def _report_unknown(self, raw: Mapping[str, Any], path: str, known_names: Sequence[str]) -> None:
        for key in raw:
            if key not in known_names:
                # Without quotes if TOML allows a bare key.
                name = key if schema.is_bare_key(key) else shown(key)
                place = f"{path}.{name}" if path else name
                self.problem(place, f"unknown key {shown(key)}", nearest_name(key, known_names))

    def problem(self, path: str, what: str, remedy: str) -> None:
        """Add a problem at a path."""
        self.problems.append(PkmodesError(what, f"{self.source}: {path}", remedy))


def values_from_tables(
    mechanism: Mechanism, values: Mapping[str, schema.Value]
) -> dict[str, Quantity | None]:
    """Return the values that effects take from tables, by the path of the effect parameter.

    - values: of the tables, as the file gives them; values that it does not give have their default

    None for a value that is computed from another one, because no key declares it.
    """
    values_by_path: dict[str, Quantity | None] = {}
    for path, table_path in table_sources(mechanism).items():
        key = items_by_path(mechanism)[table_path].key
        value = values.get(table_path, default_of(key))
        if isinstance(value, Quantity):
            values_by_path[path] = value
        elif key.middle_of:
            values_by_path[path] = None
    return values_by_path


def read_effect_parameters(
    effect: Effect,
    names: Container[str],
    read: Callable[[EffectParameter, str], Quantity | None],
    declared: Mapping[str, Quantity | None],
    problem: Callable[[str, str, str], None],
) -> dict[str, Quantity]:
    """Return the parameters of an effect by path: given for the effect, taken from other tables, or zero.

    - names: of the parameters that the file gives for it
    - read: returns one of these, from the parameter and its path; None if it is refused
    - declared: from `values_from_tables`
    - problem: takes the path, what is wrong, and the remedy of each problem
    """
    alternatives = [p.name for p in effect.parameters if p.in_place_of]
    from_tables = [p.name for p in effect.parameters if f"{EFFECTS}.{effect.name}.{p.name}" in declared]
    declarable = [p.name for p in effect.parameters if p.name not in (*from_tables, *alternatives)]
    quantities: dict[str, Quantity] = {}
    for parameter in effect.parameters:
        path = f"{EFFECTS}.{effect.name}.{parameter.name}"
        excluded = [p.name for p in effect.excluded(parameter.name) if p.name in names]
        if parameter.name in names:
            value = read(parameter, path)
            if value is not None:
                quantities[path] = value
            if excluded and not parameter.in_place_of:
                message = f"expected {parameter.name} or {' and '.join(excluded)}, found both"
                problem(path, message, f"keep {parameter.name}, or {' and '.join(excluded)} in its place")
        elif path in declared:
            if (lent_value := declared[path]) is not None:
                quantities[path] = lent_value
        elif excluded or parameter.in_place_of:
            continue  # given by other parameters, or not at all: zero
        elif len(declarable) > 1:  # if an effect has several parameters, missing ones are zero
            quantities[path] = Quantity(0.0, parameter.unit)
        else:
            example = DIMENSIONS[dimension_of_effect(parameter.unit)][1]
            remedy = f'add it, for example {parameter.name} = "{example}"'
            problem(path, f"the parameter {parameter.name} is missing", remedy)
    return quantities


def default_of(key: Key) -> schema.Value | None:
    """Return the default of a quantity or vector; None if the file must give it, or it follows from another value."""
    if key.default is None or key.middle_of:
        return None
    element = Quantity(key.default, DIMENSIONS[key.dimension][0])
    return element if key.kind == "quantity" else (element,) * len(key.elements)


def read_effect_parameter(raw: Any, parameter: EffectParameter) -> Quantity:
    """Read a parameter of an effect; zero, its null value, is always allowed, otherwise the physical bounds apply."""
    dimension = dimension_of_effect(parameter.unit)
    quantity = schema.parse_quantity(raw, dimension)
    lower, upper = parameter.greater_than, parameter.less_than
    if lower is not None and quantity.value != 0.0 and quantity.value <= lower:
        bound = f"greater than {with_unit(lower, parameter.unit)}, or 0 for no effect"
        raise schema.RefusedError(
            f"expected {article(dimension)} {bound}, found {shown(raw)}", "check the sign and the number"
        )
    if upper is not None and quantity.value >= upper:
        problem = (
            f"expected {article(dimension)} less than {with_unit(upper, parameter.unit)}, found {shown(raw)}"
        )
        raise schema.RefusedError(problem, "check the number and its unit")
    return quantity


def dimension_of_effect(unit: str) -> str:
    """Return the dimension with this SI unit; of two, the one that describes a spring."""
    return [name for name, (si_unit, _) in DIMENSIONS.items() if si_unit == unit][-1]
