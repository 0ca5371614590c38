"""Seas: at stations in time, and their surface, against the program and the heights that were asked for."""

import unittest

import numpy
import swellray
from support import FolderCase, program, read_table, read_vtk
from vtkmodules.util.numpy_support import vtk_to_numpy

SEA = {"hs": 2, "tp": 10, "direction": 90, "frequencies": 4, "directions": 16}
PLACES = [(50.0, 100.0), (500.0, 100.0), (-90.0, 0.0)]  # the last is land
# The table of the program has five digits after the point.
ROUNDED = 5.001e-6


def arguments(settings):
    return [text for name, value in settings.items() for text in ("--" + name, str(value))]


class ElevationSeries(FolderCase):
    @classmethod
    def setUpClass(cls):
        cls.seafloor = swellray.Seafloor.read("plane:x0=-100,x1=2000")
        cls.sea = cls.seafloor.spectrum(**SEA, stations=PLACES, elevation_series=True, duration=300, seed=7)

    def test_has_the_height_of_its_sea(self):
        height = self.sea["SignificantWaveHeight"]
        # But for what lies beyond half of the sampling frequency, 1 Hz, the record has just the Hs of the spectrum.
        numpy.testing.assert_allclose(4 * numpy.std(self.sea.elevations[:2], axis=1), height[:2], rtol=1e-3)
        self.assertTrue(numpy.isnan(self.sea.elevations[2]).all())
        self.assertEqual(len(self.sea.times), self.sea.elevations.shape[1])
        self.assertGreaterEqual(self.sea.times[-1] + 0.5, 300)

    def test_is_that_of_the_program(self):
        places, table = self.folder / "places.csv", self.folder / "table.csv"
        places.write_text("".join(f"{x},{y}\n" for x, y in PLACES))
        program("spectrum", "plane:x0=-100,x1=2000", *arguments(SEA), "--stations", places, "--elevation-series", table,
                "--duration", 300, "--seed", 7, "--quiet")
        rows = read_table(table)
        self.assertEqual(len(rows), len(self.sea.times))
        for station in (0, 1):
            found = [float(row[f"Elevation{station + 1}"]) for row in rows]
            numpy.testing.assert_allclose(found, self.sea.elevations[station], rtol=0, atol=ROUNDED)

    def test_goes_by_its_seed(self):
        def again(seed):
            return self.seafloor.spectrum(**SEA, stations=PLACES, elevation_series=True, duration=300, seed=seed).elevations

        numpy.testing.assert_array_equal(again(7), self.sea.elevations)
        self.assertGreater(numpy.abs(again(8)[0] - self.sea.elevations[0]).max(), 0.1)

    def test_says_what_is_wrong(self):
        with self.assertRaisesRegex(TypeError, "elevation_series is of stations"):
            self.seafloor.spectrum(**SEA, elevation_series=True)
        with self.assertRaisesRegex(swellray.Error, "too short"):
            self.seafloor.spectrum(**SEA, stations=PLACES, elevation_series=True, duration=10)
        with self.assertRaisesRegex(swellray.Error, "2 to a million samples"):
            self.seafloor.spectrum(**SEA, stations=PLACES, elevation_series=True, interval=1e-6)


class Sea(FolderCase):
    state = {"hs": 1, "tp": 5, "direction": 240, "size": 100, "spacing": 4, "components": 40, "time": 2.5, "seed": 3}

    def test_is_that_of_the_program(self):
        surface = swellray.sea(**self.state)
        path = self.folder / "sea.vtp"
        program("sea", *arguments(self.state), "-o", path, "--quiet")
        expected = vtk_to_numpy(read_vtk(path).GetPointData().GetArray("SurfaceHeight"))
        numpy.testing.assert_array_equal(surface["SurfaceHeight"], expected)
        self.assertEqual(surface.time, 2.5)
        first = swellray.sea(**self.state | {"time": 0})["SurfaceHeight"]
        self.assertGreater(numpy.abs(surface["SurfaceHeight"] - first).max(), 0.1)

    def test_of_pixels_is_a_map_that_tiles(self):
        image = swellray.sea(hs=1, tp=5, direction=240, size=150, tile=True, pixels=64)
        self.assertEqual(image["SurfaceHeight"].shape, (64, 64))
        self.assertEqual(image["Normals"].shape, (64, 64, 3))
        height = image["SurfaceHeight"]
        # Across its edge the surface goes on no more steeply than anywhere else.
        steepest = numpy.abs(numpy.diff(height, axis=1)).max()
        self.assertLessEqual(numpy.abs(height[:, 0] - height[:, -1]).max(), 1.2 * steepest)

    def test_spreads_as_it_is_told(self):
        narrow = swellray.sea(**self.state, spread=5, turbulence=False)
        self.assertGreater(
            numpy.abs(narrow["SurfaceHeight"] - swellray.sea(**self.state, turbulence=False)["SurfaceHeight"]).max(), 0.05)
        numpy.testing.assert_array_equal(narrow["SurfaceHeight"],
            swellray.sea(**self.state, spread=5, spreading="cosine", turbulence=False)["SurfaceHeight"])

    def test_says_what_is_wrong(self):
        with self.assertRaisesRegex(TypeError, "hs and tp, or wind"):
            swellray.sea(direction=0)
        with self.assertRaisesRegex(TypeError, "hs and tp, or wind"):
            swellray.sea(direction=0, hs=1, tp=5, wind=10)
        with self.assertRaisesRegex(ValueError, "'cosine' or 'normal'"):
            swellray.sea(direction=0, hs=1, tp=5, spread=20, spreading="thon")
        with self.assertRaisesRegex(swellray.Error, "too small"):
            swellray.sea(direction=0, hs=1, tp=8, size=50, tile=True)


if __name__ == "__main__":
    unittest.main()
