"""The panels of the ParaView plugin against the headers of the filters: every property is there, with its default, its
range of choices, a help text and its unit. Needs no ParaView."""

import re
import unittest
import xml.etree.ElementTree as xml
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FILTERS = ROOT / "filters"
PANELS = sorted((ROOT / "apps" / "paraview" / "plugin").glob("*.xml"))

# Properties that have no place in a panel, and why.
LEFT_OUT = {
    ("vtkSwellSeafloorReader", "CrossValidate"): "only for the report of the program",
    ("vtkSwellMap", "WaterLevel"): "that of the rays goes first",
    ("vtkSwellStations", "WaterLevel"): "that of the rays goes first",
    ("vtkSwellSurface", "Time"): "the animation has it",
    ("vtkSwellSurfaceProbe", "Time"): "the animation has it",
    ("vtkSwellSpray", "Time"): "the animation has it",
    ("vtkSwellFoamMap", "Time"): "the animation has it",
    ("vtkSwellProjectedGrid", "Time"): "the animation has it",
    ("vtkSwellSea", "Time"): "the animation has it",
    ("vtkSwellSpectralMap", "KeepSpectra"): "spectra are no arrays",
    ("vtkSwellSpectralMap", "KeepTransfer"): "rays of a sea are no arrays",
}

# Classes that are no algorithms, and what they are.
NO_FILTERS = {
    "vtkSwellSeaFunction": "the implicit function of vtkSwellSea",
    "vtkSwellSurfaceAlgorithm": "the base of what is made of the surface",
}

# Where a panel begins with something else than the class.
OTHER_DEFAULTS = {
    ("vtkSwellSeafloorReader", "FileName"): "babbage",
    ("vtkSwellCrests", "MaxGapOfRays"): "1",
    ("vtkSwellBreakerLine", "MaxGapOfRays"): "1",
}

# Lists of values: the method that adds one.
LISTS = {("vtkSwellContours", "AddLevel")}

# Labels make the names in ParaView's Python (WaterLevelMetres), so units are words there.
UNITS = {"m": "Metres", "s": "Seconds", "degrees": "Degrees", "m/s": "Metres per Second",
         "m/s2": "Metres per Second Squared", "m2/s3": "m2/s3", "Hz": "Hertz"}
UNIT = r"(?:, |in |by )(m|s|degrees|m/s|m/s2|m2/s3|Hz)(?: clockwise[^.]*| offshore)?[.:;,]"


class Header:
    """What can be set in a class of the filters, with what it inherits."""

    def __init__(self, name):
        self.text = ""
        while name.startswith("vtkSwell"):
            text = (FILTERS / f"{name}.h").read_text()
            self.text += text
            name = re.search(r"^class \w+ \w+ : public (\w+)", text, re.M).group(1)
        enumerators = re.findall(r"^\s+([A-Z_]+) = (\d+)", self.text, re.M)
        self.numbers = {word: int(number) for word, number in enumerators}
        self.kinds = {
            words[1]: words[0]
            for words in re.findall(r"vtkSet(\w*)Macro\((\w+)", self.text)
        }
        self.choices = {
            prop: range(self.number(low), self.number(high) + 1)
            for prop, low, high in re.findall(r"vtkSetClampMacro\((\w+), int, (\w+), (\w+)\)", self.text)
        }
        # Choices with gaps between their numbers are those of the enumeration of that name.
        for prop in re.findall(r"vtkSetMacro\((\w+), int\)", self.text):
            words = re.search(rf"enum {prop}s\b[^{{]*{{([^}}]*)}}", self.text)
            if words:
                self.choices[prop] = [int(number) for number in re.findall(r"= (\d+)", words.group(1))]

    def number(self, word):
        return int(word) if word.isdigit() else self.numbers[word]

    def default(self, prop):
        """The member's initial value, as a list of numbers or a string."""
        found = re.search(rf"^  [\w:*]+\*? {prop}(?:\[\d\])?(?: = (.*))?;", self.text, re.M)
        value = found.group(1)
        if value is None or value == "nullptr":
            return ""
        if value.startswith('"'):
            return value.strip('"')
        if "infinity" in value:
            return [0.0]  # stands for it
        return [self.scalar(word) for word in value.strip("{} ").split(", ")]

    def scalar(self, word):
        if word in ("true", "false"):
            return float(word == "true")
        return float(self.numbers.get(word, word))


class Panels:
    """The proxies of the XML files, with what they inherit."""

    def __init__(self):
        self.groups = {}
        for file in PANELS:
            for group in xml.parse(file).getroot():
                for proxy in group:
                    self.groups[group.get("name"), proxy.get("name")] = proxy
        self.shown = [proxy for (group, _), proxy in self.groups.items() if group in ("sources", "filters")]

    def properties(self, proxy):
        """The properties of a proxy by the command that sets them."""
        found = {}
        if proxy.get("base_proxyname"):
            found = self.properties(self.groups[proxy.get("base_proxygroup"), proxy.get("base_proxyname")])
        for item in proxy:
            if item.tag.endswith("VectorProperty") and item.get("command"):
                found[item.get("command")] = item
        return found

    def grouped(self, proxy):
        """The properties that stand in groups, and the names of those groups."""
        names = []
        if proxy.get("base_proxyname"):
            names = self.grouped(self.groups[proxy.get("base_proxygroup"), proxy.get("base_proxyname")])
        return names + [(group.get("name"), item.get("name")) for group in proxy.iter("PropertyGroup") for item in group]


class PanelTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.panels = Panels()

    def test_every_filter_has_one(self):
        listed = set(re.findall(r"^  (vtkSwell\w+)", (FILTERS / "CMakeLists.txt").read_text(), re.M))
        shown = {proxy.get("class") for proxy in self.panels.shown}
        self.assertEqual(listed - shown - set(NO_FILTERS), set(), "filters without a panel in apps/paraview/plugin")
        self.assertEqual(shown - listed, set(), "panels without a filter")

    def test_every_property_is_there(self):
        for name in {proxy.get("class") for proxy in self.panels.shown}:
            header = Header(name)
            found = {}
            for proxy in self.panels.shown:
                if proxy.get("class") == name:
                    found.update(self.panels.properties(proxy))
            lists = {command for kind, command in LISTS if kind == name}
            wanted = {"Set" + prop for prop in header.kinds if (name, prop) not in LEFT_OUT} | lists
            self.assertEqual(wanted - set(found), set(), f"properties of {name} without a panel in apps/paraview/plugin")
            self.assertEqual(set(found) - wanted, set(), f"panel of {name} without a property")

    def test_defaults_and_choices_are_those_of_the_class(self):
        compared = 0
        for proxy in self.panels.shown:
            name = proxy.get("class")
            header = Header(name)
            for command, item in self.panels.properties(proxy).items():
                if (name, command) in LISTS or item.get("panel_visibility") == "never":
                    continue
                prop = command[3:]
                where = f"{name}.{prop}"
                self.assertEqual(item.get("name"), prop)
                text = item.get("default_values")
                if (name, prop) in OTHER_DEFAULTS:
                    self.assertEqual(text, OTHER_DEFAULTS[name, prop], where)
                elif item.tag == "StringVectorProperty":
                    self.assertEqual(text, header.default(prop), where)
                elif prop == "ShoreNormal":
                    continue  # not in use before it is set
                else:
                    self.assertEqual([float(word) for word in text.split()], header.default(prop), where)
                    compared += 1
                enumeration = item.find("EnumerationDomain")
                if prop in header.choices:
                    self.assertIsNotNone(enumeration, f"{where} is no menu")
                    values = [int(entry.get("value")) for entry in enumeration]
                    self.assertEqual(values, list(header.choices[prop]), where)
                else:
                    self.assertIsNone(enumeration, where)
        self.assertGreater(compared, 80)

    def test_everything_has_a_label_a_help_text_and_its_unit(self):
        for proxy in self.panels.shown:
            name = proxy.get("name")
            words = proxy.find("Documentation")
            self.assertTrue(words is not None and words.get("short_help") and words.get("long_help"), name)
            self.assertEqual([item.get("category") for item in proxy.iter("ShowInMenu")], ["Swellray"], name)
            self.assertTrue(proxy.get("label").startswith("Swell "), name)
            for item in self.panels.properties(proxy).values():
                where = f"{name}.{item.get('name')}"
                self.assertTrue(item.get("label"), where)
                text = item.findtext("Documentation")
                self.assertTrue(text, where)
                unit = re.search(UNIT, text)
                if item.tag == "DoubleVectorProperty" and unit:
                    self.assertTrue(item.get("label").endswith(f"({UNITS[unit.group(1)]})"), f"{where}: no unit in the label")

    def test_groups_name_properties_of_their_own(self):
        for proxy in self.panels.shown:
            names = {item.get("name") for item in self.panels.properties(proxy).values()}
            grouped = self.panels.grouped(proxy)
            self.assertEqual({name for _, name in grouped} - names, set(), proxy.get("name"))
            self.assertEqual(len({name for _, name in grouped}), len(grouped), proxy.get("name"))


if __name__ == "__main__":
    unittest.main()
