#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A million growth steps of a few rods that grow, divide, and are washed out by half whenever they are more than eight:
# the clock is that many steps to rounding, nothing is lost or left over, memory is that of the beginning, and two
# halves joined by a restart come to the same bits as the whole.
# Usage: growth_steps.sh [STEPS]   (from the repository's root, after a release build)
# Seed 1; on one thread of an AMD EPYC 93 s of processor for both presets (draft, balanced), 11.2 to 18.4 MB, 151,932 cells
# in all: of each that is gone the program keeps its mother, 16 bytes.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../tools/verdicts.sh"
sarcina=$PWD/build/release/bin/sarcina
steps=${1:-1000000}
early=$((steps / 100)) half=$((steps / 2))
cd "$scratch"

scene() { # PRESET
    cat <<S
accuracy      $1
seed          1
species       e rod diameter 0.75um
division      e midpoint mass 2.45e-15kg
growth        e exponential rate 1/h sd 10%
substratum    plane
force         collision
force         damping
link          internal e
thermo        $steps
S
}
first="create_cells e single 0 0 0 orient x mass 60%"
cycles() { echo "run $1 grow 1min relax 10ms every 40 \"delete_cells all where cells > 8 fraction 50%\""; }
state="write_dump all csv %s.csv id parent x y z ux uy uz length mass rate vx vy vz generation age"
finish() { # NAME
    printf "$state\n" "$1"
    echo "print '$1 step \$(step) drift \$(time/60s - step) relaxed \$(abs(relaxed/10ms - step) < 0.000001) cells \$(cells) deepest \$(max(overlap) < 50nm) low \$(min(zmin) > -20nm) highest \$(max(id))' file $1.txt"
}

# Peak memory in MB after each run of a log.
peaks() { sed -n 's/^Peak memory = \([0-9.]*\) Mbytes.*/\1/p' "$1"; }
# What the program must keep for ever: of each cell that is gone its id and its mother's, 16 bytes, in a block that
# doubles and is copied as it grows.
is_bounded() { # LOG IDS
    peaks "$1" | awk -v ids="$2" 'NR == 1 {from = $1} {to = $1} END {print "  " from " MB, then " to; exit !(to - from < 4 + 4 * 16e-6 * ids)}'
}

for preset in draft balanced; do
    begin=$SECONDS
    { scene $preset; echo "$first"; cycles $early; cycles $((steps - early)); finish whole; } > whole.in
    { scene $preset; echo "$first"; cycles $half; echo "write_restart half.rst"; } > half.in
    { echo "read_restart half.rst"; cycles $((steps - half)); finish halves; } > halves.in
    check "$preset: the whole" "$sarcina" -log whole.log whole.in
    check "$preset: the first half" "$sarcina" -log none half.in
    check "$preset: the second half" "$sarcina" -log none halves.in
    cat whole.txt
    check "$preset: clock and cells" grep -q "step $steps drift 0 relaxed 1 cells [0-9]* deepest 1 low 1" whole.txt
    check "$preset: halves and the whole" cmp whole.csv halves.csv
    check "$preset: what they say" cmp <(sed s/whole// whole.txt) <(sed s/halves// halves.txt)
    check "$preset: memory" is_bounded whole.log "$(sed 's/.*highest //' whole.txt)"
    echo "$preset: $((SECONDS - begin)) s"
done
verdicts_end
