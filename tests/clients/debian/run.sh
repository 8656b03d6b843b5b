#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# run.sh LIBDIR FOLDER: the games and libraries of Debian that link with libode8 (scripts/setup clients installs them, 200 MB), on our
# library in LIBDIR and on Debian's; pictures, logs and the paths of bodies in FOLDER. For scripts/nightly: three minutes.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
debian=${PARITY_DEBIAN_DIR:-/usr/lib/x86_64-linux-gnu}
mkdir -p "$2"
"${CC:-cc}" -O1 -Wall -Wextra -shared -fPIC -DdIDEDOUBLE -I"$here/../../../include" -o "$2/observer.so" "$here/observer.c" -ldl -lm
exec /usr/bin/python3 -B "$here/judge.py" "$(cd "$1" && pwd)/libode.so.8" "$debian/libode.so.8" "$(cd "$2" && pwd)/observer.so" "$(cd "$2" && pwd)"
