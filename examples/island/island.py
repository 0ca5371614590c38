# %% [markdown]
# # An island
#
# Waves round the island of section 3.4 of Gonzato and Le Saëc (1997), as `run` does it with the program. The cells are
# marked by `# %%`; `python3 island.py FOLDER` runs them all.

# %%
import pathlib
import sys

import numpy
import swellray

folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
folder.mkdir(parents=True, exist_ok=True)

island = swellray.Seafloor.read(
    "island:slope=0.2,shore-radius=12,toe-radius=20,xc=-15,x0=-50,y0=-50,x1=50,y1=50")

# %% [markdown]
# ## Rays into the lee, and without them

# %%
wave = {"period": 4, "direction": 270, "height": 0.5, "spacing": 1, "step": 0.4, "max_spacing": 1.2}
cases = {
    "dynamic": island.trace(**wave),
    "refraction": island.trace(**wave, lee_rays=False),
    "plain": island.trace(**wave, insert="none"),
}
for name, rays in cases.items():
    inserted = numpy.count_nonzero(rays["ParentRay"] >= 0)
    lee = numpy.count_nonzero(rays["LeeRay"])
    aground = numpy.count_nonzero(rays["EndReason"] == 3)
    print(f"{name:10} {rays.number} rays, {inserted} inserted, {lee} of these in the lee, {aground} aground")
    rays.write(folder / f"{name}.vtp")

assert numpy.any(cases["dynamic"]["LeeRay"])
assert not numpy.any(cases["refraction"]["LeeRay"])
assert cases["plain"].number == 100

# %% [markdown]
# ## The shadow
#
# Refraction alone brings nothing to a part of the lee: there the map is NaN.

# %%
shares = {}
for name in ("dynamic", "refraction"):
    waves = cases[name].map(spacing=1)
    lee = (waves["Depth"] > 0.1) & (waves.x > 5) & (numpy.abs(waves.y[:, None]) < 10)
    shares[name] = numpy.mean(numpy.isnan(waves["WaveHeight"][lee]))
    print(f"{name:10} no wave on {100 * shares[name]:.0f} % of the lee")

assert shares["dynamic"] < shares["refraction"]

# %%
try:
    from matplotlib import pyplot
except ImportError:
    print("no picture without matplotlib")
else:
    figure, axes = pyplot.subplots(1, 2, figsize=(12, 5))
    for ax, name in zip(axes, ("dynamic", "refraction")):
        rays = cases[name]
        waves = rays.map(spacing=0.5)
        image = ax.imshow(waves["WaveHeight"], origin="lower", extent=waves.extent, cmap="viridis", vmin=0, vmax=0.8)
        for part, lee in zip(rays.slices(), rays["LeeRay"]):
            ax.plot(rays.points[part, 0], rays.points[part, 1], "--" if lee else "-", color="white", linewidth=0.3)
        ax.set(title=name, xlabel="x, m", ylabel="y, m")
        figure.colorbar(image, ax=ax, label="wave height, m")
    figure.savefig(folder / "island-python.png", dpi=120)
