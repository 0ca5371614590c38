# %% [markdown]
# # The shoal of Vincent and Briggs
#
# The whole wave over an elliptic shoal by the mild-slope equation, with rays over it, as `run` does it with the program. The cells
# are marked by `# %%`; `python3 vincent-briggs.py FOLDER` runs them all.

# %%
import pathlib
import sys

import numpy
import swellray

folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
folder.mkdir(parents=True, exist_ok=True)

shoal = swellray.Seafloor.read("vincent-briggs")
wave = {"period": 1.3, "direction": 270, "height": 0.0254, "offshore_depth": 0.4572, "breaking": "none"}

# %% [markdown]
# ## The whole wave, and rays

# %%
waves = shoal.mild_slope(**wave, spacing=0.05)
rays = shoal.trace(**wave, spacing=0.5, insert="none")
highest = numpy.nanmax(waves["WaveHeight"]) / wave["height"]
print(f"focus of {highest:.2f} times the height; {rays.number} rays")
assert 2.3 < highest < 2.8

# %%
try:
    from matplotlib import pyplot
except ImportError:
    print("no picture without matplotlib")
else:
    figure, axes = pyplot.subplots(figsize=(9, 8))
    heights = axes.pcolormesh(waves.x, waves.y, waves["WaveHeight"] / wave["height"], cmap="viridis", shading="nearest")
    for part in rays.slices():
        axes.plot(rays.points[part, 0], rays.points[part, 1], color="white", linewidth=0.6)
    axes.set(xlabel="x, m", ylabel="y, m", aspect="equal")
    figure.colorbar(heights, label="H/H0")
    figure.savefig(folder / "vincent-briggs-python.png", dpi=100)
