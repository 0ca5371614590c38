"""What goes wrong is an exception with the line of the filter."""

import os
import signal
import unittest
import warnings

import numpy
import swellray
from support import FolderCase
from swellray._run import run

WAVE = {"period": 8.0, "direction": 270.0, "height": 1.0}


class Errors(FolderCase):
    @classmethod
    def setUpClass(cls):
        cls.seafloor = swellray.Seafloor.read("plane:facing=270")

    def test_are_the_lines_of_the_filters(self):
        with self.assertRaisesRegex(swellray.Error, r"^period must be above 0 s, not -1"):
            self.seafloor.trace(**{**WAVE, "period": -1})
        with self.assertRaisesRegex(swellray.Error, r"^[^\n]*no such file[^\n]*$"):
            swellray.Seafloor.read("nowhere.tif")
        with self.assertRaisesRegex(swellray.Error, "did you mean 'plane'"):
            swellray.Seafloor.read("plnae")
        with self.assertRaisesRegex(swellray.Error, "latitude|no number"):
            self.seafloor.to_scene([[numpy.nan, 0.0]])

    def test_of_words_list_the_choices(self):
        with self.assertRaisesRegex(ValueError, "scheme must be one of ode, snell, not 'od'; did you mean 'ode'"):
            self.seafloor.trace(**WAVE, scheme="od")
        with self.assertRaisesRegex(ValueError, "coordinates must be 'file' or 'scene'"):
            self.seafloor.trace(**WAVE).stations([[0, 0]], coordinates="map")

    def test_of_types_name_the_keyword(self):
        with self.assertRaisesRegex(TypeError, "period cannot be 'ten'"):
            self.seafloor.trace(**{**WAVE, "period": "ten"})
        with self.assertRaisesRegex(TypeError, "perid"):
            self.seafloor.trace(**WAVE, perid=3)
        with self.assertRaisesRegex(TypeError, "direction with hs and tp"):
            self.seafloor.spectrum(hs=1.0, direction=270.0)
        with self.assertRaisesRegex(TypeError, "one of direction, from_storm and from_point"):
            self.seafloor.trace(**WAVE, from_storm=(170, -50))
        with self.assertRaisesRegex(TypeError, "one of direction, from_storm and from_point"):
            self.seafloor.trace(period=8, height=1)
        with self.assertRaisesRegex(ValueError, r"\(n, 2\)"):
            self.seafloor.to_scene([1.0, 2.0, 3.0, 4.0])

    def test_of_names_suggest_the_nearest(self):
        with self.assertRaisesRegex(KeyError, "did you mean 'WaveHeight'"):
            self.seafloor.trace(**WAVE)["Waveheight"]

    def test_of_files(self):
        rays = self.seafloor.trace(**WAVE)
        with self.assertRaisesRegex(ValueError, "must end in .vtp"):
            rays.write(self.folder / "rays.vti")
        with self.assertRaises(FileNotFoundError):
            rays.write(self.folder / "nowhere" / "rays.vtp")
        with self.assertRaises(FileNotFoundError):
            swellray.Rays.read(self.folder / "rays.vtp", self.seafloor)
        (self.folder / "rays.vtp").write_text("no rays")
        with self.assertRaises(swellray.Error):
            swellray.Rays.read(self.folder / "rays.vtp", self.seafloor)
        self.seafloor.contours([5]).write(self.folder / "rays.vtp")
        with self.assertRaisesRegex(swellray.Error, "has no rays"):
            swellray.Rays.read(self.folder / "rays.vtp", self.seafloor)
        self.assertEqual(os.listdir(self.folder), ["rays.vtp"])

    def test_of_arrays(self):
        elevation = numpy.full((5, 6), -10.0)
        with self.assertRaisesRegex(ValueError, r"shape \(5, 6\); x and y ask for \(6, 5\)"):
            swellray.Seafloor.from_array(elevation, range(5), range(6))
        with self.assertRaisesRegex(ValueError, "x must rise in equal steps"):
            swellray.Seafloor.from_array(elevation, [0, 1, 2, 3, 5, 6], range(5))
        with self.assertRaisesRegex(ValueError, "y must rise in equal steps"):
            swellray.Seafloor.from_array(elevation, range(6), [4, 3, 2, 1, 0])

    def test_warnings_are_notices(self):
        with self.assertWarnsRegex(swellray.Notice, "the cap of 20 fronts was reached") as caught:
            self.seafloor.trace(**WAVE, max_fronts=20)
        self.assertEqual(caught.filename, __file__)

    def test_nothing_is_printed(self):
        read, write = os.pipe()
        kept = os.dup(2)
        os.dup2(write, 2)
        try:
            with self.assertRaises(swellray.Error):
                self.seafloor.trace(**{**WAVE, "height": 0})
        finally:
            os.dup2(kept, 2)
            os.close(kept)
            os.close(write)
        with os.fdopen(read) as printed:
            self.assertEqual(printed.read(), "")


class Progress(unittest.TestCase):
    def setUp(self):
        self.seafloor = swellray.Seafloor.read("plane:facing=270")

    def test_goes_to_the_end(self):
        shares = []
        self.seafloor.trace(**WAVE, progress=shares.append)
        self.assertGreater(len(shares), 2)
        self.assertEqual(shares, sorted(shares))
        self.assertLessEqual(shares[-1], 1.0)

    def test_what_it_raises_ends_the_work(self):
        calls = []

        def stop(share):
            calls.append(share)
            raise TimeoutError("long enough")

        with self.assertRaisesRegex(TimeoutError, "long enough"), warnings.catch_warnings():
            warnings.simplefilter("error")
            self.seafloor.trace(**WAVE, progress=stop)
        self.assertEqual(len(calls), 1)

    def test_the_work_has_ended_then(self):
        tracer = swellray.vtkSwellRayTracer()
        tracer.SetInputData(self.seafloor.vtk)
        with self.assertRaises(ZeroDivisionError):
            run(tracer, lambda share: 1 / 0)
        reasons = swellray.Result(tracer.GetOutput())["EndReason"]
        self.assertIn(5, reasons)
        run(tracer)
        self.assertNotIn(5, swellray.Result(tracer.GetOutput())["EndReason"])

    def test_an_interrupt_is_the_users(self):
        # The interpreter takes a signal between two of its own steps: the next report of progress.
        with self.assertRaises(KeyboardInterrupt):
            self.seafloor.trace(**WAVE, progress=lambda share: signal.raise_signal(signal.SIGINT))
        self.assertGreater(self.seafloor.trace(**WAVE).number, 0)


if __name__ == "__main__":
    unittest.main()
