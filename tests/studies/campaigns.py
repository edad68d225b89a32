"""The suite of campaigns: signals of sixty machines, identified and diagnosed.

    python -m studies.campaigns --seed 20261226 --out docs/results/signals          # `make suites`

How often `pkmodes identify` and `pkmodes diagnose` are right from the accelerometer on.  Sixty machines of three
mechanisms on the virtual rig: MuJoCo gives the mass and stiffness of each at each pose, and its motion is integrated
in time, exactly for forces that are linear between steps of 1/4096 s.  Each has damping of its own: a ratio of 0.2 to
0.6 % in every mode, viscous friction at the rails, losses of up to 1 % in belts or reducers; one in five with rails
has Coulomb friction on them, by Moreau's scheme, without a regularised sign.  Motors are held at half of the machines
and free at the others, which then hang on soft cords.

Most machines lack one effect of the catalogue in their robot files, a few lack nothing or something outside the
catalogue; the uncertain values are drawn from their priors.  A laboratory measures each at three to six poses, two to
four files a pose: frequency response functions of a shaker (three averages of 8 s, one or two references), hammer
blows (one or three in a file, 4 or 6 s each), or 40 s of ambient vibration, at 1024 Hz, as universal files, MATLAB
files or tables.

It is unkind as laboratories are.  Belts and reducers settle anew at every approach (0.1 to 0.3 % in frequency; 0.2 %
is stated), the pose is off by 0.2 mm, the room warms (up to 0.2 % in stiffness over the campaign).  Sensors have
noise, mains hum and the tone of a fan; sensitivities are off by 0.5 %, mountings askew by 1 %.  In one case of three
the band cuts modes off; hammers and shakers act along one axis of the platform in one case of four, so that modes
have nodes there.

What counts and what is asked was fixed before any machine was run (`campaign_judging`, `campaign_table`):

* A mode counts if it is in the band, its peak is 10 dB above the noise of one file at the best sensor, and its
  neighbours cannot imitate it: what the best fit by the modes beside it leaves of it is 10 dB above that noise too.
  It is found if a row lies within 1 % of it; rows and modes are paired one to one, by frequency and shape.  Any mode
  of the machine, counting or not, makes a row a mode.
* The record's own truth is that of the machine as it was while the files were recorded.  For the rows *within 2
  sigma*, the frequency is held against the machine at the stated pose, as it is on average, because the standard
  deviation includes the repeatability; damping and shape against the record's own.
* Frequency errors, damping errors and MAC are those of modes that count; coverage and ratios, of all rows that are
  modes.  Coulomb friction makes damping depend on the amplitude: such machines have no part in the figures of
  damping.
* Shape components are held against what the sensors show, with their sensitivity and mounting, which are not the
  identification's; the MAC against the motion itself.
* The signal of a cause is what it leaves of the rows, at their true frequencies, in standard deviations.
* The robot files declare no damping.  Losses that a diagnosis claims beside the cause count as right if the machine
  has one of the class; viscous friction at the rails counts as wrong where there is Coulomb friction.

The diagnosis runs again with `CALIBRATION` added to every `sigma_shape` in quadrature, which is what a laboratory
knows of the sensitivity and mounting of its sensors, and no signal shows.
"""

from __future__ import annotations

import argparse
import statistics
import sys
from collections import Counter
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from studies.campaign_cases import CALIBRATION, CampaignOutcome, run
from studies.campaign_machines import CampaignCase, cases
from studies.campaign_table import DETAILS, SIGNAL, details, rows_of, table
from studies.requirements import MET, NOT_MET
from studies.suite import Suite
from studies.tables import Table, Tables, confusion, grouped, in_words, stacked

MACHINES = 60
#: Seeds with which the rig's suite was tried out.
SEEN = "1, 2, 3, 20261224 and 20261225"


class Campaigns(Suite[CampaignCase, CampaignOutcome]):
    """From the signals of a machine to what its robot file lacks."""

    description = "Measure the way from signals to causes."
    run, failed = staticmethod(run), CampaignOutcome

    def options(self, parser: argparse.ArgumentParser) -> None:
        parser.add_argument("--machines", type=int, default=MACHINES, help="how many machines; default 60")
        parser.add_argument("--machine", type=int, help="run this machine alone, from 1")
        parser.add_argument("--keep", type=Path, help="folder in which the campaign of --machine is kept")

    def instead(self, arguments: argparse.Namespace) -> bool:
        if arguments.machine:
            case = self.cases(arguments)[arguments.machine - 1]
            print(self.line(run(case, arguments.keep)), file=sys.stderr)
        return bool(arguments.machine)

    def cases(self, arguments: argparse.Namespace) -> list[CampaignCase]:
        return cases(arguments.seed, arguments.machines)

    def line(self, outcome: CampaignOutcome) -> str:
        case = f"{outcome.case.label} ({_cause(outcome)}), {outcome.signal:.3g}"
        what = f"{case}: {outcome.state} ({outcome.calibrated}) {in_words(outcome)}"
        return f"{what} [{outcome.identifying:.1f} s, {outcome.seconds:.1f} s] {outcome.reason}"

    def facts(self, outcomes: Sequence[CampaignOutcome]) -> dict[str, object]:
        unkind = Counter(words for o in outcomes for words in o.unkind)
        slow = [o.identifying for o in outcomes]
        return {
            "developed with the seeds": SEEN,
            "against some": ", ".join(f"{name}: {n}" for name, n in sorted(unkind.items())),
            "identification, median [s]": f"{statistics.median(slow):.1f}",
            "identification, longest [s]": f"{max(slow):.1f}",
        }

    def tables(self, outcomes: Sequence[CampaignOutcome]) -> Tables:
        missed = [o for o in outcomes if o.case.names and o.state != "named"]
        calibrated = [replace(o, state=o.calibrated or o.state) for o in outcomes]
        return {
            "requirements": Table.of(
                ("group", "requirement", "measured", "met"),
                [(*line, MET if met else NOT_MET) for *line, met in table(outcomes)],
            ),
            "records": Table.of(DETAILS, details(outcomes)),
            "outcomes": stacked(
                "by",
                {
                    "cause": confusion(grouped(outcomes, _group)),
                    "kind of record": confusion(grouped(outcomes, lambda o: o.case.kind)),
                    f"cause, {CALIBRATION:.0%} added to sigma_shape": confusion(grouped(calibrated, _group)),
                },
            ),
            "cases": stacked(
                "list",
                {
                    "causes that were not named": _listed(missed),
                    "confident and wrong": _listed([o for o in outcomes if o.state in ("wrong", "failed")]),
                },
            ),
            "rows": _false(outcomes),
            "modes": _missed(outcomes),
        }


def _cause(o: CampaignOutcome) -> str:
    return o.case.cause or "nothing"


def _group(o: CampaignOutcome) -> str:
    if not o.case.cause:
        return "nothing missing"
    if o.case.outside:
        return "outside the catalogue"
    return f"one effect, signal {'above' if o.signal > SIGNAL else 'up to'} {SIGNAL:g} sigma"


def _listed(outcomes: Sequence[CampaignOutcome]) -> Table:
    return Table.of(("machine", "cause", "signal", "rows", "verdict", "why"), map(_line, outcomes))


def _line(o: CampaignOutcome) -> tuple[object, ...]:
    why = in_words(o) or o.reason.strip().splitlines()[-1] if o.reason else in_words(o)
    if o.unkind:
        why = f"{why} ({', '.join(o.unkind)})"
    return o.case.label, _cause(o), f"{o.signal:.3g}", len(rows_of(o)), o.verdict or o.state, why


def _false(outcomes: Sequence[CampaignOutcome]) -> Table:
    """Return the rows that are no mode."""
    rows = [
        (
            *(o.case.label, f"P{row.record + 1}", f"{row.frequency:.2f}", f"{row.sigma:.2f}"),
            f"{100 * row.damping:.2g}",
        )
        for o in outcomes
        for row in rows_of(o)
        if row.mode < 0
    ]
    return Table.of(("machine", "pose", "frequency [Hz]", "sigma [Hz]", "damping [%]"), rows)


def _missed(outcomes: Sequence[CampaignOutcome]) -> Table:
    """Return the modes that were not found."""
    rows: list[tuple[object, ...]] = []
    for o in outcomes:
        if o.judged and o.judged.missed:
            places = ", ".join(f"P{record + 1}: {frequency:.1f}" for record, frequency in o.judged.missed)
            rows.append((o.case.label, len(o.judged.missed), len(o.judged.counted), places))
    return Table.of(("machine", "modes not found", "modes", "pose: frequency [Hz]"), rows)


main = Campaigns().main

if __name__ == "__main__":
    main()
