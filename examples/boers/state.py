"""Random waves over a bar in a flume (Boers 1996), as a state of ParaView: `paraview --state=state.py` with the plugin Swellray loaded, or

    SWELLRAY_PLUGIN=.../Swellray.so pvpython state.py

which writes a picture into SWELLRAY_OUTPUT (here, unless set)."""

import os
import sys

from paraview.simple import *

if "SWELLRAY_PLUGIN" in os.environ:
    LoadPlugin(os.environ["SWELLRAY_PLUGIN"], remote=False, ns=globals())

# No part of Swellray: looked for in SWELLRAY_DATA.
data = os.environ.get("SWELLRAY_DATA", "../../../shared/data")
flume = os.path.join(data, "measured", "boers_1996_1C", "params.txt")
for file in (flume,):
    if not os.path.isfile(file):
        print(f"no {file}; set SWELLRAY_DATA")
        sys.exit(77)

bed = SwellSeafloorReader(registrationName="bed", FileName=flume)
rays = SwellRays(registrationName="rays", Input=bed, PeriodSeconds=10 / 3, DirectionFromDegrees=270, HeightMetres=0.072,
                 OffshoreDepthMetres=0.75, Edge="Not refracted")
heights = SwellHeights(registrationName="heights", Input=rays, Breaking="Battjes and Janssen 1978")

LoadPalette("WhiteBackground")
heights_colors = GetColorTransferFunction("WaveHeight")
heights_colors.ApplyPreset("Viridis (matplotlib)", True)
heights_colors.NanColor = [0.76, 0.70, 0.55]

view = GetActiveViewOrCreate("RenderView")
view.ViewSize = [1000, 800]
view.InteractionMode = "2D"
chart = Show(heights, view)
ColorBy(chart, ("POINTS", "WaveHeight"))
chart.SetScalarBarVisibility(view, True)
ResetCamera(view)
Render(view)

if "SWELLRAY_PLUGIN" in os.environ:
    SaveScreenshot(os.path.join(os.environ.get("SWELLRAY_OUTPUT", "."), "boers-paraview.png"), view)
