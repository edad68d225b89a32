"""Numbers and units as people write them, in the spelling that is read: text only, for the remedies of errors."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import islice, product

#: The typographic minus sign, and what separates groups of digits, with the typographic apostrophe and spaces.
MINUS_SIGN = "\u2212"
SEPARATORS = ".,'\u2019 \u00a0\u2009\u202f"
#: A number whose digits may be grouped by thousands, perhaps with decimals.
GROUPED_NUMBER = re.compile(
    rf"\s*(?P<sign>[+\-{MINUS_SIGN}]?)(?P<digits>\d+(?:[{SEPARATORS}]\d+)*)(?P<power>[eE][+-]?\d{{1,3}})?"
    rf"\s*(?P<unit>(?![\d{SEPARATORS}]).*?)?\s*",
    re.DOTALL,
)

#: Names that people also use for another unit: pattern, spelling of the unit meant, and both units in words.
AMBIGUOUS_NAMES: tuple[tuple[re.Pattern[str], tuple[str, ...], str], ...] = (
    (re.compile(r"(k|m|kilo|milli)?(gr|grain)s?"), (r"\1g",), "the gram or the grain (64.8 mg)"),
    (re.compile(r"gra(d|de)s?"), ("deg",), "the degree or the gon (0.9 deg)"),
    (re.compile(r"tons?"), ("t",), "the tonne or the short ton (907 kg)"),
    (re.compile(r"mt"), ("m", "t"), "the metre, the metric ton or a thousandth of one"),
    (re.compile(r"Mm|megamet(er|re)s?"), ("mm",), "the millimetre or the megametre (1000 km)"),
)
#: Other names of units, in lower case.
SYNONYMS = {
    "g": ("gm", "gms", "grm", "gramm", "gramme", "grammes"),
    "kg": ("kgs", "kilo", "kilos"),
    "t": ("te", "tn"),
    "m": ("mts", "mtr", "mtrs"),
    "thou": ("mil", "mils"),
    "inch": ('"', "''"),
    "s": ("secs",),
    "N": ("newton", "newtons"),
    "kgf": ("kg", "kp"),  # the weight of a mass, where a force is expected
    "gf": ("g",),
    "lbf": ("lb", "lbs", "pound", "pounds"),
    "ozf": ("oz",),
    "gravity": ("g", "gn"),
    "rad": ("rads",),
    "deg": ("º",),
    "Hz": ("hz", "herz"),
    "kHz": ("khz",),
    "%": ("percent", "pct"),
}
#: Symbols that people write without a separator, as in Nm, or with capitals and small letters exchanged.
SYMBOLS = (
    *("mm", "cm", "um", "µm", "m", "s", "rad", "deg", "arcmin", "in"),
    *("N", "kN", "MN", "mN", "cN", "daN", "kgf", "kg", "gf", "g", "lbf", "lb", "ozf", "oz"),
)
WORD = re.compile(r"([A-Za-zµμ°º%\"']+)((?:\^-?\d)?)")
#: Maximum number of factors of a unit, of symbols in a name that stands for a product, and of spellings tried.
MAX_FACTORS, MAX_SYMBOLS, MAX_SPELLINGS = 5, 3, 200
SUPERSCRIPTS = str.maketrans("⁻⁰¹²³⁴", "-01234")


def number_readings(text: str) -> tuple[list[tuple[str, str]], str]:
    """Return how a number can be read whose digits are separated by anything but one decimal point.

    Returns, in this order:
    - the number with a decimal point and the unit, for each reading; empty if it is no such number
    - its peculiarity, as a relative clause
    """
    match = GROUPED_NUMBER.fullmatch(text)
    if match is None:
        return [], ""
    digits = match["digits"]
    separators = list(dict.fromkeys(c for c in digits if c in SEPARATORS))
    point = next((c for c in separators[-1:] if c in ".," and digits.count(c) == 1), "")
    integer_digits, _, decimals = digits.rpartition(point) if point else (digits, "", "")
    readings = []
    if _in_groups(integer_digits):
        readings.append(
            f"{_without_separators(integer_digits)}.{decimals}"
            if point
            else _without_separators(integer_digits)
        )
    if separators == [","] and point:
        peculiarity = "which has a decimal comma"
        if integer_digits != "0" and _in_groups(digits):  # also "1,234"
            readings.append(_without_separators(digits))
            peculiarity = "whose comma may separate decimals or thousands"
    elif separators in ([], ["."]) and (point or not separators):
        peculiarity = "which has a typographic minus sign"
        readings = readings if match["sign"] == MINUS_SIGN else []
    else:
        peculiarity = "whose digits are in groups"
    sign = match["sign"].replace(MINUS_SIGN, "-")
    return [
        (f"{sign}{number}{match['power'] or ''}", match["unit"] or "") for number in readings
    ], peculiarity


def _in_groups(digits: str) -> bool:
    """Return whether digits are undivided, or in groups of three after the first with one kind of separator."""
    first, *groups = re.split(r"\D", digits)
    one_separator = len(set(re.findall(r"\D", digits))) <= 1
    return one_separator and all(len(group) == 3 for group in groups) and (not groups or len(first) <= 3)


def _without_separators(digits: str) -> str:
    return re.sub(r"\D", "", digits)


def ambiguous_name(unit: str) -> tuple[str, str] | None:
    """Return the first name in a unit that does not denote what most people mean by it, and what it may be."""
    for name, _ in WORD.findall(unit):
        for pattern, _, meanings in AMBIGUOUS_NAMES:
            if pattern.fullmatch(name) is not None:
                return name, meanings
    return None


def likely_spellings(unit: str) -> Iterator[str]:
    """Yield what a unit may stand for, the most likely first: ``N*m/rad`` for ``Nm/rad``.

    The caller checks which of them is of the expected kind.
    """
    text = re.sub(r"[⁻⁰¹²³⁴]+", lambda match: "^" + match[0].translate(SUPERSCRIPTS), unit.rstrip(". "))
    text = re.sub(r"[·⋅\u00d7•∙]", "*", text.replace("**", "^"))
    text = re.sub(r"(?<=[A-Za-zµμ])\s*[.\-]\s*(?=[A-Za-zµμ])", "*", text)
    text = re.sub(r"(?<=[A-Za-zµμ])(-?\d)(?!\d)", r"^\1", text)
    text = re.sub(r"\bg_?\^?0\b", "gravity", re.sub(r"\A\s*/", "1/", text))
    words = list(WORD.finditer(text))
    if len(words) > MAX_FACTORS:
        return
    for variant in dict.fromkeys((text, _one_quotient(text), _quotient_of_quotients(text))):
        for combination in islice(product(*(_meanings(word[1]) for word in words)), MAX_SPELLINGS):
            names = iter(combination)

            def next_name(word: re.Match[str], names: Iterator[str] = names) -> str:
                name = next(names) + word[2]
                divides = "*" in name and word.string[: word.start()].rstrip().endswith("/")
                return f"({name})" if divides else name

            yield WORD.sub(next_name, variant)


def _one_quotient(text: str) -> str:
    """Return ``rad/(N*m)`` for ``rad/N*m``."""
    numerator, slash, denominator = text.partition("/")
    return f"{numerator}/({denominator})" if slash and "*" in denominator and "/" not in denominator else text


def _quotient_of_quotients(text: str) -> str:
    """Return ``N/(m/s)`` for ``N/m/s``."""
    numerator, slash, denominator = text.partition("/")
    return f"{numerator}/({denominator})" if slash and "/" in denominator and "(" not in denominator else text


def _meanings(name: str) -> list[str]:
    """Return the names of units that a name may stand for, itself first unless it is often confused."""
    for pattern, units, _ in AMBIGUOUS_NAMES:
        if (match := pattern.fullmatch(name)) is not None:
            return [match.expand(unit) for unit in units]
    lower = name.lower()
    synonyms = [unit for unit, names in SYNONYMS.items() if lower in names]
    same_letters = [symbol for symbol in SYMBOLS if symbol.lower() == lower]
    ambiguous = [
        pattern.sub(units[0], lower) for pattern, units, _ in AMBIGUOUS_NAMES if pattern.fullmatch(lower)
    ]
    written = () if name in SYMBOLS else (name, name.upper().replace("M", "m"))
    products = ["*".join(parts) for text in written for parts in _split_into_symbols(text) if len(parts) > 1]
    return list(dict.fromkeys([name, *products, *same_letters, *synonyms, *ambiguous]))


def _split_into_symbols(name: str, limit: int = MAX_SYMBOLS) -> Iterator[list[str]]:
    """Yield the ways in which a name consists of a few symbols."""
    if not name:
        yield []
    for symbol in SYMBOLS if limit else ():
        if name.startswith(symbol):
            yield from ([symbol, *rest] for rest in _split_into_symbols(name[len(symbol) :], limit - 1))
