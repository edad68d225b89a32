"""A function as a straight-line program: named values, common subexpressions, results, in order.

All languages print the same program, so they compute the same numbers.  Common subexpressions are found
once over all expressions together (`sympy.cse`); the names that the derivation gave are kept, and only what
is left over gets a number.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from sympy import Expr, Symbol, count_ops, cse, default_sort_key, preorder_traversal

from pkmodes_derive.functions import Function, Output


@dataclass(frozen=True)
class Program:
    """What every printer prints.

    Attributes
    ----------
    inputs : tuple of sympy.Symbol
        Symbols that are neither defined in `steps` nor constants: arguments and parameters, sorted.
    steps : tuple of (sympy.Symbol, sympy.Expr)
        Assignments; each uses inputs and earlier steps only.
    results : tuple of (Output, tuple of sympy.Expr)
        The outputs; entries are short expressions in inputs and steps.
    operations_written_out : int
        Operations if every named value were written out wherever it is used.
    operations : int
        Operations of the program as it stands.
    """

    inputs: tuple[Symbol, ...]
    steps: tuple[tuple[Symbol, Expr], ...]
    results: tuple[tuple[Output, tuple[Expr, ...]], ...]
    operations_written_out: int
    operations: int


def arrange(function: Function) -> Program:
    """Select what `function` needs, share common subexpressions, and put the steps in order."""
    names = _needed(function)
    entries = [entry for output in function.outputs for entry in output.entries]
    before = _written_out(function.definitions, entries)
    shared, reduced = cse([function.definitions[name] for name in names] + entries, order="canonical")
    expressions = dict(shared)
    named = dict(zip(names, reduced[: len(names)], strict=True))

    # A shared subexpression that is all of a named value takes that value's name.
    alias: dict[Symbol, Symbol] = {}
    for name, expression in named.items():
        if expression in expressions and expression not in alias:
            alias[expression] = name
            named[name] = expressions[expression]
    # A sign is not worth a name: SymPy shares -r, but r - a reads better than -a - t1 with t1 = -r.
    inline = dict(alias)
    for s, e in shared:
        if (-e).is_Symbol:
            inline[s] = -(-e).xreplace(alias)
    expressions = {s: e.xreplace(inline) for s, e in expressions.items() if s not in inline}
    expressions.update({name: e.xreplace(inline) for name, e in named.items()})
    results = [entry.xreplace(inline) for entry in reduced[len(names) :]]

    order = _topological(expressions, names, results)
    number = {
        s: Symbol(f"t{i}", real=True) for i, s in enumerate((s for s in order if s not in named), start=1)
    }
    steps = tuple((number.get(s, s), expressions[s].xreplace(number)) for s in order)
    results = [entry.xreplace(number) for entry in results]
    defined = {s for s, _ in steps}
    used = {s for e in [*(e for _, e in steps), *results] for s in e.free_symbols}
    return Program(
        inputs=tuple(sorted(used - defined, key=default_sort_key)),
        steps=steps,
        results=tuple(_regroup(function.outputs, results)),
        operations_written_out=before,
        operations=sum(int(count_ops(e)) for e in [*(e for _, e in steps), *results]),
    )


def _needed(function: Function) -> list[Symbol]:
    """Defined symbols that the outputs depend on, in the order of their definitions."""
    wanted = {s for output in function.outputs for entry in output.entries for s in entry.free_symbols}
    needed = []
    for symbol in reversed(function.definitions):
        if symbol in wanted:
            needed.append(symbol)
            wanted |= function.definitions[symbol].free_symbols
    return needed[::-1]


def _written_out(definitions: Mapping[Symbol, Expr], entries: list[Expr]) -> int:
    cost: dict[Symbol, int] = {}

    def count(expression: Expr) -> int:
        names = (node for node in preorder_traversal(expression) if isinstance(node, Symbol))
        return int(count_ops(expression)) + sum(cost.get(name, 0) for name in names)

    for symbol, expression in definitions.items():
        cost[symbol] = count(expression)
    return sum(count(entry) for entry in entries)


def _topological(
    expressions: Mapping[Symbol, Expr], names: list[Symbol], results: list[Expr]
) -> list[Symbol]:
    """Named values in the order of the derivation, each shared subexpression just before its first use."""
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


def _regroup(outputs: tuple[Output, ...], entries: list[Expr]) -> list[tuple[Output, tuple[Expr, ...]]]:
    groups, start = [], 0
    for output in outputs:
        stop = start + len(output.entries)
        groups.append((output, tuple(entries[start:stop])))
        start = stop
    return groups
