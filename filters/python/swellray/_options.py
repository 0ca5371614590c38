"""Keywords of the calls as properties of the filters."""

import difflib
import os

# Where a keyword is not the property's name in small letters.
_PROPERTIES = {
    "amplitude": "AmplitudeRule",
    "boundary": "BoundaryFileName",
    "breaking": "BreakingRule",
    "caustics": "CausticRule",
    "combine": "CombineRule",
    "crs": "CRS",
    "direction": "DirectionFrom",
    "directions": "NumberOfDirections",
    "foam_spacing": "Spacing",
    "frequencies": "NumberOfFrequencies",
    "height": "WaveHeight",
    "hs": "SignificantHeight",
    "insert": "Insertion",
    "kr_max": "MaxRefraction",
    "max_fronts": "MaximumNumberOfFronts",
    "max_memory": "MemoryLimit",
    "max_rays": "MaximumNumberOfRays",
    "max_reflections": "MaximumReflections",
    "min_depth": "MinimumDepth",
    "nodata": "NoData",
    "phase": "PhaseRule",
    "profile": "Section",
    "size": "ImageSize",
    "source": "FileName",
    "spray_rate": "Rate",
    "spray_steepness": "Steepest",
    "tp": "PeakPeriod",
    "transfer": "TransferFileName",
}

# Words in the order of the filters' enumerations.
CHOICES = {
    "amplitude": ("spacing", "tube"),
    "breaking": ("none", "gamma", "weggel", "miche", "dally", "battjes-janssen", "baldock"),
    "caustics": ("uniform", "geometric", "cap"),
    "combine": ("energy", "phase"),
    "dispersion": ("linear", "nonlinear"),
    "earth": ("plane", "ellipsoid"),
    "edge": ("contours", "edge", "none"),
    "insert": ("none", "retrace", "interpolate"),
    "phase": ("traced", "straight"),
    "positive": ("auto", "up", "down"),
    "scheme": ("ode", "snell"),
    "shape": ("pierson-moskowitz", "jonswap", "tma"),
    "spreading": ("hasselmann", "thon", "cosine", "normal"),
}

# Keywords that are in use only with a switch of the filter beside them.
_SWITCHES = {"crop": "UseCrop", "nodata": "UseNoData", "shore_normal": "UseShoreNormal"}


def property_of(keyword):
    """Name of the filters' property that a keyword sets."""
    return _PROPERTIES.get(keyword) or "".join(word.capitalize() for word in keyword.split("_"))


def number_of_choice(keyword, word):
    """Number of a word among the choices of a keyword; raises ValueError that lists them."""
    words = CHOICES[keyword]
    if word not in words:
        nearest = difflib.get_close_matches(str(word), words, 1)
        hint = f"; did you mean {nearest[0]!r}?" if nearest else ""
        raise ValueError(f"{keyword} must be one of {', '.join(words)}, not {word!r}{hint}")
    return words.index(word)


def configure(algorithm, **settings):
    """Set the properties of a filter by their keywords; None leaves the filter's default."""
    for keyword, value in settings.items():
        if value is None:
            continue
        if keyword in CHOICES:
            value = number_of_choice(keyword, value)
        elif keyword == "friction" and str(value).partition(":")[0] == "laminar" and hasattr(algorithm, "SetViscosity"):
            keyword, value = "viscosity", float(str(value).partition(":")[2] or 1e-6)
        elif isinstance(value, os.PathLike):
            value = os.fspath(value)
        try:
            getattr(algorithm, "Set" + property_of(keyword))(value)
        except (TypeError, ValueError):
            raise TypeError(f"{keyword} cannot be {value!r}") from None
        if keyword in _SWITCHES:
            getattr(algorithm, "Set" + _SWITCHES[keyword])(True)
    return algorithm
