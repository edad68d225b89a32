"""Numbers that carry what they would be if a threshold had another value, and notice where that makes a difference.

A `Shadowed` number goes through a calculation in place of a plain one.  What is calculated from it has shadows too;
where it is compared, indexed with or turned into a plain number, the shadows whose answer would be another one are
noticed.  A shadow that is not noticed took part in no decision and in no result: the calculation with its value would
have been the same.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Iterator, Mapping
from typing import Any, Generic, TypeVar

import numpy as np

K = TypeVar("K")


class Shadowed(Generic[K]):
    """A number or an array with shadows.

    Parameters
    ----------
    value : float, int or array
    shadows : mapping
        Other values, by what would have made them.
    noticed : set
        Keys of the shadows that made a difference; they are added here.
    """

    def __init__(self, value: Any, shadows: Mapping[K, Any], noticed: set[K]) -> None:
        self._value, self._shadows, self._noticed = value, shadows, noticed

    def __array_ufunc__(self, ufunc: np.ufunc, method: str, *inputs: Any, **options: Any) -> Any:
        function = getattr(ufunc, method)
        if options.get("out"):  # the shadows would write there, too
            return function(
                *(one._plain() if isinstance(one, Shadowed) else one for one in inputs), **options
            )
        return self._derived(lambda *values: function(*values, **options), *inputs)

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> np.ndarray:
        return np.array(self._plain(), dtype=dtype)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):  # NumPy asks for protocols
            raise AttributeError(name)
        return getattr(self._plain(), name)

    def __format__(self, how: str) -> str:  # words decide nothing
        return format(self._value, how)

    def __hash__(self) -> int:
        return hash(self._plain())

    def __len__(self) -> int:
        return int(self._decided(len, self))

    def __iter__(self) -> Iterator[Any]:
        return iter(self._plain())

    def __bool__(self) -> bool:
        return bool(self._decided(bool, self))

    def __int__(self) -> int:
        return int(self._decided(int, self))

    def __index__(self) -> int:
        return operator.index(self._plain())

    def __float__(self) -> float:
        return float(self._plain())

    def _plain(self) -> Any:
        """Return the value for a use in which any other one may make a difference."""
        return self._decided(lambda value: value, self)

    def _decided(self, function: Callable[..., Any], *inputs: Any) -> Any:
        value, others = self._applied(function, *inputs)
        self._noticed.update(others)
        return value

    def _derived(self, function: Callable[..., Any], *inputs: Any) -> Any:
        value, others = self._applied(function, *inputs)
        if np.asarray(value).dtype == bool:
            self._noticed.update(others)
            return value
        return Shadowed(value, others, self._noticed) if others else value

    @staticmethod
    def _applied(function: Callable[..., Any], *inputs: Any) -> tuple[Any, dict[Any, Any]]:
        """Return what a function makes of the values, and of the shadows of which it makes something else."""
        several = [one for one in inputs if isinstance(one, Shadowed)]
        value = function(*(one._value if isinstance(one, Shadowed) else one for one in inputs))
        others = {
            key: function(
                *(one._shadows.get(key, one._value) if isinstance(one, Shadowed) else one for one in inputs)
            )
            for key in {key for one in several for key in one._shadows}
        }
        return value, {key: one for key, one in others.items() if not _same(value, one)}


def _same(one: Any, other: Any) -> bool:
    return np.array_equal(one, other, equal_nan=True)


def _operator(function: Callable[..., Any], turned: bool = False) -> Callable[..., Any]:
    def applied(self: Shadowed[Any], *others: Any) -> Any:
        return self._derived(function, *((*others, self) if turned else (self, *others)))

    return applied


for _name in ("lt", "le", "gt", "ge", "eq", "ne", "neg", "abs", "getitem"):
    setattr(Shadowed, f"__{_name}__", _operator(getattr(operator, f"__{_name}__")))
for _name in ("add", "sub", "mul", "truediv", "floordiv", "pow", "matmul"):
    setattr(Shadowed, f"__{_name}__", _operator(getattr(operator, f"__{_name}__")))
    setattr(Shadowed, f"__r{_name}__", _operator(getattr(operator, f"__{_name}__"), turned=True))
