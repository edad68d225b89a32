"""The suite of campaigns: signals of sixty machines, identified and diagnosed.

    python -m studies.campaigns --seed 20261226 --out docs/signals-measured.md      # `make suites`

What counts and what is asked was fixed before any machine was run (`campaign_judging`, `campaign_table`).
"""

from __future__ import annotations

import statistics
import sys
import time
from collections import Counter
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from studies.campaign_cases import CALIBRATION, CampaignOutcome, run
from studies.campaign_machines import cases
from studies.campaign_table import DETAILS, SIGNAL, details, rows_of, table
from studies.running import Pool, parallel_command_line, publish, run_all
from studies.tables import confusion, grouped, in_words, listed
from studies.tables import table as lines_of

MACHINES = 60
#: Seeds with which the rig's suite was tried out.
SEEN = "1, 2, 3, 20261224 and 20261225"
#: Columns of the lists of machines.
LISTED = ("machine", "cause", "signal", "rows", "verdict", "why")
TEXT = """\
# From signals to causes, measured

Written by `make suites`; do not edit. How often `pkmodes identify` and `pkmodes diagnose` are right from the
accelerometer on, on machines whose truth is known. The command is
`{command} --out docs/signals-measured.md`.

## What was simulated

{count} machines of three mechanisms on the virtual rig, which shares no code with the model: MuJoCo gives the
mass and stiffness of each at each pose, and its motion is integrated in time, exactly for forces that are
linear between steps of 1/4096 s. Each has damping of its own: a ratio of 0.2 to 0.6 % in every mode, viscous
friction at the rails, losses of up to 1 % in belts or reducers; one in five with rails has Coulomb friction on
them, by Moreau's scheme, without a regularised sign. Motors are held at half of the machines and free at the
others, which then hang on soft cords.

Most machines lack one effect of the catalogue in their robot files, a few lack nothing or something outside the
catalogue; the uncertain values are drawn from their priors. A laboratory measures each at three to six poses,
two to four files a pose: frequency response functions of a shaker (three averages of 8 s, one or two
references), hammer blows (one or three in a file, 4 or 6 s each), or 40 s of ambient vibration, at 1024 Hz, as
universal files, MATLAB files or tables.

It is unkind as laboratories are. Belts and reducers settle anew at every approach (0.1 to 0.3 % in frequency;
0.2 % is stated), the pose is off by 0.2 mm, the room warms (up to 0.2 % in stiffness over the campaign).
Sensors have noise, mains hum and the tone of a fan; sensitivities are off by 0.5 %, mountings askew by 1 %. In
one case of three the band cuts modes off; hammers and shakers act along one axis of the platform in one case of
four, so that modes have nodes there. Some campaigns have more against them: {unkind}.

Seed {seed}. The suite was tried out, and what it exposed was corrected, with the seeds {seen}.

## What was asked, and what came out
"""
CALIBRATED = """\
The same rows with {share:.0%} added to every `sigma_shape` in quadrature, which is what a laboratory knows of the
sensitivity and mounting of its sensors, and no signal shows:"""
MEANING = """\
* A mode counts if it is in the band, its peak is 10 dB above the noise of one file at the best sensor, and its
  neighbours cannot imitate it: what the best fit by the modes beside it leaves of it is 10 dB above that noise
  too. It is found if a row lies within 1 % of it; rows and modes are paired one to one, by frequency and shape.
  Any mode of the machine, counting or not, makes a row a mode.
* The record's own truth is that of the machine as it was while the files were recorded. For the rows *within 2
  sigma*, the frequency is held against the machine at the stated pose, as it is on average, because the
  standard deviation includes the repeatability; damping and shape against the record's own.
* Frequency errors, damping errors and MAC are those of modes that count; coverage and ratios, of all rows that
  are modes. Coulomb friction makes damping depend on the amplitude: such machines have no part in the figures
  of damping.
* Shape components are held against what the sensors show, with their sensitivity and mounting, which are not
  the identification's; the MAC against the motion itself.
* The signal of a cause is what it leaves of the rows, at their true frequencies, in standard deviations; from
  {signal:g} on it should be named.
* The robot files declare no damping. Losses that a diagnosis claims beside the cause count as right if the
  machine has one of the class; viscous friction at the rails counts as wrong where there is Coulomb friction.
* Pairs of close modes, times and memory are measured in the tests and benchmarks, not here."""


def main() -> None:
    """Run the suite and write its page."""
    parser = parallel_command_line("Measure the way from signals to causes.")
    parser.add_argument("--machines", type=int, default=MACHINES, help="how many machines; default 60")
    parser.add_argument("--only", type=int, help="run this machine only, from 1")
    parser.add_argument("--keep", type=Path, help="folder in which the campaign of --only is kept")
    arguments = parser.parse_args()
    pool = Pool.of(arguments)
    chosen = cases(arguments.seed, arguments.machines)
    if arguments.only:
        print(_said(run(chosen[arguments.only - 1], arguments.keep)), file=sys.stderr)
        return
    start = time.perf_counter()
    outcomes = run_all(run, chosen, pool, _said, CampaignOutcome)
    publish(page(outcomes, time.perf_counter() - start, pool), arguments.out)


def _said(o: CampaignOutcome) -> str:
    what = f"{o.case.label} ({_cause(o)}), {o.signal:.3g}: {o.state} ({o.calibrated}) {in_words(o)}"
    return f"{what} [{o.identifying:.1f} s, {o.seconds:.1f} s] {o.reason}"


def page(outcomes: Sequence[CampaignOutcome], seconds: float, pool: Pool) -> list[str]:
    """Return the lines of the page."""
    seed, count = outcomes[0].case.seed, len(outcomes)
    marked = [(*line, "met" if met else "**NOT MET**") for *line, met in table(outcomes)]
    measured = [tuple(map(str, line)) for line in marked]
    missed = [o for o in outcomes if o.case.names and o.state != "named"]
    unkind = Counter(words for o in outcomes for words in o.unkind)
    head = TEXT.format(
        command=f"PYTHONPATH=tests python -m studies.campaigns --seed {seed} --machines {count}",
        count=count,
        unkind=", ".join(f"{name}: {n}" for name, n in sorted(unkind.items())),
        seed=seed,
        seen=SEEN,
    )
    slow, hard = ([getattr(o, name) for o in outcomes] for name in ("identifying", "seconds"))
    return [
        *head.splitlines(),
        "",
        *lines_of(("what", "asked", "measured", ""), measured),
        "",
        *MEANING.format(signal=SIGNAL).splitlines(),
        "",
        "## By kind of record",
        "",
        *lines_of(DETAILS, list(details(outcomes))),
        "",
        "## Outcomes of the diagnosis",
        "",
        *confusion(grouped(outcomes, _group), "machines"),
        "",
        *confusion(grouped(outcomes, lambda o: o.case.kind), "records"),
        "",
        *CALIBRATED.format(share=CALIBRATION).splitlines(),
        "",
        *confusion(
            grouped([replace(o, state=o.calibrated or o.state) for o in outcomes], _group), "machines"
        ),
        "",
        "## Causes that were not named",
        "",
        *listed(LISTED, [_line(o) for o in missed]),
        "",
        "## Confident and wrong, and failures",
        "",
        *listed(LISTED, [_line(o) for o in outcomes if o.state in ("wrong", "failed")]),
        "",
        "## Rows that are no mode",
        "",
        *listed(("machine", "pose", "frequency [Hz]", "sigma [Hz]", "damping [%]"), _false(outcomes)),
        "",
        "## Modes that were not found",
        "",
        *listed(("machine", "modes", "pose: frequency [Hz]"), _missed(outcomes)),
        "",
        "## Time",
        "",
        f"Median {statistics.median(slow):.1f} s, longest {max(slow):.1f} s an identification;"
        f" {statistics.median(hard):.1f} s and {max(hard):.1f} s a diagnosis; all {count} machines, with their"
        f" signals, in {seconds / 60:.0f} min with {pool}.",
    ]


def _cause(o: CampaignOutcome) -> str:
    return o.case.cause or "nothing"


def _group(o: CampaignOutcome) -> str:
    if not o.case.cause:
        return "nothing missing"
    if o.case.outside:
        return "outside the catalogue"
    return f"one effect, signal {'above' if o.signal > SIGNAL else 'up to'} {SIGNAL:g} sigma"


def _line(o: CampaignOutcome) -> tuple[str, ...]:
    why = in_words(o) or o.reason.strip().splitlines()[-1] if o.reason else in_words(o)
    if o.unkind:
        why = f"{why} ({', '.join(o.unkind)})"
    return o.case.label, _cause(o), f"{o.signal:.3g}", str(len(rows_of(o))), o.verdict or o.state, why


def _false(outcomes: Sequence[CampaignOutcome]) -> list[tuple[str, ...]]:
    return [
        (
            o.case.label,
            f"P{row.record + 1}",
            f"{row.frequency:.2f}",
            f"{row.sigma:.2f}",
            f"{100 * row.damping:.2g}",
        )
        for o in outcomes
        for row in rows_of(o)
        if row.mode < 0
    ]


def _missed(outcomes: Sequence[CampaignOutcome]) -> list[tuple[str, ...]]:
    found: list[tuple[str, ...]] = []
    for o in outcomes:
        if o.judged and o.judged.missed:
            places = ", ".join(f"P{record + 1}: {frequency:.1f}" for record, frequency in o.judged.missed)
            found.append((o.case.label, f"{len(o.judged.missed)} of {len(o.judged.counted)}", places))
    return found


if __name__ == "__main__":
    main()
