"""A sea on a map or at stations, the points shared by the ranks of MPI:

    SWELLRAY_PLUGIN=.../Swellray.so mpirun -np 4 pvbatch examples/spectral_map.py SEAFLOOR OUT.pvti

Every rank reads the seafloor and traces the rays of its own part of the points; the ranks write their parts beside OUT, which
names them. With --stations POINTS.csv (columns x and y, in the file's coordinates) OUT is a .pvtp. The numbers are the same for
any number of ranks. A rank has one thread; more by VTK_SMP_BACKEND_IN_USE=STDThread VTK_SMP_MAX_THREADS=N.
"""

import argparse
import os
import sys
from pathlib import Path

import paraview.simple as pv

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("seafloor", help="a seafloor file")
parser.add_argument("output", help=".pvti of a map, .pvtp of stations")
parser.add_argument("--hs", type=float, default=2.0, help="significant height offshore, m")
parser.add_argument("--tp", type=float, default=12.0, help="peak period offshore, s")
parser.add_argument("--direction", type=float, default=135.0, help="from, nautical degrees")
parser.add_argument("--spread", type=float, default=25.0, help="of the directions, degrees")
parser.add_argument("--spacing", type=float, help="of the nodes of the map, m; a hundredth of its longer side unless given")
parser.add_argument("--frequencies", type=int, default=20)
parser.add_argument("--directions", type=int, default=36)
parser.add_argument("--stations", help="points, .csv, in place of a map")
call = parser.parse_args()
if not call.output.endswith(".pvtp" if call.stations else ".pvti"):
    sys.exit("spectral_map.py: the output of a map must end in .pvti, of stations in .pvtp")
for path in (call.seafloor, call.stations):
    if path and not Path(path).is_file():
        sys.exit(f"spectral_map.py: no file {path}")

pv.LoadPlugin(os.environ["SWELLRAY_PLUGIN"], remote=True, ns=vars(pv))

seafloor = pv.SwellSeafloorReader(FileName=call.seafloor)
if call.stations:
    table = pv.CSVReader(FileName=[call.stations])
    points = pv.TableToPoints(Input=table, XColumn="x", YColumn="y", a2DPoints=1)
    places = pv.SwellPlaces(Points=points, Seafloor=seafloor)
else:
    seafloor.UpdatePipeline()
    west, east, south, north = seafloor.GetDataInformation().GetBounds()[:4]
    spacing = call.spacing or max(east - west, north - south) / 100.0
    places = pv.SwellSeafloorReader(FileName=call.seafloor, ResampleMetres=spacing)
sea = pv.SwellSea(Places=places, Seafloor=seafloor, SignificantHeightMetres=call.hs, PeakPeriodSeconds=call.tp,
                  DirectionFromDegrees=call.direction, SpreadDegrees=call.spread, Frequencies=call.frequencies,
                  Directions=call.directions)
pv.SaveData(call.output, proxy=sea)
