"""The functions that a diagnosis needs to try terms: motion of their places, and matrices of mounts that may yield.

A mass, a spring or a resonator changes M and K by squares of the displacements of its place; a mount is a released
coordinate, whose rows of M and K are derived with all mounts of the machine released.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass, field

from sympy import Expr, Integer, Symbol, diff

from pkmodes_derive.assembly.derived import Derived, derive, flattened, matrix_sum
from pkmodes_derive.assembly.placed import motion
from pkmodes_derive.effect import Effect
from pkmodes_derive.functions import FieldGroup, Function, Model, Output
from pkmodes_derive.machine import Machine
from pkmodes_derive.parts import Rod
from pkmodes_derive.terms.enumeration import Term, terms
from pkmodes_derive.terms.places import FRAME, PLATFORM, Place, places, strained_directions
from pkmodes_description import Named
from pkmodes_description import Term as DescribedTerm

#: Parameters of catalogue effects that are the mass of a place whose mass a mechanism need not declare.
LENT_MASSES = {PLATFORM: "payload_mass", FRAME: "frame_compliance_mass"}


@dataclass
class _Motions:
    """The displacements of places, each derived once, and their rows."""

    derived: Derived
    place_of: dict[str, Place]
    size: int
    rows: list[tuple[Expr, ...]] = field(default_factory=list)
    row_of: dict[tuple[str, str], int] = field(default_factory=dict)

    def row(self, place: Place, along: str) -> int:
        """Return the row of a displacement."""
        if (place.name, along) not in self.row_of:
            displacement = motion(self.derived.machine, self.derived.kin, self.place_of[place.name], along)
            row = tuple(displacement[: self.size])
            if row not in self.rows:
                self.rows.append(row)
            self.row_of[place.name, along] = self.rows.index(row)
        return self.row_of[place.name, along]


def terms_model(
    plain_machine: Machine, with_effects: Callable[[Sequence[Effect]], Machine], known: Collection[str] = ()
) -> tuple[Model, tuple[DescribedTerm, ...]]:
    """Return the functions for the terms of a machine, and what the runtime needs to know of each.

    Parameters
    ----------
    plain_machine : Machine
        Without effects.
    with_effects : callable
        ``with_effects(mounts)`` returns the machine with the catalogue and these effects.
    known : collection of str
        Names of effects of the catalogue, which are no terms.
    """
    all_terms = [term for term in terms(plain_machine) if term.effect.name not in known]
    mounts = [term for term in all_terms if term.form == "mount"]
    machine = with_effects([term.effect for term in mounts])
    d = derive(machine)
    size = len(machine.rates) - len(mounts)
    motions = _Motions(d, places(machine), size)
    described = tuple(
        description
        for term in all_terms
        if (description := _describe_term(term, motions, machine, mounts)) is not None
    )
    return _model(d, motions.rows, size, mounts), described


def _describe_term(
    term: Term, motions: _Motions, machine: Machine, mounts: Sequence[Term]
) -> DescribedTerm | None:
    """Return a term for the runtime; None for a mass whose weight no declared value has."""
    parameters = tuple(Named(p.name, p.unit, p.description) for p in term.effect.on(machine).parameters)
    common = term.name, term.form, term.sentence, parameters
    place = term.ends[0]
    if term.form == "spring":
        directions = (term.along,) if term.along else strained_directions(term.ends)
        strains = tuple(tuple(motions.row(end, along) for end in term.ends) for along in directions)
        return DescribedTerm(*common, strains=strains)
    if term.form == "mount":
        return DescribedTerm(*common, mount=mounts.index(term))
    declared = _declared_mass(machine, place) if place.directions else None
    if place.directions and declared is None:
        return None
    if term.form == "mass" and isinstance(place.part, Rod):
        return DescribedTerm(*common, declared=declared)
    # A body that slides on a rail follows the frame in all directions.
    directions = machine.directions if place.along else place.translations or ("",)
    rows = tuple(motions.row(place, along) for along in directions)
    swing_row = motions.row(place, term.along) if term.form == "resonator" else -1
    return DescribedTerm(*common, rows=rows, swings=swing_row, declared=declared)


def _declared_mass(machine: Machine, place: Place) -> tuple[str, int] | None:
    """Return the field and the index of the mass that a place has, or of an effect that lends it one."""
    fields = {symbol: (f.name, i) for f in machine.tables.fields for i, symbol in enumerate(f.symbols)}
    if place.mass in fields:
        return fields[place.mass]
    lent = LENT_MASSES.get(place.name, "")
    return (lent, 0) if any(f.name == lent for f in machine.effect_fields) else None


def _model(d: Derived, rows: Sequence[tuple[Expr, ...]], size: int, released: Sequence[Term]) -> Model:
    machine, v = d.machine, d.machine.vocabulary
    mounts, prefixes = len(released), tuple(f"{term.effect.name}_" for term in released)
    fields = tuple(f for f in machine.effect_fields if not f.name.startswith(prefixes))
    masses = {s: Integer(0) for f in machine.effect_fields if f not in fields for s in f.symbols}
    functions = [
        Function(
            "place_motion",
            "Displacements of the places of terms per unit of every coordinate.",
            "the velocities of the bodies that the mechanism declares, without the mounts of terms",
            (d.pose,),
            (Output("J", (len(rows), size), flattened(rows), "1, m", "one row for each displacement"),),
            d.kin.definitions,
            in_c=False,
        )
    ]
    if mounts:
        K = matrix_sum(d.K_el, d.K_g)
        index = range(size, size + mounts)
        platform_motion = d.platform_motion([machine.rates[w] for w in index])
        platform = Output(
            "J_p",
            (mounts, len(platform_motion)),
            flattened([list(column) for column in zip(*platform_motion, strict=True)]),
            "1, 1/m",
            "motion of the platform per unit of each mount",
        )
        functions.append(
            Function(
                "mount_matrices",
                "Rows of M and K of what holds a body, where it yields alone.",
                "equations 24 to 48 with these displacements released; without the springs of the mounts",
                (d.pose,),
                tuple(
                    Output(name, shape, tuple(e.xreplace(masses) for e in entries), unit, what)
                    for name, matrix, unit in (("M", d.M, "kg, kg m"), ("K", K, "N/m, N"))
                    for name, shape, entries, what in _mount_rows(name, matrix, index, size)
                )
                + (platform,),
                d.kin.definitions,
                in_c=False,
            )
        )
        functions.append(_mount_inertia(d, index, size, released))
    return Model(
        mechanism=machine.name,
        coordinates=tuple((q.name, v[q].unit) for q in machine.all_coordinates[:size]),
        vocabulary=v,
        groups=(
            FieldGroup("Parameters", "parameters", tuple(machine.tables.fields), declared=False),
            FieldGroup("Effects", "effects", fields, null=0.0, declared=False),
        ),
        functions=tuple(functions),
    )


def _mount_rows(
    name: str, matrix: Sequence[Sequence[Expr]], index: range, size: int
) -> list[tuple[str, tuple[int, ...], list[Expr], str]]:
    mixed = [matrix[w][k] for w in index for k in range(size)]
    own = [matrix[w][w] for w in index]
    return [
        (
            f"{name}_wq",
            (len(index), size),
            mixed,
            f"entries of {name} between each mount and every coordinate",
        ),
        (f"{name}_ww", (len(index),), own, f"diagonal entry of {name} of each mount"),
    ]


def _mount_inertia(d: Derived, index: range, size: int, released: Sequence[Term]) -> Function:
    """Return the derivatives of these rows of M with respect to the mass that moves with each mount."""
    fields = {f.name: f.symbols[0] for f in d.machine.effect_fields}
    symbols = [fields.get(f"{term.effect.name}_mass") for term in released]

    def rate(entry: Expr, symbol: Symbol | None) -> Expr:
        return Integer(0) if symbol is None else diff(entry, symbol)

    pairs = list(zip(index, symbols, strict=True))
    mixed = tuple(rate(d.M[w][k], s) for w, s in pairs for k in range(size))
    return Function(
        "mount_inertia",
        "Derivatives of the rows of M of the mounts with respect to the mass that moves with each.",
        "the kinetic energy of a bearing that yields, of which the frame has the rest",
        (),
        (
            Output("M_wq", (len(index), size), mixed, "1", "of M_wq"),
            Output("M_ww", (len(index),), tuple(rate(d.M[w][w], s) for w, s in pairs), "1", "of M_ww"),
        ),
        d.kin.definitions,
        in_c=False,
    )
