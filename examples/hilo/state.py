"""Swell behind the breakwater of Hilo, the whole wave with rays, as a state of ParaView: `paraview --state=state.py` with the plugin Swellray loaded, or

    SWELLRAY_PLUGIN=.../Swellray.so pvpython state.py

which writes a picture into SWELLRAY_OUTPUT (here, unless set)."""

import os
import sys

from paraview.simple import *

if "SWELLRAY_PLUGIN" in os.environ:
    LoadPlugin(os.environ["SWELLRAY_PLUGIN"], remote=False, ns=globals())

# No part of Swellray: looked for in SWELLRAY_DATA.
data = os.environ.get("SWELLRAY_DATA", "../../../shared/data")
grid = os.path.join(data, "sites", "hilo_bay_hawaii", "hilo_bay_1_3s_epsg4326.tif")
land = os.path.join(data, "sites", "_shorelines", "hilo_land_polygons.geojson")
for file in (grid, land):
    if not os.path.isfile(file):
        print(f"no {file}; set SWELLRAY_DATA")
        sys.exit(77)

harbour = SwellSeafloorReader(registrationName="harbour", FileName=grid, Crop=1, CropBox=[-155.0887, 19.7255, -155.045, 19.752])
wave = dict(PeriodSeconds=14, DirectionFromDegrees=20, HeightMetres=1, Obstacles=land, Reflection=0.3)
waves = SwellMildSlope(registrationName="waves", Seafloor=harbour, Breaking="None", MinimumDepthMetres=3, **wave)
rays = SwellRays(registrationName="rays", Input=harbour, SpacingMetres=100, Insertion="None", **wave)

LoadPalette("WhiteBackground")
heights_colors = GetColorTransferFunction("WaveHeight")
heights_colors.ApplyPreset("Viridis (matplotlib)", True)
heights_colors.NanColor = [0.76, 0.70, 0.55]

view = GetActiveViewOrCreate("RenderView")
view.ViewSize = [1000, 800]
view.InteractionMode = "2D"
chart = Show(OutputPort(waves, 0), view)
chart.SetRepresentationType("Slice")
ColorBy(chart, ("POINTS", "WaveHeight"))
chart.SetScalarBarVisibility(view, True)
lines = Show(rays, view)
lines.ColorArrayName = ["POINTS", ""]
lines.DiffuseColor = lines.AmbientColor = [1, 1, 1]
lines.Position = [0, 0, 50]
ResetCamera(view)
Render(view)

if "SWELLRAY_PLUGIN" in os.environ:
    SaveScreenshot(os.path.join(os.environ.get("SWELLRAY_OUTPUT", "."), "hilo-paraview.png"), view)
