#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# planted.sh SCRIPTS_GOLDEN BUILD: the script reports a hash that has moved, one that no test prints and one without an entry;
# --update mends all three and leaves the frozen ones.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
run() { "$1" --build "$2" --tables "$work" "${@:3}" > "$work/said"; }
finds() { grep -qE "$1" "$work/said" || { echo "not '$1':"; cat "$work/said"; exit 1; }; }
head='// run: unit_tests Hypotenuse.*'
table=$(dirname "$0")/unit.inc
cp "$table" "$work/unit.inc"
run "$1" "$2" || { echo "the true table is refused:"; cat "$work/said"; exit 1; }

printf '%s\n{"unit/hypotenuse", 0x0123456789abcdef},\n{"unit/unused", 0x0123456789abcdef},\n' "$head" > "$work/unit.inc"
cp "$work/unit.inc" "$work/frozen.inc"
if run "$1" "$2"; then echo "planted hashes are not found"; exit 1; fi
finds 'unit/hypotenuse: 0x0123456789abcdef -> 0x'
finds 'unit/unused: no test prints it'
if run "$1" "$2" --update; then echo "a frozen hash has moved and is accepted"; exit 1; fi
[ "$(tail -n 1 "$work/unit.inc")" = "$(tail -n 1 "$table")" ] || { echo "--update writes something else"; exit 1; }
[ "$(grep -c unused "$work/unit.inc")" -eq 0 ] || { echo "--update leaves what no test prints"; exit 1; }
[ "$(grep -c 0123456789abcdef "$work/frozen.inc")" -eq 2 ] || { echo "--update writes frozen hashes"; exit 1; }

rm "$work/frozen.inc"
echo "$head" > "$work/unit.inc"
if run "$1" "$2"; then echo "a hash without an entry is accepted"; exit 1; fi
finds 'unit/hypotenuse: new -> 0x'
