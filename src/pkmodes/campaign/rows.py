"""The rows of a measurement file from the modes of records."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pkmodes.campaign.campaign import Campaign
from pkmodes.campaign.results import RecordResult
from pkmodes.core.base.errors import MeasurementError
from pkmodes.measured.measurements import Measurements


def measurements_of(results: Sequence[RecordResult], campaign: Campaign) -> Measurements:
    """Return the modes of all records as measurements.

    The band is stated if all records have the same one.

    Raises
    ------
    MeasurementError
        If there is no mode, or a number breaks a rule of measurement files.
    """
    rows = [
        (result.record, number, mode) for result in results for number, mode in enumerate(result.modes, 1)
    ]
    if not rows:
        raise MeasurementError(
            "expected modes, found none in any record", campaign.source, "check files and band"
        )
    channels = [name for name in campaign.channels if any(name in mode.shape for _, _, mode in rows)]
    settings = list(dict.fromkeys(path for record, _, _ in rows for path in record.settings))
    components = (
        {} if campaign.model is None else {one.name: one.unit for one in campaign.model.mechanism.pose}
    )
    bands = {record.band for record in campaign.records}
    points = np.array([[record.point[name] for name in components] for record, _, _ in rows])
    spreads = np.array([[record.point_sigma[name] for name in components] for record, _, _ in rows])
    shapes = {name: [mode.shape.get(name, np.nan) for _, _, mode in rows] for name in channels}
    return Measurements.from_rows(
        [record.pose for record, _, _ in rows],
        [mode.frequency for _, _, mode in rows],
        [mode.sigma for _, _, mode in rows],
        points=points.reshape(len(rows), len(components)),
        point_sigma=spreads.reshape(len(rows), len(components)),
        damping=[mode.damping for _, _, mode in rows],
        damping_sigma=[mode.sigma_damping for _, _, mode in rows],
        mode=[number for _, number, _ in rows],
        shapes=shapes,
        shape_sigma=[mode.sigma_shape if mode.shape else np.nan for _, _, mode in rows],
        band=bands.pop() if len(bands) == 1 else None,
        source=campaign.source,
        components=components,
        drives=[record.drives for record, _, _ in rows],
        settings={path: [record.settings.get(path, np.nan) for record, _, _ in rows] for path in settings},
    )
