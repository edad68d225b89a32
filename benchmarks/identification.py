"""Identified modes beside those of other programs, on simulated structures whose modes are known.

    PYTHONPATH=tests python benchmarks/identification.py [--out docs/explanation/identification-compared.md]

sdYPY-EMA and pyOMA-2, where they are installed, are told the true frequencies and choose the nearest poles, as
their user reads them from a stabilisation diagram; pkmodes gets the band only.  Times are those of one core in one
process, the programs in turn on the same data.
"""

from __future__ import annotations

import argparse
import logging
import warnings
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.signal import decimate

from backends_report import paragraph, put, table
from pkmodes.core.support.threads import one_blas_thread
from pkmodes.modaltest.identification.estimates import Mode, complex_mac
from pkmodes.modaltest.identification.frf_identification import identify_frf
from pkmodes.modaltest.identification.ssi_identification import identify_responses
from pkmodes_rig.structures import driven, forced
from timing import seconds

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

SEED = 20261123
#: Responses to a force: the band [Hz], the lines, and the noise relative to the rms of each function.
FORCED_BAND, LINES, NOISE = (15.0, 390.0), np.arange(0.25, 420.0, 0.25), 0.01
#: Responses alone: the band [Hz], and the time step [s].
DRIVEN_BAND, STEP = (8.0, 200.0), 1e-3
STRUCTURES, SYSTEMS = 20, 12
#: Poles of the highest order for sdYPY-EMA; block rows, order and blocks of the uncertainty for pyOMA-2, at half the
#: sampling rate: its own examples use such numbers, and others on either side gave no better results.
EMA_ORDER = 60
OMA_ROWS, OMA_ORDER, OMA_BLOCKS = 30, 24, 50
#: A mode is found if one is this close, relative.
NEAR = 0.01


@dataclass(frozen=True)
class Found:
    """A mode as a program finds it; NaN where it says nothing."""

    frequency: float
    sigma: float
    damping: float
    shape: Complex


#: A program finds modes in what was measured, near frequencies that it is told.
Program = Callable[[NDArray, Array], list[Found]]


@dataclass(frozen=True)
class Truth:
    """The true modes that are asked for."""

    frequencies: Array
    damping: Array
    shapes: Array  # (n, S)


@dataclass
class Score:
    """What a program finds over all cases."""

    frequency: list[float] = field(default_factory=list)
    damping: list[float] = field(default_factory=list)
    covered: list[bool] = field(default_factory=list)
    shapes: list[float] = field(default_factory=list)
    asked: int = 0
    others: int = 0
    seconds: float = 0.0

    def add(self, found: Sequence[Found], truth: Truth) -> None:
        """Judge the modes of one case: each true mode has the nearest one that is found."""
        left = list(found)
        for frequency, damping, shape in zip(truth.frequencies, truth.damping, truth.shapes, strict=True):
            self.asked += 1
            near = [one for one in left if abs(one.frequency / frequency - 1.0) < NEAR]
            if not near:
                continue
            one = min(near, key=lambda each: abs(each.frequency - frequency))
            left.remove(one)
            self.frequency.append(100.0 * (one.frequency / frequency - 1.0))
            self.damping.append(100.0 * (one.damping / damping - 1.0))
            self.shapes.append(complex_mac(one.shape, shape.astype(complex)))
            if np.isfinite(one.sigma):
                self.covered.append(abs(one.frequency - frequency) <= 2.0 * one.sigma)
        self.others += len(left)

    def row(self, name: str) -> list[str]:
        """Return its line of a table."""
        f = np.abs(self.frequency)
        return [
            name,
            f"{len(f)} of {self.asked}",
            str(self.others),
            f"{np.median(f):.4f} %",
            f"{np.sqrt((f**2).mean()):.4f} %",
            f"{100 * np.mean(self.covered):.0f} %" if self.covered else "no sigma",
            f"{np.median(np.abs(self.damping)):.2f} %",
            f"{np.median(self.shapes):.5f}",
            f"{self.seconds:.1f} s",
        ]


TITLES = [
    "program",
    "modes found",
    "others",
    "frequency: median error",
    "rms error",
    "within 2 sigma",
    "damping: median error",
    "MAC: median",
    "time",
]


def of_pkmodes(modes: Sequence[Mode]) -> list[Found]:
    return [Found(one.frequency, one.sigma_frequency, one.damping, one.shape) for one in modes]


def ema(H: Complex, frequencies: Array) -> list[Found]:
    """sdYPY-EMA: least-squares complex frequency, then shapes; one reference."""
    import sdypy.EMA as EMA

    model = EMA.Model(
        H[:, :, 0].T.copy(),
        LINES,
        lower=FORCED_BAND[0],
        upper=FORCED_BAND[1],
        pol_order_high=EMA_ORDER,
        frf_type="accelerance",
    )
    model.get_poles(show_progress=False)
    model.select_closest_poles(list(frequencies), f_window=10)
    model.get_constants()
    return [
        Found(f, np.nan, d, shape)
        for f, d, shape in zip(model.nat_freq, model.nat_xi, model.A.T, strict=True)
    ]


def oma(y: Array, frequencies: Array) -> list[Found]:
    """pyOMA-2: covariance-driven subspace identification with its uncertainty."""
    from pyoma2.functions import ssi

    slower = decimate(y, 2, ftype="fir", axis=0).T
    H, T = ssi.build_hank(slower, slower, OMA_ROWS, "cov", calc_unc=True, nb=OMA_BLOCKS)
    Obs, A, C, *_ = ssi.SSI_fast(H, OMA_ROWS, OMA_ORDER)
    Fn, Xi, Phi, _, spread, *_ = ssi.SSI_poles(Obs, A, C, OMA_ORDER, 2.0 * STEP, calc_unc=True, H=H, T=T)
    found = []
    for frequency in frequencies:
        near = int(np.nanargmin(np.abs(Fn[:, OMA_ORDER] - frequency)))
        at = near, OMA_ORDER
        found.append(Found(float(Fn[at]), float(spread[at]), float(Xi[at]), Phi[at]))
    return found


def forced_case(rng: np.random.Generator) -> tuple[Complex, Truth]:
    """Six modes in the band and two above it, four accelerometers, one force."""
    s = forced.random_structure(rng)
    clean = s.response(LINES, [0, 1, 2, 3], [4], 2)
    level = NOISE * np.sqrt((np.abs(clean) ** 2).mean(axis=0))
    return clean + forced.noise(rng, clean, level), Truth(
        s.frequencies[:6], s.damping[:6], s.shapes[:4, :6].T
    )


def driven_case(rng: np.random.Generator) -> tuple[Array, Truth]:
    """Six modes, six accelerometers, 40 s of white forces at all places, 5 % noise."""
    s = driven.random_structure(rng)
    return driven.ambient(s, rng, seconds=40.0, rate=1.0 / STEP), Truth(*s.modes())


def identified_frf(H: Complex, _: Array) -> list[Found]:
    return of_pkmodes(identify_frf(LINES, H, band=FORCED_BAND, derivative_order=2).modes)


def identified_responses(y: Array, _: Array) -> list[Found]:
    return of_pkmodes(identify_responses(STEP, (y,), band=DRIVEN_BAND)[0].modes)


def compared(case: Callable, count: int, programs: dict[str, Program]) -> str:
    """Return the table of some programs over the same cases."""
    rng = np.random.default_rng(SEED)
    scores = {name: Score() for name in programs}
    for _ in range(count):
        measured, truth = case(rng)
        for name, run in programs.items():
            found: list[Found] = []
            scores[name].seconds += seconds(lambda: found.extend(run(measured, truth.frequencies)))  # noqa: B023
            scores[name].add(found, truth)
    return table(TITLES, [score.row(name) for name, score in scores.items()])


def versions() -> str:
    """Return the other programs that are installed, with their versions."""
    found = []
    for name in ("sdypy-EMA", "pyOMA-2"):
        try:
            found.append(f"{name} {version(name)}")
        except PackageNotFoundError:
            found.append(f"{name} is not installed")
    return ", ".join(found)


def there(program: str) -> bool:
    try:
        return bool(version(program))
    except PackageNotFoundError:
        return False


def text() -> str:
    """Compare, and return the tables."""
    frf: dict[str, Program] = {"pkmodes": identified_frf}
    alone: dict[str, Program] = {"pkmodes": identified_responses}
    if there("sdypy-EMA"):
        frf["sdYPY-EMA"] = ema
    if there("pyOMA-2"):
        alone["pyOMA-2"] = oma
    parts = [
        paragraph(
            f"Frequency response functions: {STRUCTURES} structures with six modes between 20 and 380 Hz, 3 % apart "
            "or more, damping ratios from 0.3 to 3 %, two further modes above the band, four accelerometers, one "
            "force, lines of 0.25 Hz, noise of 1 %."
        ),
        compared(forced_case, STRUCTURES, frf),
        paragraph(
            f"Responses alone: {SYSTEMS} systems with six modes between 12 and 170 Hz, 3 % apart or more, damping "
            "ratios from 0.3 to 3 %, six accelerometers, 40 s of white forces, 5 % noise."
        ),
        compared(driven_case, SYSTEMS, alone),
        paragraph(f"Measured with {versions()}."),
    ]
    return "\n\n".join(parts) + "\n"


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--out", type=Path, help="document whose tables are replaced")
    out = parser.parse_args().out
    logging.disable(logging.INFO)  # pyOMA-2 logs every step
    with warnings.catch_warnings(), one_blas_thread():
        warnings.simplefilter("ignore")
        found = text()
    if out is None:
        print(found)
    else:
        put(out, found, "benchmarks/identification.py")


if __name__ == "__main__":
    main()
