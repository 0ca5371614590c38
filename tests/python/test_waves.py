"""The package as it is used: against formulas, on arrays of one's own and on real seafloors."""

import gc
import unittest

import numpy
import swellray
from support import DATA
from swellray._run import output_of, run
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData

GRAVITY = 9.81

# Rays are integrated to 1e-8 a step; linear depths are exact on a spline.
SNELL = 1e-6
# Of a map of metres, whose files have coordinates of a million metres.
ROUNDING = 1e-6


def wavenumber(period, depth):
    """Linear dispersion relation by Newton's method, rad/m."""
    omega = 2 * numpy.pi / period
    k = omega**2 / GRAVITY / numpy.sqrt(numpy.tanh(omega**2 * depth / GRAVITY))
    for _ in range(30):
        t = numpy.tanh(k * depth)
        k -= (GRAVITY * k * t - omega**2) / (GRAVITY * (t + k * depth * (1 - t**2)))
    return k


class Waves(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.x = numpy.linspace(-1000.0, 100.0, 111)
        cls.y = numpy.linspace(-600.0, 600.0, 121)
        elevation = numpy.broadcast_to(0.02 * cls.x, (121, 111))
        cls.beach = swellray.Seafloor.from_array(elevation, cls.x, cls.y)
        cls.rays = cls.beach.trace(period=8, direction=250, height=1, spacing=20, breaking="none")

    def test_start_from_points_and_lines(self):
        offshore = {"period": 8, "height": 1, "offshore_depth": 20, "edge": "none", "spacing": 20}
        rays = self.beach.trace(from_point=(-1500.0, 0.0), **offshore)
        self.assertAlmostEqual(float(rays.fields["SourceDistance"]), 500.0, delta=0.1)
        line = [[-500.0, -200.0], [-500.0, 200.0]]
        rays = self.beach.trace(direction=270, launch=line, **offshore)
        numpy.testing.assert_allclose(numpy.sort(rays.points[:, 0])[0], -500.0, atol=1e-9)
        again = self.beach.trace(direction=270, launch=[line], **offshore)
        numpy.testing.assert_array_equal(again.points, rays.points)
        with self.assertRaisesRegex(TypeError, "one of direction, from_storm and from_point"):
            self.beach.trace(**offshore)
        with self.assertRaisesRegex(swellray.Error, "where on Earth"):
            self.beach.trace(from_storm=(170, -50), **offshore)

    def test_are_followed_back_from_a_site(self):
        ways = self.beach.ways((-300.0, 10.0), period=8, directions=36)
        self.assertEqual(len(ways["SiteDirectionFrom"]), 36)
        west = int(numpy.argmin(abs(ways["SiteDirectionFrom"] - 270.0)))
        self.assertAlmostEqual(ways["OffshoreDirectionFrom"][west], 270.0, places=9)

    def test_follow_snell_on_an_array(self):
        depth = self.rays["Depth"]
        wet = (depth > 1.0) & (self.rays["RayState"] == 1)
        self.assertGreater(numpy.count_nonzero(wet), 1000)
        k = wavenumber(8.0, depth[wet])
        deep = wavenumber(8.0, 1e4)
        sine = deep * numpy.sin(numpy.radians(20.0)) / k
        numpy.testing.assert_allclose(self.rays["Direction"][wet][:, 1], sine, rtol=SNELL)
        numpy.testing.assert_allclose(self.rays["Wavenumber"][wet], k, rtol=SNELL)

    def test_grids_have_rows_from_south_to_north(self):
        numpy.testing.assert_allclose(self.beach.x, self.x, atol=ROUNDING)
        numpy.testing.assert_allclose(self.beach.y, self.y, atol=ROUNDING)
        self.assertEqual(self.beach["Elevation"].shape, (121, 111))
        numpy.testing.assert_allclose(self.beach.depth[7], -0.02 * self.x, atol=1e-12)
        numpy.testing.assert_allclose(self.beach.at_water_level(1.5).depth[7], 1.5 - 0.02 * self.x, atol=1e-12)
        self.assertEqual(self.beach.extent, (-1005.0, 105.0, -605.0, 605.0))
        waves = self.rays.map(spacing=100)
        self.assertEqual(waves.shape, (13, 12))
        self.assertEqual(waves["WaveHeight"].shape, (13, 12))
        numpy.testing.assert_allclose(waves["Depth"], numpy.broadcast_to(-0.02 * waves.x, (13, 12)), atol=1e-9)

    def test_lines_are_slices_of_the_points(self):
        parts = self.rays.slices()
        self.assertEqual(len(parts), self.rays.number)
        self.assertEqual(parts[-1].stop, len(self.rays))
        for part in parts:
            self.assertTrue(numpy.all(numpy.diff(self.rays["TravelTime"][part]) >= 0))
        self.assertEqual(len(self.rays["LaunchParameter"]), self.rays.number)

    def test_arrays_outlive_their_results_and_are_read_only(self):
        heights = self.beach.trace(period=8, direction=250, height=1, spacing=20)["WaveHeight"]
        again = heights.copy()
        gc.collect()
        self.beach.trace(period=9, direction=260, height=2, spacing=20)
        numpy.testing.assert_array_equal(heights, again)
        with self.assertRaises(ValueError):
            heights[0] = 0.0

    def test_a_second_call_leaves_the_first_result_alone(self):
        first = self.rays.surface(0.0)
        before = first.points.copy()
        second = self.rays.surface(4.0)
        numpy.testing.assert_array_equal(first.points, before)
        self.assertEqual((first.time, second.time), (0.0, 4.0))
        self.assertGreater(numpy.abs(second.points - first.points).max(), 0.1)
        still = self.rays.heights(breaking="gamma")
        self.assertLess(numpy.nanmax(still["WaveHeight"] / numpy.maximum(still["Depth"], 0.1)), 0.79)
        self.assertGreater(numpy.nanmax(self.rays["WaveHeight"] / numpy.maximum(self.rays["Depth"], 0.1)), 0.79)

    def test_an_output_is_on_its_own(self):
        contours = swellray.vtkSwellContours()
        contours.SetInputData(self.beach.vtk)
        contours.AddLevel(5.0)
        run(contours)
        first = output_of(contours)
        contours.AddLevel(10.0)
        run(contours)
        self.assertEqual((first.GetNumberOfLines(), output_of(contours).GetNumberOfLines()), (1, 2))

    def test_results_are_data_sets_of_vtk(self):
        self.assertIsInstance(self.beach.vtk, vtkImageData)
        self.assertIsInstance(self.rays.vtk, vtkPolyData)
        self.assertIsInstance(self.rays.map(spacing=100).vtk, vtkImageData)
        self.assertIn("WaveHeight", self.rays)
        self.assertNotIn("Waves", self.rays)
        self.assertIn("rays", repr(self.rays))
        self.assertIn("12 x 13 nodes", repr(self.rays.map(spacing=100)))
        tracer = swellray.vtkSwellRayTracer()
        tracer.SetInputData(self.beach.vtk)
        tracer.Update()
        self.assertGreater(tracer.GetOutput().GetNumberOfLines(), 0)

    def test_threads_do_not_change_them(self):
        again = []
        for threads in (1, 2):
            swellray.set_threads(threads)
            again.append(self.beach.trace(period=8, direction=250, height=1, spacing=20, breaking="none"))
        swellray.set_threads(0)
        numpy.testing.assert_array_equal(again[0]["WaveHeight"], again[1]["WaveHeight"])


@unittest.skipUnless((DATA / "sites").is_dir(), "no real bathymetry: set SWELLRAY_DATA")
class RealSeafloors(unittest.TestCase):
    def test_a_projected_one(self):
        grid = DATA / "sites" / "egmond_nl" / "egmond_10m_epsg28992.tif"
        seafloor = swellray.Seafloor.read(grid, water_level=0.5, resample=40)
        self.assertIn("at water level 0.5 m", seafloor.report)
        corner = seafloor.to_file([[seafloor.x[0], seafloor.y[0]]])
        numpy.testing.assert_allclose(
            corner, [[seafloor.x[0] + seafloor.fields["OriginX"], seafloor.y[0] + seafloor.fields["OriginY"]]],
            rtol=1e-12)
        numpy.testing.assert_allclose(seafloor.to_scene(corner), [[seafloor.x[0], seafloor.y[0]]], atol=ROUNDING)
        rays = seafloor.trace(period=9, direction=280, height=1.5)
        middle = seafloor.to_file([[numpy.mean(seafloor.x), numpy.mean(seafloor.y)]])
        at = [rays.stations(middle), rays.stations(seafloor.to_scene(middle), coordinates="scene")]
        self.assertEqual(at[0]["Depth"], at[1]["Depth"])

    def test_one_in_longitude_and_latitude(self):
        grid = DATA / "sites" / "hawaii_islands" / "hawaii_etopo1.nc"
        seafloor = swellray.Seafloor.read(grid, crop=(-158.5, 21.0, -157.5, 22.0))
        places = numpy.array([[-158.2, 21.3], [-157.6, 21.9]])
        # The geodesic on WGS 84 by Vincenty 1975; the map's scale is off by less than (30 km / 6378 km)^2 / 2.
        length = numpy.hypot(*numpy.diff(seafloor.to_scene(places), axis=0)[0])
        self.assertAlmostEqual(length / 90959.5, 1.0, delta=1.2e-5)
        numpy.testing.assert_allclose(seafloor.to_file(seafloor.to_scene(places)), places, atol=1e-9)


if __name__ == "__main__":
    unittest.main()
