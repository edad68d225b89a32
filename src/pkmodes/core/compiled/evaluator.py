"""The compiled evaluator of one robot, or of several: modes at poses, written into arrays.

Arrays of several poses belong to the caller; a single pose has a `PoseBuffer`, so that a call needs no new arrays and
looks up no addresses.
"""

from __future__ import annotations

import ctypes
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from threading import Lock

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.compiled.lanes import Lanes, Terms
from pkmodes.core.compiled.loader import Library, Request

Array = NDArray[np.float64]
#: Poses that a thread takes at a time, a multiple of those in a block.
POSES_PER_SHARE = 4800
#: Lanes for a single pose: every processor has this many, more are slower, and the results are the same.
SINGLE_POSE_LANES = 2


class Evaluator:
    """The compiled evaluator of one robot, or of several with the same free coordinates.

    - coordinates: without effects; with them `lanes` says how many there are
    - largest_condition: poses with a larger condition number are singular
    - components, size: components of the platform's motion and number of all coordinates of the model with effects,
      for `along`
    - rigid_modes: how many modes do not vibrate

    Its attributes:
    - coordinates, modes: n, and m of them with inertia
    """

    def __init__(
        self,
        library: Library,
        lanes: Lanes,
        coordinates: int,
        largest_condition: float,
        components: int = 0,
        size: int = 0,
        rigid_modes: int = 0,
    ) -> None:
        self.coordinates = coordinates
        self.modes = coordinates - int(lanes.massless.sum())
        self._library, self._lanes = library, lanes  # the arrays live as long as their addresses are used
        self._robots, self._components, self._size = lanes.robots, components, size
        self._request = Request(
            robots=self._robots,
            rigid_modes=rigid_modes,
            parameter_count=lanes.parameters.shape[-1],
            effect_count=lanes.effects.shape[-1],
            joint_count=lanes.joints.shape[-1],
            parameters=lanes.parameters.ctypes.data,
            effects=lanes.effects.ctypes.data,
            largest_condition=largest_condition,
            joints=lanes.joints.ctypes.data,
            free=lanes.free.ctypes.data,
            massless=lanes.massless.ctypes.data,
            free_count=len(lanes.free),
            leading=lanes.fold.leading.ctypes.data,
            following=lanes.fold.following.ctypes.data,
            fold_weights=lanes.fold.weights.ctypes.data,
            fold_count=len(lanes.fold.weights),
        )

    def run(
        self,
        points: Array,
        arrays: Mapping[str, Array],
        threads: int = 1,
        width: int | None = None,
        terms: Terms | None = None,
    ) -> NDArray[np.int8]:
        """Evaluate poses.

        - points: contiguous, (N, d); for several robots the same number for each, robot by robot
        - arrays: contiguous arrays to fill, by field of `pkmodes.core.compiled.lanes.FIELDS`, or of `RATES` with
          `terms`, each (N, ...); NaN where a pose cannot be evaluated
        - threads: number of threads for one robot; the results do not depend on it
        - width: number of lanes, by default the largest that the processor has
        - terms: paths along which to differentiate

        Returns (N,): indices into `pkmodes.core.mechanism.poses.codes_of`, or `pkmodes.core.compiled.lanes.UNSOLVED`.
        """
        count = len(points)
        codes = np.empty(count, dtype=np.int8)
        request = self._with_terms(terms)
        helpers = min(threads, -(-count // POSES_PER_SHARE)) - 1 if self._robots == 1 else 0
        if helpers < 1:
            self._run_part(request, points, arrays, codes, width)
            return codes
        starts, lock = iter(range(0, count, POSES_PER_SHARE)), Lock()

        def work() -> None:
            """Take shares until none is left: a slow thread delays the others by one share at most."""
            while True:
                with lock:
                    start = next(starts, None)
                if start is None:
                    return
                part = slice(start, start + POSES_PER_SHARE)
                share_arrays = {name: array[part] for name, array in arrays.items()}
                self._run_part(request, points[part], share_arrays, codes[part], width)

        with ThreadPoolExecutor(helpers) as pool:
            futures = [pool.submit(work) for _ in range(helpers)]
            work()
            for future in futures:
                future.result()
        return codes

    def buffer(self, size: int, pose_shapes: Mapping[str, tuple[int, ...]]) -> PoseBuffer:
        """Return a buffer for one pose with `size` components and some fields of one robot: see `PoseBuffer`."""
        return PoseBuffer(self._library, self._request, size, pose_shapes)

    def along(
        self, points: Array, modes: tuple[Array, Array] | None, terms: Terms, fields: Sequence[str]
    ) -> dict[str, Array] | None:
        """Evaluate what the derivatives of given modes along paths need.

        - points: as for `run`, (N, d)
        - modes: eigenvalues and shapes, with n coordinates that are not locked, (N, m) and (N, m, n); None for
          no mode
        - terms: of T paths; for several robots those of each
        - fields: of `ALONG_OF_MODES`, `RATES_OF_MATRICES` and `ALL_COORDINATES` in `pkmodes.core.compiled.lanes`

        Returns arrays by field; None if a pose cannot be evaluated.
        """
        if modes is None:
            modes = np.empty((len(points), 0)), np.empty((len(points), 0, self.coordinates))
        count, m, n = modes[1].shape
        request = Request.from_buffer_copy(self._with_terms(terms))
        contiguous = [np.ascontiguousarray(array) for array in modes]
        request.given_eigenvalues, request.given_shapes = (array.ctypes.data for array in contiguous)
        request.modes, request.path_count = m, terms.first.shape[-1] - 1
        request.term_count = terms.first.shape[-1] if terms.first.ndim > 1 else 0
        per_path, full_matrix = (count, request.path_count), (count, self._size, self._size)
        shapes = {
            "changes": (*per_path, m, n),
            "mode_rates": (*per_path, m),
            "norms": (*per_path, m),
            "motions": (*per_path, m, self._components),
            "mass_rates": (*per_path, n, n),
            "stiffness_rates": (*per_path, n, n),
            "mass_of_all": full_matrix,
            "stiffness_of_all": full_matrix,
        }
        arrays = {name: np.empty(shapes[name]) for name in fields}
        codes = np.empty(count, dtype=np.int8)
        self._run_part(request, points, arrays, codes, None)
        return None if codes.any() else arrays

    def _with_terms(self, terms: Terms | None) -> Request:
        """Return the request with paths."""
        if terms is None:
            return self._request
        request = Request.from_buffer_copy(self._request)
        request.effects = terms.effects.ctypes.data
        request.path_count = len(terms.first) - 1
        request.first_term, request.places = terms.first.ctypes.data, terms.places.ctypes.data
        request.weights = terms.weights.ctypes.data
        request.all_coordinates, request.locked_joints = terms.all_coordinates, terms.locked_joints
        return request

    def _run_part(
        self,
        template: Request,
        points: Array,
        arrays: Mapping[str, Array],
        codes: NDArray[np.int8],
        width: int | None,
    ) -> None:
        request = Request.from_buffer_copy(template)
        request.count, request.poses, request.codes = len(points), points.ctypes.data, codes.ctypes.data
        for name, array in arrays.items():
            setattr(request, name, array.ctypes.data)
        self._library.run(ctypes.addressof(request), self._library.width if width is None else width)


class PoseBuffer:
    """A request for one pose with arrays that stay where they are; for one thread at a time.

    - request: with one robot; what its addresses point to must outlive the buffer
    - size: components of a pose
    - pose_shapes: shape at one pose of each field of `pkmodes.core.compiled.lanes.FIELDS` that is requested

    Its attributes:
    - arrays: what `run` has filled, by field, each (1, *tail)
    """

    def __init__(
        self, library: Library, request: Request, size: int, pose_shapes: Mapping[str, tuple[int, ...]]
    ) -> None:
        self._pose, self._codes = np.empty((1, size)), np.empty(1, dtype=np.int8)
        self.arrays = {name: np.empty((1, *shape)) for name, shape in pose_shapes.items()}
        self._request = Request.from_buffer_copy(request)
        self._request.count = 1
        self._request.poses, self._request.codes = self._pose.ctypes.data, self._codes.ctypes.data
        for name, array in self.arrays.items():
            setattr(self._request, name, array.ctypes.data)
        self._run, self._address = library.run, ctypes.addressof(self._request)

    def run(self, point: Array) -> int:
        """Evaluate a pose, (1, d), and return its code, as `pkmodes.core.compiled.evaluator.Evaluator.run` does."""
        self._pose[...] = point
        self._run(self._address, SINGLE_POSE_LANES)
        return int(self._codes[0])
