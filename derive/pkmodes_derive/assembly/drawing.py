"""The functions of a drawing: points and their exact motion with every coordinate, and the springs between them.

Points of the same body move alike, so each different motion is written once; the description has the index of the
motion of each point.  The first point is the centre of the platform.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from sympy import Expr, Integer, Symbol

from pkmodes_derive.assembly.derived import Derived, derive, flattened
from pkmodes_derive.assembly.springs import Spring, springs
from pkmodes_derive.drawing import Element, Point, from_parts
from pkmodes_derive.functions import Argument, FieldGroup, Function, Model, Output
from pkmodes_derive.machine import Machine
from pkmodes_derive.terms.places import places
from pkmodes_derive.vectors import placed
from pkmodes_derive.vocabulary import AXES, DeclarationError
from pkmodes_description import Drawing as DescribedDrawing
from pkmodes_description import Element as DescribedElement

Motion = tuple[Expr, ...]


def drawing(machine: Machine) -> tuple[Model, DescribedDrawing]:
    """Return the model and the description of a drawing; `machine` has every effect that applies."""
    d = derive(machine)
    elements = machine.draw.elements or from_parts(
        machine.vocabulary,
        machine.points,
        machine.rods,
        machine.arms,
        machine.legs,
        machine.bodies,
        machine.platform,
        _joints(machine),
    )
    points = list(dict.fromkeys([Point(machine.platform), *(p for one in elements for p in one.points)]))
    motion_of_points = [_motion(d, point) for point in points]
    motions = list(dict.fromkeys(motion_of_points))
    all_springs = springs(d)
    bodies = {place.words.removeprefix("the "): name for name, place in places(machine).items()}
    data = DescribedDrawing(
        tuple(motions.index(motion) for motion in motion_of_points),
        tuple(_described_element(element, points, all_springs, bodies) for element in elements),
        tuple(spring.named for spring in all_springs),
        len(machine.draw.uprights),
    )
    return _model(d, points, motions, all_springs), data


def _joints(machine: Machine) -> list[Motion]:
    """Return the positions of the joints on a platform that turns."""
    levers = (placed(machine.directions, link.lever) for link in machine.links if link.lever)
    return [tuple(p + b for p, b in zip(machine.platform, lever, strict=True)) for lever in levers]


def _motion(d: Derived, point: Point) -> Motion:
    """Return the derivatives of a point with respect to every coordinate, component by component."""
    machine, kin = d.machine, d.kin
    coordinates = machine.all_coordinates
    rows = []
    for i, axis in enumerate(AXES):
        row = {q: kin.chain.derivative(point.position[i], q) for q in kin.independent}
        for c in point.clamp.released if point.clamp else ():
            row[c.position] = point.along[i]
        for direction, released in zip(machine.directions, machine.frame, strict=True):
            for c in released if direction == axis else ():
                row[c.position] = Integer(1)
        rows += [row.get(q, Integer(0)).xreplace(kin.reference) for q in coordinates]
    return tuple(rows)


def _described_element(
    element: Element, points: Sequence[Point], all_springs: Sequence[Spring], bodies: Mapping[str, str]
) -> DescribedElement:
    spring = next(
        (i for i, s in enumerate(all_springs) if s.part is not None and s.part is element.spring), -1
    )
    return DescribedElement(
        element.shape,
        element.kind,
        element.name,
        tuple(points.index(point) for point in element.points),
        spring,
        "" if element.turns is None else element.turns.name,
        element.place or bodies.get(element.name, ""),
    )


def _model(
    d: Derived, points: Sequence[Point], motions: Sequence[Motion], all_springs: Sequence[Spring]
) -> Model:
    machine, v = d.machine, d.machine.vocabulary
    n, uprights = len(machine.all_coordinates), machine.draw.uprights
    _check_names(machine)
    up = Argument(
        "up",
        flattened([u.symbols for u in uprights]),
        "1",
        "unit vectors that the robot leaves open, one after another",
    )
    arguments = (d.pose, up) if uprights else (d.pose,)
    functions = [
        _function(
            d,
            "drawing_points",
            "Positions of the points of a drawing.",
            "the positions that the mechanism declares, or those of its parts",
            arguments,
            Output(
                "r",
                (len(points), 3),
                flattened([[x.xreplace(d.kin.reference) for x in p.position] for p in points]),
                "m",
                "base frame; first the platform",
            ),
        ),
        _function(
            d,
            "drawing_motion",
            "Jacobians of these points with respect to every coordinate, one for points that move alike.",
            "the positions differentiated, with the contributions of released joints and the frame",
            arguments,
            Output("J", (len(motions), 3, n), flattened(motions), "1, m", "dr_i/dq_k, base frame"),
        ),
        _function(
            d,
            "springs",
            "Stiffness of every spring, and its elongation or twist per unit of each coordinate.",
            "equation 38 with the effects' energies; the springs of released joints are not among them",
            (d.pose,),
            Output(
                "k", (len(all_springs),), tuple(s.stiffness for s in all_springs), "N/m, N m/rad", "stiffness"
            ),
            Output(
                "g",
                (len(all_springs), n),
                flattened([s.strain for s in all_springs]),
                "1, m, 1/m",
                "the energy is the sum of k (g . q)^2 / 2",
            ),
        ),
    ]
    functions.append(_driven_function(machine))
    if uprights:
        directions = flattened([entry for u in uprights for entry in (u.direction, u.place)])
        functions.append(
            _function(
                d,
                "drawing_directions",
                "Directions to which the unit vectors `up` of a drawing must be perpendicular.",
                "the directions that the mechanism declares",
                (d.pose,),
                Output(
                    "e",
                    (len(uprights), 2, 3),
                    directions,
                    "1, m",
                    "a unit vector, and the point where it is used",
                ),
            )
        )
    return Model(
        mechanism=machine.name,
        coordinates=tuple((q.name, v[q].unit) for q in machine.all_coordinates),
        vocabulary=v,
        groups=(
            FieldGroup("Parameters", "parameters", tuple(machine.tables.fields), declared=False),
            FieldGroup("Effects", "effects", machine.effect_fields, null=0.0, declared=False),
        ),
        functions=tuple(functions),
    )


def _driven_function(machine: Machine) -> Function:
    """Return the function that tells which rotors have a motor: the robot may choose among several."""
    share: dict[Symbol, Expr] = dict.fromkeys(machine.coordinates, Integer(0))
    for drive in machine.drives:
        for rotor, factor in drive.rotors:
            share[rotor.coordinate] += factor
    output = Output(
        "d", (machine.base,), tuple(share.values()), "1", "1 where a motor turns the coordinate, else 0"
    )
    what = "Which coordinates are rotations of a rotor that a motor drives."
    return Function("driven", what, "the drives that the mechanism declares", (), (output,), {}, in_c=False)


def _check_names(machine: Machine) -> None:
    """Refuse a symbol with the name of the unit vectors that a drawing leaves open, or of their argument."""
    reserved = {"up", *(symbol.name for upright in machine.draw.uprights for symbol in upright.symbols)}
    for quantity in machine.vocabulary if machine.draw.uprights else ():
        if quantity.symbol.name in reserved:
            what = f"the symbol {quantity.symbol} has the name of an open direction of the drawing"
            raise DeclarationError(what, f"rename it, for example {quantity.symbol}_0")


def _function(
    d: Derived, name: str, summary: str, source: str, arguments: tuple[Argument, ...], *outputs: Output
) -> Function:
    return Function(name, summary, source, arguments, outputs, d.kin.definitions, in_c=False)
