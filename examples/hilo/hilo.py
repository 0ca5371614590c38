# %% [markdown]
# # Behind the breakwater of Hilo
#
# The whole wave in a harbour by the mild-slope equation, with rays over it, as `run` does it with the program. Grid and shore are
# no part of Swellray: they are looked for in SWELLRAY_DATA. The cells are marked by `# %%`; `python3 hilo.py FOLDER` runs
# them all.

# %%
import os
import pathlib
import sys

import numpy
import swellray

folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
folder.mkdir(parents=True, exist_ok=True)
sites = pathlib.Path(os.environ.get("SWELLRAY_DATA", "../../../shared/data")) / "sites"
grid = sites / "hilo_bay_hawaii" / "hilo_bay_1_3s_epsg4326.tif"
land = sites / "_shorelines" / "hilo_land_polygons.geojson"
if not grid.is_file() or not land.is_file():
    print(f"no {grid} or {land}; set SWELLRAY_DATA")
    sys.exit(77)

harbour = swellray.Seafloor.read(grid, crop=(-155.0887, 19.7255, -155.045, 19.752))
wave = {"period": 14, "direction": 20, "height": 1, "breaking": "none", "obstacles": land, "reflection": 0.3}

# %% [markdown]
# ## Into the lee of the wall
#
# Places from the open water past the head of the wall: no ray comes to the last of them.

# %%
places = [(longitude, 19.73329) for longitude in numpy.arange(-155.085, -155.064, 0.003)]
waves, line = harbour.mild_slope(**wave, min_depth=3, spacing=10, stations=places)
rays = harbour.trace(**wave, spacing=100, insert="none", max_reflections=0)
for (longitude, _), height in zip(places, line["WaveHeight"]):
    print(f"{longitude:9.4f}  {height:.2f} m")
assert line["WaveHeight"][0] > 0.9
assert line["WaveHeight"][-1] < 0.25

# %%
try:
    from matplotlib import pyplot
except ImportError:
    print("no picture without matplotlib")
else:
    figure, axes = pyplot.subplots(figsize=(11, 7))
    heights = axes.pcolormesh(waves.x, waves.y, waves["WaveHeight"], vmin=0, vmax=2, cmap="viridis", shading="nearest")
    for part in rays.slices():
        axes.plot(rays.points[part, 0], rays.points[part, 1], color="white", linewidth=0.6)
    axes.set(xlabel="x, m", ylabel="y, m", aspect="equal")
    figure.colorbar(heights, label="H, m")
    figure.savefig(folder / "hilo-python.png", dpi=100)
