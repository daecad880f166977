# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by the checks of compiled code, which read the library's objects from a list that CMake wrote, one a line.

# A line an object, its symbols as nm lists them with these options: "SOURCE TYPE SYMBOL", the source below src/.
# Usage: list_symbols OBJECT_LIST NM_OPTION...
list_symbols() {
    local list=$1
    shift
    # /…/sarcina_lib.dir/./mechanics/force/collision.c.o:0000000000000000 T force_collision
    grep . "$list" | tr '\n' '\0' | xargs -0 nm --print-file-name "$@" |
        sed -E 's|^.*\.dir/(\./)?||; s|\.o:[0-9a-f ]*| |; s/@.*//'
}

count_objects() {
    grep -c . "$1"
}

# The lines of standard input ("SOURCE ... SYMBOL") that none of the lines "SOURCE SYMBOL" of $1 excuses.
without_excused() {
    awk -v excused="$1" '
        BEGIN {
            n = split(excused, line, "\n")
            for (i = 1; i <= n; i++) {
                split(line[i], word, " ")
                is_excused[word[1] " " word[2]] = 1
            }
        }
        !(($1 " " $NF) in is_excused)'
}
