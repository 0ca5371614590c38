# %% [markdown]
# # A bay
#
# Waves into the bay of section 3.4 of Gonzato and Le Saëc (1997), as `run` does it with the program: rays a metre apart,
# fronts every 0.4 m, a new ray where two are further apart than 1.2 m. The cells are marked by `# %%`: editors and
# Jupyter (by jupytext) run them one by one; `python3 bay.py FOLDER` runs them all.

# %%
import pathlib
import sys

import numpy
import swellray

folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
folder.mkdir(parents=True, exist_ok=True)

bay = swellray.Seafloor.read("bay")
print(bay.report)

# %% [markdown]
# ## Rays with and without insertion

# %%
wave = {"period": 3, "direction": 90, "height": 0.4, "spacing": 1, "step": 0.4, "max_spacing": 1.2}
dynamic = bay.trace(**wave)
plain = bay.trace(**wave, insert="none")
snell = bay.trace(**wave, scheme="snell", insert="interpolate")
for name, rays in (("dynamic", dynamic), ("plain", plain), ("snell", snell)):
    inserted = numpy.count_nonzero(rays["ParentRay"] >= 0)
    print(f"{name:8} {rays.number} rays, {inserted} inserted, {len(rays)} points")
    rays.write(folder / f"{name}.vtp")

assert plain.number == 100
assert dynamic.number > 150 and snell.number > 150

# %% [markdown]
# ## Heights across the mouth of the bay
#
# Waves gather before the capes and spread between them.

# %%
heights = dynamic.map(spacing=2)
heights.write(folder / "heights.vti")
column = numpy.argmin(numpy.abs(heights.x - 17))
across = heights["WaveHeight"][:, column]
for y, depth, height in zip(heights.y, heights["Depth"][:, column], across):
    if abs(y) < 40:
        print(f"y {y:5.0f} m  depth {depth:5.2f} m  height {height:5.2f} m")

capes = (numpy.abs(heights.y) > 22) & (numpy.abs(heights.y) < 32)
between = (numpy.abs(heights.y) > 8) & (numpy.abs(heights.y) < 18)
assert across[capes].min() > 1.1 * across[between].max()

# %%
try:
    from matplotlib import pyplot
except ImportError:
    print("no picture without matplotlib")
else:
    figure, axes = pyplot.subplots(figsize=(7, 6))
    image = axes.imshow(heights["WaveHeight"], origin="lower", extent=heights.extent, cmap="viridis")
    figure.colorbar(image, label="wave height, m")
    for part in dynamic.slices()[::4]:
        axes.plot(dynamic.points[part, 0], dynamic.points[part, 1], color="white", linewidth=0.4)
    crests = dynamic.crests()
    for part in crests.slices():
        axes.plot(crests.points[part, 0], crests.points[part, 1], color="black", linewidth=0.4)
    axes.set(xlabel="x, m", ylabel="y, m", title="Waves into a bay")
    figure.savefig(folder / "bay-python.png", dpi=120)
