#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# run.sh LIBDIR PROBE COMPARE [--poses N]: the probe on our libode.so.8 in LIBDIR and on Debian's, then the comparison.
# PARITY_BEHAVIOUR=0.16: our worlds have that behaviour, and the rules of tolerances_016.tsv come first.
# Which library was measured is read from the process map by the probe itself ("#library PATH").
set -eu
libdir=$1 probe=$2 compare=$3
shift 3
here=$(cd "$(dirname "$0")" && pwd)
debian=${PARITY_DEBIAN_DIR:-/usr/lib/x86_64-linux-gnu}

if [ ! -e "$debian/libode.so.8" ]; then
    echo "parity: no $debian/libode.so.8: install Debian's package libode8 (scripts/test does)" >&2
    exit 1
fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
tolerances=$here/tolerances.tsv
if [ -n "${PARITY_BEHAVIOUR:-}" ]; then
    export EPODE_BEHAVIOUR="$PARITY_BEHAVIOUR"
    tolerances=$work/tolerances.tsv
    cat "$here/tolerances_016.tsv" "$here/tolerances.tsv" >"$tolerances"
fi
LD_LIBRARY_PATH=$libdir "$probe" "$@" --all >"$work/ours.txt"
LD_LIBRARY_PATH=$debian "$probe" "$@" --all >"$work/debian.txt"

ours=$(sed -n 's/^#library //p' "$work/ours.txt")
reference=$(sed -n 's/^#library //p' "$work/debian.txt")
if [ "$(realpath "$ours")" != "$(realpath "$libdir/libode.so.8")" ]; then
    echo "parity: measured $ours instead of $libdir/libode.so.8" >&2
    exit 1
fi
if [ "$(realpath "$reference")" != "$(realpath "$debian/libode.so.8")" ]; then
    echo "parity: the reference was $reference instead of $debian/libode.so.8" >&2
    exit 1
fi
"$compare" "$work/ours.txt" "$work/debian.txt" "$tolerances" "$here/differences.tsv"
