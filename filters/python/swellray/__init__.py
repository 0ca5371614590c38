"""Wave refraction over real seafloors.

    import swellray

    seafloor = swellray.Seafloor.read("hudson.tif")
    rays = seafloor.trace(period=14, direction=135, height=2)
    rays["WaveHeight"]                      # numpy array, one value a point
    rays.map(spacing=50)["WaveHeight"]      # rows from south to north, columns from west to east
    rays.write("rays.vtp")

Lengths are metres, periods seconds; heights are crest to trough. A direction is where waves come from, degrees
clockwise from north. x is east, y north, elevation positive up.

Every result has its VTK data set as `.vtk`: VTK's own filters, and PyVista by pyvista.wrap(result.vtk), work on it. The
filters that this package runs are there too (swellray.vtkSwellRayTracer, ...), to be used as any of VTK's.
"""

from . import swellrayFilters
from ._results import Lines, Map, Rays, Result, Spray, Stations, Surface
from ._run import Error, Notice, set_threads
from ._sea import sea
from ._seafloor import Seafloor
from ._version import __version__
from .swellrayFilters import *  # noqa: F401,F403  the wrapped filters, vtkSwell...

__all__ = ["Seafloor", "Rays", "Lines", "Map", "Stations", "Surface", "Spray", "Result", "Error", "Notice",
           "sea", "set_threads"]
__all__ += [name for name in dir(swellrayFilters) if name.startswith("vtkSwell")]
