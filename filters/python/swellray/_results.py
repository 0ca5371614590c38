"""What the calls give back: VTK data sets with their arrays as numpy's."""

import difflib
import os

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter, vtkXMLPolyDataReader, vtkXMLPolyDataWriter

from . import swellrayFilters as filters
from ._options import configure
from ._run import Error, output_of, run
from ._version import __version__


def _view(array):
    view = vtk_to_numpy(array)
    view.flags.writeable = False
    return view


def points_of(places):
    """vtkPolyData of (n, 2) or (n, 3) numbers."""
    places = numpy.array(places, dtype=float, ndmin=2)
    if places.ndim != 2 or places.shape[1] not in (2, 3):
        raise ValueError(f"places must be (n, 2) or (n, 3) numbers, not an array of shape {places.shape}")
    if places.shape[1] == 2:
        places = numpy.column_stack([places, numpy.zeros(len(places))])
    points = vtkPoints()
    points.SetData(numpy_to_vtk(numpy.ascontiguousarray(places), deep=True))
    data = vtkPolyData()
    data.SetPoints(points)
    return data


class Result:
    """A VTK data set with its arrays.

    result["WaveHeight"] is the array of that name as numpy's, of the points or else of the cells: a view, read only
    (copy it to change it). The names are in result.names.
    """

    _writer = None
    _ending = ""

    def __init__(self, vtk):
        self._vtk = vtk

    @property
    def vtk(self):
        """The VTK data set: for VTK's filters, and for PyVista by pyvista.wrap(result.vtk)."""
        return self._vtk

    @property
    def point_names(self):
        """Names of the arrays with a value a point."""
        data = self._vtk.GetPointData()
        return [data.GetArrayName(i) for i in range(data.GetNumberOfArrays())]

    @property
    def cell_names(self):
        """Names of the arrays with a value a cell: a ray, a line."""
        data = self._vtk.GetCellData()
        return [data.GetArrayName(i) for i in range(data.GetNumberOfArrays())]

    @property
    def names(self):
        """Names of all arrays."""
        return self.point_names + self.cell_names

    def __getitem__(self, name):
        for data in (self._vtk.GetPointData(), self._vtk.GetCellData()):
            array = data.GetArray(name)
            if array is not None:
                return _view(array)
        nearest = difflib.get_close_matches(str(name), self.names, 1)
        hint = f"did you mean {nearest[0]!r}?" if nearest else "there are " + ", ".join(self.names)
        raise KeyError(f"no array {name!r}; {hint}")

    def __contains__(self, name):
        return name in self.names

    def __len__(self):
        return self._vtk.GetNumberOfPoints()

    @property
    def points(self):
        """(n, 3) positions of the points, m: x east, y north, z up, in the plane of the scene."""
        points = self._vtk.GetPoints()
        return _view(points.GetData()) if points else numpy.empty((0, 3))

    @property
    def fields(self):
        """What holds for the whole: period, direction, georeference, ...: a dict of numbers, words and arrays."""
        data = self._vtk.GetFieldData()
        fields = {}
        for i in range(data.GetNumberOfArrays()):
            array = data.GetAbstractArray(i)
            if data.GetArray(i) is None:
                values = [array.GetValue(j) for j in range(array.GetNumberOfValues())]
                fields[array.GetName()] = values[0] if len(values) == 1 else values
            else:
                values = _view(array)
                fields[array.GetName()] = values[0].item() if values.shape == (1,) else values
        return fields

    def to_scene(self, places):
        """Positions (n, 2), m, of places in the coordinates of the seafloor's file: longitude and latitude in degrees,
        or x and y in the file's unit. Raises Error where a place is none."""
        return self._convert(places, filters.vtkSwellPlaces.FILE_TO_SCENE)

    def to_file(self, points):
        """File coordinates (n, 2) of positions in the scene, m: the way back of to_scene()."""
        return self._convert(points, filters.vtkSwellPlaces.SCENE_TO_FILE)

    def _convert(self, places, way):
        converter = filters.vtkSwellPlaces()
        converter.SetInputDataObject(0, points_of(places))
        converter.SetInputDataObject(1, self._vtk)
        converter.SetWay(way)
        run(converter, stacklevel=5)
        return vtk_to_numpy(output_of(converter).GetPoints().GetData())[:, :2]

    def write(self, path, compress=False):
        """Write the VTK file (.vtp, of an image .vti). It appears whole or not at all.

        Raises ValueError for another ending, OSError where the file cannot be written.
        """
        path = os.fspath(path)
        if not path.endswith(self._ending):
            raise ValueError(f"{path!r} must end in {self._ending}")
        folder, name = os.path.split(path)
        temporary = os.path.join(folder, f".{name}.{os.getpid()}")
        with open(temporary, "wb"):
            pass  # VTK does not say why it cannot write
        try:
            writer = self._writer()
            writer.SetInputData(self._signed())
            writer.SetFileName(temporary)
            writer.SetDataModeToAppended()
            writer.EncodeAppendedDataOff()
            writer.SetHeaderTypeToUInt64()
            if compress:
                writer.SetCompressorTypeToZLib()
            else:
                writer.SetCompressorTypeToNone()
            run(writer)
            if writer.GetErrorCode() != 0:
                raise OSError(f"cannot write {path!r}: the disk is full, or files may not get so large")
            os.replace(temporary, path)
        finally:
            if os.path.exists(temporary):
                os.remove(temporary)

    def _signed(self):
        version = vtkStringArray()
        version.SetName("SwellrayVersion")
        version.InsertNextValue(__version__)
        copy = self._vtk.NewInstance()
        copy.ShallowCopy(self._vtk)
        copy.GetFieldData().AddArray(version)
        return copy

    def __repr__(self):
        return f"<swellray.{type(self).__name__}: {self._summary()}>"

    def _summary(self):
        return f"{len(self)} points"


class Stations(Result):
    """Waves at points, in the order of the points. NaN on land and where no ray came."""

    _writer = vtkXMLPolyDataWriter
    _ending = ".vtp"


class Spray(Result):
    """Spray at a time: a point a particle in the air, with Velocity, Age and Source (0 a crest, 1 an obstacle)."""

    _writer = vtkXMLPolyDataWriter
    _ending = ".vtp"


class Lines(Result):
    """Lines over points: contours, crests, breaker lines. Line i has the points lines.slices()[i]."""

    _writer = vtkXMLPolyDataWriter
    _ending = ".vtp"

    @property
    def number(self):
        """How many lines there are."""
        return self._vtk.GetNumberOfLines()

    @property
    def offsets(self):
        """Where each line begins among the points, and the end: number + 1 integers."""
        return _view(self._vtk.GetLines().GetOffsetsArray())

    def slices(self):
        """A slice of the points for each line:

        for part in rays.slices():
            pyplot.plot(rays.points[part, 0], rays.points[part, 1])
        """
        offsets = self.offsets
        return [slice(int(first), int(end)) for first, end in zip(offsets[:-1], offsets[1:])]

    def _summary(self):
        return f"{self.number} lines, {len(self)} points"


class Surface(Result):
    """The breaking-wave surface at a time: triangles, with Foam (0 to 1), Breaking, Phase, Depth, Normals, Velocity."""

    _writer = vtkXMLPolyDataWriter
    _ending = ".vtp"

    @property
    def triangles(self):
        """(n, 3) points of the triangles."""
        return _view(self._vtk.GetPolys().GetConnectivityArray()).reshape(-1, 3)

    @property
    def time(self):
        """Time of the surface, s."""
        return self.fields["Time"]

    def _summary(self):
        return f"{self._vtk.GetNumberOfPolys()} triangles at {self.time:g} s"


class Map(Result):
    """Values on a regular grid: map["WaveHeight"][row, column], rows from south to north, columns from west to east."""

    _writer = vtkXMLImageDataWriter
    _ending = ".vti"

    def __getitem__(self, name):
        values = super().__getitem__(name)
        return values.reshape(self.shape + values.shape[1:])

    @property
    def shape(self):
        """Rows and columns."""
        columns, rows, _ = self._vtk.GetDimensions()
        return rows, columns

    def _axis(self, axis):
        first = self._vtk.GetExtent()[2 * axis]
        steps = first + numpy.arange(self._vtk.GetDimensions()[axis])
        return self._vtk.GetOrigin()[axis] + self._vtk.GetSpacing()[axis] * steps

    @property
    def x(self):
        """Eastward positions of the columns, m."""
        return self._axis(0)

    @property
    def y(self):
        """Northward positions of the rows, m."""
        return self._axis(1)

    @property
    def points(self):
        """(n, 3) positions of the nodes, m, row by row."""
        x, y = numpy.meshgrid(self.x, self.y)
        return numpy.column_stack([x.ravel(), y.ravel(), numpy.full(x.size, self._vtk.GetOrigin()[2])])

    @property
    def extent(self):
        """West, east, south and north edge of the cells around the nodes, m: pyplot.imshow(map["Depth"],
        origin="lower", extent=map.extent)."""
        dx, dy = self._vtk.GetSpacing()[:2]
        return (self.x[0] - dx / 2, self.x[-1] + dx / 2, self.y[0] - dy / 2, self.y[-1] + dy / 2)

    def _summary(self):
        rows, columns = self.shape
        return f"{columns} x {rows} nodes, {self._vtk.GetSpacing()[0]:g} m apart"


class Rays(Lines):
    """Wave rays with the waves along them, over the seafloor they were traced on (rays.seafloor).

    Arrays of the points: WaveHeight (m), Depth (m), Phase (rad), TravelTime (s), Wavenumber (rad/m), Wavelength (m),
    PhaseSpeed, GroupSpeed (m/s), Direction and RayDirection (3 components, unit, going to), DirectionFrom (degrees),
    RefractionCoefficient, KrSpacing, KrTube, TubeWidth, ShoalingCoefficient, EnergyFlux (W/m), OrbitalVelocity (m/s),
    Caustics, Breaking, BreakerType (1 spilling, 2 plunging, 3 surging), BreakingDistance (m), RayState (0 dead, 1 alive,
    2 flat, 3 aground), Longitude, Latitude (degrees, where they are known).
    Arrays of the rays: RayId, LaunchParameter (m along the incident crest), ParentRay (-1: launched), LeeRay,
    FinalState, EndReason (0 step cap, 1 left the scene, 2 hole, 3 aground, 4 between two aground rays, 5 cancelled,
    6 blocked by a current, 7 stopped by an obstacle), LaunchSegment.
    """

    def __init__(self, vtk, seafloor):
        super().__init__(vtk)
        self.seafloor = seafloor
        self._surfaces = {}

    @classmethod
    def read(cls, path, seafloor):
        """Rays of a .vtp file that Rays.write() or `swellray trace -o` has written, over the seafloor they were
        traced on. Raises Error where the file is damaged or has no rays."""
        path = os.fspath(path)
        with open(path, "rb") as file:
            if b"<VTKFile" not in file.read(1024):
                raise Error(f"{path!r} is no .vtp file")
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(path)
        run(reader)
        rays = cls(output_of(reader), seafloor)
        if "WaveHeight" not in rays or "LaunchParameter" not in rays:
            raise Error(f"{path!r} has no rays with wave heights")
        return rays

    def _on_seafloor(self, algorithm):
        algorithm.SetInputDataObject(0, self._vtk)
        algorithm.SetInputDataObject(1, self.seafloor.vtk)
        return algorithm

    def heights(self, *, amplitude="spacing", caustics="uniform", kr_max=None, breaking="gamma", gamma=None, friction=0.0):
        """The same rays with other heights: the last arguments of Seafloor.trace(), which is not done again."""
        algorithm = configure(filters.vtkSwellWaveHeight(), amplitude=amplitude, caustics=caustics, kr_max=kr_max,
                              breaking=breaking, gamma=gamma, friction=friction)
        algorithm.SetInputData(self._vtk)
        run(algorithm)
        return Rays(output_of(algorithm), self.seafloor)

    def crests(self, *, every=None):
        """Crest lines at time 0, with the waves along them and CrestNumber a line.

        every: only crests whose number is a multiple of this; default: all of them
        """
        algorithm = configure(filters.vtkSwellCrests(), every=every, max_gap_of_rays=True)
        algorithm.SetInputData(self._vtk)
        run(algorithm)
        return Lines(output_of(algorithm))

    def breaker_line(self):
        """Lines where waves begin to break: BreakerHeight, BreakerDepth (m), BreakerAngle, PeelAngle (degrees),
        IribarrenNumber, BreakerIribarrenNumber, BreakerType, VortexRatio, SetDown, SetUp (m), LongshoreEnergyFlux
        (W/m), LongshoreTransport (m3/s)."""
        algorithm = configure(filters.vtkSwellBreakerLine(), max_gap_of_rays=True)
        run(self._on_seafloor(algorithm))
        return Lines(output_of(algorithm))

    def map(self, *, spacing=None, combine="energy", progress=None):
        """Waves on a grid: WaveHeight (m), DirectionFrom (degrees), Wavelength (m), Breaking, LeeRay, RayCount, and
        Elevation, Depth (m). NaN on land and where no ray came.

        spacing: of the nodes, m; default: the nodes of the seafloor
        combine: waves of rays that cross: "energy" adds their energies, "phase" lets them interfere
        """
        algorithm = configure(filters.vtkSwellMap(), spacing=spacing, combine=combine)
        run(self._on_seafloor(algorithm), progress)
        return Map(output_of(algorithm))

    def stations(self, places, *, coordinates="file", combine="energy"):
        """Waves at places: the arrays of map().

        places: (n, 2) numbers
        coordinates: of places: "file", longitude and latitude or x and y as the seafloor's file has them; or "scene",
            metres in its plane
        """
        algorithm = configure(filters.vtkSwellStations(), combine=combine)
        self._on_seafloor(algorithm).SetInputDataObject(2, self.seafloor.places(places, coordinates))
        run(algorithm)
        return Stations(output_of(algorithm))

    def surface(self, time=0.0, *, profile="gonzato-lesaec", phase="traced", points_per_wave=None, foam_life=None, seed=1,
                group_waves=None, group_lull=None):
        """The breaking-wave surface with its foam. Times may be asked for in any order; what they share is kept.

        time: s
        profile: vertical section: airy, gerstner, biesel, fournier-reeves, gonzato-lesaec, peachey, jeschke or vortex,
            with its parameters as in "vortex:threshold=0.1"
        phase: "traced", or "straight", integrated along straight lines (Peachey 1986)
        points_per_wave: 16 or more; default: as the profile needs
        foam_life: time until foam is gone, s; default 8
        seed: what varies from wave to wave is drawn from this
        group_waves: waves a group, 2 or more, high ones in its middle; default: all are alike
        group_lull: height of the lowest waves of a group over that of the highest; default 0.3
        """
        key = (profile, phase, points_per_wave, seed, group_waves, group_lull)
        if key not in self._surfaces:
            algorithm = configure(filters.vtkSwellSurface(), profile=profile, phase=phase,
                                  points_per_wave=points_per_wave, seed=seed, group_waves=group_waves,
                                  group_lull=group_lull)
            self._surfaces[key] = self._on_seafloor(algorithm)
        algorithm = configure(self._surfaces[key], time=float(time))
        run(algorithm)
        foam = configure(filters.vtkSwellFoam(), life=foam_life)
        foam.SetInputData(output_of(algorithm))
        run(foam)
        return Surface(output_of(foam))

    def surface_at(self, places, time=0.0, *, coordinates="file", profile="gonzato-lesaec", points_per_wave=None,
                   foam_life=None, seed=1, group_waves=None, group_lull=None):
        """The surface at places without a mesh: SurfaceElevation (of the topmost sheet, m), Normals, Velocity, Depth,
        Foam, Breaking; Waves is the number of waves that cross there, which are added. NaN where no wave comes.

        places: (n, 2) numbers
        time: s, one for all places or n of them
        coordinates: of places: "file", longitude and latitude or x and y as the seafloor's file has them; or "scene",
            metres in its plane
        profile, points_per_wave, foam_life, seed, group_waves, group_lull: as for surface()
        """
        points = self.seafloor.places(places, coordinates)
        times = numpy.broadcast_to(numpy.asarray(time, dtype=float), points.GetNumberOfPoints())
        array = numpy_to_vtk(numpy.ascontiguousarray(times), deep=True)
        array.SetName("Time")
        points.GetPointData().AddArray(array)
        key = ("at", profile, points_per_wave, seed, group_waves, group_lull)
        if key not in self._surfaces:
            algorithm = configure(filters.vtkSwellSurfaceProbe(), profile=profile, points_per_wave=points_per_wave,
                                  seed=seed, group_waves=group_waves, group_lull=group_lull)
            self._surfaces[key] = self._on_seafloor(algorithm)
        algorithm = configure(self._surfaces[key], foam_life=8.0 if foam_life is None else foam_life)
        algorithm.SetInputDataObject(2, points)
        run(algorithm)
        return Stations(output_of(algorithm))

    def seen_surface(self, time=0.0, *, camera, size=(1600, 900), pixel_step=8, profile="gonzato-lesaec",
                     points_per_wave=None, foam_life=None, seed=1, group_waves=None, group_lull=None):
        """The breaking-wave surface with its foam as a camera samples it, at every n-th pixel: what it costs follows the
        picture and not the scene.

        time: s
        camera: two places, eye and what it looks at, ((x, y, z), (x, y, z)), m in the scene's plane
        size: width and height of the picture, pixels
        pixel_step: pixels from sample to sample
        profile, points_per_wave, foam_life, seed, group_waves, group_lull: as for surface()
        """
        try:
            eye, focus = numpy.asarray(camera, dtype=float).reshape(2, 3)
        except (TypeError, ValueError):
            raise ValueError(f"camera must be two places of three numbers, not {camera!r}") from None
        key = ("seen", profile, points_per_wave, seed, group_waves, group_lull)
        if key not in self._surfaces:
            algorithm = configure(filters.vtkSwellProjectedGrid(), profile=profile, points_per_wave=points_per_wave,
                                  seed=seed, group_waves=group_waves, group_lull=group_lull)
            algorithm.SetViewAngle(40.0)
            self._surfaces[key] = self._on_seafloor(algorithm)
        algorithm = configure(self._surfaces[key], time=float(time), foam_life=8.0 if foam_life is None else foam_life,
                              size=size, pixel_step=pixel_step)
        algorithm.SetCameraPosition(eye)
        algorithm.SetCameraFocalPoint(focus)
        algorithm.SetCameraViewUp((0.0, 0.0, 1.0) if any(eye[:2] != focus[:2]) else (0.0, 1.0, 0.0))
        run(algorithm)
        return Surface(output_of(algorithm))

    def foam(self, time=0.0, *, profile="gonzato-lesaec", points_per_wave=None, foam_life=None, foam_spacing=None, seed=1,
             group_waves=None, group_lull=None):
        """Foam on a grid of still water: Foam, 0 to 1, NaN where no wave comes.

        time: s
        profile, points_per_wave, foam_life, seed, group_waves, group_lull: as for surface()
        foam_spacing: of the nodes, m; default: the nodes of the seafloor
        """
        key = ("foam", profile, points_per_wave, seed, foam_spacing, group_waves, group_lull)
        if key not in self._surfaces:
            algorithm = configure(filters.vtkSwellFoamMap(), profile=profile, points_per_wave=points_per_wave, seed=seed,
                                  group_waves=group_waves, group_lull=group_lull, foam_spacing=foam_spacing)
            self._surfaces[key] = self._on_seafloor(algorithm)
        algorithm = configure(self._surfaces[key], time=float(time), foam_life=8.0 if foam_life is None else foam_life)
        run(algorithm)
        return Map(output_of(algorithm))

    def spray(self, time=0.0, *, profile="gonzato-lesaec", points_per_wave=None, seed=1, group_waves=None, group_lull=None,
              spray_rate=None, spray_steepness=None):
        """Spray in the air at a time, of breaking crests and of waves that strike obstacles.

        time: s
        profile, points_per_wave, seed, group_waves, group_lull: as for surface()
        spray_rate: particles a metre of crest and metre by which its water is ahead of the wave; default 20
        spray_steepness: height over length from which on crests throw spray; default: where the trace breaks
        """
        key = ("spray", profile, points_per_wave, seed, spray_rate, spray_steepness, group_waves, group_lull)
        if key not in self._surfaces:
            algorithm = configure(filters.vtkSwellSpray(), profile=profile, points_per_wave=points_per_wave, seed=seed,
                                  group_waves=group_waves, group_lull=group_lull, spray_rate=spray_rate,
                                  spray_steepness=spray_steepness)
            self._surfaces[key] = self._on_seafloor(algorithm)
        algorithm = configure(self._surfaces[key], time=float(time))
        run(algorithm)
        return Spray(output_of(algorithm))

    def _summary(self):
        wave = self.fields
        return (f"{self.number} rays, {len(self)} points; period {wave['Period']:g} s from "
                f"{wave['DirectionFrom']:g} degrees, {wave['WaveHeight']:g} m offshore")
