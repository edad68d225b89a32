"""Gearbox inertia: extra inertia on every driven pulley."""

from pkmodes_derive.effect import Effect, EffectParameter


def apply(machine, parameters, released):
    """Add the inertia to the driven pulley."""
    for j in range(3):
        machine.driven_inertia[j] += parameters["inertia"]


EFFECT = Effect(
    name="gearbox_inertia",
    sentence="the gearboxes have an inertia of their own",
    parameters=(EffectParameter("inertia", "kg m^2", "extra inertia on every driven pulley", "I_G", "I_G"),),
    apply=apply,
)
