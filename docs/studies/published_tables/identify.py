"""Identify the geometry and the poses behind Tables 1 and 2 of the paper, and print the evidence step by step.

    python docs/studies/published_tables/identify.py

It starts from robots/linear-delta-2022.toml and tables.csv (`identification`), and finally compares its result with
robots/linear-delta-2022-identified.toml and published-modes.csv, which were made from it: exit code 1 if they
differ.  docs/explanation/published-tables.md documents the results.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

import numpy as np

import evidence
import pkmodes
import published_modes
import report
from before_after import print_before_after
from extremes import centre_line, extremes
from identification import Identified, identify
from printed import read_rows
from residual import IDENTIFIED, SHORTEST_SPAN, Z

DECLARED = IDENTIFIED.with_name("linear-delta-2022.toml")


def compare_with_file(found: Identified, path: Path = IDENTIFIED) -> float:
    """Return the largest difference of the identified joints and limits from a robot file [m]."""
    parameters = pkmodes.read_robot(path).parameters
    joint, limits, _ = found.in_robot_file
    return float(max(np.abs(joint - parameters.joint).max(), np.abs(limits - parameters.limits).max()))


def main() -> None:
    """Identify, print the evidence, and compare the committed files with it."""
    parser = argparse.ArgumentParser(description="Geometry and poses behind the published tables.")
    parser.add_argument("--write", action="store_true", help=f"write {published_modes.FILE.name}")
    arguments = parser.parse_args()

    found = identify(pkmodes.read_robot(DECLARED), read_rows())
    report.first_look(found)
    report.fits(found)
    evidence.report(found)
    text = published_modes.text(found)
    if arguments.write:
        published_modes.FILE.write_text(text, encoding="utf-8")
    problems = []
    if compare_with_file(found) > 1e-9:
        problems.append(f"{IDENTIFIED} differs from the identified robot")
    if published_modes.FILE.read_text(encoding="utf-8") != text:
        problems.append(f"{published_modes.FILE} differs from the output of this script; run it with --write")
    robots = [pkmodes.read_robot(path) for path in (DECLARED, IDENTIFIED)]
    before = extremes(robots[0], centre_line(robots[0], Z, SHORTEST_SPAN))
    printed = {(row.point, row.mode): row.frequency for row in found.rows}
    print_before_after(printed, before.frequency, published_modes.frequencies(robots[1]))
    report.diagnoses(*robots, before)
    if problems:
        sys.exit("error: " + "; ".join(problems))
    print(f"\n{IDENTIFIED.name} and {published_modes.FILE.name} agree with the identification.")


if __name__ == "__main__":
    main()
