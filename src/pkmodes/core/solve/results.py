"""Results of an evaluation: modes, statics and checks, with the leading axes of the caller's poses."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import InitVar, dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.attached import Attached
from pkmodes.core.base.errors import NotComputedError
from pkmodes.core.mechanism.poses import CHUNK, explain_codes
from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.core.robot.robot import Robot
from pkmodes.core.solve.fields import mode_fields

if TYPE_CHECKING:
    from pandas import DataFrame
    from xarray import Dataset

    from pkmodes.core.solve.mode_fields import DeferredFields

Array = NDArray[np.float64]


@dataclass(frozen=True, repr=False, eq=False)
class AtPoses:
    """Results at poses, some of which may not have been evaluated.

    Attributes
    ----------
    codes : ndarray of int8, shape (...)
        Indices into `known`, from which `valid` and `reason` follow.
    known : tuple of str
        The reasons that the codes index: ``""`` for a pose that can be evaluated.
    valid : ndarray of bool, shape (...)
        Which poses could be evaluated.
    reason : ndarray of str, shape (...)
        Why the others could not: ``"finite"``, or the code of a condition of the mechanism, such as ``"limits"``
        (`pkmodes.Model.reasons` has a sentence for each); ``""`` where valid.  For a single pose a string.
    """

    codes: NDArray[np.int8]
    known: tuple[str, ...]

    @cached_property
    def valid(self) -> NDArray[np.bool_]:
        """Mask of the poses that could be evaluated."""
        return np.asarray(self.codes == 0)

    @cached_property
    def reason(self) -> NDArray[np.str_]:
        """Short code of the reason why a pose could not be evaluated, ``""`` where valid."""
        reasons: NDArray[np.str_] = np.array(self.known)[self.codes]
        return reasons


@dataclass(frozen=True, repr=False, eq=False)
class ChosenFields(AtPoses):
    """Results with optional fields; reading a field that was not requested raises `NotComputedError`.

    Fields may be evaluated when they are read first.
    """

    FIELDS: ClassVar[tuple[str, ...]] = ()
    METHOD: ClassVar[str] = ""

    arrays: InitVar[Mapping[str, NDArray[Any]]]
    _later: InitVar[DeferredFields | None] = field(default=None, kw_only=True)

    def __post_init__(self, arrays: Mapping[str, NDArray[Any]], _later: DeferredFields | None) -> None:
        self.__dict__.update(arrays)
        if _later is not None:
            self.__dict__["_later"] = _later

    def __getstate__(self) -> dict[str, Any]:
        for name in self.requested:  # a copy does not depend on the model
            getattr(self, name)
        return {name: value for name, value in self.__dict__.items() if name != "_later"}

    @property
    def requested(self) -> list[str]:
        """The fields that were requested, whether they have been evaluated or not."""
        later = self.__dict__.get("_later", ())
        return [name for name in self.FIELDS if name in self.__dict__ or name in later]

    def _shape(self, name: str) -> tuple[int, ...]:
        """Return the shape of a field that was requested."""
        array = self.__dict__.get(name)
        shape: tuple[int, ...] = self.__dict__["_later"].shape(name) if array is None else array.shape
        return shape

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> NDArray[Any]:
            later = self.__dict__.get("_later")
            if later is not None and name in later:
                return self.__dict__.setdefault(name, later(name))  # two threads get the same array
            if name not in self.FIELDS:
                raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")
            there = self.requested
            field_list = ", ".join(
                f'"{field_name}"' for field_name in self.FIELDS if field_name in (*there, name)
            )
            raise NotComputedError(
                f"the field {name} was not requested",
                f"{type(self).__name__} with {', '.join(there)}",
                f"call {self.METHOD} with fields=({field_list})",
            )

    def __repr__(self) -> str:
        shapes = ", ".join(f"{name} {self._shape(name)}" for name in self.requested)
        return f"{type(self).__name__}({np.count_nonzero(self.valid)} of {self.valid.size} valid; {shapes})"


class _NamesOfModes:
    """The names of the fields in the table, as a class attribute."""

    def __get__(self, instance: object, owner: type) -> tuple[str, ...]:
        return mode_fields()


@dataclass(frozen=True, repr=False, eq=False)
class Modes(ChosenFields):
    """Small vibrations about the static equilibrium at each pose.

    The leading axes are those of the poses: none for a single pose of shape (d,), (N,) for poses of shape
    (N, d).  n is the number of coordinates; the number of modes m is n minus the number of coordinates without
    inertia and, where the motors are held, of motors.  Modes are sorted by eigenvalue, the rigid-body modes
    first.  Entries of poses that could not be evaluated are NaN.  Fields that few need are evaluated when they are
    read, unless they were requested by name.

    Attributes
    ----------
    poses : ndarray, shape (..., d)
        Pose components of the mechanism, in SI units.
    coordinates : tuple of str, length n
        Names of the generalised coordinates, in the order of the matrices.
    rigid_modes : int
        Number of modes that strain nothing elastic; they come first.
    robot : Robot
        Whose modes they are.
    backend : {"numpy", "compiled"}
        What evaluated them.
    drives : {"free", "held"}
        What the motors do.
    valid : ndarray of bool, shape (...)
        Which poses could be evaluated.
    reason : ndarray of str, shape (...)
        Why the others could not (`pkmodes.Model.reasons`), ``""`` where valid; for a single pose a string.
    frequencies : ndarray, shape (..., m)
        sqrt(abs(lambda)) / (2 pi) with the sign of lambda [Hz].
    damping_ratios : ndarray, shape (..., m)
        As for light damping (docs/how-to/response.md); NaN for rigid-body modes, 0 where nothing dissipates.
    shapes : ndarray, shape (..., m, n)
        ``shapes[..., i, :]`` is mode i, mass-normalised (phi^T M phi = 1) with a deterministic sign.  A held motor
        has no motion in it.
    platform_shapes : ndarray, shape (..., m, components)
        Absolute motion of the platform centre in each mode, in the base frame, by the linear pose components: D_p
        times the independent coordinates' components, plus the motion of released joints and the frame.  Where the
        platform turns, its small rotations about base axes follow.
    vibration_amplitudes : ndarray, shape (..., m, directions)
        With motors that are held, or on springs (servo_stiffness), how the platform rings after a step of its
        acceleration of 1 m/s^2 along each linear pose component d [s^2]: ``|J_p phi_i| |phi_i^T M r_d| / omega_i^2``,
        with the motion r_d of all coordinates, motors included, that moves the platform by 1 along d without turning
        it and strains nothing; the norm is over all directions, not over rotations.  NaN for rigid-body modes, and
        with free motors that no spring holds.  In a group of equal frequencies it depends on the shapes that stand
        for the group.
    joint_positions : ndarray, shape (..., k)
        The independent coordinates, which follow from the pose.
    carriage_positions : ndarray, shape (..., k)
        The same values, for mechanisms where they are carriage positions.
    mass_matrix, stiffness_matrix : ndarray, shape (..., n, n)
        M and K in SI units.

    Raises
    ------
    NotComputedError
        If `frequencies` or a later field is read but was not requested.
    """

    FIELDS: ClassVar = _NamesOfModes()
    METHOD: ClassVar[str] = "Model.modes"

    poses: Array
    coordinates: tuple[str, ...]
    rigid_modes: int
    robot: Robot
    backend: str = "numpy"
    drives: str = "free"
    frequencies: Array = field(init=False)
    damping_ratios: Array = field(init=False)
    shapes: Array = field(init=False)
    platform_shapes: Array = field(init=False)
    vibration_amplitudes: Array = field(init=False)
    joint_positions: Array = field(init=False)
    carriage_positions: Array = field(init=False)
    mass_matrix: Array = field(init=False)
    stiffness_matrix: Array = field(init=False)

    @classmethod
    def fields_of(cls, mechanism: Mechanism) -> tuple[str, ...]:
        """Return the ``FIELDS`` that exist for a mechanism.

        Parameters
        ----------
        mechanism : Mechanism
            Attribute of a model.

        Returns
        -------
        tuple of str
            In the order of ``FIELDS``.
        """
        return mode_fields(mechanism)

    if TYPE_CHECKING:

        def to_dataset(self) -> Dataset:
            """Return the vibration modes as a dataset: `pkmodes.machine.dataset.modes.to_dataset`."""

        def to_table(self) -> DataFrame:
            """Return the vibration modes as a table: `pkmodes.machine.dataset.modes.to_table`."""

    else:
        to_dataset = Attached("pkmodes.machine.dataset.modes:to_dataset")
        to_table = Attached("pkmodes.machine.dataset.modes:to_table")
        _repr_html_ = Attached("pkmodes.pages.report.notebook:modes_html")


@dataclass(frozen=True, eq=False)
class Statics(AtPoses):
    """Static equilibrium at each pose (equation 44): what holds the platform against gravity.

    Attributes
    ----------
    poses : ndarray, shape (..., d)
        Pose components of the mechanism, in SI units.
    torques : ndarray, shape (..., drives)
        What the drives exert, in their order, positive in the direction of each drive's coordinate: torques [N m], or
        forces [N] where that coordinate is a length; ``mechanism.drives`` has the units.
    rotations : ndarray, shape (..., n - k)
        Displacements of the dependent coordinates from the unstrained transmissions, in their order: rotations
        [rad], or lengths [m].
    robot : Robot
        The robot that they hold.
    valid : ndarray of bool, shape (...)
        Which poses could be evaluated.
    reason : ndarray of str, shape (...)
        Why the others could not (`pkmodes.Model.reasons`), ``""`` where valid; for a single pose a string.
    """

    poses: Array
    torques: Array
    rotations: Array
    robot: Robot = field(repr=False)

    _repr_html_ = Attached("pkmodes.pages.report.notebook:statics_html")


@dataclass(frozen=True, repr=False, eq=False)
class PoseCheck(AtPoses):
    """Which poses can be evaluated, and what is wrong with the others.

    Attributes
    ----------
    poses : ndarray, shape (..., d)
        Pose components of the mechanism, in SI units.
    robot : Robot
        The robot for which the poses were checked.
    valid : ndarray of bool, shape (...)
        Which poses can be evaluated.
    reason : ndarray of str, shape (...)
        Why the others cannot (`pkmodes.Model.reasons`), ``""`` where valid; for a single pose a string.
    sentences : ndarray of object, shape (...)
        What is wrong with each pose, with numbers and a remedy; ``""`` where valid.  For a single pose a string.
    """

    poses: Array
    robot: Robot

    @cached_property
    def sentences(self) -> NDArray[np.object_]:
        """Sentences that say what is wrong with each pose, with the remedy."""
        sentences = np.full(self.codes.size, "", dtype=object)
        invalid, codes = np.flatnonzero(self.codes), self.codes.reshape(-1)
        mechanism, points = self.robot.mechanism, self.poses.reshape(self.codes.size, -1)
        for start in range(0, len(invalid), CHUNK):
            chunk = invalid[start : start + CHUNK]
            texts = explain_codes(points[chunk], codes[chunk], mechanism, self.robot.parameters)
            sentences[chunk] = [f"{problem}; {remedy}" for problem, remedy in texts]
        shaped: NDArray[np.object_] = sentences.reshape(self.codes.shape)[()]
        return shaped

    def __repr__(self) -> str:
        counts = {code: int(np.count_nonzero(self.reason == code)) for code in self.known if code}
        rejected = "".join(f", {count} {code}" for code, count in counts.items() if count)
        return f"PoseCheck({np.count_nonzero(self.valid)} of {self.valid.size} valid{rejected})"
