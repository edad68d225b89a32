r"""The chain rule over named intermediate values: differentiate without ever expanding.

A `Chain` holds two things.  *Definitions* give a symbol its expression in terms of earlier symbols.
*Rules* give the derivative of a symbol with respect to a variable where that derivative is known by other
means, such as the implicit function theorem for the dependent coordinates of a closed loop.  The total
derivative of an expression e is then

.. math:: \frac{de}{dv} = \sum_s \frac{\partial e}{\partial s} \frac{ds}{dv},

where ds/dv is 1 if s is v, the rule if there is one, and otherwise the derivative of the definition of s.
Expressions stay as short as if written by hand, which keeps the derivation fast and the generated code
readable (SymPy is slow on large expressions, not on many small ones).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from sympy import Add, Expr, Integer, Symbol, default_sort_key

from pkmodes_derive.differentiation import partial_derivative


class Chain:
    """Ordered definitions of intermediate values, and derivative rules for some of them."""

    def __init__(self) -> None:
        self._definitions: dict[Symbol, Expr] = {}
        self._rules: dict[tuple[Symbol, Symbol], Expr] = {}
        self._cache: dict[tuple[Symbol, Symbol, frozenset[Symbol]], Expr] = {}
        self._partials: dict[tuple[Expr, Symbol], Expr] = {}
        self._sorted_symbols: dict[Expr, list[Symbol]] = {}

    def copy(self, *, rules: bool = True) -> Chain:
        """Return a chain with the definitions made so far, and with the rules or without."""
        result = Chain()
        result._definitions, result._rules = dict(self._definitions), dict(self._rules) if rules else {}
        return result

    @property
    def definitions(self) -> Mapping[Symbol, Expr]:
        """Definitions in the order they were made; each uses only earlier ones and inputs."""
        return dict(self._definitions)

    def define(self, symbol: Symbol, expression: Expr) -> Symbol:
        """Name an expression.

        Raises
        ------
        ValueError
            If the symbol is already defined.
        """
        if symbol in self._definitions:
            raise ValueError(f"{symbol} is defined twice")
        self._definitions[symbol] = expression
        return symbol

    def redefine(self, symbol: Symbol, expression: Expr) -> None:
        """Replace the definition of a symbol, and clear the caches that depend on the earlier one."""
        self._definitions[symbol] = expression
        self._cache.clear()
        self._partials.clear()
        self._sorted_symbols.clear()

    def rule(self, symbol: Symbol, variable: Symbol, derivative: Expr) -> None:
        """Set d(symbol)/d(variable), which takes precedence over the symbol's definition."""
        if (symbol, variable) in self._rules:
            raise ValueError(f"d{symbol}/d{variable} is set twice")
        self._rules[symbol, variable] = derivative
        self._cache.clear()

    def derivative(self, expression: Expr, variable: Symbol, hold: Iterable[Symbol] = ()) -> Expr:
        """Return the total derivative of an expression, with the symbols in `hold` constant.

        Holding the dependent coordinates gives the partial derivative that the implicit function theorem
        needs.
        """
        return self._derivative(expression, variable, frozenset(hold))

    def hessian(
        self, expression: Expr, variables: Iterable[Symbol], hold: Iterable[Symbol] = ()
    ) -> list[list[Expr]]:
        """Return the second total derivatives; the lower triangle repeats the upper one."""
        symbols, held_symbols = tuple(variables), frozenset(hold)
        gradient = [self.derivative(expression, v, held_symbols) for v in symbols]
        upper = {
            (k, m): self.derivative(gradient[k], symbols[m], held_symbols)
            for k in range(len(symbols))
            for m in range(k, len(symbols))
        }
        return [[upper[min(k, m), max(k, m)] for m in range(len(symbols))] for k in range(len(symbols))]

    def expand(self, expression: Expr) -> Expr:
        """Replace every symbol by its definition, down to the inputs (for tests: the result may be huge)."""
        for symbol in reversed(self._definitions):
            expression = expression.xreplace({symbol: self._definitions[symbol]})
        return expression

    def _derivative(self, expression: Expr, variable: Symbol, hold: frozenset[Symbol]) -> Expr:
        terms = []
        for symbol in self._symbols(expression):
            inner = self._symbol_derivative(symbol, variable, hold)
            if inner != 0:
                terms.append(self._partial(expression, symbol) * inner)
        return Add(*terms)

    def _symbols(self, expression: Expr) -> list[Symbol]:
        # SymPy returns free symbols as a set; sorting keeps the output independent of hashing.
        if expression not in self._sorted_symbols:
            self._sorted_symbols[expression] = sorted(expression.free_symbols, key=default_sort_key)
        return self._sorted_symbols[expression]

    def _partial(self, expression: Expr, symbol: Symbol) -> Expr:
        # Cached: it is the same for every variable.
        if (expression, symbol) not in self._partials:
            self._partials[expression, symbol] = partial_derivative(expression, symbol)
        return self._partials[expression, symbol]

    def _symbol_derivative(self, symbol: Symbol, variable: Symbol, hold: frozenset[Symbol]) -> Expr:
        if symbol == variable:
            return Integer(1)
        if symbol in hold:
            return Integer(0)
        key = (symbol, variable, hold)
        if key not in self._cache:
            if (symbol, variable) in self._rules:
                value = self._rules[symbol, variable]
            elif symbol in self._definitions:
                value = self._derivative(self._definitions[symbol], variable, hold)
            else:
                value = Integer(0)
            self._cache[key] = value
        return self._cache[key]
