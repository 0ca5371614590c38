"""The surface of a sea away from the shore."""

from . import swellrayFilters as filters
from ._options import configure
from ._results import Map, Surface
from ._run import output_of, run


def sea(*, direction, hs=None, tp=None, wind=None, fetch=None, shape="jonswap", peakedness=None, spread=None,
        spreading=None, depth=None, gravity=None, size=200.0, spacing=None, tile=False, time=0.0, components=256,
        sharpness=1.0, turbulence=True, seed=1, pixels=None):
    """The surface of a sea in deep water, or water of one depth (Thon, Dischler and Ghazanfarpour 2000): a Surface with
    SurfaceHeight (m above the mean level), Normals and TextureCoordinates; with pixels a Map with SurfaceHeight and Normals.

    direction: mean direction it comes from, degrees clockwise from north
    hs: significant wave height, m
    tp: peak period, s
    wind: at 10 m height, m/s, in place of hs and tp
    fetch: of the wind, m; default: without end
    shape: "jonswap", "pierson-moskowitz" or "tma", which needs a depth
    peakedness: peak enhancement of jonswap and tma; default 3.3
    spread: circular standard deviation of the directions, degrees, 1 to 80, of the spreadings "cosine" and "normal"; default 25
    spreading: of the directions: "hasselmann" or "thon", by frequency; "cosine" or "normal", by spread; default: "cosine"
        where spread is given, otherwise "hasselmann"
    depth: m, the same everywhere; default: deep
    gravity: m/s2; default 9.81

    size: side of the patch, m
    spacing: of the points of the mesh, m; default: a 256th of the side
    tile: whether the surface repeats over the patch
    time: s
    components: waves of greatest amplitude, drawn one by one, 1 to 4096
    sharpness: factor on the steepness that sharpens their crests
    turbulence: whether the shorter waves are there, as turbulence
    seed: what is random is drawn from this
    pixels: a side of an image in place of the mesh
    """
    if (wind is None) == (hs is None or tp is None):
        raise TypeError("a sea needs hs and tp, or wind")
    if spreading is None:
        spreading = "hasselmann" if spread is None else "cosine"
    if spread is not None and spreading in ("hasselmann", "thon"):
        raise ValueError("spread is that of the spreading 'cosine' or 'normal'")
    algorithm = configure(
        filters.vtkSwellSea(), direction=direction, hs=hs, tp=tp, wind=wind, fetch=fetch, shape=shape, peakedness=peakedness,
        spread=spread, spreading=spreading, depth=depth, gravity=gravity,
        spacing=size if pixels else spacing, tile=tile, time=float(time), components=components, sharpness=sharpness,
        turbulence=turbulence, seed=seed, image_pixels=pixels)
    try:
        algorithm.SetSize(size)
    except TypeError:
        raise TypeError(f"size cannot be {size!r}") from None
    run(algorithm)
    return Map(output_of(algorithm, 1)) if pixels else Surface(output_of(algorithm))
