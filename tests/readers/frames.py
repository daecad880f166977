# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads what `dump xyz`, `vtk` (with its springs and indices) and `povray` wrote, by the definitions of these formats
alone, and compares every number with `dump csv` and `dump link` of the same steps. Usage: frames.py FOLDER, which holds
cells.csv (step id species x y z ux uy uz length diameter generation), links.csv, c.xyz, c.*.vtp with column generation,
c.pvd, c.springs.*.vtp, c.springs.pvd and c.*.pov."""
import csv
import glob
import math
import os
import re
import sys
import xml.etree.ElementTree as xml

folder = sys.argv[1]


def table(name):
    steps = {}
    for row in csv.DictReader(open(os.path.join(folder, name))):
        steps.setdefault(int(row["step"]), []).append(row)
    return steps


cells, links = table("cells.csv"), table("links.csv")


def near(a, b, scale=1e-6):
    assert abs(a - b) <= 1e-12 * scale, "%.17g is not %.17g" % (a, b)


# ---- extended XYZ: a count, KEY=VALUE with Properties=NAME:TYPE:COLUMNS..., that many lines


def xyz_frames(path):
    lines = open(path).read().splitlines()
    while lines:
        n = int(lines[0])
        keys = dict(re.findall(r'(\w+)=("[^"]*"|\S+)', lines[1]))
        fields = re.findall(r"(\w+):([SRI]):(\d+)", keys["Properties"])
        rows = []
        for line in lines[2 : 2 + n]:
            words, row = line.split(), {}
            for name, kind, count in fields:
                take, words = words[: int(count)], words[int(count) :]
                row[name] = [{"S": str, "R": float, "I": int}[kind](w) for w in take]
            assert not words, "a line has the columns it says"
            rows.append(row)
        yield keys, rows
        lines = lines[2 + n :]


def turn(q, v):
    """v turned by the quaternion x y z w."""
    x, y, z, w = q
    t = [2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])]
    return [
        v[0] + w * t[0] + y * t[2] - z * t[1],
        v[1] + w * t[1] + z * t[0] - x * t[2],
        v[2] + w * t[2] + x * t[1] - y * t[0],
    ]


seen = []
for keys, rows in xyz_frames(os.path.join(folder, "c.xyz")):
    step = int(keys["step"])
    seen.append(step)
    assert len(rows) == len(cells[step])
    for row, cell in zip(rows, cells[step]):
        assert row["molecule"] == [int(cell["id"])] and row["species"] == [cell["species"]]
        for k in range(3):
            near(row["pos"][k], float(cell["xyz"[k]]))
        near(row["radius"][0], float(cell["diameter"]) / 2)
        near(row["aspherical_shape"][0], row["radius"][0])
        near(row["aspherical_shape"][2], float(cell["length"]) - float(cell["diameter"]))
        axis, turned = [float(cell[u]) for u in ("ux", "uy", "uz")], turn(row["orientation"], [0, 0, 1])
        if any(axis):
            near(abs(sum(a * b for a, b in zip(axis, turned))), 1, 100)
        near(sum(q * q for q in row["orientation"]), 1, 100)
assert seen == sorted(cells), "every step once, in order: %s" % seen
print("xyz: %d frames" % len(seen))

# ---- VTK XML PolyData


def arrays(part):
    found = {}
    for data in part:
        if data.tag == "DataArray":
            words = (data.text or "").split()
            if data.get("type") == "String":
                found[data.get("Name")] = "".join(chr(int(w)) for w in words).split("\0")[:-1]
            else:
                found[data.get("Name")] = [float(w) for w in words]
    return found


def polydata(path):
    root = xml.parse(path).getroot()
    assert root.tag == "VTKFile" and root.get("type") == "PolyData"
    piece = root.find("PolyData/Piece")
    points = arrays(piece.find("Points"))["points"]
    points = [points[i : i + 3] for i in range(0, len(points), 3)]
    assert len(points) == int(piece.get("NumberOfPoints"))
    lines = []
    for kind, number in (("Verts", "NumberOfVerts"), ("Lines", "NumberOfLines")):
        part = piece.find(kind)
        if part is None:
            assert piece.get(number) == "0"
            continue
        topology, start = arrays(part), 0
        assert len(topology["offsets"]) == int(piece.get(number))
        for end in topology["offsets"]:
            lines.append([points[int(i)] for i in topology["connectivity"][start : int(end)]])
            start = int(end)
    data = arrays(piece.find("CellData"))
    assert all(len(column) == len(lines) for column in data.values()), "cell data for every line"
    field = arrays(root.find("PolyData/FieldData"))
    return lines, data, field


def collection(path):
    root = xml.parse(path).getroot()
    assert root.tag == "VTKFile" and root.get("type") == "Collection"
    sets = [(float(s.get("timestep")), s.get("file")) for s in root.findall("Collection/DataSet")]
    assert [time for time, _ in sets] == sorted({time for time, _ in sets}), "times rise"
    for _, name in sets:
        assert os.path.exists(os.path.join(folder, name)), name
    return sets


def matches(lines, data, cell):
    i = data["id"].index(float(cell["id"]))
    ends = [lines[i][0], lines[i][-1]]
    for k in range(3):
        near((ends[0][k] + ends[1][k]) / 2, float(cell["xyz"[k]]))
    near(math.dist(*ends), float(cell["length"]) - float(cell["diameter"]))
    near(data["radius"][i], float(cell["diameter"]) / 2)
    assert data["generation"][i] == float(cell["generation"]) and data["species"][i] == cell["species"]


listed = collection(os.path.join(folder, "c.pvd"))
assert len(listed) == len(cells)
for time, name in listed:
    lines, data, field = polydata(os.path.join(folder, name))
    step = int(field["step"][0])
    assert field["TimeValue"] == [time] and name == "c.%d.vtp" % step
    assert len(lines) == len(cells[step])
    for cell in cells[step]:
        matches(lines, data, cell)
print("vtk: %d frames" % len(listed))

kinds = ["internal", "filial", "stick", "anchor", "spring"]
listed = collection(os.path.join(folder, "c.springs.pvd"))
assert len(listed) == sum(1 for step in cells if links.get(step))
springs = 0
for time, name in listed:
    lines, data, field = polydata(os.path.join(folder, name))
    rows = links[int(field["step"][0])]
    assert len(lines) == len(rows)
    for i, row in enumerate(rows):
        springs += 1
        assert kinds[int(data["kind"][i])] == row["kind"] and data["link"][i] == float(row["link"])
        assert (data["cell_a"][i], data["cell_b"][i]) == (float(row["cell_a"]), float(row["cell_b"]))
        for name in ("k", "rest", "length"):
            near(data[name][i], float(row[name]))
        near(math.dist(*lines[i]), float(row["length"]))
        near(data["strain"][i], (float(row["length"]) - float(row["rest"])) / float(row["rest"]), 1)
assert springs > 0
print("springs: %d" % springs)

# ---- POV-Ray: brackets close, and the objects are the cells

scenes = glob.glob(os.path.join(folder, "c.*.pov"))
assert scenes
for path in scenes:
    text = open(path).read()
    assert text.count("{") == text.count("}") and text.count("camera {") == 1
    step = int(path.split(".")[-2])
    vector = r"<([-+0-9.e]+),([-+0-9.e]+),([-+0-9.e]+)>"
    rods = re.findall(r"cylinder \{ %s, %s, ([-+0-9.e]+) \}" % (vector, vector), text)
    balls = re.findall(r"^sphere \{ %s, ([-+0-9.e]+)" % vector, text, re.M)
    assert len(rods) + len(balls) == len(cells[step])
    place = {(round(float(c["x"]) * 1e6, 6), round(float(c["y"]) * 1e6, 6)) for c in cells[step]}
    for rod in rods:
        a, b = [float(x) for x in rod[:3]], [float(x) for x in rod[3:6]]
        x, y = (a[0] + b[0]) / 2, (a[1] + b[1]) / 2
        assert any(abs(x - p[0]) < 1e-5 and abs(y - p[1]) < 1e-5 for p in place)
print("povray: %d scenes" % len(scenes))
