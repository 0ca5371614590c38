"""Every filter of the plugin on a real coast, and the program beside it: the same numbers."""

import numpy
from plugin_support import DATA, OUTPUT, arrays_of, assert_same, fetch, load_plugin, need, program, servermanager

pv = load_plugin()
grid = need(DATA / "sites" / "egmond_nl" / "egmond_10m_epsg28992.tif")
stations = [(102400.0, 515000.0), (102000.0, 514000.0)]

read = [grid, "--resample", 40, "--water-level", 0.5]
wave = ["--period", 9, "--direction", 280, "--height", 1.5]
files = {name: OUTPUT / name for name in ("rays.vtp", "crests.vtp", "breakers.vtp", "map.vti", "contours.vtp",
                                          "surface.vtp", "table.csv")}
(OUTPUT / "points.csv").write_text("x,y\n" + "".join(f"{x},{y}\n" for x, y in stations))
program("trace", *read, *wave, "--breaking", "dally", "-o", files["rays.vtp"], "--crests", files["crests.vtp"],
        "--breaker-line", files["breakers.vtp"], "--map", files["map.vti"], "--map-spacing", 80, "--stations",
        OUTPUT / "points.csv", "--table", files["table.csv"])
program("contour", *read, "--levels", "5,10", "-o", files["contours.vtp"])
program("surface", *read, *wave, "--breaking", "dally", "--spacing", 100, "--time", 3, "--profile", "jeschke", "-o",
        files["surface.vtp"])

seafloor = pv.SwellSeafloorReader(FileName=grid, ResampleMetres=40, WaterLevelMetres=0.5)
common = {"PeriodSeconds": 9, "DirectionFromDegrees": 280, "HeightMetres": 1.5, "WaterLevelMetres": 0.5}
rays = pv.SwellRays(Input=seafloor, **common)
heights = pv.SwellHeights(Input=rays, Breaking="Dally, Dean and Dalrymple 1985")
assert_same(heights, files["rays.vtp"])
assert_same(pv.SwellCrests(Input=heights), files["crests.vtp"])
assert_same(pv.SwellBreakerLine(Rays=heights, Seafloor=seafloor), files["breakers.vtp"])
assert_same(pv.SwellMap(Rays=heights, Seafloor=seafloor, SpacingMetres=80), files["map.vti"])
assert_same(pv.SwellContours(Input=seafloor, WaterLevelMetres=0.5, DepthsMetres=[5, 10]), files["contours.vtp"])

# Stations, from the coordinates of the file.
table = pv.CSVReader(FileName=[str(OUTPUT / "points.csv")])
points = pv.TableToPoints(Input=table, XColumn="x", YColumn="y", a2DPoints=1)
places = pv.SwellPlaces(Points=points, Seafloor=seafloor)
waves = arrays_of(fetch(pv.SwellStations(Rays=heights, Seafloor=seafloor, Points=places)))
rows = [line.split(",") for line in files["table.csv"].read_text().splitlines()]
for name in ("Depth", "WaveHeight", "DirectionFrom"):
    expected = [float(row[rows[0].index(name)]) for row in rows[1:]]
    numpy.testing.assert_allclose(waves["point " + name], expected, rtol=1e-9)

# Time plays.
few = pv.SwellHeights(Input=pv.SwellRays(Input=seafloor, SpacingMetres=100, **common), Breaking=heights.Breaking)
surface = pv.SwellSurface(Rays=few, Seafloor=seafloor, Section="jeschke", TimesSeconds=[0, 9], TimeStepSeconds=1.5)
foam = pv.SwellFoam(Input=surface)
assert list(surface.TimestepValues) == [0, 1.5, 3, 4.5, 6, 7.5, 9], surface.TimestepValues
assert list(pv.GetTimeKeeper().TimestepValues) == list(surface.TimestepValues)
foam.UpdatePipeline(3.0)
assert_same(foam, files["surface.vtp"])
first = arrays_of(servermanager.Fetch(foam))["points"].copy()
foam.UpdatePipeline(6.0)
assert numpy.abs(arrays_of(servermanager.Fetch(foam))["points"] - first).max() > 0.1

# The mild-slope equation, with and without points; a sea.
shoal = pv.SwellBuiltinSeafloor(Seafloor="berkhoff")
program("trace", "berkhoff", "--period", 1, "--direction", 270, "--height", 0.0464, "--method", "mild-slope",
        "--node-spacing", 0.15, "--map", OUTPUT / "mild.vti")
mild = pv.SwellMildSlope(Seafloor=shoal, PeriodSeconds=1, DirectionFromDegrees=270, HeightMetres=0.0464, NodeSpacingMetres=0.15)
assert_same(mild, OUTPUT / "mild.vti")
at = pv.SwellMildSlope(Seafloor=shoal, Points=pv.PointSource(NumberOfPoints=1, Radius=0), PeriodSeconds=1,
                       DirectionFromDegrees=270, HeightMetres=0.0464, NodeSpacingMetres=0.15)
heights_at = arrays_of(fetch(at, 1))["point WaveHeight"]
assert heights_at.shape == (1,), heights_at

program("spectrum", "babbage", "--hs", 1, "--tp", 6, "--direction", 15, "--map", OUTPUT / "sea.vti", "--map-spacing", 200)
coast = pv.SwellBuiltinSeafloor(Seafloor="babbage")
nodes = pv.XMLImageDataReader(FileName=[str(OUTPUT / "sea.vti")])
sea = pv.SwellSea(Places=nodes, Seafloor=coast, SignificantHeightMetres=1, PeakPeriodSeconds=6,
                  DirectionFromDegrees=15)
assert_same(sea, OUTPUT / "sea.vti")
