#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# kernels.sh OBJECT...
# Object files for better machines share no function with others, or the linker might keep their copy for
# everybody, and neither fuse nor approximate.
set -eu
wrong=0
for object in "$@"; do
    shared=$(nm -C "$object" | sed -n 's/.* [WVu] //p')
    if [ -n "$shared" ]; then
        echo "$object shares $shared"
        wrong=1
    fi
    inexact=$(objdump -d --no-show-raw-insn "$object" | grep -oE '\bv(fn?m(add|sub)|rcp|rsqrt)[0-9a-z]*' | sort -u || true)
    if [ -n "$inexact" ]; then
        echo "$object has" $inexact
        wrong=1
    fi
done
echo "$# object files"
[ $# -gt 0 ] || wrong=1
exit $wrong
