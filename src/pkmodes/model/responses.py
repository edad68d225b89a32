"""What a model says of a machine that is driven: poles, frequency responses, state space, compliance."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.base.drives import FREE
from pkmodes.mechanism.poses import OnError
from pkmodes.solve.backends import AUTO
from pkmodes.solve.dynamics import Dynamics

if TYPE_CHECKING:
    from pkmodes.response.frequency_response import FrequencyResponse
    from pkmodes.response.moves import Move
    from pkmodes.response.ports import Output
    from pkmodes.response.state_space import StateSpace
    from pkmodes.shaping.choice import Choice
    from pkmodes.shaping.shapers import Shaper


class Responses:
    """Methods of `pkmodes.Model` for a machine that is driven."""

    dynamics: Dynamics

    def poles(
        self,
        poses: ArrayLike,
        on_error: OnError = "raise",
        *,
        drives: str = FREE,
        backend: str = AUTO,
    ) -> NDArray[np.complex128]:
        """Compute the poles of small vibrations, whatever the damping (docs/response.md).

        Parameters
        ----------
        poses : array_like, shape (d,) or (..., d)
            In SI units.
        on_error : {"raise", "nan"}
            As for `modes`.
        drives : {"free", "held"}
            As for `modes`.
        backend : {"auto", "numpy", "compiled"}
            As for `modes`: what solves the undamped eigenproblem.

        Returns
        -------
        ndarray of complex128, shape (..., 2 m)
            In 1/s, by ascending magnitude; of a pair, the one with positive imaginary part first.  They are exact for
            viscous friction and damping ratios; a loss factor is the viscous damping that it is at the frequency of
            each mode.

        Examples
        --------
        >>> import pkmodes
        >>> model = pkmodes.load("robots/linear-delta-2022.toml").with_values({"damping.ratio": 0.02})
        >>> model.poles([0.6, 0.0, -0.245], drives="held")[:2].round(2)
        array([-4.05+202.7j, -4.05-202.7j])
        """
        from pkmodes.response.poles import poles_at

        return poles_at(self.dynamics, poses, on_error, drives=drives, backend=backend)

    def frf(
        self,
        poses: ArrayLike,
        frequencies: ArrayLike,
        inputs: Sequence[str],
        outputs: Sequence[Output],
        *,
        drives: str = FREE,
        quantity: str = "displacement",
        on_error: OnError = "raise",
        backend: str = AUTO,
    ) -> FrequencyResponse:
        """Compute frequency response functions, for exp(+i omega t) (docs/response.md).

        Parameters
        ----------
        poses : array_like, shape (d,) or (..., d)
            In SI units.
        frequencies : array_like, shape (F,)
            In Hz; 0 only where no rigid mode exists.
        inputs : sequence of str
            ``torque_j`` of a free motor [N m], the prescribed angle ``motor_j`` of a held one [rad], and
            ``force_<component>`` on the platform [N].
        outputs : sequence of str or mapping
            ``p_<component>``, ``{"name": [dx, dy, dz]}`` for another direction of the platform, ``motor_j``, and
            every coordinate of the robot.
        drives : {"free", "held"}
            As for `modes`.
        quantity : {"displacement", "velocity", "acceleration"}
            Of every output.
        on_error : {"raise", "nan"}
            As for `modes`.
        backend : {"auto", "numpy", "compiled"}
            As for `modes`: what solves the undamped eigenproblem.

        Returns
        -------
        FrequencyResponse
            ``values`` of shape (..., F, outputs, inputs).

        Raises
        ------
        PkmodesError
            If a port is unknown (the message suggests the nearest) or is not one with these drives, or a frequency is
            invalid.

        Examples
        --------
        >>> import numpy as np, pkmodes
        >>> model = pkmodes.load("robots/linear-delta-2022.toml").with_values({"damping.ratio": 0.02})
        >>> found = model.frf([0.6, 0.0, -0.245], np.linspace(10, 60, 501), ["force_x"], ["p_x"], drives="held")
        >>> float(found.frequencies[abs(found.values[:, 0, 0]).argmax()].round(1))
        36.2
        """
        from pkmodes.response.frequency_response import frequency_response

        return frequency_response(
            self.dynamics,
            poses,
            frequencies,
            inputs,
            outputs,
            drives=drives,
            quantity=quantity,
            on_error=on_error,
            backend=backend,
        )

    def state_space(
        self,
        poses: ArrayLike,
        inputs: Sequence[str],
        outputs: Sequence[Output],
        *,
        drives: str = FREE,
        modes: int | None = None,
        residual: bool = True,
        quantity: str = "displacement",
        on_error: OnError = "raise",
        backend: str = AUTO,
    ) -> StateSpace:
        """Build state space models in modal coordinates (docs/response.md).

        Parameters
        ----------
        poses : array_like, shape (d,) or (..., d)
            In SI units.
        inputs, outputs : sequence
            As for `frf`.
        drives : {"free", "held"}
            As for `modes`.
        modes : int, optional
            Number of modes kept, the lowest, rigid ones included; all by default.
        residual : bool
            Whether the static contribution of omitted modes is kept, in D (of displacements only).
        quantity : {"displacement", "velocity", "acceleration"}
            Of every output.
        on_error : {"raise", "nan"}
            As for `modes`.
        backend : {"auto", "numpy", "compiled"}
            As for `modes`: what solves the undamped eigenproblem.

        Returns
        -------
        StateSpace
            ``A``, ``B``, ``C`` and ``D`` with the leading axes of the poses.  The states are the coordinate and the
            rate of each mode.  Shapes of neighbouring poses may differ in sign and order: interpolate transfer
            functions, not these matrices.

        Raises
        ------
        PkmodesError
            If a port is unknown or is not one with these drives, the number of modes is not possible, or a velocity
            or an acceleration would contain a derivative of an input.

        Examples
        --------
        >>> import pkmodes
        >>> model = pkmodes.load("robots/linear-delta-2022.toml").with_values({"damping.ratio": 0.02})
        >>> system = model.state_space([0.6, 0.0, -0.245], ["motor_1"], ["p_x"], drives="held", modes=3)
        >>> system.A.shape, system.D.shape
        ((6, 6), (1, 1))
        >>> system.discretized(0.001).at().dt
        0.001
        """
        from pkmodes.response.state_space import state_space

        return state_space(
            self.dynamics,
            poses,
            inputs,
            outputs,
            drives=drives,
            modes=modes,
            residual=residual,
            quantity=quantity,
            on_error=on_error,
            backend=backend,
        )

    def compliance(self, poses: ArrayLike, on_error: OnError = "raise") -> NDArray[np.float64]:
        """Compute how far the platform gives way to a force while the motors are held (docs/response.md).

        Parameters
        ----------
        poses : array_like, shape (d,) or (..., d)
            In SI units.
        on_error : {"raise", "nan"}
            As for `modes`.

        Returns
        -------
        ndarray, shape (..., d, d)
            In m/N: displacement (rows) per force (columns), of the whole potential energy, gravity included.

        Examples
        --------
        >>> import pkmodes
        >>> model = pkmodes.load("robots/linear-delta-2022.toml")
        >>> (1e6 * model.compliance([0.6, 0.0, -0.245])).diagonal().round(2)  # um/N
        array([2.98, 6.24, 3.51])
        """
        from pkmodes.response.compliance import compliance

        return compliance(self.dynamics, poses, on_error)

    def shaper(
        self, kind: str, poses: ArrayLike, *, modes: int | None = None, continuous: bool = True
    ) -> Shaper:
        """Design shapers for the modes of held motors at poses (docs/shapers.md).

        Parameters
        ----------
        kind : str
            One of `pkmodes.shaping.KINDS`, or a product such as "zv*zv*zv", factor k of which is for mode k.
        poses : array_like, shape (d,) or (..., d)
            In SI units.
        modes : int, optional
            For a single kind: how many of the lowest modes count; by default three.
        continuous : bool
            For a single kind: the mean frequency of these modes, weighted by the squared ``vibration_amplitudes``,
            which has no jump along a path, as a move needs; or, if False, the frequency that leaves least at each
            pose, as in the comparison of `shapers`.

        Returns
        -------
        Shaper
            ``amplitudes`` and ``delays`` with the leading axes of the poses, then the impulses.

        Raises
        ------
        PkmodesError
            If the kind is unknown, or has more factors than the machine has modes; or a mode does not oscillate.

        Examples
        --------
        >>> import pkmodes
        >>> model = pkmodes.load("robots/linear-delta-2022-identified.toml")
        >>> (1e3 * model.shaper("zv*zv*zv", [0.6, 0.0, -0.244]).durations).round(1)  # ms
        np.float64(47.9)
        """
        from pkmodes.shaping.at_poses import shaper_at

        return shaper_at(self.dynamics, kind, poses, modes, continuous)

    def shapers(
        self,
        poses: ArrayLike,
        kinds: Sequence[str] | None = None,
        *,
        modes: int | None = None,
        left: float = 0.1,
        length: float | None = None,
        tick: float = 1e-3,
        firmware: str | None = None,
    ) -> Choice:
        """Compare shapers over poses: the best fixed one of each kind, and those that follow the pose.

        Parameters
        ----------
        poses : array_like, shape (..., d)
            Such as a grid over the workspace; those that cannot be evaluated, or at which a mode does not oscillate,
            are left out.
        kinds : str or sequence of str, optional
            By default all for one mode, and products of zv up to the number of modes.
        modes : int, optional
            The lowest modes that count; by default three.
        left : float
            Share of the vibration that a fixed shaper may leave at the worst pose to be good enough.
        length : float, optional
            Longest duration of a shaper [s].
        tick : float
            Time between two commands of the controller [s]; shapers shorter than two ticks are left out.
        firmware : {"klipper", "marlin", "reprapfirmware"}, optional
            Recommend only a shaper that it has.

        Returns
        -------
        Choice
            ``candidates``, and ``recommended``: the index of the shortest fixed shaper that is good enough, else of
            the one that leaves least at its worst pose.  At no pose those that follow it leave more than fixed ones.

        Raises
        ------
        PkmodesError
            If an argument is invalid, no fixed shaper is long or short enough, or the firmware has none of them.
        PoseError
            If no pose can be evaluated.
        """
        from pkmodes.shaping.choice import choose
        from pkmodes.shaping.ringing import ringing

        at = ringing(self.dynamics, poses, modes)
        return choose(at, kinds, left=left, length=length, tick=tick, firmware=firmware)

    def simulate(
        self, time: ArrayLike, poses: ArrayLike, *, shaper: Shaper | None = None, damping: float | None = None
    ) -> Move:
        """Simulate how the platform rings while held motors follow a command (docs/shapers.md).

        Modes, inertia and motion are those of the commanded pose of each moment; vibrations are small, and forces
        that grow with the square of the speed are left out.

        Parameters
        ----------
        time : array_like, shape (T,)
            Ascending [s].  Before the first sample the machine is at rest; between samples the command is a straight
            line, so sample it as the controller does.
        poses : array_like, shape (T, d)
            The command, in SI units.  Components that are no lengths stay constant.
        shaper : Shaper, optional
            With which the command is convolved: one, amplitudes and delays (n,), or one for each time, (T, n), which
            splits what the command moves up to this time: `shaper` designs them for the commanded poses.
        damping : float, optional
            Damping ratio of every mode, instead of that of the robot file.

        Returns
        -------
        Move
            ``poses``, which the motors follow: the command after the shaper; and ``deviation``, how far the platform
            is from them [m], both (T, d).

        Raises
        ------
        PkmodesError
            If the times do not ascend, or shapes do not go together.
        PoseError
            If the path leaves the workspace; the message says when and where.

        Examples
        --------
        >>> import numpy as np, pkmodes
        >>> model = pkmodes.load("robots/linear-delta-2022-identified.toml")
        >>> t = np.arange(0.0, 0.4, 0.001)  # 0.1 m/s within 10 ms, then on
        >>> x = 0.5 + np.where(t < 0.01, 5.0 * t**2, 0.1 * t - 0.0005)
        >>> move = model.simulate(t, np.stack([x, 0.0 * x, 0.0 * x - 0.245], axis=-1), damping=0.01)
        >>> bool(move.largest(after=0.05) > 1e-4)
        True
        """
        from pkmodes.response.moves import simulate

        return simulate(self.dynamics, time, poses, shaper, damping)
