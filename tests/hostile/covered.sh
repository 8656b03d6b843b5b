#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# covered.sh LIBRARY HOSTILE_CALLS [PATTERN]
# Every function that the library exports (and whose name fits the pattern) is called with hostile values, or excused with a reason.
set -eu
export LC_ALL=C
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

nm -D --defined-only "$1" | awk '$(NF - 1) ~ /^[TWi]$/ {print $NF}' | grep -E "${3:-.}" | sort -u > "$work/exported"
"$2" --list > "$work/list"
grep -E '^[^ ]+ (called|excused)' "$work/list" | cut -d ' ' -f 1 | sort -u > "$work/known"

echo "$(grep -c ' called$' "$work/list") of $(wc -l < "$work/exported") functions are called"
grep ' excused: ' "$work/list" || true
comm -23 "$work/exported" "$work/known" > "$work/forgotten"
[ -s "$work/forgotten" ] || exit 0
while read -r name; do
    echo "not called: $(grep "^$name " "$work/list" || echo "$name: declared in no header that generate.py reads")"
done < "$work/forgotten"
exit 1
