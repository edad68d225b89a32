"""Sizes of the causes in `mechanism_suites`, as ``python benchmarks/mechanism_suites.py --sizes`` found them.

By their predicted signal, not by any diagnosis; all in SI units.
"""

from __future__ import annotations

SIZES: dict[str, dict[str, dict[str, list[float]]]] = {}
