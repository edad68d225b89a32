"""Write the page of results from the CSV files of the suites, and from nothing else.

    python -m studies.results                                        # `make suites`, after the suites

A section of the page says what a suite measured on what, whether its requirements are met, and names what was missed.
"""

from __future__ import annotations

import re
import textwrap
from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from studies.motors import DRIVES
from studies.requirements import NOT_MET
from studies.tables import Table, Tables, markdown, read

ROOT = Path(__file__).resolve().parents[2]
FOLDER, PAGE = ROOT / "docs/results", ROOT / "docs/reference/results.md"
#: Length of its lines; causes that are named of those that were missed.
WIDTH, MENTIONED = 118, 8
#: A row of a CSV file by its columns.
Record = Mapping[str, str]

BEGINNING = """\
# Results

How often pkmodes is right, measured on a virtual test rig whose physics shares no code with the model
(`tests/pkmodes_rig`).  `make suites` writes the tables of the suites, CSV files in `docs/results`, and then this
page from them: do not edit it.  The head of each module in `tests/studies` says how its cases are drawn, measured
and judged.  Requirements were fixed before the reported seed was run.

In the tables, 66/66 (94.6-100.0) are 66 of 66 cases, with the 95 % Clopper-Pearson interval of the rate in %.

*Named*: a cause is claimed, and each true cause is in a class of its own.  *Wrong*: a class without any true cause
is claimed.  *Abstained*: `ambiguous`, `unexplained` or `insufficient_data`.  The *signal* of a cause is the
residual that it leaves after the declared model and its uncertain values are fitted to the true modes, in standard
deviations."""


class Section(NamedTuple):
    """A section of the page.

    Attributes
    ----------
    name : str
        Folder of its CSV files.
    title, text : str
        The text may quote the summary: "{cases}".
    tables : callable
        Makes tables of the page from those of the suite.
    misses : callable, optional
        Names what was missed.
    """

    name: str
    title: str
    text: str
    tables: Callable[[Tables], Sequence[Table]]
    misses: Callable[[Tables], Sequence[str]] = lambda tables: ()


def page(folder: Path = FOLDER) -> str:
    """Return the page."""
    suites = {section.name: read(folder / section.name) for section in SECTIONS}
    lines = [*BEGINNING.splitlines(), "", *markdown(_overview(suites)), ""]
    for section in SECTIONS:
        tables = suites[section.name]
        facts = tables["summary"].values()
        text = re.sub(r"\s+", " ", section.text)
        for name in re.findall(r"\{([^}]+)\}", text):
            text = text.replace(f"{{{name}}}", facts[name])
        cases, every = _cases(facts)
        if cases != every:
            text += f" **Not every case was run: {cases} of {every}.**"
        if (small := facts.get("none large enough", "0")) != "0":
            text += f" In {small} cases nothing of the kind was large enough at any place that was drawn."
        lines += [f"## {section.title}", "", *_filled(text), ""]
        for table in section.tables(tables):
            lines += [*markdown(table), ""]
        for miss in section.misses(tables):
            lines += [*_filled(miss), ""]
        files = ", ".join(f"[{name}](../results/{section.name}/{name}.csv)" for name in sorted(tables))
        lines += [*_filled(f"CSV: {files}."), ""]
    return "\n".join(lines[:-1]) + "\n"


def _cases(facts: Mapping[str, str]) -> tuple[str, str]:
    """Return how many cases were run, and how many the suites have."""
    cases = facts.get("cases", facts.get("cases drawn", ""))
    return cases, facts.get("cases of the suites", cases)


def _filled(text: str) -> list[str]:
    """Return a paragraph in lines."""
    return textwrap.wrap(re.sub(r"\s+", " ", text), WIDTH, break_long_words=False, break_on_hyphens=False)


def _overview(suites: Mapping[str, Tables]) -> Table:
    rows = []
    for section in SECTIONS:
        tables = suites[section.name]
        facts = tables["summary"].values()
        asked = [record for record in _records(tables, "requirements") if record["met"]]
        met = sum(record["met"] != NOT_MET for record in asked)
        anchor = section.title.lower().replace(" ", "-")
        cases, every = _cases(facts)
        cases = cases if cases == every else f"{cases} of {every}"
        rows.append((f"[{section.title}](#{anchor})", cases, f"{met} of {len(asked)}" if asked else ""))
    return Table.of(("suite", "cases", "requirements met"), rows)


# Requirements ------------------------------------------------------------------------------------------------


def _records(tables: Tables, name: str) -> list[dict[str, str]]:
    return tables[name].records() if name in tables else []


def _cell(record: Record) -> str:
    """Return what was measured, in bold where the requirement is not met."""
    if "measured" in record:
        text = record["measured"]
    elif record["cases"] == "0":
        return "no cases"
    else:
        text = f"{record['number']}/{record['cases']} ({record['low [%]']}-{record['high [%]']})"
    return f"**{text} {NOT_MET}**" if record["met"] == NOT_MET else text


def _pivot(
    records: Iterable[Record], title: str, row: Callable[[Record], str], column: Callable[[Record], str]
) -> Table:
    """Return requirements with a row and a column each."""
    cells: dict[str, dict[str, str]] = {}
    columns: dict[str, None] = {}
    for record in records:
        cells.setdefault(row(record), {})[column(record)] = _cell(record)
        columns[column(record)] = None
    rows = [(name, *(of.get(record, "") for record in columns)) for name, of in cells.items()]
    return Table.of((title, *columns), rows)


def _plain(tables: Tables) -> list[Table]:
    """Return one column of requirements."""
    return [
        _pivot(
            _records(tables, "requirements"),
            "requirement",
            lambda record: f"{record['group']}: {record['requirement']}",
            lambda _: "measured",
        )
    ]


def _by(split: Callable[[Record], tuple[str, str]]) -> Callable[[Tables], list[Table]]:
    """Return a function that shows requirements in columns; `split` gives the column, and the suite of its row."""

    def shown(tables: Tables) -> list[Table]:
        return [
            _pivot(
                _records(tables, "requirements"),
                "suite: requirement",
                lambda record: f"{split(record)[1]}: {record['requirement']}",
                lambda record: split(record)[0],
            )
        ]

    return shown


def _motors(record: Record) -> tuple[str, str]:
    return record["motors"], record["group"]


def _mechanism(record: Record) -> tuple[str, str]:
    """Return the parts of a group: "corexy, one effect"; one without a mechanism is of all."""
    mechanism, comma, suite = record["group"].partition(", ")
    return (mechanism, suite) if comma else ("all", mechanism)


def _mechanism_and_motors(record: Record) -> tuple[str, str]:
    """Return the parts of a group: "corexy, one effect, motors held"."""
    mechanism, _, rest = record["group"].partition(", ")
    suite, _, drives = rest.partition(", motors ")
    return f"{mechanism}, {drives or DRIVES[0]}", suite


def _by_suite(tables: Tables) -> list[Table]:
    """Return a row for each mechanism, and the requirements on all of them below."""
    records = _records(tables, "requirements")
    every = [record for record in records if record["group"] == "all"]
    of_one = [record for record in records if record["group"] != "all"]

    def column(record: Record) -> str:
        return f"{record['group'].partition(', ')[2]}: {record['requirement'].partition(' >=')[0]}"

    return [
        _pivot(of_one, "mechanism", lambda record: record["group"].partition(", ")[0], column),
        _pivot(every, "all", lambda record: record["requirement"], lambda _: "measured"),
    ]


def _rows(name: str, by: str = "") -> Callable[[Tables], list[Table]]:
    """Return a function that shows a table as it is, or the part of it where the first column has a name."""

    def shown(tables: Tables) -> list[Table]:
        table = tables[name]
        if not by:
            return [table]
        return [Table.of((by, *table.head[2:]), (row[1:] for row in table.rows if row[0] == by))]

    return shown


# What was missed ---------------------------------------------------------------------------------------------


def _taken(records: Iterable[Record], truth: Callable[[Record], str]) -> str:
    """Return what was taken for what, with the number of cases where there are several."""
    taken = Counter((truth(record), _claim(record)) for record in records)
    return "; ".join(f"{_code(what)} for {claim}{_times(n)}" for (what, claim), n in taken.items())


def _claim(record: Record) -> str:
    """Return the first member of each class without a true cause; of all classes if none is without."""
    classes = (record.get("classes") or record["why"].partition(" (")[0]).split("; ")
    true = set(_truth(record).split(" + "))
    wrong = [members for members in classes if not true & set(members.split(" or "))] or classes
    return " and ".join(_code(members.split(" or ")[0]) for members in wrong)


def _code(name: str) -> str:
    return " + ".join(
        f"`{part}`" if re.fullmatch(r"\w+[_.:][\w.]+", part) else part for part in name.split(" + ")
    )


def _times(number: int) -> str:
    return f" ({number} cases)" if number > 1 else ""


def _counted(records: Iterable[Record], truth: Callable[[Record], str]) -> str:
    counts = Counter(map(truth, records)).most_common()
    told = [f"{_code(what)} {number}" for what, number in counts[:MENTIONED]]
    others = sum(number for _, number in counts[MENTIONED:])
    return ", ".join([*told, *([f"others {others}"] if others else [])])


def _truth(record: Record) -> str:
    """Return what a case lacks; of a complete machine, which one it is."""
    truth = record.get("truth") or record.get("cause") or record["case"].rsplit(", ", 3)[0]
    return record["case"].partition(",")[0] if truth == "nothing" and "case" in record else truth


def _kind(record: Record) -> str:
    """Return the kind of a fault at a place: "mass" of "mass:platform"."""
    return record["truth"].partition(":")[0]


def _listed(truth: Callable[[Record], str] = _truth) -> Callable[[Tables], list[str]]:
    """Return a function that names the cases of each list."""

    def named(tables: Tables) -> list[str]:
        groups: dict[str, list[Record]] = {}
        for record in _records(tables, "cases"):
            groups.setdefault(record["list"], []).append(record)
        lines = []
        for title, records in groups.items():
            told = _taken(records, _truth) if title == "confident and wrong" else _counted(records, truth)
            lines.append(f"*{title[0].upper()}{title[1:]}* ({len(records)}): {told}.")
        return lines

    return named


def _of_changes(tables: Tables) -> list[str]:
    records = _records(tables, "cases")
    wrong = [record for record in records if record["state"].startswith("wrong")]
    silent = [
        record
        for record in records
        if record["truth"] != "nothing" and record["state"].split()[0] in ("abstained", "unchanged")
    ]
    return [
        f"*Confident and wrong* ({len(wrong)}): {_taken(wrong, _truth)}.",
        f"*Not named* ({len(silent)}): {_counted(silent, _kind)}.",
    ]


def _of_thresholds(tables: Tables) -> list[str]:
    records = _records(tables, "thresholds")
    changing = [
        record for record in records if record["half: changed"] != "0" or record["double: changed"] != "0"
    ]
    stay = Counter(record["why it stays"].partition(",")[0] for record in records if record not in changing)
    reasons = tables["reasons"].values()
    return [
        f"Half or double of {len(changing)} of the {len(records)} thresholds changed an outcome.  The others:",
        *(f"* {number}: {reasons[letter]}." for letter, number in sorted(stay.items())),
    ]


# Sections ----------------------------------------------------------------------------------------------------

SECTIONS = (
    Section(
        "diagnosis",
        "The linear delta",
        """\
{cases} cases (seed {seed}): three robots in three plans of twelve poses, six modes with 0.2 % noise, shapes except
in every fifth case, and true values of the uncertain parameters drawn from their priors.  In the *realistic*
suites, and with few rows, missed modes and outliers, a laboratory is drawn for each case: 15 % of the modes
missed, a band, few sensors or none, errors that differ from row to row and may all be wrong by a common factor;
some specimens are frames of three to five storeys.  Motors are free, held, or held at every second pose (mixed).""",
        _by(_motors),
        _listed(),
    ),
    Section(
        "mechanisms",
        "Rotary delta and CoreXY",
        """\
{cases} cases (seed {seed}) at 10 to 12 poses, with 0.2 % noise, shapes except in every fifth case, and 15 % of the
modes missed in every second one.  A CoreXY has two vibration modes per pose, a rotary delta three, so that causes
are harder to tell apart.  `one_run`, a soft end of one run of a belt, turned out to be exactly equivalent to a
longer free length, which the catalogue has; its cases count as wrong, because the judging was fixed beforehand.""",
        _by(_mechanism_and_motors),
        _listed(),
    ),
    Section(
        "clear-causes",
        "Clear causes",
        """\
{cases} cases (seed {seed}) on five robots of three mechanisms, twelve poses, each case by a realistic laboratory
of its own.  Causes are sized by their signal in the modes that were found: one effect 9 to 14, each of two 10 to
25, outside the catalogue 9 to 50.  36 cases were diagnosed again with each pose alone held out ({splits} splits).
In {not named, but among several that remain} of the {not named} cases that were not named, the truth is among
several explanations that remain.""",
        _by(_mechanism),
        _listed(),
    ),
    Section(
        "six-legs",
        "Machines with six legs",
        """\
{cases} cases (seed {seed}) of a hexapod and a hexaglide, sized and measured as clear causes are, at twelve poses
drawn for each case in a box of positions and rotations.  Every second case has sensors on the platform, the others
on the legs or carriages.  A hose along a leg acts as a stiffer leg does: the claim that legs are not equally stiff
is then correct in effect, and counted as wrong.""",
        _by(_mechanism),
        _listed(),
    ),
    Section(
        "one-place",
        "One fault at one place",
        """\
Faults that the catalogue does not have, on nine robots of seven mechanisms (seed {seed}).  A *clear* fault changes
frequencies by 0.7 to 1.3 %; a *faint* one changes all modes together by 9 to 14 standard deviations; laws *outside
the grammar* are no term at all.  At least 80 % of the faults of the linear delta and 70 % of the others should be
named, 90 % of the laws left unnamed, and 95 % of the complete machines called adequate.  In {true term among
several that remain} cases that were not named, the true term is among several that remain.""",
        _by_suite,
        _listed(_kind),
    ),
    Section(
        "changed",
        "What changed between two campaigns",
        """\
Pairs of campaigns on nine robots of seven mechanisms (seed {seed}).  The robot file is wrong by up to 3 % both
times, and the drives have another temperature the second time.  One thing changed, by 0.7 to 1.3 % of the
frequencies (*clear*) or by 9 to 14 standard deviations of all modes together (*sigmas*), or nothing.  In {what
changed is among what remains} of the {changes that were not named} pairs that were not named, what changed is
among what remains.""",
        _plain,
        _of_changes,
    ),
    Section(
        "damping",
        "Damping",
        """\
{cases} cases (seed {seed}) on five robots of three mechanisms, three to eight modes at eight poses; the losses
damp the modes that they reach by 0.4 to 3 %, however hard they are to tell apart.  Errors of the ratios are 5, 10
or 20 %, or not stated.  *Adequate* is the damping of the file, or, where it declares none, one ratio for all
modes.  With *scatter by mode* each ratio is off by 20 to 40 % at all poses, as laboratories measure it.""",
        _plain,
        _listed(),
    ),
    Section(
        "signals",
        "From signals to causes",
        """\
{cases} machines of three mechanisms (seed {seed}), from the accelerometer on: shakers, hammers or ambient
vibration, 1024 Hz, universal files, MATLAB files or tables, identified by `pkmodes identify` and diagnosed by
`pkmodes diagnose`.  Belts settle anew, rooms warm, sensors are noisy and askew; some machines
have more against them ({against some}).""",
        _plain,
        _listed(),
    ),
    Section(
        "limits",
        "Limits",
        """\
How large what a diagnosis does not find may be.  {cases} cases of the linear delta (seed {seed}) hide one effect
or wrong value with a signal of 0 to {largest signal}: {adequate} were adequate, {unexplained} unexplained,
{ambiguous} ambiguous, and in {effect_found} an effect was found.  A limit covers if the true size is not above it;
at a physical bound it covers more often than stated.  The intervals of the fit alone contain {of these covering}
of {intervals of the fit alone} true values; those saved are wider by a factor of {saved sigma / sigma of the fit,
median} in the median.""",
        _plain,
    ),
    Section(
        "probabilities",
        "Probabilities",
        """\
How often the most probable explanation is right, in {cases} cases (seed {seed}) drawn from all suites but those
with mistaken files and those of six legs, one place and damping: {with probabilities} have probabilities.  That
nothing is missing is wrong where a cause is too small to be seen, and so is a class with one of two causes.  The
expected calibration error is {expected calibration error}.""",
        _rows("probabilities", "largest probability"),
    ),
    Section(
        "refused",
        "Probable and refused",
        """\
The most probable class or pair, held against the verdict and the truth: {cases drawn} cases drawn from {suites}
suites (seed {seed}), of which {with a class or pair} have one, and all {cases with few rows} cases with few rows.
An `unexplained` verdict leaves a doubt of at least {doubt, refused [%]} %, so that what it refuses is never
probable as stated; *as if accepted*, the doubt is {doubt, accepted [%]} %.  Those that are refused nevertheless
were diagnosed again without the rule that refused: the last table says what would be claimed.""",
        lambda tables: [*_rows("shares")(tables), *_rows("without")(tables)],
    ),
    Section(
        "thresholds",
        "Thresholds",
        """\
{cases} cases of four suites, each threshold of `pkmodes.diagnosis.Criteria` at half and at double its value:
{diagnoses with another threshold} diagnoses.  Where no decision and no number on the way was another one, the
outcome cannot be: {not noticed, and tried} of those were tried, and {not noticed, but changed} were.""",
        lambda tables: [],
        _of_thresholds,
    ),
)


def main() -> None:
    """Write the page."""
    PAGE.write_text(page(), encoding="utf-8")


if __name__ == "__main__":
    main()
