#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# fetch.sh PATH SHA256 FOLDER: one file of Debian's archive (PATH below its pool/) into FOLDER, unless it is there; prints where it lies.
# apt's helper obeys apt's proxies and checks the sum. Not `apt-get source` or `download`: they need source lists that few machines
# have, or package lists that are fresh.
set -eu
mirror=${DEBIAN_MIRROR:-http://deb.debian.org/debian}
file=$3/${1##*/}

if [ ! -e "$file" ]; then
    mkdir -p "$3"
    work=$(mktemp -d "$3/fetching.XXXXXX")
    trap 'rm -rf "$work"' EXIT
    timeout 60 /usr/lib/apt/apt-helper -o Acquire::Retries=2 -o APT::Sandbox::User=root \
        download-file "$mirror/pool/$1" "$work/file" "SHA256:$2" >&2
    mv "$work/file" "$file"
fi
echo "$file"
