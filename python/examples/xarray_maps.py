"""Maps over a grid of two inputs: an xarray with names and units, saved as netCDF."""

from pathlib import Path

import numpy as np
import rollerscrew as rs
import xarray

FORCE, NUT = "load_cases[0].axial_force", "structure.nut.outer_diameter"


def main(file: Path | None = None, points: int = 21) -> xarray.Dataset:
    """Stiffness and the share of each thread over force and diameter of the nut."""
    forces, diameters = np.meshgrid(np.linspace(5.0, 45.0, points), np.linspace(44.0, 60.0, points))
    designs = rs.lesson(1).evaluate(
        {FORCE: (forces.ravel(), "kN"), NUT: (diameters.ravel(), "mm")},
        ["axial_stiffness_N_per_um", "screw.load_rate_percent"],
    )
    maps = designs.to_xarray()
    if file is not None:
        maps.to_netcdf(file, engine="netcdf4")
    return maps


if __name__ == "__main__":
    maps = main(Path("maps.nc"))
    stiffest = maps["axial_stiffness_N_per_um"].argmax(...)
    print(maps, {name: float(maps[name][place]) for name, place in stiffest.items()})
