"""Base of the printers of all languages."""

from __future__ import annotations

from functools import lru_cache

from sympy import Add, Expr
from sympy.printing.codeprinter import CodePrinter


@lru_cache(maxsize=2**16)
def _in_order(total: Add, order: str | None) -> tuple[Expr, ...]:
    return tuple(total.as_ordered_terms(order=order))


class Ordered(CodePrinter):  # type: ignore[misc]  # SymPy has no types
    """Prints the terms of a sum in the order of `CodePrinter`.

    All languages print the same programs, and finding the order takes longer than printing.
    """

    def _as_ordered_terms(self, expr: Add, order: str | None = None) -> list[Expr]:
        return list(_in_order(expr, order or self.order))

    def _handle_UnevaluatedExpr(self, expr: Expr) -> Expr:  # noqa: N802
        return expr  # SymPy searches it for real parts of unevaluated expressions, of which there are none
