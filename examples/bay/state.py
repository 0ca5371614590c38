"""Waves into a bay, as a state of ParaView: `paraview --state=state.py` with the plugin Swellray loaded, or

    SWELLRAY_PLUGIN=.../Swellray.so pvpython state.py

which writes a picture into SWELLRAY_OUTPUT (here, unless set)."""

import os

from paraview.simple import *

if "SWELLRAY_PLUGIN" in os.environ:
    LoadPlugin(os.environ["SWELLRAY_PLUGIN"], remote=False, ns=globals())

bay = SwellBuiltinSeafloor(registrationName="bay", Seafloor="bay")
rays = SwellRays(registrationName="rays", Input=bay, PeriodSeconds=3, DirectionFromDegrees=90, HeightMetres=0.4,
                 SpacingMetres=1, StepMetres=0.4, MaximumSpacingMetres=1.2)
heights = SwellHeights(registrationName="heights", Input=rays)
contours = SwellContours(registrationName="contours", Input=bay, IntervalMetres=1)
surface = SwellSurface(registrationName="surface", Rays=heights, Seafloor=bay, TimesSeconds=[0, 6],
                       TimeStepSeconds=0.1)
foam = SwellFoam(registrationName="foam", Input=surface)
land = WarpByScalar(registrationName="land", Input=bay, Scalars=["POINTS", "Elevation"])

LoadPalette("WhiteBackground")
heights_colors = GetColorTransferFunction("WaveHeight")
heights_colors.ApplyPreset("Viridis (matplotlib)", True)
heights_colors.NanColor = [0.76, 0.70, 0.55]

view = GetActiveViewOrCreate("RenderView")
view.ViewSize = [1200, 800]
for source, color in ((rays, [1, 1, 1]), (contours, [0.3, 0.25, 0.2])):
    line = Show(source, view)
    line.ColorArrayName = ["POINTS", ""]
    line.DiffuseColor = line.AmbientColor = color
ground = Show(land, view)
ground.ColorArrayName = ["POINTS", ""]
ground.DiffuseColor = [0.76, 0.70, 0.55]
water = Show(foam, view)
ColorBy(water, ("POINTS", "WaveHeight"))
water.SetScalarBarVisibility(view, True)
water.Opacity = 0.85

view.CameraPosition = [105, -75, 65]
view.CameraFocalPoint = [12, 0, 0]
view.CameraViewUp = [0, 0, 1]
GetAnimationScene().AnimationTime = 3.0
Render(view)

if "SWELLRAY_PLUGIN" in os.environ:
    SaveScreenshot(os.path.join(os.environ.get("SWELLRAY_OUTPUT", "."), "bay-paraview.png"), view)
