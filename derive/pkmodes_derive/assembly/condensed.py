"""A derived machine in its coordinates with inertia, the basis of the functions of a model without free joints."""

from __future__ import annotations

from collections.abc import Mapping, Sequence, Set
from dataclasses import replace
from functools import cached_property

from sympy import Add, Expr, Integer, Symbol

from pkmodes_derive import condensation
from pkmodes_derive.assembly.derived import Derived, flattened, joint_losses, matrix_sum
from pkmodes_derive.assembly.rank import nullity
from pkmodes_derive.functions import Argument, Function, Output

NUMBER_WORDS = {2: "two", 3: "three", 4: "four", 5: "five", 6: "six", 7: "seven", 8: "eight", 9: "nine"}


class Condensed:
    """Derived quantities, arguments, M and K that the functions of a model use.

    Parameters
    ----------
    derived : Derived
        With or without effects.
    zeros : set of sympy.Symbol
        Parameters that are zero; released coordinates that have no inertia as a result are condensed.

    Attributes
    ----------
    coordinates, rates, displacements : tuple of sympy.Symbol
        The coordinates with inertia, used by every function, their rates and displacements.
    M, K_el, K : tuple of sympy.Expr
        In the coordinates with inertia, row by row; K_el with the springs of released joints.
    C_v, K_loss : tuple of sympy.Expr
        Viscous damping, and the imaginary part of K_el, likewise; empty if nothing dissipates.
    K_g : tuple of sympy.Expr
        Hessian of gravity in the independent coordinates.
    M_all, K_all : list of lists
        In all coordinates, with the springs of released joints.
    condensation : list of lists
        Map from the coordinates with inertia to all coordinates, one row for each of these.
    V_el : sympy.Expr
        Elastic energy, including the springs of released joints.
    """

    def __init__(self, derived: Derived, zeros: Set[Symbol] = frozenset()) -> None:
        self.derived = d = derived
        self.machine, self.kin, self.energies, self.equilibrium = d.machine, d.kin, d.energies, d.equilibrium
        self.definitions = d.kin.definitions
        self._matrices(zeros)
        machine, count = self.machine, NUMBER_WORDS.get(self.n, str(self.n))
        self.count = f"{count} generalised coordinates"
        coordinate_units = dict.fromkeys(machine.vocabulary[q].unit for q in self.coordinates)
        self.pose = d.pose
        free = tuple(machine.velocities[i] for i in d.free)
        unit = machine.vocabulary[free[0]].unit
        words = machine.independent_are.rsplit(" ", 1)
        description = f"{words[0]} velocities" if len(words) > 1 else "velocities"
        self.free_rates = Argument(f"{machine.argument}_dot", free, unit, description)
        self.q_dot = Argument(
            "q_dot", self.rates, ", ".join(f"{u}/s" for u in coordinate_units), f"rates of the {self.count}"
        )
        self.delta_q = Argument(
            "delta_q",
            self.displacements,
            ", ".join(coordinate_units),
            f"small displacements of the {self.count} from the reference configuration at p",
        )

    def _matrices(self, zeros: Set[Symbol]) -> None:
        """Form M and K in all coordinates, then condense the coordinates without inertia."""
        d, machine, energies = self.derived, self.machine, self.energies
        self.V_el = Add(energies.V_el, *energies.V_r)
        K_el = [list(row) for row in d.K_el]
        for i, compliance in enumerate(machine.compliances, start=machine.base):
            K_el[i][i] += 1 / compliance  # the spring of a released joint
        zero_values = dict.fromkeys(zeros, Integer(0))
        all_indices = range(len(machine.small))
        massless = [
            i for i in all_indices if i >= machine.base and not any(e.xreplace(zero_values) for e in d.M[i])
        ]
        with_inertia = [i for i in all_indices if i not in massless]
        self.massless, self.n = tuple(machine.all_coordinates[i] for i in massless), len(with_inertia)
        self.coordinates, self.rates, self.displacements = (
            tuple(symbols[i] for i in with_inertia)
            for symbols in (machine.all_coordinates, machine.rates, machine.small)
        )
        # Gravity acts on masses only, so a massless coordinate follows elastic forces alone.
        self.condensation = condensation.condensation_map(K_el, with_inertia, massless)
        self._massless_rates = {machine.rates[i]: Integer(0) for i in massless}
        self._massless_displacements = {
            machine.small[i]: Add(
                *(f * q for f, q in zip(self.condensation[i], self.displacements, strict=True))
            )
            for i in massless
        }
        self.M_all, self.K_all = d.M, matrix_sum(K_el, d.K_g)
        condensed = condensation.condensed_stiffness(K_el, with_inertia, massless, self.condensation)
        self.M = tuple(d.M[k][m] for k in with_inertia for m in with_inertia)
        self.K_el = flattened(condensed)
        free = range(len(machine.independent))
        self.K_g = tuple(self.equilibrium.gravity_hessian[k][m] for k in free for m in free)
        self.C_v, self.K_loss = (), ()
        if any(effect.dissipates for effect in machine.effects):
            K_loss = [list(row) for row in d.K_loss]
            springs = zip(joint_losses(machine), machine.compliances, strict=True)
            for i, (loss, compliance) in enumerate(springs, start=machine.base):
                K_loss[i][i] += loss / compliance
            self.C_v, self.K_loss = (
                flattened(condensation.project(matrix, self.condensation)) for matrix in (d.C_v, K_loss)
            )
        self.K = flattened(matrix_sum(condensed, [[d.K_g[k][m] for m in with_inertia] for k in with_inertia]))

    @property
    def elastic_gradient(self) -> tuple[Expr, ...]:
        """Gradient of V_el; massless coordinates are in equilibrium and contribute nothing."""
        return tuple(self.kin.chain.derivative(self.V_el, q, self.derived.hold) for q in self.displacements)

    @property
    def locked(self) -> dict[Symbol, Expr]:
        """Values of released joints at rest in the reference configuration."""
        return dict.fromkeys((s for c in self.machine.released for s in (c.position, c.rate)), Integer(0))

    @property
    def moving_energy(self) -> Expr:
        """Kinetic energy of the structure with rigid transmissions and locked joints."""
        machine = self.machine
        rate = dict(zip(machine.coordinates, machine.velocities, strict=True))
        turning = {rate[q]: form.xreplace(rate) for q, form in machine.follows.items()}
        return self.energies.T_ss.xreplace({**turning, **self.locked})

    @cached_property
    def rigid_modes(self) -> int:
        """Nullity of the elastic Hessian at unrelated values."""
        return nullity([self.K_el[i : i + self.n] for i in range(0, self.n**2, self.n)])

    def function(
        self,
        name: str,
        summary: str,
        source: str,
        arguments: Sequence[Argument],
        *outputs: Output,
        details: str = "",
        substitutions: Mapping[Symbol, Expr] | None = None,
    ) -> Function:
        """Return a function of the pose that uses the shared definitions.

        Rates and displacements of massless coordinates are not arguments: they are substituted, as are the
        `substitutions` values.
        """
        substitutions = {**self._massless_rates, **self._massless_displacements, **(substitutions or {})}
        if not substitutions:
            return Function(name, summary, source, tuple(arguments), outputs, self.definitions, details)
        results = tuple(
            replace(o, entries=tuple(entry.xreplace(substitutions) for entry in o.entries)) for o in outputs
        )
        definitions = {s: e.xreplace(substitutions) for s, e in self.definitions.items()}
        return Function(name, summary, source, tuple(arguments), results, definitions, details)
