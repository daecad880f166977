# SPDX-License-Identifier: GPL-3.0-or-later
"""The longest line of a diagram that gnuplot drew as SVG against a column of a table: they must be proportional. With
mean for Y, the shade against mean -+ ci95 too.
plot.py SVG CSV X Y [COLUMN=TEXT...]: of the rows where the columns have these texts"""
import csv
import re
import sys
import xml.etree.ElementTree as xml

svg, table, x, y = sys.argv[1:5]
wanted = [w.split("=", 1) for w in sys.argv[5:]]
root = xml.parse(svg).getroot()
assert root.tag.endswith("svg")


def points(text):
    numbers = [float(n) for n in re.findall(r"-?[0-9]+\.?[0-9]*", text)]
    return list(zip(numbers[::2], numbers[1::2]))


def scale_of(drawn, told):
    low, high = told.index(min(told)), told.index(max(told))
    scale = (drawn[high] - drawn[low]) / (told[high] - told[low])
    return lambda value: drawn[low] + scale * (value - told[low])


namespace = "{http://www.w3.org/2000/svg}"
canvas = root.find(namespace + "g")
for patterns in canvas.findall(namespace + "defs"):
    canvas.remove(patterns)
line = max((points(p.get("d")) for p in root.iter(namespace + "path")), key=len)
rows = [r for r in csv.DictReader(open(table)) if r[y] != "nan" and all(r[k] == v for k, v in wanted)]
assert len(line) == len(rows), "%d points of %d rows" % (len(line), len(rows))
places = []
for axis, name in ((0, x), (1, y)):
    drawn, told = [p[axis] for p in line], [float(r[name]) for r in rows]
    places.append(scale_of(drawn, told))
    for a, b in zip(drawn, told):
        assert abs(places[axis](b) - a) < 0.1, (a, b)

if y == "mean":
    shade = [q for p in root.iter(namespace + "polygon") for q in points(p.get("points"))]
    for r in rows:
        for side in (-1, 1):
            at = places[0](float(r[x])), places[1](float(r[y]) + side * float(r["ci95"]))
            assert min(abs(at[0] - q[0]) + abs(at[1] - q[1]) for q in shade) < 0.3, at
