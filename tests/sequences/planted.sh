#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# planted.sh RANDOM_SEQUENCES LIBRARY INCLUDE C_COMPILER [SANITIZERS]
# A model that makes a mistake on purpose is found out, the sequence is cut down to a few operations, and what
# is written is a C program that compiles and runs.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

if "$1" --plant --operations 20000 --save "$work/found.c" >"$work/said"; then
    echo "the planted fault was not found"
    exit 1
fi
cat "$work/said"
left=$(sed -n 's/^\([0-9]*\) operations remain.*/\1/p' "$work/said")
if [ "$left" -gt 8 ]; then
    echo "the sequence was not cut down"
    exit 1
fi
"$4" ${5:+-fsanitize=$5} ${SINGLE:+-DdIDESINGLE} -I "$3" "$work/found.c" -o "$work/found" "$2" -Wl,-rpath,"$(dirname "$2")"
"$work/found"
grep -q 'dBodyDestroy(b\[' "$work/found.c"
