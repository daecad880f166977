#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A million rods that a script creates on a plane, on top of each other as they come: two cycles of growth, division and
# relaxation by the fastest preset and by the recommended one. Every number stays finite, the cells come apart, their
# mean place stays while they relax (forces along the plane cancel), a restart comes to the same bits, memory and time are bounded.
# Usage: million.sh [CELLS]   (from the repository's root, after a release build)
# Seed 1; both presets together took 297 s of processor on one thread of an AMD EPYC, and 2.7 GB at most; they left 10.5
# and 9.7 nm of overlap among 1,301,801 cells.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../tools/verdicts.sh"
sarcina=$PWD/build/release/bin/sarcina
cells=${1:-1000000}
side=$(awk -v n="$cells" 'BEGIN {printf "%.6g", 2 * sqrt(n)}') # um: 4 um2 a rod
cd "$scratch"

scene() { # PRESET
    cat <<S
accuracy      $1
seed          1
species       e rod diameter 0.75um
division      e midpoint mass 2.45e-15kg jitter 0
growth        e exponential rate 1.23/h sd 0.277/h
substratum    plane
force         collision
force         damping
link          internal e
region        field block 0 ${side}um 0 ${side}um 0.4um 2.4um
create_cells  e random $cells field orient xy mass uniform 50% 100% overlap yes
variable      deepest string \$(max(overlap))
run           1 grow 4min relax 50ms
write_restart million.rst
grow          4min
variable      x0 string \$(mean(x))
variable      y0 string \$(mean(y))
relax         50ms
expect        cells > $cells && cells < 1.6*$cells
# forces along the plane cancel
expect        abs(mean(x) - x0) < 0.1nm && abs(mean(y) - y0) < 0.1nm
# a number that is not finite would be in one of these sums
expect        abs(sum(x) + sum(y) + sum(z) + sum(length)) < 1e9m && sum(speed) < 1e9m/1s && sum(mass) < 1kg
expect        max(overlap) < 50nm && max(overlap) < 0.1*deepest
expect        min(zmin) > -50nm && max(zmax) < 10um && max(length) < 6um && max(speed) < 1mm/1s
print         "$1: \$(cells) cells, deepest overlap \$(max(overlap)/1nm:%.3g) nm of \$(deepest/1nm:%.3g), fastest \$(max(speed)*1s/1um:%.3g) um/s, limits met \$(caps)"
variable      after string "\$(mean(x)) \$(max(overlap)) \$(cells)"
read_restart  million.rst
run           1
expect        "\$(mean(x)) \$(max(overlap)) \$(cells)" == after
S
}

for preset in draft balanced; do
    scene $preset > million.in
    check "$preset" "$sarcina" -log million.log million.in
    sed -n "/^$preset:/p" million.log
    peak=$(sed -n 's/^Peak memory = \([0-9]*\).*/\1/p' million.log | tail -1)
    echo "peak memory $peak MB, $(sed -n 's/^Loop time of \([0-9.]*\) .*/\1/p' million.log | paste -sd' ') s of the clock a cycle"
    # 5 kB a cell, the snapshot to which a cycle may have to return and the restart in memory among them
    check "$preset takes more memory than 5 kB a cell" test "$peak" -lt $((100 + cells / 200))
done
verdicts_end
