#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# abidiff.sh LIBRARY: what abidiff (libabigail) says of Debian's libode.so.8 and LIBRARY. Debian's mangled C++
# internals and stray data are not ours to keep (abidiff.suppr); what is missing must be in missing_functions.txt.
# No debugging information is needed: types are compared by functions.sh and layouts.inc.
set -eu
library=$1
here=$(cd "$(dirname "$0")" && pwd)
debian=${EPODE_DEBIAN_DIR:-/usr/lib/x86_64-linux-gnu}/libode.so.8
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cp "$here/abidiff.suppr" "$work/suppr"
grep -v '^#' "$here/missing_functions.txt" |
    sed 's/.*/\n[suppress_function]\n  change_kind = deleted-function\n  symbol_name = &/' >> "$work/suppr"
status=0
abidiff --suppressions "$work/suppr" --no-added-syms "$debian" "$library" > "$work/report" || status=$?
cat "$work/report"
# Bits of the exit status: 1 and 2 are trouble with files or options, 4 a change, 8 an incompatible one.
if [ $status -ne 0 ]; then
    echo "abidiff: exit status $status"
    exit 1
fi
