#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The colony of colony.c from Python, without a package: the class below is all that a notebook needs.

    python3 colony.py [libsarcina.so]
"""

import array
import ctypes
import sys


class SarcinaError(Exception):
    """What a command found wrong, as the program shows it."""


class Sarcina:
    """A scene and its command language: run(text), run_file(path), value(expression), cells(expression)."""

    def __init__(self, library="libsarcina.so"):
        self._c = ctypes.CDLL(library)
        self._c.sarcina_create.restype = ctypes.c_void_p
        self._c.sarcina_error.restype = ctypes.c_char_p
        self._c.sarcina_cells.restype = ctypes.c_size_t
        self._scene = ctypes.c_void_p(self._c.sarcina_create(None))
        if not self._scene:
            raise SarcinaError("the tables of units (UDUNITS-2) are missing")

    def __del__(self):
        if getattr(self, "_scene", None):
            self._c.sarcina_free(self._scene)

    def _must(self, status):
        if status:
            raise SarcinaError(self._c.sarcina_error(self._scene).decode())

    def run(self, text):
        """Runs commands, one a line."""
        self._must(self._c.sarcina_run(self._scene, text.encode()))

    def run_file(self, path):
        """Runs the commands of a file."""
        self._must(self._c.sarcina_run_file(self._scene, path.encode()))

    def set(self, **variables):
        """Sets variables before a script does, as -var: set(seed=7)."""
        for name, value in variables.items():
            self._must(self._c.sarcina_set_variable(self._scene, name.encode(), str(value).encode()))

    def value(self, expression):
        """One number of the scene, such as "gyration/1um"."""
        value = ctypes.c_double()
        self._must(self._c.sarcina_value(self._scene, expression.encode(), ctypes.byref(value)))
        return value.value

    def cells(self, expression):
        """A number for each cell, such as "x/1um", in the order of their ids; numpy.asarray takes it as it is."""
        values = array.array("d", bytes(8 * self._c.sarcina_cells(self._scene)))
        address, _ = values.buffer_info()
        self._must(self._c.sarcina_cell_values(self._scene, expression.encode(), ctypes.c_void_p(address)))
        return values


def main():
    scene = Sarcina(*sys.argv[1:2])
    scene.run("""
        species       ball coccus
        growth        ball exponential rate 1/h sd 10%
        division      ball random mass 6e-16kg
        force         collision
        force         damping
        create_cells  ball single 0 0 0
    """)
    for _ in range(5):
        scene.run("run 20 grow 4min relax 1s")
        distances = scene.cells("sqrt(x^2 + y^2 + z^2)/1um")
        print(f"{scene.value('time/1h'):.2f} h  {len(distances):4} cells  {max(distances):5.2f} um")


if __name__ == "__main__":
    main()
