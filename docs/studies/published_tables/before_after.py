"""Comparison of the twelve published frequencies with the declared robot (before) and the identified one (after)."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from extremes import percent


def print_before_after(
    printed: Mapping[tuple[str, int], float],
    before: Mapping[tuple[str, int], float],
    after: Mapping[tuple[str, int], float],
) -> None:
    """Print the table [Hz]."""
    print("\nPublished, declared robot and identified robot [Hz]:")
    print("point    mode     paper    before     diff       after        diff")
    errors = {"before": [], "after": []}
    for (point, mode), paper in printed.items():
        old, new = before[point, mode] / paper - 1.0, after[point, mode] / paper - 1.0
        errors["before"].append(old)
        errors["after"].append(new)
        print(
            f"{point:8} {mode:4d} {paper:9.3f} {before[point, mode]:9.3f} {100 * old:+7.1f}% "
            f"{after[point, mode]:11.3f} {100 * new:+10.5f}%"
        )
    (rms_old, most_old), (rms_new, most_new) = (percent(np.array(errors[key])) for key in ("before", "after"))
    print(f"rms difference                  {rms_old:8.1f}%              {rms_new:9.5f}%")
    print(f"largest difference              {most_old:8.1f}%              {most_new:9.5f}%")
