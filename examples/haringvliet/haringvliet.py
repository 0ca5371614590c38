# %% [markdown]
# # Haringvliet
#
# The storm of 14 October 1982 at 23 h from its own SWAN files, as `run` does it with the program. The files are no part of Swellray:
# they are looked for in SWELLRAY_DATA. The cells are marked by `# %%`; `python3 haringvliet.py FOLDER` runs them all.

# %%
import os
import pathlib
import sys

import numpy
import swellray

folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
folder.mkdir(parents=True, exist_ok=True)
site = pathlib.Path(os.environ.get("SWELLRAY_DATA", "../../../shared/data")) / "sites" / "haringvliet_nl"
if not (site / "f31har03.swn").is_file():
    print(f"no run {site}/f31har03.swn; set SWELLRAY_DATA")
    sys.exit(77)

buoys = numpy.loadtxt(site / "f31hari.loc", usecols=(0, 1))
estuary = swellray.Seafloor.read(site / "f31har03.swn", water_level=1.7)
sea = {"boundary": site / "f31har03.bnd", "offshore_depth": 15, "edge": "none", "frequencies": 12, "friction": 0.067}

# %% [markdown]
# ## The eight buoys
#
# The sea limited by the depth at its own place, and with what it lost on its way.

# %%
heights = {breaking: estuary.spectrum(**sea, breaking=breaking, stations=buoys)["SignificantWaveHeight"]
           for breaking in ("gamma", "battjes-janssen")}
for number, (saturated, along) in enumerate(zip(*heights.values()), 1):
    print(f"buoy {number}  Hs {saturated:.2f} m by saturation, {along:.2f} m by Battjes and Janssen")
assert numpy.all(heights["battjes-janssen"] <= heights["gamma"] + 1e-9)
assert heights["gamma"][0] > 2.9
