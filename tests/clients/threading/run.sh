#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# run.sh LIBDIR CLIENT: one binary on our libode.so.8 in LIBDIR and on Debian's. Both must find everything in
# order, in the same judgements; ours in addition to the last bit.
set -eu
libdir=$1 client=$2
debian=${PARITY_DEBIAN_DIR:-/usr/lib/x86_64-linux-gnu}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

try() { # directory, output, argument
    used=$(LD_LIBRARY_PATH=$1 ldd "$client" | sed -n 's/.*libode.so.8 => \([^ ]*\).*/\1/p')
    if [ "$(realpath "$used")" != "$(realpath "$1/libode.so.8")" ]; then
        echo "the program would run on $used instead of $1/libode.so.8" >&2
        return 1
    fi
    LD_LIBRARY_PATH=$1 "$client" $3 > "$work/$2" || { cat "$work/$2"; echo "wrong on $used"; return 1; }
}
try "$libdir" ours bits
try "$debian" theirs ""
if ! diff "$work/ours" "$work/theirs"; then
    echo "the two libraries were judged differently" >&2
    exit 1
fi
lines=$(grep -c ': ok$' "$work/ours")
[ "$lines" -ge 60 ] || { echo "only $lines judgements" >&2; exit 1; }
echo "$lines judgements, the same on both libraries"
