#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# exports.sh LIBRARY INCLUDE_DIR CC [-DdIDESINGLE]
# Of C names the library exports exactly those that include/epode declares. (Its C++ names are for our own tools and tests.)
set -eu
library=$1
include=$2
cc=$3
define=${4:-}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export LC_ALL=C

nm -D --defined-only "$library" | awk '$NF ~ /^d[A-Z]/ {print $NF}' | sort -u > "$work/exported"
# names_of HEADER...: functions that they declare, or that what they include does.
names_of() {
    for header; do echo "#include \"$header\""; done |
        "$cc" -E -P -x c -DODE_API=EPODE_EXPORTED $define -I"$include" - | tr '\n' ' ' | tr ';' '\n' |
        sed -n 's/.*EPODE_EXPORTED[^(]* \**\(d[A-Z][A-Za-z0-9]*\)(.*/\1/p' | sort -u
}
names_of "$include"/ode/ode.h "$include"/ode/ext.h > "$work/ours"
names_of "$include"/epode/*.h | comm -23 - "$work/ours" > "$work/declared"
[ -s "$work/declared" ] || { echo "no name found in $include/epode: the headers were not read"; exit 1; }
comm -23 "$work/declared" "$work/exported" | sed 's/^/declared, but not exported: /' > "$work/wrong"
comm -13 "$work/declared" "$work/exported" | sed 's/^/exported, but not declared: /' >> "$work/wrong"
echo "$(wc -l < "$work/declared") functions of robots"
cat "$work/wrong"
[ ! -s "$work/wrong" ]
