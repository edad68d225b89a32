r"""The chain rule over named intermediate values: differentiate without ever expanding.

A `Chain` holds two things.  *Definitions* give a symbol its expression in terms of earlier symbols.
*Rules* give the derivative of a symbol with respect to a variable where that derivative is known by other
means, as the implicit function theorem gives it for the dependent coordinates of a closed loop.  The total
derivative of an expression e is then

.. math:: \frac{de}{dv} = \sum_s \frac{\partial e}{\partial s} \frac{ds}{dv},

where ds/dv is 1 if s is v, the rule if there is one, and otherwise the derivative of the definition of s.
Expressions stay as short as a person would write them, which keeps the derivation fast and the generated
code readable (SymPy's cost is in large expressions, not in many small ones).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from sympy import Add, Expr, Integer, Symbol, default_sort_key, diff


class Chain:
    """Ordered definitions of intermediate values, and the rules by which some of them vary."""

    def __init__(self) -> None:
        self._definitions: dict[Symbol, Expr] = {}
        self._rules: dict[tuple[Symbol, Symbol], Expr] = {}
        self._cache: dict[tuple[Symbol, Symbol, frozenset[Symbol]], Expr] = {}
        self._partials: dict[tuple[Expr, Symbol], Expr] = {}

    @property
    def definitions(self) -> Mapping[Symbol, Expr]:
        """The definitions in the order in which they were made; each uses only earlier ones and inputs."""
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

    def rule(self, symbol: Symbol, variable: Symbol, derivative: Expr) -> None:
        """State d(symbol)/d(variable); it takes precedence over the symbol's definition."""
        if (symbol, variable) in self._rules:
            raise ValueError(f"d{symbol}/d{variable} is stated twice")
        self._rules[symbol, variable] = derivative
        self._cache.clear()

    def derivative(self, expression: Expr, variable: Symbol, hold: Iterable[Symbol] = ()) -> Expr:
        """Total derivative of an expression; the symbols in `hold` count as constants.

        Holding the dependent coordinates gives the partial derivative that the implicit function theorem
        needs.
        """
        return self._derivative(expression, variable, frozenset(hold))

    def hessian(
        self, expression: Expr, variables: Iterable[Symbol], hold: Iterable[Symbol] = ()
    ) -> list[list[Expr]]:
        """Second total derivatives; the lower triangle repeats the upper one, so the result is symmetric."""
        names, held = tuple(variables), frozenset(hold)
        gradient = [self.derivative(expression, v, held) for v in names]
        upper = {
            (k, m): self.derivative(gradient[k], names[m], held)
            for k in range(len(names))
            for m in range(k, len(names))
        }
        return [[upper[min(k, m), max(k, m)] for m in range(len(names))] for k in range(len(names))]

    def expand(self, expression: Expr) -> Expr:
        """Replace every defined symbol by its definition, down to the inputs (for tests: it may be huge)."""
        for symbol in reversed(self._definitions):
            expression = expression.xreplace({symbol: self._definitions[symbol]})
        return expression

    def _derivative(self, expression: Expr, variable: Symbol, hold: frozenset[Symbol]) -> Expr:
        # SymPy hands out free symbols as a set; the order is fixed so that output never depends on hashing.
        terms = []
        for symbol in sorted(expression.free_symbols, key=default_sort_key):
            inner = self._symbol_derivative(symbol, variable, hold)
            if inner != 0:
                terms.append(self._partial(expression, symbol) * inner)
        return Add(*terms)

    def _partial(self, expression: Expr, symbol: Symbol) -> Expr:
        # The same for every variable of a total derivative, and where SymPy spends its time.
        if (expression, symbol) not in self._partials:
            self._partials[expression, symbol] = diff(expression, symbol)
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
