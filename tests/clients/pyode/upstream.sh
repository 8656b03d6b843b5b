#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# upstream.sh LIBDIR FOLDER: pyode's own tests and tutorials (fetched into FOLDER) on our library in LIBDIR and on Debian's.
# Exit 77, ctest's skip, only where the sources can not be fetched.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
debian=${PARITY_DEBIAN_DIR:-/usr/lib/x86_64-linux-gnu}

if ! /usr/bin/python3 -c 'import ode' 2>/dev/null; then
    echo "pyode: install Debian's packages libode8 and python3-pyode (scripts/test does)" >&2
    exit 1
fi
if ! sources=$("$here/fetch.sh" "$2"); then
    echo "pyode: SKIPPED, NOT PASSED: pyode's sources can not be fetched from Debian's mirror" >&2
    exit 77
fi
exec /usr/bin/python3 -B "$here/upstream.py" "$sources" "$1/libode.so.8" "$debian/libode.so.8"
