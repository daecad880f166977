#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Ten E. coli colonies with the numbers that the original program drew, against its ten: a case's links on their own.
# Usage: ecoli_draws.sh [CASE...]   (from the repository's root, after a release build; two CPU minutes a case)
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../tools/verdicts.sh"
[[ $# -gt 0 ]] || set -- default anchor anchor2x anchor05x filial
for case in "$@"; do
    echo "== $case"
    status=0
    build/release/bin/oracle-colony tests/data/ecoli "$case" || status=$?
    verdict $status "$case"
done
verdicts_end
