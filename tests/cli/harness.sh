# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# Sourced by the tests of this folder: runs the program with its output kept, and counts what is not as it should be.
# Nothing stops at the first failure: a report of all of them is worth more.

failures=0
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT

fail() {
    echo "FAILED: $*" >&2
    failures=$((failures + 1))
}

# expect CODE ARGUMENTS...: runs $program; its output is then in $work/out and $work/err.
expect() {
    local wanted=$1 code=0
    shift
    "$program" "$@" > "$work/out" 2> "$work/err" || code=$?
    if [[ $code != "$wanted" ]]; then
        fail "'$*' gave exit code $code, wanted $wanted"
        sed 's/^/    /' "$work/err" >&2
    fi
}

# has FILE PATTERN: an extended regular expression found in $work/FILE.
has() { grep -qE -- "$2" "$work/$1" || fail "no '$2' in the $1 of the last run"; }
lacks() { ! grep -qE -- "$2" "$work/$1" || fail "'$2' in the $1 of the last run"; }

# number KEY: the value of a key of the JSON object in $work/out.
number() { sed -nE "s/^ *\"$1\": (-?[0-9.e+-]+),?\$/\1/p" "$work/out"; }

# holds EXPRESSION: arithmetic on decimal numbers, by awk.
holds() { awk "BEGIN { exit !($1) }" || fail "not true: $1"; }

finish() {
    if ((failures > 0)); then
        echo "$failures failed" >&2
        exit 1
    fi
    echo "all passed"
}
