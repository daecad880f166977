# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by the checks of compiled code. Defines each_object, which reads the library's objects, one a line, from
# the file that CMake wrote, and prints "OBJECT SOURCE" with the source's path below src/.

each_object() {
    local object source
    while read -r object; do
        # .../sarcina_lib.dir/mechanics/force/collision.c.o: the folder of another target is one of these too
        source=${object##*.dir/}
        source=${source%.o}
        source=${source#./}
        [[ -e $object ]] || {
            echo "$object is missing: build first" >&2
            return 1
        }
        echo "$object $source"
    done <"$1"
}
