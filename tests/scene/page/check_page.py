"""The page of a scene (render --export FILE.html) in headless Chromium: what it shows, and that it turns and plays.

usage: check_page.py SWELLRAY [FOLDER]; exit 77 where Chromium or vtk.js is missing. Pictures are left in the folder.
"""

import os
import shutil
import subprocess
import sys
import tempfile

import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy

from browser import Browser

SKIPPED = 77
# Small: without a graphics card a browser draws slowly.
WIDTH, HEIGHT = 360, 240
BAY = ["bay", "--period", "3", "--direction", "90", "--height", "0.4", "--quiet"]
TITLE = 'a <b>bay</b> & "more" </script>'

# Differences of a channel, 0 to 255, that no rounding explains.
SEEN = 12


def skip(words):
    print(f"skipped: {words}")
    sys.exit(SKIPPED)


def image(path):
    reader = vtk.vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    picture = reader.GetOutput()
    columns, rows, _ = picture.GetDimensions()
    colors = vtk_to_numpy(picture.GetPointData().GetScalars()).reshape(rows, columns, -1)[::-1, :, :3]
    return colors.astype(int)


def check(true, words):
    print(f"{'ok' if true else 'FAILED'}: {words}")
    check.failed |= not true


check.failed = False


def read(path):
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def surface(program, folder, time):
    path, spray = os.path.join(folder, "surface.vtp"), os.path.join(folder, "spray.vtp")
    subprocess.run([program, "surface", *BAY, "--time", repr(time), "-o", path, "--spray", spray, "--spray-rate", "100"],
                   check=True)
    data, drops = read(path), read(spray)
    return (vtk_to_numpy(data.GetPoints().GetData()).astype(float), vtk_to_numpy(data.GetPointData().GetArray("Foam")),
            vtk_to_numpy(data.GetPolys().GetConnectivityArray()), vtk_to_numpy(drops.GetPoints().GetData()).astype(float),
            vtk_to_numpy(drops.GetPointData().GetArray("Velocity")).astype(float))


def check_data(browser, program, folder):
    count = browser.run("swellray.frames.length")
    check(count == 24, f"a period has {count} frames")
    for i in (0, 7):
        time = browser.run(f"swellray.frames[{i}].time")
        places, foam, triangles, drops, velocity = surface(program, folder, time)
        # Half a step of 65535 over a bay of 100 m, and what a float keeps of it.
        step = 0.5 * 100.0 / 65535 + 1e-5
        page = numpy.array(browser.run(f"Array.from(swellray.frames[{i}].points)")).reshape(-1, 3)
        check(page.shape == places.shape and abs(page - places).max() < step, f"places at {time} s are those of 'surface'")
        page = numpy.array(browser.run(f"Array.from(swellray.frames[{i}].foam)")) / 255.0
        check(abs(page - foam).max() <= 0.5 / 255 + 1e-6, f"so is the foam, up to {foam.max():.2f}")
        check(triangles.tolist() == browser.run("Array.from(swellray.triangles)"), "and the triangles")
        page = numpy.array(browser.run(f"Array.from(swellray.frames[{i}].spray)")).reshape(-1, 3)
        check(page.shape == drops.shape and len(drops) > 100 and abs(page - drops).max() < step, f"and {len(drops)} drops of spray")
        # 0.05 s later, before the next frame, they have flown on; velocities are kept to 1/127 of the largest.
        later = 0.05
        browser.run(f"swellray.play(false); swellray.show({time + later})")
        thrown = drops + later * velocity - [0.0, 0.0, 0.5 * 9.81 * later**2]
        page = numpy.array(browser.run("Array.from(swellray.drops)")).reshape(-1, 3)
        fastest = abs(velocity).max()
        check(abs(page - thrown).max() < step + later * 2.0 * fastest / 127, f"which fly, {fastest:.1f} m/s at most")


def check_pictures(browser, folder):
    def still():
        drawn = browser.run("swellray.drawn")
        browser.run("swellray.orbit.changed()")
        browser.wait(f"swellray.drawn > {drawn}")

    def picture(name):
        still()
        path = os.path.join(folder, name)
        browser.picture(path)
        return image(path)

    def boxes(how):
        browser.run(f"document.querySelectorAll('.box').forEach((box) => {{ box.style.visibility = '{how}'; }})")

    boxes("hidden")

    browser.run("swellray.play(false); swellray.show(0); swellray.look('chart')")
    chart = picture("chart.png")
    sea = chart[:, int(0.70 * WIDTH):int(0.76 * WIDTH)].mean(axis=(0, 1))
    land = chart[:, int(0.22 * WIDTH):int(0.26 * WIDTH)].mean(axis=(0, 1))
    check(sea[2] > sea[0] + 40, f"the sea in the east is blue: {sea.round()}")
    check(land[0] > land[2] + 10, f"the land in the west is not: {land.round()}")
    shore = chart[:, int(0.28 * WIDTH):int(0.5 * WIDTH)]
    foam = ((shore.min(axis=2) > 185) & (shore.max(axis=2) - shore.min(axis=2) < 25)).mean()
    check(0.03 < foam < 0.3, f"foam is white on {foam:.3f} of the shore")

    browser.run("swellray.look('aerial')")
    first = picture("aerial.png")
    browser.drag((180, 120), (240, 108))
    turned = picture("turned.png")
    check((abs(turned - first).max(axis=2) > SEEN).mean() > 0.2, "dragging turns the scene")
    browser.drag((240, 108), (180, 120))
    back = picture("back.png")
    check((abs(back - first).max(axis=2) > SEEN).mean() < 0.01, "dragging back turns it back")
    browser.wheel((180, 120), -300)
    check((abs(picture("near.png") - first).max(axis=2) > SEEN).mean() > 0.1, "the wheel brings it nearer")
    browser.run("swellray.look('aerial'); swellray.show(1.5)")
    later = picture("later.png")
    check((abs(later - first).max(axis=2) > SEEN).mean() > 0.01, "waves are elsewhere half a period later")
    browser.run("swellray.show(3)")
    check((abs(picture("again.png") - first).max(axis=2) > SEEN).mean() < 1e-3, "and after a period where they were")
    browser.run("document.getElementById('water').click()")
    check((abs(picture("dry.png") - first).max(axis=2) > SEEN).mean() > 0.1, "water can be taken away")
    browser.run("document.getElementById('water').click()")
    browser.run("document.getElementById('rays').click()")
    check((abs(picture("rays.png") - first).max(axis=2) > SEEN).mean() > 0.02, "rays can be laid over it")
    browser.run("document.getElementById('rays').click()")
    boxes("visible")


def check_controls(browser):
    play = browser.run("(() => { const b = document.getElementById('play').getBoundingClientRect();"
                       " return [b.x + b.width / 2, b.y + b.height / 2]; })()")
    browser.run("swellray.play(false); swellray.show(1)")
    browser.click(play)
    check(browser.run("swellray.playing"), "a click on Play plays")
    browser.wait("swellray.time !== 1")
    browser.click(play)
    time = browser.run("swellray.time")
    check(not browser.run("swellray.playing") and browser.run("swellray.time") == time, "and another one stops")
    browser.run("document.getElementById('stretch').value = 0.5;"
                "document.getElementById('stretch').dispatchEvent(new Event('input'))")
    check(browser.run("document.getElementById('times').textContent").startswith("4.5"), "heights are drawn 4.5 times as large")
    check(browser.run("document.querySelector('h1').textContent") == TITLE, "the title is shown as it was given")
    check(browser.run("document.title") == TITLE, "also over the page")


def main():
    program = sys.argv[1]
    chromium = shutil.which("chromium")
    if not chromium:
        skip("no chromium")
    folder = sys.argv[2] if len(sys.argv) > 2 else tempfile.mkdtemp()
    os.makedirs(folder, exist_ok=True)
    page = os.path.abspath(os.path.join(folder, "bay.html"))
    made = subprocess.run([program, "render", *BAY, "--title", TITLE, "--export", page], capture_output=True, text=True)
    if "pages need vtk.js" in made.stderr:
        skip("no vtk.js")
    if made.returncode != 0:
        sys.exit(f"no page was made: {made.stderr}")
    browser = Browser(chromium, WIDTH, HEIGHT)
    try:
        browser.open(f"file://{page}")
        browser.wait("!!(window.swellray && swellray.drawn > 0) || document.getElementById('problem')?.hidden === false")
        problem = browser.run("document.getElementById('problem').textContent")
        check(problem == "", f"the scene is shown {problem}")
        if not check.failed:
            check_data(browser, program, folder)
            check_pictures(browser, folder)
            check_controls(browser)
        asked = [what for kind, what in browser.log if kind == "asked" and not what.startswith("blob:")]
        check(asked == [f"file://{page}"], f"nothing but the page is fetched: {asked}")
        said = [entry for entry in browser.log if entry[0] != "asked"]
        check(not said, f"no error is said: {said}")
    finally:
        browser.close()
        if len(sys.argv) < 3:
            shutil.rmtree(folder)
    sys.exit(1 if check.failed else 0)


main()
