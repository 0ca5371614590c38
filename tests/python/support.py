"""What the tests share: the program beside the package, and the folder of real bathymetry."""

import csv
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLPolyDataReader

PROGRAM = os.environ["SWELLRAY"]
DATA = Path(os.environ["SWELLRAY_DATA"])


class FolderCase(unittest.TestCase):
    """A test with a folder of its own, gone when it is over."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="swellray-python-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)


def program(*arguments):
    """Run the program; returns what it printed."""
    call = [PROGRAM, *(str(argument) for argument in arguments)]
    return subprocess.run(call, check=True, capture_output=True, text=True).stdout


def read_vtk(path):
    """Data set of a file that the program has written."""
    reader = vtkXMLImageDataReader() if str(path).endswith(".vti") else vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def read_table(path):
    """Rows of a CSV file as dicts."""
    with open(path, newline="") as file:
        return list(csv.DictReader(file))
