#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# allocations.sh OBJECT...
# All memory of the library goes through the client's handlers: of its object files only that of base/memory.cpp,
# which calls them, knows malloc, realloc and free, and none knows operator new or another allocator of libc.
set -eu
[ $# -gt 0 ] || exit 1
wrong=0
nm -A -u "$@" | awk '
    { sub(/:$/, "", $1); sub(/@.*/, "", $NF) }
    $1 ~ /\/base\/memory\.cpp\.o$/ { next }
    $NF ~ /^(malloc|calloc|realloc|reallocarray|free|memalign|posix_memalign|aligned_alloc|str(n)?dup|_Zn[aw].*|_Zd[al].*)$/ {
        print $1 " uses " $NF
        wrong = 1
    }
    END { exit wrong || NR == 0 }' || wrong=1
echo "$# object files"
exit $wrong
