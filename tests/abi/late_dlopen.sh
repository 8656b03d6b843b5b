#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# late_dlopen.sh HOST LIBRARY: 64 copies of the library in one process. Copies, since the loader knows a file by its inode.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for i in $(seq 64); do cp "$2" "$work/plugin$i.so"; done
"$1" "$work"/plugin*.so
