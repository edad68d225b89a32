"""Frequency responses for other programs: datasets, python-control, CSV."""

from __future__ import annotations

import csv
import io
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.mechanism.poses import placed
from pkmodes.dataset.attributes import imported
from pkmodes.dataset.variables import dims_of_poses
from pkmodes.response.channels import Channels, Index
from pkmodes.support.extras import require
from pkmodes.support.writing import write_file

if TYPE_CHECKING:
    from xarray import Dataset

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]


def response_dataset(response: Channels, values: Complex, frequencies: Array) -> Dataset:
    """Return responses as a dataset: see `FrequencyResponse.to_dataset`."""
    xr = imported()
    leading = dims_of_poses(response.poses.ndim - 1)
    components = {
        component.name: (leading, response.poses[..., i], {"units": component.unit})
        for i, component in enumerate(response.robot.mechanism.pose)
    }
    text = f"{response.quantity} of the outputs per unit of the inputs, exp(+i omega t)"
    data = {
        "response": ((*leading, "frequency", "output", "input"), values, {"long_name": text}),
        "unit": (("output", "input"), np.array(response.units, dtype=object)),
        "valid": (leading, response.valid),
        "reason": (leading, response.reason),
    }
    coords = {
        **components,
        "frequency": ("frequency", frequencies, {"units": "Hz"}),
        "output": list(response.outputs),
        "input": list(response.inputs),
    }
    attributes = {"robot": response.robot.name, "drives": response.drives, "quantity": response.quantity}
    dataset: Dataset = xr.Dataset(data, coords, attributes)
    return dataset


def control_library() -> Any:
    """Return python-control.

    Raises
    ------
    MissingExtraError
        If it is not installed.
    """
    require("systems for python-control", "control", "control")
    import control

    return control


def response_to_control(response: Channels, values: Complex, frequencies: Array) -> Any:
    """Return the response at one pose for python-control: see `FrequencyResponse.to_control`."""
    control = control_library()
    return control.FrequencyResponseData(
        np.moveaxis(values, 0, -1),  # outputs, inputs, frequencies
        2.0 * np.pi * frequencies,
        inputs=list(response.inputs),
        outputs=list(response.outputs),
    )


def response_to_csv(
    response: Channels, values: Complex, frequencies: Array, path: Path, index: Index
) -> None:
    """Write the response at one pose: see `FrequencyResponse.to_csv`."""
    text = io.StringIO()
    text.write(f"# robot: {response.robot.name}\n")
    text.write(f"# pose: {placed(response.robot.mechanism, response.poses[index], 'g')}\n")
    text.write(f"# drives: {response.drives}\n")
    text.write(f"# quantity: {response.quantity}\n")
    channels = [
        (o, i, f"{out}/{into}")
        for o, out in enumerate(response.outputs)
        for i, into in enumerate(response.inputs)
    ]
    for o, i, name in channels:
        text.write(f"# unit: {name} = {response.units[o][i]}\n")
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(["frequency", *(f"{part}:{name}" for _, _, name in channels for part in ("re", "im"))])
    for f, row in zip(frequencies, values, strict=True):
        cells = [number for o, i, _ in channels for number in (row[o, i].real, row[o, i].imag)]
        writer.writerow([repr(float(f)), *(repr(float(cell)) for cell in cells)])
    write_file(path, text.getvalue())


def state_space_to_control(system: Channels, matrices: tuple[Array, ...], tick: float | None) -> Any:
    """Return the model at one pose for python-control: see `StateSpace.to_control`."""
    control = control_library()
    time = 0 if tick is None else tick
    return control.StateSpace(*matrices, time, inputs=list(system.inputs), outputs=list(system.outputs))


def state_space_to_mat(
    system: Channels, matrices: tuple[Array, ...], tick: float | None, path: Path, index: Index
) -> None:
    """Write the model at one pose for MATLAB: see `StateSpace.to_mat`."""
    from scipy.io import savemat

    content: dict[str, Any] = dict(zip("ABCD", matrices, strict=True))
    content |= {
        "inputs": np.array(system.inputs, dtype=object),
        "outputs": np.array(system.outputs, dtype=object),
        "units": np.array(system.units, dtype=object),
        "pose": system.poses[index],
    }
    if tick is not None:
        content["tick"] = tick
    written = io.BytesIO()
    savemat(cast("Any", written), content, oned_as="column")  # SciPy takes open files too
    write_file(path, written.getvalue())
