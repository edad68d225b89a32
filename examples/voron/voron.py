"""Close the loop on a real CoreXY printer: compare its resonances at several belt tensions with the model.

    python examples/voron/voron.py [--out FILE]

prints the residual with belts of constant stiffness, the diagnosis, and fits made without pkmodes; --out writes the
table of all peaks and predictions (CSV).
"""

from __future__ import annotations

import argparse
import csv
import sys
import tempfile
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares

import pkmodes
from pkmodes.core.base.numbers import round_to_sigma
from pkmodes.diagnosis import Diagnosis, Measurements
from pkmodes.updating import compare, diagnose, read

Array = NDArray[np.float64]
HERE = Path(__file__).resolve().parent
TENSION = "effects.belt_tension_stiffness.tension"
#: Names of the measurement series and their files.
SERIES = ("measured", "preloads")
#: Settings [mm] at which only the peak along x [Hz] belongs to the belts.
SLACKEST = ((-1.5, 20.0), (-1.0, 24.0))
#: Moving masses along x and y, as weighed [kg].
MASSES = {"x": 0.502, "y": 0.502 + 0.695}
#: Pairs of readings of the same setting [Hz].
REPEATED = ((39.0, 33.0), (23.0, 23.0), (35.0, 28.0))
#: Relative standard deviations tried in addition to the stated ones; the repeated readings suggest the larger.
WIDER = {"5 %": 0.05, "10 %": 0.1}
#: Declaration of belts whose stiffness increases linearly with tension.
LINEAR = '\n[effects.belt_tension_stiffness]\ncoefficient = { value = "0.3 1/N", sigma = "1 1/N" }\n'


def tension(extension: float) -> float:
    """Return the assumed tension [N] for an extension [mm].

    In the second series 4.6 N was measured where the peak along y is 28 Hz, as it is here at +0.5 mm.  2.2 N/mm is
    about the largest slope that keeps the belts tensioned at -1.5 mm, where the peak along x still exists.  A linear
    law fits any other offset and slope equally well, with another coefficient; a power law needs the offset.
    """
    return 4.6 + 2.2 * (extension - 0.5)


@dataclass(frozen=True)
class Peaks:
    """Peaks of a series: setting, tension [N], direction, frequency [Hz]."""

    setting: list[str]
    tension: Array
    direction: list[str]
    frequency: Array

    @property
    def mass(self) -> Array:
        """Moving mass of each peak [kg]."""
        return np.array([MASSES[d] for d in self.direction])


def peaks(data: Measurements, more: tuple[tuple[float, float], ...] = ()) -> Peaks:
    """Collect the peaks of a file, and further ones along x at extensions [mm]."""
    setting = [data.labels[p] for p in data.pose] + [f"{e:+.1f} mm" for e, _ in more]
    loads = [data.load(p)[TENSION] for p in data.pose] + [tension(e) for e, _ in more]
    frequency = [*data.frequency, *(f for _, f in more)]
    return Peaks(setting, np.array(loads), [*data.mode, *("x" for _ in more)], np.array(frequency))


# Fits without pkmodes: one spring, two masses --------------------------------------------------------------------

#: Logarithm of the stiffness [N/m] as a function of tension [N] and parameters, and starting values.
LAWS: dict[str, tuple[Callable[[Array, Array], Array], tuple[float, ...]]] = {
    "constant": (lambda t, p: p[0] + 0.0 * t, (10.0,)),
    "linear": (lambda t, p: p[0] + np.log1p(np.exp(p[1]) * t), (9.0, -1.0)),
    "power": (lambda t, p: p[0] + p[1] * np.log(t), (9.0, 0.5)),
}


def fitted(law: str, at: Peaks, rows: NDArray[np.bool_] | None = None) -> Array:
    """Fit the parameters of a law by least squares in the logarithm of the frequencies."""
    rows = np.ones(len(at.mass), dtype=bool) if rows is None else rows
    stiffness, start = LAWS[law]
    aim = 2.0 * np.log(2.0 * np.pi * at.frequency) + np.log(at.mass)

    def left(p: Array) -> Array:
        return (stiffness(at.tension, p) - aim)[rows]

    # Belts that are slack without tension put no upper limit on a coefficient: the bound is far beyond the data.
    return np.asarray(least_squares(left, start, bounds=(-15.0, 15.0), xtol=1e-12, ftol=1e-12).x)


def predicted(law: str, at: Peaks, p: Array) -> Array:
    """Predict the frequencies [Hz]."""
    return np.asarray(np.exp(0.5 * (LAWS[law][0](at.tension, p) - np.log(at.mass))) / (2.0 * np.pi))


def rms(prediction: Array, at: Peaks) -> float:
    """Return the rms relative error."""
    return float(np.sqrt(np.mean((prediction / at.frequency - 1.0) ** 2)))


def left_out(law: str, at: Peaks) -> float:
    """Return the rms relative error with each setting predicted from the others."""
    found = np.empty(len(at.mass))
    for setting in dict.fromkeys(at.setting):
        others = np.array([s != setting for s in at.setting])
        found[~others] = predicted(law, at, fitted(law, at, others))[~others]
    return rms(found, at)


# The program -----------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Loop:
    """Declared robots, measurements, and diagnoses by series, robot and sigma."""

    robots: dict[str, pkmodes.Robot]
    data: dict[str, Measurements]
    found: dict[tuple[str, str, str], Diagnosis]

    def refitted(self, series: str) -> pkmodes.Robot:
        """Return the robot with linear belt stiffness, fitted to a series."""
        values = self.found[series, "linear", "stated"].refitted
        return self.robots["linear"].with_values({v.name: v.after for v in values})


#: Diagnoses: series, robot, sigma.
RUNS = (
    ("measured", "free motors", "stated"),
    ("measured", "constant", "stated"),
    ("measured", "linear", "stated"),
    ("measured", "constant", "5 %"),
    ("measured", "linear", "5 %"),
    ("measured", "constant", "10 %"),
    ("preloads", "constant", "stated"),
    ("preloads", "constant", "5 %"),
    ("preloads", "linear", "stated"),
)


def close_the_loop() -> Loop:
    """Run all diagnoses; no setting is held out, as there are few."""
    text = (HERE / "robot.toml").read_text(encoding="utf-8")
    free = text[: text.index("# Both motors are energised.")]
    robots = {}
    with tempfile.TemporaryDirectory() as folder:
        for name, content in (("constant", text), ("linear", text + LINEAR), ("free motors", free)):
            path = Path(folder) / "robot.toml"
            path.write_text(content, encoding="utf-8")
            robots[name] = pkmodes.read_robot(path)
    data = {name: read(HERE / f"{name}.csv", robot=robots["constant"]) for name in SERIES}
    found = {}
    for series, robot, sigma in RUNS:
        rows = data[series]
        if sigma in WIDER:
            rows = replace(rows, sigma=np.maximum(rows.sigma, WIDER[sigma] * rows.frequency))
        found[series, robot, sigma] = diagnose(robots[robot], rows, holdout=[])
    return Loop(robots, data, found)


def table(loop: Loop) -> list[dict[str, object]]:
    """Return a row for each peak: measured, and predicted by the declared model and by both refits [Hz]."""
    rows: list[dict[str, object]] = []
    for series in SERIES:
        constant = loop.found[series, "constant", "stated"].rows
        linear = {(r.pose, r.mode): r for r in loop.found[series, "linear", "stated"].rows}
        for row in constant:
            rows.append(
                {
                    "series": series,
                    "setting": row.pose,
                    "tension": row.load[TENSION],
                    "direction": row.mode,
                    "measured": row.measured,
                    "sigma": row.sigma,
                    "declared": _shown(row.before),
                    "constant": _shown(row.refit),
                    "linear": _shown(linear[row.pose, row.mode].refit),
                }
            )
    return rows


def report(loop: Loop) -> str:
    """Return the text with all results stated in docs/explanation/voron.md."""
    scatter = np.sqrt(np.mean([(a - b) ** 2 / 2.0 for a, b in REPEATED]))
    lines = [f"repeated readings: standard deviation {scatter:.1f} Hz", "", "diagnosis"]
    for (series, robot, sigma), found in loop.found.items():
        stages = [("declared", found.before), ("refit", found.refit), ("with the cause", found.after)]
        told = ", ".join(
            f"{name} {100 * e.rms_relative:.1f} % (chi2 {e.chi2_per_dof:.1f})"
            for name, e in stages
            if e is not None and e.rms_relative is not None
        )
        lines += [f"{series}, {robot}, sigma {sigma}: {found.verdict}; rms {told}", f"  {found.reason}"]
        fits = ", ".join(f"{v.name} = {round_to_sigma(v.after, v.sigma)} {v.unit}" for v in found.refitted)
        lines.append(f"  {fits}")
        better = [f"{s.change}: {s.verdict} {' and '.join(s.effects)}".rstrip() for s in found.stability]
        lines.append(f"  {'; '.join(better)}")
    across = compare(loop.refitted("measured"), loop.data["preloads"]).rms_relative
    lines += [f"linear, fitted to measured, on preloads: rms {100 * across:.1f} %", "", "peak [Hz]"]
    rows = table(loop)
    lines += [" | ".join(rows[0]), *(" | ".join(str(cell) for cell in row.values()) for row in rows)]
    lines += [
        "",
        "one spring and two masses, fitted without pkmodes: rms, rms with each setting left out, parameter",
    ]
    whole = peaks(loop.data["measured"], SLACKEST)
    for name, at in (
        ("measured", peaks(loop.data["measured"])),
        ("all seven", whole),
        ("preloads", peaks(loop.data["preloads"])),
    ):
        for law in LAWS:
            p = fitted(law, at)
            value = {
                "constant": "",
                "linear": f", {np.exp(p[-1]):.2f} 1/N",
                "power": f", exponent {p[-1]:.2f}",
            }
            told = f"{100 * rms(predicted(law, at, p), at):.1f} %, {100 * left_out(law, at):.1f} %"
            lines.append(f"{name}, {law}: {told}{value[law]}")
    return "\n".join(lines)


def _shown(value: float | None) -> str:
    return "" if value is None else f"{value:.1f}"


def main() -> None:
    """Print the summary and write the table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=Path, help="write the table of peaks and predictions to this CSV file")
    out = parser.parse_args().out
    loop = close_the_loop()
    sys.stdout.write(report(loop) + "\n")
    if out is not None:
        rows = table(loop)
        with out.open("w", newline="", encoding="utf-8") as file:
            writer = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
            writer.writeheader()
            writer.writerows(rows)


if __name__ == "__main__":
    main()
