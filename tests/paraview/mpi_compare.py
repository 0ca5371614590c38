"""What 2 and 4 ranks have written is what one has, number by number, in as many parts: mpi_compare.py FOLDER."""

import re
import sys
from pathlib import Path

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPImageDataReader, vtkXMLPPolyDataReader

folder = Path(sys.argv[1])


def read(reader, path):
    reader.SetFileName(str(path))
    reader.Update()
    data = reader.GetOutput()
    values = {data.GetPointData().GetArrayName(i): vtk_to_numpy(data.GetPointData().GetArray(i))
              for i in range(data.GetPointData().GetNumberOfArrays())}
    values["points"] = numpy.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])
    return values


def compare(name, ending, reader_class, count):
    one = read(reader_class(), folder / f"{name}1{ending}")
    assert len(one["points"]) == count, (name, len(one["points"]))
    assert numpy.nanmin(one["SignificantWaveHeight"]) > 0.0
    for ranks in (2, 4):
        path = folder / f"{name}{ranks}{ending}"
        parts = len(re.findall("<Piece ", path.read_text()))
        assert parts == ranks, (path, parts)
        other = read(reader_class(), path)
        assert set(other) == set(one), set(other) ^ set(one)
        for array, values in one.items():
            numpy.testing.assert_array_equal(other[array], values, f"{path.name}: {array}")
        print(f"{path.name}: {len(one)} arrays of {count} points in {parts} parts are those of one rank")


compare("map", ".pvti", vtkXMLPImageDataReader, 24 * 16)
compare("stations", ".pvtp", vtkXMLPPolyDataReader, 11)
