"""The plugin is there without being loaded: that is what paraview-swellray is for."""

import paraview.simple as pv
from paraview import servermanager

plugins = servermanager.vtkSMProxyManager.GetProxyManager().GetPluginManager().GetLocalInformation()
loaded = [plugins.GetPluginFileName(i) for i in range(plugins.GetNumberOfPlugins()) if plugins.GetPluginName(i) == "Swellray"]
assert len(loaded) == 1 and loaded[0].endswith("/plugins/Swellray/Swellray.so"), loaded

bay = pv.SwellBuiltinSeafloor(Seafloor="bay")
rays = pv.SwellRays(Input=bay, PeriodSeconds=3, DirectionFromDegrees=90, HeightMetres=0.4)
rays.UpdatePipeline()
assert rays.GetDataInformation().GetNumberOfCells() > 100
print(loaded[0])
