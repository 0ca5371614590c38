"""Keywords, words and docstrings against the filters and against the options of the program."""

import inspect
import re
import unittest

import swellray
from support import program
from swellray import _options

# Of the program: files to write, and what is another call here.
ELSEWHERE = {
    "trace": {"output", "crests", "breaker_line", "map", "stations", "table", "water_levels", "compress", "points",
              "map_spacing", "combine", "method", "dispersion", "node_spacing", "min_depth", "coast_reflection",
              "side_walls", "max_memory", "dry_run", "from_site", "directions"},
    "spectrum": {"map", "table", "spectra", "map_spacing", "compress", "series", "dry_run"},
    "sea": {"output", "height_map", "normal_map", "picture", "picture_size", "compress", "times", "eye", "look"},
    "contour": {"output", "compress", "points"},
    "surface": {"output", "compress", "times", "spray", "foam", "at", "table", "component", "dry_run"},
}
COMMON = {"config", "threads", "quiet", "help"}
SEAFLOOR = {"water_level", "positive", "crs", "crop", "resample", "smooth", "nodata", "variable", "max_gap",
            "drop_outliers", "earth"}


def keywords_of(function):
    return set(inspect.signature(function).parameters) - {"self", "cls", "progress", "coordinates"}


def options_of(command):
    names = re.findall(r"--([a-z-]+)", re.sub(r"Examples:.*", "", program(command, "--help"), flags=re.S))
    lines = re.findall(r"^  (?:-\w,)?--([a-z-]+)", program(command, "--help"), flags=re.M)
    assert set(lines) <= set(names)
    return {name.replace("-", "_") for name in lines} - COMMON


class Options(unittest.TestCase):
    def assert_options(self, command, keywords):
        options = options_of(command) - ELSEWHERE[command]
        self.assertEqual(options - keywords, set(), f"options of {command} without a keyword in filters/python/swellray; "
                         "add it there, or to ELSEWHERE here if the program alone has it")
        self.assertEqual(keywords - options, set(), f"keywords that are no options of {command}")

    def test_are_those_of_the_program(self):
        self.assertEqual(keywords_of(swellray.Seafloor.read) - {"source"}, SEAFLOOR)
        trace = keywords_of(swellray.Seafloor.trace)
        self.assert_options("trace", SEAFLOOR | trace)
        self.assert_options("contour", SEAFLOOR | keywords_of(swellray.Seafloor.contours))
        self.assert_options("surface", SEAFLOOR | trace | keywords_of(swellray.Rays.surface) |
                            keywords_of(swellray.Rays.spray) | keywords_of(swellray.Rays.foam) |
                            keywords_of(swellray.Rays.seen_surface))
        self.assert_options("spectrum", SEAFLOOR | keywords_of(swellray.Seafloor.spectrum) - {"spacing"})
        self.assert_options("sea", keywords_of(swellray.sea))

    def test_friction_may_be_laminar(self):
        heights = _options.configure(swellray.vtkSwellWaveHeight(), friction="laminar")
        self.assertEqual((heights.GetViscosity(), heights.GetFriction()), (1e-6, 0.0))
        self.assertEqual(_options.configure(swellray.vtkSwellMildSlope(), friction="laminar:1.3e-6").GetViscosity(), 1.3e-6)
        with self.assertRaises(TypeError):
            _options.configure(swellray.vtkSwellSpectralMap(), friction="laminar")

    def test_words_are_those_of_the_filters(self):
        number = _options.number_of_choice
        tracer, heights, surface = swellray.vtkSwellRayTracer, swellray.vtkSwellWaveHeight, swellray.vtkSwellSurface
        reader, mild, sea = swellray.vtkSwellSeafloorReader, swellray.vtkSwellMildSlope, swellray.vtkSwellSpectralMap
        expected = {
            "amplitude": {"spacing": heights.SPACING, "tube": heights.TUBE},
            "breaking": {"none": heights.NO_BREAKING, "gamma": heights.GAMMA_BREAKING,
                         "weggel": heights.WEGGEL_BREAKING, "miche": heights.MICHE_BREAKING,
                         "dally": heights.DALLY_BREAKING, "battjes-janssen": heights.BATTJES_JANSSEN_BREAKING,
                         "baldock": heights.BALDOCK_BREAKING},
            "caustics": {"uniform": heights.UNIFORM, "geometric": heights.GEOMETRIC, "cap": heights.CAP},
            "combine": {"energy": swellray.vtkSwellMap.ENERGY, "phase": swellray.vtkSwellMap.PHASE},
            "dispersion": {"linear": mild.LINEAR, "nonlinear": mild.NONLINEAR},
            "earth": {"plane": reader.PLANE, "ellipsoid": reader.ELLIPSOID},
            "edge": {"contours": tracer.EDGE_CONTOURS, "edge": tracer.EDGE_EDGE, "none": tracer.EDGE_NONE},
            "insert": {"none": tracer.INSERT_NONE, "retrace": tracer.INSERT_RETRACE,
                       "interpolate": tracer.INSERT_INTERPOLATE},
            "phase": {"traced": surface.TRACED, "straight": surface.STRAIGHT},
            "positive": {"auto": reader.AUTO, "up": reader.UP, "down": reader.DOWN},
            "scheme": {"ode": tracer.ODE, "snell": tracer.SNELL},
            "shape": {"jonswap": sea.JONSWAP, "pierson-moskowitz": sea.PIERSON_MOSKOWITZ, "tma": sea.TMA},
            "spreading": {"hasselmann": swellray.vtkSwellSea.HASSELMANN, "thon": swellray.vtkSwellSea.THON,
                          "cosine": swellray.vtkSwellSea.COSINE_POWER, "normal": swellray.vtkSwellSea.WRAPPED_NORMAL},
        }
        self.assertEqual(set(_options.CHOICES), set(expected))
        for keyword, words in expected.items():
            self.assertEqual({word: number(keyword, word) for word in _options.CHOICES[keyword]}, words, keyword)
        for rules in (mild, sea):
            self.assertEqual((rules.EDGE_CONTOURS, rules.EDGE_EDGE, rules.EDGE_NONE), (0, 1, 2))

    def test_keywords_are_properties_of_their_own(self):
        for function, kinds, elsewhere in (
            (swellray.Seafloor.read, [swellray.vtkSwellSeafloorReader], set()),
            (swellray.Seafloor.contours, [swellray.vtkSwellContours], {"levels"}),
            (swellray.Seafloor.trace, [swellray.vtkSwellRayTracer, swellray.vtkSwellWaveHeight],
             {"from_storm", "from_point", "launch"}),
            (swellray.Seafloor.ways, [swellray.vtkSwellBackwardRays], {"site"}),
            (swellray.Seafloor.mild_slope, [swellray.vtkSwellMildSlope], {"stations"}),
            (swellray.Seafloor.spectrum, [swellray.vtkSwellSpectralMap],
             {"stations", "spacing", "breaking", "elevation_series", "duration", "interval", "seed"}),
            (swellray.sea, [swellray.vtkSwellSea], {"pixels", "size"}),
            (swellray.Rays.heights, [swellray.vtkSwellWaveHeight], set()),
            (swellray.Rays.map, [swellray.vtkSwellMap], set()),
            (swellray.Rays.surface, [swellray.vtkSwellSurface], {"foam_life"}),
            (swellray.Rays.surface_at, [swellray.vtkSwellSurfaceProbe], {"places"}),
            (swellray.Rays.foam, [swellray.vtkSwellFoamMap], set()),
            (swellray.Rays.seen_surface, [swellray.vtkSwellProjectedGrid], {"camera"}),
            (swellray.Rays.spray, [swellray.vtkSwellSpray], set()),
        ):
            keywords = sorted(keywords_of(function) - elsewhere)
            properties = [_options.property_of(keyword) for keyword in keywords]
            self.assertEqual(len(set(properties)), len(keywords), function.__name__)
            for name in properties:
                self.assertTrue(any(hasattr(kind, "Set" + name) for kind in kinds), f"{function.__name__}: {name}")

    def test_words_are_those_of_the_program(self):
        for command in ("trace", "spectrum", "surface", "sea"):
            for name, words in re.findall(r"--([a-z-]+) ([a-z-]+(?:\|[a-z-]+)+)", program(command, "--help")):
                if name.replace("-", "_") in _options.CHOICES and (command, name) != ("spectrum", "breaking"):
                    self.assertEqual(set(words.split("|")), set(_options.CHOICES[name.replace("-", "_")]), name)

    def test_every_call_and_keyword_is_documented(self):
        for kind in (swellray.Seafloor, swellray.Rays, swellray.Lines, swellray.Map, swellray.Stations,
                     swellray.Surface, swellray.Spray):
            self.assertTrue(kind.__doc__, kind)
            for name, member in inspect.getmembers(kind):
                if name.startswith("_") or not (callable(member) or isinstance(member, property)):
                    continue
                words = inspect.getdoc(member)
                self.assertTrue(words, f"{kind.__name__}.{name}")
        inherited = keywords_of(swellray.Seafloor.trace)
        for function, elsewhere in (
            (swellray.Seafloor.read, set()),
            (swellray.Seafloor.from_array, {"water_level"}),
            (swellray.Seafloor.contours, set()),
            (swellray.Seafloor.trace, set()),
            (swellray.Seafloor.ways, inherited),
            (swellray.Seafloor.mild_slope, inherited),
            (swellray.Seafloor.spectrum, inherited),
            (swellray.sea, set()),
            (swellray.Rays.heights, inherited),
            (swellray.Rays.crests, set()),
            (swellray.Rays.map, set()),
            (swellray.Rays.stations, {"combine"}),
            (swellray.Rays.surface, set()),
            (swellray.Rays.surface_at, set()),
            (swellray.Rays.foam, set()),
            (swellray.Rays.seen_surface, set()),
            (swellray.Rays.spray, set()),
        ):
            for keyword in keywords_of(function) - elsewhere:
                self.assertRegex(function.__doc__, rf"(?m)^\s+(\w+, )*{keyword}(, \w+)*:", f"{function.__name__}")


if __name__ == "__main__":
    unittest.main()
