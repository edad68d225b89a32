"""A mechanism at runtime: its description with its generated code.

Everything that differs between mechanisms comes from here.  No other module refers to a mechanism by name.
"""

from __future__ import annotations

from functools import cached_property
from importlib import import_module
from importlib.resources import files
from types import ModuleType

import msgspec
from msgspec import structs

from pkmodes_description import FILE_NAME, Description, Effect, Key, Table, decode

#: The table ``[damping]`` of every robot file: nothing is derived from it.
DAMPING = Table(
    "damping",
    "what every vibration mode dissipates, in addition to the effects",
    (
        Key(
            "ratio",
            "quantity",
            "",
            "number",
            "damping ratio of every vibration mode",
            at_least=0.0,
            below=1.0,
            default=0.0,
            suspected=False,
        ),
    ),
)
#: The path of its only key.
DAMPING_RATIO = "damping.ratio"


class Mechanism(Description, frozen=True, eq=False, dict=True, kw_only=True):
    """A mechanism: its `Description` and its generated functions.

    Attributes
    ----------
    package : str
        Package with the generated functions.
    """

    package: str

    def __repr__(self) -> str:
        pose = ", ".join(component.name for component in self.pose)
        return f"Mechanism({self.name!r}, pose ({pose}), {len(self.coordinates)} coordinates)"

    def moving_body(self, axis: str = "") -> str:
        """Return what moves along an axis, without an article; without one, what moves along any.

        Machines whose directions belong to several bodies have them all: "tool head (x) and bed (y)".
        """
        bodies = dict(zip(self.directions, self.moving_bodies, strict=False))
        if axis or len(set(bodies.values())) < 2:
            return bodies.get(axis or self.directions[0], "platform")
        return " and ".join(f"{body} ({direction})" for direction, body in bodies.items())

    def body_moves(self) -> str:
        """Return a clause that says that they move: "platform moves", "tool head (x) and bed (y) move"."""
        body = self.moving_body()
        return f"{body} move" if len(set(self.moving_bodies)) > 1 else f"{body} moves"

    def in_own_words(self, text: str) -> str:
        """Return a text on any mechanism with what moves in this one in place of "the platform"."""
        if not self.moving_bodies:
            return text
        bodies = " and ".join(f"the {body}" for body in dict.fromkeys(self.moving_bodies))
        return text.replace("the platform centre", f"the centre of {bodies}").replace("the platform", bodies)

    @cached_property
    def effects(self) -> dict[str, Effect]:
        """The effects that apply by name, in the order of the generated model and in words of this mechanism."""
        return {effect.name: self._effect_in_own_words(effect) for effect in self.effects_in_order}

    def _effect_in_own_words(self, effect: Effect) -> Effect:
        parameters = tuple(
            structs.replace(parameter, description=self.in_own_words(parameter.description))
            for parameter in effect.parameters
        )
        return structs.replace(effect, sentence=self.in_own_words(effect.sentence), parameters=parameters)

    @cached_property
    def conservative_effects(self) -> dict[str, Effect]:
        """The effects that change M or K: all except those that only dissipate."""
        return {name: effect for name, effect in self.effects.items() if not effect.dissipates}

    @cached_property
    def differences(self) -> dict[str, str]:
        """Fields that enter only as the difference from another field, which carries the sensitivities."""
        return dict(self.difference_pairs)

    @cached_property
    def model(self) -> ModuleType:
        """The generated model without effects."""
        return import_module(self.package)

    @cached_property
    def extended(self) -> ModuleType:
        """The generated model with effects."""
        return import_module(f"{self.package}.extended")

    @cached_property
    def placed(self) -> ModuleType:
        """The generated module ``terms``: the motion at the places of terms, and the matrices of mounts."""
        return import_module(f"{self.package}.terms")

    @cached_property
    def drawn(self) -> ModuleType:
        """The generated module ``drawing``: the points and springs of the drawing."""
        return import_module(f"{self.package}.drawing")


def described_mechanism(package: str) -> Mechanism:
    """Return the mechanism that a package describes.

    Raises DescriptionError if the description is invalid.
    """
    description = decode((files(package) / FILE_NAME).read_bytes())
    content = msgspec.structs.asdict(description)
    content["tables"] = (*description.tables, DAMPING)
    return Mechanism(package=package, **content)
