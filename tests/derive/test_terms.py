"""Terms: places of every mechanism, and what the search evaluates beside the extended model derived with the term."""

from __future__ import annotations

from collections.abc import Iterator
from types import SimpleNamespace

import numpy as np
import pytest

from pkmodes.core.mechanism.registry import mechanism as registered
from pkmodes.core.mechanism.regular import sample_parameters, sample_pose
from pkmodes.core.system.evaluation import ExtendedSystem
from pkmodes.loop.updating.term_changes import Surroundings, change_of
from pkmodes_derive import mechanisms
from pkmodes_derive.assembly import models
from pkmodes_derive.assembly.derived import derive
from pkmodes_derive.emit.product import arrange_functions
from pkmodes_derive.emit.registry import BACKENDS
from pkmodes_derive.functions import Model
from pkmodes_derive.terms.enumeration import Term, terms
from pkmodes_derive.terms.places import places
from pkmodes_description import Term as DescribedTerm

#: Places as the contract on terms names them.
PLACES = {
    "linear_delta": "platform carriage_1 carriage_2 carriage_3 link_1 link_2 link_3 pulley_1_1 pulley_1_2 pulley_2_1 "
    "pulley_2_2 pulley_3_1 pulley_3_2 frame",
    "rotary_delta": "platform link_1 link_2 link_3 arm_1 arm_2 arm_3 motor_1 motor_2 motor_3 frame",
    "corexy": "platform gantry pulley_1 pulley_2 frame",
    "cartesian": "platform beam pulley_1 pulley_2 frame",
    "bed_slinger": "toolhead bed pulley_1 pulley_2 frame",
    "hexapod": "platform leg_1 leg_2 leg_3 leg_4 leg_5 leg_6 rod_1 rod_2 rod_3 rod_4 rod_5 rod_6 "
    "motor_1 motor_2 motor_3 motor_4 motor_5 motor_6 frame",
}
#: Values of the parameters of terms: large enough that every digit counts.
VALUES = {
    "mass": 0.37,
    "inertia": 3.1e-4,
    "stiffness": 5.3e4,
    "compliance": 2.3e-7,
    "frequency": 71.0,
}


@pytest.mark.parametrize("name", PLACES)
def test_places_are_the_bodies_of_the_mechanism(name: str) -> None:
    assert set(places(mechanisms.machine(name))) == set(PLACES[name].split())


def test_the_description_lists_the_terms_in_order() -> None:
    described = [term.name for term in registered("linear_delta").terms]
    assert described == [term.name for term in terms(mechanisms.machine("linear_delta"))]


def _matrices(name: str, chosen: list[Term]) -> SimpleNamespace:
    """Return a module with the extended matrices of a mechanism with some terms as effects."""
    machine = mechanisms.machine(name, (*mechanisms.effects(name), *(term.effect for term in chosen)))
    d = derive(machine)
    function = models._matrices(d)
    model = Model(
        mechanism=name,
        coordinates=tuple((q.name, machine.vocabulary[q].unit) for q in machine.all_coordinates),
        vocabulary=machine.vocabulary,
        groups=(
            models.FieldGroup("Parameters", "parameters", tuple(machine.tables.fields), declared=False),
            models.FieldGroup("Effects", "effects", machine.effect_fields, null=0.0),
        ),
        functions=(function, models._joints(d)),
    )
    backend = next(one for one in BACKENDS if one.name == "NumPy")
    provenance = mechanisms_provenance(name)
    (text,) = backend.model(model, arrange_functions(model.functions), provenance).values()
    module: dict[str, object] = {}
    exec(compile(text, f"{name}_with_terms.py", "exec"), module)
    return SimpleNamespace(**module)


def mechanisms_provenance(name: str) -> object:
    """Return the header of a module that is not written."""
    from pkmodes_derive.emit.identity import Identity
    from pkmodes_derive.emit.provenance import Provenance

    return Provenance(
        name=f"{name}_terms",
        module="terms",
        title="Terms.",
        origin="a test",
        generator="a test",
        command="none",
        identity=Identity(name, "0"),
    )


def _groups(name: str) -> Iterator[list[Term]]:
    """Yield terms of each form that can be derived together: the first, one in the middle and the last of each."""
    every = terms(mechanisms.machine(name))
    for form in ("mass", "spring", "mount", "resonator"):
        some = [term for term in every if term.form == form]
        step = max(1, len(some) // 4)
        yield some[::step][:5]


@pytest.mark.slow
@pytest.mark.parametrize(
    "name", ["linear_delta", "corexy", "cartesian", "bed_slinger", "rotary_delta", "hexapod"]
)
def test_matrices_are_those_of_the_extended_model_with_the_term(name: str, subtests: pytest.Subtests) -> None:
    """The search changes M and K by displacements of places; the derivation knows nothing of that."""
    known = {term.name: term for term in registered(name).terms}
    for chosen in _groups(name):
        if not chosen:
            continue
        module = _matrices(name, chosen)
        for term in chosen:
            with subtests.test(term.name):
                if term.name in known:
                    assert _apart(name, module, term, known[term.name]) < 1e-11


def _apart(name: str, module: SimpleNamespace, term: Term, described: DescribedTerm) -> float:
    """Return the largest difference of an entry of M and K, relative to the diagonals of its row and column."""
    mechanism = registered(name)
    plain, p = sample_parameters(mechanism), sample_pose(mechanism)
    values = [VALUES[named.name] for named in described.parameters]
    catalogue = mechanism.extended.Effects(**_catalogue_values(mechanism))
    effect = {
        f"{term.effect.name}_{named.name}": v for named, v in zip(described.parameters, values, strict=True)
    }
    effects = module.Effects(**catalogue._asdict(), **effect)
    M, K_el, K_g = module.extended_matrices(p, plain, effects)
    with np.errstate(divide="ignore"):  # joints that are locked
        kappa, _ = module.joint_stiffness(effects)
    base, names = len(mechanism.coordinates), list(module.COORDINATES)
    old = [names.index(q) for q in mechanism.extended.COORDINATES]
    own = [
        names.index(q)
        for q in names
        if q.endswith(f"_{term.ends[0].name}{term.along}") and q[:2] in ("w_", "y_")
    ]
    own = own if term.form in ("mount", "resonator") else []
    K = K_el + K_g
    for q in own:
        K[q, q] += kappa[q - base] if term.form == "mount" else 0.0
    every = np.ix_([*old, *own], [*old, *own])
    system = ExtendedSystem(mechanism, plain, {})
    system.effects = catalogue
    change = change_of(described, values, Surroundings(system, p[None]))
    M_0, K_el_0, K_g_0 = mechanism.extended.extended_matrices(p, plain, catalogue)
    worst = 0.0
    for wanted, before, more in ((M[every], M_0, change.M[0]), (K[every], K_el_0 + K_g_0, change.K[0])):
        found = np.array(more)
        found[: len(before), : len(before)] += before
        size = np.sqrt(np.abs(np.diagonal(wanted)))
        scale = np.outer(size, size)
        scale[scale == 0.0] = np.abs(wanted).max()
        worst = max(worst, float((np.abs(found - wanted) / scale).max()))
    return worst


def _catalogue_values(mechanism: object) -> dict[str, float]:
    """Return values of effects that a term has to live with: a payload, heavy belts, a frame."""
    some = {
        "payload_mass": 0.21,
        "belt_mass_linear_density": 0.11,
        "frame_compliance_mass": 23.0,
        "cable_stiffness_stiffness": 900.0,
    }
    return {name: value for name, value in some.items() if name in mechanism.extended.Effects._fields}  # type: ignore[attr-defined]
