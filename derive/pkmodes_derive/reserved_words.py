"""Reserved words of the generated languages and code: no symbol of a mechanism may use one as its name."""

from __future__ import annotations

import keyword
import re

C_KEYWORDS = frozenset(
    """
    auto break case char const continue default do double else enum extern float for goto if inline int long main
    register restrict return short signed sizeof static struct switch typedef union unsigned void volatile while
    """.split()  # noqa: SIM905 - a list of quoted words would be harder to read
)
#: Functions of the C library, and names that generated Python and vector code use.
LIBRARY_NAMES = frozenset(
    """
    acos acosh asin asinh atan atan2 atanh cbrt ceil cos cosh erf exp expm1 fabs floor fmax fmin fmod hypot log log10
    log1p log2 memset pow round sin sinh sqrt tan tanh trunc gamma tgamma lgamma j0 j1 jn y0 y1 yn
    np math arctan2 tuple list float int len range broadcast lane mask pose pick root parameters effects margin
    mode modes shape shapes eigenvalue eigenvalues gradient gradients
    path paths direction derivatives mass_rate stiffness_rate motion_rate
    """.split()  # noqa: SIM905
)
#: Shared subexpressions: t1, t2, ...
SHARED_SUBEXPRESSION = re.compile(r"t\d+")
#: Names that derivatives of eigenvalues and of matrices consist of.
DERIVATIVE_NAME = re.compile(r"(shape|forward|adjoint|along|tangent)_\w+")


def is_reserved(name: str) -> bool:
    """Whether a name is reserved in generated code."""
    return bool(
        keyword.iskeyword(name)
        or name in C_KEYWORDS
        or name in LIBRARY_NAMES
        or SHARED_SUBEXPRESSION.fullmatch(name)
        or DERIVATIVE_NAME.fullmatch(name)
        or not name.isascii()
    )
