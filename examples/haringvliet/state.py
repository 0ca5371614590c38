"""The storm of 14 October 1982 at the mouth of the Haringvliet, as a state of ParaView: `paraview --state=state.py` with the plugin Swellray loaded, or

    SWELLRAY_PLUGIN=.../Swellray.so pvpython state.py

which writes a picture into SWELLRAY_OUTPUT (here, unless set)."""

import os
import sys

from paraview.simple import *

if "SWELLRAY_PLUGIN" in os.environ:
    LoadPlugin(os.environ["SWELLRAY_PLUGIN"], remote=False, ns=globals())

# No part of Swellray: looked for in SWELLRAY_DATA.
data = os.environ.get("SWELLRAY_DATA", "../../../shared/data")
swan = os.path.join(data, "sites", "haringvliet_nl", "f31har03.swn")
boundary = os.path.join(data, "sites", "haringvliet_nl", "f31har03.bnd")
for file in (swan, boundary):
    if not os.path.isfile(file):
        print(f"no {file}; set SWELLRAY_DATA")
        sys.exit(77)

estuary = SwellSeafloorReader(registrationName="estuary", FileName=swan, WaterLevelMetres=1.7)
coarse = SwellSeafloorReader(registrationName="coarse", FileName=swan, ResampleMetres=500)
sea = SwellSea(registrationName="sea", Places=coarse, Seafloor=estuary, SpectralFile=boundary, OffshoreDepthMetres=15,
               Edge="Not refracted", Frequencies=12)

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
    SaveScreenshot(os.path.join(os.environ.get("SWELLRAY_OUTPUT", "."), "haringvliet-paraview.png"), view)
