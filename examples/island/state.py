"""Waves round an island, as a state of ParaView: `paraview --state=state.py` with the plugin Swellray loaded, or

    SWELLRAY_PLUGIN=.../Swellray.so pvpython state.py

which writes a picture into SWELLRAY_OUTPUT (here, unless set)."""

import os

from paraview.simple import *

if "SWELLRAY_PLUGIN" in os.environ:
    LoadPlugin(os.environ["SWELLRAY_PLUGIN"], remote=False, ns=globals())

island = SwellBuiltinSeafloor(
    registrationName="island",
    Seafloor="island:slope=0.2,shore-radius=12,toe-radius=20,xc=-15,x0=-50,y0=-50,x1=50,y1=50")
rays = SwellRays(registrationName="rays", Input=island, PeriodSeconds=4, DirectionFromDegrees=270, HeightMetres=0.5,
                 SpacingMetres=1, StepMetres=0.4, MaximumSpacingMetres=1.2)
heights = SwellHeights(registrationName="heights", Input=rays)
crests = SwellCrests(registrationName="crests", Input=heights)
waves = SwellMap(registrationName="map", Rays=heights, Seafloor=island, SpacingMetres=0.5)

LoadPalette("WhiteBackground")
heights_colors = GetColorTransferFunction("WaveHeight")
heights_colors.ApplyPreset("Viridis (matplotlib)", True)
heights_colors.NanColor = [0.76, 0.70, 0.55]

view = GetActiveViewOrCreate("RenderView")
view.ViewSize = [1000, 900]
view.InteractionMode = "2D"
chart = Show(waves, view)
chart.SetRepresentationType("Slice")
ColorBy(chart, ("POINTS", "WaveHeight"))
chart.SetScalarBarVisibility(view, True)
lines = Show(rays, view)
lines.ColorArrayName = ["POINTS", ""]
lines.DiffuseColor = lines.AmbientColor = [1, 1, 1]
lines.Position = [0, 0, 0.5]
tops = Show(crests, view)
tops.ColorArrayName = ["POINTS", ""]
tops.DiffuseColor = tops.AmbientColor = [0, 0, 0]
tops.Position = [0, 0, 0.6]
ResetCamera(view)
Render(view)

if "SWELLRAY_PLUGIN" in os.environ:
    SaveScreenshot(os.path.join(os.environ.get("SWELLRAY_OUTPUT", "."), "island-paraview.png"), view)
