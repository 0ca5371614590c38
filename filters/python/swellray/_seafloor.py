"""The seafloor, and what is done on it."""

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData

from . import swellrayFilters as filters
from ._options import configure
from ._results import Lines, Map, Rays, Stations, points_of
from ._run import output_of, run

# Axes are taken for equally spaced up to rounding of what was written as text.
_AXIS_TOLERANCE = 1e-6

_GIGABYTE = 1e9


def _spacing_of(name, axis):
    axis = numpy.asarray(axis, dtype=float)
    if axis.ndim != 1 or len(axis) < 2:
        raise ValueError(f"{name} must be two or more numbers, not an array of shape {axis.shape}")
    spacing = (axis[-1] - axis[0]) / (len(axis) - 1)
    even = axis[0] + spacing * numpy.arange(len(axis))
    if not spacing > 0 or not numpy.all(numpy.abs(axis - even) <= _AXIS_TOLERANCE * spacing):
        raise ValueError(f"{name} must rise in equal steps")
    return axis[0], spacing


class Seafloor(Map):
    """Elevations of the bed on a grid, m, positive up, NaN in holes: seafloor["Elevation"][row, column].

    water_level: still-water level (tide), m, positive up, in the datum of the elevations; all that is done on the
    seafloor is done at it.
    """

    def __init__(self, vtk, *, water_level=0.0):
        """On a vtkImageData of one layer with the point array Elevation; Seafloor.read() and Seafloor.from_array()
        make one."""
        super().__init__(vtk)
        self.water_level = float(water_level)
        self._report = []

    @classmethod
    def read(cls, source, *, water_level=0.0, positive="auto", crs=None, crop=None, resample=None, smooth=None,
             nodata=None, variable=None, max_gap=None, drop_outliers=False, earth="plane", progress=None):
        """Read a seafloor.

        source: any raster that GDAL reads (GeoTIFF, NetCDF, ESRI ASCII, ...), a wave model's grid by the file that
            names the rest, a mesh, soundings, .vti, .vts, .vtu; or a built-in one, "NAME:key=value,..."
        water_level: height of the water above the file's zero (tide), m
        positive: sign of the file's values: "up" elevation, "down" depth, "auto" as the file says
        crs: coordinate reference system, as "EPSG:28992", WKT or "local"; default: as the file says
        crop: (x0, y0, x1, y1), keep this rectangle, in the file's own coordinates
        resample: spacing of the nodes, m; default: the file's own
        smooth: standard deviation of a Gaussian, m
        nodata: value that marks cells without data
        variable: of a NetCDF file, raster band, or column of a table
        max_gap: fill gaps up to this width, m; default 5 cells
        drop_outliers: leave out soundings far off their neighbours
        earth: of a grid in longitude and latitude: "plane" map, or "ellipsoid", for whole basins

        Raises Error where it cannot be read or has no water.
        """
        reader = configure(filters.vtkSwellSeafloorReader(), source=source, water_level=water_level, positive=positive,
                           crs=crs, crop=crop, resample=resample, smooth=smooth, nodata=nodata, variable=variable,
                           max_gap=max_gap, drop_outliers=drop_outliers, earth=earth)
        run(reader, progress)
        seafloor = cls(output_of(reader), water_level=water_level)
        seafloor._report = [(reader.GetReportLabel(i), reader.GetReportText(i))
                            for i in range(reader.GetNumberOfReportLines())]
        return seafloor

    @classmethod
    def from_array(cls, elevation, x, y, *, water_level=0.0):
        """A seafloor of one's own, without a place on Earth.

        elevation: (rows, columns), m, positive up, NaN: a hole
        x, y: positions of the columns, eastward, and of the rows, northward, m, in equal steps
        """
        elevation = numpy.asarray(elevation, dtype=float)
        (x0, dx), (y0, dy) = _spacing_of("x", x), _spacing_of("y", y)
        if elevation.shape != (len(y), len(x)):
            raise ValueError(f"elevation has the shape {elevation.shape}; x and y ask for {(len(y), len(x))}")
        image = vtkImageData()
        image.SetDimensions(len(x), len(y), 1)
        image.SetOrigin(x0, y0, 0.0)
        image.SetSpacing(dx, dy, min(dx, dy))
        values = numpy_to_vtk(numpy.ascontiguousarray(elevation).ravel(), deep=True)
        values.SetName("Elevation")
        image.GetPointData().SetScalars(values)
        return cls(image, water_level=water_level)

    @property
    def report(self):
        """How the file was understood, line by line, as `swellray info` prints it."""
        width = max((len(label) for label, _ in self._report), default=0)
        return "\n".join(f"{label:{width}}  {text}" for label, text in self._report)

    @property
    def depth(self):
        """(rows, columns) water level less elevation, m, positive in water."""
        return self.water_level - self["Elevation"]

    def at_water_level(self, level):
        """The same seafloor at another water level, m."""
        seafloor = type(self)(self._vtk, water_level=level)
        seafloor._report = self._report
        return seafloor

    def places(self, places, coordinates="file"):
        """(n, 2) places as vtkPolyData in the scene: of the coordinates of the seafloor's file, or of the "scene"."""
        if coordinates not in ("file", "scene"):
            raise ValueError(f"coordinates must be 'file' or 'scene', not {coordinates!r}")
        return points_of(self.to_scene(places) if coordinates == "file" else places)

    def contours(self, levels=None, *, interval=None, simplify=None, relief=None):
        """Depth contour lines, with their Depth (m) a line; shallower water lies on their left.

        levels: depths, m
        interval: without levels, a line every so many metres; default: about ten lines
        simplify: leave out points that matter less than this, m
        relief: no lines around ground that departs less than this from their depth, m; default 0.02
        """
        algorithm = configure(filters.vtkSwellContours(), interval=interval, simplify=simplify, relief=relief,
                              water_level=self.water_level)
        for level in numpy.atleast_1d([] if levels is None else levels):
            algorithm.AddLevel(float(level))
        algorithm.SetInputData(self._vtk)
        run(algorithm)
        return Lines(output_of(algorithm))

    def trace(self, *, period, height, direction=None, from_storm=None, from_point=None, launch=None,
              offshore_depth=None, gravity=None, spacing=None, max_spacing=None,
              steps_per_wave=None, step=None, scheme="ode", tolerance=None, flat_height=None, insert="retrace",
              lee_rays=True, edge="contours", shore_normal=None, aground_depth=None, max_rays=None, max_fronts=None,
              current=None, obstacles=None, reflection=None, max_reflections=None, amplitude="spacing",
              caustics="uniform", kr_max=None, breaking="gamma", gamma=None, friction=None, progress=None):
        """Trace wave rays.

        The incident wave
        period: s
        height: offshore, crest to trough, m; from a storm or a point where the wave first meets the scene
        One of
        direction: where the waves come from, degrees clockwise from north, -360 to 360
        from_storm: (longitude, latitude) of a storm far away, degrees
        from_point: (x, y) of a point of the plane, in the coordinates of the seafloor's file
        and
        offshore_depth: depth in which height and direction are given, m; default: deep water
        gravity: m/s2; default 9.81

        The rays
        launch: where they start in place of the edges of the scene, in the coordinates of the file: a line, (n, 2), or a
            list of such lines
        spacing: along the incident crest, m; default: from the scene
        max_spacing: insert a ray where two are further apart, m; default: 1.5 times the spacing
        steps_per_wave: fronts a wavelength; default: 8, or as the scene allows
        step: fronts of equal length instead of equal phase, m
        scheme: "ode" integrates the ray equations, "snell" is Snell's law step by step (1997)
        tolerance: relative error a step of the integrator; default 1e-8
        flat_height: waves lower than this get no inserted rays, m; default: a tenth of the height
        insert: how inserted rays are made: "retrace", "interpolate" or "none"
        lee_rays: insert rays in the lee of the shore, a model of diffraction
        edge: refraction between offshore and the edge of the grid: "contours", "edge" or "none"
        shore_normal: direction that the offshore contours face, degrees; default: from the scene
        aground_depth: depth at which a ray is aground, m; default: 5 % of the height
        max_rays, max_fronts: caps; default 200,000 and 100,000
        current: steady current: a raster or .vti with u and v, or built in: "jet", "shear" or "eddy"
        obstacles: file of walls that rays stop at: polygons and lines
        reflection: height that a wall reflects, as a share, 0 to 1; its property 'reflection' goes first; default 0
        max_reflections: how often one wave is reflected at most; default 10

        Their heights
        amplitude: refraction from the "spacing" of rays, or the "tube" equation
        caustics: heights there: "uniform", finite at folds by the Airy function; "geometric", infinite; or "cap"
        kr_max: largest refraction coefficient where a caustic is no fold; default 3
        breaking: "none", "gamma", "weggel", "miche", "dally", "battjes-janssen" or "baldock"
        gamma: breaker index, height over depth; default 0.78, with battjes-janssen by the steepness, with baldock by the
            kh of each place
        friction: bottom friction factor of Jonsson, or "laminar" ("laminar:1.1e-6", m2/s): a smooth bed of a small tank;
            default 0

        progress: called with the share that is done, 0 to 1; what it raises ends the work

        Raises Error with the line that says what is wrong; warns with Notice, as where the grid is too coarse.
        """
        if sum(source is not None for source in (direction, from_storm, from_point)) != 1:
            raise TypeError("trace() needs one of direction, from_storm and from_point")
        tracer = filters.vtkSwellRayTracer()
        for place, kind in ((from_storm, tracer.STORM), (from_point, tracer.POINT)):
            if place is not None:
                x, y = place
                tracer.SetSource(kind)
                tracer.SetSourcePosition(float(x), float(y))
        configure(
            tracer, period=period, direction=direction, height=height,
            offshore_depth=offshore_depth, gravity=gravity, water_level=self.water_level, spacing=spacing,
            max_spacing=max_spacing, steps_per_wave=steps_per_wave, step=step, scheme=scheme, tolerance=tolerance,
            flat_height=flat_height, insert=insert, lee_rays=lee_rays, edge=edge, shore_normal=shore_normal,
            aground_depth=aground_depth, max_rays=max_rays, max_fronts=max_fronts, current=current,
            obstacles=obstacles, reflection=reflection, max_reflections=max_reflections)
        tracer.SetInputDataObject(0, self._vtk)
        if launch is not None:
            tracer.SetInputDataObject(1, self._lines(launch))
        heights = configure(filters.vtkSwellWaveHeight(), amplitude=amplitude, caustics=caustics, kr_max=kr_max,
                            breaking=breaking, gamma=gamma, friction=friction)
        run(tracer, progress)
        heights.SetInputData(output_of(tracer))
        run(heights)
        return Rays(output_of(heights), self)

    def ways(self, site, *, period, directions=None, offshore_depth=None, gravity=None, steps_per_wave=None, tolerance=None,
             edge="contours", shore_normal=None, aground_depth=None, current=None, obstacles=None, progress=None):
        """The ways by which waves come to a site from offshore, as Lines, one a direction: with SiteDirectionFrom,
        OffshoreDirectionFrom (degrees; NaN where none gets there), EnergyGain (the energy a direction over that offshore),
        TravelTime (s) and EndReason a line.

        site: (x, y) in the coordinates of the seafloor's file
        directions: around the circle, the first from north; default 72
        aground_depth: default 0.1 m
        The others as in trace().
        """
        algorithm = configure(
            filters.vtkSwellBackwardRays(), period=period, directions=directions, offshore_depth=offshore_depth,
            gravity=gravity, water_level=self.water_level, steps_per_wave=steps_per_wave, tolerance=tolerance, edge=edge,
            shore_normal=shore_normal, aground_depth=aground_depth, current=current, obstacles=obstacles)
        algorithm.SetSite(*site)
        algorithm.SetInputDataObject(0, self._vtk)
        run(algorithm, progress)
        return Lines(output_of(algorithm))

    def _lines(self, lines):
        """vtkPolyData in the scene of a line, (n, 2), or of several, in the coordinates of the file."""
        single = numpy.ndim(lines[0]) == 1
        parts = [numpy.asarray(line, dtype=float) for line in ([lines] if single else lines)]
        data = points_of(self.to_scene(numpy.concatenate(parts)))
        cells = vtkCellArray()
        first = 0
        for part in parts:
            cells.InsertNextCell(len(part), range(first, first + len(part)))
            first += len(part)
        data.SetLines(cells)
        return data

    def mild_slope(self, *, period, direction, height, stations=None, coordinates="file", offshore_depth=None,
                   gravity=None, edge="contours", shore_normal=None, node_spacing=None, spacing=None, min_depth=None,
                   side_walls=False, coast_reflection=None, obstacles=None, reflection=None, dispersion="linear",
                   breaking="gamma", gamma=None, friction=None, max_memory=None, progress=None):
        """Waves by the mild-slope equation, with diffraction and reflection: a Map of WaveHeight (m), DirectionFrom
        (degrees), Wavelength (m), WavePhase (rad), Breaking, Elevation, Depth (m).

        stations: (n, 2) places in the given coordinates (see Rays.stations()); the same at them is the second of two
            results
        node_spacing: of the solution, m; default: a tenth of the shortest wavelength
        spacing: of the nodes of the map, m; default: those of the seafloor
        min_depth: depth where the coast begins, m; default: half the breaker depth
        side_walls: the two sides along which the wave runs are walls
        coast_reflection: height that a coast reflects over that which comes in, 0 to 1; default 0
        dispersion: wavenumber of "linear" waves, or "nonlinear": of waves of their height
        max_memory: that the solution may take, GB; default: four fifths of the machine's
        The others as in trace().
        """
        algorithm = configure(
            filters.vtkSwellMildSlope(), period=period, direction=direction, height=height,
            offshore_depth=offshore_depth, gravity=gravity, water_level=self.water_level, edge=edge,
            shore_normal=shore_normal, node_spacing=node_spacing, spacing=spacing, min_depth=min_depth,
            side_walls=side_walls, coast_reflection=coast_reflection, obstacles=obstacles, reflection=reflection,
            dispersion=dispersion, breaking=breaking, gamma=gamma, friction=friction,
            max_memory=None if max_memory is None else _GIGABYTE * max_memory)
        algorithm.SetInputDataObject(0, self._vtk)
        if stations is not None:
            algorithm.SetInputDataObject(1, self.places(stations, coordinates))
        run(algorithm, progress)
        waves = Map(output_of(algorithm, 0))
        return waves if stations is None else (waves, Stations(output_of(algorithm, 1)))

    def spectrum(self, *, direction=None, hs=None, tp=None, spread=25.0, shape="jonswap", peakedness=None, wind=None,
                 fetch=None, boundary=None, stations=None, coordinates="file", spacing=None, frequencies=20,
                 directions=36, rays_per_direction=1, frequency_range=None, transfer=None, tolerance=None,
                 edge="contours", shore_normal=None, current=None, offshore_depth=None, gravity=None, breaking="gamma",
                 gamma=None, friction=None, elevation_series=False, duration=1200.0, interval=0.5, seed=1, progress=None):
        """A sea from offshore: SignificantWaveHeight (m), PeakPeriod, MeanPeriod, ZeroCrossingPeriod, EnergyPeriod (s),
        MeanDirectionFrom, DirectionalSpread (degrees), Depth (m), Breaking; a Map, or Stations where these are given.

        The sea offshore: hs, tp and direction; or wind, fetch and direction; or boundary
        direction: mean direction it comes from, degrees clockwise from north
        hs: significant wave height, m
        tp: peak period, s
        spread: circular standard deviation of the directions, degrees, 1 to 80
        shape: "jonswap", "pierson-moskowitz" or "tma"
        peakedness: peak enhancement of jonswap and tma; default 3.3
        wind: at 10 m height, m/s
        fetch: of the wind, m; default: without end
        boundary: spectral file (SWAN .bnd, .sp1, .sp2)

        stations: (n, 2) places in the given coordinates (see Rays.stations())
        spacing: of the nodes of the map, m; default: some 2,500 nodes
        frequencies, directions, rays_per_direction: rays back from each place
        frequency_range: (lowest, highest) of the rays, Hz; default: the band that holds 99.5 % of the energy
        transfer: keep the rays in this file (.nc), and take from it those that it has: other seas cost little then
        breaking: "none", "gamma", "battjes-janssen" or "baldock"
        gamma: largest Hs over depth, default 0.6; with battjes-janssen and baldock breaker index, default by the
            steepness and by the kh of each place
        friction: bottom friction coefficient, m2/s3 (0.038: swell over sand; 0.067: storm sea); default 0

        elevation_series: also the surface elevation in time at the stations, by random phases: the result has `.elevations`, m, a row a
            station (NaN where it is dry), and `.times`, s
        duration, interval: of these records, s; they are that long or somewhat longer
        seed: their phases are drawn from this
        The others as in trace().
        """
        if boundary is None and (direction is None or (wind is None and (hs is None or tp is None))):
            raise TypeError("a sea offshore needs direction with hs and tp or with wind, or boundary")
        if elevation_series and stations is None:
            raise TypeError("elevation_series is of stations")
        algorithm = configure(
            filters.vtkSwellSpectralMap(), direction=direction, hs=hs, tp=tp, spread=spread, shape=shape,
            peakedness=peakedness, wind=wind, fetch=fetch, boundary=boundary, frequencies=frequencies,
            directions=directions, rays_per_direction=rays_per_direction, frequency_range=frequency_range,
            transfer=transfer, tolerance=tolerance, edge=edge,
            shore_normal=shore_normal, current=current, offshore_depth=offshore_depth, gravity=gravity,
            breaking=breaking, gamma=gamma, friction=friction, water_level=self.water_level)
        places = self._nodes(spacing) if stations is None else self.places(stations, coordinates)
        algorithm.SetInputDataObject(0, places)
        algorithm.SetInputDataObject(1, self._vtk)
        algorithm.SetKeepSpectra(elevation_series)
        run(algorithm, progress)
        sea = (Map if stations is None else Stations)(output_of(algorithm))
        if elevation_series:
            records = vtkDoubleArray()
            run(algorithm, work=lambda: algorithm.MakeElevations(duration, interval, seed, records))
            sea.elevations = vtk_to_numpy(records).reshape(places.GetNumberOfPoints(), -1)
            sea.times = interval * numpy.arange(sea.elevations.shape[1])
        return sea

    def _nodes(self, spacing):
        usual_nodes = 2500
        x, y = self.x, self.y
        width, height = x[-1] - x[0], y[-1] - y[0]
        if spacing is None:
            spacing = max(numpy.sqrt(width * height / usual_nodes), self._vtk.GetSpacing()[0])
        if not spacing > 0:
            raise ValueError(f"spacing must be above 0 metres, not {spacing}")
        nodes = vtkImageData()
        rounding = 1e-9
        nodes.SetDimensions(int(width / spacing + rounding) + 1, int(height / spacing + rounding) + 1, 1)
        nodes.SetOrigin(x[0], y[0], 0.0)
        nodes.SetSpacing(spacing, spacing, 1.0)
        return nodes
