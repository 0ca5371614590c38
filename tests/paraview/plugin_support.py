"""What the tests in ParaView share: the plugin, the program, and data sets compared array by array."""

import os
import subprocess
import sys
from pathlib import Path

import numpy
import paraview.simple as pv
from paraview import servermanager
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkSMPTools

OUTPUT = Path(os.environ["SWELLRAY_OUTPUT"])
DATA = Path(os.environ["SWELLRAY_DATA"])

# Of the program alone: what was typed, and what VTK's writers add.
OF_THE_FILE = {"CommandLine", "SwellrayVersion", "TimeValue"}


def load_plugin():
    """The plugin, its proxies as functions of paraview.simple; more threads than ParaView's one."""
    vtkSMPTools.SetBackend("STDThread")
    pv.LoadPlugin(os.environ["SWELLRAY_PLUGIN"], remote=False, ns=vars(pv))
    return pv


def need(path):
    """End the test as skipped where a file is missing."""
    if not path.is_file():
        print(f"no {path}: set SWELLRAY_DATA")
        sys.exit(77)
    return str(path)


def program(*arguments):
    call = [os.environ["SWELLRAY"], *(str(argument) for argument in arguments), "--quiet"]
    subprocess.run(call, check=True)


def fetch(proxy, port=0):
    # Fetch() knows the first output only.
    source = proxy if port == 0 else pv.Transform(Input=servermanager.OutputPort(proxy, port))
    source.UpdatePipeline()
    return servermanager.Fetch(source)


def read(path):
    """Data set of a file that the program has written."""
    reader = pv.XMLImageDataReader if str(path).endswith(".vti") else pv.XMLPolyDataReader
    return fetch(reader(FileName=[str(path)]))


def arrays_of(data):
    """Every number of a data set by name."""
    arrays = {}
    if hasattr(data, "GetPoints") and data.GetPoints():
        arrays["points"] = vtk_to_numpy(data.GetPoints().GetData())
    for kind, attributes in (("point", data.GetPointData()), ("cell", data.GetCellData()), ("field", data.GetFieldData())):
        for i in range(attributes.GetNumberOfArrays()):
            array = attributes.GetAbstractArray(i)
            if array.GetName() not in OF_THE_FILE:
                values = attributes.GetArray(i)
                arrays[kind + " " + array.GetName()] = (
                    vtk_to_numpy(values) if values else [array.GetValue(j) for j in range(array.GetNumberOfValues())])
    return arrays


def assert_same(proxy, path, port=0):
    """The output of a proxy is what the program has written, number by number."""
    found, expected = arrays_of(fetch(proxy, port)), arrays_of(read(path))
    assert set(found) == set(expected), (path, set(found) ^ set(expected))
    for name, values in expected.items():
        numpy.testing.assert_array_equal(found[name], values, f"{path}: {name}")
    print(f"{Path(path).name}: {len(expected)} arrays are the same")
