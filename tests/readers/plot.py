# SPDX-License-Identifier: GPL-3.0-or-later
"""The longest line of a diagram that gnuplot drew as SVG against a column of a table: they must be proportional.
plot.py SVG CSV X Y"""
import csv
import re
import sys
import xml.etree.ElementTree as xml

svg, table, x, y = sys.argv[1:]
root = xml.parse(svg).getroot()
assert root.tag.endswith("svg")
lines = []
for path in root.iter("{http://www.w3.org/2000/svg}path"):
    numbers = [float(n) for n in re.findall(r"-?[0-9]+\.?[0-9]*", path.get("d"))]
    lines.append(list(zip(numbers[::2], numbers[1::2])))
line = max(lines, key=len)
rows = [r for r in csv.DictReader(open(table)) if r[y] != "nan"]
assert len(line) == len(rows), "%d points of %d rows" % (len(line), len(rows))
for axis, name in ((0, x), (1, y)):
    drawn, told = [p[axis] for p in line], [float(r[name]) for r in rows]
    low, high = told.index(min(told)), told.index(max(told))
    scale = (drawn[high] - drawn[low]) / (told[high] - told[low])
    for a, b in zip(drawn, told):
        assert abs(drawn[low] + scale * (b - told[low]) - a) < 0.1, (a, b)
