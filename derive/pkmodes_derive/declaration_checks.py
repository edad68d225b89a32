"""Checks of a declaration, before and after the derivation.

Without them most of these mistakes would fail inside the derivation, far from their cause.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from difflib import get_close_matches
from math import isfinite, prod

from sympy import Expr, Symbol, default_sort_key, expand

from pkmodes_derive.definition import DefinitionError
from pkmodes_derive.functions import Function, Model
from pkmodes_derive.machine import Machine
from pkmodes_derive.sample_robot import check_directions
from pkmodes_derive.vectors import axis, cross, placed
from pkmodes_derive.vocabulary import AXES, Field
from pkmodes_description import Margin, Requirement

RULES = ("at_least_zero", "above_zero", "at_most_limit")


def check_declared(machine: Machine) -> None:
    """Refuse a machine with missing or inconsistent parts."""
    for is_declared, what, remedy in (
        (machine.gravity, "gravity is not declared", "call m.add_gravity()"),
        (machine.coordinates, "no coordinates are declared", "declare all of them with m.generalised(...)"),
        (machine.pose, "no pose is declared", "call m.platform_pose(...) or m.independent_pose(...)"),
        (
            machine.independent,
            "no coordinate moves the platform",
            "declare which ones do: m.moves_platform(coordinates, argument, plural noun)",
        ),
        (
            len(machine.platform) == 3,
            "m.platform does not have three components",
            "write, for example, (*p, Integer(0))",
        ),
        (machine.drives, "no drive is declared", "call m.drive([(rotor, Integer(1))], inertia, torque)"),
    ):
        if not is_declared:
            raise DefinitionError(what, "", remedy)
    if len(machine.pose) != len(machine.components):
        raise DefinitionError(
            f"the pose has {len(machine.pose)} components, DIRECTIONS and ROTATIONS {len(machine.components)}",
            "",
            "give the pose one component for each direction and each rotation",
        )
    _check_coordinates(machine)
    _check_closures(machine)
    _check_levers(machine)
    _check_positions(machine)
    _check_sample(machine)
    check_directions(machine)


def _check_coordinates(machine: Machine) -> None:
    """Check that parts refer to declared coordinates and that all coordinates move with the platform."""
    for where, symbols in _coordinate_references(machine):
        for symbol in symbols:
            if symbol not in machine.coordinates:
                raise DefinitionError(
                    f"{symbol} is not a coordinate", where, "declare it with m.generalised(...)"
                )
    for q in machine.coordinates:
        if q not in machine.independent and q not in machine.follows:
            raise DefinitionError(
                f"the motion of {q} with rigid transmissions is not declared",
                f"m.follows[{q}]",
                "declare it, for example m.follows[phi[j]] = theta[j]",
            )


def _coordinate_references(machine: Machine) -> Iterator[tuple[str, Iterable[Symbol]]]:
    """Yield each place that names coordinates, with the coordinates."""
    yield "m.moves_platform", machine.independent
    yield "m.follows", machine.follows
    yield "m.arms", (arm.angle for arm in machine.arms)
    yield "m.rotor", (rotor.coordinate for rotor in machine.rotors)
    yield "m.reducers", (q for spring in machine.transmissions for q in spring.twist)
    yield "m.belt", (q for belt in machine.belts for run in belt.runs for form, _ in run.ends for q in form)


def _check_closures(machine: Machine) -> None:
    """Check that there is one link per component of the pose, each with its own independent coordinate."""
    links, expected = len(machine.links), len(machine.dependent)
    if links != expected:
        raise DefinitionError(
            f"{links} links close the loops of a platform with {expected} components",
            "m.link",
            "declare one link for each component",
        )
    if not expected:
        return
    if tuple(link.coordinate for link in machine.links) != machine.independent:
        raise DefinitionError(
            "the links do not match the independent coordinates one to one, in order",
            "m.link",
            f"declare them for {', '.join(q.name for q in machine.independent)}",
        )
    for q in machine.independent:
        if q not in machine.inverse:
            raise DefinitionError(
                f"the inverse kinematics does not give {q}",
                "m.inverse",
                f"define m.inverse[{q}] as a function of the pose",
            )


def _check_levers(machine: Machine) -> None:
    """Check that each link of a platform that turns has its joint on it, with which its vector turns."""
    turning = machine.turning
    if turning is None:
        return
    for number, link in enumerate(machine.links, start=1):
        where = f"m.link, link {number}"
        if not link.lever:
            raise DefinitionError(
                "a link to a platform that turns has no lever",
                where,
                "name its joint with lever = m.fixed_in_platform(names, joint), and write m.link(..., lever)",
            )
        lever = placed(machine.directions, link.lever)
        if len(link.lever) != len(machine.directions) or lever not in turning.fixed:
            raise DefinitionError(
                "the lever of a link is not a vector that is fixed in the platform",
                where,
                "give the names that m.fixed_in_platform returned for its joint",
            )
        for small, name in zip(turning.small, turning.axes, strict=True):
            expected_rate = cross(axis(name), lever)
            for component, direction in zip(link.vector, machine.directions, strict=True):
                if (
                    expand(machine.chain.derivative(component, small) - expected_rate[AXES.index(direction)])
                    != 0
                ):
                    raise DefinitionError(
                        "the vector of a link does not turn with its lever",
                        where,
                        "define it as position of the platform + lever - joint on the other side",
                    )


def _check_positions(machine: Machine) -> None:
    """Check that bodies are in space, also those of a machine in a plane, and that legs change their length."""
    positions = [("m.points", point.position) for point in machine.points]
    positions += [("m.rods", end) for rod in machine.rods for end in rod.ends]
    positions += [("m.arms", arm.centre) for arm in machine.arms]
    positions += [("m.leg", end) for leg in machine.legs for end in leg.ends]
    for where, position in positions:
        if len(position) != 3:
            what = f"a position has {len(position)} components, expected 3"
            raise DefinitionError(what, where, "write 0 for each missing one, for example (*p, 0)")
    for leg in machine.legs:
        if leg.link.rigid:
            what = f"the link of the leg along {leg.link.vector[0]}, ... is rigid"
            raise DefinitionError(
                what, "m.leg", "write m.link(vector, l, l, ...), with the leg's length l twice"
            )


def _check_sample(machine: Machine) -> None:
    """Check that the sample robot has a finite number for every entry of every parameter."""
    fields = {field.name: field for field in machine.tables.fields}
    for name, field in fields.items():
        if name not in machine.sample:
            raise DefinitionError(
                f"there is no value for {name}", "m.sample", f"add {_describe_shape(field)}, in {field.unit}"
            )
        if _shape(machine.sample[name]) != field.shape:
            raise DefinitionError(
                f"the value of {name} has the wrong shape, or is not finite",
                "m.sample",
                f"write {_describe_shape(field)}, in {field.unit}",
            )
    for name in machine.sample:
        if name not in fields:
            known = ", ".join(fields)
            raise DefinitionError(f"there is no parameter {name}", "m.sample", f"use one of {known}")


def _shape(value: object) -> tuple[int, ...] | None:
    if not isinstance(value, list | tuple):
        return () if isinstance(value, int | float) and isfinite(value) else None
    entry_shapes = {_shape(entry) for entry in value}
    entry_shape = entry_shapes.pop() if len(entry_shapes) == 1 else None
    return None if entry_shape is None else (len(value), *entry_shape)


def _describe_shape(field: Field) -> str:
    return f"numbers of shape {field.shape}" if field.shape else "one number"


def check_model(machine: Machine, model: Model) -> None:
    """Refuse a model with undefined values, or whose margins or requirements refer to missing results."""
    functions = {function.name: function for function in model.functions}
    for margin in machine.margins:
        _check_margin(margin, functions)
    for requirement in machine.requirements:
        _check_requirement(requirement, functions)
    parameters = {symbol for field in model.fields for symbol in field.symbols}
    for function in model.functions:
        given = {symbol for argument in function.arguments for symbol in argument.symbols}
        for symbol in _undefined_symbols(function):
            if symbol not in parameters | given:
                raise DefinitionError(
                    f"{symbol} is used in {function.name} but not defined",
                    f"{symbol}: {machine.vocabulary[symbol].description}",
                    "define it with m.define or m.inverse, or use a parameter of the robot file",
                )
    masses = functions["modal_matrices"].outputs[0]
    for i, (name, _) in enumerate(model.coordinates):
        if masses.entries[i * (masses.shape[1] + 1)] == 0:
            raise DefinitionError(
                f"the coordinate {name} has no inertia", name, "add a body or a rotor that moves with it"
            )


def check_names(machine: Machine, model: Model) -> None:
    """Refuse a symbol with the name of an argument or a result: generated code would declare it twice."""
    owners = {group.argument: f"the argument {group.argument}" for group in model.groups}
    for function in model.functions:
        names = [argument.name for argument in function.arguments if not argument.scalar]
        for name in (*names, *(output.name for output in function.outputs)):
            owners.setdefault(name, f"an argument or a result of {function.name}")
    for q in machine.vocabulary:
        if q.symbol.name in owners:
            raise DefinitionError(
                f"the symbol {q.symbol} has the name of {owners[q.symbol.name]}",
                f"{q.symbol}: {q.description}",
                f"rename it, for example {q.symbol}_0",
            )


def _undefined_symbols(function: Function) -> list[Symbol]:
    """Return the symbols that a function uses and its definitions do not give, in the order of use."""
    undefined: list[Symbol] = []
    visited: set[Symbol] = set()

    def visit(expression: Expr, path: tuple[Symbol, ...]) -> None:
        for symbol in _symbols(expression):
            if symbol in path:
                cycle = " -> ".join(s.name for s in (*path[path.index(symbol) :], symbol))
                raise DefinitionError(f"definitions are circular: {cycle}", "m.inverse", "break the cycle")
            if symbol not in visited:
                if symbol in function.definitions:
                    visit(function.definitions[symbol], (*path, symbol))
                else:
                    undefined.append(symbol)
                visited.add(symbol)

    for output in function.outputs:
        for entry in output.entries:
            visit(entry, ())
    return undefined


def _symbols(expression: Expr) -> list[Symbol]:
    return sorted(expression.free_symbols, key=default_sort_key)


def _check_margin(margin: Margin, functions: dict[str, Function]) -> None:
    where = f'm.margins, "{margin.code}"'
    function = _function(margin.function, functions, where)
    if not 0 <= margin.output < len(function.outputs):
        raise DefinitionError(
            f"{margin.function} has no result {margin.output}",
            where,
            f"it has {len(function.outputs)}, counted from 0",
        )
    if margin.rule not in RULES:
        raise DefinitionError(f'unknown rule "{margin.rule}"', where, f"write one of {', '.join(RULES)}")
    shape, names_shape = function.outputs[margin.output].shape, tuple(len(names) for names in margin.names)
    if shape != names_shape:
        raise DefinitionError(
            f"the names have shape {names_shape}, the result of {margin.function} has shape {shape}",
            where,
            "give a name for each index along each axis of the result",
        )
    _check_sentence(
        margin.sentence, dict.fromkeys(("missing", "short", "value"), ""), len(names_shape), where
    )


def _check_requirement(requirement: Requirement, functions: dict[str, Function]) -> None:
    where = f'm.requirements, "{requirement.function}"'
    function = _function(requirement.function, functions, where)
    if function.arguments:
        raise DefinitionError(
            f"{requirement.function} takes a pose, but a requirement depends on the robot alone",
            where,
            "declare that function with arguments=()",
        )
    places = prod(function.outputs[0].shape)
    if places != len(requirement.places):
        raise DefinitionError(
            f"{len(requirement.places)} places for {places} entries of {requirement.function}",
            where,
            "give one path of the robot file for each entry",
        )


def _function(name: str, functions: dict[str, Function], where: str) -> Function:
    if name not in functions:
        matches = get_close_matches(name, functions, n=1)
        remedy = f'did you mean "{matches[0]}"?' if matches else f"use one of {', '.join(functions)}"
        raise DefinitionError(f'there is no function "{name}"', where, remedy)
    return functions[name]


def _check_sentence(sentence: str, words: dict[str, str], places: int, where: str) -> None:
    try:
        sentence.format(*["" for _ in range(places)], **words)
    except (LookupError, ValueError):
        holes = [f"{{{hole}}}" for hole in (*range(places), *words)]
        raise DefinitionError(
            f'the sentence "{sentence}" cannot be formatted', where, f"use only {', '.join(holes)}"
        ) from None
