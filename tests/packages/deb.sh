#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# deb.sh FOLDER: a bare Debian 12 gets Debian's clients of libode8, and then the packages in FOLDER: libepode8 takes libode8's place,
# and the clients, the headers, the command and Python are used there (inside.sh). Needs root and debootstrap; the root stays in
# build/deb/root, for the next run.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
packages=$(realpath "$1")
cd "$here/../.."
root=$PWD/build/deb/root
if [ ! -x "$root/usr/bin/apt-get" ]; then
  mkdir -p "$root"
  debootstrap --variant=minbase --include=ca-certificates bookworm "$root" >build/deb/root.log 2>&1 || { tail build/deb/root.log; exit 1; }
fi
for file in /etc/resolv.conf /etc/apt/apt.conf.d/*proxy* /etc/ssl/certs/ca-certificates.crt /etc/apt/sources.list; do
  [ ! -f "$file" ] || cp "$file" "$root$file"
done
rm -rf "$root/try" && mkdir "$root/try"
cp "$packages"/*.deb "$root/try"
cp "$here/inside.sh" "$here/client.c" "$here/../clients/pyode/falling.py" "$here/../clients/dart/contacts.cpp" "$here/../clients/dart/judge.py" "$here/../../python/recipes/pendulum.py" "$here/../clients/preamble.cpp" "$root/try"
# Mounts of its own end with it.
exec unshare --mount --fork bash -euc '
  for folder in proc sys dev dev/pts dev/shm; do mount --rbind "/$folder" "$0/$folder"; done
  exec chroot "$0" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin:/usr/games HOME=/root TERM=dumb bash /try/inside.sh' "$root"
