#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# run.sh LIBDIR FOLDER: planning with Debian's libompl over our library in LIBDIR and over Debian's own. OMPL's ODE demo (fetched from
# Debian's ompl-demos into FOLDER) and drive.cpp are compiled with Debian's headers and linked with Debian's libraries; the binaries are
# not made again for ours. Exit 77, ctest's skip, only where the demo can not be fetched.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
debian=${PARITY_DEBIAN_DIR:-/usr/lib/x86_64-linux-gnu}

if [ ! -e /usr/include/ompl-1.5/ompl/extensions/ode/OpenDESimpleSetup.h ]; then
    echo "ompl: install Debian's package libompl-dev (scripts/test does)" >&2
    exit 1
fi
if ! package=$("$here/../fetch.sh" main/o/ompl/ompl-demos_1.5.2+ds1-1_all.deb \
    fa02f3417701fd27726c506007ab406e413237eb23fc060c3179b871b69272a1 "$2"); then
    echo "ompl: SKIPPED, NOT PASSED: OMPL's demos can not be fetched from Debian's mirror" >&2
    exit 77
fi
demo=usr/share/ompl/demos/OpenDERigidBodyPlanning.cpp
dpkg-deb --fsys-tarfile "$package" | tar -x -C "$2" "./$demo"

build() {  # PROGRAM SOURCES...
    program=$2/$1
    shift 2
    "${CXX:-c++}" -std=c++17 -O1 -isystem /usr/include/ompl-1.5 -isystem /usr/include/eigen3 -o "$program" "$@" \
        "$here/../preamble.cpp" -lompl "$debian/libode.so.8"
}
build ompl_demo "$2" "$2/$demo" "$here/seed.cpp"
build ompl_drive "$2" "$here/drive.cpp"
exec /usr/bin/python3 -B "$here/judge.py" "$2/ompl_demo" "$2/ompl_drive" "$1/libode.so.8" "$debian/libode.so.8"
