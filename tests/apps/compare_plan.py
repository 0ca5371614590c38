#!/usr/bin/env python3
"""compare_plan.py PLAN RUN: are rays, steps and points of a run within the numbers of its plan, or a factor off them at most?"""
import re
import sys

# Minutes are told from hours. A sixth of the rays tells those of coasts with bays in their bays to a factor of 1.7.
FACTOR = 2.0


def planned(text):
    """Ranges in the order of the text: (low, high) of each "about A" or "about A to B"."""
    found = re.findall(r"about ([0-9.,e+-]+)(?: to ([0-9.,e+-]+))?(?= with| steps| rays| points)", text)
    number = lambda digits: float(digits.replace(",", ""))
    return [(number(low), number(high or low)) for low, high in found]


def done(text):
    traced = re.search(r"^rays +(\d+):.*?(\d+) points on.*?(\d+) steps", text, re.M)
    if traced:
        rays, points, steps = map(float, traced.groups())
        return [rays, steps, points]
    return [float(number) for number in re.search(r"^traced +(\d+) rays in (\d+) steps", text, re.M).groups()]


with open(sys.argv[1]) as plan, open(sys.argv[2]) as run:
    ranges, values = planned(plan.read()), done(run.read())
if len(ranges) != len(values):
    sys.exit(f"{len(ranges)} numbers are planned: {ranges}; {len(values)} came: {values}")
for (low, high), value in zip(ranges, values):
    if not low / FACTOR <= value <= high * FACTOR:
        sys.exit(f"{low:g} to {high:g} was planned, {value:g} came")
print("true")
