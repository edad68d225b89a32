"""The two products: the parametric model of a mechanism, and a model specialised to one robot.

A product is a set of texts by file name, including its manifest; it is built in memory and is a pure
function of the derivation, the templates and the specification.  Writing and comparing are done elsewhere.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import sympy

import pkmodes_derive
from pkmodes_derive import mechanisms
from pkmodes_derive.definition import FILE_NAME
from pkmodes_derive.effect_file import file_name
from pkmodes_derive.emit import manifest
from pkmodes_derive.emit.identity import Identity, limits, literal
from pkmodes_derive.emit.program import Program, arrange
from pkmodes_derive.emit.provenance import ANY_ROBOT, Provenance, pasteable
from pkmodes_derive.emit.registry import BACKENDS
from pkmodes_derive.emit.specification import Specification
from pkmodes_derive.functions import Function, Model
from pkmodes_derive.kept import derive_once, digest_of, has_folder
from pkmodes_derive.specialise import specialise
from pkmodes_description import FILE_NAME as DESCRIPTION
from pkmodes_description import encode

REGENERATE = "python -m pkmodes_derive generate"
#: Suffix of the module, and prefix of the programs, of a robot without its effects.
WITHOUT_EFFECTS = "without_effects"


def parametric(mechanism: str, definition: str = "", effects: Sequence[str] = ()) -> dict[str, str]:
    """Build the parametric model of a mechanism: texts by file name.

    Parameters
    ----------
    definition : str
        Path of the file of a user-defined mechanism, relative to the product.
    effects : sequence of str
        Paths of the files of its effects of one's own, in their order, relative to the product.
    """
    inputs = mechanism, definition, tuple(effects), mechanisms.origin(mechanism)
    return derive_once("parametric", inputs, lambda: _parametric(mechanism, definition, effects))


def _parametric(mechanism: str, definition: str, effects: Sequence[str]) -> dict[str, str]:
    model, extended = mechanisms.base(mechanism), mechanisms.extended(mechanism)
    definition_text, effect_files = mechanisms.source(mechanism), mechanisms.own_effects(mechanism)
    options = [f"--mechanism {pasteable(definition)}"] if definition_text is not None else []
    options += [f"--effect {pasteable(path)}" for path in effects]
    command = " ".join(["pkmodes generate", *options, ANY_ROBOT, "--out .."])
    provenance = Provenance(
        name=mechanism,
        module="model",
        title=f"Dynamics of the mechanism {mechanism}, for a robot given by its parameters.",
        origin=f"the derivation of {mechanism}",
        generator=_generator(),
        command=command if options else REGENERATE,
        place=", run in this folder" if options else "",
        identity=Identity(mechanism, pkmodes_derive.__version__),
    )
    origin_with_effects = f"the derivation of {mechanism} and the catalogue of effects"
    (drawing, _), (terms, _) = mechanisms.drawing(mechanism), mechanisms.terms_beyond_catalogue(mechanism)
    texts, programs = write_models(
        (model, provenance),
        (
            extended,
            replace(
                provenance,
                name=f"{mechanism}_extended",
                module="extended",
                title=f"Dynamics of the mechanism {mechanism} with effects: extended matrices and sensitivities.",
                origin=origin_with_effects,
            ),
        ),
        (
            drawing,
            replace(
                provenance,
                module="drawing",
                title=f"Points and springs of the mechanism {mechanism}, with effects, for pictures of it.",
                origin=origin_with_effects,
            ),
        ),
        (
            terms,
            replace(
                provenance,
                module="terms",
                title=f"Terms of the mechanism {mechanism}: motion of its bodies, and what holds them yielding.",
                origin=origin_with_effects,
            ),
        ),
    )
    description = mechanisms.description(mechanism)
    header_provenance = replace(provenance, title=f"The mechanism {mechanism} for the compiled evaluator.")
    for backend in BACKENDS:
        more_texts, more_programs = backend.mechanism(model, extended, description, header_provenance)
        texts |= more_texts
        programs |= more_programs
    texts[DESCRIPTION] = encode(description)
    texts["__init__.py"] = (
        f'"""Generated model of the mechanism {mechanism}: see `model`."""\n\n'
        "from .model import *  # noqa: F403\n"  # relative: a user-defined mechanism may be anywhere
    )
    if definition_text is not None:
        texts[FILE_NAME] = definition_text
    texts |= {file_name(effect): text for text, effect in effect_files}
    origin = None if definition_text is None else (definition, definition_text)
    effect_copies = {
        path: (file_name(effect), text) for path, (text, effect) in zip(effects, effect_files, strict=True)
    }
    texts[manifest.FILE_NAME] = manifest.text(
        mechanism, mechanism, None, texts, programs, origin, effect_copies
    )
    return texts


def of_robot(specification: Specification) -> Model:
    """Return the model of a robot, base or with its effects, before its parameters are folded in."""
    name, zeros = specification.mechanism, _zeros(specification)
    has_no_effects = not specification.effects
    model: Model = (
        mechanisms.base(name) if has_no_effects else mechanisms.single(name, specification.effects, zeros)
    )
    held = mechanisms.held(name, specification.effects, zeros, specification.springs)
    held = replace(held, ratio=specification.damping_ratio)
    return replace(model, functions=(*model.functions, *held.functions), held=held)


def _zeros(specification: Specification) -> frozenset[tuple[str, int]]:
    """Return the field and the index of every parameter that is zero for a robot."""
    return frozenset(
        (name, i)
        for name, value in specification.fields.items()
        for i, entry in enumerate(_flat(value))
        if entry == 0.0
    )


def specialised(specification: Specification) -> dict[str, str]:
    """Build the model of one robot, constants folded: texts by file name."""
    inputs = specification, mechanisms.origin(specification.mechanism)
    return derive_once("specialised", inputs, lambda: _specialised(specification))


def _specialised(specification: Specification) -> dict[str, str]:
    model = of_robot(specification)
    name, definition = specification.identifier, specification.definition
    option = f"--mechanism {pasteable(definition)} " if definition else ""
    definition_text = mechanisms.source(specification.mechanism)
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
            limits=limits(mechanisms.machine(specification.mechanism), specification.fields),
        ),
    )
    if specification.effects:
        bare_name = f"{name}_{WITHOUT_EFFECTS}"
        note = f"The same functions for the robot without its effects are in `{bare_name}`."
        model = replace(model, notes=(*model.notes, note))
    texts, programs = write_models((specialise(model, _values(model, specification)), provenance))
    if specification.effects:
        title = (
            f"Dynamics of the robot {specification.name} ({specification.mechanism}) without its effects, "
            "parameters folded in."
        )
        bare_texts, bare_programs = _without_effects(
            specification, replace(provenance, name=bare_name, module=bare_name, title=title)
        )
        texts |= bare_texts
        programs |= {f"{WITHOUT_EFFECTS}_{key}": program for key, program in bare_programs.items()}
    origin = (definition, definition_text) if definition or definition_text is not None else None
    effect_files = mechanisms.own_effects(specification.mechanism)
    effect_copies = {
        f"{definition}/{file_name(effect)}": (file_name(effect), text) for text, effect in effect_files
    }
    texts[manifest.FILE_NAME] = manifest.text(
        name, specification.mechanism, specification, texts, programs, origin, effect_copies
    )
    return texts


def _without_effects(
    specification: Specification, provenance: Provenance
) -> tuple[dict[str, str], dict[str, Program]]:
    """Write the model of a robot without its effects; it does not depend on them."""
    fields = {field.name for field in mechanisms.base(specification.mechanism).fields}
    bare = replace(
        specification,
        fields={name: value for name, value in specification.fields.items() if name in fields},
        values={},
        effects=(),
        springs="",
    )

    def write() -> tuple[dict[str, str], dict[str, Program]]:
        model = of_robot(bare)
        own = replace(provenance, constants=_constants(model, bare))
        return write_models((specialise(model, _values(model, bare)), own))

    inputs = bare, replace(provenance, constants=()), mechanisms.origin(bare.mechanism)
    return derive_once("without_effects", inputs, write)


def _values(model: Model, specification: Specification) -> dict[str, float]:
    """Return the value of every parameter symbol by name."""
    return {
        symbol.name: value
        for field in model.fields
        for symbol, value in zip(field.symbols, _flat(specification.fields[field.name]), strict=True)
    }


def write_models(*models: tuple[Model, Provenance]) -> tuple[dict[str, str], dict[str, Program]]:
    """Write models in every language: return the texts by file name, and the programs that all of them print."""
    texts: dict[str, str] = {}
    programs: dict[str, Program] = {}
    for model, provenance in models:
        model_programs = arrange_functions(model.functions)
        by_backend: dict[str, Mapping[str, str]] = {}
        # First the language whose source identifies the model, because the others state its digest.
        for backend in sorted(BACKENDS, key=lambda backend: not backend.source):
            files = by_backend[backend.name] = backend.model(model, model_programs, provenance)
            if backend.source and files:
                provenance = provenance.of_source(files[f"{provenance.name}{backend.source}"])
        for backend in BACKENDS:
            texts |= by_backend[backend.name]
        programs |= model_programs
    return texts, programs


def arrange_functions(functions: Sequence[Function]) -> dict[str, Program]:
    """Return the program of each function by name."""

    def arrange_all() -> dict[str, Program]:
        return {function.name: arrange(function) for function in functions}

    return derive_once("programs", digest_of(functions), arrange_all) if has_folder() else arrange_all()


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
