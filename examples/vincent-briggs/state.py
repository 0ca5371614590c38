"""The whole wave over the shoal of Vincent and Briggs, with rays, as a state of ParaView: `paraview --state=state.py` with the plugin Swellray loaded, or

    SWELLRAY_PLUGIN=.../Swellray.so pvpython state.py

which writes a picture into SWELLRAY_OUTPUT (here, unless set)."""

import os

from paraview.simple import *

if "SWELLRAY_PLUGIN" in os.environ:
    LoadPlugin(os.environ["SWELLRAY_PLUGIN"], remote=False, ns=globals())

shoal = SwellBuiltinSeafloor(registrationName="shoal", Seafloor="vincent-briggs")
wave = dict(PeriodSeconds=1.3, DirectionFromDegrees=270, HeightMetres=0.0254, OffshoreDepthMetres=0.4572)
waves = SwellMildSlope(registrationName="waves", Seafloor=shoal, Breaking="None", MapSpacingMetres=0.05, **wave)
rays = SwellRays(registrationName="rays", Input=shoal, SpacingMetres=0.5, Insertion="None", **wave)

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
lines.Position = [0, 0, 0.5]
ResetCamera(view)
Render(view)

if "SWELLRAY_PLUGIN" in os.environ:
    SaveScreenshot(os.path.join(os.environ.get("SWELLRAY_OUTPUT", "."), "vincent-briggs-paraview.png"), view)
