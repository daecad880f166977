# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by the checks: counts what holds and what fails, shows what a failure printed, and ends with the line that
# scripts/test reads. $scratch is a folder of the check's own, which goes with it.
scratch=$(mktemp -d)
said=$scratch.said # what the command of the check or want before printed
verdicts_clean() {
    rm -rf "$scratch" "$said" "$said.next"
}
trap verdicts_clean EXIT
passed=0 failed=0

# verdict STATUS WHAT: counts what was found out elsewhere; 0 holds
verdict() {
    if [[ $1 == 0 ]]; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAILED: $2"
    fi
}

# Runs a command into what will be $said; its exit code is in $code.
verdicts_run() {
    code=0
    [[ ! -e $said.next ]] || mv "$said.next" "$said"
    "$@" >"$said.next" 2>&1 || code=$?
}

# check WHAT COMMAND...: the command succeeds
check() {
    local what=$1 code
    shift
    verdicts_run "$@"
    [[ $code == 0 ]] || what+=": $(tail -n 20 "$said.next")"
    verdict "$code" "$what"
}

# wants CODE TEXT COMMAND...: the command, with nothing to read, ends with this code and prints this text somewhere
wants() {
    local due=$1 text=$2 code
    shift 2
    verdicts_run "$@" </dev/null
    if [[ $code == "$due" ]] && { [[ -z $text ]] || grep -qF -- "$text" "$said.next"; }; then
        verdict 0
    else
        verdict 1 "$*: ended with $code (due $due), printed: $(head -c 500 "$said.next") (due: $text)"
    fi
}

# await FILE...: all of them are there; some minutes are as good as never
await() {
    local file
    for file in "$@"; do
        for ((i = 0; i < 3000; i++)); do
            [[ ! -e $file ]] || continue 2
            sleep 0.1
        done
        verdict 1 "waited in vain for $file"
    done
}

# gone PROCESS: whether it ends, sooner or later; a zombie has ended
gone() {
    local i
    for ((i = 0; i < 3000; i++)); do
        [[ $(ps -o stat= -p "$1") == [!Z]* ]] || return 0
        sleep 0.1
    done
    return 1
}

# The last line; nothing looked at is a failure too.
verdicts_end() {
    echo "$passed passed, $failed failed"
    [[ $failed == 0 && $passed -gt 0 ]]
}
