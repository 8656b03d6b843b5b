#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# compile.sh INCLUDE_DIR COMPILER...: the wrappers compile without a warning with every compiler that is there
# (at least one must be), in C++98 to C++20, in both precisions, over both kinds of holders; and with only some
# of the holders named they do not compile at all.
set -eu
include=$1
shift
here=$(cd "$(dirname "$0")" && pwd)
compiled=0
for compiler in "$@"; do
    command -v "$compiler" >/dev/null || continue
    for standard in 98 11 20; do
        for options in "-DdIDEDOUBLE" "-DdIDESINGLE -DTEST_SIMPLE_HOLDERS"; do
            # shellcheck disable=SC2086
            "$compiler" -std=c++$standard -Wall -Wextra -Wshadow -Wpedantic -Woverloaded-virtual -Werror \
                -fsyntax-only -I"$include" $options "$here/instantiate.cpp"
            compiled=$((compiled + 1))
        done
    done
    if echo '#include <ode/ode.h>' | "$compiler" -x c++ -fsyntax-only -I"$include" \
        -DdODECPP_WORLD_TEMPLATE_BASE=dWorldSimpleIDContainer - 2>/dev/null; then
        echo "$compiler: one holder without the others was accepted" >&2
        exit 1
    fi
done
echo "$compiled compilations of the C++ wrappers"
[ "$compiled" -gt 0 ]
