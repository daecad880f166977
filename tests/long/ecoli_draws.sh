#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Ten E. coli colonies with the numbers that the original program drew, against its ten: a case's links on their own.
# Usage: ecoli_draws.sh [CASE...]   (from the repository's root, after a release build; two CPU minutes a case)
set -euo pipefail
[[ $# -gt 0 ]] || set -- default anchor anchor2x anchor05x
passed=0 failed=0
for case in "$@"; do
    echo "== $case"
    if build/release/bin/oracle-colony tests/data/ecoli "$case"; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
    fi
done
echo "$passed passed, $failed failed"
[[ $failed -eq 0 ]]
