# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs a command on a terminal of its own. terminal.py raw|screen COMMAND...: prints all it wrote, or the lines that
stand on the screen at the end (a carriage return goes to the line's beginning, ESC [ K erases the rest of it)."""
import os
import pty
import sys

os.environ["TERM"] = "xterm"
pid, terminal = pty.fork()
if pid == 0:
    os.execvp(sys.argv[2], sys.argv[2:])
taken = b""
while True:
    try:
        data = os.read(terminal, 65536)
    except OSError:  # the other side is closed
        break
    if not data:
        break
    taken += data
status = os.waitpid(pid, 0)[1]
text = taken.decode()


def shown(line):
    cells, at = "", 0
    while line:
        if line.startswith("\r"):
            at, line = 0, line[1:]
        elif line.startswith("\x1b[K"):
            cells, line = cells[:at], line[3:]
        else:
            cells, at, line = cells[:at] + line[0] + cells[at + 1 :], at + 1, line[1:]
    return cells


if sys.argv[1] == "raw":
    sys.stdout.write(text)
else:
    print("\n".join(shown(line) for line in text.split("\r\n")))
sys.exit(os.waitstatus_to_exitcode(status))
