"""The package and the program give the same numbers: they run the same filters."""

import unittest

import numpy
import swellray
from support import FolderCase, program, read_table, read_vtk

WAVE = {"period": 6, "direction": 15, "height": 0.8}
OPTIONS = ["--period", 6, "--direction", 15, "--height", 0.8, "--quiet"]

# What a table has of a number: ten digits.
PRINTED = 1e-9

# Written beside the data by the program, and by VTK.
OF_THE_FILE = {"CommandLine", "SwellrayVersion", "TimeValue"}


class SameAsProgram(FolderCase):
    @classmethod
    def setUpClass(cls):
        cls.seafloor = swellray.Seafloor.read("babbage")
        cls.rays = cls.seafloor.trace(**WAVE)

    def assert_same(self, result, path):
        expected = (swellray.Map if isinstance(result, swellray.Map) else swellray.Result)(read_vtk(path))
        self.assertGreater(len(expected), 0)
        numpy.testing.assert_array_equal(result.points, expected.points)
        self.assertEqual(sorted(result.names), sorted(expected.names))
        for name in expected.names:
            numpy.testing.assert_array_equal(result[name], expected[name], name)
        fields = expected.fields
        self.assertEqual(set(result.fields) - OF_THE_FILE, set(fields) - OF_THE_FILE)
        for name in set(fields) - OF_THE_FILE:
            numpy.testing.assert_array_equal(result.fields[name], fields[name], name)

    def test_rays_crests_breakers_and_map(self):
        names = [self.folder / name for name in ("rays.vtp", "crests.vtp", "breakers.vtp", "map.vti")]
        program("trace", "babbage", *OPTIONS, "-o", names[0], "--crests", names[1], "--breaker-line", names[2], "--map",
                names[3], "--map-spacing", 20)
        self.assert_same(self.rays, names[0])
        self.assert_same(self.rays.crests(), names[1])
        self.assert_same(self.rays.breaker_line(), names[2])
        self.assert_same(self.rays.map(spacing=20), names[3])

    def test_rays_with_options(self):
        path = self.folder / "rays.vtp"
        program("trace", "babbage", *OPTIONS, "--water-level", 0.5, "--spacing", 20, "--max-spacing", 25, "--insert",
                "interpolate", "--lee-rays", "off", "--edge", "none", "--breaking", "dally", "--caustics", "cap",
                "--kr-max", 2, "--amplitude", "tube", "--friction", 0.01, "--steps-per-wave", 4, "-o", path)
        rays = swellray.Seafloor.read("babbage", water_level=0.5).trace(
            **WAVE, spacing=20, max_spacing=25, insert="interpolate", lee_rays=False, edge="none", breaking="dally",
            caustics="cap", kr_max=2, amplitude="tube", friction=0.01, steps_per_wave=4)
        self.assert_same(rays, path)

    def test_rays_of_a_point(self):
        path = self.folder / "rays.vtp"
        program("trace", "babbage", "--period", 6, "--height", 0.8, "--from-point", "500,3000", "--quiet", "-o", path)
        self.assert_same(self.seafloor.trace(period=6, height=0.8, from_point=(500, 3000)), path)

    def test_contours(self):
        path = self.folder / "contours.vtp"
        program("contour", "babbage", "--levels", "2,5", "-o", path, "--quiet")
        self.assert_same(self.seafloor.contours([2, 5]), path)
        program("contour", "babbage", "--interval", 3, "--water-level", 1, "-o", path, "--quiet")
        self.assert_same(self.seafloor.at_water_level(1).contours(interval=3), path)

    def test_surface(self):
        path = self.folder / "surface.vtp"
        program("surface", "babbage", *OPTIONS, "--time", 3, "--profile", "jeschke", "-o", path)
        self.rays.surface(1.0, profile="jeschke")
        self.assert_same(self.rays.surface(3.0, profile="jeschke"), path)

    def test_spray(self):
        path = self.folder / "spray.vtp"
        program("surface", "babbage", *OPTIONS, "--time", 3, "--spray", path, "--spray-rate", 50)
        self.rays.spray(1.0, spray_rate=50)
        spray = self.rays.spray(3.0, spray_rate=50)
        self.assertGreater(len(spray), 100)
        self.assert_same(spray, path)

    def test_foam(self):
        path = self.folder / "foam.vti"
        program("surface", "babbage", *OPTIONS, "--time", 3, "--foam", path, "--foam-spacing", 5, "--foam-life", 4)
        self.rays.foam(1.0, foam_spacing=5)
        foam = self.rays.foam(3.0, foam_spacing=5, foam_life=4)
        self.assertGreater(numpy.count_nonzero(foam["Foam"] > 0), 50)
        self.assert_same(foam, path)

    def test_seen_surface(self):
        path = self.folder / "seen.vtp"
        program("surface", "babbage", *OPTIONS, "--time", 3, "--camera", "500,150,15,500,400,0", "--size", "500x400",
                "-o", path)
        seen = self.rays.seen_surface(3.0, camera=((500, 150, 15), (500, 400, 0)), size=(500, 400))
        self.assertGreater(len(seen), 500)
        self.assert_same(seen, path)
        with self.assertRaises(ValueError):
            self.rays.seen_surface(3.0, camera=(500, -20, 15))

    def test_surface_at(self):
        points, path = self.folder / "points.csv", self.folder / "series.csv"
        points.write_text("x,y\n500,700\n480,650\n")
        program("surface", "babbage", *OPTIONS, "--at", points, "--times", "0:2:0.5", "--table", path)
        times = numpy.repeat(numpy.arange(0.0, 2.1, 0.5), 2)
        values = self.rays.surface_at([[500, 700], [480, 650]] * 5, times)
        for i, name in enumerate(("NormalX", "NormalY", "NormalZ")):
            rows = read_table(path)
            numpy.testing.assert_allclose(values["Normals"][:, i], [float(row[name]) for row in rows], atol=1e-6)
        for name in ("SurfaceElevation", "Time", "Depth"):
            numpy.testing.assert_allclose(values[name], [float(row[name]) for row in rows], rtol=PRINTED, err_msg=name)

    def assert_same_table(self, result, path):
        rows = read_table(path)
        self.assertEqual(len(rows), len(result))
        for name in rows[0]:
            if name not in ("x", "y"):
                expected = [float(row[name]) if row[name] else numpy.nan for row in rows]
                numpy.testing.assert_allclose(result[name], expected, rtol=PRINTED, err_msg=name)

    def test_stations(self):
        places = [[500.0, 700.0], [480.0, 650.0]]
        points = self.folder / "points.csv"
        points.write_text("x,y\n500,700\n480,650\n")
        path = self.folder / "table.csv"
        program("trace", "babbage", *OPTIONS, "--stations", points, "--table", path)
        self.assert_same_table(self.rays.stations(places), path)
        program("spectrum", "babbage", "--hs", 0.8, "--tp", 6, "--direction", 15, "--stations", points, "--table", path,
                "--quiet")
        self.assert_same_table(self.seafloor.spectrum(hs=0.8, tp=6, direction=15, stations=places), path)

    def test_spectral_map(self):
        path = self.folder / "sea.vti"
        program("spectrum", "babbage", "--wind", 8, "--direction", 15, "--breaking", "none", "--frequencies", 6,
                "--directions", 12, "--map", path, "--map-spacing", 200, "--quiet")
        sea = self.seafloor.spectrum(wind=8, direction=15, breaking="none", frequencies=6, directions=12, spacing=200)
        expected = swellray.Map(read_vtk(path))
        numpy.testing.assert_array_equal(sea["SignificantWaveHeight"], expected["SignificantWaveHeight"])
        numpy.testing.assert_array_equal(sea["MeanDirectionFrom"], expected["MeanDirectionFrom"])

    def test_seas_of_kept_rays(self):
        rays = self.folder / "rays.nc"
        keywords = {"direction": 15, "stations": [[500, 700]], "frequency_range": (0.08, 0.4), "frequencies": 8,
                    "transfer": rays}
        first = self.seafloor.spectrum(hs=0.8, tp=6, **keywords)
        written = rays.stat().st_mtime_ns
        again = self.seafloor.spectrum(hs=0.8, tp=6, **keywords)
        self.assertEqual(rays.stat().st_mtime_ns, written)
        numpy.testing.assert_array_equal(first["SignificantWaveHeight"], again["SignificantWaveHeight"])

    def test_mild_slope(self):
        path, table, points = (self.folder / name for name in ("map.vti", "table.csv", "points.csv"))
        points.write_text("x,y\n-5,0\n0,0\n")
        program("trace", "berkhoff", "--period", 1, "--direction", 270, "--height", 0.0464, "--method", "mild-slope",
                "--node-spacing", 0.15, "--map", path, "--stations", points, "--table", table, "--quiet")
        waves, stations = swellray.Seafloor.read("berkhoff").mild_slope(
            period=1, direction=270, height=0.0464, node_spacing=0.15, stations=[[-5, 0], [0, 0]])
        self.assert_same(waves, path)
        self.assert_same_table(stations, table)

    def test_files_go_both_ways(self):
        self.rays.write(self.folder / "rays.vtp")
        again = swellray.Rays.read(self.folder / "rays.vtp", self.seafloor)
        numpy.testing.assert_array_equal(again.map(spacing=50)["WaveHeight"], self.rays.map(spacing=50)["WaveHeight"])
        self.rays.map(spacing=50).write(self.folder / "map.vti", compress=True)
        numpy.testing.assert_array_equal(swellray.Map(read_vtk(self.folder / "map.vti"))["WaveHeight"],
                                         self.rays.map(spacing=50)["WaveHeight"])
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["map.vti", "rays.vtp"])


if __name__ == "__main__":
    unittest.main()
