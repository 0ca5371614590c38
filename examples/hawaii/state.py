"""Swell from the Southern Ocean arriving at Hawaii, as a state of ParaView: `paraview --state=state.py` with the plugin Swellray loaded, or

    SWELLRAY_PLUGIN=.../Swellray.so pvpython state.py

which writes a picture into SWELLRAY_OUTPUT (here, unless set)."""

import os
import sys

from paraview.simple import *

if "SWELLRAY_PLUGIN" in os.environ:
    LoadPlugin(os.environ["SWELLRAY_PLUGIN"], remote=False, ns=globals())

# The grid is no part of Swellray: it is looked for in SWELLRAY_DATA.
grid = os.path.join(os.environ.get("SWELLRAY_DATA", "../../../shared/data"), "sites", "hawaii_islands", "hawaii_etopo1.nc")
if not os.path.isfile(grid):
    print(f"no grid {grid}; set SWELLRAY_DATA")
    sys.exit(77)

islands = SwellSeafloorReader(registrationName="islands", FileName=grid, Earth="Ellipsoid")
rays = SwellRays(registrationName="rays", Input=islands, PeriodSeconds=16, HeightMetres=2,
                 Source="A storm far away", SourcePosition=[170, -50], Edge="Not refracted", SpacingMetres=8000, LeeRays=0)
heights = SwellHeights(registrationName="heights", Input=rays)
shore = SwellContours(registrationName="shore", Input=islands, DepthsMetres=[0])

LoadPalette("WhiteBackground")
heights_colors = GetColorTransferFunction("WaveHeight")
heights_colors.ApplyPreset("Viridis (matplotlib)", True)
heights_colors.NanColor = [0.76, 0.70, 0.55]

view = GetActiveViewOrCreate("RenderView")
view.ViewSize = [1200, 900]
view.InteractionMode = "2D"
lines = Show(heights, view)
ColorBy(lines, ("POINTS", "WaveHeight"))
lines.RescaleTransferFunctionToDataRange(False)
heights_colors.RescaleTransferFunction(0.0, 4.0)
lines.SetScalarBarVisibility(view, True)
coast = Show(shore, view)
coast.ColorArrayName = ["POINTS", ""]
coast.DiffuseColor = coast.AmbientColor = [0, 0, 0]
coast.LineWidth = 2
ResetCamera(view)
Render(view)

if "SWELLRAY_PLUGIN" in os.environ:
    SaveScreenshot(os.path.join(os.environ.get("SWELLRAY_OUTPUT", "."), "hawaii-paraview.png"), view)
