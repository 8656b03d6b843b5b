#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# run.sh LIBDIR: Debian's python3-pyode, a binary built for Debian's libode.so.8, on both libraries.
# The extension finds the library by its name alone (no RPATH), so LD_LIBRARY_PATH decides; the script reports from
# its own process map what was loaded. The extension is linked with -z now: every one of its symbols must be there.
set -eu
libdir=$1
here=$(cd "$(dirname "$0")" && pwd)
debian=${PARITY_DEBIAN_DIR:-/usr/lib/x86_64-linux-gnu}
python=/usr/bin/python3

if [ ! -e "$debian/libode.so.8" ] || ! "$python" -c 'import ode' 2>/dev/null; then
    echo "pyode: install Debian's packages libode8 and python3-pyode (scripts/test does)" >&2
    exit 1
fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
LD_LIBRARY_PATH=$libdir "$python" "$here/falling.py" >"$work/ours.txt"
LD_LIBRARY_PATH=$debian "$python" "$here/falling.py" >"$work/debian.txt" 2>"$work/messages.txt"
exec "$python" "$here/compare.py" "$work/ours.txt" "$work/debian.txt" "$libdir/libode.so.8" "$debian/libode.so.8"
