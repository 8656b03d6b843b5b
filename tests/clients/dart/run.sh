#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# run.sh LIBDIR FOLDER: DART's collision detector by ODE over our library in LIBDIR and over Debian's (scripts/setup clients has
# libdart-collision-ode-dev). Half a minute, most of it to compile, once, with Debian's headers.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
debian=${PARITY_DEBIAN_DIR:-/usr/lib/x86_64-linux-gnu}
mkdir -p "$2"
folder=$(cd "$2" && pwd)
"${CXX:-c++}" -std=c++17 -O0 -isystem /usr/include/eigen3 -o "$folder/dart_contacts" "$here/contacts.cpp" "$here/../preamble.cpp" \
    -ldart-collision-ode -ldart "$debian/libode.so.8"
exec /usr/bin/python3 -B "$here/judge.py" "$folder/dart_contacts" "$(cd "$1" && pwd)/libode.so.8" "$debian/libode.so.8" "$folder"
