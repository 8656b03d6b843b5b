#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# needed.sh LIBRARY SONAME
# The library calls itself by that name and needs nothing at run time but the C and C++ run-time libraries.
set -eu
dynamic=$(LC_ALL=C readelf -d "$1")

soname=$(echo "$dynamic" | sed -n 's/.*(SONAME).*\[\(.*\)\].*/\1/p')
if [ "$soname" != "$2" ]; then
    echo "SONAME is '$soname', not $2"
    exit 1
fi

needed=$(echo "$dynamic" | sed -n 's/.*(NEEDED).*\[\(.*\)\].*/\1/p')
wrong=0
for name in $needed; do
    case $name in
        libc.so.6 | libm.so.6 | libstdc++.so.6 | libgcc_s.so.1 | ld-linux-x86-64.so.2) ;;
        *)
            echo "needs $name"
            wrong=1
            ;;
    esac
done
if [ -z "$needed" ]; then
    echo "needs nothing at all: is it a shared library?"
    wrong=1
fi
echo "SONAME $soname, needs" $needed
exit $wrong
