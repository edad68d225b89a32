"""A function as a straight-line program: named values, common subexpressions, results, in order.

All languages print the same program, so they compute the same numbers.  Common subexpressions are found
once over all expressions together (`sympy.cse`); names from the derivation are kept, and only the remaining
subexpressions are numbered.  A second name for a value is not a step, a symmetric matrix is evaluated only in
its upper triangle, and structural zeros are not evaluated.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache

from sympy import Expr, Symbol, count_ops, cse, default_sort_key, preorder_traversal

from pkmodes_derive.functions import FieldGroup, Function, Output, mirrored
from pkmodes_derive.specialise import fold


@dataclass(frozen=True)
class Entry:
    """A value of an output, and the index of each place that takes it: two in a symmetric matrix."""

    value: Expr
    places: tuple[tuple[int, ...], ...]


@dataclass(frozen=True)
class Result:
    """An output with its values; all other entries are zero."""

    output: Output
    entries: tuple[Entry, ...]

    @property
    def has_zeros(self) -> bool:
        """Whether there are entries without a value."""
        return sum(len(entry.places) for entry in self.entries) < len(self.output.entries)


@dataclass(frozen=True)
class Program:
    """The program that every printer prints.

    Attributes
    ----------
    inputs : tuple of sympy.Symbol
        Symbols that are neither defined in `steps` nor constants: arguments and parameters, sorted.
    steps : tuple of (sympy.Symbol, sympy.Expr)
        Assignments; each uses inputs and earlier steps only.
    results : tuple of Result
        The outputs; values are short expressions in inputs and steps.
    operations_written_out : int
        Operations if every named value were written out wherever it is used.
    operations : int
        Operations of the emitted program.
    """

    inputs: tuple[Symbol, ...]
    steps: tuple[tuple[Symbol, Expr], ...]
    results: tuple[Result, ...]
    operations_written_out: int
    operations: int

    def groups(self, function: Function, groups: Sequence[FieldGroup]) -> list[FieldGroup]:
        """Return the groups of parameters that the program takes, which are those it needs.

        A function of the pose always takes the robot's parameters, so its signature is the same in every mechanism.
        """
        inputs = set(self.inputs)
        always = groups[:1] if function.arguments else ()
        return [g for g in groups if g in always or any(inputs & set(field.symbols) for field in g.fields)]


def arrange(function: Function) -> Program:
    """Select the definitions that `function` needs, share common subexpressions, and put the steps in order."""
    written_out = _operations_written_out(function)
    needed = {name: function.definitions[name] for name in _needed(function)}
    function = fold(replace(function, definitions=needed))
    names = list(function.definitions)
    outputs = [Result(output, _entries(output)) for output in function.outputs]
    values = [entry.value for result in outputs for entry in result.entries]
    shared, reduced = cse([function.definitions[name] for name in names] + values, order="canonical")
    named, expressions, values = _use_names(names, shared, reduced)
    order = _topological(expressions, named, values)
    named_symbols = set(named)
    number = {
        s: Symbol(f"t{i}", real=True)
        for i, s in enumerate((s for s in order if s not in named_symbols), start=1)
    }
    steps = tuple((number.get(s, s), expressions[s].xreplace(number)) for s in order)
    values = [value.xreplace(number) for value in values]
    defined = {s for s, _ in steps}
    used = {s for e in [*(e for _, e in steps), *values] for s in e.free_symbols}
    return Program(
        inputs=tuple(sorted(used - defined, key=default_sort_key)),
        steps=steps,
        results=_with_values(outputs, values),
        operations_written_out=written_out,
        operations=sum(_operations(e) for e in [*(e for _, e in steps), *values]),
    )


def _entries(output: Output) -> tuple[Entry, ...]:
    """Return the entries to be evaluated: no zeros, and only the upper triangle of a symmetric matrix."""
    symmetric, entries = output.symmetric, []
    for index, value in zip(output.indices, output.entries, strict=True):
        if value == 0 and not output.listed:
            continue
        if symmetric and index[-2] != index[-1]:
            if index[-2] < index[-1]:
                entries.append(Entry(value, (index, mirrored(index))))
        else:
            entries.append(Entry(value, (index,)))
    return tuple(entries)


def _use_names(
    names: Sequence[Symbol], shared: Sequence[tuple[Symbol, Expr]], reduced: Sequence[Expr]
) -> tuple[list[Symbol], dict[Symbol, Expr], list[Expr]]:
    """Return named values, the expressions of all steps, and results, with names in place of numbers if possible."""
    expressions = dict(shared)
    named: dict[Symbol, Expr] = {}
    alias: dict[Symbol, Symbol] = {}
    for name, expression in zip(names, reduced, strict=False):
        # A shared subexpression that equals a named value takes its name; if there are two, the first.
        if expression not in expressions:
            named[name] = expression
        elif expression in alias:
            alias[name] = alias[expression]
        else:
            alias[expression] = name
            named[name] = expressions[expression]
    # A sign is not worth a name: SymPy shares -r, but r - a reads better than -a - t1 with t1 = -r.
    inline: dict[Symbol, Expr] = dict(alias)
    for s, e in shared:
        if (-e).is_Symbol:
            inline[s] = -(-e).xreplace(alias)
    expressions = {s: e.xreplace(inline) for s, e in expressions.items() if s not in inline}
    expressions.update({name: e.xreplace(inline) for name, e in named.items()})
    return list(named), expressions, [value.xreplace(inline) for value in reduced[len(names) :]]


def _needed(function: Function) -> list[Symbol]:
    """Return the defined symbols that the outputs depend on, in the order of their definitions."""
    symbols = {s for output in function.outputs for entry in output.entries for s in entry.free_symbols}
    needed = []
    for symbol in reversed(function.definitions):
        if symbol in symbols:
            needed.append(symbol)
            symbols |= function.definitions[symbol].free_symbols
    return needed[::-1]


@cache
def _operations(expression: Expr) -> int:
    return int(count_ops(expression))


@cache
def _names(expression: Expr) -> tuple[Symbol, ...]:
    """Return the symbols of an expression, each as often as it occurs."""
    return tuple(node for node in preorder_traversal(expression) if isinstance(node, Symbol))


def _operations_written_out(function: Function) -> int:
    cost: dict[Symbol, int] = {}

    def count(expression: Expr) -> int:
        return _operations(expression) + sum(cost.get(name, 0) for name in _names(expression))

    for symbol in _needed(function):
        cost[symbol] = count(function.definitions[symbol])
    return sum(count(entry) for output in function.outputs for entry in output.entries)


def _topological(
    expressions: Mapping[Symbol, Expr], names: Sequence[Symbol], results: Sequence[Expr]
) -> list[Symbol]:
    """Return named values in the order of the derivation, each shared subexpression just before its first use."""
    order: dict[Symbol, None] = {}

    def visit(symbol: Symbol) -> None:
        if symbol in expressions and symbol not in order:
            visit_all(expressions[symbol])
            order[symbol] = None

    def visit_all(expression: Expr) -> None:
        for symbol in sorted(expression.free_symbols, key=default_sort_key):
            visit(symbol)

    for name in names:
        visit(name)
    for entry in results:
        visit_all(entry)
    return list(order)


def _with_values(results: Sequence[Result], values: Sequence[Expr]) -> tuple[Result, ...]:
    """Return the results with the values left after sharing, in the same order."""
    remaining = iter(values)
    return tuple(
        Result(r.output, tuple(Entry(next(remaining), entry.places) for entry in r.entries)) for r in results
    )
