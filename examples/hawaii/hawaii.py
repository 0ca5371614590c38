# %% [markdown]
# # Hawaii
#
# Swell of a storm in the Southern Ocean arriving at the Hawaiian islands, on the ellipsoid, as `run` does it with the program. The
# grid, sites/hawaii_islands/hawaii_etopo1.nc, is no part of Swellray: it is looked for in SWELLRAY_DATA. The cells are
# marked by `# %%`; `python3 hawaii.py FOLDER` runs them all.

# %%
import os
import pathlib
import sys

import numpy
import swellray

folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
folder.mkdir(parents=True, exist_ok=True)
data = pathlib.Path(os.environ.get("SWELLRAY_DATA", "../../../shared/data"))
grid = data / "sites" / "hawaii_islands" / "hawaii_etopo1.nc"
if not grid.is_file():
    print(f"no grid {grid}; set SWELLRAY_DATA")
    sys.exit(77)

islands = swellray.Seafloor.read(grid, earth="ellipsoid")
print(islands.report)

# %% [markdown]
# ## Rays

# %%
rays = islands.trace(period=16, from_storm=(170, -50), height=2, edge="none", spacing=8000, lee_rays=False)
print(rays)
print(f"{numpy.count_nonzero(rays['EndReason'] == 3)} rays aground")
rays.write(folder / "ellipsoid.vtp")
assert numpy.any(rays["EndReason"] == 3)

# %% [markdown]
# ## Waves at places given by longitude and latitude

# %%
places = {"south of Oahu": (-157.9, 21.1), "south of Kauai": (-159.5, 21.7), "north of Oahu": (-158.0, 21.9)}
waves = rays.stations(list(places.values()))
for name, depth, height, direction in zip(places, waves["Depth"], waves["WaveHeight"], waves["DirectionFrom"]):
    print(f"{name:15} depth {depth:5.0f} m  height {height:5.2f} m  from {direction:5.1f} degrees")

# %%
try:
    from matplotlib import pyplot
except ImportError:
    print("no picture without matplotlib")
else:
    figure, axes = pyplot.subplots(figsize=(10, 8))
    axes.contourf(islands.x / 1e3, islands.y / 1e3, islands["Elevation"], levels=[0, 5000], colors=["tan"])
    for part in rays.slices():
        axes.plot(rays.points[part, 0] / 1e3, rays.points[part, 1] / 1e3, color="steelblue", linewidth=0.3)
    axes.set(xlabel="x on Mercator's map, km", ylabel="y, km", title="16 s from the Southern Ocean", aspect="equal")
    figure.savefig(folder / "hawaii-python.png", dpi=120)
