r"""Forms of terms as effects: a mass, a spring, a mount that yields, a resonator, each at one place.

With v the velocity of a place, :math:`\delta` its small displacement and e a direction, they add

.. math::
    T = \tfrac12 m v \cdot v - m\, g \cdot r, \qquad
    V = \tfrac12 k\, \delta^2, \qquad
    V = \frac{w^2}{2 c}, \qquad
    T = \tfrac12 m (v + e \dot y)^2, \quad V = \tfrac12 m (2 \pi f)^2 y^2,

a mass with its weight, a spring that is relaxed at the pose, a released displacement w of the bearing, with which
the body and what is fastened to it moves, and a mass on a spring of its own, which follows its body in all other
directions.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any

from sympy import Dummy, Expr, Integer, Rational, Symbol, pi

from pkmodes_derive.effect import COMPLIANCE, Coordinate, Effect, EffectParameter, Positive, Released
from pkmodes_derive.effects import catalogue
from pkmodes_derive.machine import Machine
from pkmodes_derive.parts import Arm, LegPart, PlacedSpring, PointMass, Rod, Rotor
from pkmodes_derive.terms.places import FRAME, PLATFORM, Place, places, strained_directions
from pkmodes_derive.vectors import axis, dot
from pkmodes_derive.vocabulary import AXES, DeclarationError

HALF = Rational(1, 2)
#: Coordinates of terms follow those of the catalogue.
ORDER = 10
#: Condition on a resonator: without a frequency, nothing would hold its mass.
FREQUENCY_REQUIREMENT = Positive(
    lambda parameters: parameters["frequency"],
    "frequency",
    "expected the natural frequency of the resonator above 0, found {value}",
    "declare frequency, such as 50 Hz, beside the mass, or remove the table",
    "Hz",
)


def mass(place: str, *, name: str = "", sentence: str = "") -> Effect:
    """Return the effect of an extra mass at a body, with its weight; of a body that rotates, of extra inertia.

    Parameters
    ----------
    place : str
        Such as "carriage_2".
    name : str, optional
        Of the effect in robot files, by default "mass_carriage_2".
    sentence : str, optional
        What it means for the machine.
    """

    def apply(machine: Machine, parameters: Mapping[str, Symbol], released: Sequence[Coordinate]) -> None:
        _add_mass(machine, _find_place(machine, place), *parameters.values())

    def parameters(machine: Machine) -> tuple[EffectParameter, ...]:
        return (_inertia_parameter(_find_place(machine, place), "extra"),)

    return _effect(name or f"mass_{place}", sentence, (place,), parameters, apply)


def spring(place: str, other: str = "", along: str = "", *, name: str = "", sentence: str = "") -> Effect:
    """Return the effect of a spring from a body to ground, or between two bodies, relaxed at the pose.

    Parameters
    ----------
    place, other : str
        Such as "pulley_2_1" and "pulley_2_2"; without the second one to ground.
    along : str, optional
        "x", "y", "z", or "rx", "ry", "rz" of a platform that turns; without it isotropic, or along the one freedom of
        the bodies.
    name, sentence : str, optional
        As for `mass`.
    """
    ends = (place, other) if other else (place,)

    def apply(machine: Machine, parameters: Mapping[str, Symbol], released: Sequence[Coordinate]) -> None:
        bodies = tuple(_find_place(machine, end) for end in ends)
        directions = (along,) if along else strained_directions(bodies)
        machine.springs.append(PlacedSpring(parameters["stiffness"], bodies, directions))

    def parameters(machine: Machine) -> tuple[EffectParameter, ...]:
        turns = along.startswith("r") or _find_place(machine, place).rotates
        between = " and ".join(_find_place(machine, end).words for end in ends)
        what = f"stiffness between {between}" if other else f"stiffness from {between} to ground"
        return (EffectParameter("stiffness", "N m/rad" if turns else "N/m", what, "k_X", "k_X"),)

    effect_name = name or "_".join(["spring", *ends, *([along] if along else [])])
    return _effect(effect_name, sentence, ends, parameters, apply, grounds=not other, along=along)


def mount(place: str, along: str = "", *, name: str = "", sentence: str = "") -> Effect:
    """Return the effect of a bearing, a rail or a base joint that yields, with the body that it holds.

    Parameters
    ----------
    place : str
        A pulley, which moves along its belt, or a body on a rail or base joint.
    along : str, optional
        "x", "y" or "z"; none for a pulley.
    name, sentence : str, optional
        As for `mass`.
    """

    def apply(machine: Machine, parameters: Mapping[str, Symbol], released: Sequence[Coordinate]) -> None:
        body, (w,) = _find_place(machine, place), released
        if isinstance(body.part, Rotor):
            _yield_bearing(machine, body.part, w, parameters["mass"])
        else:
            _yield_seat(machine, body, w, axis(along))

    def parameters(machine: Machine) -> tuple[EffectParameter, ...]:
        body = _find_place(machine, place)
        compliance_of_seat = EffectParameter(
            COMPLIANCE, "m/N", f"compliance of what holds {body.words}", "c_X", "c_X"
        )
        if not isinstance(body.part, Rotor):
            return (compliance_of_seat,)
        what = f"mass that moves with the bearing of {body.words}"
        return compliance_of_seat, EffectParameter("mass", "kg", what, "m_X", "m_X")

    effect_name = name or "_".join(["mount", place, *([along] if along else [])])
    coordinate = Released(f"w_{place}{along}", "m", f"displacement of what holds {place}", "w", order=ORDER)
    return _effect(effect_name, sentence, (place,), parameters, apply, released=coordinate, along=along)


def compliance(coordinate: str, *, name: str = "", sentence: str = "") -> Effect:
    """Return the effect of one released joint of the catalogue alone.

    Parameters
    ----------
    coordinate : str
        Such as "eps_2", the displacement of the clamp of belt 2.
    name, sentence : str, optional
        As for `mass`.
    """

    def find_effect(machine: Machine) -> tuple[Effect, int]:
        for effect in (one.on(machine) for one in catalogue() if one.released is not None):
            names = [effect.released.name.format(i=p, j=p) for p in effect.places] if effect.released else []
            if coordinate in names and effect.parts(machine):
                return effect, names.index(coordinate)
        raise DeclarationError(
            f"no effect releases {coordinate}", "name a coordinate of the catalogue's effects"
        )

    def apply(machine: Machine, parameters: Mapping[str, Symbol], released: Sequence[Coordinate]) -> None:
        effect, index = find_effect(machine)
        # The others are released as well, and locked again.
        others = [Coordinate(Dummy("locked"), Dummy("locked")) for _ in effect.places]
        coordinates = [released[0] if k == index else other for k, other in enumerate(others)]
        symbols = {p.name: Dummy(p.name) for p in effect.parameters} | dict(parameters)
        effect.apply(machine, symbols, tuple(coordinates))
        locked = [other for k, other in enumerate(others) if k != index]
        for joints in _released_lists(machine):
            joints[:] = [joint for joint in joints if joint not in locked]

    def parameters(machine: Machine) -> tuple[EffectParameter, ...]:
        effect, _ = find_effect(machine)
        (own,) = (p for p in effect.parameters if p.name == COMPLIANCE)
        what = f"compliance of {coordinate} alone"
        return (replace(own, description=what, symbol="c_X", latex="c_X"),)

    def parts(machine: Machine) -> Sequence[object]:
        try:
            effect, own = find_effect(machine)
        except DeclarationError:
            return []
        return [effect.places[own]]

    effect_name = name or f"compliance_{coordinate}"
    stem = coordinate.rpartition("_")[0]
    units = {one.released.name.rpartition("_")[0]: one.released.unit for one in catalogue() if one.released}
    coordinate_released = Released(
        f"w_{coordinate}", units.get(stem, "m"), f"{coordinate} alone", "w", order=ORDER
    )
    effect_of_joint = _effect(effect_name, sentence, (), parameters, apply, released=coordinate_released)
    return replace(effect_of_joint, parts=parts)


def _released_lists(machine: Machine) -> list[list[Coordinate]]:
    """Return the lists of released coordinates of all parts."""
    clamps = [belt.clamp for belt in machine.belts if belt.clamp is not None]
    return [
        *(link.elongation for link in machine.links),
        *(clamp.released for clamp in clamps),
        *(drive.wind_up for drive in machine.drives),
        *machine.frame,
        *([machine.beam.released] if machine.beam else []),
    ]


def resonator(place: str, along: str = "", *, name: str = "", sentence: str = "") -> Effect:
    """Return the effect of a mass on a spring of its own that hangs on a body and adds a mode.

    Parameters
    ----------
    place : str
        Such as "platform".
    along : str, optional
        "x", "y" or "z", in which it swings; none for a body with one freedom.
    name, sentence : str, optional
        As for `mass`.
    """

    def apply(machine: Machine, parameters: Mapping[str, Symbol], released: Sequence[Coordinate]) -> None:
        body, (y,) = _find_place(machine, place), released
        m, f = parameters.values()
        machine.add_elastic(HALF * m * (2 * pi * f) ** 2 * y.position**2)
        if body.coordinate is not None:
            rate = machine.velocities[machine.coordinates.index(body.coordinate)]
            machine.add_kinetic(HALF * m * (rate + y.rate) ** 2)
            return
        machine.swinging.append(y)
        direction = body.along or axis(along)
        position = tuple(r + y.position * e for r, e in zip(body.position or _zero(), direction, strict=True))
        machine.loads.append(PointMass(m, position))

    def parameters(machine: Machine) -> tuple[EffectParameter, ...]:
        body = _find_place(machine, place)
        f = EffectParameter("frequency", "Hz", "its natural frequency with the body at rest", "f_X", "f_X")
        return _inertia_parameter(body, "swinging"), f

    effect_name = name or "_".join(["resonator", place, *([along] if along else [])])
    coordinate = Released(
        f"y_{place}{along}", "m", f"displacement relative to {place}", "y", order=ORDER, sprung=False
    )
    effect_without_condition = _effect(
        effect_name, sentence, (place,), parameters, apply, released=coordinate, along=along
    )
    return replace(effect_without_condition, needs=FREQUENCY_REQUIREMENT)


def _effect(
    name: str,
    sentence: str,
    ends: tuple[str, ...],
    parameters: Callable[[Machine], tuple[EffectParameter, ...]],
    apply: Callable[[Any, Mapping[str, Symbol], tuple[Coordinate, ...]], None],
    *,
    released: Released | None = None,
    grounds: bool = False,
    along: str = "",
) -> Effect:
    """Return an effect that applies where a machine has its places, which can move that way."""

    def parts(machine: Machine) -> list[Place]:
        place_of = places(machine)
        if any(end not in place_of for end in ends):
            return []
        bodies = [place_of[end] for end in ends]
        return bodies[:1] if not along or any(along in body.directions for body in bodies) or released else []

    return Effect(
        name=name,
        sentence=sentence or name.replace("_", " "),
        parts=parts,
        parameters=(),
        parameters_on=lambda machine: tuple(
            replace(p, symbol=f"{p.symbol}_{name}") for p in parameters(machine)
        ),
        apply=apply,
        released=released,
        grounds=grounds,
    )


def _find_place(machine: Machine, name: str) -> Place:
    place_of = places(machine)
    if name not in place_of:
        raise DeclarationError(
            f"the machine has no place {name}", f"its places are {', '.join(place_of)}: choose one of these"
        )
    return place_of[name]


def _inertia_parameter(place: Place, kind: str) -> EffectParameter:
    """Return the mass or moment of inertia that a term has at a place."""
    if place.rotates:
        what = f"{kind} moment of inertia at {place.words}"
        return EffectParameter("inertia", "kg m^2", what, "I_X", "I_X")
    return EffectParameter("mass", "kg", f"{kind} mass at {place.words}", "m_X", "m_X")


def _add_mass(machine: Machine, place: Place, m: Symbol) -> None:
    """Add to the mass of a body, or to the moment of inertia of one that rotates."""
    part = place.part
    if isinstance(part, Rod | PointMass):
        part.mass += m
    elif isinstance(part, Arm | Rotor):
        part.inertia += m
    elif place.name == FRAME:
        rate = machine.frame_rate
        machine.add_kinetic(HALF * m * dot(rate, rate))
    else:
        assert place.name == PLATFORM or isinstance(part, LegPart)
        machine.loads.append(PointMass(m, place.position))


def _yield_bearing(machine: Machine, rotor: Rotor, w: Coordinate, m: Symbol) -> None:
    """Displace the bearing of a pulley, with a mass that otherwise counts as the frame's."""
    rotor.bearing.released.append(w)
    along = rotor.along or _zero()
    machine.add_kinetic(m * (HALF * w.rate**2 + w.rate * dot(along, machine.frame_rate)))


def _yield_seat(machine: Machine, body: Place, w: Coordinate, direction: Sequence[Expr]) -> None:
    """Displace what holds a body, with the start of its link; a belt follows a carriage along its rail."""
    seat = body.seat
    assert seat is not None
    machine.yielding.append(w)
    if body.along:
        (q,) = (s for s in machine.independent if any(r.has(s) for r in body.position))
        machine.along_rails.setdefault(q, []).append((w, dot(body.along, direction)))
    components = [AXES.index(name) for name in machine.directions]
    for symbol, i in zip(seat.link.vector, components, strict=True):
        if direction[i] != 0:
            new_definition = machine.chain.definitions[symbol] - w.position * direction[i]
            machine.chain.redefine(symbol, new_definition)

    def shifted(position: Sequence[Expr]) -> tuple[Expr, ...]:
        return tuple(r + w.position * e for r, e in zip(position, direction, strict=True))

    for point in seat.points:
        point.position = shifted(point.position)
    for rod, end in seat.ends:
        start, finish = rod.ends
        rod.ends = (shifted(start), finish) if end == 0 else (start, shifted(finish))
    for arm in seat.arms:
        arm.centre = shifted(arm.centre)
        arm.shift = tuple(u + w.rate * e for u, e in zip(arm.shift, direction, strict=True))
    for leg in seat.legs:
        start, finish = leg.ends
        leg.ends = shifted(start), finish


def _zero() -> tuple[Expr, ...]:
    return (Integer(0),) * 3
