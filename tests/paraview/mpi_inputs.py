"""A small seafloor with a shoal, and stations over it, for the ranks of MPI: mpi_inputs.py FOLDER."""

import math
import sys
from pathlib import Path

folder = Path(sys.argv[1])
columns, rows, cell = 61, 41, 20.0


def elevation(x, y):
    return -14.0 + 0.012 * x + 5.0 * math.exp(-((x - 500.0) ** 2 + (y - 400.0) ** 2) / (2.0 * 120.0**2))


lines = [f"ncols {columns}", f"nrows {rows}", "xllcenter 0", "yllcenter 0", f"cellsize {cell:g}", "NODATA_value -9999"]
for row in reversed(range(rows)):
    lines.append(" ".join(f"{elevation(column * cell, row * cell):.4f}" for column in range(columns)))
(folder / "seafloor.asc").write_text("\n".join(lines) + "\n")
stations = [(100.0 + 90.0 * i, 120.0 + 55.0 * i) for i in range(11)]
(folder / "stations.csv").write_text("x,y\n" + "".join(f"{x:g},{y:g}\n" for x, y in stations))
