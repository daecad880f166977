# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the tables of a log as programs that read LAMMPS's logs do, each by its own marks; fails where they disagree.

lammps_logfile, pymatgen and atomman take what stands between a line that begins with "Per MPI rank memory allocation
(min/avg/max) =" and one that begins with "Loop time of": its first line is the heading, blanks separate the fields.
pizza.py looks for the heading, a line that holds "Step ", and the next "Loop time of". The Loop line itself is
"Loop time of T on P procs for N steps with M atoms". Usage: lammps_log.py FILE prints one line a table:
ROWS COLUMN... | the last row | N steps, M atoms.
"""
import re
import sys

BEGIN = "Per MPI rank memory allocation (min/avg/max) ="
END = "Loop time of"
MEMORY = re.compile(r"Per MPI rank memory allocation \(min/avg/max\) = (\S+) \| (\S+) \| (\S+) Mbytes$")
LOOP = re.compile(r"Loop time of (\S+) on (\d+) procs for (\d+) steps with (\d+) atoms$")
STAGE = re.compile(r"(\w+) +\| +(\S+) +\| +(\S+) +\| +(\S+) +\| +(\S+) +\| +(\S+)$")


def by_marks(lines):
    begins = [i for i, line in enumerate(lines) if line.startswith(BEGIN)]
    ends = [i for i, line in enumerate(lines) if line.startswith(END)]
    assert len(begins) == len(ends), "tables begin and end equally often"
    return [lines[b + 1 : e] for b, e in zip(begins, ends)]


def by_heading(lines):
    tables, rows = [], None
    for line in lines:
        if rows is None and "Step " in line:
            rows = []
        if rows is not None and line.startswith(END):
            tables.append(rows)
            rows = None
        if rows is not None:
            rows.append(line)
    return tables


def stages(lines):
    """The times of the sections of every timing table, which must sum to all of it."""
    for i, line in enumerate(lines):
        if line.startswith("MPI task timing breakdown"):
            share = 0.0
            for row in lines[i + 3 :]:
                fields = [f.strip() for f in row.split("|")]
                share += float(fields[5])
                assert row.startswith("Other") or STAGE.match(row), row
                if row.startswith("Other"):
                    break
            assert 99 < share < 101, "the stages are %g %% of the time" % share


lines = open(sys.argv[1]).read().splitlines()
tables = by_marks(lines)
assert tables == by_heading(lines), "two ways to find the tables"
loops = [m for m in map(LOOP.match, lines) if m]
assert len(loops) == len(tables)
assert sum(1 for m in map(MEMORY.match, lines) if m) == len(tables)
stages(lines)
for table, loop in zip(tables, loops):
    heading = table[0].split()
    rows = [[float(x) for x in line.split()] for line in table[1:]]
    assert all(len(row) == len(heading) for row in rows), "every row has every column"
    assert rows, "a table has rows"
    print(len(rows), *heading, "|", *table[-1].split(), "|", loop.group(3), "steps,", loop.group(4), "atoms")
