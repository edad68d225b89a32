"""The two products: the parametric model of a mechanism, and a model specialised to one robot.

A product is a set of texts by file name, including its manifest; it is built in memory and is a pure
function of the derivation, the templates and the specification.  Writing and comparing are done elsewhere.
"""

from __future__ import annotations

from dataclasses import replace

import sympy

import pkmodes_derive
from pkmodes_derive import mechanisms
from pkmodes_derive.definition import FILE_NAME
from pkmodes_derive.emit import c99, lanes, manifest, numpy
from pkmodes_derive.emit.identity import Identity, limits, literal
from pkmodes_derive.emit.program import Program, arrange
from pkmodes_derive.emit.provenance import ANY_ROBOT, Provenance, pasteable
from pkmodes_derive.emit.specification import Specification
from pkmodes_derive.functions import Model
from pkmodes_derive.specialise import specialise
from pkmodes_description import FILE_NAME as DESCRIPTION
from pkmodes_description import encode

REGENERATE = "python -m pkmodes_derive generate"
#: What the names of a robot's functions without its effects have in addition.
WITHOUT_EFFECTS = "without_effects"


def parametric(mechanism: str, definition: str = "") -> dict[str, str]:
    """Build the parametric model of a mechanism: texts by file name.

    Parameters
    ----------
    mechanism : str
    definition : str
        Path of the file of a user-defined mechanism, relative to the product.
    """
    model = mechanisms.base(mechanism)
    own = mechanisms.source(mechanism)
    command = f"pkmodes generate --mechanism {pasteable(definition)} {ANY_ROBOT} --out .."
    provenance = Provenance(
        name=mechanism,
        module="model",
        title=f"Dynamics of the mechanism {mechanism}, for a robot given by its parameters.",
        origin=f"the derivation of {mechanism}",
        generator=_generator(),
        command=REGENERATE if own is None else command,
        place="" if own is None else ", run in this folder",
        identity=Identity(mechanism, pkmodes_derive.__version__),
    )
    texts, programs = write(model, provenance)
    extended_texts, extended_programs = write(
        mechanisms.extended(mechanism),
        replace(
            provenance,
            name=f"{mechanism}_extended",
            module="extended",
            title=f"Dynamics of the mechanism {mechanism} with effects: extended matrices and sensitivities.",
            origin=f"the derivation of {mechanism} and the catalogue of effects",
        ),
    )
    drawing, _ = mechanisms.drawing(mechanism)
    drawing_texts, drawing_programs = in_numpy(
        drawing,
        replace(
            provenance,
            module="drawing",
            title=f"Points and springs of the mechanism {mechanism}, with effects, for pictures of it.",
            origin=f"the derivation of {mechanism} and the catalogue of effects",
        ),
    )
    lane_texts, lane_programs = lanes.files(
        model,
        mechanisms.extended(mechanism),
        mechanisms.description(mechanism),
        replace(provenance, title=f"The mechanism {mechanism} for the compiled evaluator."),
    )
    texts |= extended_texts | drawing_texts | lane_texts
    programs |= extended_programs | drawing_programs | lane_programs
    texts[DESCRIPTION] = encode(mechanisms.description(mechanism))
    texts["__init__.py"] = (
        f'"""Generated model of the mechanism {mechanism}: see `model`."""\n\n'
        "from .model import *  # noqa: F403\n"  # relative: a user-defined mechanism may be anywhere
    )
    if own is not None:
        texts[FILE_NAME] = own
    origin = None if own is None else (definition, own)
    texts[manifest.FILE_NAME] = manifest.text(mechanism, mechanism, None, texts, programs, origin)
    return texts


def of_robot(specification: Specification) -> Model:
    """Return the model of a robot, base or with its effects, before its parameters are folded in."""
    if not specification.effects:
        base: Model = mechanisms.base(specification.mechanism)
        return base
    zeros = frozenset(
        (name, i)
        for name, value in specification.fields.items()
        for i, entry in enumerate(_flat(value))
        if entry == 0.0
    )
    single: Model = mechanisms.single(specification.mechanism, specification.effects, zeros)
    return single


def specialised(specification: Specification) -> dict[str, str]:
    """Build the model of one robot, constants folded: texts by file name."""
    model = of_robot(specification)
    values = {
        symbol.name: value
        for field in model.fields
        for symbol, value in zip(field.symbols, _flat(specification.fields[field.name]), strict=True)
    }
    name, given = specification.identifier, specification.definition
    option = f"--mechanism {pasteable(given)} " if given else ""
    own = mechanisms.source(specification.mechanism)
    described = mechanisms.description(specification.mechanism)
    provenance = Provenance(
        name=name,
        module=name,
        title=f"Dynamics of the robot {specification.name} ({specification.mechanism}), parameters folded in.",
        origin=f"the robot file of {specification.name}",
        generator=_generator(),
        command=f"pkmodes generate {option}{pasteable(specification.robot_file)} --out .",
        place=", run in this folder",
        constants=_constants(model, specification),
        identity=Identity(
            literal(specification.name, name),
            pkmodes_derive.__version__,
            limits=limits(described, specification.fields),
        ),
    )
    if specification.effects:
        beside = f"{name}_{WITHOUT_EFFECTS}"
        note = f"The same functions for the robot without its effects are in `{beside}`."
        model = replace(model, notes=(*model.notes, note))
    texts, programs = write(specialise(model, values), provenance)
    if specification.effects:
        base = mechanisms.base(specification.mechanism)
        own_texts, own_programs = write(
            specialise(base, values),
            replace(
                provenance,
                name=beside,
                module=beside,
                title=f"Dynamics of the robot {specification.name} ({specification.mechanism}) without its effects, "
                "parameters folded in.",
                constants=_constants(base, specification),
            ),
        )
        texts |= own_texts
        programs |= {f"{WITHOUT_EFFECTS}_{key}": program for key, program in own_programs.items()}
    origin = None if own is None else (given, own)
    texts[manifest.FILE_NAME] = manifest.text(
        name, specification.mechanism, specification, texts, programs, origin
    )
    return texts


def write(model: Model, provenance: Provenance) -> tuple[dict[str, str], dict[str, Program]]:
    """Write a model in every language: return the texts by file name, and the programs that all of them print."""
    programs = {function.name: arrange(function) for function in model.functions}
    in_c = c99.BACKEND.files(model, programs, provenance)
    provenance = provenance.of_source(in_c[f"{provenance.name}.c"])
    return {**numpy.BACKEND.files(model, programs, provenance), **in_c}, programs


def in_numpy(model: Model, provenance: Provenance) -> tuple[dict[str, str], dict[str, Program]]:
    """Write a model that no controller needs in NumPy only."""
    programs = {function.name: arrange(function) for function in model.functions}
    return numpy.BACKEND.files(model, programs, provenance), programs


def _constants(model: Model, specification: Specification) -> tuple[str, ...]:
    """Return the parameters of a model that are folded into the code of a robot, one line each."""
    return tuple(
        f"{field.name} [{field.unit}] = {_constant(specification.fields[field.name])}: {field.description}"
        for field in model.fields
    )


def _generator() -> str:
    return f"pkmodes_derive {pkmodes_derive.__version__} with SymPy {sympy.__version__}"


def _flat(value: object) -> list[float]:
    if isinstance(value, list | tuple):
        return [entry for item in value for entry in _flat(item)]
    return [float(value)]  # type: ignore[arg-type]


def _constant(value: object) -> str:
    if isinstance(value, list | tuple):
        return "[" + ", ".join(map(_constant, value)) + "]"
    return repr(float(value))  # type: ignore[arg-type]
