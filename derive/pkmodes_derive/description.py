"""What the declaration of a mechanism writes directly into its description, and imports from here."""

from pkmodes_description import Margin, ParameterGroup, Requirement, Scale

__all__ = ["Margin", "ParameterGroup", "Requirement", "Scale"]
