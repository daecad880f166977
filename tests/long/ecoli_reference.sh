#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Twenty seeds of examples/ecoli/default.in against the original program's ten, at equal cell number.
# Usage: ecoli_reference.sh [SEEDS [FOLDER]]   (from the repository's root, after a release build)
set -euo pipefail
seeds=${1:-20}
folder=${2:-$(mktemp -d)}
[[ $# -ge 2 ]] || trap 'rm -rf "$folder"' EXIT

colonies=()
for ((seed = 1; seed <= seeds; seed++)); do
    colony=$folder/seed$seed
    mkdir -p "$colony"
    build/release/bin/sarcina examples/ecoli/default.in -var seed "$seed" -var out "$colony" >"$colony/stdout.txt"
    colonies+=("$colony")
done
build/release/tests/compare_ecoli tests/data/ecoli "${colonies[@]}"
