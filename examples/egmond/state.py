"""One hour of a storm over the bars of Egmond, its heights limited by the depth, as Baldock's breaking takes minutes on a map. As a state
of ParaView: `paraview --state=state.py` with the plugin Swellray loaded, or

    SWELLRAY_PLUGIN=.../Swellray.so pvpython state.py

which writes a picture into SWELLRAY_OUTPUT (here, unless set)."""

import os
import sys

from paraview.simple import *

if "SWELLRAY_PLUGIN" in os.environ:
    LoadPlugin(os.environ["SWELLRAY_PLUGIN"], remote=False, ns=globals())

# No part of Swellray: looked for in SWELLRAY_DATA.
data = os.environ.get("SWELLRAY_DATA", "../../../shared/data")
grid = os.path.join(data, "sites", "egmond_nl", "egmond_10m_epsg28992.tif")
for file in (grid,):
    if not os.path.isfile(file):
        print(f"no {file}; set SWELLRAY_DATA")
        sys.exit(77)

bed = SwellSeafloorReader(registrationName="bed", FileName=grid, WaterLevelMetres=1.35)
coarse = SwellSeafloorReader(registrationName="coarse", FileName=grid, ResampleMetres=100)
sea = SwellSea(registrationName="sea", Places=coarse, Seafloor=bed, DirectionFromDegrees=287, SignificantHeightMetres=3.5,
               PeakPeriodSeconds=8.8, SpreadDegrees=20, OffshoreDepthMetres=13.5, Frequencies=10)

LoadPalette("WhiteBackground")
heights_colors = GetColorTransferFunction("SignificantWaveHeight")
heights_colors.ApplyPreset("Viridis (matplotlib)", True)
heights_colors.NanColor = [0.76, 0.70, 0.55]

view = GetActiveViewOrCreate("RenderView")
view.ViewSize = [1000, 800]
view.InteractionMode = "2D"
chart = Show(sea, view)
chart.SetRepresentationType("Slice")
ColorBy(chart, ("POINTS", "SignificantWaveHeight"))
chart.SetScalarBarVisibility(view, True)
ResetCamera(view)
Render(view)

if "SWELLRAY_PLUGIN" in os.environ:
    SaveScreenshot(os.path.join(os.environ.get("SWELLRAY_OUTPUT", "."), "egmond-paraview.png"), view)
