#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# fetch.sh FOLDER: pyode's own tests and tutorials, from Debian's source package of python3-pyode, into FOLDER; prints where they lie.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
archive=$("$here/../fetch.sh" main/p/pyode/pyode_1.2.0.dev15.orig.tar.gz \
    dffd44260bb329b102cd779e58a17ffbb1eda41f70ee17061cbe85826fae250a "$1")
folder=$1/pyode

if [ ! -e "$folder/tests/test_xode.py" ]; then
    work=$(mktemp -d "$1/unpacking.XXXXXX")
    trap 'rm -rf "$work"' EXIT
    tar -xzf "$archive" -C "$work" --strip-components=1
    # Two tests may unpack at the same time: the first to rename wins, and both have the same files.
    mv -T "$work" "$folder" 2>/dev/null || [ -e "$folder/tests/test_xode.py" ]
fi
echo "$folder"
