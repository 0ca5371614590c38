"""The installed package, below the prefix given: it is found there, with the libraries beside it, and traces."""

import os
import sys

import swellray

prefix = os.path.realpath(sys.argv[1])
assert os.path.realpath(swellray.__file__).startswith(prefix), swellray.__file__
with open("/proc/self/maps") as maps:
    libraries = {line.split()[-1] for line in maps if "libswellray" in line}
assert len(libraries) == 3, libraries
assert all(os.path.realpath(library).startswith(prefix) for library in libraries), libraries
rays = swellray.Seafloor.read("plane:facing=270").trace(period=8, direction=270, height=1)
assert rays.number > 50 and rays["WaveHeight"].max() > 1.0
print(rays)
