"""run_tutorial.py PAGE SWELLRAY GRID FOLDER: run every command of the tutorial, on the grid that it speaks of.

Exit code 77: the grid is not here.
"""
import csv
import os
import re
import shutil
import subprocess
import sys


def main():
    page, swellray, grid, folder = sys.argv[1:]
    if not os.path.exists(grid):
        print(f"skipped: {grid} is not here")
        return 77
    if not os.environ.get("DISPLAY") and not shutil.which("Xvfb"):
        print("skipped: neither a display nor Xvfb to draw with")
        return 77
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    os.symlink(grid, os.path.join(folder, "hudson.tif"))
    with open(page, encoding="utf-8") as file:
        commands = "".join(re.findall(r"(?ms)^```\n(.*?)^```", file.read()))
    environment = dict(os.environ, PATH=os.path.dirname(swellray) + os.pathsep + os.environ["PATH"])
    subprocess.run(["bash", "-euo", "pipefail", "-c", commands], cwd=folder, env=environment, check=True)
    for name in re.findall(r"(?:-o|--crests|--map|--table) (\w+\.\w+)", commands):
        if not os.path.getsize(os.path.join(folder, name)):
            sys.exit(f"{name} was not written")
    with open(os.path.join(folder, "waves.csv"), encoding="utf-8") as file:
        heights = [float(row["WaveHeight"]) for row in csv.DictReader(file)]
    # A swell of 2 m in 8 and 12 m of water: refraction and shoaling leave it its order of magnitude.
    if len(heights) != 2 or not all(0.5 < height < 5.0 for height in heights):
        sys.exit(f"heights at the two places are {heights}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
