"""State files of a pipeline, loaded again, give the same; readers are offered for their kinds of files."""

import numpy
from paraview import smstate
from plugin_support import OUTPUT, arrays_of, fetch, load_plugin, servermanager

pv = load_plugin()


def make_pipeline():
    seafloor = pv.SwellBuiltinSeafloor(registrationName="seafloor", Seafloor="babbage:offshore-depth=9", WaterLevelMetres=0.25)
    rays = pv.SwellRays(registrationName="rays", Input=seafloor, PeriodSeconds=7, DirectionFromDegrees=20,
                        HeightMetres=0.7, WaterLevelMetres=0.25, Insertion="Interpolated", LeeRays=0, MaximumRays=5000)
    heights = pv.SwellHeights(registrationName="heights", Input=rays, Breaking="Miche", BottomFriction=0.01)
    pv.SwellContours(registrationName="contours", Input=seafloor, WaterLevelMetres=0.25, DepthsMetres=[1, 2, 3])
    pv.SwellMap(registrationName="map", Rays=heights, Seafloor=seafloor, SpacingMetres=25, Combine="Waves interfere")


def results():
    return {name: arrays_of(fetch(pv.FindSource(name))) for name in ("heights", "contours", "map")}


make_pipeline()
before = results()
assert before["heights"]["point WaveHeight"].size > 1000
assert before["heights"]["field Period"][0] == 7 and before["heights"]["field WaterLevel"][0] == 0.25
before = {name: {key: numpy.array(values) for key, values in arrays.items()} for name, arrays in before.items()}
pv.SaveState(str(OUTPUT / "state.pvsm"))
script = smstate.get_state()
for load in (lambda: pv.LoadState(str(OUTPUT / "state.pvsm")),
             lambda: exec(compile(script, "state.py", "exec"), {"__name__": "state"})):
    pv.ResetSession()
    assert pv.FindSource("heights") is None
    load()
    for name, arrays in results().items():
        assert set(arrays) == set(before[name]), name
        for key, values in arrays.items():
            numpy.testing.assert_array_equal(values, before[name][key], f"{name}: {key}")

# Every kind of file is offered to the reader, and kinds that nobody else reads are opened by it.
factory = servermanager.vtkSMProxyManager.GetProxyManager().GetReaderFactory()
session = servermanager.ActiveConnection.Session
for ending in ("tif", "asc", "nc", "grd", "dep", "swn", "sim", "vti", "vts", "vtu", "xyz", "csv", "txt"):
    path = OUTPUT / f"seafloor.{ending}"
    path.write_text("")
    readers = factory.GetReaders(str(path), session)
    names = [readers.GetString(i) for i in range(readers.GetNumberOfStrings())]
    assert "SwellSeafloorReader" in names, (ending, names)
grid = OUTPUT / "beach.asc"
grid.write_text("ncols 4\nnrows 4\nxllcorner 0\nyllcorner 0\ncellsize 10\n" + "-3 -2 -1 1\n" * 4)
seafloor = pv.OpenDataFile(str(grid))
assert seafloor.GetXMLName() == "SwellSeafloorReader", seafloor
assert arrays_of(fetch(seafloor))["point Elevation"].min() == -3

# What is wrong is said, and does not end ParaView.
bad = pv.SwellRays(Input=seafloor, PeriodSeconds=-1)
bad.UpdatePipeline()
assert fetch(bad).GetNumberOfPoints() == 0
