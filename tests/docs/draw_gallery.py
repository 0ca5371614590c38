"""draw_gallery.py GALLERY PICTURE SWELLRAY SITES FOLDER: draw a picture of the gallery again and compare it with the one kept.

The commands are those of the section in which the picture stands. Exit code 77: the data that they need are not here, or there is
nothing to draw with. A further argument 'keep' puts the picture among those kept instead of comparing.
"""
import os
import re
import shutil
import subprocess
import sys

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkJPEGReader, vtkPNGReader

# Pictures are compared in squares of so many pixels: drivers draw the edges of lines in ways of their own, which a mean over a
# square does not see, and lines that lie elsewhere or other colours do.
SQUARE = 5
# Levels of 255 by which the mean of a square may be off before it counts as another.
OTHER = 12
# Share of squares that may be others.
MOST_OTHER = 0.03
LARGEST = 200_000  # bytes of a picture kept


def section_of(text, picture):
    for section in re.split(r"(?m)^## ", text):
        found = re.search(rf"images/gallery/({picture}\.\w+)\)", section)
        if found:
            commands = re.findall(r"(?ms)^```\n(.*?)^```", section)
            return found.group(1), "".join(commands)
    sys.exit(f"no picture {picture} in the gallery")


def means(path):
    reader = vtkJPEGReader() if path.endswith(".jpg") else vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, -1)[..., :3].astype(float)
    rows, columns = height // SQUARE, width // SQUARE
    squares = pixels[: rows * SQUARE, : columns * SQUARE].reshape(rows, SQUARE, columns, SQUARE, 3)
    return (width, height), squares.mean(axis=(1, 3))


def main():
    gallery, picture, swellray, sites, folder = sys.argv[1:6]
    with open(gallery, encoding="utf-8") as file:
        name, commands = section_of(file.read(), picture)
    for path in re.findall(r"\$SITES/\S+", commands):
        if not os.path.exists(path.replace("$SITES", sites)):
            print(f"skipped: {path} is not here")
            return 77
    if not os.environ.get("DISPLAY") and not shutil.which("Xvfb"):
        print("skipped: neither a display nor Xvfb to draw with")
        return 77
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    environment = dict(os.environ, SITES=sites, PATH=os.path.dirname(swellray) + os.pathsep + os.environ["PATH"])
    subprocess.run(["bash", "-euo", "pipefail", "-c", commands], cwd=folder, env=environment, check=True)
    drawn = os.path.join(folder, name)
    kept = os.path.join(os.path.dirname(gallery), "images", "gallery", name)
    if sys.argv[6:] == ["keep"]:
        shutil.copy(drawn, kept)
        return 0
    if os.path.getsize(kept) > LARGEST:
        sys.exit(f"{kept} has {os.path.getsize(kept)} bytes, more than {LARGEST}")
    size, now = means(drawn)
    kept_size, before = means(kept)
    if size != kept_size:
        sys.exit(f"{name} is of {size} pixels, that in the gallery of {kept_size}")
    other = (abs(now - before).max(axis=2) > OTHER).mean()
    print(f"{100 * other:.2g} % of the squares of {name} differ")
    if other > MOST_OTHER:
        sys.exit(f"{name} is another picture than the one in the gallery: look at {drawn} and draw it again with 'keep'")
    return 0


if __name__ == "__main__":
    sys.exit(main())
