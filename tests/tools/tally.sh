# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by scripts/test. Counts what passed and failed over programs that count for themselves: cmocka's, `sarcina
# -test` and the checks, whose last line ends in "N passed, N failed". A program that says neither counts as one test.

tally_passed=0
tally_failed=0
tally_began=$SECONDS

tally_stage() {
    printf '[%4d s] %s\n' $((SECONDS - tally_began)) "$1"
}

tally_failed() {
    echo "FAILED: $1"
    tally_failed=$((tally_failed + 1))
}

# The two numbers that a program's output (standard input) and exit status ($1) amount to.
tally_numbers() {
    awk -v status="$1" '
        /^\[  PASSED  \] [0-9]+ test/ { passed += $4; said = 1 }
        /^\[  FAILED  \] [0-9]+ test/ { failed += $4; said = 1 }
        /(^| )[0-9]+ passed, [0-9]+ failed$/ { last_passed = $(NF - 3); last_failed = $(NF - 1); said = 1 }
        END {
            passed += last_passed
            failed += last_failed
            if (!said && !status)
                passed = 1
            # a crash, a leak, a time-out: nothing that the program itself could count
            if (status && !failed)
                failed = 1
            print passed + 0, failed + 0
        }'
}

# Runs a program; its output is shown when it fails.
tally_program() {
    local log status=0 passed failed
    log=$(mktemp)
    "$@" >"$log" 2>&1 || status=$?
    read -r passed failed < <(tally_numbers "$status" <"$log")
    [[ $status -eq 0 && $failed -eq 0 ]] || cat "$log"
    rm -f "$log"
    tally_passed=$((tally_passed + passed))
    tally_failed=$((tally_failed + failed))
}

# Runs the tests of a build folder by ctest, and reads from its log what each said.
tally_ctest() {
    local folder=$1 log=$1/Testing/Temporary/LastTest.log status=0 passed failed
    ctest --test-dir "$folder" -j "$(nproc)" --timeout 900 --output-on-failure --no-tests=error \
        >"$folder/ctest.log" 2>&1 || status=$?
    [[ $status -eq 0 ]] || cat "$folder/ctest.log"
    read -r passed failed < <(awk '
        function count() {
            if (!said)
                passed += good
            passed += last_passed
            failed_here += last_failed
            if (!good && !failed_here)
                failed_here = 1
            failed += failed_here
        }
        /^[0-9]+\/[0-9]+ Testing: / { said = failed_here = last_passed = last_failed = 0 }
        /^\[  PASSED  \] [0-9]+ test/ { passed += $4; said = 1 }
        /^\[  FAILED  \] [0-9]+ test/ { failed_here += $4; said = 1 }
        /(^| )[0-9]+ passed, [0-9]+ failed$/ { last_passed = $(NF - 3); last_failed = $(NF - 1); said = 1 }
        /^Test Passed\.$/ { good = 1; count() }
        /^Test (Failed|time-out|not run)|^Test .*(Exception|Timeout|SIGNAL)/ { good = 0; count() }
        END { print passed + 0, failed + 0 }' "$log")
    # ctest saw a failure that its log does not show
    [[ $status -eq 0 || $failed -gt 0 ]] || failed=1
    tally_passed=$((tally_passed + passed))
    tally_failed=$((tally_failed + failed))
}

# The counts out of a subshell and back.
tally_save() {
    echo "$tally_passed $tally_failed" >build/tally
}
tally_load() {
    read -r tally_passed tally_failed <build/tally
}

tally_end() {
    printf 'time %d s\n' $((SECONDS - tally_began))
    printf '%d passed, %d failed\n' "$tally_passed" "$tally_failed"
    [[ $tally_failed -eq 0 ]]
}
