# %% [markdown]
# # Random waves over a bar
#
# Significant heights at 70 gauges of a flume (Boers 1996, case 1C), computed and measured, as `run` does it with the program.
# The measurements are no part of Swellray: they are looked for in SWELLRAY_DATA. The cells are marked by `# %%`;
# `python3 boers.py FOLDER` runs them all.

# %%
import math
import os
import pathlib
import sys

import numpy
import swellray

folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
folder.mkdir(parents=True, exist_ok=True)
data = pathlib.Path(os.environ.get("SWELLRAY_DATA", "../../../shared/data"))
flume = data / "measured" / "boers_1996_1C"
if not flume.is_dir():
    print(f"no measurements in {data}; set SWELLRAY_DATA")
    sys.exit(77)

gauges, measured = numpy.loadtxt(flume / "Hm0_high.asc", comments="%").T
places = numpy.column_stack((gauges, numpy.full_like(gauges, 0.15)))

# %% [markdown]
# ## Waves at the gauges
#
# Heights of `battjes-janssen` are root mean square ones.

# %%
bed = swellray.Seafloor.read(flume / "params.txt")
computed = {}
for rule in ("battjes-janssen", "none"):
    rays = bed.trace(period=1 / 0.3, direction=270, height=measured[0] / math.sqrt(2), offshore_depth=0.75, edge="none",
                     breaking=rule)
    waves = rays.stations(places)
    computed[rule] = math.sqrt(2) * waves["WaveHeight"]
    error = computed[rule] - measured
    print(f"{rule:16} rms error of Hm0 {1000 * math.sqrt(numpy.mean(error**2)):.1f} mm")

assert math.sqrt(numpy.mean((computed["battjes-janssen"] - measured) ** 2)) < 0.005

# %%
try:
    from matplotlib import pyplot
except ImportError:
    print("no picture without matplotlib")
else:
    figure, (heights, bottom) = pyplot.subplots(2, sharex=True, figsize=(9, 6), height_ratios=(2, 1))
    heights.plot(gauges, 1000 * measured, "o", color="black", markersize=4, label="measured (Boers 1996)")
    heights.plot(gauges, 1000 * computed["battjes-janssen"], color="tab:blue", label="Battjes and Janssen")
    heights.plot(gauges, 1000 * computed["none"], "--", color="tab:gray", label="no breaking")
    heights.set(ylabel="Hm0, mm", ylim=(0, 200))
    heights.legend()
    bottom.plot(gauges, -waves["Depth"], color="tab:brown")
    bottom.axhline(0, color="tab:blue", linewidth=0.8)
    bottom.set(xlabel="x, m", ylabel="bed, m")
    figure.tight_layout()
    figure.savefig(folder / "boers.png", dpi=80)
