# %% [markdown]
# # Egmond
#
# Significant heights over the two bars of Egmond aan Zee in November 1998 (COAST3D), hour by hour from the sea measured offshore,
# with the tide, beside those measured at five poles. Grid and measurements are no part of Swellray: they are looked
# for in SWELLRAY_DATA. The cells are marked by `# %%`; `python3 egmond.py FOLDER HOURS` runs them all, for every so
# many hours (72 by default; 1 takes about ten minutes on two cores).

# %%
import csv
import datetime
import math
import os
import pathlib
import sys
import time

import numpy
import swellray

folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
every = int(sys.argv[2]) if len(sys.argv) > 2 else 72
folder.mkdir(parents=True, exist_ok=True)
data = pathlib.Path(os.environ.get("SWELLRAY_DATA", "../../../shared/data"))
site = data / "sites" / "egmond_nl"
measured = data / "measured" / "egmond_coast3d_1998"
if not site.is_dir() or not measured.is_dir():
    print(f"no grid or no measurements in {data}; set SWELLRAY_DATA")
    sys.exit(77)


def table(path):
    with open(path, encoding="utf-8") as lines:
        return list(csv.DictReader(line for line in lines if not line.startswith("#")))


# %%
POLES = ("2", "1a", "1b", "1c", "1d")
places = {row["station"]: (float(row["x_rd"]), float(row["y_rd"])) for row in table(site / "stations.csv")}
heights = {(row["time"], row["station"]): float(row["Hm0_m"]) for row in table(measured / "egmond_hm0_stations.csv")}

# The sea at the seaward edge of the grid, every ten minutes.
boundary = table(measured / "egmond_boundary.csv")
seconds = [datetime.datetime.fromisoformat(row["time"]).timestamp() for row in boundary]
sea = {name: [float(row[name]) for row in boundary]
       for name in ("Hm0_m", "Tp_s", "dir_degN", "spread_deg", "water_level_m")}
hours = sorted({hour for hour, pole in heights if pole in POLES})
hours = [hour for hour in hours if datetime.datetime.fromisoformat(hour).timestamp() <= seconds[-1]][::every]

# %% [markdown]
# ## Hour by hour

# %%
bed = swellray.Seafloor.read(site / "egmond_10m_epsg28992.tif")
computed = {}
begin = time.perf_counter()
for hour in hours:
    now = {name: float(numpy.interp(datetime.datetime.fromisoformat(hour).timestamp(), seconds, values))
           for name, values in sea.items()}
    bed.water_level = now["water_level_m"]
    waves = bed.spectrum(hs=now["Hm0_m"], tp=now["Tp_s"], direction=now["dir_degN"], spread=now["spread_deg"],
                         offshore_depth=13.5, breaking="baldock", friction=0.067, frequencies=10,
                         stations=[places[pole] for pole in POLES])
    for pole, height in zip(POLES, waves["SignificantWaveHeight"]):
        computed[hour, pole] = height
print(f"{len(hours)} hours, {(time.perf_counter() - begin) / len(hours):.1f} s each")

# %%
with open(folder / "egmond.csv", "w", encoding="utf-8", newline="") as file:
    lines = csv.writer(file)
    lines.writerow(("Time", "Pole", "Measured", "SignificantWaveHeight"))
    for key, height in computed.items():
        lines.writerow((*key, heights.get(key, ""), f"{height:.4f}"))

for pole in POLES:
    pairs = numpy.array([(heights[key], height) for key, height in computed.items()
                         if key[1] == pole and math.isfinite(heights.get(key, math.nan)) and math.isfinite(height)])
    if len(pairs) < 2:
        print(f"{pole:3} {len(pairs)} hours")
        continue
    error = pairs[:, 1] - pairs[:, 0]
    rmse = math.sqrt(numpy.mean(error**2))
    correlation = numpy.corrcoef(pairs.T)[0, 1]
    explained = 1 - numpy.mean(error**2) / numpy.var(pairs[:, 0])
    print(f"{pole:3} {len(pairs)} hours  rmse {rmse:.3f} m  bias {numpy.mean(error):+.3f} m  r {correlation:.3f}  "
          f"r2 {correlation**2:.2f}  1 - SSE/SST {explained:.2f}")
    assert rmse < 0.5, "far from what was measured"

# %%
try:
    from matplotlib import pyplot
except ImportError:
    print("no picture without matplotlib")
else:
    figure, rows = pyplot.subplots(len(POLES), sharex=True, figsize=(11, 12))
    days = [datetime.datetime.fromisoformat(hour) for hour in hours]
    for axes, pole in zip(rows, POLES):
        axes.plot(days, [heights.get((hour, pole), math.nan) for hour in hours], "-", linewidth=1, color="black", label="measured")
        axes.plot(days, [computed[hour, pole] for hour in hours], "-", linewidth=1, color="tab:blue", label="computed")
        axes.set(ylabel=f"Hm0 at {pole}, m", ylim=(0, None))
    rows[0].legend()
    figure.autofmt_xdate()
    figure.savefig(folder / "egmond.png", dpi=72, bbox_inches="tight")
