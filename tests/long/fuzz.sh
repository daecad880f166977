#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Wrong scripts and damaged files under the sanitizers: 3,000 and 750, others with another seed.
# Usage: fuzz.sh [COUNT [SEED]]   (from the repository's root, after scripts/test full or scripts/build asan)
set -euo pipefail
# what a mutant may ask for in vain is no error of the program's
export ASAN_OPTIONS=detect_leaks=0:hard_rss_limit_mb=4000:allocator_may_return_null=1
export UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1
exec build/asan/tests/fuzz "${1:-3000}" "${2:-1}" tests/script/*.in tests/language/tests/*.in examples/tutorial/*.in
