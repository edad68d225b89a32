"""The description of a mechanism: what the derivation writes about it as ``description.json`` and the runtime reads.

It has its tables, poses, conditions, effects and drawing, so that the runtime reads robot files, checks poses and
writes reports without code for any particular mechanism.  `structure` is its only definition, from which `encoding`
follows; `references` checks what types cannot.

`shapers` is another table that both share: kinds of input shapers, which the derivation prints into C and the runtime
designs with.
"""

from pkmodes_description.encoding import FILE_NAME, DescriptionError, decode, encode
from pkmodes_description.structure import (
    CHOICES,
    UNITS,
    Axis,
    Description,
    Drawing,
    Effect,
    EffectParameter,
    Element,
    ElementShape,
    Key,
    Margin,
    Named,
    ParameterGroup,
    Requirement,
    Scale,
    Table,
    Term,
)

__all__ = [
    "CHOICES",
    "FILE_NAME",
    "UNITS",
    "Axis",
    "Description",
    "DescriptionError",
    "Drawing",
    "Effect",
    "EffectParameter",
    "Element",
    "ElementShape",
    "Key",
    "Margin",
    "Named",
    "ParameterGroup",
    "Requirement",
    "Scale",
    "Table",
    "Term",
    "decode",
    "encode",
]
