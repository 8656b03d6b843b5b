#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# allocations.sh OBJECT...
# All memory of the library goes through the client's handlers: of its object files only that of base/memory.cpp,
# which calls them, knows malloc, realloc and free, and none knows operator new or another allocator of libc.
set -eu
wrong=0
count=0
for object in "$@"; do
    count=$((count + 1))
    used=$(nm -u "$object" | awk '{print $NF}' | sed 's/@.*//' |
        grep -E '^(malloc|calloc|realloc|reallocarray|free|memalign|posix_memalign|aligned_alloc|str(n)?dup|_Zn[aw].*|_Zd[al].*)$' || true)
    case $object in
        */base/memory.cpp.o) ;;
        *)
            if [ -n "$used" ]; then
                echo "$object uses" $used
                wrong=1
            fi
            ;;
    esac
done
echo "$count object files"
[ "$count" -gt 0 ] || wrong=1
exit $wrong
