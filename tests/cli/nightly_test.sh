#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# scripts/nightly with parts that are known: one that fails in its middle stops no other, and is not forgotten.
set -euo pipefail
nightly=$(realpath "$(dirname "$0")/../../scripts/nightly")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export EPODE_NIGHTLY_PARTS=$work/parts EPODE_NIGHTLY_RESULTS=$work/results
cat > "$work/parts" <<'PARTS'
part first "passes"
run_first() { echo "first's line"; }
part broken "fails in its middle, and goes no further"
run_broken() { false; echo "past the fault"; }
part piped "fails at the beginning of a pipe"
run_piped() { false | cat; }
part last "passes"
run_last() { [ -e "$EPODE_NIGHTLY_RESULTS/broken.result" ]; }
PARTS
fail() { echo "nightly: $*" >&2; cat "$work/out" >&2; exit 1; }
answers() {  # CODE ARGUMENTS...
  local wanted=$1 code=0
  shift
  "$nightly" "$@" > "$work/out" 2>&1 || code=$?
  [ $code -eq "$wanted" ] || fail "'$*' answers $code, not $wanted"
}
shows() { grep -qE "$1" "$work/out" || fail "does not show: $1"; }

answers 1
shows '^last +good +[0-9]+ '
shows '^broken +FAILED +[0-9]+ '
shows '^piped +FAILED '
shows "^first's line"
if grep -q 'past the fault' "$work/out"; then fail "a part goes on behind a fault"; fi
grep -q "first's line" "$work/results/first.log" || fail "no log"
answers 0 first last
if grep -q '^broken' "$work/out"; then fail "tells of parts that were not asked for"; fi
answers 1 --summary
rm "$work/results/broken.result" "$work/results/piped.result"
answers 1 --summary
shows '^broken +not run'
answers 0 --list
shows '^piped +fails at the beginning'
answers 2 no_such_part
shows "unknown part 'no_such_part'"
answers 2 --no-such-option
echo "nightly: good"
