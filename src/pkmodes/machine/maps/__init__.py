"""Maps: the modes of a robot over its workspace and over ranges of its parameters, as an `xarray.Dataset`.

`pkmodes.Model.map` and ``pkmodes map`` use `pkmodes.machine.maps.mapping`;
docs/reference/map-dataset.md describes the dataset.
"""
